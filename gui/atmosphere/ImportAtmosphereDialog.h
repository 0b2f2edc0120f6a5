#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QDialog>

#include "gui/widgets/Dialogs.h"
#include "gui/widgets/LatestTask.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace smat::gui {

class Workbench;

/// Results of MODTRAN as one table of ours: files are read as they are added, each with what is
/// wrong with it, then the family of all of them, which is saved as `.smatatm`: what
/// `smat-batch atmosphere import` makes of the same files.
class ImportAtmosphereDialog : public QDialog {
    Q_OBJECT

  public:
    ImportAtmosphereDialog(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    void add(const std::vector<std::filesystem::path>& files);
    bool isBusy() const { return task_.isBusy(); }

  private:
    struct Reading;
    void addFile();
    void addFolder();
    void removeFile();
    void read();
    void showReading(const Reading& reading);
    void save();
    void refreshButtons();

    Workbench& workbench_;
    Dialogs dialogs_;
    std::vector<std::filesystem::path> files_;
    std::shared_ptr<const irsg::TabulatedAtmosphere> family_;
    QTreeWidget* list_ = nullptr;
    QLabel* words_ = nullptr;
    QCheckBox* use_ = nullptr;
    QPushButton *remove_ = nullptr, *save_ = nullptr;
    LatestTask task_; ///< last: nothing of it is heard once the rest goes
};

} // namespace smat::gui

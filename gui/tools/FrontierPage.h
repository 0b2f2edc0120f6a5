#pragma once

#include <QWidget>

#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"
#include "gui/widgets/LatestTask.h"
#include "smatcore/analysis/Frontier.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace smat::gui {

class FrontierPanel;
class Workbench;

/// Tools, Time against error: the view of the project in many ways to calculate it, as a job in the
/// line; a cancel keeps the ways there are. Says before how many there are and about how long that
/// takes, and shows the command that does the same. What was measured is a result like any other.
class FrontierPage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    FrontierPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    bool isRunning() const;
    FrontierPanel& panel() const { return *panel_; }
    Frontier::Options options() const;
    AnalysisData asked() const;

    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  public slots:
    void run();
    void cancel();

  signals:
    /// After every run, whatever came of it.
    void ended();

  private:
    QWidget* makeForm();
    void connectJobs();
    void refresh();
    void countWays();

    Workbench& workbench_;
    Dialogs dialogs_;
    QComboBox* which_ = nullptr;
    QSpinBox* repeats_ = nullptr;
    QLineEdit *target_ = nullptr, *command_ = nullptr;
    QLabel *count_ = nullptr, *problem_ = nullptr, *unsaved_ = nullptr;
    QPushButton *run_ = nullptr, *cancel_ = nullptr;
    QProgressBar* progress_ = nullptr;
    FrontierPanel* panel_ = nullptr;
    LatestTask counting_;
    int number_ = 0; ///< of the job that is heard of
    bool cancelled_ = false;
};

} // namespace smat::gui

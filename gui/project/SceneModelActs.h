#pragma once

#include <filesystem>

#include <QStringList>

#include "gui/widgets/LatestTask.h"
#include "gui/workbench/ModelStore.h"
#include "gui/workbench/ModelWait.h"
#include "smatcore/project/Project.h"

class QWidget;

namespace smat::gui {

class Workbench;
struct Dialogs;

/// Adds models to the project that is open and takes them out, as steps to undo. A file is read
/// beside the window before it becomes a model, since it may be damaged, and its size says where it
/// finds room.
class SceneModelActs : public ModelWait {
    Q_OBJECT

  public:
    SceneModelActs(Workbench& workbench, const Dialogs& dialogs, QWidget* window);

    /// Asks for a file, and adds it when it was read.
    void chooseAndAdd();
    void add(const std::filesystem::path& file);
    bool isBusy() const override { return task_.isBusy(); }
    void remove(std::size_t model);
    void makeTarget(std::size_t model);

  signals:
    void added(const QString& name);

  private:
    void letGo() override { task_.cancel(); }
    void attempt(const QString& title, const std::function<void()>& act);

    Workbench& workbench_;
    const Dialogs& dialogs_;
    QWidget* window_;
    LatestTask task_;
};

} // namespace smat::gui

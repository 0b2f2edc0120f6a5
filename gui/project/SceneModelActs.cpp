#include "gui/project/SceneModelActs.h"

#include <QWidget>

#include "gui/project/ProjectFiles.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/SceneModels.h"

namespace smat::gui {

SceneModelActs::SceneModelActs(Workbench& workbench, const Dialogs& dialogs, QWidget* window)
    : ModelWait(window), workbench_(workbench), dialogs_(dialogs), window_(window) {
    // What was to be added to another project is not wanted any more.
    connect(&workbench_, &Workbench::projectOpened, this, &ModelWait::cancel);
}

void SceneModelActs::chooseAndAdd() {
    if (!workbench_.hasProject())
        return;
    const QString file = dialogs_.openFile(window_, tr("Add a model to the scene"),
                                           {ProjectFiles::modelFilter(), tr("All files (*)")});
    if (!file.isEmpty())
        add(std::filesystem::absolute(file.toStdString()).lexically_normal());
}

void SceneModelActs::add(const std::filesystem::path& file) {
    beginWaiting(textOf(file.filename()));
    using Radii = std::vector<double>;
    task_.run<Radii>(
        [file, project = workbench_.project(), models = workbench_.models()] {
            Radii radii;
            for (const ProjectModel& model : project.models)
                radii.push_back(reachOf(*models->model(ModelKey::of(project, model))));
            radii.push_back(reachOf(*models->model({file, {}})));
            return radii;
        },
        [this, file](const Radii& radii) {
            endWaiting();
            // Models may have come and gone meanwhile.
            if (radii.size() != workbench_.project().models.size() + 1)
                return add(file);
            const ProjectModel model = besideOthers(workbench_.editedProject(), file, radii);
            attempt(tr("This model cannot be added"), [&] { workbench_.addModel(model); });
            emit added(textOf(model.name));
        },
        [this](const std::exception_ptr& thrown) {
            endWaiting();
            dialogs_.tell(window_, tr("This model cannot be added"), sentencesOf(thrown));
        });
}

void SceneModelActs::attempt(const QString& title, const std::function<void()>& act) {
    try {
        act();
    } catch (const irsg::InputError& error) {
        dialogs_.tell(window_, title, sentencesOf(error));
    }
}

void SceneModelActs::remove(std::size_t model) {
    if (workbench_.hasProject() && model < workbench_.project().models.size())
        attempt(tr("This model cannot be taken out"), [&] { workbench_.removeModel(model); });
}

void SceneModelActs::makeTarget(std::size_t model) {
    if (workbench_.hasProject() && model < workbench_.project().models.size())
        attempt(tr("This model cannot be the target"), [&] { workbench_.makeTarget(model); });
}

} // namespace smat::gui

#include "moc_SceneModelActs.cpp"

#include "gui/view/SceneLoader.h"

#include "gui/widgets/Sentences.h"

namespace smat::gui {

SceneLoader::SceneLoader(std::shared_ptr<ModelStore> models, QObject* parent)
    : ModelWait(parent), models_(std::move(models)) {}

void SceneLoader::load(const Project& project, const Settings& settings) {
    QStringList names;
    for (const ProjectModel& model : project.models)
        names << QString::fromStdString(model.file.filename().string());
    beginWaiting(names.join(", "));

    using Loaded = std::shared_ptr<DisplayScene>;
    task_.run<Loaded>(
        [project, settings, models = models_] {
            return std::make_shared<DisplayScene>(
                loadDisplayScene(project, settings, ModelStore::loader(models)));
        },
        [this](const Loaded& scene) {
            endWaiting();
            emit loaded(scene);
        },
        [this](const std::exception_ptr& thrown) {
            endWaiting();
            emit failed(sentencesOf(thrown));
        });
}

} // namespace smat::gui

#include "moc_SceneLoader.cpp"

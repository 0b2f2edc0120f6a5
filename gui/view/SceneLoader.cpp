#include "gui/view/SceneLoader.h"

#include "gui/Sentences.h"

namespace smat::gui {
namespace {

constexpr int tick_ms = 100, patience_ms = 250;

} // namespace

SceneLoader::SceneLoader(std::shared_ptr<ModelStore> models, QObject* parent)
    : QObject(parent), models_(std::move(models)) {
    tick_.setInterval(tick_ms);
    connect(&tick_, &QTimer::timeout, this, &SceneLoader::tell);
}

void SceneLoader::load(const Project& project, const Settings& settings) {
    QStringList names;
    for (const ProjectModel& model : project.models)
        names << QString::fromStdString(model.file.filename().string());
    names_ = names.join(", ");
    clock_.start();
    tick_.start();

    using Loaded = std::shared_ptr<DisplayScene>;
    const auto end = [this] {
        tick_.stop();
        emit waiting({});
    };
    task_.run<Loaded>(
        [project, settings, models = models_] {
            return std::make_shared<DisplayScene>(
                loadDisplayScene(project, settings, ModelStore::loader(models)));
        },
        [this, end](const Loaded& scene) {
            end();
            emit loaded(scene);
        },
        [this, end](const std::exception_ptr& thrown) {
            end();
            emit failed(sentencesOf(thrown));
        });
}

void SceneLoader::cancel() {
    if (!isBusy())
        return;
    task_.cancel();
    tick_.stop();
    emit waiting({});
    emit cancelled(names_);
}

void SceneLoader::tell() {
    if (clock_.elapsed() < patience_ms)
        return;
    emit waiting(tr("Reading %1, %2 s")
                     .arg(names_)
                     .arg(static_cast<double>(clock_.elapsed()) / 1000.0, 0, 'f', 1));
}

} // namespace smat::gui

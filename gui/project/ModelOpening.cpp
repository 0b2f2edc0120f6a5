#include "gui/project/ModelOpening.h"

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "smatcore/project/ProjectFile.h"

namespace smat::gui {

ModelOpening::ModelOpening(std::shared_ptr<ModelStore> models, QObject* parent)
    : ModelWait(parent), models_(std::move(models)) {}

void ModelOpening::read(const std::filesystem::path& file) {
    beginWaiting(textOf(file.filename()));
    using Read = std::shared_ptr<const irsg::Model>;
    task_.run<Read>(
        [file, models = models_] {
            const Project opened = projectOfModel(file);
            return models->model(ModelKey::of(opened, opened.models.front()));
        },
        [this, file](const Read&) {
            endWaiting();
            emit wasRead(file);
        },
        [this](const std::exception_ptr& thrown) {
            endWaiting();
            emit failed(sentencesOf(thrown));
        });
}

} // namespace smat::gui

#include "moc_ModelOpening.cpp"

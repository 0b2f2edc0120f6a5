#include "gui/project/SceneIndex.h"

#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/SignatureFile.h"

namespace smat::gui {
namespace {

template <typename Entries>
void addEntries(std::map<int, IndexUse>& uses, const Entries& entries,
                const std::optional<int>& fallback) {
    for (const auto& [index, entry] : entries) {
        uses[index].name = QString::fromStdString(entry.name);
        uses[index].hasEntry = true;
    }
    const bool standsIn = fallback && entries.contains(*fallback);
    for (auto& [index, use] : uses)
        use.isReplaced = !use.hasEntry && standsIn;
}

QString problemOf(const irsg::InputError& error) {
    return sentenceOf(error.diagnostics().front());
}

} // namespace

ModelIndex makeModelIndex(const ProjectModel& model, const ModelCodes& codes,
                          const irsg::SignatureDatabase& database) {
    ModelIndex index;
    for (const auto& [pair, use] : codes) {
        for (auto* one : {&index.temperatures[pair.temperature], &index.materials[pair.material]}) {
            one->faces += use.faces;
            one->area_m2 += use.area_m2;
        }
    }
    addEntries(index.temperatures, database.temperatures, model.fallbackTemperature);
    addEntries(index.materials, database.materials, model.fallbackMaterial);
    return index;
}

std::vector<ModelIndex> loadSceneIndex(const Project& project, ModelStore& models) {
    std::vector<ModelIndex> indices;
    for (const auto& model : project.models) {
        ModelCodes codes;
        irsg::SignatureDatabase database;
        QString modelProblem, databaseProblem;
        try {
            codes = models.model(ModelKey::of(project, model))->codes();
        } catch (const irsg::InputError& error) {
            modelProblem = problemOf(error);
        }
        try {
            if (!model.database.empty())
                database = irsg::loadSignatureFile(project.resolve(model.database),
                                                   irsg::OutsideChanges::accept)
                               .database;
        } catch (const irsg::InputError& error) {
            databaseProblem = problemOf(error);
        }
        ModelIndex index = makeModelIndex(model, codes, database);
        index.modelProblem = modelProblem;
        index.databaseProblem = databaseProblem;
        indices.push_back(std::move(index));
    }
    return indices;
}

} // namespace smat::gui

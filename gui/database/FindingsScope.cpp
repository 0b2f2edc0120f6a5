#include "gui/database/FindingsScope.h"

#include <algorithm>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/signature/LintScalings.h"
#include "smatcore/analysis/ProjectLint.h"

namespace smat::gui {
namespace {

constexpr int gatherDelay_ms = 300;

bool isSame(const irsg::LintScope& a, const irsg::LintScope& b) {
    return a.bands == b.bands &&
           std::ranges::equal(a.states, b.states,
                              [](const irsg::SweptState& x, const irsg::SweptState& y) {
                                  return x.analysis == y.analysis && x.state == y.state;
                              }) &&
           std::ranges::equal(
               a.models, b.models, [](const irsg::ModelUse& x, const irsg::ModelUse& y) {
                   return x.name == y.name && x.temperatureFaces == y.temperatureFaces &&
                          x.materialFaces == y.materialFaces &&
                          x.temperaturesOfMaterial == y.temperaturesOfMaterial &&
                          x.levelsOfDetail == y.levelsOfDetail &&
                          x.sharedPlanes == y.sharedPlanes &&
                          x.fallbackTemperature == y.fallbackTemperature &&
                          x.fallbackMaterial == y.fallbackMaterial;
               });
}

} // namespace

FindingsScope::FindingsScope(EditorContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    delay_.setSingleShot(true);
    delay_.setInterval(gatherDelay_ms);
    connect(&delay_, &QTimer::timeout, this, &FindingsScope::ask);
    const auto soon = [this] { delay_.start(); };
    Workbench& workbench = context_.workbench();
    connect(&workbench, &Workbench::projectOpened, this, &FindingsScope::forget);
    connect(&context_.session(), &DatabaseSession::opened, this, &FindingsScope::forget);
    // What was gathered stays until there is better: findings that come back would only flicker.
    connect(&context_, &EditorContext::surroundingsChanged, this, soon);
    connect(&workbench, &Workbench::projectChanged, this, soon);
    connect(&workbench, &Workbench::settingsChanged, this, soon);
    delay_.start();
}

void FindingsScope::forget() {
    gathered_.reset();
    gathering_.cancel();
    delay_.start();
}

void FindingsScope::ask() {
    const Workbench& workbench = context_.workbench();
    if (!workbench.hasProject() || !context_.session().isOpen())
        return;
    gathering_.run<Surroundings>(
        [project = workbench.editedProject(), file = context_.session().file(),
         models = workbench.models()] { return gather(project, file, models); },
        [this](Surroundings found) {
            if (gathered_ && isSame(gathered_->scope, found.scope))
                return;
            gathered_ = std::move(found);
            emit changed();
        },
        [this](const std::exception_ptr& thrown) {
            try {
                std::rethrow_exception(thrown);
            } catch (const irsg::InputError&) {
                // Told where it is used: by the view, or by the analysis that cannot run.
                if (std::exchange(gathered_, std::nullopt))
                    emit changed();
            }
        });
}

FindingsScope::Surroundings FindingsScope::gather(const Project& project,
                                                  const std::filesystem::path& database,
                                                  const std::shared_ptr<ModelStore>& models) {
    SceneBuilder builder(ModelStore::loader(models));
    Surroundings around{lintScopeOf(project, database, builder), {}};
    for (const std::size_t model : modelsWith(project, database))
        around.modelFiles.push_back(project.resolve(project.models[model].file));
    return around;
}

FindingsScope::Surroundings FindingsScope::ofTargetAlone() const {
    Surroundings around;
    if (context_.knowsModel()) {
        const Project& project = context_.workbench().project();
        around.scope.models.push_back(context_.modelUse());
        around.modelFiles.push_back(
            project.resolve(project.models.at(context_.workbench().chosenModel()).file));
    }
    return around;
}

std::vector<irsg::Finding> FindingsScope::findings() const {
    const auto& database = context_.session().value();
    Surroundings around = gathered_ ? *gathered_ : ofTargetAlone();
    // The view shows the project's own band, whatever the analyses look at.
    auto& bands = around.scope.bands;
    if (std::ranges::find(bands, context_.band()) == bands.end())
        bands.push_back(context_.band());
    auto all = irsg::lint(database, around.scope);
    for (std::size_t i = 0; i < around.modelFiles.size(); ++i) {
        const auto scalings = irsg::scalingUseOf(around.modelFiles[i]);
        const auto more = irsg::lintScalings(database, around.scope.models[i], scalings);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

} // namespace smat::gui

#include "moc_FindingsScope.cpp"

#include "smatcore/analysis/ProjectLint.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "irsg/core/Errors.h"
#include "irsg/geometry/model/ModelUse.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code failure;
    const bool same = std::filesystem::equivalent(a, b, failure);
    return failure ? std::filesystem::weakly_canonical(a) == std::filesystem::weakly_canonical(b)
                   : same;
}

/// Nose axis to the direction reference point -> camera, for a target whose reference point is
/// anywhere.
double aspectAngle_rad(const AnalysisCase& one) {
    const irsg::Vec3 toCamera = one.viewpoint({}).position_m;
    const double range_m = irsg::length(toCamera);
    if (!(range_m > 0.0))
        return 0.0;
    const irsg::Vec3 nose = one.attitude.rotation() * irsg::Vec3{0, 1, 0};
    return std::acos(std::clamp(irsg::dot(nose, toCamera) / range_m, -1.0, 1.0));
}

std::vector<AnalysisData> analysesOf(const Project& project) {
    std::vector<AnalysisData> analyses;
    for (const NamedAnalysis& named : project.analyses)
        analyses.push_back(AnalysisData::of(project, named.name));
    if (analyses.empty())
        analyses.push_back(AnalysisData::of(project, AnalysisKind::image));
    return analyses;
}

/// The states of one model in one analysis, each once.
void addStates(const AnalysisData& analysis, std::size_t model, irsg::LintScope& scope) {
    const irsg::Environment environment = environmentOf(analysis.project, analysis.settings);
    const irsg::EntityState standing = targetStateOf(analysis.settings);
    const irsg::Pose pose = poseOf(analysis.project, analysis.settings, model);

    const StateOverride own = model == 0 ? StateOverride() : analysis.project.models[model].own;
    const std::string name = analysis.name.empty() ? smat::name(analysis.kind) : analysis.name;
    const std::size_t first = scope.states.size();
    // The states do not depend on the band, and an image has one at a time.
    for (const AnalysisCase& one :
         planAnalysis(analysis.kind, analysis.project, eachBand(analysis.settings).front()).cases) {
        irsg::EntityState state = one.state(standing, own);
        state.altitude_m = (model == 0 ? one.standing(pose) : pose).position_m.z;
        state.ambient_K = environment.ambientTemperature_K(state.altitude_m).value;
        state.aspectAngle_rad = model == 0 ? aspectAngle_rad(one) : 0.0;
        // Neighbours alone are compared: a range analysis has one state, a polar one many.
        if (scope.states.size() == first || scope.states.back().state != state)
            scope.states.push_back({name, state});
    }
}

} // namespace

std::vector<std::size_t> modelsWith(const Project& project, const std::filesystem::path& database) {
    std::vector<std::size_t> models;
    for (std::size_t i = 0; i < project.models.size(); ++i) {
        const std::filesystem::path& named = project.models[i].database;
        if (!named.empty() && isSameFile(project.resolve(named), database))
            models.push_back(i);
    }
    return models;
}

irsg::LintScope lintScopeOf(const Project& project, const std::filesystem::path& database,
                            SceneBuilder& builder) {
    irsg::LintScope scope;
    const std::vector<std::size_t> models = modelsWith(project, database);
    for (const std::size_t i : models) {
        const ProjectModel& model = project.models[i];
        irsg::ModelUse use =
            irsg::useOf(*builder.model(project.resolve(model.file), model.options));
        use.fallbackTemperature = model.fallbackTemperature;
        use.fallbackMaterial = model.fallbackMaterial;
        scope.models.push_back(std::move(use));
    }
    if (models.empty()) {
        throw irsg::InputError({.file = project.displayName(),
                                .position = "models",
                                .value = "no model with the database " + database.string(),
                                .expected = "the project of a model with this database"});
    }
    for (const AnalysisData& analysis : analysesOf(project)) {
        for (const irsg::Band& one : bandsOf(project, analysis.settings))
            if (std::ranges::find(scope.bands, one.range()) == scope.bands.end())
                scope.bands.push_back(one.range());
        for (const std::size_t model : models)
            addStates(analysis, model, scope);
    }
    return scope;
}

} // namespace smat

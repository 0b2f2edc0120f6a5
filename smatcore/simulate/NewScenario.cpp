#include "smatcore/simulate/NewScenario.h"

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat {

namespace {

constexpr double firstDuration_s = 10.0;

/// In digits that a person would write.
double toMillimetres(double length_m) {
    return std::round(length_m * 1e3) / 1e3;
}

ScenarioEntity entityOf(const Project& project, std::size_t model) {
    const ProjectModel& from = project.models[model];
    const irsg::EntityState state = stateOf(project, project.settings, model);
    ScenarioEntity entity;
    entity.model = from.file;
    entity.database = from.database;
    entity.options = from.options;
    entity.referencePoint_m = from.referencePoint_m;
    entity.fallbackTemperature = from.fallbackTemperature;
    entity.fallbackMaterial = from.fallbackMaterial;
    entity.pose = poseOf(project, project.settings, model);
    entity.timeOffset_s = state.time_s;
    if (state.power != 0.0)
        entity.power = state.power;
    if (state.mach != 0.0)
        entity.mach = state.mach;
    return entity;
}

/// Where the camera of the project is, which looks at the target.
ScenarioSensor sensorOf(const Project& project, const irsg::Vec3& targetReference_m) {
    const AnalysisPlan plan = planAnalysis(AnalysisKind::image, project, project.settings);
    const AnalysisCase& view = plan.cases.front();
    const irsg::Pose standing = view.standing(targetPoseOf(project.settings));
    ScenarioSensor sensor;
    sensor.name = "sensor";
    const irsg::Vec3 at_m = view.viewpoint(standing.toWorld(targetReference_m)).position_m;
    sensor.offset.position_m = {toMillimetres(at_m.x), toMillimetres(at_m.y),
                                toMillimetres(at_m.z)};
    return sensor;
}

} // namespace

std::string scenarioName(std::string wanted,
                         const std::function<bool(const std::string&)>& isTaken) {
    for (char& letter : wanted)
        if (std::string_view(",\"[]#/\\").find(letter) != std::string_view::npos)
            letter = '-';
    if (wanted.empty() || wanted == "." || wanted == "..")
        wanted = "model";
    std::string name = wanted;
    for (int number = 2; isTaken(name); ++number)
        name = wanted + "-" + std::to_string(number);
    return name;
}

Scenario scenarioOf(const Project& project, const irsg::Vec3& targetReference_m) {
    std::vector<irsg::Diagnostic> missing;
    for (const ProjectModel& model : project.models)
        if (model.database.empty())
            missing.push_back({project.displayName(), model.shownName(), "no signature database",
                               "one that is saved, for every model of a scenario"});
    if (project.models.empty())
        missing.push_back({project.displayName(), "", "no model", "at least one"});
    if (!missing.empty())
        throw irsg::InputError(missing);

    Scenario scenario;
    scenario.file = project.file;
    scenario.title = project.title;
    scenario.end_s = firstDuration_s;
    for (const auto& [key, text] : project.settings.values())
        if (const SettingInfo* setting = findSetting(key);
            setting != nullptr && isScenarioSetting(*setting) && !project.settings.isDefault(key))
            scenario.settings.set(key, text);
    for (std::size_t model = 0; model < project.models.size(); ++model) {
        ScenarioEntity entity = entityOf(project, model);
        entity.name = scenarioName(project.models[model].shownName(), [&](const std::string& name) {
            return scenario.findEntity(name).has_value();
        });
        scenario.entities.push_back(std::move(entity));
    }
    scenario.sensors.push_back(sensorOf(project, targetReference_m));
    scenario.sensors.front().track = scenario.entities.front().name;
    return scenario;
}

} // namespace smat

#include "smatcore/project/SceneModels.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

std::string allNames(const Project& project) {
    std::string names;
    for (std::size_t i = 0; i < project.models.size(); ++i)
        names += fmt::format("{}{} ({})", i == 0 ? "" : ", ", project.models[i].shownName(), i);
    return names.empty() ? "none" : names;
}

/// Degrees as somebody wrote them, of radians.
double written_deg(double angle_rad) {
    return std::round(irsg::degrees(angle_rad) * 1e10) / 1e10;
}

} // namespace

std::size_t findModel(const Project& project, std::string_view nameOrNumber,
                      const std::string& where) {
    const std::string wanted(irsg::trimmed(nameOrNumber));
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < project.models.size(); ++i)
        if (project.models[i].shownName() == wanted)
            found.push_back(i);
    if (found.size() == 1)
        return found.front();
    const auto number = irsg::parseNumber(wanted);
    if (found.empty() && number && *number >= 0.0 && *number == std::floor(*number) &&
        *number < static_cast<double>(project.models.size()))
        return static_cast<std::size_t>(*number);
    throw irsg::InputError({.file = where,
                            .position = "",
                            .value = wanted.empty() ? "nothing" : wanted,
                            .expected = (found.size() > 1 ? "the number of one of several models "
                                                            "of this name: "
                                                          : "the name or number of a model: ") +
                                        allNames(project)});
}

std::string freeModelName(const Project& project, const std::string& wanted) {
    const auto isTaken = [&](const std::string& name) {
        return std::ranges::any_of(
            project.models, [&](const ProjectModel& model) { return model.shownName() == name; });
    };
    std::string name = wanted;
    for (int number = 2; isTaken(name); ++number)
        name = fmt::format("{}-{}", wanted, number);
    return name;
}

double reachOf(const irsg::Model& model) {
    const irsg::BoundingBox& box = model.bounds();
    double reach_m = 0.0;
    for (const double x : {box.min.x, box.max.x})
        for (const double y : {box.min.y, box.max.y})
            for (const double z : {box.min.z, box.max.z})
                reach_m = std::max(reach_m, irsg::length({x, y, z}));
    return reach_m;
}

ProjectModel besideOthers(const Project& project, const std::filesystem::path& file,
                          const std::vector<double>& radii_m) {
    ProjectModel model = projectOfModel(file).models.front();
    model.name = freeModelName(project, model.name);
    const irsg::Pose target = targetPoseOf(project.settings);
    double end_m = 0.0;
    for (std::size_t i = 0; i < project.models.size(); ++i)
        end_m = std::max(end_m, poseOf(project, project.settings, i).position_m.x + radii_m.at(i));
    // A quarter of its own size is left between them.
    const double east_m = end_m + 1.5 * radii_m.at(project.models.size());
    const double step_m = std::pow(10.0, std::floor(std::log10(std::max(east_m, 1e-3))) - 1.0);
    model.pose.position_m = {std::ceil(east_m / step_m) * step_m, 0.0, target.position_m.z};
    model.pose.attitude.yaw_rad = target.attitude.yaw_rad;
    return model;
}

void makeTarget(Project& project, std::size_t model) {
    if (model == 0)
        return;
    Project after = project;
    const ProjectModel chosen = after.models.at(model);
    const irsg::Pose before = targetPoseOf(project.settings);
    const irsg::EntityState didBefore = targetStateOf(project.settings);
    const irsg::EntityState does = stateOf(project, project.settings, model);
    const irsg::Vec3 origin_m{chosen.pose.position_m.x, chosen.pose.position_m.y, 0.0};

    // Only what changes is set: what was left to its default stays so.
    const auto set = [&](RealKey key, double value) {
        if (after.settings[key] != value)
            after.settings.set(key, value);
    };
    set(key::targetAltitude, chosen.pose.position_m.z);
    set(key::targetYaw, written_deg(chosen.pose.attitude.yaw_rad));
    set(key::targetPitch, written_deg(chosen.pose.attitude.pitch_rad));
    set(key::targetRoll, written_deg(chosen.pose.attitude.roll_rad));
    set(key::statePower, does.power);
    set(key::stateMach, does.mach);
    set(key::stateTime, does.time_s);
    if (!after.settings[key::environmentTerrain].empty()) {
        set(key::environmentTerrainEast, after.settings[key::environmentTerrainEast] - origin_m.x);
        set(key::environmentTerrainNorth,
            after.settings[key::environmentTerrainNorth] - origin_m.y);
    }

    after.models.front().pose = before;
    for (ProjectModel& one : after.models) {
        one.pose.position_m = one.pose.position_m - origin_m;
        if (does.power != didBefore.power && !one.own.power)
            one.own.power = didBefore.power;
        if (does.mach != didBefore.mach && !one.own.mach)
            one.own.mach = didBefore.mach;
        one.own.timeOffset_s -= chosen.own.timeOffset_s;
    }
    const auto place = after.models.begin() + static_cast<std::ptrdiff_t>(model);
    std::rotate(after.models.begin(), place, place + 1);
    after.models.front().pose = {};
    after.models.front().own = {};
    project = std::move(after);
}

void removeModel(Project& project, std::size_t model) {
    if (project.models.size() < 2) {
        throw irsg::InputError({.file = project.displayName(),
                                .position = "models",
                                .value = "one model",
                                .expected = "a project that keeps at least one model"});
    }
    Project after = project;
    if (model == 0)
        makeTarget(after, 1); // it is the second then
    after.models.erase(after.models.begin() + static_cast<std::ptrdiff_t>(model == 0 ? 1 : model));
    project = std::move(after);
}

} // namespace smat

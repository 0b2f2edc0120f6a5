#include "gui/scenario/ScenarioParts.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "gui/widgets/NumberFormat.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/simulate/NewScenario.h"

namespace smat::gui {
namespace {

constexpr double newEntityBeside_m = 50.0;

QString trPart(const char* text) {
    return QCoreApplication::translate("smat::gui::ScenarioParts", text);
}

irsg::Pose poseAtStart(const EditedScenario& state, const std::filesystem::path& path,
                       const irsg::Pose& otherwise) {
    const TrajectoryTable* table = path.empty() ? nullptr : state.table(path);
    if (table == nullptr)
        return otherwise;
    return Trajectory(*table).at(state.scenario.start_s, true)->pose;
}

/// Where an entity or a sensor is in the world at the start. A sensor that looks at an entity has
/// no attitude of its own.
irsg::Pose poseAtStart(const EditedScenario& state, const ScenarioPart& part) {
    if (part.entity) {
        const ScenarioEntity& entity = state.scenario.entities.at(*part.entity);
        return poseAtStart(state, entity.trajectory, entity.pose);
    }
    const ScenarioSensor& sensor = state.scenario.sensors.at(part.sensor.value());
    const irsg::Pose mount = mountOf(state, sensor);
    irsg::Pose pose{mount.toWorld(sensor.offset.position_m), {}};
    if (!sensor.track.empty())
        return pose;
    if (sensor.mount == MountKind::world)
        pose.attitude = sensor.offset.attitude;
    else
        pose.attitude = attitudeTowards(mount.attitude.rotation() *
                                        (sensor.offset.attitude.rotation() * irsg::Vec3{0, 1, 0}));
    return pose;
}

TrajectoryTable::Row rowAt(double time_s, const irsg::Pose& pose) {
    // To a nanometre and a billionth of a degree: what turning there and back leaves is no number
    // to read.
    const auto rounded = [](double value) { return std::round(value * 1e9) / 1e9 + 0.0; };
    TrajectoryTable::Row row{};
    row[TrajectoryTable::time] = time_s;
    row[TrajectoryTable::x] = rounded(pose.position_m.x);
    row[TrajectoryTable::y] = rounded(pose.position_m.y);
    row[TrajectoryTable::z] = rounded(pose.position_m.z);
    row[TrajectoryTable::yaw] = rounded(irsg::degrees(pose.attitude.yaw_rad));
    row[TrajectoryTable::pitch] = rounded(irsg::degrees(pose.attitude.pitch_rad));
    row[TrajectoryTable::roll] = rounded(irsg::degrees(pose.attitude.roll_rad));
    return row;
}

/// "mover.csv", or "mover-2.csv" where there is such a file or trajectory.
std::filesystem::path freeTrajectory(const EditedScenario& state, const std::string& name) {
    for (int number = 1;; ++number) {
        const std::filesystem::path path =
            name + (number == 1 ? "" : "-" + std::to_string(number)) + ".csv";
        const std::filesystem::path at = state.scenario.resolve(path);
        std::error_code failure;
        if (!state.trajectories.contains(at) && !std::filesystem::exists(at, failure))
            return path;
    }
}

void forgetUnfollowed(EditedScenario& state, const std::filesystem::path& path) {
    if (!path.empty() && followersOf(state.scenario, path, {}).isEmpty())
        state.trajectories.erase(state.scenario.resolve(path));
}

void follow(EditedScenario& state, const ScenarioPart& part, const std::filesystem::path& path,
            TrajectoryTable table) {
    const std::filesystem::path before = trajectoryOf(state.scenario, part);
    state.trajectories[state.scenario.resolve(path)] = std::move(table);
    if (part.entity) {
        state.scenario.entities.at(*part.entity).trajectory = path;
    } else {
        ScenarioSensor& sensor = state.scenario.sensors.at(part.sensor.value());
        sensor.mount = MountKind::trajectory;
        sensor.carrier.clear();
        sensor.trajectory = path;
        sensor.offset = {};
    }
    if (before != path)
        forgetUnfollowed(state, before);
}

} // namespace

QString nameOf(const Scenario& scenario, const ScenarioPart& part) {
    if (part.entity)
        return textOf(scenario.entities.at(*part.entity).name);
    return part.sensor ? textOf(scenario.sensors.at(*part.sensor).name) : QString();
}

std::filesystem::path trajectoryOf(const Scenario& scenario, const ScenarioPart& part) {
    if (part.entity)
        return scenario.entities.at(*part.entity).trajectory;
    return part.sensor ? scenario.sensors.at(*part.sensor).trajectory : std::filesystem::path();
}

QStringList followersOf(const Scenario& scenario, const std::filesystem::path& trajectory,
                        const QString& but) {
    QStringList names;
    const auto take = [&](const auto& parts) {
        for (const auto& part : parts)
            if (part.trajectory == trajectory && textOf(part.name) != but)
                names << textOf(part.name);
    };
    take(scenario.entities);
    take(scenario.sensors);
    return names;
}

irsg::Pose poseAtStart(const EditedScenario& state, const std::string& entity) {
    return poseAtStart(
        state, ScenarioPart{.entity = state.scenario.findEntity(entity).value(), .sensor = {}});
}

irsg::Pose mountOf(const EditedScenario& state, const ScenarioSensor& sensor) {
    if (sensor.mount == MountKind::entity)
        return poseAtStart(state, sensor.carrier);
    return sensor.mount == MountKind::trajectory
               ? poseAtStart(state, sensor.trajectory, irsg::Pose())
               : irsg::Pose();
}

irsg::Attitude attitudeTowards(const irsg::Vec3& direction) {
    const irsg::Vec3 ahead = irsg::normalized(direction);
    return {std::atan2(-ahead.x, ahead.y), std::asin(std::clamp(ahead.z, -1.0, 1.0)), 0.0};
}

std::size_t addEntity(EditedScenario& state, const std::filesystem::path& model,
                      const std::filesystem::path& database) {
    ScenarioEntity entity;
    entity.name = scenarioName(model.stem().string(), [&](const std::string& name) {
        return state.scenario.findEntity(name).has_value();
    });
    entity.model = model;
    entity.database = database;
    entity.pose = poseAtStart(state, state.scenario.entities.front().name);
    entity.pose.position_m.x += newEntityBeside_m;
    state.scenario.entities.push_back(entity);
    return state.scenario.entities.size() - 1;
}

std::size_t addSensor(EditedScenario& state, std::size_t like) {
    ScenarioSensor sensor = state.scenario.sensors.at(like);
    sensor.name = scenarioName(sensor.name, [&](const std::string& name) {
        return state.scenario.findSensor(name).has_value();
    });
    state.scenario.sensors.push_back(sensor);
    return state.scenario.sensors.size() - 1;
}

QString whyNotRemoved(const Scenario& scenario, const ScenarioPart& part) {
    if (part.sensor)
        return scenario.sensors.size() == 1 ? trPart("A scenario needs at least one sensor")
                                            : QString();
    if (scenario.entities.size() == 1)
        return trPart("A scenario needs at least one entity");
    const std::string& name = scenario.entities.at(part.entity.value()).name;
    for (const ScenarioSensor& sensor : scenario.sensors) {
        if (sensor.carrier == name)
            return trPart("%1 rides on it").arg(textOf(sensor.name));
        if (sensor.track == name)
            return trPart("%1 looks at it").arg(textOf(sensor.name));
    }
    return {};
}

void removePart(EditedScenario& state, const ScenarioPart& part) {
    const std::filesystem::path path = trajectoryOf(state.scenario, part);
    const auto erase = [](auto& list, std::size_t at) {
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
    };
    if (part.entity)
        erase(state.scenario.entities, *part.entity);
    else
        erase(state.scenario.sensors, part.sensor.value());
    forgetUnfollowed(state, path);
}

void giveTrajectory(EditedScenario& state, const ScenarioPart& part) {
    const irsg::Pose pose = poseAtStart(state, part);
    const Scenario& scenario = state.scenario;
    TrajectoryTable table;
    table.rows.push_back(rowAt(scenario.start_s, pose));
    if (scenario.end_s > scenario.start_s)
        table.rows.push_back(rowAt(scenario.end_s, pose));
    if (part.entity) {
        // Rows have them from now on, and may change them.
        ScenarioEntity& entity = state.scenario.entities.at(*part.entity);
        table.hasPower = entity.power.has_value();
        table.hasMach = entity.mach.has_value();
        for (TrajectoryTable::Row& row : table.rows) {
            row[TrajectoryTable::power] = entity.power.value_or(0.0);
            row[TrajectoryTable::mach] = entity.mach.value_or(0.0);
        }
        entity.power.reset();
        entity.mach.reset();
    }
    follow(state, part, freeTrajectory(state, nameOf(scenario, part).toStdString()), table);
}

void followFile(EditedScenario& state, const ScenarioPart& part,
                const std::filesystem::path& file) {
    const std::filesystem::path absolute = std::filesystem::absolute(file).lexically_normal();
    // One that others follow is as it is edited.
    const TrajectoryTable* known = state.table(absolute);
    TrajectoryTable table = known != nullptr ? *known : TrajectoryTable::read(absolute);
    const std::filesystem::path folder = state.scenario.file.parent_path();
    const std::filesystem::path path =
        absolute.parent_path() == folder ? absolute.filename() : absolute;
    follow(state, part, path, std::move(table));
}

void letStand(EditedScenario& state, std::size_t entity) {
    const ScenarioPart part{.entity = entity, .sensor = {}};
    const irsg::Pose pose = poseAtStart(state, part);
    ScenarioEntity& standing = state.scenario.entities.at(entity);
    const std::filesystem::path before = standing.trajectory;
    if (const TrajectoryTable* table = before.empty() ? nullptr : state.table(before)) {
        const TrajectoryPoint start = Trajectory(*table).at(state.scenario.start_s, true).value();
        if (table->hasPower)
            standing.power = start.power;
        if (table->hasMach)
            standing.mach = start.mach;
    }
    standing.trajectory.clear();
    standing.hold = false;
    standing.pose = pose;
    forgetUnfollowed(state, before);
}

} // namespace smat::gui

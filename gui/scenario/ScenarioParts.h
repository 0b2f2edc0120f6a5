#pragma once

#include <filesystem>
#include <optional>

#include <QStringList>

#include "gui/scenario/ScenarioDocument.h"

namespace smat::gui {

/// What fields of a scenario are about: an entity, a sensor or, with neither, the scenario.
struct ScenarioPart {
    std::optional<std::size_t> entity, sensor;
};

/// Its name; empty for the scenario.
QString nameOf(const Scenario& scenario, const ScenarioPart& part);
/// The trajectory that it follows; empty where it has none.
std::filesystem::path trajectoryOf(const Scenario& scenario, const ScenarioPart& part);
/// Who else follows a trajectory.
QStringList followersOf(const Scenario& scenario, const std::filesystem::path& trajectory,
                        const QString& but);

/// Where an entity is at the start of the scenario, or where it begins to be.
irsg::Pose poseAtStart(const EditedScenario& state, const std::string& entity);
/// What the place of a sensor is in the axes of, at the same time.
irsg::Pose mountOf(const EditedScenario& state, const ScenarioSensor& sensor);
/// Nose towards a direction, wings level.
irsg::Attitude attitudeTowards(const irsg::Vec3& direction);

/// Adds an entity beside the first one, where the scenario begins. Returns its number.
std::size_t addEntity(EditedScenario& state, const std::filesystem::path& model,
                      const std::filesystem::path& database);
/// Adds a copy of a sensor under another name. Returns its number.
std::size_t addSensor(EditedScenario& state, std::size_t like);
/// Why a part cannot be removed; empty where it can.
QString whyNotRemoved(const Scenario& scenario, const ScenarioPart& part);
/// Removes an entity or a sensor with the trajectory that nobody else follows.
void removePart(EditedScenario& state, const ScenarioPart& part);

/// Lets an entity or a sensor follow a new trajectory of two rows, at the start and at the end,
/// both where it is at the start: a file beside the scenario, written when that is saved.
void giveTrajectory(EditedScenario& state, const ScenarioPart& part);
/// Lets it follow the rows of a file. Throws irsg::InputError where that is no trajectory.
void followFile(EditedScenario& state, const ScenarioPart& part, const std::filesystem::path& file);
/// Lets an entity stand where it is at the start.
void letStand(EditedScenario& state, std::size_t entity);

} // namespace smat::gui

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/sensor/SensorChain.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/simulate/Scenario.h"
#include "smatcore/simulate/Trajectory.h"

namespace smat {

/// Where a sensor is, with its axes in the world.
struct SensorPlace {
    irsg::Vec3 position_m;
    irsg::Rotation axes; ///< takes starboard, nose and up into the world
};

/// A sensor with everything its frames are made of.
struct LoadedSensor {
    Settings settings;      ///< all in effect, scenarioDefaults() among them
    SceneDescription scene; ///< all entities, wherever they are; sensor, environment, rendering
    Trajectory path;        ///< of its own mount; of one in the world or on an entity at rest
    std::vector<std::string> warnings; ///< what its ImagingSensor file asks in vain
    /// Reads its frames, where `image.sensor` names one; size, field and band of settings and scene
    /// are this sensor's then. All frames share its kernels.
    std::shared_ptr<const irsg::SensorChain> chain = {};
};

/// A scenario with all its files read: models and databases once each, atmospheres once for all
/// sensors that have the same environment.
struct LoadedScenario {
    Scenario scenario;
    std::vector<Trajectory> paths; ///< by entity
    std::vector<LoadedSensor> sensors;

    /// Where an entity is and what it does; no value where it is not there.
    std::optional<TrajectoryPoint> entityAt(std::size_t entity, double time_s) const;
    /// No value where its mount is not there.
    std::optional<SensorPlace> sensorAt(std::size_t sensor, double time_s) const;
};

/// Trajectories as they are edited, by their resolved file: they stand in for what the file holds.
using EditedTrajectories = std::map<std::filesystem::path, TrajectoryTable>;

/// The entities of a scenario as the models of a project.
Project projectOf(const Scenario& scenario);

/// Reads what a scenario names. `overrides` go before the settings of every sensor. Throws
/// InputError with the diagnostics of all files and settings together: those of the parts, an
/// engine setting beside a trajectory that has the column, an ImagingSensor file that turns
/// something on that no setting describes.
LoadedScenario loadScenarioFiles(const Scenario& scenario, SceneBuilder& builder,
                                 const Settings& overrides = {},
                                 const EditedTrajectories& edited = {});

} // namespace smat

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/view/Pose.h"
#include "smatcore/settings/Settings.h"

namespace smat {

/// One thing of a scenario: a model with its signature that follows a trajectory or stands still.
struct ScenarioEntity {
    std::string name; ///< the model file's stem where the file gives none; unique
    std::filesystem::path model;
    std::filesystem::path database;
    irsg::ModelOptions options = {};
    std::optional<irsg::Vec3> referencePoint_m = {}; ///< model axes; box centre where it is not set
    std::optional<int> fallbackTemperature = {};
    std::optional<int> fallbackMaterial = {};

    std::filesystem::path trajectory; ///< empty where it stands still at `pose`
    bool hold = false;                ///< stays at the ends of its trajectory
    irsg::Pose pose = {};
    double timeOffset_s = 0.0; ///< added to the scenario's time for its lookup tables
    /// For all times, where the trajectory has no such column.
    std::optional<double> power = {}, mach = {};

    bool operator==(const ScenarioEntity&) const = default;
};

/// What a sensor's mount is fixed to.
enum class MountKind { world, entity, trajectory };

/// One sensor of a scenario. Its mount stands in the world, rides on an entity or follows a
/// trajectory of its own; the sensor sits at `offset` in the mount's axes and looks along its own
/// nose, or at the reference point of an entity.
struct ScenarioSensor {
    std::string name; ///< unique; the name of its folder
    MountKind mount = MountKind::world;
    std::string carrier = {};              ///< name of an entity
    std::filesystem::path trajectory = {}; ///< CSV
    bool hold = false;                     ///< stays at the ends of its trajectory
    irsg::Pose offset = {}; ///< in the mount's axes; of a mount in the world, in the world
    std::string track = {}; ///< name of an entity; empty: looks along its own nose
    std::filesystem::path imagingSensor = {}; ///< ImagingSensor XML; `settings` go before it
    Settings settings = {};                   ///< on top of those of the scenario

    bool operator==(const ScenarioSensor&) const = default;
};

/// An engagement: several entities seen by several sensors over time, every `dt_s` from `start_s`
/// to `end_s`, both ends included. A value, copied and compared like one.
struct Scenario {
    std::filesystem::path file; ///< where it was loaded from; paths are relative to its folder
    std::string title = {};
    std::string notes = {};
    double dt_s = 1.0;
    double start_s = 0.0;
    double end_s = 0.0;
    Settings settings = {}; ///< of all sensors
    std::vector<ScenarioEntity> entities = {};
    std::vector<ScenarioSensor> sensors = {};

    std::filesystem::path resolve(const std::filesystem::path& path) const;
    /// "flyby.json", or the title, or "new scenario".
    std::string displayName() const;
    /// Times of all steps, s: start + k dt. An end that is a step but for rounding is one.
    std::vector<double> times_s() const;
    /// Position in `entities` or `sensors`; no value where there is none of that name.
    std::optional<std::size_t> findEntity(const std::string& name) const;
    std::optional<std::size_t> findSensor(const std::string& name) const;

    bool operator==(const Scenario&) const = default;
};

/// True for the settings that a scenario or one of its sensors may set: sensor, scaling,
/// environment, render, display and image. Camera, target and state follow from the trajectories.
bool isScenarioSetting(const SettingInfo& setting);

/// What KARMA does and a project has to ask for (F32, F55), below all that a scenario sets: scaling
/// files beside models are applied, the sun's disc is drawn.
const Settings& scenarioDefaults();

} // namespace smat

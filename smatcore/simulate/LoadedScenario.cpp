#include "smatcore/simulate/LoadedScenario.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/sensor/SensorFile.h"
#include "irsg/signature/ScalingXml.h"
#include "smatcore/analysis/ImageSensor.h"
#include "smatcore/project/NamedPaths.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/simulate/ImagingSensorXml.h"
#include "smatcore/support/Log.h"

namespace smat {

namespace {

/// Reads the files of one scenario and collects what is wrong with them.
class Loader {
  public:
    Loader(const Scenario& scenario, SceneBuilder& builder, const Settings& overrides,
           const EditedTrajectories& edited)
        : scenario_(scenario), builder_(builder), overrides_(overrides), edited_(edited) {}

    LoadedScenario load() {
        LoadedScenario loaded{.scenario = scenario_, .paths = {}, .sensors = {}};
        for (std::size_t i = 0; i < scenario_.entities.size(); ++i)
            loaded.paths.push_back(pathOf(scenario_.entities[i], i));
        const Project project = projectOf(scenario_);
        for (const ScenarioSensor& sensor : scenario_.sensors) {
            loaded.sensors.push_back(loadSensor(sensor, project));
            shareEnvironment(loaded.sensors);
        }
        if (!diagnostics_.empty())
            throw irsg::InputError(diagnostics_);
        return loaded;
    }

  private:
    /// Keeps what a piece of the work refuses. What several sensors share is refused once.
    template <typename Work>
    void collect(const Work& work) {
        irsg::collectOnce(diagnostics_, work);
    }

    Trajectory pathOf(const ScenarioEntity& entity, std::size_t index) {
        if (entity.trajectory.empty())
            return Trajectory(entity.pose, entity.power.value_or(0.0), entity.mach.value_or(0.0));
        Trajectory path = read(entity.trajectory);
        const auto refuseBoth = [&](const char* key, bool isBoth) {
            if (isBoth) {
                diagnostics_.push_back({.file = scenario_.displayName(),
                                        .position = fmt::format("entities.{}.{}", index, key),
                                        .value = "a value beside a trajectory with that column",
                                        .expected = "one of them"});
            }
        };
        refuseBoth("power", entity.power && path.hasPower());
        refuseBoth("mach", entity.mach && path.hasMach());
        return path;
    }

    Trajectory read(const std::filesystem::path& file) {
        Trajectory path{irsg::Pose()};
        collect([&] {
            const std::filesystem::path at = scenario_.resolve(file);
            if (const auto edited = edited_.find(at); edited != edited_.end()) {
                path = Trajectory(edited->second);
                return;
            }
            logInfo("reading trajectory " + at.string());
            path = Trajectory::read(at);
        });
        return path;
    }

    LoadedSensor loadSensor(const ScenarioSensor& sensor, const Project& project) {
        LoadedSensor loaded{.settings = scenario_.settings,
                            .scene = {},
                            .path = Trajectory(irsg::Pose()),
                            .warnings = {}};
        // Names of the project's files are remarked by their scene.
        std::vector<std::filesystem::path> named{sensor.trajectory, sensor.imagingSensor};
        for (const ScenarioEntity& entity : scenario_.entities)
            named.push_back(entity.trajectory);
        for (const std::filesystem::path& path : named)
            if (std::string remark = namedPath(scenario_.file, path).remark; !remark.empty())
                loaded.warnings.push_back(std::move(remark));
        if (sensor.mount == MountKind::trajectory)
            loaded.path = read(sensor.trajectory);
        named_.reset();
        if (!sensor.imagingSensor.empty())
            collect([&] { readImagingSensorOf(sensor, loaded); });
        loaded.settings = loaded.settings.with(sensor.settings).with(overrides_);
        // Files that nobody asked for need not be there.
        const bool isAsked = loaded.settings.isSet(key::scalingUse);
        loaded.settings = scenarioDefaults().with(loaded.settings);
        if (!isAsked && !hasScalings())
            loaded.settings.set(key::scalingUse, "false");
        // What the ImagingSensor file turns on must be named somewhere.
        if (named_)
            for (irsg::Diagnostic& missing :
                 named_->missingIn(loaded.settings, "the scenario or its sensor " + sensor.name))
                diagnostics_.push_back(std::move(missing));
        collect([&] { readChain(sensor, loaded); });
        collect([&] { loaded.scene = builder_.build(project, loaded.settings); });
        if (loaded.chain)
            followSensor(loaded.chain->sensor(), loaded.scene);
        // A step has the same frame whatever was before it.
        loaded.scene.environment = irsg::onTheFly(loaded.scene.environment);
        return loaded;
    }

    /// The sensor that reads the frames. Refuses what only one could do, or none.
    void readChain(const ScenarioSensor& sensor, LoadedSensor& loaded) {
        const auto refuse = [&](const char* key, const std::string& value, const char* expected) {
            throw irsg::InputError({.file = scenario_.displayName(),
                                    .position = "sensor " + sensor.name + ", " + key,
                                    .value = value,
                                    .expected = expected});
        };
        const std::vector<std::filesystem::path> file = loaded.settings[key::imageSensor];
        if (file.empty()) {
            if (loaded.settings.text(key::imageQuantity) == "counts")
                refuse(key::imageQuantity.name, "counts",
                       "another quantity, or a sensor (image.sensor) that counts");
            return;
        }
        if (loaded.settings[key::imageTruthLayers])
            refuse(key::imageTruthLayers.name, "true",
                   "false with a sensor, whose pixels mix what layers tell apart");
        loaded.chain = std::make_shared<const irsg::SensorChain>(
            irsg::loadSensor(scenario_.resolve(file.front())));
        checkSensorGrid(loaded.chain->sensor(), loaded.settings);
        followSensor(loaded.chain->sensor(), loaded.settings);
    }

    bool hasScalings() const {
        return std::ranges::any_of(scenario_.entities, [&](const ScenarioEntity& entity) {
            return irsg::hasScalingFiles(scenario_.resolve(entity.model));
        });
    }

    void readImagingSensorOf(const ScenarioSensor& sensor, LoadedSensor& loaded) {
        const ImagingSensorFile read = readImagingSensor(scenario_.resolve(sensor.imagingSensor));
        loaded.settings = loaded.settings.with(read.set.settings);
        loaded.warnings.insert(loaded.warnings.end(), read.remarks.begin(), read.remarks.end());
        named_ = read;
    }

    /// Gives the last sensor the environment of an earlier one that is described alike, so that
    /// what an atmosphere has computed serves both.
    static void shareEnvironment(std::vector<LoadedSensor>& sensors) {
        LoadedSensor& last = sensors.back();
        for (const LoadedSensor& earlier : sensors) {
            const bool isAlike =
                std::all_of(settingTable().begin(), settingTable().end(), [&](const auto& setting) {
                    return setting.section() != "environment" ||
                           (earlier.settings.text(setting.key) == last.settings.text(setting.key) &&
                            earlier.settings.isSet(setting.key) ==
                                last.settings.isSet(setting.key));
                });
            if (isAlike && &earlier != &last) {
                last.scene.environment = earlier.scene.environment;
                return;
            }
        }
    }

    const Scenario& scenario_;
    SceneBuilder& builder_;
    const Settings& overrides_;
    const EditedTrajectories& edited_;
    std::optional<ImagingSensorFile> named_; ///< by the sensor that is being loaded
    std::vector<irsg::Diagnostic> diagnostics_;
};

} // namespace

std::optional<TrajectoryPoint> LoadedScenario::entityAt(std::size_t entity, double time_s) const {
    const ScenarioEntity& given = scenario.entities.at(entity);
    std::optional<TrajectoryPoint> point = paths.at(entity).at(time_s, given.hold);
    if (point && !paths[entity].hasPower())
        point->power = given.power.value_or(0.0);
    if (point && !paths[entity].hasMach())
        point->mach = given.mach.value_or(0.0);
    return point;
}

std::optional<SensorPlace> LoadedScenario::sensorAt(std::size_t sensor, double time_s) const {
    const ScenarioSensor& given = scenario.sensors.at(sensor);
    const irsg::Rotation own = given.offset.attitude.rotation();
    std::optional<TrajectoryPoint> mount;
    switch (given.mount) {
    case MountKind::world:
        return SensorPlace{given.offset.position_m, own};
    case MountKind::trajectory:
        mount = sensors.at(sensor).path.at(time_s, given.hold);
        break;
    case MountKind::entity:
        mount = entityAt(scenario.findEntity(given.carrier).value(), time_s);
        break;
    }
    if (!mount)
        return std::nullopt;
    return SensorPlace{mount->pose.toWorld(given.offset.position_m),
                       mount->pose.attitude.rotation() * own};
}

Project projectOf(const Scenario& scenario) {
    Project project;
    project.file = scenario.file;
    project.title = scenario.title;
    for (const ScenarioEntity& entity : scenario.entities) {
        ProjectModel model;
        model.name = entity.name;
        model.file = entity.model;
        model.database = entity.database;
        model.options = entity.options;
        model.referencePoint_m = entity.referencePoint_m;
        model.fallbackTemperature = entity.fallbackTemperature;
        model.fallbackMaterial = entity.fallbackMaterial;
        project.models.push_back(model);
    }
    return project;
}

LoadedScenario loadScenarioFiles(const Scenario& scenario, SceneBuilder& builder,
                                 const Settings& overrides, const EditedTrajectories& edited) {
    return Loader(scenario, builder, overrides, edited).load();
}

} // namespace smat

#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "irsg/core/FileStamp.h"
#include "irsg/geometry/reading/ModelCodes.h"
#include "smatcore/data/SceneDescription.h"
#include "smatcore/project/Project.h"

namespace smat {

/// Makes the scene a project and its settings describe: loads models and databases, each once,
/// reads atmospheres and responses, and checks the whole. Models and databases are kept until their
/// file changes (time of writing or size).
class SceneBuilder {
  public:
    using ModelLoader = std::function<std::shared_ptr<const irsg::Model>(
        const std::filesystem::path&, const irsg::ModelOptions&)>;

    /// `loader` stands in for irsg::Model::load in tests.
    explicit SceneBuilder(ModelLoader loader = {});

    /// Throws InputError with the diagnostics of all parts together. An `environment` that is given
    /// stands in for reading the atmospheres of the settings.
    SceneDescription build(const Project& project, const Settings& settings,
                           const irsg::Environment* environment = nullptr);
    std::shared_ptr<const irsg::Model> model(const std::filesystem::path& file,
                                             const irsg::ModelOptions& options);
    /// Models are asked for anew, though their files are what they were.
    void forgetModels() { models_.clear(); }
    std::shared_ptr<const irsg::SignatureDatabase> database(const std::filesystem::path& file);
    /// Databases that stand in for files, by their resolved path, while they are being edited; the
    /// files need not even exist. Replaces those of the last call.
    using DatabaseOverrides =
        std::map<std::filesystem::path, std::shared_ptr<const irsg::SignatureDatabase>>;
    void setDatabaseOverrides(DatabaseOverrides overrides);
    /// Null where the settings name none.
    std::shared_ptr<const irsg::Skybox> skybox(const Project& project, const Settings& settings);
    std::shared_ptr<const irsg::Terrain> terrain(const Project& project, const Settings& settings);

  private:
    template <typename Value, typename Stamp = irsg::FileStamp>
    struct CacheEntry {
        Stamp stamp;
        Value value;
    };
    static irsg::FileStamp stampOf(const std::filesystem::path& file, const char* what);

    ModelLoader loader_;
    std::map<ModelKey, CacheEntry<std::shared_ptr<const irsg::Model>, irsg::ModelStamp>> models_;
    std::map<std::string, CacheEntry<std::shared_ptr<const irsg::SignatureDatabase>>> databases_;
    DatabaseOverrides overrides_;
    // The last ones, by all that names them and the stamps of their files.
    std::pair<std::string, std::shared_ptr<const irsg::Skybox>> skybox_;
    std::pair<std::string, std::shared_ptr<const irsg::Terrain>> terrain_;
};

/// The pieces that need no file of a model, for forms that show their effect at once. Paths are
/// resolved against `project`. Each throws InputError.
irsg::Environment environmentOf(const Project& project, const Settings& settings);
/// A text that changes with every setting that environmentOf reads, for who keeps an environment:
/// of the sun's azimuth and elevation with whether they are set, since `sun` can be moved without
/// the air being read again; and when a file of the air is written again.
std::string environmentKey(const Project& project, const Settings& settings);
/// The sensor with the first of its bands.
irsg::Sensor sensorOf(const Project& project, const Settings& settings);
/// The settings as they are for each of the sensor's bands alone: with one `sensor.band`, or one
/// `sensor.response` where there are any.
std::vector<Settings> eachBand(const Settings& settings);
/// The bands of the sensor, at least one. Throws InputError also for responses that are equal.
std::vector<irsg::Band> bandsOf(const Project& project, const Settings& settings);
/// What tells bands apart in names of columns and files: "3-5um", the file's name of a response.
/// No two are equal.
std::vector<std::string> bandLabels(const std::vector<irsg::Band>& bands);
irsg::RenderSettings renderSettingsOf(const Settings& settings);
irsg::Pose targetPoseOf(const Settings& settings);
/// Time, power and Mach number; what follows from the place is left to the renderer.
irsg::EntityState targetStateOf(const Settings& settings);
/// Of any model of a project: the target as the settings place it, the others as their own pose.
irsg::Pose poseOf(const Project& project, const Settings& settings, std::size_t model);
irsg::EntityState stateOf(const Project& project, const Settings& settings, std::size_t model);

} // namespace smat

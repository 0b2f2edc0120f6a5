#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "irsg/geometry/reading/ModelValues.h"
#include "irsg/geometry/view/Pose.h"
#include "smatcore/settings/Settings.h"

namespace smat {

/// Paths as a JSON file of ours says them: relative to its folder where they lie in it or one step
/// beside it, absolute where they are farther away.
class JsonPaths {
  public:
    /// `from` is the folder that the paths are relative to now, `folder` that of the file.
    JsonPaths(std::filesystem::path from, std::filesystem::path folder);

    /// "" for an empty path.
    std::string text(const std::filesystem::path& path) const;

  private:
    std::filesystem::path from_, folder_;
};

/// Adds what is set, section by section.
void writeSettings(nlohmann::json& json, const JsonPaths& paths, const Settings& settings);
/// The same without the values that equal those of `under`, which would be in effect anyway.
void writeSettings(nlohmann::json& json, const JsonPaths& paths, const Settings& settings,
                   const Settings& under);

/// `upAxis`, `noseAxis`, `unit_m`, `origin`, `twoSided` and `cutTextureAlpha`, where they are
/// set.
void writeModelOptions(nlohmann::json& json, const irsg::ModelOptions& options);
nlohmann::json pointJson(const irsg::Vec3& point);
/// `yaw_deg`, `pitch_deg` and `roll_deg`, where they are not 0.
void writeAttitude(nlohmann::json& json, const irsg::Attitude& attitude);

} // namespace smat

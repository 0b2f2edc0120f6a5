#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/JsonText.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/view/Pose.h"
#include "smatcore/settings/Settings.h"

namespace smat {

using irsg::joinedKeyPath;
using irsg::shownJson;

/// Takes values out of the JSON of a file of ours (used by its readers alone) and collects what is
/// wrong with them, each with its key path and line, the value and what was expected. A value that
/// was taken is gone from its object, so that what is left over there is what nobody knows.
class JsonFields {
  public:
    using Json = nlohmann::json;

    /// `kind` says what the file should be: "a project file (JSON)". Throws InputError for text
    /// that is not JSON.
    JsonFields(std::string fileName, const std::string& text, const std::string& kind);

    const std::string& fileName() const { return fileName_; }
    /// The whole file; what was taken is no longer in it.
    Json& root() { return json_; }

    /// Refuses a root that is no object, and a missing or newer `version`, on the spot: by the same
    /// keys a newer file may mean other things.
    void takeVersion(int newest, const std::string& parts);

    /// Values by key; what is missing gives "", false, 0 or no value.
    std::string takeText(Json& json, const char* key, const std::string& path);
    bool takeBoolean(Json& json, const char* key, const std::string& path);
    double takeNumber(Json& json, const char* key, const std::string& path, double minimum,
                      double maximum);
    /// Three numbers in m, each up to 1e9.
    std::optional<irsg::Vec3> takePoint(Json& json, const char* key, const std::string& path);
    /// `yaw_deg`, `pitch_deg` and `roll_deg`.
    irsg::Attitude takeAttitude(Json& json, const std::string& path);
    std::optional<int> takeIndex(Json& json, const char* key, const std::string& path);
    /// How a model is read: `upAxis`, `noseAxis`, `unit_m`, `origin`, `twoSided` and
    /// `cutTextureAlpha`.
    irsg::ModelOptions takeModelOptions(Json& json, const std::string& path);
    /// Takes the sections of settings out of `json`; what is unknown in them stays.
    Settings takeSettings(Json& json, const std::string& path);

    void refuse(const std::string& path, const std::string& value, const std::string& expected);
    void refuse(const std::string& path, const Json& value, const std::string& expected);
    bool isRefused() const { return !diagnostics_.empty(); }
    /// Throws InputError with everything that was refused, if anything was.
    void throwRefused() const;

  private:
    std::optional<irsg::ModelAxis> takeAxis(Json& json, const char* key, const std::string& path);
    std::optional<irsg::ModelOrigin> takeOrigin(Json& json, const std::string& path);
    void takeSetting(Settings& settings, const std::string& key, const Json& value,
                     const std::string& path);

    std::string fileName_;
    Json json_;
    irsg::JsonPlaces places_;
    std::vector<irsg::Diagnostic> diagnostics_;
};

/// True for what can be the name of a file in any folder: no separators, no line breaks, no dot in
/// front.
bool isFileName(const std::string& name);

/// "file", "centre" and "base", in the order of irsg::ModelOrigin::At.
const std::vector<std::string>& modelOriginNames();

} // namespace smat

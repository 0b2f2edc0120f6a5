#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "irsg/radiometry/Errors.h"
#include "smatcore/project/Project.h"
#include "smatcore/support/JsonLines.h"

namespace smat {

/// Reads the parts of a `.smat` file and collects what is wrong with them (used by ProjectFile
/// alone). Keys nobody asks for end up in the `unknownKeys` of the part they stand in.
class ProjectReader {
  public:
    ProjectReader(std::string fileName, const std::string& text);

    /// Throws InputError with everything that was wrong.
    Project read();

  private:
    using Json = nlohmann::json;

    void readVersion();
    void readModels(Project& project);
    ProjectModel readModel(const Json& json, const std::string& path);
    void readTargetPose(const Json& json, const std::string& path);
    void readAnalyses(Project& project);
    NamedAnalysis readAnalysis(const std::string& name, const Json& json, const std::string& path);
    /// Takes the sections of settings out of `json`; what is unknown in them stays.
    Settings readSettings(Json& json, const std::string& path);
    void readSetting(Settings& settings, const std::string& key, const Json& value,
                     const std::string& path);

    std::string takeText(Json& json, const char* key, const std::string& path);
    bool takeBoolean(Json& json, const char* key, const std::string& path);
    double takeNumber(Json& json, const char* key, const std::string& path, double minimum,
                      double maximum);
    std::optional<irsg::Vec3> takePoint(Json& json, const char* key, const std::string& path);
    std::optional<int> takeIndex(Json& json, const char* key, const std::string& path);
    irsg::NoseAxis takeNoseAxis(Json& json, const std::string& path);

    void refuse(const std::string& path, const std::string& value, const std::string& expected);
    void refuse(const std::string& path, const Json& value, const std::string& expected);

    std::string fileName_;
    Json json_;
    JsonLines lines_;
    std::vector<irsg::Offence> offences_;
};

/// "+y" and so on, in the order of irsg::NoseAxis.
const std::vector<std::string>& noseAxisNames();

} // namespace smat

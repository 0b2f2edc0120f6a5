#include "smatcore/project/ProjectFile.h"

#include <nlohmann/json.hpp>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/ProjectReader.h"
#include "smatcore/support/TextFile.h"

namespace smat {

namespace {

using Json = nlohmann::json;

/// A path as the file says it: relative to the file's folder where it lies in it or one step beside
/// it, absolute where it is farther away.
std::string pathText(const Project& project, const std::filesystem::path& path,
                     const std::filesystem::path& folder) {
    if (path.empty()) {
        return "";
    }
    const std::filesystem::path absolute =
        std::filesystem::absolute(project.resolve(path)).lexically_normal();
    const std::filesystem::path relative = absolute.lexically_relative(folder);
    const bool isFar = relative.empty() || relative.string().starts_with("../..");
    return (isFar && !path.is_relative() ? absolute : relative).generic_string();
}

Json settingJson(const Project& project, const std::filesystem::path& folder,
                 const SettingInfo& setting, const Settings& settings) {
    const std::string& text = settings.text(setting.key);
    switch (setting.kind) {
    case SettingKind::integer:
        return settings.integer(setting.key);
    case SettingKind::real:
        return settings.real(setting.key);
    case SettingKind::boolean:
        return settings.boolean(setting.key);
    case SettingKind::choiceOrReal: {
        const std::optional<double> number = settings.optionalReal(setting.key);
        return number ? Json(*number) : Json(text);
    }
    case SettingKind::path:
        return pathText(project, text, folder);
    case SettingKind::pathList: {
        Json list = Json::array();
        for (const std::filesystem::path& path : settings.paths(setting.key)) {
            list.push_back(pathText(project, path, folder));
        }
        return list;
    }
    case SettingKind::choice:
    case SettingKind::band:
        return text;
    }
    throw irsg::LogicError("unknown kind of setting");
}

/// Adds what is set, section by section. Values that equal what would be in effect without them,
/// the default or the project's own, are left out.
void writeSettings(Json& json, const Project& project, const std::filesystem::path& folder,
                   const Settings& settings, const Settings& under) {
    for (const SettingInfo& setting : settingTable()) {
        if (settings.isSet(setting.key) && settings.text(setting.key) != under.text(setting.key)) {
            const std::string section = setting.section();
            json[section][setting.key.substr(section.size() + 1)] =
                settingJson(project, folder, setting, settings);
        }
    }
}

/// Puts kept keys back, without touching what this version has written.
void mergeUnknown(Json& json, const Json& unknown) {
    for (const auto& [key, value] : unknown.items()) {
        if (json.contains(key) && json[key].is_object() && value.is_object()) {
            mergeUnknown(json[key], value);
        } else if (!json.contains(key)) {
            json[key] = value;
        }
    }
}

void mergeUnknown(Json& json, const std::string& unknown) {
    if (!unknown.empty()) {
        mergeUnknown(json, Json::parse(unknown));
    }
}

Json pointJson(const irsg::Vec3& point) {
    return {point.x, point.y, point.z};
}

void writeAngle(Json& json, const char* key, double angle_rad) {
    // Degrees come back from radians with an error of rounding, which nobody meant to write.
    const double angle_deg = std::round(irsg::degrees(angle_rad) * 1e10) / 1e10;
    if (angle_deg != 0.0) {
        json[key] = angle_deg;
    }
}

Json modelJson(const Project& project, const ProjectModel& model,
               const std::filesystem::path& folder) {
    Json json = Json::object();
    if (!model.name.empty()) {
        json["name"] = model.name;
    }
    json["file"] = pathText(project, model.file, folder);
    if (!model.database.empty()) {
        json["database"] = pathText(project, model.database, folder);
    }
    if (model.noseAxis != irsg::NoseAxis::plusY) {
        json["noseAxis"] = noseAxisNames()[static_cast<std::size_t>(model.noseAxis)];
    }
    if (model.forceTwoSided) {
        json["twoSided"] = true;
    }
    if (model.pose.position_m != irsg::Vec3{}) {
        json["position_m"] = pointJson(model.pose.position_m);
    }
    writeAngle(json, "yaw_deg", model.pose.attitude.yaw_rad);
    writeAngle(json, "pitch_deg", model.pose.attitude.pitch_rad);
    writeAngle(json, "roll_deg", model.pose.attitude.roll_rad);
    if (model.referencePoint_m) {
        json["referencePoint_m"] = pointJson(*model.referencePoint_m);
    }
    if (model.fallbackTemperature) {
        json["fallbackTemperature"] = *model.fallbackTemperature;
    }
    if (model.fallbackMaterial) {
        json["fallbackMaterial"] = *model.fallbackMaterial;
    }
    mergeUnknown(json, model.unknownKeys);
    return json;
}

void listKeys(const std::string& path, const std::string& unknown, std::vector<std::string>& keys) {
    if (unknown.empty()) {
        return;
    }
    const Json json = Json::parse(unknown);
    for (const auto& [key, value] : json.items()) {
        // Of a section of settings only the keys inside are unknown.
        bool isSection = false;
        for (const SettingInfo& setting : settingTable()) {
            isSection = isSection || setting.section() == key;
        }
        if (isSection && value.is_object()) {
            listKeys(joinedKeyPath(path, key), value.dump(), keys);
        } else {
            keys.push_back(joinedKeyPath(path, key));
        }
    }
}

} // namespace

Project loadProject(const std::filesystem::path& file) {
    return projectFromJson(readTextFile(file), file);
}

Project projectFromJson(const std::string& text, const std::filesystem::path& file) {
    Project project = ProjectReader(file.string(), text).read();
    project.file = file;
    return project;
}

std::string projectToJson(const Project& project, const std::filesystem::path& file) {
    const std::filesystem::path folder =
        std::filesystem::absolute(file).lexically_normal().parent_path();
    Json json = Json::object();
    json["version"] = projectFileVersion;
    if (!project.title.empty()) {
        json["title"] = project.title;
    }
    if (!project.notes.empty()) {
        json["notes"] = project.notes;
    }
    for (const ProjectModel& model : project.models) {
        json["models"].push_back(modelJson(project, model, folder));
    }
    writeSettings(json, project, folder, project.settings, Settings());
    for (const NamedAnalysis& analysis : project.analyses) {
        Json one = {{"kind", name(analysis.kind)}};
        if (!analysis.notes.empty()) {
            one["notes"] = analysis.notes;
        }
        writeSettings(one, project, folder, analysis.settings, project.settings);
        mergeUnknown(one, analysis.unknownKeys);
        json["analyses"][analysis.name] = std::move(one);
    }
    mergeUnknown(json, project.unknownKeys);
    return json.dump(2) + "\n";
}

void saveProject(const Project& project, const std::filesystem::path& file) {
    writeTextFile(file, projectToJson(project, file));
}

std::vector<std::string> unknownKeys(const Project& project) {
    std::vector<std::string> keys;
    listKeys("", project.unknownKeys, keys);
    for (std::size_t i = 0; i < project.models.size(); ++i) {
        listKeys("models." + std::to_string(i), project.models[i].unknownKeys, keys);
    }
    for (const NamedAnalysis& analysis : project.analyses) {
        listKeys("analyses." + analysis.name, analysis.unknownKeys, keys);
    }
    return keys;
}

} // namespace smat

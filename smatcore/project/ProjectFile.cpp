#include "smatcore/project/ProjectFile.h"

#include <nlohmann/json.hpp>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/ProgramVersion.h"
#include "smatcore/project/JsonWriting.h"
#include "smatcore/project/ProjectReader.h"
#include "smatcore/support/NearestNames.h"
#include "smatcore/support/TextFile.h"

namespace smat {

namespace {

using Json = nlohmann::json;

/// Puts kept keys back, without touching what this version has written.
void mergeUnknown(Json& json, const Json& unknown) {
    for (const auto& [key, value] : unknown.items())
        if (json.contains(key) && json[key].is_object() && value.is_object())
            mergeUnknown(json[key], value);
        else if (!json.contains(key))
            json[key] = value;
}

void mergeUnknown(Json& json, const std::string& unknown) {
    if (!unknown.empty())
        mergeUnknown(json, Json::parse(unknown));
}

Json modelJson(const ProjectModel& model, const JsonPaths& paths) {
    Json json = Json::object();
    if (!model.name.empty())
        json["name"] = model.name;
    json["file"] = paths.text(model.file);
    if (!model.database.empty())
        json["database"] = paths.text(model.database);
    writeModelOptions(json, model.options);
    if (model.pose.position_m != irsg::Vec3{})
        json["position_m"] = pointJson(model.pose.position_m);
    writeAttitude(json, model.pose.attitude);
    if (model.own.power)
        json["power"] = *model.own.power;
    if (model.own.mach)
        json["mach"] = *model.own.mach;
    if (model.own.timeOffset_s != 0.0)
        json["timeOffset_s"] = model.own.timeOffset_s;
    if (model.referencePoint_m)
        json["referencePoint_m"] = pointJson(*model.referencePoint_m);
    if (model.fallbackTemperature)
        json["fallbackTemperature"] = *model.fallbackTemperature;
    if (model.fallbackMaterial)
        json["fallbackMaterial"] = *model.fallbackMaterial;
    mergeUnknown(json, model.unknownKeys);
    return json;
}

/// Keys of a model, as modelJson writes them.
std::vector<std::string> modelKeys() {
    return {"name",
            "file",
            "database",
            "upAxis",
            "noseAxis",
            "unit_m",
            "origin",
            "twoSided",
            "cutTextureAlpha",
            "position_m",
            "yaw_deg",
            "pitch_deg",
            "roll_deg",
            "power",
            "mach",
            "timeOffset_s",
            "referencePoint_m",
            "fallbackTemperature",
            "fallbackMaterial"};
}

void listKeys(const std::string& path, const std::string& unknown, std::vector<std::string>& keys) {
    if (unknown.empty())
        return;
    const Json json = Json::parse(unknown);
    for (const auto& [key, value] : json.items()) {
        // Of a section of settings only the keys inside are unknown.
        bool isSection = false;
        for (const SettingInfo& setting : settingTable())
            isSection = isSection || setting.section() == key;
        if (isSection && value.is_object())
            listKeys(irsg::joinedKeyPath(path, key), value.dump(), keys);
        else
            keys.push_back(irsg::joinedKeyPath(path, key));
    }
}

} // namespace

Project loadProject(const std::filesystem::path& file, std::vector<std::string>* remarks) {
    return projectFromJson(readTextFile(file), file, remarks);
}

Project projectFromJson(const std::string& text, const std::filesystem::path& file,
                        std::vector<std::string>* remarks) {
    Project project = readProject(text, file.string(), remarks);
    project.file = file;
    return project;
}

std::string projectToJson(const Project& project, const std::filesystem::path& file) {
    const JsonPaths paths(project.file.parent_path(),
                          std::filesystem::absolute(file).lexically_normal().parent_path());
    Json json = Json::object();
    json["version"] = projectFileVersion;
    json["program"] = irsg::programWithVersion();
    if (!project.title.empty())
        json["title"] = project.title;
    if (!project.notes.empty())
        json["notes"] = project.notes;
    if (!project.results.empty())
        json["results"] = project.results;
    for (const ProjectModel& model : project.models)
        json["models"].push_back(modelJson(model, paths));
    writeSettings(json, paths, project.settings, Settings());
    for (const NamedAnalysis& analysis : project.analyses) {
        Json one = {{"kind", name(analysis.kind)}};
        if (!analysis.notes.empty())
            one["notes"] = analysis.notes;
        writeSettings(one, paths, analysis.settings, project.settings);
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
    for (std::size_t i = 0; i < project.models.size(); ++i)
        listKeys("models." + std::to_string(i), project.models[i].unknownKeys, keys);
    for (const NamedAnalysis& analysis : project.analyses)
        listKeys("analyses." + analysis.name, analysis.unknownKeys, keys);
    return keys;
}

std::string knownKeysLike(const std::string& path) {
    if (const std::string settings = settingsLike(path); !settings.empty())
        return settings;
    const std::string key = path.substr(path.rfind('.') + 1);
    if (path.starts_with("models."))
        return didYouMean(key, modelKeys());
    std::vector<std::string> names{"title", "notes", "results", "models", "analyses"};
    if (path.starts_with("analyses."))
        names = {"kind", "notes"};
    for (const SettingInfo& setting : settingTable())
        irsg::appendUnique(names, setting.section());
    return didYouMean(key, names);
}

} // namespace smat

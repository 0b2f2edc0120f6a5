#include "smatcore/project/ProjectReader.h"

#include <fmt/format.h>

#include "smatcore/project/ProjectFile.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

using Json = nlohmann::json;

/// What is left of an object after everything known was taken out; "" where nothing is.
std::string leftOver(const Json& json) {
    return json.empty() ? "" : json.dump();
}

} // namespace

ProjectReader::ProjectReader(std::string fileName, const std::string& text)
    : JsonFields(std::move(fileName), text, "a project file (JSON)") {}

Project ProjectReader::read() {
    takeVersion(projectFileVersion, "version, models, settings and analyses");
    Project project;
    project.title = takeText(root(), "title", "");
    project.notes = takeText(root(), "notes", "");
    project.results = takeText(root(), "results", "");
    if (!project.results.empty() && !isFileName(project.results))
        refuse("results", project.results, "the name of a folder beside the project");
    readModels(project);
    readAnalyses(project);
    project.settings = takeSettings(root(), "");
    project.unknownKeys = leftOver(root());
    throwRefused();
    return project;
}

void ProjectReader::readModels(Project& project) {
    const auto found = root().find("models");
    if (found == root().end())
        return;
    if (!found->is_array()) {
        refuse("models", *found, "a list of models");
    } else {
        for (std::size_t i = 0; i < found->size(); ++i) {
            const std::string path = fmt::format("models.{}", i);
            if (!(*found)[i].is_object()) {
                refuse(path, (*found)[i], "an object with file and database");
                continue;
            }
            if (i == 0)
                refuseOwnOfTarget((*found)[i], path);
            project.models.push_back(readModel((*found)[i], path));
        }
    }
    root().erase("models");
}

void ProjectReader::refuseOwnOfTarget(const Json& json, const std::string& path) {
    for (const char* key : {"power", "mach", "timeOffset_s"}) {
        if (json.contains(key)) {
            refuse(joinedKeyPath(path, key), json[key],
                   "no state of its own: the first model is the target, of which state.power, "
                   "state.mach and state.time tell");
        }
    }
    for (const char* key : {"position_m", "yaw_deg", "pitch_deg", "roll_deg"}) {
        if (json.contains(key)) {
            refuse(joinedKeyPath(path, key), json[key],
                   "no pose of its own: the first model is the target, which target.altitude, "
                   "target.yaw, target.pitch and target.roll place");
        }
    }
}

ProjectModel ProjectReader::readModel(const Json& given, const std::string& path) {
    Json json = given;
    ProjectModel model;
    model.name = takeText(json, "name", path);
    const bool hasFile = json.contains("file");
    model.file = takeText(json, "file", path);
    if (!hasFile || (model.file.empty() && given["file"].is_string()))
        refuse(joinedKeyPath(path, "file"), std::string("nothing"), "the file of the model");
    model.database = takeText(json, "database", path);
    model.options = takeModelOptions(json, path);
    if (const auto position = takePoint(json, "position_m", path))
        model.pose.position_m = *position;
    model.pose.attitude = takeAttitude(json, path);
    const auto takeWithin = [&](const char* name, std::string_view limits) {
        const SettingInfo& setting = settingInfo(limits);
        return json.contains(name)
                   ? std::optional(takeNumber(json, name, path, setting.minimum, setting.maximum))
                   : std::nullopt;
    };
    model.own.power = takeWithin("power", key::statePower);
    model.own.mach = takeWithin("mach", key::stateMach);
    model.own.timeOffset_s = takeWithin("timeOffset_s", key::stateTime).value_or(0.0);
    model.referencePoint_m = takePoint(json, "referencePoint_m", path);
    model.fallbackTemperature = takeIndex(json, "fallbackTemperature", path);
    model.fallbackMaterial = takeIndex(json, "fallbackMaterial", path);
    model.unknownKeys = leftOver(json);
    return model;
}

void ProjectReader::readAnalyses(Project& project) {
    const auto found = root().find("analyses");
    if (found == root().end())
        return;
    if (!found->is_object()) {
        refuse("analyses", *found, "an object of analyses by name");
    } else {
        // Objects of this library are sorted by key, which is the order of Project::analyses.
        for (const auto& [name, json] : found->items()) {
            const std::string path = "analyses." + name;
            if (!isFileName(name))
                refuse(path, Json(name), "a name that can be a file name");
            if (!json.is_object()) {
                refuse(path, json, "an object with the kind of the analysis");
                continue;
            }
            project.analyses.push_back(readAnalysis(name, json, path));
        }
    }
    root().erase("analyses");
}

NamedAnalysis ProjectReader::readAnalysis(const std::string& name, const Json& given,
                                          const std::string& path) {
    Json json = given;
    NamedAnalysis analysis;
    analysis.name = name;
    const std::string word = takeText(json, "kind", path);
    const std::optional<AnalysisKind> kind = analysisKindFromName(word);
    if (!kind && (!given.contains("kind") || given["kind"].is_string())) {
        refuse(joinedKeyPath(path, "kind"),
               given.contains("kind") ? shownJson(given["kind"]) : "nothing", analysisKindNames());
    }
    analysis.kind = kind.value_or(AnalysisKind::image);
    analysis.notes = takeText(json, "notes", path);
    analysis.settings = takeSettings(json, path);
    analysis.unknownKeys = leftOver(json);
    return analysis;
}

} // namespace smat

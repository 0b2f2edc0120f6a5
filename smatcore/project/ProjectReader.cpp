#include "smatcore/project/ProjectReader.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "irsg/core/AppendUnique.h"
#include "smatcore/project/JsonReading.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/NearestNames.h"

namespace smat {

namespace {

using irsg::JsonReader;

/// What nobody asked for of an object; "" where that is nothing.
std::string leftOver(const JsonReader& json) {
    const nlohmann::json unknown = json.unknown();
    return unknown.empty() ? "" : unknown.dump();
}

void refuseOverrideOfTarget(const JsonReader& json) {
    for (const char* key : {"power", "mach", "timeOffset_s"})
        json.refuseMember(key, "no state of its own: the first model is the target, of which "
                               "state.power, state.mach and state.time tell");
    for (const char* key : {"position_m", "yaw_deg", "pitch_deg", "roll_deg"})
        json.refuseMember(key, "no pose of its own: the first model is the target, which "
                               "target.altitude, target.yaw, target.pitch and target.roll place");
}

ProjectModel readModel(const JsonReader& json) {
    ProjectModel model;
    model.name = json.at("name").textOr("");
    model.file = json.at("file").filledText("the file of the model");
    model.database = json.at("database").textOr("");
    model.options = readModelOptions(json);
    if (const auto position = readPoint(json.at("position_m")))
        model.pose.position_m = *position;
    model.pose.attitude = readAttitude(json);
    const auto within = [&](const char* name, std::string_view limits) {
        const SettingInfo& setting = settingInfo(limits);
        return json.at(name).numberIfAny({setting.minimum, setting.maximum});
    };
    model.own.power = within("power", key::statePower);
    model.own.mach = within("mach", key::stateMach);
    model.own.timeOffset_s = within("timeOffset_s", key::stateTime).value_or(0.0);
    model.referencePoint_m = readPoint(json.at("referencePoint_m"));
    model.fallbackTemperature = readEntryIndex(json.at("fallbackTemperature"));
    model.fallbackMaterial = readEntryIndex(json.at("fallbackMaterial"));
    model.unknownKeys = leftOver(json);
    return model;
}

NamedAnalysis readAnalysis(const std::string& name, const JsonReader& json) {
    NamedAnalysis analysis;
    analysis.name = name;
    const JsonReader kind = json.at("kind");
    const auto known = analysisKindFromName(kind.textOr(""));
    if (!known)
        kind.refuse(analysisKindNames() + didYouMean(kind.textOr(""), analysisKindWords()));
    analysis.kind = known.value_or(AnalysisKind::image);
    analysis.notes = json.at("notes").textOr("");
    analysis.settings = readSettings(json);
    analysis.unknownKeys = leftOver(json);
    return analysis;
}

void readAnalyses(Project& project, const JsonReader& analyses) {
    if (!analyses.exists())
        return;
    // In the order of their names, which is that of Project::analyses.
    for (const auto& [name, json] : analyses.members("an object of analyses by name")) {
        if (!isFileName(name))
            json.refuse(irsg::shownJson(name), "a name that can be a file name");
        if (json.isObject("an object with the kind of the analysis"))
            project.analyses.push_back(readAnalysis(name, json));
    }
}

} // namespace

Project readProject(const std::string& text, const std::string& file,
                    std::vector<std::string>* remarks) {
    const JsonReader root = readVersioned(text, file, "a project file (JSON)", projectFileVersion,
                                          "version, models, settings and analyses");
    Project project;
    project.title = root.at("title").textOr("");
    project.notes = root.at("notes").textOr("");
    const JsonReader results = root.at("results");
    project.results = results.textOr("");
    if (!project.results.empty() && !isFileName(project.results))
        results.refuse(project.results, "the name of a folder beside the project");
    bool isTarget = true;
    for (const JsonReader& model : root.at("models").listOrNone("a list of models")) {
        const bool isFirst = std::exchange(isTarget, false);
        if (!model.isObject("an object with file and database"))
            continue;
        if (isFirst)
            refuseOverrideOfTarget(model);
        project.models.push_back(readModel(model));
    }
    readAnalyses(project, root.at("analyses"));
    project.settings = readSettings(root);
    project.unknownKeys = leftOver(root);
    root.throwRefused();
    if (remarks != nullptr)
        irsg::appendUnique(*remarks, root.remarks());
    return project;
}

} // namespace smat

#include "smatcore/simulate/ScenarioFile.h"

#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "smatcore/project/JsonWriting.h"
#include "smatcore/simulate/ScenarioReader.h"
#include "smatcore/support/TextFile.h"

namespace smat {

namespace {

using Json = nlohmann::json;

/// No scenario is longer; results in JSON may be.
constexpr std::uintmax_t longestScenario_B = 16 << 20;

void writeText(Json& json, const char* key, const std::string& text) {
    if (!text.empty())
        json[key] = text;
}

template <typename Value>
void writeOptional(Json& json, const char* key, const std::optional<Value>& value) {
    if (value)
        json[key] = *value;
}

Json entityJson(const ScenarioEntity& entity, const JsonPaths& paths) {
    Json json = {{"name", entity.name},
                 {"model", paths.text(entity.model)},
                 {"database", paths.text(entity.database)}};
    writeModelOptions(json, entity.options);
    if (entity.referencePoint_m)
        json["referencePoint_m"] = pointJson(*entity.referencePoint_m);
    writeOptional(json, "fallbackTemperature", entity.fallbackTemperature);
    writeOptional(json, "fallbackMaterial", entity.fallbackMaterial);
    if (entity.trajectory.empty()) {
        json["position_m"] = pointJson(entity.pose.position_m);
        writeAttitude(json, entity.pose.attitude);
    } else {
        json["trajectory"] = paths.text(entity.trajectory);
        if (entity.hold)
            json["hold"] = true;
    }
    if (entity.timeOffset_s != 0.0)
        json["timeOffset_s"] = entity.timeOffset_s;
    writeOptional(json, "power", entity.power);
    writeOptional(json, "mach", entity.mach);
    return json;
}

Json sensorJson(const ScenarioSensor& sensor, const JsonPaths& paths) {
    Json json = {{"name", sensor.name}};
    const bool inWorld = sensor.mount == MountKind::world;
    if (inWorld || sensor.offset.position_m != irsg::Vec3{})
        json[inWorld ? "position_m" : "offset_m"] = pointJson(sensor.offset.position_m);
    writeText(json, "carrier", sensor.carrier);
    writeText(json, "trajectory", paths.text(sensor.trajectory));
    if (sensor.hold)
        json["hold"] = true;
    writeAttitude(json, sensor.offset.attitude);
    writeText(json, "track", sensor.track);
    writeText(json, "imagingSensor", paths.text(sensor.imagingSensor));
    writeSettings(json, paths, sensor.settings);
    return json;
}

} // namespace

Scenario scenarioFromJson(const std::string& text, const std::filesystem::path& file,
                          std::vector<std::string>* remarks) {
    Scenario scenario = readScenario(text, file.string(), remarks);
    scenario.file = file;
    return scenario;
}

Scenario loadScenario(const std::filesystem::path& file, std::vector<std::string>* remarks) {
    return scenarioFromJson(readTextFile(file), file, remarks);
}

bool isScenarioFile(const std::filesystem::path& file) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(file, failure) ||
        std::filesystem::file_size(file, failure) > longestScenario_B)
        return false;
    std::string text;
    try {
        text = readTextFile(file);
    } catch (const irsg::InputError&) {
        return false;
    }
    const Json json = Json::parse(text, nullptr, false);
    // One with a fault in its writing is still what it was meant to be.
    if (json.is_discarded())
        return text.find("\"entities\"") != std::string::npos &&
               text.find("\"sensors\"") != std::string::npos;
    return json.is_object() &&
           (json.contains("entities") || json.contains("sensors") || json.contains("dt_s"));
}

std::string scenarioToJson(const Scenario& scenario, const std::filesystem::path& file) {
    const JsonPaths paths(scenario.file.parent_path(),
                          std::filesystem::absolute(file).lexically_normal().parent_path());
    Json json = {{"version", scenarioFileVersion},
                 {"program", irsg::programWithVersion()},
                 {"dt_s", scenario.dt_s},
                 {"end_s", scenario.end_s}};
    writeText(json, "title", scenario.title);
    writeText(json, "notes", scenario.notes);
    if (scenario.start_s != 0.0)
        json["start_s"] = scenario.start_s;
    writeSettings(json, paths, scenario.settings);
    for (const ScenarioEntity& entity : scenario.entities)
        json["entities"].push_back(entityJson(entity, paths));
    for (const ScenarioSensor& sensor : scenario.sensors)
        json["sensors"].push_back(sensorJson(sensor, paths));
    return json.dump(2) + "\n";
}

void saveScenario(const Scenario& scenario, const std::filesystem::path& file) {
    writeTextFile(file, scenarioToJson(scenario, file));
}

} // namespace smat

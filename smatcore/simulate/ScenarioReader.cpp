#include "smatcore/simulate/ScenarioReader.h"

#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/core/AppendUnique.h"
#include "smatcore/project/JsonReading.h"
#include "smatcore/simulate/ScenarioFile.h"

namespace smat {

namespace {

using irsg::JsonReader;

constexpr double longest_s = 1e9;
constexpr const char* noHold = "a trajectory whose end is to be held";

/// Names stand in file names, and in the headers of tables.
bool isName(const std::string& name) {
    return isFileName(name) && name.find_first_of(",\"[]#") == std::string::npos;
}

void readTimes(Scenario& scenario, const JsonReader& root) {
    const JsonReader end = root.at("end_s");
    scenario.dt_s = root.at("dt_s").number({1e-6, longest_s});
    scenario.start_s = root.at("start_s").numberOr(0, {-longest_s, longest_s});
    scenario.end_s = end.number({-longest_s, longest_s});
    if (root.isAnyRefused())
        return;
    if (scenario.end_s < scenario.start_s)
        end.refuse(fmt::format("a time not before start_s, {} s", scenario.start_s));
    else if ((scenario.end_s - scenario.start_s) / scenario.dt_s >= mostSteps)
        end.refuse(fmt::format("less than {} steps of {} s", mostSteps, scenario.dt_s));
}

/// The objects of a list that must not be empty; `what` names one.
std::vector<JsonReader> objectsOf(const JsonReader& json, const char* what) {
    const std::string some = fmt::format("a list of at least one {}", what + 3);
    std::vector<JsonReader> objects = json.list(some);
    if (objects.empty() && json.json().is_array())
        json.refuse(some);
    std::erase_if(objects, [&](const JsonReader& one) { return !one.isObject(what); });
    return objects;
}

/// Refuses the members of these keys, because `reason`.
void refuseKeys(const JsonReader& json, std::initializer_list<const char*> keys,
                const std::string& reason) {
    for (const char* key : keys)
        json.refuseMember(key, reason);
}

Settings readScenarioSettings(const JsonReader& json) {
    for (const SettingInfo& setting : settingTable())
        if (!isScenarioSetting(setting))
            json.refuseMember(setting.section(),
                              "none in a scenario: sensors and entities say where they are and "
                              "what they do, and frames are all that is made");
    return readSettings(json, isScenarioSetting);
}

ScenarioEntity readEntity(const JsonReader& json) {
    ScenarioEntity entity;
    entity.name = json.at("name").textOr("");
    entity.model = json.at("model").filledText("the file of the model");
    entity.database = json.at("database").filledText("a signature database (.sigdb)");
    if (entity.name.empty())
        entity.name = entity.model.stem().string();
    entity.options = readModelOptions(json);
    entity.referencePoint_m = readPoint(json.at("referencePoint_m"));
    entity.fallbackTemperature = readEntryIndex(json.at("fallbackTemperature"));
    entity.fallbackMaterial = readEntryIndex(json.at("fallbackMaterial"));
    entity.timeOffset_s = json.at("timeOffset_s").numberOr(0, {-longest_s, longest_s});
    entity.power = json.at("power").numberIfAny({0, 1e6});
    entity.mach = json.at("mach").numberIfAny({0, 30});

    const bool moves = json.has("trajectory");
    if (moves == json.has("position_m")) {
        json.refuse(moves ? "both trajectory and position_m" : "no place",
                    "one of them: a CSV to follow, or a place to stand at");
    }
    if (moves) {
        entity.trajectory = json.at("trajectory").filledText("a trajectory (CSV)");
        entity.hold = json.at("hold").booleanOr(false);
        refuseKeys(json, {"position_m", "yaw_deg", "pitch_deg", "roll_deg"},
                   "no pose beside a trajectory");
    } else {
        entity.pose.position_m = readPoint(json.at("position_m")).value_or(irsg::Vec3{});
        entity.pose.attitude = readAttitude(json);
        refuseKeys(json, {"hold"}, noHold);
    }
    json.refuseUnknown();
    return entity;
}

void readMount(ScenarioSensor& sensor, const JsonReader& json) {
    const bool inWorld = json.has("position_m"), isCarried = json.has("carrier"),
               moves = json.has("trajectory");
    if (int{inWorld} + int{isCarried} + int{moves} != 1) {
        std::string found;
        for (const char* key : {"position_m", "carrier", "trajectory"})
            if (json.has(key))
                found += (found.empty() ? "" : " and ") + std::string(key);
        json.refuse(found.empty() ? "no place" : found,
                    "one of position_m, carrier and trajectory");
    }
    const auto position_m = readPoint(json.at("position_m"));
    sensor.carrier = json.at("carrier").textOr("");
    sensor.trajectory = json.at("trajectory").textOr("");
    sensor.mount = isCarried ? MountKind::entity : moves ? MountKind::trajectory : MountKind::world;
    if (inWorld) {
        sensor.offset.position_m = position_m.value_or(irsg::Vec3{});
        refuseKeys(json, {"offset_m"}, "no offset: position_m is the place");
    } else {
        sensor.offset.position_m = readPoint(json.at("offset_m")).value_or(irsg::Vec3{});
    }
    if (moves)
        sensor.hold = json.at("hold").booleanOr(false);
    else
        refuseKeys(json, {"hold"}, noHold);
}

ScenarioSensor readSensor(const JsonReader& json) {
    ScenarioSensor sensor;
    sensor.name = json.at("name").filledText("a name, which its folder gets");
    sensor.track = json.at("track").textOr("");
    sensor.imagingSensor = json.at("imagingSensor").textOr("");
    readMount(sensor, json);
    if (sensor.track.empty()) {
        sensor.offset.attitude = readAttitude(json);
    } else {
        refuseKeys(json, {"yaw_deg", "pitch_deg", "roll_deg"},
                   "no attitude: the sensor looks at what it tracks");
    }
    sensor.settings = readScenarioSettings(json);
    json.refuseUnknown();
    return sensor;
}

/// Refuses a name that no entity has.
void checkReference(const Scenario& scenario, const std::string& name, const JsonReader& json) {
    if (!name.empty() && !scenario.findEntity(name)) {
        std::string known;
        for (const ScenarioEntity& entity : scenario.entities)
            known += (known.empty() ? "" : ", ") + entity.name;
        json.refuse("the name of an entity: " + known);
    }
}

/// `entities` and `sensors` are those of the scenario, one for one.
void checkNames(const Scenario& scenario, const std::vector<JsonReader>& entities,
                const std::vector<JsonReader>& sensors) {
    std::set<std::string> names, folders;
    for (std::size_t i = 0; i < scenario.entities.size(); ++i) {
        const JsonReader json = entities[i].at("name");
        const std::string& name = scenario.entities[i].name;
        const std::string found = irsg::shownJson(name); // may be the model's
        if (!name.empty() && !isName(name))
            json.refuse(found, "a name without separators of files and tables");
        else if (!names.insert(name).second && !name.empty())
            json.refuse(found, "a name that no other entity has");
    }
    for (std::size_t i = 0; i < scenario.sensors.size(); ++i) {
        const ScenarioSensor& sensor = scenario.sensors[i];
        const JsonReader name = sensors[i].at("name"), track = sensors[i].at("track");
        if (!sensor.name.empty() && !isName(sensor.name))
            name.refuse("a name that a folder can have");
        else if (!folders.insert(sensor.name).second && !sensor.name.empty())
            name.refuse("a name that no other sensor has");
        checkReference(scenario, sensor.carrier, sensors[i].at("carrier"));
        checkReference(scenario, sensor.track, track);
        if (!sensor.track.empty() && sensor.track == sensor.carrier)
            track.refuse("another entity than its carrier");
    }
}

} // namespace

Scenario readScenario(const std::string& text, const std::string& file,
                      std::vector<std::string>* remarks) {
    const JsonReader root = readVersioned(text, file, "a scenario (JSON)", scenarioFileVersion,
                                          "version, dt_s, end_s, entities and sensors");
    Scenario scenario;
    scenario.title = root.at("title").textOr("");
    scenario.notes = root.at("notes").textOr("");
    readTimes(scenario, root);
    const auto entities =
        objectsOf(root.at("entities"), "an object with model, database and trajectory");
    for (const JsonReader& json : entities)
        scenario.entities.push_back(readEntity(json));
    const auto sensors = objectsOf(root.at("sensors"), "an object with name and place");
    for (const JsonReader& json : sensors)
        scenario.sensors.push_back(readSensor(json));
    scenario.settings = readScenarioSettings(root);
    root.refuseUnknown([](const std::string& path) { return settingsLike(path); });
    checkNames(scenario, entities, sensors);
    root.throwRefused();
    if (remarks != nullptr)
        irsg::appendUnique(*remarks, root.remarks());
    return scenario;
}

} // namespace smat

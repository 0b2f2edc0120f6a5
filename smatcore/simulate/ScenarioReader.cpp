#include "smatcore/simulate/ScenarioReader.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "smatcore/simulate/ScenarioFile.h"

namespace smat {

namespace {

constexpr double longest_s = 1e9;

bool isSection(const std::string& key) {
    return std::any_of(settingTable().begin(), settingTable().end(),
                       [&](const SettingInfo& setting) { return setting.section() == key; });
}

/// Names stand in file names, and in the headers of tables.
bool isName(const std::string& name) {
    return isFileName(name) && name.find_first_of(",\"[]#") == std::string::npos;
}

} // namespace

ScenarioReader::ScenarioReader(std::string fileName, const std::string& text)
    : JsonFields(std::move(fileName), text, "a scenario (JSON)") {}

Scenario ScenarioReader::read() {
    takeVersion(scenarioFileVersion, "version, dt_s, end_s, entities and sensors");
    Scenario scenario;
    scenario.title = takeText(root(), "title", "");
    scenario.notes = takeText(root(), "notes", "");
    readTimes(scenario);
    for (auto& [path, json] : takeList("entities", "an object with model, database and trajectory"))
        scenario.entities.push_back(readEntity(std::move(json), path));
    for (auto& [path, json] : takeList("sensors", "an object with name and place"))
        scenario.sensors.push_back(readSensor(std::move(json), path));
    scenario.settings = takeScenarioSettings(root(), "");
    refuseLeftOver(root(), "");
    checkNames(scenario);
    throwRefused();
    return scenario;
}

void ScenarioReader::readTimes(Scenario& scenario) {
    scenario.dt_s = requireNumber(root(), "dt_s", "", 1e-6, longest_s);
    scenario.start_s = takeNumber(root(), "start_s", "", -longest_s, longest_s);
    const Json given = root().contains("end_s") ? root()["end_s"] : Json();
    scenario.end_s = requireNumber(root(), "end_s", "", -longest_s, longest_s);
    if (isRefused())
        return;
    if (scenario.end_s < scenario.start_s)
        refuse("end_s", given, fmt::format("a time not before start_s, {} s", scenario.start_s));
    else if ((scenario.end_s - scenario.start_s) / scenario.dt_s >= mostSteps)
        refuse("end_s", given, fmt::format("less than {} steps of {} s", mostSteps, scenario.dt_s));
}

std::vector<std::pair<std::string, ScenarioReader::Json>>
ScenarioReader::takeList(const char* key, const char* what) {
    std::vector<std::pair<std::string, Json>> list;
    const auto found = root().find(key);
    if (found == root().end() || !found->is_array() || found->empty()) {
        refuse(key, found == root().end() ? "nothing" : shownJson(*found),
               fmt::format("a list of at least one {}", what + 3));
    } else {
        for (std::size_t i = 0; i < found->size(); ++i) {
            const std::string path = fmt::format("{}.{}", key, i);
            if ((*found)[i].is_object())
                list.emplace_back(path, (*found)[i]);
            else
                refuse(path, (*found)[i], what);
        }
    }
    root().erase(key);
    return list;
}

ScenarioEntity ScenarioReader::readEntity(Json json, const std::string& path) {
    ScenarioEntity entity;
    entity.name = takeText(json, "name", path);
    entity.model = requireText(json, "model", path, "the file of the model");
    entity.database = requireText(json, "database", path, "a signature database (.sigdb)");
    if (entity.name.empty())
        entity.name = entity.model.stem().string();
    entity.options = takeModelOptions(json, path);
    entity.referencePoint_m = takePoint(json, "referencePoint_m", path);
    entity.fallbackTemperature = takeIndex(json, "fallbackTemperature", path);
    entity.fallbackMaterial = takeIndex(json, "fallbackMaterial", path);
    entity.timeOffset_s = takeNumber(json, "timeOffset_s", path, -longest_s, longest_s);
    entity.power = takeOptional(json, "power", path, 0, 1e6);
    entity.mach = takeOptional(json, "mach", path, 0, 30);

    const bool moves = json.contains("trajectory");
    if (moves == json.contains("position_m")) {
        refuse(path, std::string(moves ? "both trajectory and position_m" : "no place"),
               "one of them: a CSV to follow, or a place to stand at");
    }
    if (moves) {
        entity.trajectory = requireText(json, "trajectory", path, "a trajectory (CSV)");
        entity.hold = takeBoolean(json, "hold", path);
        refuseKeys(json, {"position_m", "yaw_deg", "pitch_deg", "roll_deg"}, path,
                   "no pose beside a trajectory");
    } else {
        entity.pose.position_m = takePoint(json, "position_m", path).value_or(irsg::Vec3{});
        entity.pose.attitude = takeAttitude(json, path);
        refuseKeys(json, {"hold"}, path, "a trajectory whose end is to be held");
    }
    refuseLeftOver(json, path);
    return entity;
}

ScenarioSensor ScenarioReader::readSensor(Json json, const std::string& path) {
    ScenarioSensor sensor;
    sensor.name = requireText(json, "name", path, "a name, which its folder gets");
    sensor.track = takeText(json, "track", path);
    sensor.imagingSensor = takeText(json, "imagingSensor", path);
    readMount(sensor, json, path);
    if (sensor.track.empty()) {
        sensor.offset.attitude = takeAttitude(json, path);
    } else {
        refuseKeys(json, {"yaw_deg", "pitch_deg", "roll_deg"}, path,
                   "no attitude: the sensor looks at what it tracks");
    }
    sensor.settings = takeScenarioSettings(json, path);
    refuseLeftOver(json, path);
    return sensor;
}

void ScenarioReader::readMount(ScenarioSensor& sensor, Json& json, const std::string& path) {
    const bool inWorld = json.contains("position_m"), isCarried = json.contains("carrier"),
               moves = json.contains("trajectory");
    if (int{inWorld} + int{isCarried} + int{moves} != 1) {
        std::string found;
        for (const char* key : {"position_m", "carrier", "trajectory"})
            if (json.contains(key))
                found += (found.empty() ? "" : " and ") + std::string(key);
        refuse(path, found.empty() ? "no place" : found,
               "one of position_m, carrier and trajectory");
    }
    const auto position_m = takePoint(json, "position_m", path);
    sensor.carrier = takeText(json, "carrier", path);
    sensor.trajectory = takeText(json, "trajectory", path);
    sensor.mount = isCarried ? MountKind::entity : moves ? MountKind::trajectory : MountKind::world;
    if (inWorld) {
        sensor.offset.position_m = position_m.value_or(irsg::Vec3{});
        refuseKeys(json, {"offset_m"}, path, "no offset: position_m is the place");
    } else {
        sensor.offset.position_m = takePoint(json, "offset_m", path).value_or(irsg::Vec3{});
    }
    if (moves)
        sensor.hold = takeBoolean(json, "hold", path);
    else
        refuseKeys(json, {"hold"}, path, "a trajectory whose end is to be held");
}

void ScenarioReader::checkNames(const Scenario& scenario) {
    std::set<std::string> entities, sensors;
    for (std::size_t i = 0; i < scenario.entities.size(); ++i) {
        const std::string path = fmt::format("entities.{}.name", i);
        const std::string& name = scenario.entities[i].name;
        if (!name.empty() && !isName(name))
            refuse(path, Json(name), "a name without separators of files and tables");
        else if (!entities.insert(name).second && !name.empty())
            refuse(path, Json(name), "a name that no other entity has");
    }
    for (std::size_t i = 0; i < scenario.sensors.size(); ++i) {
        const ScenarioSensor& sensor = scenario.sensors[i];
        const std::string path = fmt::format("sensors.{}", i);
        if (!sensor.name.empty() && !isName(sensor.name))
            refuse(path + ".name", Json(sensor.name), "a name that a folder can have");
        else if (!sensors.insert(sensor.name).second && !sensor.name.empty())
            refuse(path + ".name", Json(sensor.name), "a name that no other sensor has");
        checkReference(scenario, sensor.carrier, path + ".carrier");
        checkReference(scenario, sensor.track, path + ".track");
        if (!sensor.track.empty() && sensor.track == sensor.carrier)
            refuse(path + ".track", Json(sensor.track), "another entity than its carrier");
    }
}

void ScenarioReader::checkReference(const Scenario& scenario, const std::string& name,
                                    const std::string& path) {
    if (!name.empty() && !scenario.findEntity(name)) {
        std::string known;
        for (const ScenarioEntity& entity : scenario.entities)
            known += (known.empty() ? "" : ", ") + entity.name;
        refuse(path, Json(name), "the name of an entity: " + known);
    }
}

double ScenarioReader::requireNumber(Json& json, const char* key, const std::string& path,
                                     double minimum, double maximum) {
    if (!json.contains(key)) {
        refuse(joinedKeyPath(path, key), std::string("nothing"),
               fmt::format("a number from {} to {}", minimum, maximum));
    }
    return takeNumber(json, key, path, minimum, maximum);
}

std::string ScenarioReader::requireText(Json& json, const char* key, const std::string& path,
                                        const char* what) {
    const bool isText = json.contains(key) && json[key].is_string();
    const bool isMissing = !json.contains(key);
    const std::string text = takeText(json, key, path);
    if (isMissing || (isText && text.empty()))
        refuse(joinedKeyPath(path, key), std::string("nothing"), what);
    return text;
}

std::optional<double> ScenarioReader::takeOptional(Json& json, const char* key,
                                                   const std::string& path, double minimum,
                                                   double maximum) {
    if (!json.contains(key))
        return std::nullopt;
    return takeNumber(json, key, path, minimum, maximum);
}

Settings ScenarioReader::takeScenarioSettings(Json& json, const std::string& path) {
    for (const SettingInfo& setting : settingTable()) {
        if (!isScenarioSetting(setting)) {
            refuseKeys(json, {setting.section()}, path,
                       "none in a scenario: sensors and entities say where they are and what they "
                       "do, and frames are all that is made");
        }
    }
    return takeSettings(json, path);
}

void ScenarioReader::refuseKeys(Json& json, const std::vector<std::string>& keys,
                                const std::string& path, const std::string& reason) {
    for (const std::string& key : keys) {
        const auto found = json.find(key);
        if (found != json.end()) {
            refuse(joinedKeyPath(path, key), *found, reason);
            json.erase(found);
        }
    }
}

void ScenarioReader::refuseLeftOver(const Json& json, const std::string& path) {
    for (const auto& [key, value] : json.items()) {
        const std::string place = joinedKeyPath(path, key);
        // What is left of a section of settings are the keys in it that are not known.
        if (value.is_object() && isSection(key))
            refuseLeftOver(value, place);
        else
            refuse(place, value, "no such key: it is not known to this version");
    }
}

} // namespace smat

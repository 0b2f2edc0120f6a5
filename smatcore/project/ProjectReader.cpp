#include "smatcore/project/ProjectReader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "irsg/radiometry/Units.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/support/JsonText.h"

namespace smat {

namespace {

using Json = nlohmann::json;

constexpr double farthest_m = 1e9;

std::string shown(const Json& value) {
    std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > 80) {
        text = text.substr(0, 77) + "...";
    }
    return text;
}

/// What is left of an object after everything known was taken out; "" where nothing is.
std::string leftOver(const Json& json) {
    return json.empty() ? "" : json.dump();
}

bool isFileName(const std::string& name) {
    return !name.empty() && name.front() != '.' && name.find_first_of("/\\\n\r\t") == name.npos;
}

} // namespace

const std::vector<std::string>& noseAxisNames() {
    static const std::vector<std::string> names = {"+x", "-x", "+y", "-y"};
    return names;
}

ProjectReader::ProjectReader(std::string fileName, const std::string& text)
    : fileName_(std::move(fileName)),
      json_(parseJsonText<Json>(text, fileName_, "a project file (JSON)")),
      lines_(text) {}

Project ProjectReader::read() {
    if (!json_.is_object()) {
        refuse("", json_, "an object with version, models, settings and analyses");
        throw irsg::InputError(offences_);
    }
    // A newer file may mean other things by the same keys: nothing else in it is judged.
    readVersion();
    if (!offences_.empty()) {
        throw irsg::InputError(offences_);
    }
    for (const auto& [path, line] : lines_.duplicates()) {
        offences_.push_back({.file = fileName_,
                             .position = fmt::format("{}, line {}", path, line),
                             .value = "a key that occurs twice",
                             .expected = "every key once"});
    }

    Project project;
    project.title = takeText(json_, "title", "");
    project.notes = takeText(json_, "notes", "");
    readModels(project);
    readAnalyses(project);
    project.settings = readSettings(json_, "");
    project.unknownKeys = leftOver(json_);
    if (!offences_.empty()) {
        throw irsg::InputError(offences_);
    }
    return project;
}

void ProjectReader::readVersion() {
    const auto found = json_.find("version");
    const std::string expected = fmt::format("version {}", projectFileVersion);
    if (found == json_.end()) {
        refuse("version", std::string("nothing"), expected);
    } else if (!found->is_number_integer() || found->get<double>() < 1) {
        refuse("version", *found, expected);
    } else if (found->get<double>() > projectFileVersion) {
        refuse("version", *found, expected + " or older: the file was written by a newer program");
    }
    json_.erase("version");
}

void ProjectReader::readModels(Project& project) {
    const auto found = json_.find("models");
    if (found == json_.end()) {
        return;
    }
    if (!found->is_array()) {
        refuse("models", *found, "a list of models");
    } else {
        for (std::size_t i = 0; i < found->size(); ++i) {
            const std::string path = fmt::format("models.{}", i);
            if (!(*found)[i].is_object()) {
                refuse(path, (*found)[i], "an object with file and database");
                continue;
            }
            if (i == 0) {
                readTargetPose((*found)[i], path);
            }
            project.models.push_back(readModel((*found)[i], path));
        }
    }
    json_.erase("models");
}

void ProjectReader::readTargetPose(const Json& json, const std::string& path) {
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
    if (!hasFile || (model.file.empty() && given["file"].is_string())) {
        refuse(joinedKeyPath(path, "file"), std::string("nothing"), "the file of the model");
    }
    model.database = takeText(json, "database", path);
    model.noseAxis = takeNoseAxis(json, path);
    model.forceTwoSided = takeBoolean(json, "twoSided", path);
    if (const auto position = takePoint(json, "position_m", path)) {
        model.pose.position_m = *position;
    }
    model.pose.attitude = {irsg::radians(takeNumber(json, "yaw_deg", path, -360, 360)),
                           irsg::radians(takeNumber(json, "pitch_deg", path, -90, 90)),
                           irsg::radians(takeNumber(json, "roll_deg", path, -180, 180))};
    model.referencePoint_m = takePoint(json, "referencePoint_m", path);
    model.fallbackTemperature = takeIndex(json, "fallbackTemperature", path);
    model.fallbackMaterial = takeIndex(json, "fallbackMaterial", path);
    model.unknownKeys = leftOver(json);
    return model;
}

void ProjectReader::readAnalyses(Project& project) {
    const auto found = json_.find("analyses");
    if (found == json_.end()) {
        return;
    }
    if (!found->is_object()) {
        refuse("analyses", *found, "an object of analyses by name");
    } else {
        // Objects of this library are sorted by key, which is the order of Project::analyses.
        for (const auto& [name, json] : found->items()) {
            const std::string path = "analyses." + name;
            if (!isFileName(name)) {
                refuse(path, Json(name), "a name that can be a file name");
            }
            if (!json.is_object()) {
                refuse(path, json, "an object with the kind of the analysis");
                continue;
            }
            project.analyses.push_back(readAnalysis(name, json, path));
        }
    }
    json_.erase("analyses");
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
               given.contains("kind") ? shown(given["kind"]) : "nothing",
               "image, spectrum, polar, time or range");
    }
    analysis.kind = kind.value_or(AnalysisKind::image);
    analysis.notes = takeText(json, "notes", path);
    analysis.settings = readSettings(json, path);
    analysis.unknownKeys = leftOver(json);
    return analysis;
}

Settings ProjectReader::readSettings(Json& json, const std::string& path) {
    Settings settings;
    for (const SettingInfo& setting : settingTable()) {
        const std::string section = setting.section();
        const auto found = json.find(section);
        if (found == json.end()) {
            continue;
        }
        if (!found->is_object()) {
            refuse(joinedKeyPath(path, section), *found, "an object of settings");
            json.erase(section);
            continue;
        }
        const std::string name = setting.key.substr(section.size() + 1);
        if (found->contains(name)) {
            readSetting(settings, setting.key, (*found)[name], joinedKeyPath(path, setting.key));
            found->erase(name);
        }
        if (found->empty()) {
            json.erase(section);
        }
    }
    return settings;
}

void ProjectReader::readSetting(Settings& settings, const std::string& key, const Json& value,
                                const std::string& path) {
    const SettingInfo& setting = settingInfo(key);
    const bool takesNumber = setting.kind == SettingKind::real ||
                             setting.kind == SettingKind::integer ||
                             setting.kind == SettingKind::choiceOrReal;
    const bool takesText =
        setting.kind != SettingKind::real && setting.kind != SettingKind::integer &&
        setting.kind != SettingKind::boolean && setting.kind != SettingKind::pathList;

    // Each kind has one JSON type; its text is then judged like that of the command line.
    std::optional<std::string> text;
    if ((takesNumber && value.is_number()) ||
        (setting.kind == SettingKind::boolean && value.is_boolean())) {
        text = value.dump();
    } else if (takesText && value.is_string()) {
        text = value.get<std::string>();
        if (setting.kind == SettingKind::choiceOrReal &&
            std::find(setting.choices.begin(), setting.choices.end(), *text) ==
                setting.choices.end()) {
            text.reset(); // a number in quotes
        }
    } else if (setting.kind == SettingKind::pathList && value.is_array()) {
        text = "";
        for (const Json& item : value) {
            const bool isName = item.is_string() && !item.get<std::string>().empty() &&
                                item.get<std::string>().find(';') == std::string::npos;
            if (!isName) {
                text.reset();
                break;
            }
            *text += (text->empty() ? "" : ";") + item.get<std::string>();
        }
    }
    if (!text || !canonicalText(setting, *text)) {
        refuse(path, value,
               setting.kind == SettingKind::pathList ? "a list of file names" : setting.expected());
        return;
    }
    settings.set(key, *text);
}

std::string ProjectReader::takeText(Json& json, const char* key, const std::string& path) {
    const auto found = json.find(key);
    if (found == json.end()) {
        return "";
    }
    std::string text;
    if (found->is_string()) {
        text = found->get<std::string>();
    } else {
        refuse(joinedKeyPath(path, key), *found, "a text");
    }
    json.erase(key);
    return text;
}

bool ProjectReader::takeBoolean(Json& json, const char* key, const std::string& path) {
    const auto found = json.find(key);
    if (found == json.end()) {
        return false;
    }
    bool value = false;
    if (found->is_boolean()) {
        value = found->get<bool>();
    } else {
        refuse(joinedKeyPath(path, key), *found, "true or false");
    }
    json.erase(key);
    return value;
}

double ProjectReader::takeNumber(Json& json, const char* key, const std::string& path,
                                 double minimum, double maximum) {
    const auto found = json.find(key);
    if (found == json.end()) {
        return 0.0;
    }
    double value = 0.0;
    if (found->is_number() && found->get<double>() >= minimum && found->get<double>() <= maximum) {
        value = found->get<double>();
    } else {
        refuse(joinedKeyPath(path, key), *found,
               fmt::format("a number from {} to {}", minimum, maximum));
    }
    json.erase(key);
    return value;
}

std::optional<irsg::Vec3> ProjectReader::takePoint(Json& json, const char* key,
                                                   const std::string& path) {
    const auto found = json.find(key);
    if (found == json.end()) {
        return std::nullopt;
    }
    std::optional<irsg::Vec3> point;
    const bool isPoint =
        found->is_array() && found->size() == 3 &&
        std::all_of(found->begin(), found->end(), [](const Json& value) {
            return value.is_number() && std::abs(value.get<double>()) <= farthest_m;
        });
    if (isPoint) {
        point = irsg::Vec3{(*found)[0].get<double>(), (*found)[1].get<double>(),
                           (*found)[2].get<double>()};
    } else {
        refuse(joinedKeyPath(path, key), *found, "three numbers [x, y, z] in m, each up to 1e9");
    }
    json.erase(key);
    return point;
}

std::optional<int> ProjectReader::takeIndex(Json& json, const char* key, const std::string& path) {
    const auto found = json.find(key);
    if (found == json.end()) {
        return std::nullopt;
    }
    std::optional<int> index;
    if (found->is_number_integer() && std::abs(found->get<double>()) <= 2147483647.0) {
        index = found->get<int>();
    } else {
        refuse(joinedKeyPath(path, key), *found, "the index of an entry, a whole number");
    }
    json.erase(key);
    return index;
}

irsg::NoseAxis ProjectReader::takeNoseAxis(Json& json, const std::string& path) {
    const auto found = json.find("noseAxis");
    if (found == json.end()) {
        return irsg::NoseAxis::plusY;
    }
    const Json value = *found;
    json.erase("noseAxis");
    const auto& names = noseAxisNames();
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (value == names[i]) {
            return static_cast<irsg::NoseAxis>(i);
        }
    }
    refuse(joinedKeyPath(path, "noseAxis"), value, "+x, -x, +y or -y");
    return irsg::NoseAxis::plusY;
}

void ProjectReader::refuse(const std::string& path, const std::string& value,
                           const std::string& expected) {
    const int line = lines_.line(path);
    offences_.push_back(
        {.file = fileName_,
         .position = line > 0 && !path.empty() ? fmt::format("{}, line {}", path, line) : path,
         .value = value,
         .expected = expected});
}

void ProjectReader::refuse(const std::string& path, const Json& value,
                           const std::string& expected) {
    refuse(path, shown(value), expected);
}

} // namespace smat

#include "smatcore/project/JsonFields.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "irsg/radiometry/Units.h"
#include "smatcore/project/Project.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

using Json = nlohmann::json;

constexpr double farthest_m = 1e9;

} // namespace

bool isFileName(const std::string& name) {
    return !name.empty() && name.front() != '.' && name.find_first_of("/\\\n\r\t") == name.npos;
}

const std::vector<std::string>& modelOriginNames() {
    static const std::vector<std::string> names = {"file", "centre", "base"};
    return names;
}

JsonFields::JsonFields(std::string fileName, const std::string& text, const std::string& kind)
    : fileName_(std::move(fileName)),
      json_(irsg::parseJson(text, fileName_, {.expected = kind})),
      places_(text) {}

void JsonFields::takeVersion(int newest, const std::string& parts) {
    if (!json_.is_object()) {
        refuse("", json_, "an object with " + parts);
        throwRefused();
    }
    const auto found = json_.find("version");
    const std::string expected = fmt::format("version {}", newest);
    if (found == json_.end())
        refuse("version", std::string("nothing"), expected);
    else if (!found->is_number_integer() || found->get<double>() < 1)
        refuse("version", *found, expected);
    else if (found->get<double>() > newest)
        refuse("version", *found, expected + " or older: the file was written by a newer program");
    throwRefused();
    json_.erase("version");
}

void JsonFields::throwRefused() const {
    if (!diagnostics_.empty())
        throw irsg::InputError(diagnostics_);
}

Settings JsonFields::takeSettings(Json& json, const std::string& path) {
    Settings settings;
    for (const SettingInfo& setting : settingTable()) {
        const std::string section = setting.section();
        const auto found = json.find(section);
        if (found == json.end())
            continue;
        if (!found->is_object()) {
            refuse(joinedKeyPath(path, section), *found, "an object of settings");
            json.erase(section);
            continue;
        }
        const std::string name = setting.key.substr(section.size() + 1);
        if (found->contains(name)) {
            takeSetting(settings, setting.key, (*found)[name], joinedKeyPath(path, setting.key));
            found->erase(name);
        }
        if (found->empty())
            json.erase(section);
    }
    return settings;
}

void JsonFields::takeSetting(Settings& settings, const std::string& key, const Json& value,
                             const std::string& path) {
    const SettingInfo& setting = settingInfo(key);
    const bool takesNumber =
        setting.kind == SettingKind::real || setting.kind == SettingKind::integer ||
        setting.kind == SettingKind::choiceOrReal || setting.kind == SettingKind::realList;
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
    } else if (value.is_array() &&
               (setting.kind == SettingKind::band || setting.kind == SettingKind::realList)) {
        const bool isNumbers = setting.kind == SettingKind::realList;
        text = "";
        for (const Json& item : value) {
            if (isNumbers ? !item.is_number() : !item.is_string()) {
                text.reset();
                break;
            }
            *text += text->empty() ? "" : ",";
            *text += isNumbers ? item.dump() : item.get<std::string>();
        }
    } else if (key == key::sensorResponse && value.is_string()) {
        text = value.get<std::string>(); // one file, as a word of its own
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

std::string JsonFields::takeText(Json& json, const char* key, const std::string& path) {
    const auto found = json.find(key);
    if (found == json.end())
        return "";
    std::string text;
    if (found->is_string())
        text = found->get<std::string>();
    else
        refuse(joinedKeyPath(path, key), *found, "a text");
    json.erase(key);
    return text;
}

bool JsonFields::takeBoolean(Json& json, const char* key, const std::string& path) {
    const auto found = json.find(key);
    if (found == json.end())
        return false;
    bool value = false;
    if (found->is_boolean())
        value = found->get<bool>();
    else
        refuse(joinedKeyPath(path, key), *found, "true or false");
    json.erase(key);
    return value;
}

double JsonFields::takeNumber(Json& json, const char* key, const std::string& path, double minimum,
                              double maximum) {
    const auto found = json.find(key);
    if (found == json.end())
        return 0.0;
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

std::optional<irsg::Vec3> JsonFields::takePoint(Json& json, const char* key,
                                                const std::string& path) {
    const auto found = json.find(key);
    if (found == json.end())
        return std::nullopt;
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

irsg::Attitude JsonFields::takeAttitude(Json& json, const std::string& path) {
    return {irsg::radians(takeNumber(json, "yaw_deg", path, -360, 360)),
            irsg::radians(takeNumber(json, "pitch_deg", path, -90, 90)),
            irsg::radians(takeNumber(json, "roll_deg", path, -180, 180))};
}

std::optional<int> JsonFields::takeIndex(Json& json, const char* key, const std::string& path) {
    const auto found = json.find(key);
    if (found == json.end())
        return std::nullopt;
    std::optional<int> index;
    if (found->is_number_integer() && std::abs(found->get<double>()) <= 2147483647.0)
        index = found->get<int>();
    else
        refuse(joinedKeyPath(path, key), *found, "the index of an entry, a whole number");
    json.erase(key);
    return index;
}

std::optional<irsg::ModelAxis> JsonFields::takeAxis(Json& json, const char* key,
                                                    const std::string& path) {
    const auto found = json.find(key);
    if (found == json.end())
        return std::nullopt;
    const Json value = *found;
    json.erase(key);
    const auto& names = irsg::modelAxisNames();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (value == names[i])
            return static_cast<irsg::ModelAxis>(i);
    refuse(joinedKeyPath(path, key), value, "+x, -x, +y, -y, +z or -z");
    return std::nullopt;
}

std::optional<irsg::ModelOrigin> JsonFields::takeOrigin(Json& json, const std::string& path) {
    const auto found = json.find("origin");
    if (found == json.end())
        return std::nullopt;
    if (found->is_array()) {
        const auto point = takePoint(json, "origin", path);
        return point ? std::optional(irsg::ModelOrigin{irsg::ModelOrigin::At::point, *point})
                     : std::nullopt;
    }
    const Json value = *found;
    json.erase("origin");
    const auto& names = modelOriginNames();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (value == names[i])
            return irsg::ModelOrigin{static_cast<irsg::ModelOrigin::At>(i), {}};
    refuse(joinedKeyPath(path, "origin"), value,
           "file, centre, base or three numbers [x, y, z] in the unit of the file");
    return std::nullopt;
}

irsg::ModelOptions JsonFields::takeModelOptions(Json& json, const std::string& path) {
    irsg::ModelOptions options;
    options.placing.up = takeAxis(json, "upAxis", path);
    options.placing.nose = takeAxis(json, "noseAxis", path);
    if (json.contains("unit_m"))
        options.placing.unit_m =
            takeNumber(json, "unit_m", path, leastModelUnit_m, mostModelUnit_m);
    options.placing.origin = takeOrigin(json, path);
    options.forceTwoSided = takeBoolean(json, "twoSided", path);
    options.cutsTextureAlpha = takeBoolean(json, "cutTextureAlpha", path);
    return options;
}

void JsonFields::refuse(const std::string& path, const std::string& value,
                        const std::string& expected) {
    diagnostics_.push_back({.file = fileName_,
                            .position = places_.position(path),
                            .value = value,
                            .expected = expected});
}

void JsonFields::refuse(const std::string& path, const Json& value, const std::string& expected) {
    refuse(path, shownJson(value), expected);
}

} // namespace smat

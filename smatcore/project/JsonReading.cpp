#include "smatcore/project/JsonReading.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/radiometry/Units.h"
#include "smatcore/project/Project.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

using irsg::JsonReader;
using Json = nlohmann::json;

constexpr double farthest_m = 1e9;

/// `called`: its key in the file.
void readSetting(Settings& settings, const SettingInfo& setting, const std::string& called,
                 const JsonReader& reader) {
    const Json& value = reader.json();
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
    } else if (setting.key == key::sensorResponse && value.is_string()) {
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
        reader.refuse(setting.kind == SettingKind::pathList ? "a list of file names"
                      : value.is_string() ? setting.expectedInsteadOf(value.get<std::string>())
                                          : setting.expected());
        return;
    }
    for (const std::string& remark : formerNameRemarks(called, *text))
        reader.remark(remark);
    settings.set(setting.key, *text);
}

std::optional<irsg::ModelAxis> readAxis(const JsonReader& json) {
    return json.exists()
               ? std::optional(static_cast<irsg::ModelAxis>(json.word(irsg::modelAxisNames())))
               : std::nullopt;
}

std::optional<irsg::ModelOrigin> readOrigin(const JsonReader& json) {
    if (!json.exists())
        return std::nullopt;
    if (json.json().is_array()) {
        const auto point = readPoint(json);
        return point ? std::optional(irsg::ModelOrigin{irsg::ModelOrigin::At::point, *point})
                     : std::nullopt;
    }
    const auto& names = modelOriginNames();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (json.json() == names[i])
            return irsg::ModelOrigin{static_cast<irsg::ModelOrigin::At>(i), {}};
    json.refuse("file, centre, base or three numbers [x, y, z] in the unit of the file");
    return std::nullopt;
}

} // namespace

bool isFileName(const std::string& name) {
    return !name.empty() && name.front() != '.' && name.find_first_of("/\\\n\r\t") == name.npos;
}

const std::vector<std::string>& modelOriginNames() {
    static const std::vector<std::string> names = {"file", "centre", "base"};
    return names;
}

JsonReader readVersioned(const std::string& text, const std::string& file, const char* kind,
                         int newest, const char* parts) {
    JsonReader root(text, file, {.expected = kind}, irsg::JsonErrors::collect);
    if (!root.isObject(fmt::format("an object with {}", parts)))
        root.throwRefused();
    const JsonReader version = root.at("version");
    const std::string expected = fmt::format("version {}", newest);
    const bool isVersion =
        version.json().is_number_integer() && version.json().get<double>() >= 1.0;
    if (!isVersion)
        version.refuse(expected);
    else if (version.json().get<double>() > newest)
        version.refuse(expected + " or older: the file was written by a newer program");
    root.throwRefused();
    root.at("program");
    return root;
}

Settings readSettings(const JsonReader& json, bool (*isAllowed)(const SettingInfo& setting)) {
    Settings settings;
    std::map<std::string, JsonReader> sections;
    for (const SettingInfo& setting : settingTable()) {
        if (isAllowed && !isAllowed(setting))
            continue;
        const std::string name = setting.section();
        const JsonReader& section = sections.try_emplace(name, json.section(name)).first->second;
        if (!section.exists() || !section.isObject("an object of settings"))
            continue;
        const auto nameIn = [&](const std::string& key) { return key.substr(name.size() + 1); };
        const JsonReader value = section.at(nameIn(setting.key));
        if (value.exists())
            readSetting(settings, setting, setting.key, value);
        for (const std::string& former : setting.former.keys) {
            if (!section.has(nameIn(former)))
                continue;
            const JsonReader old = section.at(nameIn(former));
            if (settings.isSet(setting.key))
                old.refuse("nothing beside " + setting.key + ", as it is called now");
            else
                readSetting(settings, setting, former, old);
        }
    }
    return settings;
}

std::optional<irsg::Vec3> readPoint(const JsonReader& json) {
    if (!json.exists())
        return std::nullopt;
    const auto point = json.numbers(3, farthest_m, "three numbers [x, y, z] in m, each up to 1e9");
    return point ? std::optional(irsg::Vec3{(*point)[0], (*point)[1], (*point)[2]}) : std::nullopt;
}

irsg::Attitude readAttitude(const JsonReader& json) {
    return {irsg::radians(json.at("yaw_deg").numberOr(0, {-360, 360})),
            irsg::radians(json.at("pitch_deg").numberOr(0, {-90, 90})),
            irsg::radians(json.at("roll_deg").numberOr(0, {-180, 180}))};
}

std::optional<int> readEntryIndex(const JsonReader& json) {
    return json.indexIfAny("the index of an entry, a whole number");
}

irsg::ModelOptions readModelOptions(const JsonReader& json) {
    irsg::ModelOptions options;
    options.placing.up = readAxis(json.at("upAxis"));
    options.placing.nose = readAxis(json.at("noseAxis"));
    options.placing.unit_m = json.at("unit_m").numberIfAny({leastModelUnit_m, mostModelUnit_m});
    options.placing.origin = readOrigin(json.at("origin"));
    options.forceTwoSided = json.at("twoSided").booleanOr(false);
    options.cutsTextureAlpha = json.at("cutTextureAlpha").booleanOr(false);
    return options;
}

} // namespace smat

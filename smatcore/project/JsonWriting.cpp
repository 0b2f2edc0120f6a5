#include "smatcore/project/JsonWriting.h"

#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/JsonReading.h"

namespace smat {

namespace {

using Json = nlohmann::json;

Json settingJson(const JsonPaths& paths, const SettingInfo& setting, const Settings& settings) {
    const std::string& text = settings.text(setting.key);
    switch (setting.kind) {
    case SettingKind::integer:
        return settings[IntegerKey{setting.key.c_str()}];
    case SettingKind::real:
        return settings[RealKey{setting.key.c_str()}];
    case SettingKind::boolean:
        return settings[BooleanKey{setting.key.c_str()}];
    case SettingKind::choiceOrReal: {
        const std::optional<double> number = settings[OptionalRealKey{setting.key.c_str()}];
        return number ? Json(*number) : Json(text);
    }
    case SettingKind::realList: {
        const std::vector<double> numbers = settings[RealListKey{setting.key.c_str()}];
        return numbers.empty() ? Json(text) : Json(numbers);
    }
    case SettingKind::path:
        return paths.text(text);
    case SettingKind::pathList: {
        Json list = Json::array();
        for (const std::filesystem::path& path : settings[PathsKey{setting.key.c_str()}])
            list.push_back(paths.text(path));
        // One response is a word, as programs read it that know no lists of them.
        return setting.key == key::sensorResponse && list.size() < 2
                   ? Json(list.empty() ? "" : list.front().get<std::string>())
                   : list;
    }
    case SettingKind::choice:
    case SettingKind::band:
        return text;
    }
    throw irsg::LogicError("unknown kind of setting");
}

void writeAngle(Json& json, const char* key, double angle_rad) {
    // Degrees come back from radians with an error of rounding, which nobody meant to write.
    const double angle_deg = std::round(irsg::degrees(angle_rad) * 1e10) / 1e10;
    if (angle_deg != 0.0)
        json[key] = angle_deg;
}

} // namespace

JsonPaths::JsonPaths(std::filesystem::path from, std::filesystem::path folder)
    : from_(std::move(from)), folder_(std::move(folder)) {}

std::string JsonPaths::text(const std::filesystem::path& path) const {
    if (path.empty())
        return "";
    const std::filesystem::path absolute =
        std::filesystem::absolute(from_ / path).lexically_normal();
    const std::filesystem::path relative = absolute.lexically_relative(folder_);
    const bool isFar = relative.empty() || relative.string().starts_with("../..");
    return (isFar && !path.is_relative() ? absolute : relative).generic_string();
}

void writeSettings(Json& json, const JsonPaths& paths, const Settings& settings) {
    for (const auto& [key, text] : settings.values()) {
        const SettingInfo& setting = settingInfo(key);
        const std::string section = setting.section();
        json[section][setting.key.substr(section.size() + 1)] =
            settingJson(paths, setting, settings);
    }
}

void writeSettings(Json& json, const JsonPaths& paths, const Settings& settings,
                   const Settings& under) {
    Settings written;
    for (const auto& [key, text] : settings.values())
        if (text != under.text(key))
            written.set(key, text);
    writeSettings(json, paths, written);
}

void writeModelOptions(Json& json, const irsg::ModelOptions& options) {
    const auto writeAxis = [&](const char* key, const std::optional<irsg::ModelAxis>& axis) {
        if (axis)
            json[key] = irsg::modelAxisNames()[static_cast<std::size_t>(*axis)];
    };
    writeAxis("upAxis", options.placing.up);
    writeAxis("noseAxis", options.placing.nose);
    if (options.placing.unit_m)
        json["unit_m"] = *options.placing.unit_m;
    if (const auto& origin = options.placing.origin)
        json["origin"] = origin->at == irsg::ModelOrigin::At::point
                             ? pointJson(origin->point)
                             : Json(modelOriginNames()[static_cast<std::size_t>(origin->at)]);
    if (options.forceTwoSided)
        json["twoSided"] = true;
    if (options.cutsTextureAlpha)
        json["cutTextureAlpha"] = true;
}

Json pointJson(const irsg::Vec3& point) {
    return {point.x, point.y, point.z};
}

void writeAttitude(Json& json, const irsg::Attitude& attitude) {
    writeAngle(json, "yaw_deg", attitude.yaw_rad);
    writeAngle(json, "pitch_deg", attitude.pitch_rad);
    writeAngle(json, "roll_deg", attitude.roll_rad);
}

} // namespace smat

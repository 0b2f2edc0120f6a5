#include "smatcore/analysis/SettingWords.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "irsg/image/AxisTicks.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

/// "900 m", "12°", "8-12 µm".
std::string withUnit(const std::string& value, const std::string& unit) {
    if (unit.empty())
        return value;
    if (unit == "deg")
        return value + "°";
    return value + " " + (unit == "um" ? "µm" : irsg::prettyUnit(unit));
}

/// "a;b/c.xml" -> "a + c".
std::string stems(const std::string& files) {
    std::string names;
    std::size_t from = 0;
    while (from <= files.size()) {
        const std::size_t to = std::min(files.find(';', from), files.size());
        const std::string stem = std::filesystem::path(files.substr(from, to - from)).stem();
        names += (names.empty() ? "" : " + ") + stem;
        from = to + 1;
    }
    return names;
}

std::string bandWords(const std::string& text) {
    std::string bands = text;
    for (std::size_t at = 0; (at = bands.find(',', at)) != std::string::npos; at += 6)
        bands.replace(at, 1, " µm, ");
    return bands + " µm";
}

/// The word of a setting that needs its section to be understood, or another than its label.
std::string labelOf(const SettingInfo& info) {
    if (info.key == key::stateTime)
        return "time";
    std::string label = info.label;
    const bool isShort =
        label.size() > 1 && std::isupper(static_cast<unsigned char>(label[1])) != 0;
    if (!isShort)
        label[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(label[0])));
    return label;
}

} // namespace

std::string valueWords(const Settings& settings, std::string_view key) {
    const SettingInfo& info = settingInfo(key);
    const std::string& text = settings.text(key);
    if (info.kind == SettingKind::band)
        return bandWords(text);
    const bool isFile = info.kind == SettingKind::path || info.kind == SettingKind::pathList;
    if (isFile && (text.empty() || text == "none"))
        return info.key == key::environmentAtmospheres ? "vacuum" : "none";
    if (isFile)
        return stems(text);
    if (info.kind == SettingKind::boolean)
        return text == "true" ? "on" : "off";
    return withUnit(text, info.unit);
}

std::string settingWords(const Settings& settings, std::string_view key) {
    const SettingInfo& info = settingInfo(key);
    const bool speaksForItself = info.kind == SettingKind::band ||
                                 info.key == key::environmentAtmospheres ||
                                 info.key == key::sensorResponse;
    const std::string value = valueWords(settings, key);
    return speaksForItself ? value : labelOf(info) + " " + value;
}

} // namespace smat

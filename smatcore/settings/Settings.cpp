#include "smatcore/settings/Settings.h"

#include <algorithm>

#include <fmt/format.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"

namespace smat {

namespace {

const SettingInfo& requireKind(std::string_view key, std::initializer_list<SettingKind> kinds) {
    const SettingInfo& setting = settingInfo(key);
    for (const SettingKind kind : kinds)
        if (setting.kind == kind)
            return setting;
    throw irsg::LogicError("setting " + setting.key + " is of another kind than asked for");
}

double parsed(const std::string& canonical) {
    return irsg::parseNumber(canonical).value();
}

} // namespace

void Settings::set(std::string_view key, std::string_view text, const std::string& file) {
    const SettingInfo* setting = findSetting(key);
    if (setting == nullptr) {
        throw irsg::InputError({.file = file,
                                .position = std::string(key),
                                .value = std::string(text),
                                .expected = expectedSetting(key)});
    }
    const std::optional<std::string> canonical = canonicalText(*setting, text);
    if (!canonical) {
        throw irsg::InputError({.file = file,
                                .position = setting->key,
                                .value = std::string(text),
                                .expected = setting->expectedInsteadOf(text)});
    }
    values_[setting->key] = *canonical;
}

void Settings::set(std::string_view key, double value) {
    set(key, fmt::format("{}", value));
}

void Settings::set(std::string_view key, int value) {
    set(key, fmt::format("{}", value));
}

void Settings::setFromArgument(std::string_view argument) {
    const std::size_t equals = argument.find('=');
    if (equals == std::string_view::npos) {
        throw irsg::InputError({.file = "--set",
                                .position = "",
                                .value = std::string(argument),
                                .expected = "key=value, such as sensor.width=320"});
    }
    set(irsg::trimmed(argument.substr(0, equals)), argument.substr(equals + 1), "--set");
}

void Settings::reset(std::string_view key) {
    const auto found = values_.find(settingInfo(key).key);
    if (found != values_.end())
        values_.erase(found);
}

const std::string& Settings::text(std::string_view key) const {
    const auto found = values_.find(key);
    return found != values_.end() ? found->second : settingInfo(key).defaultText;
}

double Settings::operator[](RealKey key) const {
    requireKind(key, {SettingKind::real, SettingKind::integer});
    return parsed(text(key));
}

int Settings::operator[](IntegerKey key) const {
    requireKind(key, {SettingKind::integer});
    return static_cast<int>(parsed(text(key)));
}

bool Settings::operator[](BooleanKey key) const {
    requireKind(key, {SettingKind::boolean});
    return text(key) == "true";
}

std::optional<double> Settings::operator[](OptionalRealKey key) const {
    requireKind(key, {SettingKind::choiceOrReal});
    return irsg::parseNumber(text(key));
}

std::vector<double> Settings::operator[](RealListKey key) const {
    const SettingInfo& setting = requireKind(key, {SettingKind::realList});
    const std::string& list = text(key);
    if (std::ranges::find(setting.choices, list) != setting.choices.end())
        return {};
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        numbers.push_back(parsed(list.substr(begin, end - begin)));
        begin = end + 1;
    }
    return numbers;
}

std::vector<std::filesystem::path> Settings::operator[](PathsKey key) const {
    const SettingInfo& setting = requireKind(key, {SettingKind::path, SettingKind::pathList});
    const std::string& list = text(key);
    if (list.empty() || (setting.kind == SettingKind::pathList && list == "none"))
        return {};
    if (setting.kind == SettingKind::path)
        return {list};
    std::vector<std::filesystem::path> files;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(';', begin), list.size());
        files.emplace_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return files;
}

bool Settings::isDefault(std::string_view key) const {
    return text(key) == settingInfo(key).defaultText;
}

Settings Settings::with(const Settings& overrides) const {
    Settings merged = *this;
    for (const auto& [key, text] : overrides.values_)
        merged.values_[key] = text;
    return merged;
}

} // namespace smat

#include "smatcore/settings/SettingInfo.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/radiometry/Band.h"
#include "smatcore/settings/AnalysisSections.h"
#include "smatcore/support/NearestNames.h"

namespace smat {

namespace {

/// 100000 where irsg::numberText, the shortest text, gives 1e+05: settings are read by people.
std::string plainNumber(double value) {
    return fmt::format("{}", value);
}

std::optional<std::string> canonicalNumber(const SettingInfo& setting, std::string_view text) {
    if (setting.unit == "%" && text.ends_with('%'))
        text = irsg::trimmed(text.substr(0, text.size() - 1));
    const std::optional<double> value = irsg::parseNumber(text);
    if (!value || *value < setting.minimum || *value > setting.maximum)
        return std::nullopt;
    if (setting.kind != SettingKind::integer)
        return plainNumber(*value == 0.0 ? 0.0 : *value); // -0 and 0 are one value
    if (*value != std::floor(*value) || std::abs(*value) > std::numeric_limits<int>::max())
        return std::nullopt;
    return fmt::format("{}", static_cast<int>(*value));
}

std::optional<std::string> canonicalBand(std::string_view text) {
    try {
        const irsg::SpectralRange range =
            irsg::Band::fromText(std::string(irsg::trimmed(text))).range();
        return plainNumber(range.min_um) + "-" + plainNumber(range.max_um);
    } catch (const irsg::InputError&) {
        return std::nullopt;
    }
}

/// No value for a band that occurs twice: what is asked for once more would be the same again.
std::optional<std::string> canonicalBands(std::string_view text) {
    std::vector<std::string> bands;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::optional<std::string> band = canonicalBand(text.substr(begin, end - begin));
        if (!band || std::find(bands.begin(), bands.end(), *band) != bands.end())
            return std::nullopt;
        bands.push_back(*band);
        begin = end + 1;
    }
    return fmt::format("{}", fmt::join(bands, ","));
}

/// No value for a number that occurs twice.
std::optional<std::string> canonicalNumbers(const SettingInfo& setting, std::string_view text) {
    std::vector<std::string> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto number =
            canonicalNumber(setting, irsg::trimmed(text.substr(begin, end - begin)));
        if (!number || std::ranges::find(numbers, *number) != numbers.end())
            return std::nullopt;
        numbers.push_back(*number);
        begin = end + 1;
    }
    return fmt::format("{}", fmt::join(numbers, ","));
}

std::optional<std::string> canonicalPathList(std::string_view text) {
    std::string list;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view item = irsg::trimmed(text.substr(0, end));
        if (item.empty())
            return std::nullopt;
        list += (list.empty() ? "" : ";") + std::string(item);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return list.empty() ? "none" : list;
}

/// The name of today where `text` is a former one of a choice.
std::string_view choiceOfToday(const SettingInfo& setting, std::string_view text) {
    const auto& former = setting.former.choices;
    const auto found = std::ranges::find(former, text, &std::pair<std::string, std::string>::first);
    return found == former.end() ? text : std::string_view(found->second);
}

const AnalysisSection* findAnalysisSection(std::string_view section) {
    const auto& sections = analysisSections();
    const auto found =
        std::find_if(sections.begin(), sections.end(),
                     [&](const AnalysisSection& one) { return one.name == section; });
    return found == sections.end() ? nullptr : &*found;
}

} // namespace

std::string SettingInfo::section() const {
    return key.substr(0, key.find('.'));
}

std::string SettingInfo::expected() const {
    const std::string suffix = unit.empty() ? "" : " " + unit;
    const std::string range =
        " from " + plainNumber(minimum) + " to " + plainNumber(maximum) + suffix;
    switch (kind) {
    case SettingKind::real:
        return "a number" + range;
    case SettingKind::integer:
        return "a whole number" + range;
    case SettingKind::boolean:
        return "true or false";
    case SettingKind::choice:
        return choices.size() == 1 ? choices.front() + ", the only choice of this version"
                                   : irsg::alternatives(choices);
    case SettingKind::choiceOrReal:
        return irsg::alternatives(choices) + ", or a number" + range;
    case SettingKind::realList:
        return irsg::alternatives(choices) + ", or numbers" + range +
               ", each once, separated by commas";
    case SettingKind::band:
        return "a band MIN-MAX with 0 < MIN < MAX in um, or several, each once, separated by "
               "commas";
    case SettingKind::path:
        return "a file name, or nothing";
    case SettingKind::pathList:
        return "file names separated by semicolons, or none";
    }
    throw irsg::LogicError("unknown kind of setting");
}

std::string SettingInfo::expectedInsteadOf(std::string_view text) const {
    return expected() +
           didYouMean(irsg::trimmed(text), kind == SettingKind::boolean
                                               ? std::vector<std::string>{"true", "false"}
                                               : choices);
}

const SettingInfo* findSetting(std::string_view key) {
    const auto& table = settingTable();
    auto found = std::ranges::find(table, key, &SettingInfo::key);
    if (found == table.end()) {
        found = std::ranges::find_if(table, [&](const SettingInfo& row) {
            return std::ranges::find(row.former.keys, key) != row.former.keys.end();
        });
    }
    return found == table.end() ? nullptr : &*found;
}

const SettingInfo& settingInfo(std::string_view key) {
    const SettingInfo* found = findSetting(key);
    if (found == nullptr || found->key != key)
        throw irsg::LogicError("there is no setting " + std::string(key));
    return *found;
}

std::string expectedSetting(std::string_view key) {
    std::vector<std::string> keys;
    for (const SettingInfo& row : settingTable())
        keys.push_back(row.key);
    return "a setting that exists (smat-batch settings lists them)" + didYouMean(key, keys);
}

std::string settingsLike(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string_view::npos || dot == 0)
        return "";
    const std::size_t above = path.rfind('.', dot - 1);
    const std::string_view key = path.substr(above == std::string_view::npos ? 0 : above + 1);
    std::vector<std::string> keys;
    for (const SettingInfo& row : settingTable())
        if (key.starts_with(row.section() + "."))
            keys.push_back(row.key);
    return didYouMean(key, keys);
}

std::vector<std::string> formerNameRemarks(std::string_view key, std::string_view text) {
    std::vector<std::string> remarks;
    const SettingInfo* setting = findSetting(key);
    if (setting == nullptr)
        return remarks;
    if (setting->key != key)
        remarks.push_back(std::string(key) + " is called " + setting->key + " now");
    const std::string_view given = irsg::trimmed(text), today = choiceOfToday(*setting, given);
    if (today != given) {
        remarks.push_back(
            fmt::format("the value {} of {} is called {} now", given, setting->key, today));
    }
    return remarks;
}

std::vector<std::string> settingsOn(SettingPage page) {
    std::vector<const SettingInfo*> rows;
    for (const SettingInfo& row : settingTable())
        if (row.page == page)
            rows.push_back(&row);
    std::ranges::stable_sort(rows, {}, &SettingInfo::place);
    std::vector<std::string> keys;
    keys.reserve(rows.size());
    for (const SettingInfo* row : rows)
        keys.push_back(row->key);
    return keys;
}

std::string sectionTitle(std::string_view section) {
    if (section == "render")
        return "Rendering";
    if (section == "scaling")
        return "Scalings";
    if (const AnalysisSection* own = findAnalysisSection(section))
        return std::string(own->title);
    std::string title(section);
    title.front() = static_cast<char>(title.front() - 'a' + 'A');
    return title;
}

bool isAnalysisSection(std::string_view section) {
    return findAnalysisSection(section) != nullptr;
}

bool concerns(const SettingInfo& setting, std::string_view analysis) {
    const std::string section = setting.section();
    return section == analysis || !isAnalysisSection(section);
}

std::optional<std::string> canonicalText(const SettingInfo& setting, std::string_view given) {
    const std::string_view text = choiceOfToday(setting, irsg::trimmed(given));
    const bool isChoice =
        std::find(setting.choices.begin(), setting.choices.end(), text) != setting.choices.end();
    switch (setting.kind) {
    case SettingKind::real:
    case SettingKind::integer:
        return canonicalNumber(setting, text);
    case SettingKind::boolean:
        return text == "true" || text == "false" ? std::optional(std::string(text)) : std::nullopt;
    case SettingKind::choice:
        return isChoice ? std::optional(std::string(text)) : std::nullopt;
    case SettingKind::choiceOrReal:
        return isChoice ? std::optional(std::string(text)) : canonicalNumber(setting, text);
    case SettingKind::realList:
        return isChoice ? std::optional(std::string(text)) : canonicalNumbers(setting, text);
    case SettingKind::band:
        return canonicalBands(text);
    case SettingKind::path:
        return std::string(text);
    case SettingKind::pathList:
        return canonicalPathList(text);
    }
    throw irsg::LogicError("unknown kind of setting");
}

} // namespace smat

#include "smatcore/analysis/Conditions.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/core/Quantity.h"
#include "smatcore/analysis/DetectionRequest.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/analysis/SettingWords.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

using irsg::Quantity;

/// A condition that is a number, with the column of a result that says it better than its settings:
/// an aspect that a sweep turned through, or set by itself.
struct NumberCondition {
    RealKey key;
    Quantity quantity;
};
constexpr std::array beforeAtmosphere{
    NumberCondition{key::cameraRange, Quantity::range},
    NumberCondition{key::cameraAzimuth, Quantity::azimuth},
    NumberCondition{key::cameraElevation, Quantity::elevation},
    NumberCondition{key::targetAltitude, Quantity::altitude},
};
constexpr NumberCondition time{key::stateTime, Quantity::time};

bool isConstant(const std::vector<double>& values) {
    return std::ranges::all_of(values, [&](double value) { return value == values.front(); });
}

std::string bandOf(const Settings& settings) {
    const bool hasResponse = !settings[key::sensorResponse].empty();
    return valueWords(settings, hasResponse ? key::sensorResponse.name : key::sensorBand.name);
}

/// Null where the result varies it.
std::optional<Condition> conditionOf(const NumberCondition& which, const Settings& settings,
                                     const ResultTable* table) {
    Settings said = settings;
    const ResultColumn* column = table == nullptr ? nullptr : table->find(which.quantity);
    if (column != nullptr && !column->values.empty()) {
        if (!isConstant(column->values))
            return std::nullopt;
        try {
            said.set(which.key, column->values.front());
        } catch (const irsg::InputError&) {
            return std::nullopt; // of another program, beyond what a setting may be
        }
    }
    return Condition{which.key, settingWords(said, which.key)};
}

/// The sensor of a search for ranges and what it takes to see something; none of other results.
std::vector<Condition> conditionsOfDetection(const ResultTable* table) {
    if (table == nullptr || resultKindOf(table->provenance) != detectionKind())
        return {};
    const auto said = [&](const char* key) { return table->provenance.value(key); };
    const std::string criterion = said("detection.criterion");
    return {{"detection.sensor", said("detection.sensor")},
            {"detection.criterion", said("detection.cycles").empty()
                                        ? "signal to noise ratio " + said("detection.snr")
                                        : criterion + ", " + said("detection.cycles") + " cycles"}};
}

std::vector<Condition> conditions(const Settings& settings, const ResultTable* table) {
    // Band and range of the project are not those of such a search.
    std::vector<Condition> list = conditionsOfDetection(table);
    const bool isDetection = !list.empty();
    if (!isDetection)
        list.push_back({key::sensorBand, bandOf(settings)});
    const auto add = [&](const NumberCondition& which) {
        if (isDetection && which.quantity == Quantity::range)
            return;
        if (auto one = conditionOf(which, settings, table))
            list.push_back(std::move(*one));
    };
    std::ranges::for_each(beforeAtmosphere, add);
    list.push_back(
        {key::environmentAtmospheres, valueWords(settings, key::environmentAtmospheres)});
    add(time);
    return list;
}

} // namespace

std::vector<Condition> conditionsOf(const Settings& settings) {
    return conditions(settings, nullptr);
}

Settings settingsOf(const ResultTable& table) {
    Settings settings;
    for (const auto& [key, value] : table.provenance.entries) {
        const SettingInfo* info = findSetting(key);
        if (info == nullptr)
            continue;
        const std::string unit = info->unit.empty() ? "" : " " + info->unit;
        const bool hasUnit = !unit.empty() && value.ends_with(unit);
        const std::string bare = value.substr(0, value.size() - (hasUnit ? unit.size() : 0));
        if (const auto text = canonicalText(*info, bare))
            settings.set(key, *text);
    }
    return settings;
}

namespace {

/// Band and path of a spectrum of hot gas, which knows nothing of a project.
std::vector<Condition> conditionsOfGas(const ResultTable& table) {
    const Provenance& said = table.provenance;
    ResultTable asSettings;
    const auto put = [&](const std::string& key, const char* name) {
        if (const std::string value = said.value(name); !value.empty())
            asSettings.provenance.add(key, value);
    };
    put(key::sensorBand, "band");
    put(key::cameraRange, "range [m]");
    put(key::targetAltitude, "gas_altitude [m]");
    const Settings settings = settingsOf(asSettings);
    std::vector<Condition> list{{key::sensorBand, bandOf(settings)}};
    for (const RealKey key : {key::cameraRange, key::targetAltitude})
        if (settings.isSet(key))
            list.push_back({key, settingWords(settings, key)});
    if (const std::string atmosphere = said.value("atmosphere"); !atmosphere.empty())
        list.push_back({key::environmentAtmospheres, atmosphere});
    return list;
}

} // namespace

std::vector<Condition> conditionsOf(const ResultTable& table) {
    const std::string analysis = table.provenance.value("analysis");
    if (analysis.empty())
        return {};
    // A tool asks the air alone: of a project's sensor, aspect and time it knows nothing.
    if (analysis == name(AnalysisKind::radiative) ||
        analysis == name(AnalysisKind::temperatureProfile)) {
        std::string air = table.provenance.value("atmosphere");
        constexpr std::string_view before = "ambient temperature: ";
        if (const std::string answer = table.provenance.value("answered by");
            air.empty() && answer.starts_with(before))
            air = answer.substr(before.size());
        if (air.empty())
            return {};
        return {{key::environmentAtmospheres, air}};
    }
    if (analysis == name(AnalysisKind::gas))
        return conditionsOfGas(table);
    return conditions(settingsOf(table), &table);
}

std::vector<Condition> conditionsOf(const irsg::RadianceImage& image) {
    ResultTable table;
    for (const auto& [key, value] : image.attributes)
        table.provenance.add(key, value);
    return conditionsOf(table);
}

std::vector<Condition> sharedConditions(const std::vector<const ResultTable*>& results) {
    std::vector<Condition> shared;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const std::vector<Condition> one = conditionsOf(*results[i]);
        if (i == 0)
            shared = one;
        std::erase_if(shared, [&](const Condition& condition) {
            return std::ranges::find(one, condition) == one.end();
        });
    }
    return shared;
}

std::string lineOf(const std::vector<Condition>& conditions) {
    std::string line;
    for (const Condition& condition : conditions)
        line += (line.empty() ? "" : " · ") + condition.text;
    return line;
}

} // namespace smat

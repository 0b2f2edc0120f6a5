#include "smatcore/analysis/MonteCarloData.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/CommandSettings.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/data/TableAxes.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/ShellText.h"

namespace smat {

void MonteCarloOptions::check() const {
    std::vector<irsg::Diagnostic> diagnostics;
    const auto require = [&](bool holds, const char* position, std::string value,
                             std::string expected) {
        if (!holds) {
            diagnostics.push_back({.file = "montecarlo",
                                   .position = position,
                                   .value = std::move(value),
                                   .expected = std::move(expected)});
        }
    };
    const auto isFrom = [](auto number, int least, int most) {
        return std::cmp_greater_equal(number, least) && std::cmp_less_equal(number, most);
    };
    const auto wholeNumber = [](int least, int most) {
        return fmt::format("a whole number from {} to {}", least, most);
    };
    require(isFrom(samples, leastSamples, mostSamples), "samples", std::to_string(samples),
            wholeNumber(leastSamples, mostSamples));
    const auto isPercent = [](double p) { return p >= 0.0 && p <= 100.0; };
    for (const double percent : percentiles) {
        require(isPercent(percent), "percentiles", irsg::numberText(percent),
                "numbers from 0 to 100");
    }
    require(std::is_sorted(percentiles.begin(), percentiles.end(), std::less_equal<>()),
            "percentiles", fmt::format("{}", fmt::join(percentiles, ",")),
            "ascending numbers, each once");
    require(isPercent(statistic.percent), "statistic", irsg::numberText(statistic.percent),
            "a percentile from 0 to 100");
    require(!standardError || (*standardError > 0.0 && *standardError < 1.0), "standard error",
            standardError ? irsg::numberText(*standardError) : "",
            "a part above 0 and below 1 of the statistic's largest magnitude");
    require(!standardError || hasBoundedError(statistic, samples), "standard error",
            fmt::format("that of the {} of at most {} draws", name(statistic), samples),
            "a percentile with draws on both sides of it: more draws, or one farther from 0 and "
            "100");
    require(isFrom(subpixelShifts, 1, mostSubpixelShifts), "subpixel shifts",
            std::to_string(subpixelShifts), wholeNumber(1, mostSubpixelShifts));
    require(isFrom(rankingPairs, leastRankingPairs, mostRankingPairs), "ranking pairs",
            std::to_string(rankingPairs), wholeNumber(leastRankingPairs, mostRankingPairs));
    require(!rankingAt || std::isfinite(*rankingAt), "ranking at", "no number",
            "an abscissa of the analysis");
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
}

std::string name(MonteCarloOptions::Quantity quantity) {
    switch (quantity) {
    case MonteCarloOptions::Quantity::intensity:
        return "intensity";
    case MonteCarloOptions::Quantity::contrastIntensity:
        return "contrast_intensity";
    case MonteCarloOptions::Quantity::irradiance:
        break;
    }
    return "irradiance";
}

std::optional<MonteCarloOptions::Quantity> monteCarloQuantity(std::string_view word) {
    using Quantity = MonteCarloOptions::Quantity;
    for (const Quantity quantity :
         {Quantity::intensity, Quantity::contrastIntensity, Quantity::irradiance}) {
        if (word == name(quantity))
            return quantity;
    }
    return std::nullopt;
}

std::string name(const Statistic& statistic) {
    switch (statistic.kind) {
    case Statistic::Kind::mean:
        return "mean";
    case Statistic::Kind::standardDeviation:
        return "standard-deviation";
    case Statistic::Kind::percentile:
        break;
    }
    return "p" + irsg::numberText(statistic.percent);
}

std::optional<Statistic> statisticFromName(std::string_view word) {
    if (word == "mean")
        return Statistic{};
    if (word == "standard-deviation")
        return Statistic{Statistic::Kind::standardDeviation, 50.0};
    double percent = 0.0;
    if (word.size() < 2 || word.front() != 'p')
        return std::nullopt;
    const char* end = word.data() + word.size();
    const auto [stopped, error] = std::from_chars(word.data() + 1, end, percent);
    if (error != std::errc() || stopped != end || !(percent >= 0.0 && percent <= 100.0))
        return std::nullopt;
    return Statistic{Statistic::Kind::percentile, percent};
}

std::size_t nearestPlace(const std::vector<double>& places, double wanted) {
    const auto found = std::ranges::min_element(
        places, {}, [&](double place) { return std::abs(place - wanted); });
    return static_cast<std::size_t>(found - places.begin());
}

std::size_t MonteCarloData::nearest(double abscissa) const {
    return nearestPlace(abscissae, abscissa);
}

std::vector<std::size_t> MonteCarloData::allNearest(double abscissa) const {
    const double there = abscissae.at(nearest(abscissa));
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < abscissae.size(); ++row)
        if (abscissae[row] == there)
            rows.push_back(row);
    return rows;
}

std::vector<std::size_t> MonteCarloData::rowsAlong(std::size_t row) const {
    std::vector<std::size_t> rows;
    for (std::size_t other = 0; other < abscissae.size(); ++other)
        if (std::ranges::all_of(otherAxes, [&](const ResultColumn& axis) {
                return axis.values.at(other) == axis.values.at(row);
            }))
            rows.push_back(other);
    return rows;
}

std::string MonteCarloData::rowPlace(std::size_t row) const {
    std::string place =
        axisPlace({abscissaKey, abscissaUnit, {}}, abscissae.at(row), !otherAxes.empty());
    for (const ResultColumn& axis : otherAxes)
        place += ", " + axisPlace(axis, axis.values.at(row), true);
    return place;
}

std::string MonteCarloData::rankedPlace() const {
    if (!options.rankingAt || abscissae.empty())
        return "";
    const std::vector<std::size_t> rows = allNearest(*options.rankingAt);
    return axisPlace({abscissaKey, abscissaUnit, {}}, abscissae[rows.front()], !otherAxes.empty()) +
           (rows.size() > 1 ? fmt::format(", {} rows", rows.size()) : "");
}

std::vector<double> MonteCarloData::ofBand(const std::vector<double>& byPlace,
                                           std::size_t band) const {
    const auto first = byPlace.begin() + static_cast<std::ptrdiff_t>(band * abscissae.size());
    return {first, first + static_cast<std::ptrdiff_t>(abscissae.size())};
}

std::string MonteCarloData::columnKey(const std::string& what, std::size_t band) const {
    return ColumnName{"", "", what, bands.at(band)}.key();
}

std::string MonteCarloData::equivalentCommand(const std::string& outputFile) const {
    const Project& project = analysis.project;
    const NamedAnalysis* named = project.find(analysis.name);
    const bool isNamed = named != nullptr && named->kind == analysis.kind;
    const Settings known = isNamed ? AnalysisData::of(project, analysis.name).settings
                                   : AnalysisData::of(project, analysis.kind).settings;
    std::string command = fmt::format(
        "smat-batch montecarlo {} {}",
        shellQuoted(project.file.empty() ? "PROJECT.smat" : project.file.string()),
        isNamed ? "--analysis " + shellQuoted(analysis.name) : "--kind " + name(analysis.kind));
    command += fmt::format(" --samples {} --seed {} --sequence {} --quantity {} --statistic {}",
                           options.samples, analysis.settings[key::scalingSeed],
                           name(options.sequence), name(options.quantity), name(options.statistic));
    if (options.standardError)
        command += " --standard-error " + irsg::numberText(*options.standardError);
    command += " --percentiles ";
    for (std::size_t i = 0; i < options.percentiles.size(); ++i)
        command += (i == 0 ? "" : ",") + irsg::numberText(options.percentiles[i]);
    command += fmt::format(" --subpixel-shifts {}", options.subpixelShifts);
    if (options.ranking)
        command += fmt::format(" --ranking --ranking-pairs {}", options.rankingPairs);
    if (options.ranking && options.rankingAt)
        command += " --ranking-at " + irsg::numberText(*options.rankingAt);
    Settings seeded = known;
    for (const std::string_view ownOption :
         {std::string_view(key::scalingSeed), std::string_view(key::scalingUse)}) {
        seeded.set(ownOption, analysis.settings.text(ownOption));
    }
    return command + settingOptions(project, analysis.settings, seeded, analysis.kind, true) +
           " --out " + shellQuoted(outputFile);
}

} // namespace smat

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/CommandSettings.h"
#include "smatcore/analysis/MonteCarlo.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/ShellText.h"
#include "smatcore/support/TextFile.h"

namespace smat {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson jsonOf(const Estimate& estimate) {
    return {{"value", estimate.value},
            {"standard_error", estimate.standardError},
            {"low_95", estimate.low95},
            {"high_95", estimate.high95}};
}

OrderedJson jsonOf(const std::vector<Estimate>& estimates) {
    OrderedJson list = OrderedJson::array();
    for (const Estimate& one : estimates)
        list.push_back(jsonOf(one));
    return list;
}

OrderedJson jsonOf(const MonteCarloOptions& options) {
    OrderedJson json = {
        {"samples", options.samples},           {"sequence", name(options.sequence)},
        {"quantity", name(options.quantity)},   {"percentiles", options.percentiles},
        {"statistic", name(options.statistic)}, {"phases", options.phases},
        {"ranking", options.ranking},           {"ranking_pairs", options.rankingPairs}};
    if (options.standardError)
        json["standard_error"] = *options.standardError;
    if (options.rankingAt)
        json["ranking_at"] = *options.rankingAt;
    return json;
}

const char* kindWord(const SceneScaling& scaling) {
    return scaling.input.kind == irsg::ScalingKind::temperature ? "temperature" : "emissivity";
}

} // namespace

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
    require(isFrom(phases, 1, mostPhases), "phases", std::to_string(phases),
            wholeNumber(1, mostPhases));
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

std::size_t MonteCarloData::nearest(double abscissa) const {
    const auto found =
        std::min_element(abscissae.begin(), abscissae.end(), [&](double a, double b) {
            return std::abs(a - abscissa) < std::abs(b - abscissa);
        });
    return static_cast<std::size_t>(found - abscissae.begin());
}

std::vector<double> MonteCarloData::ofBand(const std::vector<double>& byPlace,
                                           std::size_t band) const {
    const auto first = byPlace.begin() + static_cast<std::ptrdiff_t>(band * abscissae.size());
    return {first, first + static_cast<std::ptrdiff_t>(abscissae.size())};
}

std::string MonteCarloData::columnKey(const std::string& what, std::size_t band) const {
    return ColumnName{"", "", what, bands.at(band)}.key();
}

ResultTable rankingTable(const MonteCarloData& data) {
    ResultTable table;
    table.provenance = data.analysis.table.provenance;
    for (const char* key :
         {"place", "entity", "kind", "index", "first_order", "first_order_error", "first_order_low",
          "first_order_high", "total", "total_error", "total_low", "total_high"}) {
        table.add(key, "");
    }
    table.provenance.add("kind", "0 temperature, 1 emissivity");
    double place = 1.0;
    for (const RankedScaling& one : data.ranking) {
        const SceneScaling& scaling = data.scalings[one.scaling];
        const bool isTemperature = scaling.input.kind == irsg::ScalingKind::temperature;
        table.provenance.add(fmt::format("place {}", static_cast<int>(place)), scaling.name);
        table.addRow({place, static_cast<double>(scaling.input.entity), isTemperature ? 0.0 : 1.0,
                      static_cast<double>(scaling.input.index), one.firstOrder.value,
                      one.firstOrder.standardError, one.firstOrder.low95, one.firstOrder.high95,
                      one.total.value, one.total.standardError, one.total.low95, one.total.high95});
        place += 1.0;
    }
    return table;
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
    command += fmt::format(" --phases {}", options.phases);
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

ResultTable drawsTable(const MonteCarloData& data) {
    return drawsTable({NamedDraws{"", &data}});
}

ResultTable drawsTable(const std::vector<NamedDraws>& runs) {
    const MonteCarloData& last = *runs.back().data;
    if (last.draws() == 0)
        throw irsg::LogicError("draws were asked for before any was made");
    ResultTable table;
    table.provenance = last.analysis.table.provenance;
    table.add("draw", "");
    std::vector<std::string> names;
    for (const SceneScaling& scaling : last.scalings)
        names.push_back("scale " + scaling.name);
    for (const std::string& name : distinctLabels(names))
        table.add(name, "");
    for (const auto& [object, data] : runs) {
        const std::string quantity = data->analysis.table.provenance.value("quantity");
        const std::string unit = data->abscissaUnit.empty() ? "" : " " + data->abscissaUnit;
        for (std::size_t band = 0; band < data->bands.size(); ++band)
            for (const double abscissa : data->abscissae)
                table.add((object.empty() ? "" : object + ".") +
                              data->columnKey(quantity + " at " + irsg::numberText(abscissa) + unit,
                                              band),
                          data->unit);
    }
    const ScalingDraws draws(last.scalings, last.options.sequence, last.seed);
    for (std::size_t draw = 0; draw < last.draws(); ++draw) {
        std::vector<double> row{static_cast<double>(draw)};
        const std::vector<double> scales = draws.at(draw);
        row.insert(row.end(), scales.begin(), scales.end());
        for (const auto& [object, data] : runs)
            for (const std::vector<double>& values : data->values)
                row.push_back(values[draw]);
        table.addRow(row);
    }
    return table;
}

std::vector<std::filesystem::path> saveMonteCarlo(const MonteCarloData& data,
                                                  const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".csv") {
        data.analysis.table.save(file);
        if (data.ranking.empty())
            return {file};
        const std::filesystem::path ranking =
            file.parent_path() / (file.stem().string() + "-ranking.csv");
        rankingTable(data).save(ranking);
        return {file, ranking};
    }
    if (extension != ".json") {
        throw irsg::InputError({.file = file.string(),
                                .position = "",
                                .value = file.has_extension() ? extension : "no extension",
                                .expected = "a file that ends in .csv or .json"});
    }
    OrderedJson json = OrderedJson::parse(data.analysis.table.toJson());
    OrderedJson scales = OrderedJson::array();
    for (const SceneScaling& scaling : data.scalings) {
        scales.push_back({{"name", scaling.name},
                          {"entity", scaling.input.entity},
                          {"kind", kindWord(scaling)},
                          {"index", scaling.input.index},
                          {"distribution", irsg::info(scaling.distribution.kind()).name},
                          {"min", scaling.distribution.minimum()},
                          {"max", scaling.distribution.maximum()},
                          {"parameters", scaling.distribution.parameters()}});
    }
    json["options"] = jsonOf(data.options);
    json["scales"] = scales;
    json["draws"] = data.draws();
    json["abscissa"] = {{"name", data.abscissaKey}, {"unit", data.abscissaUnit}};
    json["unit"] = data.unit;
    json["bands"] = data.bands;
    json["statistic"] = jsonOf(data.statistic);
    json["reached_standard_error"] = data.reachedStandardError;
    OrderedJson ranking = OrderedJson::array();
    for (const RankedScaling& one : data.ranking) {
        ranking.push_back({{"name", data.scalings[one.scaling].name},
                           {"scale", one.scaling},
                           {"first_order", jsonOf(one.firstOrder)},
                           {"total", jsonOf(one.total)}});
    }
    json["ranking"] = ranking;
    writeTextFile(file, json.dump(1, ' ', false, decltype(json)::error_handler_t::replace) + "\n");
    return {file};
}

} // namespace smat

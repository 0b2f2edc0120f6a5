#include "smatcore/analysis/MonteCarloFile.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "smatcore/data/ColumnName.h"
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
        {"statistic", name(options.statistic)}, {"subpixel_shifts", options.subpixelShifts},
        {"ranking", options.ranking},           {"ranking_pairs", options.rankingPairs}};
    if (options.standardError)
        json["standard_error"] = *options.standardError;
    if (options.rankingAt)
        json["ranking_at"] = *options.rankingAt;
    return json;
}

/// "30 deg", "azimuth 30 deg elevation 5 deg": all digits, so that no two rows are alike, and no
/// commas.
std::string exactPlace(const MonteCarloData& data, std::size_t row) {
    const auto at = [](const std::string& unit, double value) {
        return irsg::numberText(value) + (unit.empty() ? "" : " " + unit);
    };
    if (data.otherAxes.empty())
        return at(data.abscissaUnit, data.abscissae[row]);
    std::string place = data.abscissaKey + " " + at(data.abscissaUnit, data.abscissae[row]);
    for (const ResultColumn& axis : data.otherAxes)
        place += " " + axis.key + " " + at(axis.unit, axis.values.at(row));
    return place;
}

const char* kindWord(const SceneScaling& scaling) {
    return scaling.input.kind == irsg::ScalingKind::temperature ? "temperature" : "emissivity";
}

} // namespace

ResultTable rankingTable(const MonteCarloData& data) {
    ResultTable table;
    table.provenance = data.analysis.table.provenance;
    for (const char* key :
         {"place", "entity", "kind", "index", "first_order", "first_order_error", "first_order_low",
          "first_order_high", "total", "total_error", "total_low", "total_high"}) {
        table.add(key, "");
    }
    table.provenance.add("kind", "0 temperature, 1 emissivity");
    const std::string ranked = data.rankedPlace();
    table.provenance.add("ranked at", ranked.empty() ? "all abscissae" : ranked);
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

ResultTable realisationsTable(const MonteCarloData& data) {
    return realisationsTable({NamedRealisations{"", &data}});
}

ResultTable realisationsTable(const std::vector<NamedRealisations>& runs) {
    const MonteCarloData& last = *runs.back().data;
    if (last.realisations() == 0)
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
        for (std::size_t band = 0; band < data->bands.size(); ++band)
            for (std::size_t row = 0; row < data->abscissae.size(); ++row)
                table.add((object.empty() ? "" : object + ".") +
                              data->columnKey(quantity + " at " + exactPlace(*data, row), band),
                          data->unit);
    }
    const ScalingRealisations realisations(last.scalings, last.options.sequence, last.seed);
    for (std::size_t draw = 0; draw < last.realisations(); ++draw) {
        std::vector<double> row{static_cast<double>(draw)};
        const std::vector<double> scales = realisations.at(draw);
        row.insert(row.end(), scales.begin(), scales.end());
        for (const auto& [object, data] : runs)
            for (const std::vector<double>& values : data->values)
                row.push_back(values[draw]);
        table.addRow(row);
    }
    return table;
}

std::vector<std::filesystem::path> monteCarloFiles(const std::filesystem::path& file,
                                                   bool hasRanking) {
    std::vector<std::filesystem::path> files{file};
    if (hasRanking && file.extension() == ".csv")
        files.push_back(file.parent_path() / (file.stem().string() + "-ranking.csv"));
    return files;
}

std::vector<std::filesystem::path> saveMonteCarlo(const MonteCarloData& data,
                                                  const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".csv") {
        data.analysis.table.save(file);
        std::vector<std::filesystem::path> files = monteCarloFiles(file, !data.ranking.empty());
        if (!data.ranking.empty())
            rankingTable(data).save(files.back());
        return files;
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
    json["draws"] = data.realisations();
    json["abscissa"] = {{"name", data.abscissaKey}, {"unit", data.abscissaUnit}};
    if (!data.otherAxes.empty()) {
        OrderedJson axes = OrderedJson::array();
        for (const ResultColumn& axis : data.otherAxes)
            axes.push_back({{"name", axis.key}, {"unit", axis.unit}});
        json["other_axes"] = axes;
    }
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

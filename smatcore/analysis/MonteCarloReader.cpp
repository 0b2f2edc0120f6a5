#include <fmt/format.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/JsonReader.h"
#include "smatcore/analysis/MonteCarloFile.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/TextFile.h"

namespace smat {

namespace {

using irsg::JsonReader;

constexpr std::size_t realisationsInRow = 4096;
constexpr std::size_t mostRealisations = 10'000'000;

std::size_t rowsFor(std::size_t values) {
    return (values + realisationsInRow - 1) / realisationsInRow;
}

Estimate estimateOf(const JsonReader& json) {
    return {json.at("value").numberOrNull(), json.at("standard_error").numberOrNull(),
            json.at("low_95").numberOrNull(), json.at("high_95").numberOrNull()};
}

MonteCarloOptions optionsOf(const JsonReader& json) {
    MonteCarloOptions options;
    const JsonReader quantity = json.at("quantity"), statistic = json.at("statistic");
    options.samples = json.at("samples").count(mostRealisations);
    options.sequence =
        json.at("sequence")
                    .word({name(RealisationSequence::plain), name(RealisationSequence::sobol)}) == 0
            ? RealisationSequence::plain
            : RealisationSequence::sobol;
    if (const auto known = monteCarloQuantity(quantity.text()))
        options.quantity = *known;
    else
        quantity.refuse("a quantity of Monte Carlo analyses");
    if (const auto known = statisticFromName(statistic.text()))
        options.statistic = *known;
    else
        statistic.refuse("mean, standard-deviation or pN");
    options.percentiles = json.at("percentiles").numbers();
    // Earlier versions called them phases.
    options.subpixelShifts = json.at(json.has("phases") ? "phases" : "subpixel_shifts").index();
    options.ranking = json.at("ranking").boolean();
    options.rankingPairs = json.at("ranking_pairs").count(mostRealisations);
    if (json.has("standard_error"))
        options.standardError = json.at("standard_error").number();
    if (json.has("ranking_at"))
        options.rankingAt = json.at("ranking_at").number();
    json.check([&] { options.check(); });
    return options;
}

irsg::Distribution distributionOf(const JsonReader& json) {
    std::vector<std::string> words;
    for (const irsg::DistributionInfo& one : irsg::distributionTable())
        words.emplace_back(one.name);
    const auto kind = irsg::distributionTable()[json.at("distribution").word(words)].kind;
    const double least = json.at("min").number(), most = json.at("max").number();
    const std::vector<double> parameters = json.at("parameters").numbers();
    irsg::Distribution distribution;
    json.check([&] { distribution = irsg::Distribution(kind, least, most, parameters); });
    return distribution;
}

SceneScaling scalingOf(const JsonReader& json) {
    SceneScaling scaling;
    scaling.name = json.at("name").text();
    scaling.input.entity = json.at("entity").index();
    scaling.input.index = json.at("index").index();
    scaling.input.kind = json.at("kind").word({"temperature", "emissivity"}) == 0
                             ? irsg::ScalingKind::temperature
                             : irsg::ScalingKind::emissivity;
    scaling.distribution = distributionOf(json);
    return scaling;
}

void takeColumns(MonteCarloData& data, const std::string& file) {
    const ResultTable& table = data.analysis.table;
    const auto column = [&](const std::string& key) {
        const ResultColumn* found = table.find(key);
        if (found == nullptr) {
            throw irsg::InputError({.file = file,
                                    .position = "columns",
                                    .value = "no column " + key,
                                    .expected = "those of a Monte Carlo analysis"});
        }
        return found->values;
    };
    data.abscissae = column(data.abscissaKey);
    for (ResultColumn& axis : data.otherAxes)
        axis.values = column(axis.key);
    for (std::size_t band = 0; band < data.bands.size(); ++band) {
        const auto append = [](std::vector<double>& all, const std::vector<double>& some) {
            all.insert(all.end(), some.begin(), some.end());
        };
        append(data.nominal, column(data.columnKey("nominal", band)));
        if (data.options.subpixelShifts > 1)
            append(data.numericalError, column(data.columnKey("error_numerical", band)));
    }
}

void takeRealisations(MonteCarloData& data, const JsonReader& count,
                      const irsg::RadianceImage& image) {
    const std::size_t places = data.statistic.size(), realisations = count.count(mostRealisations);
    // Both are bounded before they are multiplied: places by the file, draws by what may be asked.
    if (image.empty() || image.width() != static_cast<int>(realisationsInRow) ||
        static_cast<std::size_t>(image.height()) != rowsFor(places * realisations)) {
        count.refuse(fmt::format("{} x {} numbers beside it", image.width(), image.height()),
                     fmt::format("those of {} draws at {} places in rows of {}", realisations,
                                 places, realisationsInRow));
    }
    const std::vector<float>& flat = image.primary().values;
    for (std::size_t place = 0; place < places; ++place) {
        const auto first = flat.begin() + static_cast<std::ptrdiff_t>(place * realisations);
        data.values.emplace_back(first, first + static_cast<std::ptrdiff_t>(realisations));
    }
}

void takeRanking(MonteCarloData& data, const JsonReader& list) {
    for (const JsonReader& one : list.list()) {
        const JsonReader scale = one.at("scale");
        const std::size_t number = scale.count(mostRealisations);
        if (number >= data.scalings.size())
            scale.refuse("the number of one of the scales, from 0");
        data.ranking.push_back(
            {number, estimateOf(one.at("first_order")), estimateOf(one.at("total"))});
    }
}

/// Before anything is made of so many places: a file of some kB could name millions.
void takeStatistic(MonteCarloData& data, const JsonReader& list) {
    for (const JsonReader& one : list.list())
        data.statistic.push_back(estimateOf(one));
    const std::size_t rows = data.analysis.table.rowCount();
    if (data.bands.empty() || data.statistic.size() != rows * data.bands.size()) {
        list.refuse(fmt::format("{} estimates", data.statistic.size()),
                    fmt::format("one for each of {} rows in {} bands", rows, data.bands.size()));
    }
}

} // namespace

irsg::RadianceImage realisationsImage(const MonteCarloData& data) {
    const std::size_t count = data.values.size() * data.realisations();
    irsg::RadianceImage image(static_cast<int>(realisationsInRow), static_cast<int>(rowsFor(count)),
                              "draws", data.unit);
    auto to = image.primary().values.begin();
    for (const std::vector<double>& values : data.values)
        for (const double value : values)
            *to++ = static_cast<float>(value);
    return image;
}

MonteCarloData loadMonteCarlo(const std::filesystem::path& file,
                              const irsg::RadianceImage& realisations) {
    const std::string fileName = file.string();
    const JsonReader json(readTextFile(file), fileName,
                          {.expected = "the JSON form of a Monte Carlo run"},
                          irsg::JsonErrors::throwFirst);
    MonteCarloData data;
    data.analysis = resultOf(ResultTable::fromJson(json), fileName);
    // The run is Monte Carlo; its analysis is the one that it repeats.
    data.analysis.kind = resultKindFromName(data.analysis.table.provenance.value("analysis"));
    data.options = optionsOf(json.at("options"));
    for (const JsonReader& one : json.at("scales").list())
        data.scalings.push_back(scalingOf(one));
    data.abscissaKey = json.at("abscissa").at("name").text();
    data.abscissaUnit = json.at("abscissa").at("unit").text();
    if (json.has("other_axes"))
        for (const JsonReader& one : json.at("other_axes").list())
            data.otherAxes.push_back({one.at("name").text(), one.at("unit").text(), {}});
    data.unit = json.at("unit").text();
    data.bands = json.at("bands").texts();
    takeStatistic(data, json.at("statistic"));
    takeRanking(data, json.at("ranking"));
    data.reachedStandardError = json.at("reached_standard_error").boolean();
    takeColumns(data, fileName);
    takeRealisations(data, json.at("draws"), realisations);
    // Provenance tells what is not the default.
    const std::string seed = data.analysis.table.provenance.value(key::scalingSeed.name);
    if (const auto number = irsg::parseNumber(seed); number && *number >= 0.0)
        data.seed = static_cast<std::uint64_t>(*number);
    return data;
}

} // namespace smat

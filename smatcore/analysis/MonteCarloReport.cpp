#include "smatcore/analysis/MonteCarloReport.h"

#include <algorithm>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisProvenance.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

using irsg::Quantity;
using Asked = MonteCarloOptions::Quantity;

Quantity quantityOf(Asked asked, bool isSpectrum) {
    switch (asked) {
    case Asked::intensity:
        return isSpectrum ? Quantity::spectralIntensity : Quantity::intensity;
    case Asked::contrastIntensity:
        return isSpectrum ? Quantity::spectralContrastIntensity : Quantity::contrastIntensity;
    case Asked::irradiance:
        break;
    }
    return isSpectrum ? Quantity::spectralIrradiance : Quantity::irradiance;
}

void addColumns(MonteCarloData& data, const MonteCarloAxis& of) {
    const bool isSpectrum = !of.wavenumbers_per_cm.empty();
    ResultTable& table = data.analysis.table;
    const irsg::QuantityInfo& quantity = irsg::info(quantityOf(data.options.quantity, isSpectrum));
    const irsg::QuantityInfo& axis = irsg::info(of.abscissa);
    data.unit = std::string(quantity.unit);
    data.abscissaKey = std::string(axis.key);
    data.abscissaUnit = std::string(axis.unit);
    if (isSpectrum)
        table.add(Quantity::wavenumber);
    table.add(data.abscissaKey, data.abscissaUnit);
    for (const ResultColumn& other : data.otherAxes)
        table.add(other.key, other.unit);
    for (std::size_t band = 0; band < data.bands.size(); ++band) {
        const auto add = [&](const std::string& what) {
            table.add(data.columnKey(what, band), data.unit);
        };
        for (const char* key :
             {"nominal", "mean", "standard_deviation", "standard_error", "minimum"})
            add(key);
        for (const double percent : data.options.percentiles)
            add("p" + irsg::numberText(percent));
        add("maximum");
        if (data.options.subpixelShifts > 1)
            add("error_numerical");
        for (const char* prefix : errorPrefixes(data.errors))
            add(std::string(prefix) + "nominal");
    }
}

void summarise(MonteCarloData& data) {
    std::vector<SummaryItem>& summary = data.analysis.summary;
    // Where the spread is largest, what it is, and what of it is the drawing's own error.
    std::size_t widest = 0;
    std::vector<double> sigmas;
    for (const std::vector<double>& values : data.values)
        sigmas.push_back(standardDeviationOf(values));
    widest =
        static_cast<std::size_t>(std::max_element(sigmas.begin(), sigmas.end()) - sigmas.begin());
    const std::size_t abscissae = data.abscissae.size();
    const std::string band = ColumnName{"", "", "", data.bands[widest / abscissae]}.which();
    const std::string where =
        " at " + data.rowPlace(widest % abscissae) + (band.empty() ? "" : ", " + band);
    const Estimate& estimated = data.statistic[widest];
    summary.push_back({"Draws", static_cast<double>(data.realisations()), ""});
    summary.push_back({"Largest standard deviation" + where, sigmas[widest], data.unit});
    summary.push_back({"Mean there", meanOf(data.values[widest]), data.unit});
    summary.push_back({"Standard error of the " + name(data.options.statistic) + " there",
                       estimated.standardError, data.unit});
    if (data.options.subpixelShifts > 1)
        summary.push_back({"Numerical error there", data.numericalError[widest], data.unit});
    const std::string ranked = data.rankedPlace();
    for (const RankedScaling& one : data.ranking) {
        if (summary.size() >= 10)
            break;
        summary.push_back({"First-order index of " + data.scalings[one.scaling].name +
                               (ranked.empty() ? "" : " at " + ranked),
                           one.firstOrder.value, ""});
    }
}

} // namespace

void tellRealisations(MonteCarloData& data, const MonteCarloAxis& axis, std::size_t realisations) {
    Provenance own;
    own.add("monte carlo", fmt::format("{} draws of the {} sequence, seed {}", realisations,
                                       name(data.options.sequence), data.seed));
    const Quantity quantity = quantityOf(data.options.quantity, !axis.wavenumbers_per_cm.empty());
    own.add("quantity", std::string(irsg::info(quantity).key));
    own.add("standard error of", name(data.options.statistic));
    own.add("subpixel shifts", std::to_string(data.options.subpixelShifts));
    for (const SceneScaling& scaling : data.scalings)
        own.add("scale", scaling.name + ": " + describe(scaling.distribution));
    auto& entries = data.analysis.table.provenance.entries;
    const auto at = std::ranges::find_if(entries, [](const auto& entry) {
        return entry.first == "answered by" || entry.first == "warning";
    });
    entries.insert(at, own.entries.begin(), own.entries.end());
}

void beginRealisations(MonteCarloData& data, const MonteCarloAxis& axis) {
    addColumns(data, axis);
    tellRealisations(data, axis, data.options.samples);
}

std::vector<double> rowOfRealisations(const MonteCarloData& data, const MonteCarloAxis& axis,
                                      std::size_t abscissa) {
    std::vector<double> row;
    if (!axis.wavenumbers_per_cm.empty())
        row.push_back(axis.wavenumbers_per_cm[abscissa]);
    row.push_back(data.abscissae[abscissa]);
    for (const ResultColumn& other : data.otherAxes)
        row.push_back(other.values.at(abscissa));
    for (std::size_t k = abscissa; k < data.values.size(); k += data.abscissae.size()) {
        std::vector<double> ascending = data.values[k];
        std::sort(ascending.begin(), ascending.end());
        row.insert(row.end(), {data.nominal[k], meanOf(ascending), standardDeviationOf(ascending),
                               data.statistic[k].standardError, ascending.front()});
        for (const double percent : data.options.percentiles)
            row.push_back(percentileOf(ascending, percent));
        row.push_back(ascending.back());
        if (data.options.subpixelShifts > 1)
            row.push_back(data.numericalError[k]);
        if (data.errors != ErrorColumns::none)
            appendError(row, data.nominalErrors[k], data.errors);
    }
    return row;
}

void reportRealisations(MonteCarloData& data, const MonteCarloAxis& axis) {
    addColumns(data, axis);
    for (std::size_t i = 0; i < data.abscissae.size(); ++i)
        data.analysis.table.addRow(rowOfRealisations(data, axis, i),
                                   data.caseWarnings.empty() ? "" : data.caseWarnings.at(i));
    summarise(data);
    tellRealisations(data, axis, data.realisations());
}

void reportMonteCarlo(MonteCarloData& data, const AnalysisPlan& plan,
                      const SceneDescription& scene) {
    writeProvenance(data.analysis, scene);
    if (plan.kind->form == AnalysisForm::spectrum)
        reportRealisations(data, {Quantity::wavelength, plan.wavenumbers_per_cm});
    else
        reportRealisations(data, {plan.coordinate});
}

} // namespace smat

#include "smatcore/analysis/MonteCarloReport.h"

#include <algorithm>

#include <fmt/format.h>

#include "irsg/radiometry/Errors.h"
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

std::string describe(const SceneScaling& scaling) {
    const irsg::Distribution& d = scaling.distribution;
    std::string text =
        d.isFixed() ? fmt::format("{}: {}", scaling.name, irsg::numberText(d.minimum()))
                    : fmt::format("{}: {}, {} to {}", scaling.name, irsg::info(d.kind()).name,
                                  irsg::numberText(d.minimum()), irsg::numberText(d.maximum()));
    if (!d.hasDefaultParameters())
        for (std::size_t i = 0; i < d.parameters().size(); ++i)
            text += fmt::format(", {} {}", irsg::info(d.kind()).parameters[i],
                                irsg::numberText(d.parameters()[i]));
    return text;
}

void writeTable(MonteCarloData& data, const AnalysisPlan& plan) {
    const bool isSpectrum = plan.kind->form == AnalysisForm::spectrum;
    ResultTable& table = data.analysis.table;
    const irsg::QuantityInfo& quantity = irsg::info(quantityOf(data.options.quantity, isSpectrum));
    const irsg::QuantityInfo& axis =
        irsg::info(isSpectrum ? Quantity::wavelength : plan.coordinate);
    data.unit = std::string(quantity.unit);
    data.abscissaKey = std::string(axis.key);
    data.abscissaUnit = std::string(axis.unit);
    if (isSpectrum)
        table.add(Quantity::wavenumber);
    table.add(data.abscissaKey, data.abscissaUnit);
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
        if (data.options.phases > 1)
            add("error_numerical");
    }
    for (std::size_t i = 0; i < data.abscissae.size(); ++i) {
        std::vector<double> row;
        if (isSpectrum)
            row.push_back(plan.wavenumbers_per_cm[i]);
        row.push_back(data.abscissae[i]);
        for (std::size_t k = i; k < data.values.size(); k += data.abscissae.size()) {
            std::vector<double> ascending = data.values[k];
            std::sort(ascending.begin(), ascending.end());
            row.insert(row.end(),
                       {data.nominal[k], meanOf(ascending), standardDeviationOf(ascending),
                        data.statistic[k].standardError, ascending.front()});
            for (const double percent : data.options.percentiles)
                row.push_back(percentileOf(ascending, percent));
            row.push_back(ascending.back());
            if (data.options.phases > 1)
                row.push_back(data.numericalError[k]);
        }
        table.addRow(row);
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
    const std::string where = fmt::format(" at {:.6g} {}{}", data.abscissae[widest % abscissae],
                                          data.abscissaUnit, band.empty() ? "" : ", " + band);
    const Estimate& estimated = data.statistic[widest];
    summary.push_back({"Draws", static_cast<double>(data.draws()), ""});
    summary.push_back({"Largest standard deviation" + where, sigmas[widest], data.unit});
    summary.push_back({"Mean there", meanOf(data.values[widest]), data.unit});
    summary.push_back({"Standard error of the " + name(data.options.statistic) + " there",
                       estimated.standardError, data.unit});
    if (data.options.phases > 1)
        summary.push_back({"Numerical error there", data.numericalError[widest], data.unit});
    for (const RankedScaling& one : data.ranking) {
        if (summary.size() >= 10)
            break;
        summary.push_back(
            {"First-order index of " + data.scalings[one.scaling].name, one.firstOrder.value, ""});
    }
}

void writeDraws(MonteCarloData& data, const AnalysisPlan& plan) {
    Provenance& provenance = data.analysis.table.provenance;
    provenance.add("monte carlo", fmt::format("{} draws of the {} sequence, seed {}", data.draws(),
                                              name(data.options.sequence),
                                              data.analysis.settings[key::scalingSeed]));
    const Quantity quantity =
        quantityOf(data.options.quantity, plan.kind->form == AnalysisForm::spectrum);
    provenance.add("quantity", std::string(irsg::info(quantity).key));
    provenance.add("standard error of", name(data.options.statistic));
    provenance.add("phases", std::to_string(data.options.phases));
    for (const SceneScaling& scaling : data.scalings)
        provenance.add("scale", describe(scaling));
}

} // namespace

void reportMonteCarlo(MonteCarloData& data, const AnalysisPlan& plan,
                      const SceneDescription& scene) {
    writeTable(data, plan);
    summarise(data);
    writeProvenance(data.analysis, scene);
    writeDraws(data, plan);
}

} // namespace smat

#include "irsg/gas/GasOptics.h"

#include <algorithm>
#include <array>
#include <span>

#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

using Tables = std::array<std::shared_ptr<const NarrowBandTable>, hotGasCount>;

Tables read(const std::string& source, std::span<const HotGas> gases) {
    Tables tables;
    for (const HotGas gas : gases) {
        const auto place = static_cast<std::size_t>(gas);
        tables[place] = std::make_shared<NarrowBandTable>(NarrowBandTable::read(
            atmosphereResource("hotgas-" + source + "-" + lowerCase(hotGasNames[place]) + ".csv")));
    }
    return tables;
}

const Tables& linesTables() {
    static const Tables tables =
        read("lines", std::array{HotGas::CO2, HotGas::H2O, HotGas::CO, HotGas::CH4});
    return tables;
}

const Tables& radcalTables() {
    static const Tables tables = read("radcal", std::array{HotGas::CO2, HotGas::H2O, HotGas::CO});
    return tables;
}

/// A part of the spectrum with errors of a source there at temperatures, between which they are
/// linear and beyond which they are held.
struct Stated {
    HotGas gas;
    double lower_per_cm, upper_per_cm;
    std::array<double, 5> atTemperature; ///< of errorAxis_K
};
constexpr std::array<double, 5> errorAxis_K = {300.0, 700.0, 1000.0, 1500.0, 2000.0};
constexpr double all_per_cm = 1e9;

/// The first row that fits.
double statedError(std::span<const Stated> rows, HotGas gas, double wavenumber_per_cm,
                   double temperature_K) {
    for (const Stated& row : rows)
        if (row.gas == gas && wavenumber_per_cm >= row.lower_per_cm &&
            wavenumber_per_cm < row.upper_per_cm)
            return interpolate(errorAxis_K, row.atTemperature, temperature_K);
    return 1.0;
}

constexpr std::array<Stated, 9> radcalErrors = {{
    {HotGas::CO2, 0.0, 1300.0, {1.0, 1.0, 1.0, 1.0, 1.0}},
    {HotGas::CO2, 1900.0, 2280.0, {0.6, 0.25, 0.22, 0.22, 0.22}},
    {HotGas::CO2, 2280.0, 3200.0, {0.4, 0.22, 0.22, 0.22, 0.22}},
    {HotGas::CO2, 0.0, all_per_cm, {0.4, 0.3, 0.3, 0.3, 0.3}},
    {HotGas::H2O, 0.0, 1300.0, {0.8, 0.58, 0.58, 0.58, 0.58}},
    {HotGas::H2O, 1900.0, 3200.0, {0.5, 0.29, 0.29, 0.29, 0.29}},
    {HotGas::H2O, 3200.0, 4200.0, {0.4, 0.21, 0.21, 0.21, 0.21}},
    {HotGas::H2O, 0.0, all_per_cm, {0.5, 0.35, 0.35, 0.35, 0.35}},
    {HotGas::CO, 0.0, all_per_cm, {0.4, 0.22, 0.22, 0.22, 0.22}},
}};

constexpr std::array<Stated, 6> linesErrors = {{
    {HotGas::CO2, 780.0, 1300.0, {0.10, 0.15, 0.30, 0.50, 0.60}},
    {HotGas::CO2, 0.0, all_per_cm, {0.05, 0.05, 0.06, 0.12, 0.20}},
    {HotGas::H2O, 0.0, 1300.0, {0.10, 0.12, 0.15, 0.40, 0.50}},
    {HotGas::H2O, 0.0, all_per_cm, {0.06, 0.06, 0.10, 0.20, 0.25}},
    {HotGas::CO, 0.0, all_per_cm, {0.05, 0.05, 0.05, 0.06, 0.08}},
    {HotGas::CH4, 0.0, all_per_cm, {0.08, 0.20, 0.45, 1.0, 1.0}},
}};

std::string describe(const GasTableOfSource& answer) {
    return std::string(gasSourceNames[static_cast<std::size_t>(answer.source)]) + ": " +
           answer.table->source();
}

} // namespace

const GasTableOfSource& GasAnswer::at(double wavenumber_per_cm) const {
    const bool isReached = !beyond.table || (wavenumber_per_cm >= first.table->lower_per_cm() &&
                                             wavenumber_per_cm <= first.table->upper_per_cm());
    return isReached ? first : beyond;
}

GasAnswers gasAnswers(GasSource source) {
    GasAnswers answers;
    for (std::size_t gas = 0; gas < hotGasCount; ++gas) {
        const GasTableOfSource lines{GasSource::lines, linesTables()[gas]};
        const GasTableOfSource radcal{GasSource::radcal, radcalTables()[gas]};
        if (source == GasSource::radcal && radcal.table)
            answers[gas].first = radcal;
        else
            answers[gas] = {lines, source == GasSource::automatic ? radcal : GasTableOfSource{}};
    }
    return answers;
}

std::string describe(const GasAnswer& answer) {
    return describe(answer.first) +
           (answer.beyond.table ? "; beyond " + numberText(answer.first.table->lower_per_cm()) +
                                      "-" + numberText(answer.first.table->upper_per_cm()) +
                                      " cm-1 " + describe(answer.beyond)
                                : "");
}

double statedGasError(const GasTableOfSource& answer, HotGas gas, double wavenumber_per_cm,
                      double temperature_K) {
    constexpr double beyondTable = 1.5; // of temperatures: the ends are held
    const double stated = answer.source == GasSource::lines
                              ? statedError(linesErrors, gas, wavenumber_per_cm, temperature_K)
                              : statedError(radcalErrors, gas, wavenumber_per_cm, temperature_K);
    const bool isInside =
        temperature_K >= answer.table->coldest_K() && temperature_K <= answer.table->hottest_K();
    return std::min(1.0, isInside ? stated : beyondTable * stated);
}

} // namespace irsg

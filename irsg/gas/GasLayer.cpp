#include "irsg/gas/GasLayer.h"

#include <numeric>

namespace irsg {

namespace {

constexpr double rounding = 1e-9; ///< of a sum of fractions that were typed

double allFractions(const GasLayer& layer) {
    return std::accumulate(layer.moleFraction.begin(), layer.moleFraction.end(),
                           layer.oxygenFraction);
}

} // namespace

double GasLayer::nitrogenFraction() const {
    const double rest = 1.0 - allFractions(*this);
    return rest > 0.0 ? rest : 0.0;
}

double GasLayer::column_atm_cm(HotGas gas) const {
    return fraction(gas) * pressure_atm * length_m * 100.0;
}

std::vector<Diagnostic> gasLayerDiagnostics(const GasLayer& layer, const std::string& name) {
    using Limits = GasLayerLimits;
    std::vector<Diagnostic> diagnostics;
    const auto expect = [&](const char* key, double value, double least, double most,
                            const char* unit) {
        if (!(value >= least && value <= most))
            diagnostics.push_back(
                {name, key, numberText(value),
                 "a number from " + numberText(least) + " to " + numberText(most) + unit});
    };
    expect("T_K", layer.temperature_K, Limits::coldest_K, Limits::hottest_K, " K");
    expect("p_atm", layer.pressure_atm, Limits::thinnest_atm, Limits::densest_atm, " atm");
    if (!(layer.length_m > 0.0 && layer.length_m <= Limits::longest_m))
        diagnostics.push_back({name, "length_m", numberText(layer.length_m),
                               "a number above 0, up to " + numberText(Limits::longest_m) + " m"});
    for (std::size_t gas = 0; gas < hotGasCount; ++gas)
        expect(hotGasNames[gas], layer.moleFraction[gas], 0.0, 1.0, "");
    expect("O2", layer.oxygenFraction, 0.0, 1.0, "");
    expect("soot_ppmv", layer.soot_ppmv, 0.0, Limits::mostSoot_ppmv, " ppmv");
    const double sum = allFractions(layer);
    if (diagnostics.empty() && sum > 1.0 + rounding)
        diagnostics.push_back({name, "mole fractions", numberText(sum) + " in sum", "1 at most"});
    return diagnostics;
}

} // namespace irsg

// bench_gas: first and further spectra of layers of hot gas at 5 cm-1, and of the coincidence of
// their lines with air.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "irsg/gas/GasSpectrum.h"
#include "irsg/gas/GasThroughAir.h"

namespace {

using namespace irsg;

template <typename Work>
double milliseconds(Work work) {
    const auto begun = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun)
        .count();
}

} // namespace

int main() {
    GasRequest request;
    request.band = {3.0, 5.0};
    for (const double temperature_K : {360.0, 480.0, 700.0, 480.0, 360.0}) {
        GasLayer layer;
        layer.temperature_K = temperature_K;
        layer.length_m = 0.3;
        layer.fraction(HotGas::CO2) = 0.033;
        layer.fraction(HotGas::H2O) = 0.033;
        layer.fraction(HotGas::CO) = 0.001;
        layer.soot_ppmv = 0.01;
        request.layers.push_back(layer);
    }
    AtmosphericState air;
    air.moleFraction[static_cast<std::size_t>(Gas::H2O)] = 0.01;
    air.moleFraction[static_cast<std::size_t>(Gas::CO2)] = 4e-4;
    double sum = 0.0;
    const auto spectrum = [&] { sum += gasSpectrum(request).bandRadiance_W_m2_sr(); };
    const std::vector<GasSpectrum::Cell> cells = gasSpectrum(request).cells;
    const auto correlation = [&] {
        sum += lineCorrelations(request, cells, air, 1000.0).front().radiance;
    };
    const double firstCorrelation_ms = milliseconds(correlation);
    std::vector<double> spectra_ms, correlations_ms;
    for (int i = 0; i < 50; ++i) {
        spectra_ms.push_back(milliseconds(spectrum));
        correlations_ms.push_back(milliseconds(correlation));
    }
    std::ranges::sort(spectra_ms);
    std::ranges::sort(correlations_ms);
    std::printf(
        "5 layers, 3-5 um, 5 cm-1: spectrum %.2f ms (least %.2f), coincidence with air %.1f "
        "ms (first %.0f); %g\n",
        spectra_ms[spectra_ms.size() / 2], spectra_ms.front(),
        correlations_ms[correlations_ms.size() / 2], firstCorrelation_ms, sum);
}

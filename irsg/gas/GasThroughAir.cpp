#include "irsg/gas/GasThroughAir.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/gas/Soot.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double atmosphere_hPa = 1013.25;
constexpr double narrowest_per_cm = 5.0; ///< means of fewer samples are chance
constexpr std::size_t fewest = 20;

const GasTable& samples() {
    static const std::shared_ptr<const GasTable> table =
        GasTable::read(atmosphereResource("hotgas-samples.gastable"));
    return *table;
}

AtmosphericState stateOf(const GasLayer& layer) {
    AtmosphericState state;
    state.pressure_hPa = layer.pressure_atm * atmosphere_hPa;
    state.temperature_K = layer.temperature_K;
    state.moleFraction[static_cast<std::size_t>(Gas::CO2)] = layer.fraction(HotGas::CO2);
    state.moleFraction[static_cast<std::size_t>(Gas::H2O)] = layer.fraction(HotGas::H2O);
    state.moleFraction[static_cast<std::size_t>(Gas::CO)] = layer.fraction(HotGas::CO);
    return state;
}

/// What is known at single wavenumbers.
struct Fine {
    std::vector<double> air, gas, radiance; ///< transmittances, radiance
};

Fine fineSpectra(const GasRequest& request, const std::vector<std::uint32_t>& nodes,
                 const AtmosphericState& air, double length_m) {
    std::vector<float> absorption_per_m(nodes.size());
    samples().absorption_per_m(air, nodes, absorption_per_m);
    Fine fine;
    for (const float value : absorption_per_m)
        fine.air.push_back(std::exp(-static_cast<double>(value) * length_m));
    fine.gas.assign(nodes.size(), 1.0);
    fine.radiance.assign(nodes.size(), 0.0);
    const auto wavelength_um = [&](std::size_t i) {
        return wavelengthFromWavenumber_um(samples().wavenumber_per_cm(nodes[i]));
    };
    for (const GasLayer& layer : request.layers) {
        samples().absorption_per_m(stateOf(layer), nodes, absorption_per_m);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const double soot_per_m =
                layer.soot_ppmv > 0.0
                    ? sootAbsorption_per_m(wavelength_um(i), layer.soot_ppmv * 1e-6)
                    : 0.0;
            const double depth =
                (static_cast<double>(absorption_per_m[i]) + soot_per_m) * layer.length_m;
            fine.radiance[i] += fine.gas[i] * -std::expm1(-depth) *
                                planckRadiance_W_m2_sr_um(wavelength_um(i), layer.temperature_K);
            fine.gas[i] *= std::exp(-depth);
        }
    }
    if (request.background_K)
        for (std::size_t i = 0; i < nodes.size(); ++i)
            fine.radiance[i] +=
                fine.gas[i] * planckRadiance_W_m2_sr_um(wavelength_um(i), *request.background_K);
    return fine;
}

/// Mean of a b over the product of the means of a and b.
double correlation(const std::vector<double>& a, const std::vector<double>& b, std::size_t first,
                   std::size_t count) {
    double sumA = 0.0, sumB = 0.0, sumBoth = 0.0;
    for (std::size_t i = first; i < first + count; ++i) {
        sumA += a[i];
        sumB += b[i];
        sumBoth += a[i] * b[i];
    }
    constexpr double nothing = 1e-30; // as an atmosphere that lets nothing through
    return sumA > nothing && sumB > nothing ? sumBoth * static_cast<double>(count) / (sumA * sumB)
                                            : 1.0;
}

} // namespace

std::vector<LineCorrelation> lineCorrelations(const GasRequest& request,
                                              const std::vector<GasSpectrum::Cell>& cells,
                                              const AtmosphericState& air, double length_m) {
    const BinSet& bins = samples().bins(5);
    std::vector<LineCorrelation> correlations(cells.size());
    if (cells.empty())
        return correlations;
    const auto [first, last] = bins.range(cells.front().lower_per_cm - narrowest_per_cm,
                                          cells.back().upper_per_cm + narrowest_per_cm);
    std::vector<std::uint32_t> nodes;
    for (std::size_t b = first; b < last; ++b)
        nodes.insert(nodes.end(), bins.nodes.begin() + bins.bins[b].first,
                     bins.nodes.begin() + bins.bins[b].first + bins.bins[b].count);
    const Fine fine = fineSpectra(request, nodes, air, length_m);
    std::vector<double> wavenumbers_per_cm;
    for (const std::uint32_t node : nodes)
        wavenumbers_per_cm.push_back(samples().wavenumber_per_cm(node));
    for (std::size_t c = 0; c < cells.size(); ++c) {
        // The samples of the cell, of a narrow one those around its middle.
        const double middle = 0.5 * (cells[c].lower_per_cm + cells[c].upper_per_cm);
        const double half =
            0.5 * std::max(narrowest_per_cm, cells[c].upper_per_cm - cells[c].lower_per_cm);
        const auto from = std::ranges::lower_bound(wavenumbers_per_cm, middle - half);
        const auto to = std::ranges::lower_bound(wavenumbers_per_cm, middle + half);
        const auto begin = static_cast<std::size_t>(from - wavenumbers_per_cm.begin());
        const auto count = static_cast<std::size_t>(to - from);
        if (count < fewest)
            continue;
        correlations[c] = {correlation(fine.air, fine.radiance, begin, count),
                           correlation(fine.air, fine.gas, begin, count)};
    }
    return correlations;
}

} // namespace irsg

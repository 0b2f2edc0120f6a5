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

GasColumnsLineByLine::GasColumnsLineByLine(const std::vector<GasLayer>& gases,
                                           const std::vector<double>& wavenumbers_per_cm,
                                           const std::vector<double>& widths_per_cm)
    : cells_(wavenumbers_per_cm.size()) {
    if (wavenumbers_per_cm.empty())
        return;
    const auto reachOf_per_cm = [&](std::size_t cell) {
        return 0.5 * std::max(narrowest_per_cm, widths_per_cm[cell]);
    };
    const BinSet& bins = samples().bins(5);
    const auto [first, last] = bins.range(
        wavenumbers_per_cm.front() - reachOf_per_cm(0) - narrowest_per_cm,
        wavenumbers_per_cm.back() + reachOf_per_cm(cells_.size() - 1) + narrowest_per_cm);
    for (std::size_t b = first; b < last; ++b)
        nodes_.insert(nodes_.end(), bins.nodes.begin() + bins.bins[b].first,
                      bins.nodes.begin() + bins.bins[b].first + bins.bins[b].count);
    std::vector<double> places_per_cm;
    for (const std::uint32_t node : nodes_) {
        places_per_cm.push_back(samples().wavenumber_per_cm(node));
        wavelengths_um_.push_back(wavelengthFromWavenumber_um(places_per_cm.back()));
    }
    std::vector<float> values(nodes_.size());
    for (const GasLayer& gas : gases) {
        samples().absorption_per_m(stateOf(gas), nodes_, values);
        std::vector<double>& absorption = absorption_.emplace_back(values.begin(), values.end());
        for (std::size_t i = 0; gas.soot_ppmv > 0.0 && i < nodes_.size(); ++i)
            absorption[i] += sootAbsorption_per_m(wavelengths_um_[i], gas.soot_ppmv * 1e-6);
        planckRadiances_W_m2_sr_um(wavelengths_um_, gas.temperature_K,
                                   planck_.emplace_back(nodes_.size()));
    }
    for (std::size_t c = 0; c < cells_.size(); ++c) {
        const double middle = wavenumbers_per_cm[c], reach = reachOf_per_cm(c);
        const auto from = std::ranges::lower_bound(places_per_cm, middle - reach);
        const auto to = std::ranges::lower_bound(places_per_cm, middle + reach);
        Cell& cell = cells_[c];
        cell.first = static_cast<std::size_t>(from - places_per_cm.begin());
        cell.count = static_cast<std::size_t>(to - from);
    }
}

std::vector<double> GasColumnsLineByLine::transmittance(const AtmosphericState& air,
                                                        double length_m) const {
    std::vector<float> values(nodes_.size());
    if (!nodes_.empty())
        samples().absorption_per_m(air, nodes_, values);
    std::vector<double> transmittance;
    transmittance.reserve(values.size());
    for (const float value : values)
        transmittance.push_back(std::exp(-static_cast<double>(value) * length_m));
    return transmittance;
}

GasColumnsLineByLine::Column GasColumnsLineByLine::of(std::span<const GasStretch> column,
                                                      std::size_t first,
                                                      double background_K) const {
    Column all{std::vector<double>(nodes_.size(), 0.0), std::vector<double>(nodes_.size(), 1.0)};
    std::vector<double>&through = all.transmittance, &radiance = all.radiance;
    for (std::size_t k = 0; k < column.size(); ++k) {
        const std::vector<double>& absorption = absorption_[column[k].gas];
        const std::vector<double>& planck = planck_[column[k].gas];
        const double length_m = column[k].length_m, emits = k >= first ? 1.0 : 0.0;
        for (std::size_t i = 0; i < through.size(); ++i) {
            constexpr double thin = 1e-5; // below it a difference to 1 has too few digits
            const double depth = absorption[i] * length_m, passes = std::exp(-depth);
            const double stops = depth < thin ? depth : 1.0 - passes;
            radiance[i] += emits * through[i] * stops * planck[i];
            through[i] *= passes;
        }
    }
    for (std::size_t i = 0; background_K > 0.0 && i < through.size(); ++i)
        radiance[i] += through[i] * planckRadiance_W_m2_sr_um(wavelengths_um_[i], background_K);
    return all;
}

std::vector<LineCorrelation>
GasColumnsLineByLine::correlations(const Column& column, const std::vector<double>& air) const {
    std::vector<LineCorrelation> correlations(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c)
        if (cells_[c].count >= fewest)
            correlations[c] = {
                correlation(air, column.radiance, cells_[c].first, cells_[c].count),
                correlation(air, column.transmittance, cells_[c].first, cells_[c].count)};
    return correlations;
}

std::vector<LineCorrelation> lineCorrelations(const GasRequest& request,
                                              const std::vector<GasSpectrum::Cell>& cells,
                                              const AtmosphericState& air, double length_m) {
    std::vector<double> middles_per_cm, widths_per_cm;
    for (const GasSpectrum::Cell& cell : cells) {
        middles_per_cm.push_back(0.5 * (cell.lower_per_cm + cell.upper_per_cm));
        widths_per_cm.push_back(cell.upper_per_cm - cell.lower_per_cm);
    }
    std::vector<GasStretch> column;
    for (std::size_t i = 0; i < request.layers.size(); ++i)
        column.push_back({i, request.layers[i].length_m});
    const GasColumnsLineByLine lines(request.layers, middles_per_cm, widths_per_cm);
    return lines.correlations(lines.of(column, 0, request.background_K.value_or(0.0)),
                              lines.transmittance(air, length_m));
}

} // namespace irsg

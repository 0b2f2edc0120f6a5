#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/atmosphere/engine/RadiativeTransfer.h"

/// Air with cross sections that do not depend on pressure and temperature, for closed forms.
namespace irsg::syntheticatmosphere {

/// Nodes of the table: CO2 alone absorbs, from hardly to completely.
enum Node : std::uint32_t { thin, medium, opaque, sunlit, blue };
inline constexpr std::array<double, 5> wavenumbers_per_cm = {1001.0, 1004.0, 1008.0, 5801.0,
                                                             20000.0};
inline constexpr std::array<double, 5> crossSections_cm2 = {1e-26, 1e-22, 3e-14, 2e-24, 1e-33};

inline std::shared_ptr<const GasTable> table() {
    const GasTable::Grid grid{{1100.0, 100.0, 1.0, 1e-3}, {180.0, 250.0, 330.0}, 0.04, 0};
    std::vector<GasTable::Block> blocks;
    for (std::uint32_t node = 0; node < crossSections_cm2.size(); ++node) {
        blocks.push_back(
            {node, Gas::CO2,
             std::vector<float>(grid.points(Gas::CO2),
                                static_cast<float>(std::log(crossSections_cm2[node])))});
    }
    const BinSet bins{5.0,
                      {{1000.0, 1005.0, 0, 2}, {1005.0, 1010.0, 2, 1}},
                      {thin, medium, opaque},
                      {0.25f, 0.75f, 1.0f}};
    return std::make_shared<const GasTable>(
        grid, std::vector<double>(wavenumbers_per_cm.begin(), wavenumbers_per_cm.end()), blocks,
        std::array<BinSet, 3>{bins, bins, bins}, "synthetic");
}

inline constexpr double scaleHeight_m = 8000.0;
inline constexpr double carbonDioxide = 1e-3;

/// Pressure falls exponentially; temperature by `lapse_K_km` up to 12 km.
inline Profile profile(double ground_K = 288.0, double lapse_K_km = 0.0) {
    std::vector<AtmosphericState> levels;
    for (int km = 0; km <= 100; ++km) {
        AtmosphericState air;
        air.altitude_m = 1000.0 * km;
        air.pressure_hPa = 1013.25 * std::exp(-air.altitude_m / scaleHeight_m);
        air.temperature_K = ground_K - lapse_K_km * std::min(km, 12);
        air.moleFraction[static_cast<std::size_t>(Gas::CO2)] = carbonDioxide;
        levels.push_back(air);
    }
    return Profile(std::move(levels), "exponential");
}

/// Particles whose optical properties do not depend on wavelength.
inline ParticleLayer particles(std::vector<double> altitudes_m,
                               std::vector<double> extinction_per_m, double albedo,
                               double asymmetry) {
    const ParticleOptics optics{1.0, 1.0 - albedo, asymmetry};
    return {
        "grey", std::move(altitudes_m), std::move(extinction_per_m), {0.2, 40.0}, {optics, optics}};
}

inline AtmosphericModel model(Profile profile, ScatteringMode mode = ScatteringMode::twoStream) {
    AtmosphericModel air{std::move(profile), {}, 288.0, Spectrum::constant(0.2), mode, 5};
    return air;
}

inline NodeSet nodes(const std::vector<std::uint32_t>& which = {thin, medium, opaque, sunlit,
                                                                blue}) {
    NodeSet set;
    for (const std::uint32_t node : which) {
        set.nodes.push_back(node);
        set.wavenumbers_per_cm.push_back(wavenumbers_per_cm[node]);
    }
    return set;
}

/// Extinction in m-1: CO2 as the table has it, and Rayleigh scattering.
inline double extinction_per_m(const GasTable& table, std::uint32_t node,
                               const AtmosphericState& air) {
    return table.crossSection_cm2(node, Gas::CO2, air) * 1e-4 * air.density_per_m3(Gas::CO2) +
           rayleighScattering_per_m(air, wavenumbers_per_cm[node]);
}

inline constexpr double night_rad = -1.0;
inline constexpr SunPosition night{0.0, night_rad};

} // namespace irsg::syntheticatmosphere

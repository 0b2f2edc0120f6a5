#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

/// The gases of combustion that absorb and emit in the infrared.
enum class HotGas { CO2, H2O, CO, CH4 };
inline constexpr std::size_t hotGasCount = 4;
inline constexpr std::array<const char*, hotGasCount> hotGasNames = {"CO2", "H2O", "CO", "CH4"};

/// What a layer may hold: from a least value to a largest one.
struct GasLayerLimits {
    static constexpr double coldest_K = 250.0, hottest_K = 3000.0;
    static constexpr double thinnest_atm = 0.05, densest_atm = 10.0;
    static constexpr double longest_m = 1e4;
    static constexpr double mostSoot_ppmv = 1000.0;
};

/// A uniform layer of hot gas on a line of sight. The rest of the mole fractions is nitrogen.
struct GasLayer {
    double temperature_K = 300.0; ///< 250 to 3000
    double pressure_atm = 1.0;    ///< total, 0.05 to 10
    double length_m = 0.0;        ///< along the line of sight, above 0, to 10 km
    std::array<double, hotGasCount> moleFraction{};
    double oxygenFraction = 0.0; ///< O2 broadens lines otherwise than nitrogen, and emits nothing
    double soot_ppmv = 0.0;      ///< volume fraction times 1e6, to 1000

    double fraction(HotGas gas) const { return moleFraction[static_cast<std::size_t>(gas)]; }
    double& fraction(HotGas gas) { return moleFraction[static_cast<std::size_t>(gas)]; }
    double nitrogenFraction() const;
    /// Amount of a gas, atm cm at the temperature of the layer: p x L.
    double column_atm_cm(HotGas gas) const;

    bool operator==(const GasLayer&) const = default;
};

/// What is wrong with a layer, each with the name of its key ("T_K", "CO2"); `name` stands for the
/// layer.
std::vector<Diagnostic> gasLayerDiagnostics(const GasLayer& layer, const std::string& name);

} // namespace irsg

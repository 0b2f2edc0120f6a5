#pragma once

#include <array>
#include <cstddef>

namespace irsg {

/// The gases that a profile carries. The first `lineGasCount` absorb in lines and have a place in
/// the GasTable; HNO3 absorbs as a continuum. Nitrogen is what is left of dry air (0.781 of it).
enum class Gas { H2O, CO2, O3, N2O, CO, CH4, O2, HNO3 };
inline constexpr std::size_t gasCount = 8;
inline constexpr std::size_t lineGasCount = 7;
inline constexpr std::array<const char*, gasCount> gasNames = {"H2O", "CO2", "O3", "N2O",
                                                               "CO",  "CH4", "O2", "HNO3"};

/// Air at one point.
struct AtmosphericState {
    double altitude_m = 0.0;
    double pressure_hPa = 1013.25;
    double temperature_K = 288.15;
    std::array<double, gasCount> moleFraction{}; ///< moles of the gas per mole of moist air

    double fraction(Gas gas) const { return moleFraction[static_cast<std::size_t>(gas)]; }
    /// Molecules per m3, p / (k T).
    double airDensity_per_m3() const {
        return pressure_hPa * 100.0 / (1.380649e-23 * temperature_K);
    }
    double density_per_m3(Gas gas) const { return fraction(gas) * airDensity_per_m3(); }
};

} // namespace irsg

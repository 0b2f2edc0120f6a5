#pragma once

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/AirState.h"

/// What the absorbers of Continuum.h have in common, and each of them; for Continuum.cpp alone.
namespace irsg::continuum {

inline constexpr double loschmidt_per_cm3 = 2.686780111e19; ///< at 273.15 K and 1013.25 hPa
inline constexpr double secondRadiation_cm_K = 1.438776877;

inline double heldTemperature_K(const AirState& air) {
    return std::clamp(air.temperature_K, 150.0, 350.0);
}

/// v tanh(c2 v / 2 T), cm-1: v (1 - exp(-x)) / (1 + exp(-x)), x = c2 v / T.
inline double radiationTerm_cm(double wavenumber_cm, double temperature_K) {
    return wavenumber_cm * std::tanh(0.5 * secondRadiation_cm_K * wavenumber_cm / temperature_K);
}

inline double numberPer_cm3(const AirState& air) {
    return air.airDensity_per_m3() * 1e-6;
}

/// Density in amagats: relative to that of a perfect gas at 273.15 K and 1013.25 hPa.
inline double amagats(const AirState& air) {
    return numberPer_cm3(air) / loschmidt_per_cm3;
}

/// Each m-1, 0 outside its range.
double waterSelf_per_m(const AirState& air, double wavenumber_cm);
double waterForeign_per_m(const AirState& air, double wavenumber_cm);
double nitrogen_per_m(const AirState& air, double wavenumber_cm);
double oxygen_per_m(const AirState& air, double wavenumber_cm);
double ozone_per_m(const AirState& air, double wavenumber_cm);
double nitricAcid_per_m(const AirState& air, double wavenumber_cm);

} // namespace irsg::continuum

#pragma once

#include <array>
#include <string>

#include "irsg/atmosphere/engine/AirState.h"

namespace irsg {

/// Absorption that varies slowly with wavenumber: everything that is not lines.
enum class Continuum { waterSelf, waterForeign, nitrogen, oxygen, ozone, nitricAcid };
inline constexpr std::size_t continuumCount = 6;
inline constexpr std::array<const char*, continuumCount> continuumNames = {
    "H2O self continuum",   "H2O foreign continuum",      "N2 collision-induced",
    "O2 collision-induced", "O3 ultraviolet and visible", "HNO3"};

/// m-1 at a wavenumber of 200 to 50000 cm-1, 0 outside a continuum's own range. The line wings
/// beyond 25 cm-1 of water belong here, its lines are cut and have their pedestal removed (see
/// lbl/LineAbsorption.h); everything is 0 where the gas is not. Valid for 150 to 350 K; held
/// beyond.
double continuumAbsorption_per_m(Continuum which, const AirState& air, double wavenumber_cm);
/// All of them.
double continuumAbsorption_per_m(const AirState& air, double wavenumber_cm);

/// Molecular (Rayleigh) scattering, m-1; Bodhaine et al. 1999 or an equal.
double rayleighScattering_per_m(const AirState& air, double wavenumber_cm);

} // namespace irsg

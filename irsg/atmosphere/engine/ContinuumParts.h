#pragma once

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/AtmosphericState.h"
#include "irsg/radiometry/VectorExp.h"

/// What the absorbers of Continuum.h have in common, and each of them; for Continuum.cpp alone.
namespace irsg::continuum {

inline constexpr double loschmidt_per_cm3 = 2.686780111e19; ///< at 273.15 K and 1013.25 hPa
inline constexpr double secondRadiation_cm_K = 1.438776877;

inline double clampedTemperature_K(const AtmosphericState& air) {
    return std::clamp(air.temperature_K, 150.0, 350.0);
}

/// v tanh(c2 v / 2 T), cm-1: v (1 - exp(-x)) / (1 + exp(-x)), x = c2 v / T.
inline double radiationTerm_per_cm(double wavenumber_per_cm, double perTemperature_per_K) {
    const double taken =
        vectorAbsorbed(secondRadiation_cm_K * wavenumber_per_cm * perTemperature_per_K);
    return wavenumber_per_cm * taken / (2.0 - taken);
}

inline double number_per_cm3(const AtmosphericState& air) {
    return air.airDensity_per_m3() * 1e-6;
}

/// Density in amagats: relative to that of a perfect gas at 273.15 K and 1013.25 hPa.
inline double amagats(const AtmosphericState& air) {
    return number_per_cm3(air) / loschmidt_per_cm3;
}

/// What the water continuum is at one wavenumber, 0 outside its range. The logarithm of the self
/// part is linear in temperature (LOWTRAN 7).
struct WaterSpectral {
    double wavenumber_per_cm = 1.0;
    double self296 = 0.0;         ///< 1e-20 cm3
    double lnCooling_per_K = 0.0; ///< ln self rises by so much for every K below 296 K
    double foreign296 = 0.0;      ///< 1e-20 cm3
};
WaterSpectral waterAt(double wavenumber_per_cm);

/// What it is of the air: absorption in m-1 per coefficient and radiation term.
struct WaterAir {
    double cooling_K = 0.0; ///< below 296 K
    double perTemperature_per_K = 0.0;
    double self = 0.0, foreign = 0.0;

    explicit WaterAir(const AtmosphericState& air);
    double self_per_m(const WaterSpectral& at) const {
        return self * at.self296 * vectorExp(at.lnCooling_per_K * cooling_K) *
               radiationTerm_per_cm(at.wavenumber_per_cm, perTemperature_per_K);
    }
    double foreign_per_m(const WaterSpectral& at) const {
        return foreign * at.foreign296 *
               radiationTerm_per_cm(at.wavenumber_per_cm, perTemperature_per_K);
    }
    double both_per_m(const WaterSpectral& at) const {
        return (self * at.self296 * vectorExp(at.lnCooling_per_K * cooling_K) +
                foreign * at.foreign296) *
               radiationTerm_per_cm(at.wavenumber_per_cm, perTemperature_per_K);
    }
};

/// Likewise for collision-induced absorption by nitrogen, whose logarithm is linear in 1/T.
struct NitrogenSpectral {
    double at273 = 0.0; ///< cm-1 amagat-2
    double slope_K = 0.0;
};
NitrogenSpectral nitrogenAt(double wavenumber_per_cm);

struct NitrogenAir {
    double beyond273_per_K = 0.0; ///< 1/T - 1/273.15 K
    double pairs = 0.0;

    explicit NitrogenAir(const AtmosphericState& air);
    double absorption_per_m(const NitrogenSpectral& at) const {
        return pairs * at.at273 * vectorExp(at.slope_K * beyond273_per_K);
    }
};

/// Each m-1, 0 outside its range.
double oxygen_per_m(const AtmosphericState& air, double wavenumber_per_cm);
double ozone_per_m(const AtmosphericState& air, double wavenumber_per_cm);
double nitricAcid_per_m(const AtmosphericState& air, double wavenumber_per_cm);

} // namespace irsg::continuum

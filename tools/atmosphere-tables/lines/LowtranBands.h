#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"

namespace irsg::lbl {

/// LOWTRAN 7's description of a gas at one wavenumber (Kneizys et al. 1988, AFGL-TR-88-0177): the
/// transmittance of an interval of 20 cm-1 around it is exp(-(K W)^a), W = u (p / 1013.25 hPa)^n
/// (273.15 K / T)^m.
struct BandPoint {
    double wavenumber_per_cm = 0.0;
    double coefficient_cm2 = 0.0; ///< K, for u in molecules per cm2; 0: no absorption
    double exponent = 0.0;        ///< a
    double pressureExponent = 0.0;
    double temperatureExponent = 0.0;

    double opticalDepth(double column_per_cm2, double pressure_hPa, double temperature_K) const;
};

/// The molecular bands of LOWTRAN 7 for our line gases.
class LowtranBands {
  public:
    /// Reads `bandmodel_bands.csv` and `bandmodel_cprime.csv` from a folder. Throws InputError
    /// naming what is missing or wrong.
    static LowtranBands read(const std::filesystem::path& folder);

    static constexpr double step_per_cm = 5.0;
    /// Every 5 cm-1 within [lower, upper], those without absorption included.
    std::vector<BandPoint> points(Gas gas, double lower_per_cm, double upper_per_cm) const;

  private:
    std::array<std::vector<BandPoint>, lineGasCount> points_;
};

} // namespace irsg::lbl

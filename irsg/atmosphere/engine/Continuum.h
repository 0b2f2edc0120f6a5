#pragma once

#include <array>
#include <span>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"

namespace irsg {

/// Absorption that varies slowly with wavenumber: everything that is not lines.
enum class Continuum { waterSelf, waterForeign, nitrogen, oxygen, ozone, nitricAcid };
inline constexpr std::size_t continuumCount = 6;
inline constexpr std::array<const char*, continuumCount> continuumNames = {
    "H2O self continuum",   "H2O foreign continuum",      "N2 collision-induced",
    "O2 collision-induced", "O3 ultraviolet and visible", "HNO3"};

/// m-1 at a wavenumber of 200 to 50000 cm-1, 0 outside a continuum's own range and where the gas
/// is not. Valid for 150 to 350 K; clamped beyond.
///
/// Water: LOWTRAN 7 corrected towards a published MODTRAN run, 200 to 20000 cm-1. It holds the
/// line wings beyond 25 cm-1; lines are cut there and have their pedestal removed (see
/// tools/atmosphere-tables/lines/LineAbsorption.h). Nitrogen: rotation below 550 cm-1 and the
/// fundamental, 2010 to 2720 cm-1 (Richard et al. 2012), with N2, O2 and H2O; not the first
/// overtone. Oxygen: the fundamental, the bands at 1.27 and 1.06 um, the pair bands of the visible,
/// the Herzberg continuum; not the Schumann-Runge bands above 49600 cm-1. Ozone: Chappuis, Huggins
/// and Hartley bands. HNO3: three bands. Sources and errors stand in
/// resources/atmosphere/continuum-*.csv.
double continuumAbsorption_per_m(Continuum which, const AtmosphericState& air,
                                 double wavenumber_per_cm);
/// All of them.
double continuumAbsorption_per_m(const AtmosphericState& air, double wavenumber_per_cm);

/// All of them at a few wavenumbers, for many states of the air: what the tables say at the
/// wavenumbers is looked up once.
class ContinuumSpectrum {
  public:
    explicit ContinuumSpectrum(std::vector<double> wavenumbers_per_cm);
    /// m-1, as many as wavenumbers.
    void absorption_per_m(const AtmosphericState& air, std::span<double> out) const;

  private:
    std::vector<double> wavenumbers_per_cm_;
    std::vector<double> waterSelf_, waterCooling_, waterForeign_, nitrogen_, nitrogenSlope_;
    std::vector<std::size_t> others_; ///< where gases besides water and nitrogen absorb
};

/// Molecular (Rayleigh) scattering, m-1, by the formula of LOWTRAN 7. Against Bodhaine et al. 1999
/// (J. Atmos. Ocean. Technol. 16, 1854) within 0.6 % from 0.3 to 1 um, 1.2 % less at 0.25 um and
/// 3 % less at 0.2 um.
double rayleighScattering_per_m(const AtmosphericState& air, double wavenumber_per_cm);

} // namespace irsg

#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "irsg/atmosphere/engine/NodeColumn.h"
#include "irsg/atmosphere/engine/SunPaths.h"
#include "irsg/atmosphere/engine/TwoStream.h"
#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// Direct and diffuse light at every level of a column of air over a Lambertian ground, from the
/// two-stream solution of plane parallel layers; the beam of the sun follows its refracted path
/// through spherical shells. Computed when first asked for and kept, light of the sun for the last
/// few elevations. Const members may be called from several threads.
///
/// The phase function is delta scaled: of the scattering of every kind of particles the part
/// asymmetry^2 stays in the beam, and the rest has the asymmetry g / (1 + g).
class DiffuseLight {
  public:
    struct Ground {
        double temperature_K = 288.15;
        Spectrum albedo; ///< over wavelength, 0 to 1
    };
    DiffuseLight(const NodeColumn& column, Ground ground);

    /// Everything that one elevation of the sun gives, [level][node].
    struct Sunlight {
        double elevation_rad = 0.0, strength = 1.0;
        std::vector<double> direct; ///< normal to the beam, W m-2 um-1
        std::vector<double> scaled; ///< with what is scattered nearly forward
        TwoStreamFluxes fluxes;     ///< diffuse: what is not in `scaled`
    };
    std::shared_ptr<const TwoStreamFluxes> thermal() const;
    std::shared_ptr<const Sunlight> sunlight(const SunPaths& sun) const;

    /// Light of the diffuse field that a level scatters, as ScatteredEmission has it: scattering
    /// times J + 3 g mu H, with the mean intensity J and its first moment H of the fluxes,
    /// J = (F+ + F-) / 2 pi for heat and sqrt(3) (F+ + F-) / 4 pi for light of the sun,
    /// H = (F+ - F-) / 4 pi. `sun` may be null.
    void scattered(std::size_t level, const TwoStreamFluxes& thermal, const Sunlight* sun,
                   std::span<double> mean, std::span<double> slope) const;

  private:
    TwoStreamFluxes solveThermal() const;
    Sunlight solveSunlight(const SunPaths& sun) const;

    const NodeColumn& column_;
    Ground ground_;
    std::vector<double> albedo_;
    mutable std::mutex mutex_;
    mutable std::shared_ptr<const TwoStreamFluxes> thermal_;
    static constexpr std::size_t elevationsKept = 3;
    mutable RecentlyUsed<std::shared_ptr<const Sunlight>> sunlight_{elevationsKept};
};

/// A row at an altitude from rows at all levels ([level][node]): cubic between levels, monotone
/// where the rows are (slopes of Fritsch and Butland 1984, SIAM J. Sci. Stat. Comput. 5, 300).
void interpolateLevels(const AtmosphericColumn& air, std::span<const double> levels,
                       double altitude_m, std::span<double> out);

} // namespace irsg

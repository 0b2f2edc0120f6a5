#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Atmosphere.h"

namespace irsg {

/// What describes a homogeneous atmosphere.
struct BeerLambertParameters {
    std::string name = "Beer-Lambert";
    Spectrum extinction_per_m;                      ///< absorption, m-1, >= 0
    double airTemperature_K = 288.15;               ///< the air emits as a black body of this
    double groundTemperature_K = 288.15;            ///< lines of sight that go down end on it
    Spectrum solarIrradiance_W_m2_um;               ///< at every altitude, normal to the beam
    Spectrum downwardFlux_W_m2_um;                  ///< from the sky, at every altitude
    Spectrum upwardFlux_W_m2_um;                    ///< from the ground, at every altitude
    std::optional<Spectrum> skyRadiance_W_m2_sr_um; ///< behind the air, of upward lines of sight
};

/// How closely the spectra of this air follow its curves, see CurveSampling.h.
inline constexpr double atmosphereTolerance = 1e-5;
inline constexpr double atmosphereFloor = 1e-3;

/// Homogeneous air (Beer-Lambert's law): tau = exp(-extinction range), path radiance
/// (1 - tau) L_bb(T_air), and a sun, a sky and a ground that do not change with altitude. The earth
/// is flat here: a downward line of sight ends after h / sin(depression) m on a black ground at
/// T_ground; a horizontal or upward one ends in opaque air wherever the extinction is not zero, and
/// on the sky radiance (0 where there is none) where it is. Nothing scatters.
///
/// The extinction is linear between its nodes, and tau is the exponential of that line, not a line:
/// returned spectra keep the nodes of the extinction and have as many between them as straight
/// pieces need to follow the exponential and the Planck function to `atmosphereTolerance` of the
/// local value (or of `atmosphereFloor` of the largest): a few thousand nodes for 5 km of hazy air
/// in 3-5 um, ten times fewer than 1e-6 would take. The base is what all sampled spectra cover, 0.2
/// to 40 um where all are constant.
class BeerLambert : public Atmosphere {
  public:
    /// Throws InputError for negative extinction, flux or temperature, and for spectra that have no
    /// wavelength in common.
    explicit BeerLambert(BeerLambertParameters parameters);
    /// Reads `FILE.csv`: `# key: value` lines (`name`, `air_temperature [K]`,
    /// `ground_temperature [K]`, `sky_temperature [K]`, `sun` = nominal|none, `note`, `source`),
    /// then a header row and columns in any order: `wavelength [um]`, `extinction [km-1]` and, each
    /// where present, `solar_irradiance [W m-2 um-1]`, `down_flux [W m-2 um-1]`, `up_flux [W m-2
    /// um-1]`, `sky_radiance [W m-2 sr-1 um-1]`. A comment whose key is one word of lower-case
    /// letters and underscores, with or without a unit, and none of these keys, is a diagnostic;
    /// every other comment is free text. Fluxes that are not given are those of black hemispheres:
    /// pi L_bb(sky or air temperature) down, pi L_bb(ground temperature) up. Ground that has no
    /// temperature has that of the air. The sky radiance that
    /// is not given is L_bb(sky temperature) where there is one. The sun that is not given is that
    /// of Vacuum. Throws InputError naming every diagnostic with its line.
    static BeerLambert fromCsv(const std::filesystem::path& file);

    const BeerLambertParameters& parameters() const { return parameters_; }

    std::string name() const override { return parameters_.name; }
    SpectralRange base() const override { return base_; }
    bool supports(AtmosphereProperty) const override { return true; }
    /// Flat ground without an end.
    double horizonElevation_rad(double) const override { return 0.0; }
    double ambientTemperature_K(double altitude_m) const override;
    AtmosphereDescription describe() const override;

    /// Quadrature points are wavelengths, at which the closed forms answer.
    bool isWidebandModeAvailable() const override { return true; }
    std::shared_ptr<const SensorCkData> prepareCk(const CkRequest& request) const override;

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override;
    std::vector<double> valuesAtPoints(const AtmosphericQuery& query,
                                       const SensorCkData& points) const override;

  private:
    /// The nodes of the extinction in `range` and the ends of it.
    std::vector<double> kinks(const SpectralRange& range) const;
    Spectrum through(double range_m, const SpectralRange& range) const;
    Spectrum emittedAlong(double range_m, const SpectralRange& range) const;
    Spectrum seenAlong(const LineOfSight& sight, const SpectralRange& range) const;
    Spectrum unboundedRadiance(const SpectralRange& range) const;
    /// The answer at single wavelengths.
    std::vector<double> valuesAt(const AtmosphericQuery& query,
                                 const std::vector<double>& wavelengths_um) const;
    /// Wavelengths around a range between which no answer bends more than quadrature points need.
    std::vector<double> candidates(const SpectralRange& range) const;

    BeerLambertParameters parameters_;
    SpectralRange base_;
};

} // namespace irsg

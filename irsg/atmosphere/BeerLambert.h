#pragma once

#include <filesystem>
#include <optional>

#include "irsg/atmosphere/Atmosphere.h"

namespace irsg {

/// What describes a homogeneous atmosphere.
struct BeerLambertParameters {
    std::string name = "Beer-Lambert";
    Spectrum extinction_per_m;                 ///< absorption, m-1, >= 0
    double airTemperature_K = 288.15;          ///< the air emits as a black body of this
    double groundTemperature_K = 288.15;       ///< lines of sight that go down end on it
    Spectrum solarIrradiance_W_m2_um;          ///< at every altitude, normal to the beam
    Spectrum downwardFlux_W_m2_um;             ///< from the sky, at every altitude
    Spectrum upwardFlux_W_m2_um;               ///< from the ground, at every altitude
    std::optional<Spectrum> skyRadiance_W_m2_sr_um; ///< behind the air, of upward lines of sight
};

/// Homogeneous air: tau = exp(-extinction range), path radiance (1 - tau) L_bb(T_air), and a sun, a
/// sky and a ground that do not change with altitude. An unbounded horizontal or upward path ends in
/// opaque air wherever the extinction is not zero; a downward one ends on the ground at T_ground.
class BeerLambert : public Atmosphere {
  public:
    /// Throws InputError for negative extinction, flux or temperature.
    explicit BeerLambert(BeerLambertParameters parameters);
    /// Reads `FILE.csv`: `# key: value` lines (name, air_temperature [K], ground_temperature [K],
    /// sky_temperature [K], sun: nominal|none), then a header row and columns
    /// `wavelength [um]`, `extinction [km-1]` and, each where present,
    /// `solar_irradiance [W m-2 um-1]`, `down_flux [W m-2 um-1]`, `up_flux [W m-2 um-1]`,
    /// `sky_radiance [W m-2 sr-1 um-1]`. Fluxes that are not given are those of black hemispheres:
    /// pi L_bb(sky or air temperature) down, pi L_bb(ground temperature) up. The sun that is not
    /// given is that of Vacuum. Throws InputError naming every offence with its line.
    static BeerLambert fromCsv(const std::filesystem::path& file);

    const BeerLambertParameters& parameters() const { return parameters_; }

    std::string name() const override { return parameters_.name; }
    SpectralRange base() const override;
    bool supports(AtmosphereProperty) const override { return true; }
    Spectrum transmittance(const AirPath& path, const SpectralRange& range) const override;
    Spectrum pathRadiance(const AirPath& path, const SunPosition& sun,
                          const SpectralRange& range) const override;
    Spectrum backgroundRadiance(const LineOfSight& sight, const SunPosition& sun,
                                const SpectralRange& range) const override;
    Spectrum solarIrradiance(double altitude_m, const SunPosition& sun,
                             const SpectralRange& range) const override;
    Spectrum upwardFlux(double altitude_m, const SunPosition& sun,
                        const SpectralRange& range) const override;
    Spectrum downwardFlux(double altitude_m, const SunPosition& sun,
                          const SpectralRange& range) const override;
    double ambientTemperature_K(double altitude_m) const override;

  private:
    BeerLambertParameters parameters_;
};

} // namespace irsg

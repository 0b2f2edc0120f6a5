#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "irsg/atmosphere/Atmosphere.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

/// What describes air that is known for one geometry: the spectra and what they were made for.
struct SpectraAtmosphereParameters {
    std::string name = "spectra";
    /// In the units of Atmosphere, each over the same range; not the ambient temperature.
    std::map<AtmosphereProperty, Spectrum> spectra;
    /// Transmittance of the last so many metres of the path, m, up to the target: what the
    /// radiation of a spectrum measured from there had passed (UserSpectrum::referenceDistance_m).
    std::map<double, Spectrum> lastTransmittance;
    std::optional<AtmosphericPath> path;    ///< of transmittance, path radiance, scattering
    std::optional<LineOfSight> sight;       ///< of the background
    std::optional<double> targetAltitude_m; ///< of sun, fluxes and ambient temperature
    std::optional<SunPosition> sun;         ///< of everything the sun has a part in
    std::optional<double> ambientTemperature_K;
};

/// Air that answers with fixed spectra: a radiative output (F51) as the input of an analysis. It
/// supports the quantities it has a spectrum of, over the range that all of them cover, and accepts
/// one geometry. Anything else is an InputError that names what differs.
///
/// Scenes are flat and paths are spherical, so that sensor, target and range fix the altitudes to
/// R^2 / (2 R_earth) and the elevation to R / (2 R_earth) only (0.08 m and 0.08 mrad at 1 km).
/// Accepted are altitudes that differ by no more than that and `altitudeTolerance_m`, elevations
/// by no more than that and `angleTolerance_rad`, ranges by no more than `rangeTolerance` of the
/// range. The sun's elevation and, for the background, its azimuth from the line of sight may
/// differ by `angleTolerance_rad`; with the sun below the horizon in both its place is no matter.
class SpectraAtmosphere : public Atmosphere {
  public:
    static constexpr double altitudeTolerance_m = 1.0;
    static constexpr double rangeTolerance = 1e-4;
    static constexpr double angleTolerance_rad = radians(0.01);

    /// Throws InputError for no spectrum at all, a quantity without its geometry, negative values,
    /// transmittances above 1 and spectra without a common range.
    explicit SpectraAtmosphere(SpectraAtmosphereParameters parameters);

    /// Reads what `smat-batch radiative` writes: comments `# analysis: radiative`, `# atmosphere:
    /// name`, `# sensor_altitude [m]`, `# target_altitude [m]`, `# range [m]`, `# los_elevation
    /// [deg]`, `# los_azimuth [deg]`, `# sun_azimuth [deg]`, `# sun_elevation [deg]`, `#
    /// ambient_temperature [K]`, each where a column needs it, then a header row and the columns
    /// `wavelength [um]` (strictly ascending or descending) and at least one of `transmittance`,
    /// `path_radiance [W m-2 sr-1 um-1]`, `background_radiance [W m-2 sr-1 um-1]`,
    /// `transmittance_last_50m` (of the last 50 m of the path, for any number),
    /// `solar_irradiance [W m-2 um-1]`, `up_flux [W m-2 um-1]`, `down_flux [W m-2 um-1]`,
    /// `scattering_optical_depth`. A column `wavenumber [cm-1]` must agree with the wavelengths to
    /// a millionth. Throws InputError naming every diagnostic with its line.
    static SpectraAtmosphere fromCsv(const std::filesystem::path& file);
    /// True where the comments ahead of the first row say `analysis: radiative`; false for any
    /// other file and for one that cannot be read.
    static bool isSpectraCsv(const std::filesystem::path& file);

    const SpectraAtmosphereParameters& parameters() const { return parameters_; }

    std::string name() const override { return parameters_.name; }
    SpectralRange base() const override { return base_; }
    bool supports(AtmosphereProperty property) const override;
    double ambientTemperature_K(double altitude_m) const override;
    /// The background depends on the azimuth from the sun: another one is refused.
    bool dependsOnAzimuth(AtmosphereProperty property) const override {
        return property == AtmosphereProperty::backgroundRadiance;
    }
    AtmosphereDescription describe() const override;
    /// Quadrature points pay where many lines of sight are asked; this air knows one, at its own
    /// nodes.
    std::string widebandRefusal() const override {
        return "has no wideband mode: it knows one line of sight, so that there is nothing to "
               "train quadrature points on but the answer itself";
    }

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override;

  private:
    double altitudeSlack_m() const;
    double elevationSlack_rad() const;
    void requireNear(const char* what, double found, double held, double slack, double perUnit,
                     const char* unit) const;
    void requirePath(const AtmosphericPath& path) const;
    void requireSight(const LineOfSight& sight, const SunPosition& sun) const;
    void requireTargetAltitude(double altitude_m) const;
    void requireSunElevation(const SunPosition& sun) const;

    SpectraAtmosphereParameters parameters_;
    SpectralRange base_;
};

} // namespace irsg

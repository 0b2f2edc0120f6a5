#pragma once

#include <memory>
#include <string>
#include <vector>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

class SensorCkData;
struct CkRequest;

/// What a scene may ask of the air. A scene never sees a gas.
enum class AtmosphereProperty {
    transmittance,
    pathRadiance,
    backgroundRadiance,
    solarIrradiance,
    upwardFlux,
    downwardFlux,
    ambientTemperature,
    scatteringOpticalDepth
};
inline constexpr AtmosphereProperty allAtmosphereProperties[] = {
    AtmosphereProperty::transmittance,      AtmosphereProperty::pathRadiance,
    AtmosphereProperty::backgroundRadiance, AtmosphereProperty::solarIrradiance,
    AtmosphereProperty::upwardFlux,         AtmosphereProperty::downwardFlux,
    AtmosphereProperty::ambientTemperature, AtmosphereProperty::scatteringOpticalDepth};
/// "path radiance".
const char* name(AtmosphereProperty property);

/// A finite path from a sensor to a target. Scene geometry is flat; these three numbers fix the
/// spherical path. Altitudes are above the ground, >= 0.
struct AirPath {
    double sensorAltitude_m = 0.0;
    double targetAltitude_m = 0.0;
    double range_m = 0.0;
};

/// An unbounded line of sight: to space, or to the ground where it meets it.
struct LineOfSight {
    double sensorAltitude_m = 0.0;
    double elevation_rad = 0.0; ///< above the local horizontal, up positive
    double azimuth_rad = 0.0;   ///< east of north
};

/// Where the sun stands.
struct SunPosition {
    double azimuth_rad = 0.0;      ///< east of north, 0 to 2 pi
    double elevation_rad = 0.7854; ///< -pi/2 to pi/2

    bool isUp() const { return elevation_rad > 0.0; }
};

/// The seam between a scene and its air (report section 5, F13, F14). Spectral quantities come as
/// spectra over at least the asked range, in W, m, sr and um. An implementation answers only what
/// it accepts; asking for more is a LogicError.
class Atmosphere {
  public:
    virtual ~Atmosphere() = default;

    /// How results and the log call it: "vacuum", "Beer-Lambert (haze.csv)".
    virtual std::string name() const = 0;
    /// The spectral base: what this atmosphere has data for.
    virtual SpectralRange base() const = 0;
    virtual bool supports(AtmosphereProperty property) const = 0;
    /// Why a property is not supported, in words that follow the name: "has no upward flux".
    virtual std::string refusal(AtmosphereProperty property) const;
    /// What a user should know about the settings and data it was made of.
    virtual std::vector<std::string> remarks() const { return {}; }
    /// False if the property is not supported; else true only if the base holds the whole range.
    bool accept(const SpectralRange& range, AtmosphereProperty property) const {
        return supports(property) && base().contains(range);
    }

    /// Apparent elevation of the horizon for a sensor at an altitude: lines of sight below it end
    /// on the ground. The dip of a sphere of 6371.23 km without refraction, unless an atmosphere
    /// has a geometry of its own.
    virtual double horizonElevation_rad(double altitude_m) const;

    /// 0 to 1; 1 at range 0.
    virtual Spectrum transmittance(const AirPath& path, const SpectralRange& range) const;
    /// Emitted and scattered into the path, W m-2 sr-1 um-1; 0 at range 0.
    virtual Spectrum pathRadiance(const AirPath& path, const SunPosition& sun,
                                  const SpectralRange& range) const;
    /// Everything seen along an unbounded line of sight with no target in it, W m-2 sr-1 um-1.
    virtual Spectrum backgroundRadiance(const LineOfSight& sight, const SunPosition& sun,
                                        const SpectralRange& range) const;
    /// Direct sun on a plane normal to the beam at an altitude, W m-2 um-1; 0 below the horizon.
    virtual Spectrum solarIrradiance(double altitude_m, const SunPosition& sun,
                                     const SpectralRange& range) const;
    /// Diffuse hemispherical fluxes on a horizontal plane, W m-2 um-1. The downward flux excludes
    /// the direct beam, the upward flux includes reflected sun.
    virtual Spectrum upwardFlux(double altitude_m, const SunPosition& sun,
                                const SpectralRange& range) const;
    virtual Spectrum downwardFlux(double altitude_m, const SunPosition& sun,
                                  const SpectralRange& range) const;
    virtual double ambientTemperature_K(double altitude_m) const;
    /// Optical depth of a path by scattering alone, which blurs (absorption by gases does not); >=
    /// 0.
    virtual Spectrum scatteringOpticalDepth(const AirPath& path, const SpectralRange& range) const;

    /// True where this atmosphere can prepare wideband terms (F14, F17).
    virtual bool isWidebandModeAvailable() const { return false; }
    /// The wideband terms of a sensor: see SensorCkData.h. LogicError where they are not available.
    virtual std::shared_ptr<const SensorCkData> prepareCk(const CkRequest& request) const;
    /// The wideband twins of the spectral quantities: one value a term of data that this atmosphere
    /// prepared, in the units of the spectral ones.
    virtual std::vector<double> ckTransmittance(const AirPath& path, const SensorCkData& ck) const;
    virtual std::vector<double> ckPathRadiance(const AirPath& path, const SunPosition& sun,
                                               const SensorCkData& ck) const;
    virtual std::vector<double> ckBackgroundRadiance(const LineOfSight& sight,
                                                     const SunPosition& sun,
                                                     const SensorCkData& ck) const;
    virtual std::vector<double> ckSolarIrradiance(double altitude_m, const SunPosition& sun,
                                                  const SensorCkData& ck) const;
    virtual std::vector<double> ckUpwardFlux(double altitude_m, const SunPosition& sun,
                                             const SensorCkData& ck) const;
    virtual std::vector<double> ckDownwardFlux(double altitude_m, const SunPosition& sun,
                                               const SensorCkData& ck) const;

  protected:
    /// What every implementation asks of its arguments. LogicError unless the base holds the range;
    /// InputError for a path, a line of sight or an altitude below ground, a negative range or
    /// anything that is not finite.
    void checkRange(const SpectralRange& range) const;
    void checkPath(const AirPath& path) const;
    void checkSight(const LineOfSight& sight) const;
    void checkAltitude(double altitude_m, const char* what = "altitude") const;
};

} // namespace irsg

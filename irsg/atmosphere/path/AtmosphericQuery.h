#pragma once

#include <array>
#include <compare>

namespace irsg {

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

/// The geometry that a quantity has: a finite path, an unbounded line of sight, or an altitude.
enum class QueryGeometry { path, sight, altitude };
QueryGeometry geometryOf(AtmosphereProperty property);
/// True for what the sun has a part in.
bool hasSun(AtmosphereProperty property);

/// A finite path from a sensor to a target. Scene geometry is flat; altitudes and range fix the
/// spherical path, the azimuth where the sun stands beside it. Altitudes are above the ground, >=
/// 0.
struct AtmosphericPath {
    double sensorAltitude_m = 0.0;
    double targetAltitude_m = 0.0;
    double range_m = 0.0;
    double azimuth_rad = 0.0; ///< of the view from sensor to target, east of north
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
    double elevation_rad = 0.7854; ///< -pi/2 to pi/2, true: of its middle, as without refraction
    double distance_au = 1.0;      ///< 0.983 to 1.017 over a year

    /// Above the horizontal, which is not the horizon: from aloft it is seen below.
    bool isUp() const { return elevation_rad > 0.0; }
    /// Its light in terms of that from one astronomical unit.
    double strength() const { return 1.0 / (distance_au * distance_au); }
    bool operator==(const SunPosition&) const = default;
};

/// The sun as it is seen from an altitude.
struct SunView {
    double part = 1.0;          ///< of its disc that is above the horizon, 0 to 1
    double elevation_rad = 0.0; ///< apparent, of the middle of the whole disc
};

/// How the target at the end of a path is seen by its sensor.
struct TargetView {
    double elevation_rad = 0.0; ///< apparent, at the sensor; of a hidden target that of the horizon
    /// Altitude at that range below which the ground hides everything; 0 up to the horizon.
    double hiddenBelow_m = 0.0;
};
/// Over flat ground along a straight line: elevation asin((target - sensor) / range), nothing is
/// hidden.
TargetView flatTargetView(const AtmosphericPath& path);
/// Over a sphere of `earthRadius_m` along a straight line.
TargetView sphericalTargetView(const AtmosphericPath& path);

/// A query as far as its answer depends on it: a key of a cache. Equal keys have equal answers
/// of the same atmosphere at the same sampling.
struct AtmosphericQueryKey {
    AtmosphereProperty quantity = AtmosphereProperty::transmittance;
    /// Sensor altitude, target altitude, range, elevation, azimuth from the sun, elevation and
    /// distance of the sun; 0 where the quantity has no such number.
    std::array<double, 7> numbers{};
    auto operator<=>(const AtmosphericQueryKey&) const = default;
};

/// One quantity of the air at one geometry under one sun. Of the three places only that of the
/// quantity counts, and the sun only where it has a part.
struct AtmosphericQuery {
    AtmosphereProperty quantity = AtmosphereProperty::transmittance;
    AtmosphericPath path = {};
    LineOfSight sight = {};
    double altitude_m = 0.0;
    SunPosition sun = {};

    static AtmosphericQuery transmittance(const AtmosphericPath& path);
    static AtmosphericQuery pathRadiance(const AtmosphericPath& path, const SunPosition& sun);
    static AtmosphericQuery backgroundRadiance(const LineOfSight& sight, const SunPosition& sun);
    static AtmosphericQuery solarIrradiance(double altitude_m, const SunPosition& sun);
    static AtmosphericQuery upwardFlux(double altitude_m, const SunPosition& sun);
    static AtmosphericQuery downwardFlux(double altitude_m, const SunPosition& sun);
    static AtmosphericQuery scatteringOpticalDepth(const AtmosphericPath& path);

    /// Azimuth between the view and the sun, 0 to pi: the air is the same all around, and left and
    /// right of the sun are alike. 0 for what has no direction.
    double azimuthFromSun_rad() const;
    /// `byAzimuth`: whether the answer depends on that angle; see Atmosphere::dependsOnAzimuth.
    AtmosphericQueryKey key(bool byAzimuth) const;
};

} // namespace irsg

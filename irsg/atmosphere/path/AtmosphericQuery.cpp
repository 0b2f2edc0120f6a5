#include "irsg/atmosphere/path/AtmosphericQuery.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/path/Earth.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

const char* name(AtmosphereProperty property) {
    switch (property) {
    case AtmosphereProperty::transmittance:
        return "transmittance";
    case AtmosphereProperty::pathRadiance:
        return "path radiance";
    case AtmosphereProperty::backgroundRadiance:
        return "background radiance";
    case AtmosphereProperty::solarIrradiance:
        return "solar irradiance";
    case AtmosphereProperty::upwardFlux:
        return "upward flux";
    case AtmosphereProperty::downwardFlux:
        return "downward flux";
    case AtmosphereProperty::ambientTemperature:
        return "ambient temperature";
    case AtmosphereProperty::scatteringOpticalDepth:
        return "scattering optical depth";
    }
    throw LogicError("unknown atmosphere property");
}

QueryGeometry geometryOf(AtmosphereProperty property) {
    switch (property) {
    case AtmosphereProperty::transmittance:
    case AtmosphereProperty::pathRadiance:
    case AtmosphereProperty::scatteringOpticalDepth:
        return QueryGeometry::path;
    case AtmosphereProperty::backgroundRadiance:
        return QueryGeometry::sight;
    default:
        return QueryGeometry::altitude;
    }
}

bool hasSun(AtmosphereProperty property) {
    return property != AtmosphereProperty::transmittance &&
           property != AtmosphereProperty::scatteringOpticalDepth &&
           property != AtmosphereProperty::ambientTemperature;
}

TargetView flatTargetView(const AtmosphericPath& path) {
    const double rise_m = path.targetAltitude_m - path.sensorAltitude_m;
    return {path.range_m > 0.0 ? std::asin(std::clamp(rise_m / path.range_m, -1.0, 1.0)) : 0.0,
            0.0};
}

TargetView sphericalTargetView(const AtmosphericPath& path) {
    constexpr double R = earthRadius_m;
    const double sensor_m = path.sensorAltitude_m, range_m = path.range_m;
    const double toHorizon_m = std::sqrt(sensor_m * (2.0 * R + sensor_m));
    double target_m = path.targetAltitude_m, hidden_m = 0.0;
    if (range_m > toHorizon_m) {
        // The line that touches the ground rises by this behind the horizon.
        const double behind_m = range_m - toHorizon_m;
        hidden_m = behind_m * behind_m / (R + std::sqrt(R * R + behind_m * behind_m));
        target_m = std::max(target_m, hidden_m);
    }
    if (!(range_m > 0.0))
        return {0.0, hidden_m};
    const double sine =
        ((target_m - sensor_m) * (2.0 * R + sensor_m + target_m) - range_m * range_m) /
        (2.0 * (R + sensor_m) * range_m);
    return {std::asin(std::clamp(sine, -1.0, 1.0)), hidden_m};
}

AtmosphericQuery AtmosphericQuery::transmittance(const AtmosphericPath& path) {
    return {.quantity = AtmosphereProperty::transmittance, .path = path};
}

AtmosphericQuery AtmosphericQuery::pathRadiance(const AtmosphericPath& path,
                                                const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::pathRadiance, .path = path, .sun = sun};
}

AtmosphericQuery AtmosphericQuery::backgroundRadiance(const LineOfSight& sight,
                                                      const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::backgroundRadiance, .sight = sight, .sun = sun};
}

AtmosphericQuery AtmosphericQuery::solarIrradiance(double altitude_m, const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::solarIrradiance, .altitude_m = altitude_m, .sun = sun};
}

AtmosphericQuery AtmosphericQuery::upwardFlux(double altitude_m, const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::upwardFlux, .altitude_m = altitude_m, .sun = sun};
}

AtmosphericQuery AtmosphericQuery::downwardFlux(double altitude_m, const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::downwardFlux, .altitude_m = altitude_m, .sun = sun};
}

AtmosphericQuery AtmosphericQuery::scatteringOpticalDepth(const AtmosphericPath& path) {
    return {.quantity = AtmosphereProperty::scatteringOpticalDepth, .path = path};
}

double AtmosphericQuery::azimuthFromSun_rad() const {
    const QueryGeometry place = geometryOf(quantity);
    if (place == QueryGeometry::altitude)
        return 0.0;
    const double view_rad = place == QueryGeometry::path ? path.azimuth_rad : sight.azimuth_rad;
    return std::abs(std::remainder(view_rad - sun.azimuth_rad, 2.0 * pi));
}

AtmosphericQueryKey AtmosphericQuery::key(bool byAzimuth) const {
    AtmosphericQueryKey key{quantity, {}};
    auto& [sensor_m, target_m, range_m, elevation_rad, azimuth_rad, sun_rad, sun_au] = key.numbers;
    switch (geometryOf(quantity)) {
    case QueryGeometry::path:
        sensor_m = path.sensorAltitude_m;
        target_m = path.targetAltitude_m;
        range_m = path.range_m;
        break;
    case QueryGeometry::sight:
        sensor_m = sight.sensorAltitude_m;
        elevation_rad = sight.elevation_rad;
        break;
    case QueryGeometry::altitude:
        target_m = altitude_m;
        break;
    }
    if (hasSun(quantity)) {
        sun_rad = sun.elevation_rad;
        sun_au = sun.distance_au;
        azimuth_rad = byAzimuth ? azimuthFromSun_rad() : 0.0;
    }
    return key;
}

} // namespace irsg

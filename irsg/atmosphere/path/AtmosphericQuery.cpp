#include "irsg/atmosphere/path/AtmosphericQuery.h"

#include <cmath>

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

#include "irsg/atmosphere/AirQuestion.h"

#include <cmath>

#include "irsg/radiometry/Errors.h"
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

AirPlace placeOf(AtmosphereProperty property) {
    switch (property) {
    case AtmosphereProperty::transmittance:
    case AtmosphereProperty::pathRadiance:
    case AtmosphereProperty::scatteringOpticalDepth:
        return AirPlace::path;
    case AtmosphereProperty::backgroundRadiance:
        return AirPlace::sight;
    default:
        return AirPlace::altitude;
    }
}

bool hasSun(AtmosphereProperty property) {
    return property != AtmosphereProperty::transmittance &&
           property != AtmosphereProperty::scatteringOpticalDepth &&
           property != AtmosphereProperty::ambientTemperature;
}

AirQuestion AirQuestion::transmittance(const AirPath& path) {
    return {.quantity = AtmosphereProperty::transmittance, .path = path};
}

AirQuestion AirQuestion::pathRadiance(const AirPath& path, const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::pathRadiance, .path = path, .sun = sun};
}

AirQuestion AirQuestion::backgroundRadiance(const LineOfSight& sight, const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::backgroundRadiance, .sight = sight, .sun = sun};
}

AirQuestion AirQuestion::solarIrradiance(double altitude_m, const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::solarIrradiance, .altitude_m = altitude_m, .sun = sun};
}

AirQuestion AirQuestion::upwardFlux(double altitude_m, const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::upwardFlux, .altitude_m = altitude_m, .sun = sun};
}

AirQuestion AirQuestion::downwardFlux(double altitude_m, const SunPosition& sun) {
    return {.quantity = AtmosphereProperty::downwardFlux, .altitude_m = altitude_m, .sun = sun};
}

AirQuestion AirQuestion::scatteringOpticalDepth(const AirPath& path) {
    return {.quantity = AtmosphereProperty::scatteringOpticalDepth, .path = path};
}

double AirQuestion::azimuthFromSun_rad() const {
    const AirPlace place = placeOf(quantity);
    if (place == AirPlace::altitude)
        return 0.0;
    const double view_rad = place == AirPlace::path ? path.azimuth_rad : sight.azimuth_rad;
    return std::abs(std::remainder(view_rad - sun.azimuth_rad, 2.0 * pi));
}

AirKey AirQuestion::key(bool byAzimuth) const {
    AirKey key{quantity, {}};
    auto& [sensor_m, target_m, range_m, elevation_rad, azimuth_rad, sun_rad, sun_au] = key.numbers;
    switch (placeOf(quantity)) {
    case AirPlace::path:
        sensor_m = path.sensorAltitude_m;
        target_m = path.targetAltitude_m;
        range_m = path.range_m;
        break;
    case AirPlace::sight:
        sensor_m = sight.sensorAltitude_m;
        elevation_rad = sight.elevation_rad;
        break;
    case AirPlace::altitude:
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

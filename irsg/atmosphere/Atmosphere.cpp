#include "irsg/atmosphere/Atmosphere.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

[[noreturn]] void refuse(const Atmosphere& atmosphere, AtmosphereProperty property) {
    throw LogicError("the atmosphere " + atmosphere.name() + " was asked for its " +
                     name(property) + ", which it does not support: it " +
                     atmosphere.refusal(property));
}

} // namespace

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

std::string Atmosphere::refusal(AtmosphereProperty property) const {
    return std::string("has no ") + irsg::name(property);
}

double Atmosphere::horizonElevation_rad(double altitude_m) const {
    // cos(dip) = R / (R + h); by the tangent, which keeps its digits near the ground.
    constexpr double earthRadius_m = 6371.23e3;
    const double h_m = std::max(altitude_m, 0.0);
    return -std::atan(std::sqrt(h_m * (2.0 * earthRadius_m + h_m)) / earthRadius_m);
}

Spectrum Atmosphere::transmittance(const AirPath&, const SpectralRange&) const {
    refuse(*this, AtmosphereProperty::transmittance);
}

Spectrum Atmosphere::pathRadiance(const AirPath&, const SunPosition&, const SpectralRange&) const {
    refuse(*this, AtmosphereProperty::pathRadiance);
}

Spectrum Atmosphere::backgroundRadiance(const LineOfSight&, const SunPosition&,
                                        const SpectralRange&) const {
    refuse(*this, AtmosphereProperty::backgroundRadiance);
}

Spectrum Atmosphere::solarIrradiance(double, const SunPosition&, const SpectralRange&) const {
    refuse(*this, AtmosphereProperty::solarIrradiance);
}

Spectrum Atmosphere::upwardFlux(double, const SunPosition&, const SpectralRange&) const {
    refuse(*this, AtmosphereProperty::upwardFlux);
}

Spectrum Atmosphere::downwardFlux(double, const SunPosition&, const SpectralRange&) const {
    refuse(*this, AtmosphereProperty::downwardFlux);
}

double Atmosphere::ambientTemperature_K(double) const {
    refuse(*this, AtmosphereProperty::ambientTemperature);
}

Spectrum Atmosphere::scatteringOpticalDepth(const AirPath&, const SpectralRange&) const {
    refuse(*this, AtmosphereProperty::scatteringOpticalDepth);
}

namespace {

[[noreturn]] void refuseWideband(const Atmosphere& atmosphere) {
    throw LogicError("the atmosphere " + atmosphere.name() +
                     " was asked for wideband quantities, which it does not support");
}

} // namespace

std::shared_ptr<const SensorCkData> Atmosphere::prepareCk(const CkRequest&) const {
    refuseWideband(*this);
}

std::vector<double> Atmosphere::ckTransmittance(const AirPath&, const SensorCkData&) const {
    refuseWideband(*this);
}

std::vector<double> Atmosphere::ckPathRadiance(const AirPath&, const SunPosition&,
                                               const SensorCkData&) const {
    refuseWideband(*this);
}

std::vector<double> Atmosphere::ckBackgroundRadiance(const LineOfSight&, const SunPosition&,
                                                     const SensorCkData&) const {
    refuseWideband(*this);
}

std::vector<double> Atmosphere::ckSolarIrradiance(double, const SunPosition&,
                                                  const SensorCkData&) const {
    refuseWideband(*this);
}

std::vector<double> Atmosphere::ckUpwardFlux(double, const SunPosition&,
                                             const SensorCkData&) const {
    refuseWideband(*this);
}

std::vector<double> Atmosphere::ckDownwardFlux(double, const SunPosition&,
                                               const SensorCkData&) const {
    refuseWideband(*this);
}

void Atmosphere::checkRange(const SpectralRange& range) const {
    if (!(range.min_um < range.max_um && base().contains(range))) {
        throw LogicError("the atmosphere " + name() + ", which holds " + numberText(base().min_um) +
                         " to " + numberText(base().max_um) + " um, was asked for " +
                         numberText(range.min_um) + " to " + numberText(range.max_um) + " um");
    }
}

void Atmosphere::checkPath(const AirPath& path) const {
    checkAltitude(path.sensorAltitude_m, "sensor altitude");
    checkAltitude(path.targetAltitude_m, "target altitude");
    if (!(path.range_m >= 0.0 && std::isfinite(path.range_m))) {
        throw InputError({name(), "range", numberText(path.range_m) + " m",
                          "a finite distance of at least 0 m"});
    }
}

void Atmosphere::checkSight(const LineOfSight& sight) const {
    checkAltitude(sight.sensorAltitude_m, "sensor altitude");
    // Degrees that became radians may miss the zenith by a rounding.
    if (!(std::abs(sight.elevation_rad) <= 0.5 * pi + 1e-9)) {
        throw InputError({name(), "elevation of the line of sight",
                          numberText(degrees(sight.elevation_rad)) + " deg", "-90 to 90 deg"});
    }
}

void Atmosphere::checkAltitude(double altitude_m, const char* what) const {
    if (!(altitude_m >= 0.0 && std::isfinite(altitude_m))) {
        throw InputError({name(), what, numberText(altitude_m) + " m",
                          "a finite altitude of at least 0 m above the ground"});
    }
}

} // namespace irsg

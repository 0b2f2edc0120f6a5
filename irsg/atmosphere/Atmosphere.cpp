#include "irsg/atmosphere/Atmosphere.h"

#include "irsg/radiometry/Errors.h"

namespace irsg {

namespace {

[[noreturn]] void refuse(const Atmosphere& atmosphere, AtmosphereProperty property) {
    throw LogicError("the atmosphere " + atmosphere.name() + " was asked for its " +
                     name(property) + ", which it does not support");
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
    }
    throw LogicError("unknown atmosphere property");
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

} // namespace irsg

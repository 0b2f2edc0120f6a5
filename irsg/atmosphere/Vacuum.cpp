#include "irsg/atmosphere/Vacuum.h"

#include "irsg/radiometry/CurveSampling.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double nominalSolarTemperature_K = 5772.0;     // IAU 2015 resolution B3
constexpr double nominalSolarRadius_m = 6.957e8;         // IAU 2015 resolution B3
constexpr double astronomicalUnit_m = 149'597'870'700.0; // IAU 2012 resolution B2

} // namespace

bool Vacuum::supports(AtmosphereProperty property) const {
    return property != AtmosphereProperty::ambientTemperature &&
           (property != AtmosphereProperty::backgroundRadiance || background_ == Background::dark);
}

Spectrum Vacuum::nativeSpectrum(const AtmosphericQuery& query, const SpectralRange& range) const {
    switch (query.quantity) {
    case AtmosphereProperty::transmittance:
        return Spectrum::constant(1.0);
    case AtmosphereProperty::solarIrradiance:
        return extraterrestrialSolarIrradiance(
            range, query.sun.strength() * sunView(query.altitude_m, query.sun).part);
    default:
        return Spectrum::constant(0.0);
    }
}

Spectrum extraterrestrialSolarIrradiance(const SpectralRange& range, double strength) {
    if (strength <= 0.0)
        return Spectrum::constant(0.0);
    // E = L pi (R / d)^2: a uniform disc seen under that solid angle, on a plane normal to the
    // beam.
    const double ratio = nominalSolarRadius_m / astronomicalUnit_m;
    return sampledPlanck(nominalSolarTemperature_K, range, strength * pi * ratio * ratio);
}

} // namespace irsg

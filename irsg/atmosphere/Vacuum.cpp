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
    return property != AtmosphereProperty::ambientTemperature;
}

Spectrum Vacuum::transmittance(const AirPath& path, const SpectralRange& range) const {
    checkRange(range);
    checkPath(path);
    return Spectrum::constant(1.0);
}

Spectrum Vacuum::pathRadiance(const AirPath& path, const SunPosition&,
                              const SpectralRange& range) const {
    checkRange(range);
    checkPath(path);
    return Spectrum::constant(0.0);
}

Spectrum Vacuum::backgroundRadiance(const LineOfSight& sight, const SunPosition&,
                                    const SpectralRange& range) const {
    checkRange(range);
    checkSight(sight);
    return Spectrum::constant(0.0);
}

Spectrum Vacuum::solarIrradiance(double altitude_m, const SunPosition& sun,
                                 const SpectralRange& range) const {
    checkRange(range);
    checkAltitude(altitude_m);
    return sun.isUp() ? extraterrestrialSolarIrradiance(range) : Spectrum::constant(0.0);
}

Spectrum Vacuum::upwardFlux(double altitude_m, const SunPosition&,
                            const SpectralRange& range) const {
    checkRange(range);
    checkAltitude(altitude_m);
    return Spectrum::constant(0.0);
}

Spectrum Vacuum::downwardFlux(double altitude_m, const SunPosition&,
                              const SpectralRange& range) const {
    checkRange(range);
    checkAltitude(altitude_m);
    return Spectrum::constant(0.0);
}

Spectrum extraterrestrialSolarIrradiance(const SpectralRange& range) {
    // E = L pi (R / d)^2: a uniform disc seen under that solid angle, on a plane normal to the
    // beam.
    const double ratio = nominalSolarRadius_m / astronomicalUnit_m;
    return sampledPlanck(nominalSolarTemperature_K, range, pi * ratio * ratio);
}

Spectrum Vacuum::scatteringOpticalDepth(const AirPath& path, const SpectralRange& range) const {
    checkPath(path);
    checkRange(range);
    return Spectrum::constant(0.0);
}

} // namespace irsg

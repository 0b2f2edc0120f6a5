#include "irsg/atmosphere/Atmosphere.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/AtmosphereNodes.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/atmosphere/path/Earth.h"
#include "irsg/atmosphere/path/SunDiscGeometry.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

[[noreturn]] void refuse(const Atmosphere& atmosphere, AtmosphereProperty property) {
    throw LogicError("the atmosphere " + atmosphere.name() + " was asked for its " +
                     name(property) + ", which it does not support: it " +
                     atmosphere.refusal(property));
}

[[noreturn]] void refuseWideband(const Atmosphere& atmosphere) {
    throw LogicError("the atmosphere " + atmosphere.name() +
                     " was asked for wideband quantities, which it does not support");
}

} // namespace

std::string Atmosphere::refusal(AtmosphereProperty property) const {
    return std::string("has no ") + irsg::name(property);
}

double Atmosphere::horizonElevation_rad(double altitude_m) const {
    // cos(dip) = R / (R + h); by the tangent, which keeps its digits near the ground.
    const double h_m = std::max(altitude_m, 0.0);
    return -std::atan(std::sqrt(h_m * (2.0 * earthRadius_m + h_m)) / earthRadius_m);
}

SunView Atmosphere::sunView(double altitude_m, const SunPosition& sun) const {
    return {visibleSun(sun.elevation_rad - horizonElevation_rad(altitude_m)).part,
            sun.elevation_rad};
}

TargetView Atmosphere::targetView(const AtmosphericPath& path) const {
    return flatTargetView(path);
}

double Atmosphere::ambientTemperature_K(double) const {
    refuse(*this, AtmosphereProperty::ambientTemperature);
}

std::vector<double> Atmosphere::provide(const AtmosphericQuery& query,
                                        const SpectralSampling& sampling) const {
    if (const SensorCkData* points = SensorCkData::of(sampling)) {
        if (!isWidebandModeAvailable())
            refuseWideband(*this);
        checkQuery(query);
        return valuesAtPoints(query, *points);
    }
    if (const AtmosphereNodes* nodes = AtmosphereNodes::of(sampling)) {
        checkRange(sampling.range());
        checkQuery(query);
        if (auto values = valuesAtNodes(query, *nodes))
            return std::move(*values);
    }
    return sampling.sampled(spectrum(query, sampling.range()));
}

Spectrum Atmosphere::spectrum(const AtmosphericQuery& query, const SpectralRange& range) const {
    checkRange(range);
    checkQuery(query);
    return nativeSpectrum(query, covered(range));
}

Spectrum Atmosphere::transmittance(const AtmosphericPath& path, const SpectralRange& range) const {
    return spectrum(AtmosphericQuery::transmittance(path), range);
}

Spectrum Atmosphere::pathRadiance(const AtmosphericPath& path, const SunPosition& sun,
                                  const SpectralRange& range) const {
    return spectrum(AtmosphericQuery::pathRadiance(path, sun), range);
}

Spectrum Atmosphere::backgroundRadiance(const LineOfSight& sight, const SunPosition& sun,
                                        const SpectralRange& range) const {
    return spectrum(AtmosphericQuery::backgroundRadiance(sight, sun), range);
}

Spectrum Atmosphere::solarIrradiance(double altitude_m, const SunPosition& sun,
                                     const SpectralRange& range) const {
    return spectrum(AtmosphericQuery::solarIrradiance(altitude_m, sun), range);
}

Spectrum Atmosphere::upwardFlux(double altitude_m, const SunPosition& sun,
                                const SpectralRange& range) const {
    return spectrum(AtmosphericQuery::upwardFlux(altitude_m, sun), range);
}

Spectrum Atmosphere::downwardFlux(double altitude_m, const SunPosition& sun,
                                  const SpectralRange& range) const {
    return spectrum(AtmosphericQuery::downwardFlux(altitude_m, sun), range);
}

Spectrum Atmosphere::scatteringOpticalDepth(const AtmosphericPath& path,
                                            const SpectralRange& range) const {
    return spectrum(AtmosphericQuery::scatteringOpticalDepth(path), range);
}

std::shared_ptr<const SensorCkData> Atmosphere::prepareCk(const CkRequest&) const {
    refuseWideband(*this);
}

Spectrum Atmosphere::nativeSpectrum(const AtmosphericQuery& query, const SpectralRange&) const {
    refuse(*this, query.quantity);
}

std::vector<double> Atmosphere::valuesAtPoints(const AtmosphericQuery&, const SensorCkData&) const {
    refuseWideband(*this);
}

SpectralRange Atmosphere::covered(const SpectralRange& range) const {
    const SpectralRange own = base();
    return {std::max(range.min_um, own.min_um), std::min(range.max_um, own.max_um)};
}

bool Atmosphere::covers(const SpectralRange& range) const {
    constexpr double slack = 2e-9;
    const SpectralRange own = base(), part = covered(range);
    return part.min_um < part.max_um && own.min_um <= range.min_um * (1.0 + slack) &&
           own.max_um >= range.max_um * (1.0 - slack);
}

void Atmosphere::checkQuery(const AtmosphericQuery& query) const {
    switch (geometryOf(query.quantity)) {
    case QueryGeometry::path:
        checkPath(query.path);
        break;
    case QueryGeometry::sight:
        checkSight(query.sight);
        break;
    case QueryGeometry::altitude:
        checkAltitude(query.altitude_m);
        break;
    }
    if (query.quantity == AtmosphereProperty::ambientTemperature)
        throw LogicError("a temperature was asked for as a spectrum");
    if (!supports(query.quantity))
        refuse(*this, query.quantity);
}

void Atmosphere::checkRange(const SpectralRange& range) const {
    if (!(range.min_um < range.max_um && covers(range))) {
        throw LogicError("the atmosphere " + name() + ", which covers " +
                         numberText(base().min_um) + " to " + numberText(base().max_um) +
                         " um, was asked for " + numberText(range.min_um) + " to " +
                         numberText(range.max_um) + " um");
    }
}

void Atmosphere::checkPath(const AtmosphericPath& path) const {
    checkAltitude(path.sensorAltitude_m, "sensor altitude");
    checkAltitude(path.targetAltitude_m, "target altitude");
    if (!(path.range_m >= 0.0 && std::isfinite(path.range_m))) {
        throw InputError({name(), "range", numberText(path.range_m) + " m",
                          "a finite distance of at least 0 m"});
    }
    if (!std::isfinite(path.azimuth_rad)) {
        throw InputError({name(), "azimuth of the path", numberText(path.azimuth_rad) + " rad",
                          "a finite angle"});
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

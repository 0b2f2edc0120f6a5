#include "irsg/atmosphere/SpectraAtmosphere.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <utility>

#include "irsg/atmosphere/Vacuum.h"
#include "irsg/atmosphere/path/Earth.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// What a quantity was computed for and cannot do without.
void checkGeometry(const SpectraAtmosphereParameters& air, AtmosphereProperty property,
                   std::vector<Diagnostic>& diagnostics) {
    const auto need = [&](bool given, const char* what) {
        if (!given) {
            diagnostics.push_back({air.name, name(property), "no " + std::string(what),
                                   "the " + std::string(what) + " it was computed for"});
        }
    };
    switch (property) {
    case AtmosphereProperty::transmittance:
    case AtmosphereProperty::scatteringOpticalDepth:
        return need(air.path.has_value(), "path");
    case AtmosphereProperty::pathRadiance:
        need(air.path.has_value(), "path");
        return need(air.sun.has_value(), "sun");
    case AtmosphereProperty::backgroundRadiance:
        need(air.sight.has_value(), "line of sight");
        return need(air.sun.has_value(), "sun");
    case AtmosphereProperty::solarIrradiance:
    case AtmosphereProperty::upwardFlux:
    case AtmosphereProperty::downwardFlux:
        need(air.targetAltitude_m.has_value(), "target altitude");
        return need(air.sun.has_value(), "sun");
    case AtmosphereProperty::ambientTemperature:
        diagnostics.push_back({air.name, name(property), "a spectrum", "a temperature in K"});
        return;
    }
}

/// Within this much above 1 a transmittance is one that was rounded.
constexpr double roundedTransmittance = 1.0 + 1e-9;

void check(const SpectraAtmosphereParameters& air) {
    std::vector<Diagnostic> diagnostics;
    if (air.spectra.empty()) {
        diagnostics.push_back(
            {air.name, "", "no spectrum", "the spectrum of at least one quantity"});
    }
    for (const auto& [property, spectrum] : air.spectra) {
        checkGeometry(air, property, diagnostics);
        if (spectrum.minimum() < 0.0) {
            diagnostics.push_back({air.name, name(property), numberText(spectrum.minimum()),
                                   "at least 0 everywhere"});
        }
        if (property == AtmosphereProperty::transmittance &&
            spectrum.maximum() > roundedTransmittance) {
            diagnostics.push_back(
                {air.name, name(property), numberText(spectrum.maximum()), "at most 1 everywhere"});
        }
    }
    for (const auto& [distance_m, spectrum] : air.lastTransmittance) {
        const std::string place = "transmittance of the last " + numberText(distance_m) + " m";
        if (!air.path || !(distance_m > 0.0) || !(distance_m < air.path->range_m))
            diagnostics.push_back({air.name, place, numberText(distance_m) + " m",
                                   "a path that is longer, and more than 0 m of it"});
        if (spectrum.minimum() < 0.0 || spectrum.maximum() > roundedTransmittance)
            diagnostics.push_back(
                {air.name, place,
                 numberText(spectrum.minimum()) + " to " + numberText(spectrum.maximum()),
                 "0 to 1 everywhere"});
    }
    if (air.ambientTemperature_K) {
        if (!(*air.ambientTemperature_K > 0.0 && std::isfinite(*air.ambientTemperature_K))) {
            diagnostics.push_back({air.name, "ambient temperature",
                                   numberText(*air.ambientTemperature_K) + " K",
                                   "a finite temperature above 0 K"});
        }
        if (!air.targetAltitude_m) {
            diagnostics.push_back({air.name, "ambient temperature", "no target altitude",
                                   "the target altitude it is the temperature of"});
        }
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

SpectralRange commonRange(const SpectraAtmosphereParameters& air) {
    SpectralRange common = Vacuum().base();
    for (const auto& [property, spectrum] : air.spectra) {
        if (spectrum.isConstant())
            continue;
        common = {std::max(common.min_um, spectrum.wavelengths_um().front()),
                  std::min(common.max_um, spectrum.wavelengths_um().back())};
        if (!(common.min_um < common.max_um)) {
            throw InputError({air.name, name(property),
                              numberText(spectrum.wavelengths_um().front()) + " to " +
                                  numberText(spectrum.wavelengths_um().back()) + " um",
                              "wavelengths in common with the other spectra within 0.2 to 40 um"});
        }
    }
    return common;
}

/// An angle in (-pi, pi].
double turned(double angle_rad) {
    return std::remainder(angle_rad, 2.0 * pi);
}

/// False where an azimuth means nothing: straight up or down.
bool hasAzimuth(double elevation_rad) {
    return std::cos(elevation_rad) > 1e-4;
}

} // namespace

SpectraAtmosphere::SpectraAtmosphere(SpectraAtmosphereParameters parameters)
    : parameters_(std::move(parameters)) {
    check(parameters_);
    base_ = commonRange(parameters_);
}

bool SpectraAtmosphere::supports(AtmosphereProperty property) const {
    return property == AtmosphereProperty::ambientTemperature
               ? parameters_.ambientTemperature_K.has_value()
               : parameters_.spectra.contains(property);
}

double SpectraAtmosphere::altitudeSlack_m() const {
    const double range_m = parameters_.path ? parameters_.path->range_m : 0.0;
    return altitudeTolerance_m + range_m * range_m / (2.0 * earthRadius_m);
}

double SpectraAtmosphere::elevationSlack_rad() const {
    const double range_m = parameters_.path ? parameters_.path->range_m : 0.0;
    return angleTolerance_rad + range_m / (2.0 * earthRadius_m);
}

void SpectraAtmosphere::requireNear(const char* what, double found, double held, double slack,
                                    double perUnit, const char* unit) const {
    if (!(std::abs(found - held) <= slack)) {
        const auto text = [&](double value, int digits) {
            std::ostringstream out;
            out.imbue(std::locale::classic());
            out << std::setprecision(digits) << value * perUnit << " " << unit;
            return out.str();
        };
        throw InputError({name(), what, text(found, 12),
                          text(held, 12) + " to within " + text(slack, 3) +
                              ", the one geometry that these spectra hold"});
    }
}

void SpectraAtmosphere::requirePath(const AtmosphericPath& path) const {
    const AtmosphericPath& held = *parameters_.path;
    requireNear("sensor altitude", path.sensorAltitude_m, held.sensorAltitude_m, altitudeSlack_m(),
                1.0, "m");
    requireNear("target altitude", path.targetAltitude_m, held.targetAltitude_m, altitudeSlack_m(),
                1.0, "m");
    requireNear("range", path.range_m, held.range_m, rangeTolerance * held.range_m, 1.0, "m");
}

void SpectraAtmosphere::requireTargetAltitude(double altitude_m) const {
    const double held_m = parameters_.targetAltitude_m
                              ? *parameters_.targetAltitude_m
                              : parameters_.path.value_or(AtmosphericPath{}).targetAltitude_m;
    requireNear("target altitude", altitude_m, held_m, altitudeSlack_m(), 1.0, "m");
}

void SpectraAtmosphere::requireSunElevation(const SunPosition& sun) const {
    if (sun.isUp() || parameters_.sun->isUp()) {
        requireNear("sun elevation", sun.elevation_rad, parameters_.sun->elevation_rad,
                    angleTolerance_rad, degrees(1.0), "deg");
    }
}

Spectrum SpectraAtmosphere::nativeSpectrum(const AtmosphericQuery& query,
                                           const SpectralRange&) const {
    switch (geometryOf(query.quantity)) {
    case QueryGeometry::path:
        if (query.quantity == AtmosphereProperty::transmittance)
            for (const auto& [distance_m, spectrum] : parameters_.lastTransmittance)
                if (std::abs(query.path.range_m - distance_m) <= rangeTolerance * distance_m) {
                    requireTargetAltitude(query.path.targetAltitude_m);
                    return spectrum;
                }
        requirePath(query.path);
        break;
    case QueryGeometry::sight:
        requireSight(query.sight, query.sun);
        break;
    case QueryGeometry::altitude:
        requireTargetAltitude(query.altitude_m);
        break;
    }
    if (hasSun(query.quantity))
        requireSunElevation(query.sun);
    return parameters_.spectra.at(query.quantity);
}

void SpectraAtmosphere::requireSight(const LineOfSight& sight, const SunPosition& sun) const {
    const LineOfSight& held = *parameters_.sight;
    requireNear("sensor altitude", sight.sensorAltitude_m, held.sensorAltitude_m, altitudeSlack_m(),
                1.0, "m");
    requireNear("elevation of the line of sight", sight.elevation_rad, held.elevation_rad,
                elevationSlack_rad(), degrees(1.0), "deg");

    // The air is the same all around: only the sun tells one azimuth from another.
    requireSunElevation(sun);
    const SunPosition& heldSun = *parameters_.sun;
    if (heldSun.isUp() && hasAzimuth(heldSun.elevation_rad) && hasAzimuth(held.elevation_rad)) {
        const double heldAway_rad = turned(heldSun.azimuth_rad - held.azimuth_rad);
        const double away_rad = turned(sun.azimuth_rad - sight.azimuth_rad);
        // Left and right of the sun are alike.
        requireNear("azimuth of the sun from the line of sight", std::abs(away_rad),
                    std::abs(heldAway_rad), angleTolerance_rad, degrees(1.0), "deg");
    }
}

double SpectraAtmosphere::ambientTemperature_K(double altitude_m) const {
    if (!parameters_.ambientTemperature_K) {
        throw LogicError("the atmosphere " + name() +
                         " was asked for ambient temperature, which it does not support");
    }
    checkAltitude(altitude_m);
    requireTargetAltitude(altitude_m);
    return *parameters_.ambientTemperature_K;
}

AtmosphereDescription SpectraAtmosphere::describe() const {
    struct Number {
        const char* words;
        const char* unit;
        double value;
    };
    std::vector<Number> numbers;
    if (parameters_.path) {
        numbers.push_back({"sensor altitude", "m", parameters_.path->sensorAltitude_m});
        numbers.push_back({"range", "m", parameters_.path->range_m});
    } else if (parameters_.sight) {
        numbers.push_back({"sensor altitude", "m", parameters_.sight->sensorAltitude_m});
    }
    if (parameters_.path || parameters_.targetAltitude_m) {
        numbers.push_back({"target altitude", "m",
                           parameters_.path ? parameters_.path->targetAltitude_m
                                            : *parameters_.targetAltitude_m});
    }
    if (parameters_.sight) {
        numbers.push_back({"los elevation", "deg", degrees(parameters_.sight->elevation_rad)});
        numbers.push_back({"los azimuth", "deg", degrees(parameters_.sight->azimuth_rad)});
    }
    if (parameters_.sun) {
        numbers.push_back({"sun azimuth", "deg", degrees(parameters_.sun->azimuth_rad)});
        numbers.push_back({"sun elevation", "deg", degrees(parameters_.sun->elevation_rad)});
    }

    AtmosphereDescription told{{"known for one geometry"}, {}};
    AtmosphereFacts facts;
    for (const Number& number : numbers) {
        told.lines.push_back("  " + std::string(number.words) + " " + general(number.value, 7) +
                             " " + number.unit);
        std::string key = std::string(number.words) + "_" + number.unit;
        std::ranges::replace(key, ' ', '_');
        facts.push_back({std::move(key), {number.value}});
    }
    if (!facts.empty())
        told.facts.push_back({"geometry", {std::move(facts)}});
    return told;
}

} // namespace irsg

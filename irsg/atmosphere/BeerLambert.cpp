#include "irsg/atmosphere/BeerLambert.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/atmosphere/Vacuum.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/CurveSampling.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

/// Every spectrum of the parameters with the words an error message has for it.
std::vector<std::pair<const char*, const Spectrum*>>
spectraOf(const BeerLambertParameters& parameters) {
    std::vector<std::pair<const char*, const Spectrum*>> spectra = {
        {"extinction", &parameters.extinction_per_m},
        {"solar irradiance", &parameters.solarIrradiance_W_m2_um},
        {"downward flux", &parameters.downwardFlux_W_m2_um},
        {"upward flux", &parameters.upwardFlux_W_m2_um}};
    if (parameters.skyRadiance_W_m2_sr_um)
        spectra.emplace_back("sky radiance", &*parameters.skyRadiance_W_m2_sr_um);
    return spectra;
}

void check(const BeerLambertParameters& parameters) {
    std::vector<Diagnostic> diagnostics;
    for (const auto& [what, spectrum] : spectraOf(parameters)) {
        if (spectrum->minimum() < 0.0) {
            diagnostics.push_back(
                {parameters.name, what, numberText(spectrum->minimum()), "at least 0 everywhere"});
        }
    }
    for (const auto& [what, temperature_K] :
         {std::pair{"air temperature", parameters.airTemperature_K},
          std::pair{"ground temperature", parameters.groundTemperature_K}}) {
        if (!(temperature_K >= 0.0 && std::isfinite(temperature_K))) {
            diagnostics.push_back({parameters.name, what, numberText(temperature_K) + " K",
                                   "a finite temperature of at least 0 K"});
        }
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

/// What all sampled spectra cover; the base of Vacuum where all are constant.
SpectralRange commonRange(const BeerLambertParameters& parameters) {
    std::optional<SpectralRange> common;
    for (const auto& [what, spectrum] : spectraOf(parameters)) {
        if (spectrum->isConstant())
            continue;
        const double first_um = spectrum->wavelengths_um().front();
        const double last_um = spectrum->wavelengths_um().back();
        common = common ? SpectralRange{std::max(common->min_um, first_um),
                                        std::min(common->max_um, last_um)}
                        : SpectralRange{first_um, last_um};
        if (!(common->min_um < common->max_um)) {
            throw InputError({parameters.name, what,
                              numberText(first_um) + " to " + numberText(last_um) + " um",
                              "wavelengths in common with the other spectra"});
        }
    }
    return common.value_or(Vacuum().base());
}

} // namespace

BeerLambert::BeerLambert(BeerLambertParameters parameters) : parameters_(std::move(parameters)) {
    check(parameters_);
    base_ = commonRange(parameters_);
}

std::vector<double> BeerLambert::kinks(const SpectralRange& range) const {
    const Spectrum* const extinction[] = {&parameters_.extinction_per_m};
    return mergeAxes(extinction, range);
}

Spectrum BeerLambert::nativeSpectrum(const AtmosphericQuery& query,
                                     const SpectralRange& range) const {
    switch (query.quantity) {
    case AtmosphereProperty::transmittance:
        return through(query.path.range_m, range);
    case AtmosphereProperty::pathRadiance:
        return emittedAlong(query.path.range_m, range);
    case AtmosphereProperty::backgroundRadiance:
        return seenAlong(query.sight, range);
    case AtmosphereProperty::solarIrradiance:
        // Of whatever day the irradiance was stated for: the distance of the sun is in it.
        return parameters_.solarIrradiance_W_m2_um.mapped(
            [part = sunView(query.altitude_m, query.sun).part](double whole) {
                return part * whole;
            });
    case AtmosphereProperty::upwardFlux:
        return parameters_.upwardFlux_W_m2_um;
    case AtmosphereProperty::downwardFlux:
        return parameters_.downwardFlux_W_m2_um;
    default:
        return Spectrum::constant(0.0);
    }
}

Spectrum BeerLambert::through(double range_m, const SpectralRange& range) const {
    const Spectrum& extinction = parameters_.extinction_per_m;
    if (extinction.isConstant() || range_m == 0.0)
        return Spectrum::constant(std::exp(-extinction.values().front() * range_m));
    return sampledCurve(
        [&](double wavelength_um) { return std::exp(-extinction.at(wavelength_um) * range_m); },
        kinks(range), atmosphereTolerance, atmosphereFloor);
}

Spectrum BeerLambert::emittedAlong(double range_m, const SpectralRange& range) const {
    if (range_m == 0.0)
        return Spectrum::constant(0.0);
    // 1 - tau loses its digits in thin air: expm1.
    return sampledCurve(
        [&](double wavelength_um) {
            const double depth = parameters_.extinction_per_m.at(wavelength_um) * range_m;
            return -std::expm1(-depth) *
                   planckRadiance_W_m2_sr_um(wavelength_um, parameters_.airTemperature_K);
        },
        kinks(range), atmosphereTolerance, atmosphereFloor);
}

Spectrum BeerLambert::seenAlong(const LineOfSight& sight, const SpectralRange& range) const {
    if (sight.elevation_rad >= 0.0)
        return unboundedRadiance(range);

    // The ground at the end of the way down, seen through the air and the air before it.
    const double way_m = sight.sensorAltitude_m / std::sin(-sight.elevation_rad);
    return sampledCurve(
        [&](double wavelength_um) {
            const double extinction_per_m = parameters_.extinction_per_m.at(wavelength_um);
            const double depth = way_m > 0.0 ? extinction_per_m * way_m : 0.0;
            const double ground =
                planckRadiance_W_m2_sr_um(wavelength_um, parameters_.groundTemperature_K);
            const double air =
                planckRadiance_W_m2_sr_um(wavelength_um, parameters_.airTemperature_K);
            return std::exp(-depth) * ground - std::expm1(-depth) * air;
        },
        kinks(range), atmosphereTolerance, atmosphereFloor);
}

Spectrum BeerLambert::unboundedRadiance(const SpectralRange& range) const {
    // Where an interval without extinction borders on one with it, opaque air begins at once: a
    // node on each side of the border holds the jump.
    const Spectrum& extinction = parameters_.extinction_per_m;
    const auto& sky = parameters_.skyRadiance_W_m2_sr_um;
    const Spectrum* const bent[] = {&extinction, sky ? &*sky : &extinction};
    const std::vector<double> axis = mergeAxes(bent, range);
    std::vector<double> nodes = {axis.front()};
    std::vector<SpectralRange> windows;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
        const bool isClear = extinction.at(0.5 * (axis[i] + axis[i + 1])) == 0.0;
        const bool wasClear = !windows.empty() && windows.back().max_um == axis[i];
        if (i > 0 && isClear && !wasClear)
            nodes.insert(nodes.end() - 1, std::nextafter(axis[i], 0.0));
        else if (!isClear && wasClear)
            nodes.push_back(std::nextafter(axis[i], HUGE_VAL));
        if (isClear && wasClear)
            windows.back().max_um = axis[i + 1];
        else if (isClear)
            windows.push_back({axis[i], axis[i + 1]});
        nodes.push_back(axis[i + 1]);
    }

    return sampledCurve(
        [&](double wavelength_um) {
            const auto holds = [wavelength_um](const SpectralRange& window) {
                return wavelength_um >= window.min_um && wavelength_um <= window.max_um;
            };
            if (!std::ranges::any_of(windows, holds))
                return planckRadiance_W_m2_sr_um(wavelength_um, parameters_.airTemperature_K);
            return sky ? sky->at(wavelength_um) : 0.0;
        },
        nodes, atmosphereTolerance, atmosphereFloor);
}

double BeerLambert::ambientTemperature_K(double altitude_m) const {
    checkAltitude(altitude_m);
    return parameters_.airTemperature_K;
}

AtmosphereDescription BeerLambert::describe() const {
    return {{"homogeneous air of " + general(parameters_.airTemperature_K) + " K over ground of " +
             general(parameters_.groundTemperature_K) + " K"},
            {{"air_temperature_K", {parameters_.airTemperature_K}},
             {"ground_temperature_K", {parameters_.groundTemperature_K}}}};
}

} // namespace irsg

#include "irsg/atmosphere/engine/Particles.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace irsg {

namespace {

/// One less the single scattering albedo.
double absorbedPart(const ParticleOptics& optics) {
    return optics.extinction > 0.0 ? optics.absorption / optics.extinction : 0.0;
}

} // namespace

double ParticleLayer::extinction550At(double altitude_m) const {
    if (altitudes_m.empty() || altitude_m < altitudes_m.front() || altitude_m > altitudes_m.back())
        return 0.0;
    return interpolate(altitudes_m, extinction550_per_m, altitude_m);
}

ParticleOptics ParticleLayer::opticsAt(double wavelength_um) const {
    if (optics.empty() || optics.size() != wavelengths_um.size())
        throw LogicError("particles without optical properties: " + name);
    const Bracket at = bracket(wavelengths_um, wavelength_um);
    const ParticleOptics& a = optics[at.below];
    const ParticleOptics& b = optics[at.above];
    if (at.fraction == 0.0)
        return a;
    if (at.fraction == 1.0)
        return b;
    const double part =
        fractionByRatio(wavelengths_um[at.below], wavelengths_um[at.above], wavelength_um);
    ParticleOptics result;
    result.extinction = lerpByRatio(a.extinction, b.extinction, part);
    result.absorption = result.extinction * lerp(absorbedPart(a), absorbedPart(b), part);
    result.asymmetry = lerp(a.asymmetry, b.asymmetry, part);
    return result;
}

std::vector<ParticleLayer> particleLayers(const ParticleSettings& settings,
                                          const HumidityProfile& relativeHumidityAt) {
    particles::check(settings);
    std::vector<ParticleLayer> layers;
    const HumidityProfile finiteHumidityAt = [&](double altitude_m) {
        const double humidity = relativeHumidityAt(altitude_m);
        if (!std::isfinite(humidity))
            throw LogicError("the humidity at " + numberText(altitude_m) + " m is not a number");
        return humidity;
    };
    if (settings.aerosol)
        layers = particles::aerosols(settings, finiteHumidityAt);
    std::ranges::move(particles::clouds(settings), std::back_inserter(layers));
    return layers;
}

ParticleOptics aerosolOptics(AerosolModel model, double relativeHumidity, double wavelength_um) {
    ParticleSettings settings;
    settings.aerosol = model;
    // The humidity is the same at all heights, so that all layers at the ground have one kind of
    // optics.
    ParticleOptics sum{0.0, 0.0, 0.0};
    double strength = 0.0;
    for (const ParticleLayer& layer :
         particleLayers(settings, [&](double) { return relativeHumidity; })) {
        const double extinction550_per_m = layer.extinction550At(0.0);
        if (!(extinction550_per_m > 0.0))
            continue;
        const ParticleOptics optics = layer.opticsAt(wavelength_um);
        const double scattering = optics.extinction - optics.absorption;
        strength += extinction550_per_m;
        sum.extinction += extinction550_per_m * optics.extinction;
        sum.absorption += extinction550_per_m * optics.absorption;
        sum.asymmetry += extinction550_per_m * scattering * optics.asymmetry;
    }
    sum.asymmetry /= sum.extinction - sum.absorption;
    sum.extinction /= strength;
    sum.absorption /= strength;
    return sum;
}

namespace particles {

ParticleOptics between(const ParticleOptics& a, const ParticleOptics& b, double part) {
    ParticleOptics result;
    result.extinction = lerpByRatio(a.extinction, b.extinction, part);
    result.absorption = std::min(lerpByRatio(a.absorption, b.absorption, part), result.extinction);
    result.asymmetry = lerp(a.asymmetry, b.asymmetry, part);
    return result;
}

Optics normalised(Optics optics) {
    const ParticleLayer spectrum{"", {}, {}, optics.wavelengths_um, optics.values};
    const double reference = spectrum.opticsAt(0.55).extinction;
    for (ParticleOptics& value : optics.values) {
        value.extinction /= reference;
        value.absorption /= reference;
    }
    return optics;
}

Optics opticsOf(const ParticleTable& table, const std::string& prefix, const std::string& suffix) {
    const std::vector<double>& extinction = table.column(prefix + "_ext" + suffix);
    const std::vector<double>& absorption = table.column(prefix + "_abs" + suffix);
    const std::vector<double>& asymmetry = table.column(prefix + "_asym" + suffix);
    Optics optics{table.first(), {}};
    for (std::size_t i = 0; i < extinction.size(); ++i)
        optics.values.push_back({extinction[i], absorption[i], asymmetry[i]});
    return optics;
}

std::vector<std::string> opticsColumns(const std::vector<std::string>& prefixes,
                                       const std::vector<std::string>& suffixes) {
    std::vector<std::string> names;
    for (const std::string& prefix : prefixes)
        for (const char* quantity : {"_ext", "_abs", "_asym"})
            for (const std::string& suffix : suffixes)
                names.push_back(prefix + quantity + suffix);
    return names;
}

} // namespace particles

} // namespace irsg

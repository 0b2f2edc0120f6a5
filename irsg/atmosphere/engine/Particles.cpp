#include "irsg/atmosphere/engine/Particles.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// 0 to 1 of the way from a to b, in logarithms where both are positive.
double mix(double a, double b, double part) {
    if (a > 0.0 && b > 0.0)
        return a == b ? a : a * std::exp(part * std::log(b / a));
    return a + part * (b - a);
}

/// One less the single scattering albedo.
double absorbedPart(const ParticleOptics& optics) {
    return optics.extinction > 0.0 ? optics.absorption / optics.extinction : 0.0;
}

} // namespace

double ParticleLayer::extinction550At(double altitude_m) const {
    if (altitudes_m.empty() || altitude_m < altitudes_m.front() || altitude_m > altitudes_m.back())
        return 0.0;
    const auto above = std::ranges::upper_bound(altitudes_m, altitude_m);
    if (above == altitudes_m.end())
        return extinction550_per_m.back();
    const auto i = static_cast<std::size_t>(above - altitudes_m.begin());
    const double part = (altitude_m - altitudes_m[i - 1]) / (altitudes_m[i] - altitudes_m[i - 1]);
    return std::lerp(extinction550_per_m[i - 1], extinction550_per_m[i], part);
}

ParticleOptics ParticleLayer::opticsAt(double wavelength_um) const {
    if (optics.empty() || optics.size() != wavelengths_um.size())
        throw LogicError("particles without optical properties: " + name);
    const auto above = std::ranges::upper_bound(wavelengths_um, wavelength_um);
    if (above == wavelengths_um.begin())
        return optics.front();
    if (above == wavelengths_um.end())
        return optics.back();
    const auto i = static_cast<std::size_t>(above - wavelengths_um.begin());
    const double part = std::log(wavelength_um / wavelengths_um[i - 1]) /
                        std::log(wavelengths_um[i] / wavelengths_um[i - 1]);
    const ParticleOptics& a = optics[i - 1];
    const ParticleOptics& b = optics[i];
    ParticleOptics result;
    result.extinction = mix(a.extinction, b.extinction, part);
    result.absorption = result.extinction * std::lerp(absorbedPart(a), absorbedPart(b), part);
    result.asymmetry = std::lerp(a.asymmetry, b.asymmetry, part);
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

namespace particles {

ParticleOptics between(const ParticleOptics& a, const ParticleOptics& b, double part) {
    ParticleOptics result;
    result.extinction = mix(a.extinction, b.extinction, part);
    result.absorption = std::min(mix(a.absorption, b.absorption, part), result.extinction);
    result.asymmetry = std::lerp(a.asymmetry, b.asymmetry, part);
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

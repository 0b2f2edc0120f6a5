#include "irsg/scene/radiance/ApparentRadiance.h"

#include <algorithm>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Below this a transmittance ratio is 0 over 0: nothing arrives.
constexpr double opaque = 1e-30;

/// Transmittance of the path beyond the reference distance of a measured spectrum.
double beyondReference(const SurfaceInput& surface, double transmittance, std::size_t i) {
    if (surface.insideReference)
        return 1.0;
    if (surface.referenceTransmittance.empty())
        return transmittance;
    const double reference = surface.referenceTransmittance[i];
    if (reference < opaque)
        return 0.0;
    return transmittance / reference;
}

/// Sum of c_j L_j of eq. 6 at the source.
std::vector<double> userRadiance(const SurfaceInput& surface, const SpectrumSampler& sample,
                                 std::size_t count) {
    std::vector<double> sum(count, 0.0);
    for (const SpectrumComponent& component : surface.userSpectrum->components) {
        double factor = 1.0;
        for (const ComponentFactor& candidate : surface.temperature->factors)
            if (candidate.component == component.name)
                factor = candidate.at(surface.state);
        if (factor == 0.0)
            continue;
        const std::vector<double> samples = sample(component.radiance);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += factor * samples[i];
    }
    return sum;
}

} // namespace

double surfaceTemperature_K(const SurfaceInput& surface) {
    return surface.temperatureScale *
           surfaceTemperature_K(surface.temperature->terms, surface.state);
}

SurfaceSpectra apparentRadiance(const SurfaceInput& surface, const RadianceTerms& terms,
                                const AirSamples& air, const std::vector<double>& wavelengths_um,
                                const SpectrumSampler& sample) {
    const std::size_t count = wavelengths_um.size();
    const bool usesSpectrum = surface.temperature->mode == EmissionMode::userSpectrum;
    if (usesSpectrum && !surface.userSpectrum)
        throw LogicError("a surface in spectrum mode came without its spectrum");

    SurfaceSpectra result;
    result.nAngleFactor = surface.material->nAngleFactor;
    result.transmissivity = sample(surface.material->transmissivity);

    // A scaled emissivity stays within what transmission leaves; reflectivity takes the rest.
    result.emissivity = sample(surface.material->emissivity);
    std::vector<double> emissivity = result.emissivity;
    std::vector<double> reflectance(count), opacity(count);
    for (std::size_t i = 0; i < count; ++i) {
        opacity[i] = 1.0 - result.transmissivity[i];
        emissivity[i] = std::clamp(emissivity[i] * surface.emissivityScale, 0.0, opacity[i]);
        reflectance[i] = (opacity[i] - emissivity[i]) / pi;
    }

    // Emission: of a body at the temperature of eq. 7, or as measured.
    std::vector<double> emission(count);
    if (usesSpectrum) {
        const std::vector<double> source = userRadiance(surface, sample, count);
        for (std::size_t i = 0; i < count; ++i)
            emission[i] = surface.emissivityScale * source[i] *
                          beyondReference(surface, air.transmittance[i], i);
    } else {
        result.temperature_K = surfaceTemperature_K(surface);
        if (!(result.temperature_K > 0.0))
            throw LogicError("a surface temperature that is not positive reached the radiometry");
        for (std::size_t i = 0; i < count; ++i)
            emission[i] = emissivity[i] *
                          planckRadiance_W_m2_sr_um(wavelengths_um[i], result.temperature_K) *
                          air.transmittance[i];
    }

    for (std::size_t k = 0; k < terms.terms.size(); ++k) {
        const RadianceTerm& term = terms.terms[k];
        std::vector<double>& sent = result.terms.emplace_back();
        if (term.light && air.light[k].empty())
            continue;
        switch (term.surface) {
        case SurfaceQuantity::emission:
            sent = emission;
            break;
        case SurfaceQuantity::reflectance:
            sent = reflectance;
            break;
        case SurfaceQuantity::opacity:
            sent = opacity;
            break;
        }
        for (std::size_t i = 0; term.light && i < count; ++i)
            sent[i] *= air.light[k][i];
        for (std::size_t i = 0; term.passesAir && i < count; ++i)
            sent[i] *= air.transmittance[i];
    }
    return result;
}

} // namespace irsg

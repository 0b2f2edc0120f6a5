#include "irsg/scene/radiance/ApparentRadiance.h"

#include <algorithm>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Below this a transmittance ratio is 0 over 0: nothing arrives.
constexpr double opaque = 1e-30;

/// Components of a measured spectrum at the source: what the air up to the reference distance took
/// is given back.
void addMeasured(const SurfaceInput& surface, const SpectrumSampler& sample,
                 SurfaceSpectra& result) {
    result.emissionPassesAir = !surface.insideReference;
    const std::vector<double> factors = componentFactors(surface);
    for (std::size_t j = 0; j < factors.size(); ++j) {
        std::vector<double> radiance = sample(surface.userSpectrum->components[j].radiance);
        for (std::size_t i = 0; i < radiance.size(); ++i) {
            radiance[i] *= surface.emissivityScale;
            if (surface.insideReference || surface.referenceTransmittance.empty())
                continue;
            const double reference = surface.referenceTransmittance[i];
            radiance[i] = reference < opaque ? 0.0 : radiance[i] / reference;
        }
        result.emission.push_back({factors[j], std::move(radiance)});
    }
}

void multiply(std::vector<double>& values, const std::vector<double>& factors) {
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] *= factors[i];
}

} // namespace

double surfaceTemperature_K(const SurfaceInput& surface) {
    return surface.temperatureScale *
           surfaceTemperature_K(surface.temperature->terms, surface.state);
}

std::vector<double> componentFactors(const SurfaceInput& surface) {
    std::vector<double> factors;
    for (const SpectrumComponent& component : surface.userSpectrum->components) {
        double& factor = factors.emplace_back(1.0);
        for (const ComponentFactor& candidate : surface.temperature->factors)
            if (candidate.component == component.name)
                factor = candidate.at(surface.state);
        factor *= surface.userSpectrum->calibrationFactor;
    }
    return factors;
}

SurfaceSpectra surfaceSpectra(const SurfaceInput& surface,
                              const std::vector<double>& wavelengths_um,
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
    result.reflectance.resize(count);
    result.opacity.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        result.opacity[i] = 1.0 - result.transmissivity[i];
        emissivity[i] = std::clamp(emissivity[i] * surface.emissivityScale, 0.0, result.opacity[i]);
        result.reflectance[i] = (result.opacity[i] - emissivity[i]) / pi;
    }

    // Emission: of a body at the temperature of eq. 7, or as measured.
    if (usesSpectrum) {
        addMeasured(surface, sample, result);
        return result;
    }
    result.temperature_K = surfaceTemperature_K(surface);
    if (!(result.temperature_K > 0.0))
        throw LogicError("a surface temperature that is not positive reached the radiometry");
    std::vector<double> emission(count);
    planckRadiances_W_m2_sr_um(wavelengths_um, result.temperature_K, emission);
    for (std::size_t i = 0; i < count; ++i)
        emission[i] *= emissivity[i];
    result.emission.push_back({1.0, std::move(emission)});
    return result;
}

const std::vector<double>& SurfaceSpectra::quantity(SurfaceQuantity quantity) const {
    switch (quantity) {
    case SurfaceQuantity::reflectance:
        return reflectance;
    case SurfaceQuantity::opacity:
        return opacity;
    case SurfaceQuantity::emission:
        break;
    }
    throw LogicError("the emission of a surface was asked for as a whole");
}

std::vector<double> apparentTerm(const SurfaceSpectra& surface, const RadianceTerms& terms,
                                 std::size_t number, const AirSamples& air) {
    const RadianceTerm& term = terms.terms[number];
    if (term.light && !air.light[number])
        return {};
    std::vector<double> sent;
    if (term.surface == SurfaceQuantity::emission) {
        sent.assign(surface.opacity.size(), 0.0);
        for (const SurfaceSpectra::Emission& part : surface.emission)
            for (std::size_t i = 0; i < sent.size(); ++i)
                sent[i] += part.factor * part.radiance[i];
        if (surface.emissionPassesAir)
            multiply(sent, *air.transmittance);
    } else {
        sent = surface.quantity(term.surface);
    }
    if (term.light)
        multiply(sent, *air.light[number]);
    if (term.passesAir)
        multiply(sent, *air.transmittance);
    return sent;
}

} // namespace irsg

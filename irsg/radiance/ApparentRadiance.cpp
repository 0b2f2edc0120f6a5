#include "irsg/radiance/ApparentRadiance.h"

#include <algorithm>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SurfaceModels.h"

namespace irsg {

namespace {

/// Below this a transmittance ratio is 0 over 0: nothing arrives.
constexpr double opaque = 1e-30;

/// Components of a measured spectrum at the source: what the air up to the reference distance took
/// is given back.
void addMeasured(const SurfaceInput& surface, const SpectrumSampler& sample,
                 SurfaceSpectra& result) {
    result.emissionPassesAtmosphere = !surface.insideReference;
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

DirectionalSpectra directionalSpectra(const SurfaceInput& surface, const SpectrumSampler& sample) {
    const Material& material = *surface.material;
    DirectionalSpectra result;
    result.model = surfaceModelOf(material);
    if (!result.model)
        return result;
    const SurfaceModel& model = *result.model;
    const std::vector<double> transmissivity = sample(material.transmissivity);
    std::vector<std::vector<double>> inputs;
    for (const Spectrum* spectrum : model.inputs(material))
        inputs.push_back(sample(*spectrum));
    constexpr double step = 1e-4;
    std::vector<double> own(inputs.size());
    for (std::size_t i = 0; i < transmissivity.size(); ++i) {
        const double limit = 1.0 - transmissivity[i];
        for (std::size_t input = 0; input < own.size(); ++input)
            own[input] = inputs[input][i];
        const SurfaceModel::Amounts nominal = model.amounts(own, 1.0),
                                    less = model.amounts(own, 1.0 - step);
        result.amounts.push_back(model.amounts(own, surface.emissivityScale));
        SurfaceModel::Amounts& slope = result.perScale.emplace_back();
        for (std::size_t c = 0; c < model.components(); ++c)
            slope[c] = std::max(less[c] - nominal[c], 0.0) / step;
        double left = limit;
        for (std::size_t c = 0; c < model.components(); ++c)
            left -= result.amounts.back()[c] * model.meanAlbedo(c);
        result.emissivity.push_back(std::clamp(left, 0.0, limit));
    }
    return result;
}

SurfaceSpectra lobeSpectra(const SurfaceSpectra& whole, const DirectionalSpectra& directional,
                           std::size_t component, const std::vector<double>& wavelengths_um) {
    const std::size_t count = wavelengths_um.size();
    SurfaceSpectra lobe;
    lobe.emissionPassesAtmosphere = whole.emissionPassesAtmosphere;
    lobe.temperature_K = whole.temperature_K;
    lobe.reflectance.resize(count);
    lobe.emissivity.resize(count);
    lobe.reflectsAtMost.resize(count);
    lobe.emitsAlways.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double amount = directional.amounts[i][component];
        lobe.emissivity[i] = directional.perScale[i][component];
        lobe.reflectsAtMost[i] = amount + lobe.emissivity[i];
        lobe.emitsAlways[i] = -lobe.reflectsAtMost[i];
        lobe.reflectance[i] = amount / pi;
    }
    if (whole.temperature_K > 0.0) {
        std::vector<double> emission(count);
        planckRadiances_W_m2_sr_um(wavelengths_um, whole.temperature_K, emission);
        for (std::size_t i = 0; i < count; ++i)
            emission[i] *= -directional.amounts[i][component];
        lobe.emission.push_back({1.0, std::move(emission)});
    }
    return lobe;
}

SurfaceSpectra specularSpectra(const SurfaceSpectra& whole, SharedValues amount,
                               SharedValues light) {
    SurfaceSpectra lobe;
    lobe.emissionPassesAtmosphere = whole.emissionPassesAtmosphere;
    lobe.temperature_K = whole.temperature_K;
    lobe.lobeAmount = std::move(amount);
    lobe.lobeLight = std::move(light);
    return lobe;
}

SurfaceSpectra surfacesReflection(SurfaceSpectra component) {
    component.reflectsSurfacesAlone = true;
    component.emission.clear();
    component.emitsAlways.clear();
    return component;
}

std::vector<SharedValues> lobeAmounts(const DirectionalSpectra& directional) {
    std::vector<SharedValues> amounts;
    for (std::size_t k = 0; directional.model && k < directional.model->components(); ++k) {
        auto own = std::make_shared<std::vector<double>>();
        own->reserve(directional.amounts.size());
        for (const SurfaceModel::Amounts& all : directional.amounts)
            own->push_back(all[k]);
        amounts.push_back(std::move(own));
    }
    return amounts;
}

namespace {

/// A black body at the temperature of a gas.
SurfaceSpectra gasSpectra(const SurfaceInput& gas, const std::vector<double>& wavelengths_um) {
    const std::size_t count = wavelengths_um.size();
    SurfaceSpectra result;
    result.isGas = true;
    result.temperature_K = gas.temperature_K;
    result.transmissivity.assign(count, 0.0);
    result.reflectance = result.transmissivity;
    result.opacity.assign(count, 1.0);
    result.emissivity = result.opacity;
    std::vector<double> emission(count);
    planckRadiances_W_m2_sr_um(wavelengths_um, gas.temperature_K, emission);
    const double scale = std::clamp(gas.emissivityScale, 0.0, 1.0);
    for (double& value : emission)
        value *= scale;
    result.emission.push_back({1.0, std::move(emission)});
    return result;
}

} // namespace

SurfaceSpectra surfaceSpectra(const SurfaceInput& surface,
                              const std::vector<double>& wavelengths_um,
                              const SpectrumSampler& sample,
                              const DirectionalSpectra& directional) {
    const std::size_t count = wavelengths_um.size();
    const bool usesSpectrum = surface.temperature->mode == EmissionMode::userSpectrum;
    if (usesSpectrum && !surface.userSpectrum)
        throw LogicError("a surface in spectrum mode came without its spectrum");

    if (surface.material->isGas())
        return gasSpectra(surface, wavelengths_um);
    SurfaceSpectra result;
    result.nAngleFactor = directional.model ? 0.0 : surface.material->nAngleFactor;
    result.transmissivity = sample(surface.material->transmissivity);

    // A scaled emissivity stays within what transmission leaves; reflectivity takes the rest.
    const SurfaceModel* model = directional.model.get();
    result.emissivity = model ? directional.emissivity : sample(surface.material->emissivity);
    std::vector<double> emissivity = result.emissivity;
    result.reflectance.resize(count);
    result.opacity.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        result.opacity[i] = 1.0 - result.transmissivity[i];
        emissivity[i] =
            model ? directional.emissivity[i]
                  : std::clamp(emissivity[i] * surface.emissivityScale, 0.0, result.opacity[i]);
        result.reflectance[i] = (result.opacity[i] - emissivity[i]) / pi;
        if (!model)
            continue;
        double perScale = 0.0;
        for (std::size_t k = 0; k < model->components(); ++k)
            perScale += directional.perScale[i][k] * model->meanAlbedo(k);
        result.emissivity[i] = perScale;
        result.reflectsAtMost.push_back(pi * result.reflectance[i] + perScale);
        result.emitsAlways.push_back(result.opacity[i] - result.reflectsAtMost[i]);
    }

    // Emission: of a body at the temperature of eq. 7, or as measured.
    if (usesSpectrum) {
        addMeasured(surface, sample, result);
        return result;
    }
    result.temperature_K = surface.temperature_K;
    if (!(result.temperature_K > 0.0))
        throw LogicError("a surface temperature that is not positive reached the radiometry");
    std::vector<double> emission(count);
    planckRadiances_W_m2_sr_um(wavelengths_um, result.temperature_K, emission);
    for (std::size_t i = 0; i < count; ++i)
        emission[i] *= emissivity[i];
    result.emission.push_back({1.0, std::move(emission)});
    return result;
}

bool SurfaceSpectra::isWithout(SurfaceQuantity quantity) const {
    switch (quantity) {
    case SurfaceQuantity::reflectance:
        return reflectance.empty() || reflectsSurfacesAlone || isGas;
    case SurfaceQuantity::opacity:
        return opacity.empty();
    case SurfaceQuantity::specular:
        return !lobeLight;
    case SurfaceQuantity::emission:
        break;
    }
    return emission.empty();
}

const std::vector<double>& SurfaceSpectra::quantity(SurfaceQuantity quantity) const {
    switch (quantity) {
    case SurfaceQuantity::reflectance:
        return reflectance;
    case SurfaceQuantity::opacity:
        return opacity;
    case SurfaceQuantity::specular:
        return *lobeAmount;
    case SurfaceQuantity::emission:
        break;
    }
    throw LogicError("the emission of a surface was asked for as a whole");
}

std::vector<double> apparentTerm(const SurfaceSpectra& surface, const RadianceTerms& terms,
                                 std::size_t number, const AtmosphereSamples& air) {
    const RadianceTerm& term = terms.terms[number];
    if ((term.light && !air.light[number]) || surface.isWithout(term.surface))
        return {};
    std::vector<double> sent;
    if (term.surface == SurfaceQuantity::emission) {
        sent.assign(air.transmittance->size(), 0.0);
        for (const SurfaceSpectra::Emission& part : surface.emission)
            for (std::size_t i = 0; i < sent.size(); ++i)
                sent[i] += part.factor * part.radiance[i];
        if (surface.emissionPassesAtmosphere)
            multiply(sent, *air.transmittance);
    } else {
        sent = surface.quantity(term.surface);
        if (term.surface == SurfaceQuantity::specular)
            multiply(sent, *surface.lobeLight);
    }
    if (term.light)
        multiply(sent, *air.light[number]);
    if (term.passesAtmosphere)
        multiply(sent, *air.transmittance);
    return sent;
}

} // namespace irsg

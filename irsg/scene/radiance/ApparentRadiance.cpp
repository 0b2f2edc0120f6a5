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

SurfaceSpectra apparentRadiance(const SurfaceInput& surface, const AirSamples& air,
                                const std::vector<double>& wavelengths_um,
                                const SpectrumSampler& sample) {
    const std::size_t count = wavelengths_um.size();
    const bool usesSpectrum = surface.temperature->mode == EmissionMode::userSpectrum;
    if (usesSpectrum && !surface.userSpectrum)
        throw LogicError("a surface in spectrum mode came without its spectrum");

    SurfaceSpectra result;
    result.nAngleFactor = surface.material->nAngleFactor;
    result.transmissivity = sample(surface.material->transmissivity);
    result.thermal.resize(count);
    result.up.resize(count);
    result.down.resize(count);
    result.sun.resize(count);
    result.path.resize(count);

    // A scaled emissivity stays within what transmission leaves; reflectivity takes the rest.
    result.emissivity = sample(surface.material->emissivity);
    std::vector<double> emissivity = result.emissivity;
    std::vector<double> reflectivity(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double absorbedAtMost = 1.0 - result.transmissivity[i];
        emissivity[i] = std::clamp(emissivity[i] * surface.emissivityScale, 0.0, absorbedAtMost);
        reflectivity[i] = absorbedAtMost - emissivity[i];
    }

    // Emission: of a body at the temperature of eq. 7, or as measured.
    if (usesSpectrum) {
        const std::vector<double> source = userRadiance(surface, sample, count);
        for (std::size_t i = 0; i < count; ++i)
            result.thermal[i] = surface.emissivityScale * source[i] *
                                beyondReference(surface, air.transmittance[i], i);
    } else {
        result.temperature_K = surfaceTemperature_K(surface);
        if (!(result.temperature_K > 0.0))
            throw LogicError("a surface temperature that is not positive reached the radiometry");
        for (std::size_t i = 0; i < count; ++i)
            result.thermal[i] = emissivity[i] *
                                planckRadiance_W_m2_sr_um(wavelengths_um[i], result.temperature_K) *
                                air.transmittance[i];
    }

    // Reflection of a Lambertian surface, and the air in front of it.
    for (std::size_t i = 0; i < count; ++i) {
        const double reflected = reflectivity[i] * air.transmittance[i] / pi;
        result.up[i] = reflected * air.upwardFlux[i];
        result.down[i] = reflected * air.downwardFlux[i];
        result.sun[i] = reflected * air.solarIrradiance[i];
        result.path[i] = (1.0 - result.transmissivity[i]) * air.pathRadiance[i];
    }
    return result;
}

} // namespace irsg

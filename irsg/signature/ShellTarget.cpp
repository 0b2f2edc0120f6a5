#include "irsg/signature/ShellTarget.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/FacetAlbedos.h"
#include "irsg/signature/Fresnel.h"

namespace irsg {

std::vector<double> ShellTarget::keyOf(const Material& material) {
    if (!(material.refractiveIndex.minimum() > 0.0))
        throw InputError(Diagnostic{material.name, "refractiveIndex",
                                    numberText(material.refractiveIndex.minimum()),
                                    "n above 0 at every wavelength, which this model needs"});
    return {4.0, material.roughness, material.shadowTau_deg, material.shadowOmega_deg};
}

ShellTarget::ShellTarget(const Material& material)
    : SurfaceModel(Microfacets(FacetDistribution::beckmann, material.roughness), diffuse, count,
                   keyOf(material)),
      shadowTau_rad_(radians(material.shadowTau_deg)),
      shadowOmega_rad_(radians(material.shadowOmega_deg)) {
    std::array<std::vector<double>, count> albedos;
    std::vector<double> excess;
    for (std::size_t node = 0; node <= albedoIntervals; ++node) {
        const double root = static_cast<double>(node) / albedoIntervals;
        const double cosine = std::max(root * root, 1e-5);
        FresnelShapes::Values sums{};
        overFacets(microfacets(), cosine,
                   [&](const SurfaceDirection& to, const SurfaceDirection& facet, double weight) {
                       for (std::size_t k = 0; k < sums.size(); ++k)
                           sums[k] += facetWeight(k, to, facet) * weight;
                   });
        const double white = std::max(std::accumulate(sums.begin(), sums.end(), 0.0), 1.0);
        for (std::size_t k = 0; k < sums.size(); ++k)
            albedos[k].push_back(sums[k] / white);
        excess.push_back(white);
        albedos[diffuse].push_back(1.0);
        albedos[volume].push_back(4.0 * (1.0 - cosine * std::log1p(1.0 / cosine)));
    }
    for (std::size_t k = 0; k < count; ++k)
        setAlbedos(k, std::move(albedos[k]));
    setExcess(std::move(excess));
}

double ShellTarget::shadowing(double cosineToFacet, double cosineOfTilt) const {
    const double tilt = std::acos(std::min(cosineOfTilt, 1.0)) / shadowOmega_rad_;
    const double beta = std::acos(std::min(cosineToFacet, 1.0));
    return (1.0 + tilt * std::exp(-2.0 * beta / shadowTau_rad_)) / (1.0 + tilt);
}

double ShellTarget::brdf_per_sr(std::size_t k, const SurfaceDirection& to,
                                const SurfaceDirection& from, const SlopeSpread& spread) const {
    if (!(to.z > 0.0) || !(from.z > 0.0))
        return 0.0;
    if (k == diffuse)
        return 1.0 / pi;
    if (k == volume)
        return 2.0 / (pi * (to.z + from.z));
    const SurfaceDirection facet = halfway(to, from);
    const double cosine = dot(to, facet);
    return FresnelShapes::at(cosine)[k] * microfacets().density_per_sr(facet, spread) *
           shadowing(cosine, facet.z) / (4.0 * to.z * from.z);
}

std::vector<const Spectrum*> ShellTarget::inputs(const Material& material) const {
    return {&material.transmissivity, &material.refractiveIndex, &material.extinction,
            &material.diffuseReflectivity, &material.volumeReflectivity};
}

SurfaceModel::Amounts ShellTarget::amounts(std::span<const double> inputs, double scale) const {
    const double rest = 1.0 - inputs[0];
    Amounts all{};
    std::ranges::transform(FresnelShapes::amountsOf(inputs[1], inputs[2]), all.begin(),
                           [&](double value) { return std::min(value, rest); });
    all[diffuse] = inputs[3];
    all[volume] = inputs[4];
    return scaledReflection(all, rest, scale);
}

} // namespace irsg

#include "irsg/signature/FacetModel.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Units.h"
#include "irsg/signature/FacetAlbedos.h"
#include "irsg/signature/Fresnel.h"

namespace irsg {

namespace {

/// Reflected among facets more than once, as a part of what the white ones would.
double reflectedOnTheWay(double mean, double whiteMean) {
    return mean * mean * whiteMean / (1.0 - mean * (1.0 - whiteMean));
}

FacetDistribution distributionOf(const Material& material) {
    return material.surfaceModel == "ggx" ? FacetDistribution::ggx : FacetDistribution::beckmann;
}

} // namespace

std::vector<double> FacetModel::keyOf(const Material& material) {
    return {distributionOf(material) == FacetDistribution::ggx ? 1.0 : 2.0, material.roughness,
            material.hasIndex() ? 1.0 : 0.0};
}

FacetModel::FacetModel(const Material& material)
    : FacetModel(distributionOf(material), material.roughness, material.hasIndex()) {}

FacetModel::FacetModel(FacetDistribution distribution, double roughness, bool usesIndex)
    : SurfaceModel(
          Microfacets(distribution, roughness), usesIndex ? 3 : 2, usesIndex ? 4 : 3,
          {distribution == FacetDistribution::ggx ? 1.0 : 2.0, roughness, usesIndex ? 1.0 : 0.0}),
      usesIndex_(usesIndex) {
    fillAlbedos();
}

void FacetModel::fillAlbedos() {
    std::array<std::vector<double>, mostComponents> albedos;
    for (std::size_t node = 0; node <= albedoIntervals; ++node) {
        const double root = static_cast<double>(node) / albedoIntervals;
        const double cosine = std::max(root * root, 1e-5);
        std::array<double, mostComponents> sums{};
        overFacets(microfacets(), cosine,
                   [&](const SurfaceDirection& to, const SurfaceDirection& facet, double weight) {
                       for (std::size_t k = 0; k < lobes(); ++k)
                           sums[k] += facetWeight(k, to, facet) * weight;
                   });
        // White: amounts of 1, 1 and the raised dip. Sums over facets may pass 1 by rounding.
        const double white = sums[0] + sums[1] + FresnelShapes::raisedDip * sums[2];
        for (std::size_t k = 0; k < lobes(); ++k)
            albedos[k].push_back(sums[k] / std::max(white, 1.0));
        albedos[lobes()].push_back(std::max(1.0 - white, 0.0));
    }
    for (std::size_t k = 0; k < components(); ++k)
        setAlbedos(k, std::move(albedos[k]));
}

double FacetModel::facetWeight(std::size_t k, const SurfaceDirection& to,
                               const SurfaceDirection& facet) const {
    return facetWeights(to, facet)[k];
}

SurfaceModel::Amounts FacetModel::facetWeights(const SurfaceDirection& to,
                                               const SurfaceDirection& facet) const {
    Amounts all{};
    const double cosine = dot(to, facet);
    const SurfaceDirection from = mirrored(to, facet);
    if (!(cosine > 0.0) || !(from.z > 0.0) || !(to.z > 0.0))
        return all;
    const double seen = microfacets().visible(to.z, from.z);
    for (std::size_t k = 0; k < lobes(); ++k)
        all[k] = FresnelShapes::part(k, cosine, usesIndex_) * seen * cosine / (to.z * facet.z);
    return all;
}

double FacetModel::brdf_per_sr(std::size_t k, const SurfaceDirection& to,
                               const SurfaceDirection& from, const SlopeSpread& spread) const {
    if (!(to.z > 0.0) || !(from.z > 0.0))
        return 0.0;
    if (!hasLobe(k)) {
        const double lost = meanAlbedo(k);
        return lost > 0.0 ? albedo(k, to.z) * albedo(k, from.z) / (pi * lost) : 0.0;
    }
    const SurfaceDirection facet = halfway(to, from);
    return FresnelShapes::part(k, dot(to, facet), usesIndex_) *
           microfacets().density_per_sr(facet, spread) * microfacets().visible(to.z, from.z) /
           (4.0 * to.z * from.z);
}

SurfaceModel::Amounts FacetModel::amounts(double normal, double limit, double dip) const {
    const double white = 1.0 - meanAlbedo(lobes());
    const double mean =
        normal + (limit - normal) * FresnelShapes::meanSchlick + dip * FresnelShapes::meanDip;
    Amounts all{};
    all[0] = normal;
    all[1] = limit;
    if (usesIndex_)
        all[2] = std::max(FresnelShapes::raisedDip * normal + dip, 0.0);
    all[lobes()] = reflectedOnTheWay(std::clamp(mean, 0.0, 1.0), white);
    return all;
}

std::vector<const Spectrum*> FacetModel::inputs(const Material& material) const {
    if (usesIndex_)
        return {&material.emissivity, &material.transmissivity, &material.refractiveIndex,
                &material.extinction};
    return {&material.emissivity, &material.transmissivity};
}

SurfaceModel::Amounts FacetModel::amounts(std::span<const double> inputs, double scale) const {
    // A scale multiplies emissivity at every angle, and so the dip of Fresnel's curve.
    const double limit = 1.0 - inputs[1];
    const double along =
        usesIndex_ ? std::max(limit - normalReflectivity(inputs[2], inputs[3]), 0.0) : inputs[0];
    const double dip = usesIndex_ ? FresnelShapes::dipOf(inputs[2], inputs[3]) : 0.0;
    return amounts(limit - std::clamp(scale * along, 0.0, limit), limit, scale * dip);
}

} // namespace irsg

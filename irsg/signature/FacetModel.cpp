#include "irsg/signature/FacetModel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "irsg/core/Errors.h"
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
          Microfacets(distribution, roughness), lobesOf(usesIndex), lobesOf(usesIndex) + 1,
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
        // White: amounts of 1. Sums over facets may pass 1 by rounding.
        const double white = std::accumulate(sums.begin(), sums.end(), 0.0);
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
    all = shapesAt(cosine);
    const double seen = microfacets().visible(to.z, from.z) * cosine / (to.z * facet.z);
    for (std::size_t k = 0; k < lobes(); ++k)
        all[k] *= seen;
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
    return shapesAt(dot(to, facet))[k] * microfacets().density_per_sr(facet, spread) *
           microfacets().visible(to.z, from.z) / (4.0 * to.z * from.z);
}

SurfaceModel::Amounts FacetModel::shapesAt(double cosine) const {
    Amounts all{};
    if (usesIndex_) {
        std::ranges::copy(FresnelShapes::at(cosine), all.begin());
        return all;
    }
    all[1] = FresnelShapes::schlick(cosine);
    all[0] = 1.0 - all[1];
    return all;
}

SurfaceModel::Amounts FacetModel::amounts(std::span<const double> reflectivities) const {
    if (reflectivities.size() != lobes())
        throw LogicError("reflectivities of " + std::to_string(reflectivities.size()) +
                         " shapes where there are " + std::to_string(lobes()));
    const double white = 1.0 - meanAlbedo(lobes());
    double mean = 0.0;
    Amounts all{};
    for (std::size_t k = 0; k < lobes(); ++k) {
        all[k] = reflectivities[k];
        mean += all[k] * (usesIndex_ ? FresnelShapes::means()[k]
                          : k == 0   ? 1.0 - FresnelShapes::meanSchlick
                                     : FresnelShapes::meanSchlick);
    }
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
    // A scale multiplies emissivity at every angle.
    const double limit = 1.0 - inputs[1];
    const auto scaled = [&](double emissivity) {
        return limit - std::clamp(scale * emissivity, 0.0, limit);
    };
    if (!usesIndex_)
        return amounts(std::array{scaled(inputs[0]), limit});
    FresnelShapes::Values values = FresnelShapes::amountsOf(inputs[2], inputs[3]);
    for (double& value : values)
        value = scaled(std::max(limit - value, 0.0));
    return amounts(values);
}

} // namespace irsg

#include "irsg/signature/SandfordRobertson.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Units.h"

namespace irsg {

std::vector<double> SandfordRobertson::keyOf(const Material& material) {
    return {3.0, material.roughness, material.grazingFactor};
}

SandfordRobertson::SandfordRobertson(const Material& material)
    // h is pi / e^2 times the facets of Trowbridge and Reitz.
    : SurfaceModel(Microfacets(FacetDistribution::ggx, material.roughness), diffuse, count,
                   keyOf(material)),
      squaredGrazing_(material.grazingFactor * material.grazingFactor) {
    const double b = squaredGrazing_, left = 1.0 - b;
    // Near b = 1 by its series, 1/2 + (1 - b^2) / 6.
    if (b > 0.0)
        meanGrazing_ =
            std::abs(left) < 1e-4 ? 0.5 + left / 6.0 : (1.0 + b * std::log(b) / left) / left;
    std::array<std::vector<double>, count> albedos;
    for (std::size_t node = 0; node <= albedoIntervals; ++node) {
        const double root = static_cast<double>(node) / albedoIntervals;
        const double g = grazing(root * root);
        albedos[atGrazing].push_back(1.0 - g);
        albedos[alongNormal].push_back(g);
        albedos[diffuse].push_back(g / meanGrazing_);
    }
    for (std::size_t k = 0; k < count; ++k)
        setAlbedos(k, std::move(albedos[k]));
}

double SandfordRobertson::grazing(double cosine) const {
    const double square = cosine * cosine;
    return squaredGrazing_ == 0.0 ? 1.0 : square / (square + squaredGrazing_ * (1.0 - square));
}

double SandfordRobertson::lobeIntegral(double width, double cosine) {
    const double square = width * width, left = 1.0 - square, projected = left * cosine;
    return (projected + (2.0 * square + projected * projected) /
                            std::sqrt(projected * projected + 4.0 * square)) /
           (2.0 * square);
}

double SandfordRobertson::brdf_per_sr(std::size_t k, const SurfaceDirection& to,
                                      const SurfaceDirection& from,
                                      const SlopeSpread& spread) const {
    if (!(to.z > 0.0) || !(from.z > 0.0))
        return 0.0;
    const double g = grazing(from.z);
    if (k == diffuse)
        return g * grazing(to.z) / (pi * meanGrazing_ * meanGrazing_);
    const double part = k == alongNormal ? g : 1.0 - g;
    const double width = roughness();
    return part * microfacets().density_per_sr(halfway(to, from), spread) /
           (4.0 * width * width * lobeIntegral(width, from.z) * to.z);
}

std::vector<const Spectrum*> SandfordRobertson::inputs(const Material& material) const {
    return {&material.emissivity, &material.transmissivity, &material.diffuseReflectivity};
}

SurfaceModel::Amounts SandfordRobertson::amounts(std::span<const double> inputs,
                                                 double scale) const {
    const double limit = 1.0 - inputs[1];
    Amounts all{};
    all[atGrazing] = limit;
    all[alongNormal] = std::max(limit - (inputs[2] + scale * inputs[0]) / meanGrazing_, 0.0);
    all[diffuse] = inputs[2];
    return all;
}

} // namespace irsg

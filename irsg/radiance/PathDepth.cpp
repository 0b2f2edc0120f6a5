#include "irsg/radiance/PathDepth.h"

#include <cmath>

namespace irsg {

namespace {

/// The path radiance in air of another depth, in that of the air.
double emissionAtDepth(double transmittance, double depth) {
    if (transmittance >= 1.0)
        return depth;
    if (transmittance <= 0.0)
        return 1.0;
    const double logarithm = std::log(transmittance);
    return std::expm1(depth * logarithm) / std::expm1(logarithm);
}

SharedValues shared(std::vector<double> values) {
    return std::make_shared<const std::vector<double>>(std::move(values));
}

} // namespace

std::vector<double> ThroughDepth::of(const std::vector<double>& behind, std::size_t first) const {
    std::vector<double> seen(behind.size());
    for (std::size_t i = 0; i < seen.size(); ++i)
        seen[i] = factor[first + i] * behind[i] + offset[first + i];
    return seen;
}

void deepenPaths(AtmosphericQueryCache& answers, const AtmosphereScene& scene, SampledBand& band) {
    const double depth = scene.pathDepth;
    band.behind.clear();
    if (depth == 1.0)
        return;
    for (std::size_t e = 0; e < scene.geometry.size(); ++e) {
        ObjectAtmosphere& object = band.air.objects[e];
        for (AtmosphereSamples& node : object.nodes) {
            const std::vector<double>& passes = *node.transmittance;
            for (std::size_t k = 0; k < scene.terms.terms.size(); ++k) {
                const auto& light = scene.terms.terms[k].light;
                if (!light || !node.light[k] || geometryOf(*light) != QueryGeometry::path)
                    continue;
                std::vector<double> sent = *node.light[k];
                for (std::size_t i = 0; i < sent.size(); ++i)
                    sent[i] *= emissionAtDepth(passes[i], depth);
                node.light[k] = shared(std::move(sent));
            }
            std::vector<double> deep = passes;
            for (double& value : deep)
                value = std::pow(value, depth);
            node.transmittance = shared(std::move(deep));
        }
        if (object.beforeGas)
            object.beforeGas->length_m *= depth;

        const AtmosphericPath& path = scene.geometry[e].path;
        const SharedValues passes =
            answers.at(AtmosphericQuery::transmittance(path), band.sampling).value;
        const SharedValues sent =
            answers
                .at(AtmosphericQuery::pathRadiance(path, answers.environment().sun), band.sampling)
                .value;
        ThroughDepth& behind = band.behind.emplace_back();
        for (std::size_t i = 0; i < passes->size(); ++i) {
            const double tau = (*passes)[i];
            // Opaque air hides all of it, of whatever depth.
            const double factor = tau > 0.0 ? std::pow(tau, depth - 1.0) : 0.0;
            behind.factor.push_back(factor);
            behind.offset.push_back((*sent)[i] * (emissionAtDepth(tau, depth) - factor));
        }
    }
    if (band.air.background && scene.lookedAt < band.behind.size())
        band.air.background = shared(band.behind[scene.lookedAt].of(*band.air.background));
}

} // namespace irsg

#include "irsg/scattering/SmallAngleMtf.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/GaussLegendre.h"

namespace irsg {

namespace {

/// Of the nodes between which P is integrated: ratio, the first and the rule.
constexpr double nodeRatio = 1.06, firstNode_per_rad = 0.01;
constexpr int nodesOfPiece = 4;

} // namespace

std::vector<ScatteringLayer> normalised(const std::vector<ScatteringLayer>& layers) {
    double thickness = 0.0, depth = 0.0;
    for (const ScatteringLayer& layer : layers) {
        if (!(layer.thickness > 0.0) || !(layer.concentration >= 0.0) ||
            !std::isfinite(layer.thickness) || !std::isfinite(layer.concentration))
            throw InputError({"", "layer",
                              numberText(layer.thickness) + ":" + numberText(layer.concentration),
                              "a thickness above 0 and a concentration of at least 0"});
        thickness += layer.thickness;
        depth += layer.thickness * layer.concentration;
    }
    if (!(depth > 0.0))
        throw InputError({"", "layers", "no droplets in any of them", "one that scatters"});
    std::vector<ScatteringLayer> result;
    for (const ScatteringLayer& layer : layers)
        result.push_back({layer.thickness / thickness, layer.concentration * thickness / depth});
    return result;
}

SmallAngleMtf::SmallAngleMtf(const PhaseFunction& phase, const std::vector<ScatteringLayer>& layers,
                             double highestFrequency_per_rad)
    : layers_(normalised(layers)), nodes_{0.0} {
    for (double node = firstNode_per_rad; nodes_.back() < highestFrequency_per_rad;
         node *= nodeRatio)
        nodes_.push_back(node);
    transforms_.resize(nodes_.size());
    std::vector<double> pieces(nodes_.size() - 1, 0.0);
    const GaussRule& rule = gaussLegendre(nodesOfPiece);
    parallelFor(nodes_.size(), [&](std::size_t i) {
        transforms_[i] = phase.transform(nodes_[i]);
        if (i + 1 == nodes_.size())
            return;
        const double width = nodes_[i + 1] - nodes_[i];
        for (std::size_t k = 0; k < rule.nodes.size(); ++k)
            pieces[i] +=
                width * rule.weights[k] * phase.transform(nodes_[i] + width * rule.nodes[k]);
    });
    integrals_.push_back(0.0);
    for (const double piece : pieces)
        integrals_.push_back(integrals_.back() + piece);
}

double SmallAngleMtf::integral(double frequency_per_rad) const {
    // A cubic through the integrals and their derivatives, which are P itself.
    const auto [i, k, t] = bracket(nodes_, frequency_per_rad, Beyond::extrapolate);
    const double h = nodes_[k] - nodes_[i], s = 1.0 - t;
    return integrals_[i] * s * s * (1.0 + 2.0 * t) + integrals_[k] * t * t * (1.0 + 2.0 * s) +
           h * t * s * (transforms_[i] * s - transforms_[k] * t);
}

double SmallAngleMtf::meanTransform(double frequency_per_rad) const {
    const double k = frequency_per_rad;
    if (!(k > 0.0))
        return transforms_.front();
    // Layers come from the sensor, where s is 1.
    double sum = 0.0, s = 1.0;
    for (const ScatteringLayer& layer : layers_) {
        const double next = std::max(s - layer.thickness, 0.0);
        sum += layer.concentration * (integral(k * s) - integral(k * next)) / k;
        s = next;
    }
    return sum;
}

MtfCurve SmallAngleMtf::curve(double opticalDepth,
                              const std::vector<double>& frequencies_per_rad) const {
    std::vector<double> values;
    for (const double frequency : frequencies_per_rad)
        values.push_back(std::exp(opticalDepth * meanTransform(frequency)));
    return {frequencies_per_rad, std::move(values)};
}

std::vector<double> mtfFrequencies(double lowest, double highest, int count) {
    if (!(lowest > 0.0 && highest > lowest) || count < 3)
        throw InputError({"", "frequencies",
                          numberText(lowest) + " to " + numberText(highest) + ", " +
                              std::to_string(count) + " points",
                          "0 < lowest < highest, cycles per radian, and 3 points or more"});
    std::vector<double> result{0.0};
    for (int i = 0; i < count - 1; ++i)
        result.push_back(lerpByRatio(lowest, highest, static_cast<double>(i) / (count - 2)));
    return result;
}

} // namespace irsg

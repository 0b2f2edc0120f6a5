#include "irsg/radiometry/Quadrature.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/PlanckPanels.h"

namespace irsg {

SpectralQuadrature::SpectralQuadrature(const Band& band,
                                       std::span<const Spectrum* const> breakpoints,
                                       double coldest_K) {
    std::vector<const Spectrum*> kinked(breakpoints.begin(), breakpoints.end());
    kinked.push_back(&band.response());
    const std::vector<double> edges = mergeAxes(kinked, band.range());

    std::vector<double> wavelengths_um, weights_um;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        std::vector<PlanckPanel> pieces = planckPanels({edges[i], edges[i + 1]}, coldest_K);
        std::ranges::reverse(pieces);
        for (const PlanckPanel& piece : pieces) {
            const GaussRule& rule = gaussLegendre(piece.points);
            for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
                wavelengths_um.push_back(piece.range.min_um +
                                         piece.range.width_um() * rule.nodes[k]);
                weights_um.push_back(piece.range.width_um() * rule.weights[k]);
            }
        }
    }
    const std::vector<double> responses = band.response().sample(wavelengths_um);
    std::ranges::transform(weights_um, responses, weights_um.begin(), std::multiplies<>());
    setNodes(std::move(wavelengths_um), std::move(weights_um), band.range());
}

} // namespace irsg

#include "irsg/radiometry/AxisToNodes.h"

#include <numeric>

namespace irsg {

void AxisToNodes::add(std::size_t nodes, std::size_t first, std::span<const double> weights) {
    groups_.push_back({nodes, first, weights.size()});
    weights_.insert(weights_.end(), weights.begin(), weights.end());
    nodes_ += nodes;
}

std::vector<double> AxisToNodes::sampled(std::span<const double> values) const {
    std::vector<double> atNodes;
    atNodes.reserve(nodes_);
    const double* weight = weights_.data();
    for (const Group& group : groups_) {
        const std::span<const double> own = values.subspan(group.first, group.weights);
        atNodes.insert(atNodes.end(), group.nodes,
                       std::inner_product(own.begin(), own.end(), weight, 0.0));
        weight += group.weights;
    }
    return atNodes;
}

} // namespace irsg

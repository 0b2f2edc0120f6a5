#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "irsg/core/Interpolation.h"

namespace smat::tables {

/// A curve given at a few wavenumbers, linear between and clamped beyond.
class NodeCurve {
  public:
    explicit NodeCurve(std::vector<double> nodes_per_cm)
        : nodes_per_cm_(std::move(nodes_per_cm)), values_(nodes_per_cm_.size(), 0.0) {}

    struct Share {
        std::size_t node;
        double weight;
    };
    /// The two nodes about a wavenumber and what each contributes.
    std::array<Share, 2> shares(double wavenumber_per_cm) const {
        const auto [below, above, part] = irsg::bracket(nodes_per_cm_, wavenumber_per_cm);
        return {{{below, 1.0 - part}, {above, part}}};
    }
    double at(double wavenumber_per_cm) const {
        double sum = 0.0;
        for (const Share& share : shares(wavenumber_per_cm))
            sum += share.weight * values_[share.node];
        return sum;
    }
    std::size_t size() const { return nodes_per_cm_.size(); }
    double node_per_cm(std::size_t node) const { return nodes_per_cm_[node]; }
    double& value(std::size_t node) { return values_[node]; }
    double value(std::size_t node) const { return values_[node]; }

  private:
    std::vector<double> nodes_per_cm_, values_;
};

} // namespace smat::tables

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace irsg {

/// Brings spectra that share an axis to nodes: each node has a weighted sum of the values of a few
/// places of the axis that follow each other. What the sums are made of is found once for all
/// spectra.
class AxisToNodes {
  public:
    /// The next `nodes` nodes have the sum of `weights` times the values from place `first` on.
    void add(std::size_t nodes, std::size_t first, std::span<const double> weights);
    /// The values at all nodes, in the order in which they were added.
    std::vector<double> sampled(std::span<const double> values) const;

  private:
    struct Group {
        std::size_t nodes = 0, first = 0, weights = 0; ///< the last: how many
    };
    std::vector<Group> groups_;
    std::vector<double> weights_; ///< group after group
    std::size_t nodes_ = 0;
};

} // namespace irsg

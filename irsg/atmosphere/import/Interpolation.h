#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "irsg/core/Interpolation.h"

namespace irsg {

/// How well a table predicts its own nodes: each interior node along an axis is left out and
/// predicted from its neighbours, which are twice as far apart as in the table. The error of the
/// whole table is smaller, by a factor of about 4 where interpolation is linear and more where it
/// is cubic. Transmittances are compared as they are; radiances and irradiances relative to the
/// largest of their spectrum.
struct InterpolationError {
    std::string quantity;  ///< "transmittance"
    std::string axis;      ///< "range"
    std::size_t nodes = 0; ///< that were left out; 0: no interior node, nothing is known
    double worst = 0.0;    ///< of all wavenumbers and nodes
    double rms = 0.0;

    bool isKnown() const { return nodes > 0; }
};

/// Gathers the differences of one axis.
class ErrorSum {
  public:
    void add(double difference) {
        worst_ = std::max(worst_, std::abs(difference));
        squares_ += difference * difference;
        ++count_;
    }
    void endNode() { ++nodes_; }
    InterpolationError result(std::string quantity, std::string axis) const {
        return {std::move(quantity), std::move(axis), nodes_, worst_,
                count_ == 0 ? 0.0 : std::sqrt(squares_ / static_cast<double>(count_))};
    }

  private:
    double worst_ = 0.0;
    double squares_ = 0.0;
    std::size_t count_ = 0;
    std::size_t nodes_ = 0;
};

/// Where `value` lies on an ascending axis; no value where it is outside by more than `tolerance`,
/// else it is clamped. At a node, above is below: no neighbour takes part.
std::optional<Bracket> bracketOf(std::span<const double> axis, double value, double tolerance);

/// A length to the millimetre, without exponent: "100000", "9235.9".
std::string metresText(double length_m);

} // namespace irsg

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "irsg/image/ImageStatistics.h"

namespace irsg {

/// The smallest of 1, 2, 5 times a power of ten that is not below `least` (> 0), and that power.
std::pair<double, int> roundStep(double least);

/// Where an axis is marked and what stands there.
struct AxisTicks {
    std::vector<double> values;      ///< ascending, inside the limits
    std::vector<std::string> labels; ///< values / 10^exponent, all with as many decimals
    int exponent = 0;                ///< a multiple of 3; not 0 below 0.01 and from 100000 on
};

/// Ticks at multiples of 1, 2 or 5 times a power of ten, as many as fit but at most `mostTicks`
/// (>= 2); where colours do not follow values linearly, at round numbers about as far from each
/// other along the colours, with labels of one or two digits each. Limits that are too close for
/// that are marked at their ends. InputError unless low < high, both finite.
AxisTicks axisTicks(const DisplayLimits& limits, int mostTicks);

/// "W m-2 sr-1" as it is set: "W·m⁻²·sr⁻¹". Text that is no such product comes back unchanged.
std::string prettyUnit(const std::string& unit);
/// An integer in superscript digits: "⁻³".
std::string superscript(int number);

} // namespace irsg

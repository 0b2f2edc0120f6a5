#pragma once

#include <limits>

namespace irsg {

/// What a figure of an image is that has no value: the mean of no pixels, a temperature of nothing.
inline constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace irsg

#pragma once

#include "irsg/radiometry/Units.h"

namespace irsg {

/// Half of the angle under which the disc of the sun is seen, 0.53 degrees over all.
inline constexpr double sunDiscRadius_rad = radians(0.265);

/// The disc of the sun as a horizon cuts it.
struct VisibleSun {
    double part = 1.0; ///< of the area of the disc that is above the horizon, 0 to 1
    /// Of the middle of that part above the middle of the disc, 0 to the disc's radius.
    double middleAbove_rad = 0.0;
};

/// Of a disc whose middle stands at an angle above the horizon (below: negative). The horizon is a
/// straight line: with x = angle / radius, the part is 1/2 + (asin x + x sqrt(1 - x^2)) / pi and
/// its middle radius * 2 (1 - x^2)^(3/2) / (3 pi part) above that of the disc. Both are continuous.
VisibleSun visibleSun(double middleAboveHorizon_rad);

} // namespace irsg

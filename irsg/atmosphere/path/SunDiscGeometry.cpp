#include "irsg/atmosphere/path/SunDiscGeometry.h"

#include <algorithm>
#include <cmath>

namespace irsg {

VisibleSun visibleSun(double middleAboveHorizon_rad) {
    const double x = middleAboveHorizon_rad / sunDiscRadius_rad;
    if (x >= 1.0)
        return {1.0, 0.0};
    if (x <= -1.0)
        return {0.0, sunDiscRadius_rad};
    const double halfChord = std::sqrt((1.0 - x) * (1.0 + x));
    const double part = 0.5 + (std::asin(x) + x * halfChord) / pi;
    // Of a sliver the difference above has lost its digits: 1 + x is then its thickness, and the
    // area (4/3) sqrt(2) (1 + x)^(3/2) / pi with the middle at 3/5 of the thickness below the rim.
    if (x < -0.9999) {
        const double thick = 1.0 + x;
        return {4.0 / 3.0 * std::sqrt(2.0 * thick) * thick / pi,
                sunDiscRadius_rad * (1.0 - 0.6 * thick)};
    }
    const double middle = 2.0 * halfChord * halfChord * halfChord / (3.0 * pi * part);
    return {std::clamp(part, 0.0, 1.0), sunDiscRadius_rad * std::clamp(middle, 0.0, 1.0)};
}

} // namespace irsg

#include "irsg/render/background/Horizon.h"

#include <algorithm>
#include <cmath>

namespace irsg {

Horizon::Horizon(const FieldRays& rays, double elevation_rad)
    : elevation_rad_(elevation_rad),
      sine_(std::sin(elevation_rad)),
      pitch_(rays.pitch),
      rightZ_(rays.right.z),
      upZ_(rays.up.z),
      forwardZ_(rays.forward.z) {}

Horizon::Line Horizon::lineAt(double u, double v) const {
    // A direction d is sky where z(d) - |d| sin(horizon) is positive.
    const double distance = std::sqrt(1.0 + u * u + v * v);
    return {forwardZ_ + u * rightZ_ + v * upZ_ - sine_ * distance, rightZ_ - sine_ * u / distance,
            upZ_ - sine_ * v / distance};
}

double Horizon::skyFraction(double u, double v) const {
    const Line line = lineAt(u, v);
    const double steep = std::max(std::abs(line.slopeU), std::abs(line.slopeV)) * pitch_;
    const double flat = std::min(std::abs(line.slopeU), std::abs(line.slopeV)) * pitch_;
    const double reach = 0.5 * (steep + flat);
    if (line.level >= reach)
        return 1.0;
    if (line.level <= -reach)
        return 0.0;

    // The area of a unit square on one side of a line, from the corner that is deepest in the sky.
    const auto belowHalf = [&](double depth) {
        return depth < flat ? 0.5 * depth * depth / (steep * flat) : (depth - 0.5 * flat) / steep;
    };
    const double depth = line.level + reach;
    return depth <= reach ? belowHalf(depth) : 1.0 - belowHalf(2.0 * reach - depth);
}

} // namespace irsg

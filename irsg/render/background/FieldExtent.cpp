#include "irsg/render/background/FieldExtent.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// True where the vertical line through the eye passes through the frame, upwards or downwards.
bool sees(const FieldRays& rays, double sign) {
    const double ahead = sign * rays.forward.z;
    if (ahead <= 0.0)
        return false;
    return std::abs(rays.right.z) <= ahead * rays.uLimit() &&
           std::abs(rays.up.z) <= ahead * rays.vLimit();
}

/// Where on the way from `a` to `b` the elevation has its extremum; 0 where it has none.
double extremum(const Vec3& a, const Vec3& b) {
    const Vec3 way = b - a;
    const double across = a.z * dot(way, way) - way.z * dot(a, way);
    return across == 0.0 ? 0.0 : (way.z * dot(a, a) - a.z * dot(a, way)) / across;
}

} // namespace

FieldExtent FieldExtent::of(const FieldRays& rays, double middleAzimuth_rad) {
    const double u = rays.uLimit(), v = rays.vLimit();
    const std::array<Vec3, 4> corners{rays.at(-u, v), rays.at(u, v), rays.at(u, -v),
                                      rays.at(-u, -v)};
    FieldExtent extent;
    extent.lowest_rad = extent.highest_rad = elevationOf_rad(corners[0]);
    const auto include = [&](const Vec3& direction) {
        const double elevation_rad = elevationOf_rad(direction);
        extent.lowest_rad = std::min(extent.lowest_rad, elevation_rad);
        extent.highest_rad = std::max(extent.highest_rad, elevation_rad);
        const double azimuth_rad =
            std::remainder(azimuthOf_rad(direction) - middleAzimuth_rad, 2.0 * pi);
        extent.left_rad = std::min(extent.left_rad, azimuth_rad);
        extent.right_rad = std::max(extent.right_rad, azimuth_rad);
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        include(a);
        const double t = extremum(a, b);
        if (t > 0.0 && t < 1.0)
            include(a + (b - a) * t);
    }

    if (sees(rays, 1.0))
        extent.highest_rad = 0.5 * pi, extent.allAround = true;
    if (sees(rays, -1.0))
        extent.lowest_rad = -0.5 * pi, extent.allAround = true;
    if (extent.allAround)
        extent.left_rad = -pi, extent.right_rad = pi;
    return extent;
}

} // namespace irsg

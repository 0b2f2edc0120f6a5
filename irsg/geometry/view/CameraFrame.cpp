#include "irsg/geometry/view/CameraFrame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

std::array<Vec3, 8> corners(const BoundingBox& box) {
    std::array<Vec3, 8> result;
    for (std::size_t i = 0; i < 8; ++i)
        result[i] = {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                     i & 4 ? box.max.z : box.min.z};
    return result;
}

/// Below this fraction of the far distance nothing is drawn: it bounds the depth resolution for a
/// camera inside an object.
constexpr double nearestFraction = 1e-5;

} // namespace

CameraFrame::CameraFrame(const Sensor& sensor, const Viewpoint& viewpoint)
    : sensor_(sensor), viewpoint_(viewpoint) {}

Vec3 CameraFrame::toEye(const Vec3& worldDirection) const {
    return {dot(worldDirection, viewpoint_.right), dot(worldDirection, viewpoint_.up),
            dot(worldDirection, viewpoint_.backward)};
}

Matrix4 CameraFrame::eyeFromModel(const Pose& pose) const {
    const Rotation r = pose.attitude.rotation();
    const Vec3 x = toEye({r.m[0][0], r.m[1][0], r.m[2][0]});
    const Vec3 y = toEye({r.m[0][1], r.m[1][1], r.m[2][1]});
    const Vec3 z = toEye({r.m[0][2], r.m[1][2], r.m[2][2]});
    const Vec3 t = toEye(pose.position_m - viewpoint_.position_m);
    return {{{{x.x, x.y, x.z, 0}, {y.x, y.y, y.z, 0}, {z.x, z.y, z.z, 0}, {t.x, t.y, t.z, 1}}}};
}

double CameraFrame::column(double rightPerDepth) const {
    return 0.5 * sensor_.width_px + rightPerDepth / sensor_.pixelPitch();
}

double CameraFrame::row(double upPerDepth) const {
    return 0.5 * sensor_.height_px - upPerDepth / sensor_.pixelPitch();
}

Matrix4 CameraFrame::clipFromEye(const ImageRectangle& tile, const DepthRange& depth) const {
    const double pitch = sensor_.pixelPitch();
    const double left = (tile.left - 0.5 * sensor_.width_px) * pitch;
    const double right = left + tile.width() * pitch;
    const double top = (0.5 * sensor_.height_px - tile.top) * pitch;
    const double bottom = top - tile.height() * pitch;
    const double n = depth.near_m, f = depth.far_m;
    return {{{{2.0 / (right - left), 0, 0, 0},
              {0, 2.0 / (top - bottom), 0, 0},
              {(right + left) / (right - left), (top + bottom) / (top - bottom), n / (f - n), -1},
              {0, 0, n * f / (f - n), 0}}}};
}

std::optional<DepthRange> CameraFrame::depthOf(const BoundingBox& box, const Pose& pose) const {
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    for (const Vec3& corner : corners(box)) {
        const double depth = -toEye(pose.toWorld(corner) - viewpoint_.position_m).z;
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    if (farthest <= 0.0)
        return std::nullopt;

    const double margin = 1e-3 * (farthest - nearest) + 1e-9 * farthest;
    farthest += margin;
    return DepthRange{std::max(nearest - margin, nearestFraction * farthest), farthest};
}

std::optional<ImageRectangle> CameraFrame::extentOf(const BoundingBox& box,
                                                    const Pose& pose) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    ImageRectangle extent{infinity, infinity, -infinity, -infinity};
    double nearest = infinity, farthest = -infinity;
    for (const Vec3& corner : corners(box)) {
        const Vec3 eye = toEye(pose.toWorld(corner) - viewpoint_.position_m);
        nearest = std::min(nearest, -eye.z);
        farthest = std::max(farthest, -eye.z);
        const double x = column(eye.x / -eye.z), y = row(eye.y / -eye.z);
        extent.left = std::min(extent.left, x), extent.right = std::max(extent.right, x);
        extent.top = std::min(extent.top, y), extent.bottom = std::max(extent.bottom, y);
    }
    if (nearest <= nearestFraction * farthest)
        return std::nullopt;
    return extent;
}

std::optional<std::pair<double, double>> CameraFrame::placeOf(const Vec3& world_m) const {
    const Vec3 eye = toEye(world_m - viewpoint_.position_m);
    if (-eye.z <= nearestFraction * length(eye))
        return std::nullopt;
    return std::pair{column(eye.x / -eye.z), row(eye.y / -eye.z)};
}

std::optional<ImageRectangle> CameraFrame::extentOfSphere(const Vec3& centre_m,
                                                          double radius_m) const {
    const Vec3 eye = toEye(centre_m - viewpoint_.position_m);
    // Seen from above and from the side, the sphere is a circle between two tangents.
    const auto tangents = [&](double sideways, double& low, double& high) {
        const double distance = std::hypot(sideways, eye.z);
        if (distance <= radius_m)
            return false;
        const double middle = std::atan2(sideways, -eye.z);
        const double half = std::asin(radius_m / distance);
        low = std::tan(middle - half);
        high = std::tan(middle + half);
        return std::abs(middle) + half < 0.5 * pi;
    };
    double left = 0.0, right = 0.0, down = 0.0, up = 0.0;
    if (!tangents(eye.x, left, right) || !tangents(eye.y, down, up))
        return std::nullopt;
    return ImageRectangle{column(left), row(up), column(right), row(down)};
}

} // namespace irsg

#include "irsg/scene/CameraFrame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

PixelWindow PixelWindow::unitedWith(const PixelWindow& other) const {
    if (empty())
        return other;
    if (other.empty())
        return *this;
    const int left = std::min(x, other.x), top = std::min(y, other.y);
    const int right = std::max(x + width, other.x + other.width);
    const int bottom = std::max(y + height, other.y + other.height);
    return {left, top, right - left, bottom - top};
}

PixelWindow PixelWindow::intersectedWith(const PixelWindow& other) const {
    const int left = std::max(x, other.x), top = std::max(y, other.y);
    const int right = std::min(x + width, other.x + other.width);
    const int bottom = std::min(y + height, other.y + other.height);
    return left < right && top < bottom ? PixelWindow{left, top, right - left, bottom - top}
                                        : PixelWindow{};
}

CameraFrame::CameraFrame(const Sensor& sensor, const Viewpoint& viewpoint)
    : sensor_(sensor), viewpoint_(viewpoint) {}

Vec3 CameraFrame::toEye(const Vec3& worldDirection) const {
    return {dot(worldDirection, viewpoint_.right), dot(worldDirection, viewpoint_.up),
            dot(worldDirection, viewpoint_.backward)};
}

osg::Matrixd CameraFrame::eyeFromModel(const Pose& pose) const {
    const Rotation r = pose.attitude.rotation();
    const Vec3 x = toEye({r.m[0][0], r.m[1][0], r.m[2][0]});
    const Vec3 y = toEye({r.m[0][1], r.m[1][1], r.m[2][1]});
    const Vec3 z = toEye({r.m[0][2], r.m[1][2], r.m[2][2]});
    const Vec3 t = toEye(pose.position_m - viewpoint_.position_m);
    return osg::Matrixd(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, t.x, t.y, t.z, 1);
}

osg::Matrixd CameraFrame::clipFromEye(const PixelWindow& window, const DepthRange& depth) const {
    const double pitch = sensor_.pixelPitch();
    const double left = (window.x - 0.5 * sensor_.width_px) * pitch;
    const double right = left + window.width * pitch;
    const double top = (0.5 * sensor_.height_px - window.y) * pitch;
    const double bottom = top - window.height * pitch;
    const double n = depth.near_m, f = depth.far_m;
    return osg::Matrixd(2.0 / (right - left), 0, 0, 0,                                    //
                        0, 2.0 / (top - bottom), 0, 0,                                    //
                        (right + left) / (right - left), (top + bottom) / (top - bottom), //
                        n / (f - n), -1,                                                  //
                        0, 0, n * f / (f - n), 0);
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

PixelWindow CameraFrame::windowOf(const BoundingBox& box, const Pose& pose) const {
    const PixelWindow frame{0, 0, sensor_.width_px, sensor_.height_px};
    const double pitch = sensor_.pixelPitch();
    double left = std::numeric_limits<double>::infinity(), top = left, right = -left,
           bottom = -left;
    double nearest = left, farthest = -left;
    for (const Vec3& corner : corners(box)) {
        const Vec3 eye = toEye(pose.toWorld(corner) - viewpoint_.position_m);
        nearest = std::min(nearest, -eye.z);
        farthest = std::max(farthest, -eye.z);
        const double x = 0.5 * sensor_.width_px + eye.x / -eye.z / pitch;
        const double y = 0.5 * sensor_.height_px - eye.y / -eye.z / pitch;
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
    }
    if (farthest <= 0.0)
        return {};
    if (nearest <= nearestFraction * farthest)
        return frame;

    auto clampTo = [](double value, int limit) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
    };
    PixelWindow window;
    window.x = clampTo(std::floor(left) - 1.0, frame.width);
    window.y = clampTo(std::floor(top) - 1.0, frame.height);
    window.width = clampTo(std::ceil(right) + 1.0, frame.width) - window.x;
    window.height = clampTo(std::ceil(bottom) + 1.0, frame.height) - window.y;
    return window.empty() ? PixelWindow{} : window;
}

} // namespace irsg

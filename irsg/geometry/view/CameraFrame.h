#pragma once

#include <optional>
#include <utility>

#include "irsg/geometry/view/ImageRectangle.h"
#include "irsg/geometry/view/Matrix4.h"
#include "irsg/geometry/view/Pose.h"
#include "irsg/geometry/view/Sensor.h"

namespace irsg {

/// Distances along the view direction between which geometry is drawn, m.
struct DepthRange {
    double near_m = 0.0, far_m = 0.0;
};

/// How a sensor at a viewpoint sees the world. Everything is double and relative to the camera;
/// what GL gets is composed first and rounded last.
class CameraFrame {
  public:
    CameraFrame(const Sensor& sensor, const Viewpoint& viewpoint);

    /// World directions and model coordinates to eye space (x right, y up, z backward).
    Matrix4 eyeFromModel(const Pose& pose) const;
    Vec3 toEye(const Vec3& worldDirection) const;
    /// Eye space to the clip space of a rectangle of the image plane: an off-axis frustum. Depth
    /// runs from 1 at the near to 0 at the far distance (zero-to-one clip control),
    /// where a float has its digits: a camera inside an object still tells surfaces 1e-6 of their
    /// distance apart.
    Matrix4 clipFromEye(const ImageRectangle& tile, const DepthRange& depth) const;

    /// The part of the image plane in which a box standing at `pose` is seen, inside the frame or
    /// not; nothing when the box reaches behind the camera.
    std::optional<ImageRectangle> extentOf(const BoundingBox& box, const Pose& pose) const;
    /// Where a point of the world is seen, pixels to the right and down of the frame's corner,
    /// inside the frame or not; nothing when it is not before the camera.
    std::optional<std::pair<double, double>> placeOf(const Vec3& world_m) const;
    /// The extent of a sphere in the world.
    std::optional<ImageRectangle> extentOfSphere(const Vec3& centre_m, double radius_m) const;
    /// Depths the box spans, or nothing when all of it is behind the camera.
    std::optional<DepthRange> depthOf(const BoundingBox& box, const Pose& pose) const;

    const Sensor& sensor() const { return sensor_; }
    const Viewpoint& viewpoint() const { return viewpoint_; }

  private:
    /// Pixels right of and below the frame's corner of a direction in eye space, per unit depth.
    double column(double rightPerDepth) const;
    double row(double upPerDepth) const;

    Sensor sensor_;
    Viewpoint viewpoint_;
};

} // namespace irsg

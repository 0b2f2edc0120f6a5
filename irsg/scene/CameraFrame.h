#pragma once

#include <optional>

#include <osg/Matrixd>

#include "irsg/scene/Model.h"
#include "irsg/scene/Pose.h"
#include "irsg/scene/Sensor.h"

namespace irsg {

/// A rectangle of pixels of the sensor, top left pixel first.
struct PixelWindow {
    int x = 0, y = 0, width = 0, height = 0;

    bool empty() const { return width <= 0 || height <= 0; }
    PixelWindow unitedWith(const PixelWindow& other) const;
    PixelWindow intersectedWith(const PixelWindow& other) const;
    bool operator==(const PixelWindow&) const = default;
};

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
    osg::Matrixd eyeFromModel(const Pose& pose) const;
    Vec3 toEye(const Vec3& worldDirection) const;
    /// Eye space to the clip space of a window of the sensor: an off-axis frustum on the pixel
    /// grid. Depth runs from 1 at the near to 0 at the far distance (zero-to-one clip control),
    /// where a float has its digits: a camera inside an object still tells surfaces 1e-6 of their
    /// distance apart.
    osg::Matrixd clipFromEye(const PixelWindow& window, const DepthRange& depth) const;

    /// Pixels that can see any of a box standing at `pose`, with a margin of one pixel; the whole
    /// frame when the box reaches behind the camera; empty when it lies outside the frame.
    PixelWindow windowOf(const BoundingBox& box, const Pose& pose) const;
    /// Depths the box spans, or nothing when all of it is behind the camera.
    std::optional<DepthRange> depthOf(const BoundingBox& box, const Pose& pose) const;

    const Sensor& sensor() const { return sensor_; }
    const Viewpoint& viewpoint() const { return viewpoint_; }

  private:
    Sensor sensor_;
    Viewpoint viewpoint_;
};

} // namespace irsg

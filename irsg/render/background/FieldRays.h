#pragma once

#include <cmath>

#include "irsg/geometry/view/Pose.h"
#include "irsg/geometry/view/Sensor.h"

namespace irsg {

/// Lines of sight of a sensor as points (u, v) of its image plane at unit distance: u to the right,
/// v up, the direction in the world is forward + u right + v up and not normalised.
struct FieldRays {
    FieldRays(const Sensor& sensor, const Viewpoint& viewpoint)
        : width_px(sensor.width_px),
          height_px(sensor.height_px),
          pitch(sensor.pixelPitch()),
          right(viewpoint.right),
          up(viewpoint.up),
          forward(viewpoint.forward()) {}

    /// Of pixel coordinates; the centre of pixel (0, 0), the top left one, is (0.5, 0.5).
    double u(double x_px) const { return (x_px - 0.5 * width_px) * pitch; }
    double v(double y_px) const { return (0.5 * height_px - y_px) * pitch; }
    Vec3 at(double u, double v) const {
        return {forward.x + u * right.x + v * up.x, forward.y + u * right.y + v * up.y,
                forward.z + u * right.z + v * up.z};
    }
    /// Half the width and height of the frame.
    double uLimit() const { return 0.5 * width_px * pitch; }
    double vLimit() const { return 0.5 * height_px * pitch; }

    int width_px, height_px;
    double pitch; ///< side of a pixel
    Vec3 right, up, forward;
};

/// Elevation above the horizontal of a direction of any length.
inline double elevationOf_rad(const Vec3& direction) {
    return std::atan2(direction.z, std::hypot(direction.x, direction.y));
}
/// East of north; 0 for straight up and down.
inline double azimuthOf_rad(const Vec3& direction) {
    return std::atan2(direction.x, direction.y);
}

} // namespace irsg

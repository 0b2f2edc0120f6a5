#pragma once

#include "irsg/geometry/view/Pose.h"

namespace smat::gui {

/// What a camera is to show as a whole.
struct ViewBall {
    irsg::Vec3 centre_m; ///< world axes
    double radius_m = 1.0;
};

/// The camera of the 3-D view in the terms of the project: where it stands about the target. x
/// east, y north, z up; azimuth 0 looks at the nose, 90 degrees sees the starboard side.
struct OrbitCamera {
    double azimuth_deg = 0.0;   ///< -180 to 180
    double elevation_deg = 0.0; ///< -90 to 90
    double range_m = 1000.0;
    /// Of the point it looks at, from the target's reference point in world axes; the sensor's is
    /// 0.
    irsg::Vec3 offset_m = {};

    /// As if the mouse took hold of the model's near side: right turns azimuth up, down raises the
    /// camera. `right` and `down` are in degrees.
    void turn(double right, double down);
    /// Multiplies the range, kept between 1e-3 and 1e8 m.
    void approach(double factor);
    /// The range at which a sphere of this radius fills 85 % of a field of view.
    static double rangeToShow(double radius_m, double fieldOfView_rad);

    irsg::Viewpoint viewpoint(const irsg::Vec3& referencePoint, double yaw_rad) const;
    bool operator==(const OrbitCamera&) const = default;
};

} // namespace smat::gui

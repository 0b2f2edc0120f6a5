#pragma once

#include <array>

#include "irsg/geometry/view/Vec3.h"

namespace irsg {

/// Row-major 3 x 3 rotation acting on column vectors.
struct Rotation {
    std::array<std::array<double, 3>, 3> m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    Vec3 operator*(const Vec3& v) const {
        return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
                m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
                m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
    }
    Rotation operator*(const Rotation& o) const;
    Rotation transposed() const;
};

/// R = Rz(yaw) Rx(pitch) Ry(roll): yaw counter-clockwise seen from above (heading = -yaw), pitch
/// nose up, roll starboard down.
struct Attitude {
    double yaw_rad = 0.0, pitch_rad = 0.0, roll_rad = 0.0;

    Rotation rotation() const;
    bool operator==(const Attitude&) const = default;
};

/// Where a model stands: its origin in the world and its attitude.
struct Pose {
    Vec3 position_m;
    Attitude attitude;

    Vec3 toWorld(const Vec3& model) const;
    bool operator==(const Pose&) const = default;
};

/// Unit vector towards azimuth A (east of north) and elevation E: (sin A cos E, cos A cos E, sin
/// E).
Vec3 direction(double azimuth_rad, double elevation_rad);

/// A camera: where it is, and its axes in the world (right, up, backward = -view direction).
struct Viewpoint {
    Vec3 position_m;
    Vec3 right{1, 0, 0};
    Vec3 up{0, 0, 1};
    Vec3 backward{0, -1, 0};

    Vec3 forward() const { return backward * -1.0; }
    /// Looks from `position` at `target`; `upHint` is turned into the plane of the view. Straight
    /// up or down, `fallbackUp` is used instead.
    static Viewpoint lookAt(const Vec3& position, const Vec3& target,
                            const Vec3& upHint = {0, 0, 1}, const Vec3& fallbackUp = {0, 1, 0});

    /// At azimuth alpha and elevation e about c at distance d: c + d (sin a cos e, cos a cos e, sin
    /// e) in the horizontal frame whose y is Rz(yaw) y. a = 0 looks at the nose, 90 degrees sees
    /// the starboard side.
    static Viewpoint about(const Vec3& referencePoint, double yaw_rad, double azimuth_rad,
                           double elevation_rad, double range_m);
    /// Camera-Elevation polar mode, in the model's own frame: position d (0, cos phi, -sin phi) and
    /// camera up (0, sin phi, cos phi): front, belly, tail, top.
    static Viewpoint aroundPitchPlane(const Vec3& referencePoint, const Attitude& attitude,
                                      double angle_rad, double range_m);
};

} // namespace irsg

#include "irsg/geometry/view/Pose.h"

#include <cmath>

namespace irsg {

namespace {

// Sine of the angle between the view and its up vector below which they count as parallel: there
// the rounding of double would already turn the picture by more than 1e-7 rad.
constexpr double parallelSine = 1e-9;

bool isParallel(const Vec3& unit, const Vec3& other) {
    return length(cross(unit, other)) <= parallelSine * length(other);
}

// The coordinate axis that is farthest from a direction: never parallel to it.
Vec3 farthestAxis(const Vec3& v) {
    const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
    if (z <= x && z <= y)
        return {0, 0, 1};
    return y <= x ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
}

} // namespace

Rotation Rotation::operator*(const Rotation& o) const {
    Rotation product;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            product.m[row][column] = m[row][0] * o.m[0][column] + m[row][1] * o.m[1][column] +
                                     m[row][2] * o.m[2][column];
    return product;
}

Rotation Rotation::transposed() const {
    Rotation t;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            t.m[row][column] = m[column][row];
    return t;
}

Rotation Attitude::rotation() const {
    const double cy = std::cos(yaw_rad), sy = std::sin(yaw_rad);
    const double cp = std::cos(pitch_rad), sp = std::sin(pitch_rad);
    const double cr = std::cos(roll_rad), sr = std::sin(roll_rad);
    const Rotation rz{{{{cy, -sy, 0}, {sy, cy, 0}, {0, 0, 1}}}};
    const Rotation rx{{{{1, 0, 0}, {0, cp, -sp}, {0, sp, cp}}}};
    const Rotation ry{{{{cr, 0, sr}, {0, 1, 0}, {-sr, 0, cr}}}};
    return rz * rx * ry;
}

Vec3 Pose::toWorld(const Vec3& model) const {
    return position_m + attitude.rotation() * model;
}

Vec3 direction(double azimuth_rad, double elevation_rad) {
    const double horizontal = std::cos(elevation_rad);
    return {std::sin(azimuth_rad) * horizontal, std::cos(azimuth_rad) * horizontal,
            std::sin(elevation_rad)};
}

Viewpoint Viewpoint::lookAt(const Vec3& position, const Vec3& target, const Vec3& upHint,
                            const Vec3& fallbackUp) {
    const Vec3 forward = normalized(target - position);

    // The first up vector that is not along the view.
    Vec3 up = upHint;
    if (isParallel(forward, up))
        up = fallbackUp;
    if (isParallel(forward, up))
        up = farthestAxis(forward);

    Viewpoint view;
    view.position_m = position;
    view.backward = forward * -1.0;
    view.right = normalized(cross(forward, up));
    view.up = cross(view.backward, view.right);
    return view;
}

Viewpoint Viewpoint::about(const Vec3& referencePoint, double yaw_rad, double azimuth_rad,
                           double elevation_rad, double range_m) {
    // Azimuth turns clockwise seen from above and yaw counter-clockwise: they subtract.
    const double azimuth = azimuth_rad - yaw_rad;

    Viewpoint view;
    view.backward = direction(azimuth, elevation_rad);
    view.position_m = referencePoint + view.backward * range_m;
    // Up is the derivative of the direction by elevation, so that the picture does not jump at the
    // zenith or the nadir.
    const double sine = std::sin(elevation_rad);
    view.up = {-std::sin(azimuth) * sine, -std::cos(azimuth) * sine, std::cos(elevation_rad)};
    view.right = cross(view.up, view.backward);
    return view;
}

Viewpoint Viewpoint::aroundPitchPlane(const Vec3& referencePoint, const Attitude& attitude,
                                      double angle_rad, double range_m) {
    const Rotation toWorld = attitude.rotation();
    const double cosine = std::cos(angle_rad), sine = std::sin(angle_rad);

    Viewpoint view;
    view.backward = toWorld * Vec3{0, cosine, -sine};
    view.position_m = referencePoint + view.backward * range_m;
    view.up = toWorld * Vec3{0, sine, cosine};
    view.right = cross(view.up, view.backward);
    return view;
}

} // namespace irsg

#pragma once

#include <cmath>

#include "irsg/geometry/view/Pose.h"
#include "irsg/geometry/view/Vec3.h"

namespace irsg {

// What rays and samples do with vectors millions of times, without a call.

inline double product(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 crossed(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vec3 turned(const Rotation& r, const Vec3& v) {
    return {r.m[0][0] * v.x + r.m[0][1] * v.y + r.m[0][2] * v.z,
            r.m[1][0] * v.x + r.m[1][1] * v.y + r.m[1][2] * v.z,
            r.m[2][0] * v.x + r.m[2][1] * v.y + r.m[2][2] * v.z};
}
/// Of a vector whose square is a number: neither very long nor very short.
inline double plainLength(const Vec3& v) {
    return std::sqrt(product(v, v));
}

} // namespace irsg

#pragma once

#include <array>
#include <cmath>

namespace irsg {

/// A place, m, or a vector along three right-handed axes; Vec3 belongs to the folders of geometry,
/// which stand above this one.
using GasVector = std::array<double, 3>;

inline double dotOf(const GasVector& a, const GasVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline GasVector crossOf(const GasVector& a, const GasVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double lengthOf(const GasVector& v) {
    return std::hypot(v[0], v[1], v[2]);
}
/// Of a vector that is not null.
inline GasVector unitOf(const GasVector& v) {
    const double length = lengthOf(v);
    return {v[0] / length, v[1] / length, v[2] / length};
}
/// a + b s.
inline GasVector sumOf(const GasVector& a, const GasVector& b, double s = 1.0) {
    return {a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s};
}
inline GasVector differenceOf(const GasVector& a, const GasVector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

} // namespace irsg

#include "irsg/geometry/view/Vec3.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"

namespace irsg {

double dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double length(const Vec3& v) {
    return std::hypot(v.x, v.y, v.z);
}

Vec3 normalized(const Vec3& v) {
    const double norm = length(v);
    if (!(norm > 0.0) || !std::isfinite(norm))
        throw LogicError("a vector without length, or not finite, has no direction");
    return {v.x / norm, v.y / norm, v.z / norm};
}

void BoundingBox::include(const Vec3& place) {
    include(BoundingBox{place, place});
}

void BoundingBox::include(const BoundingBox& other) {
    if (!other.valid())
        return;
    if (!valid()) {
        *this = other;
        return;
    }
    min = {std::min(min.x, other.min.x), std::min(min.y, other.min.y),
           std::min(min.z, other.min.z)};
    max = {std::max(max.x, other.max.x), std::max(max.y, other.max.y),
           std::max(max.z, other.max.z)};
}

} // namespace irsg

#pragma once

#include <algorithm>
#include <cmath>
#include <compare>

namespace irsg {

/// A vector of the world (x east, y north, z up) or of a model (x starboard, y nose, z up), m.
struct Vec3 {
    double x = 0.0, y = 0.0, z = 0.0;

    Vec3 operator+(const Vec3& o) const { return {x + o.x, y + o.y, z + o.z}; }
    Vec3 operator-(const Vec3& o) const { return {x - o.x, y - o.y, z - o.z}; }
    Vec3 operator*(double s) const { return {x * s, y * s, z * s}; }
    auto operator<=>(const Vec3&) const = default;
};

// Rays and sums call these by the million, from other libraries.
inline double dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// As std::hypot has it, to the last bit where that is of libstdc++: scaled by the largest
/// coordinate, so that no square overflows or vanishes. The call took 3 % of the light between
/// surfaces.
inline double length(const Vec3& v) {
    const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
    const double most = std::max(x, std::max(y, z));
    if (!(most > 0.0))
        return x + y + z;
    const double ofX = x / most, ofY = y / most, ofZ = z / most;
    return most * std::sqrt(ofX * ofX + ofY * ofY + ofZ * ofZ);
}
/// Throws LogicError: a vector that is null or not finite has no direction.
[[noreturn]] void refuseDirectionless();
/// Throws LogicError for the null vector and for one that is not finite.
inline Vec3 normalized(const Vec3& v) {
    const double norm = length(v);
    if (!(norm > 0.0) || !std::isfinite(norm))
        refuseDirectionless();
    return {v.x / norm, v.y / norm, v.z / norm};
}

/// A box along the axes of its model or of the world.
struct BoundingBox {
    Vec3 min, max;
    /// Not valid until something is included.
    static constexpr BoundingBox nowhere() { return {{1, 1, 1}, {-1, -1, -1}}; }
    void include(const Vec3& place);
    /// Both boxes; one that is not valid adds nothing.
    void include(const BoundingBox& other);
    bool valid() const { return min.x <= max.x && min.y <= max.y && min.z <= max.z; }
    Vec3 centre() const { return (min + max) * 0.5; }
    double diagonal_m() const { return length(max - min); }
    bool operator==(const BoundingBox&) const = default;
};

} // namespace irsg

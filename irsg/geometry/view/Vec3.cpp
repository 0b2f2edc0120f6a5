#include "irsg/geometry/view/Vec3.h"

#include <algorithm>

#include "irsg/core/Errors.h"

namespace irsg {

void refuseDirectionless() {
    throw LogicError("a vector without length, or not finite, has no direction");
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

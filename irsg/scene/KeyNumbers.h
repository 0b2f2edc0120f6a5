#pragma once

#include <vector>

#include "irsg/geometry/view/Pose.h"

namespace irsg {

/// Append what a key of a cache holds of a value.
inline void appendTo(std::vector<double>& numbers, const Vec3& v) {
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}
inline void appendTo(std::vector<double>& numbers, const Attitude& attitude) {
    numbers.insert(numbers.end(), {attitude.yaw_rad, attitude.pitch_rad, attitude.roll_rad});
}
inline void appendTo(std::vector<double>& numbers, const std::vector<double>& more) {
    numbers.insert(numbers.end(), more.begin(), more.end());
}

} // namespace irsg

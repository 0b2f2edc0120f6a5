#pragma once

#include <cstdint>

namespace smat::gui {

/// std::floor and std::ceil of numbers that fit into the result: what draws pixels asks for them so
/// often that a call of a function is much.
inline int floorOf(float value) {
    const int whole = static_cast<int>(value);
    return whole - (value < static_cast<float>(whole) ? 1 : 0);
}
inline int ceilOf(float value) {
    const int whole = static_cast<int>(value);
    return whole + (value > static_cast<float>(whole) ? 1 : 0);
}
inline std::int64_t floorOf(double value) {
    const auto whole = static_cast<std::int64_t>(value);
    return whole - (value < static_cast<double>(whole) ? 1 : 0);
}

} // namespace smat::gui

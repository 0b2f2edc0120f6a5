#pragma once

#include <cstddef>
#include <vector>

#include "irsg/geometry/view/ImageRectangle.h"

namespace irsg {

/// A rectangle and the things that it holds a part of.
struct Enclosure {
    ImageRectangle rectangle;
    std::vector<std::size_t> things;
};

/// Rectangles that hold all things together and do not overlap: the plane is cut along lines as
/// long as that leaves things in a smaller area, by more than `waste` times for each cut that
/// stays. A thing that a line meets is in the rectangles on both sides. Of more than `most`
/// rectangles those become one that grow least by it. The same in whatever order the things are
/// given.
std::vector<Enclosure> partition(const std::vector<ImageRectangle>& things, double waste,
                                 std::size_t most);

} // namespace irsg

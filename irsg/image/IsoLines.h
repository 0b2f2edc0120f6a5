#pragma once

#include <span>
#include <vector>

namespace irsg {

/// A piece of a line of equal value, in pixels from the top left corner of an image, whose pixels
/// have their values in their middles (0.5, 0.5).
struct IsoSegment {
    double fromX = 0.0, fromY = 0.0, toX = 0.0, toY = 0.0;
    bool operator==(const IsoSegment&) const = default;
};

/// Where a plane has a level, linear between the middles of four neighbouring pixels (marching
/// squares; a saddle is cut by the mean of its corners). A value at the level counts as above it.
/// No line passes beside a pixel that is not finite. Throws LogicError where `values` are not
/// `width` x `height`.
std::vector<IsoSegment> isoLines(std::span<const float> values, int width, int height,
                                 double level);

/// Some `wanted` round levels (1, 2 or 5 times a power of ten apart) inside an interval, ascending;
/// none of one without width.
std::vector<double> roundLevels(double low, double high, int wanted = 6);

} // namespace irsg

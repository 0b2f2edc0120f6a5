#pragma once

#include <vector>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Values of a plane along a line, pixel by pixel: those of the image itself, nothing between them.
struct ImageProfile {
    std::vector<double> distance_px; ///< from the middle of the first pixel
    std::vector<int> x, y;           ///< of each pixel
    std::vector<double> values;      ///< in the unit of the plane; NaN where the image has none

    bool operator==(const ImageProfile&) const = default;
};

/// From the middle of one pixel to that of another, both included: as many pixels as the longer of
/// the two ways has, each the nearest to the line. Throws InputError for a pixel outside of the
/// image, LogicError for a plane of another size.
ImageProfile profileAlong(const RadianceImage& image, const ImageChannel& plane, int fromX,
                          int fromY, int toX, int toY);

} // namespace irsg

#pragma once

#include <cstddef>
#include <vector>

#include "irsg/image/RadianceImage.h"

namespace irsg {

/// A pixel whose value no neighbour exceeds.
struct HotSpot {
    int x = 0, y = 0;
    double value = 0.0; ///< in the unit of the plane
    bool operator==(const HotSpot&) const = default;
};

/// The `most` largest local maxima of a plane, the largest first, no two of them nearer than
/// `apart_px` in both directions; of equal ones the first in reading order. A place where all is
/// equal has none, and a pixel that is not finite neither is one nor takes part. LogicError for a
/// plane of another size and for a distance below 1.
std::vector<HotSpot> hottestSpots(const RadianceImage& image, const ImageChannel& plane,
                                  std::size_t most = 10, int apart_px = 8);

} // namespace irsg

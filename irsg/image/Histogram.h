#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "irsg/image/ImageStatistics.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// How often values occur. Bin i holds edges[i] <= value < edges[i + 1], the last one its upper
/// edge, too. Infinities count as below or above.
struct Histogram {
    std::vector<double> edges; ///< one more than bins, ascending; in equal ratios if logarithmic
    std::vector<std::size_t> counts;
    std::size_t below = 0, above = 0, nan = 0;
    bool logarithmic = false;
};

/// The histogram of a plane, or of a rectangle of it, between the least and the largest finite
/// value; with a logarithmic axis between the least and the largest positive one, the others being
/// below. Where all are equal, the bins lie around that value; where there is none, between 0
/// and 1. LogicError unless 1 <= bins; InputError for a rectangle that is not in the image.
Histogram imageHistogram(const RadianceImage& image, const ImageChannel& plane, int bins,
                         bool logarithmic = false,
                         const std::optional<PixelRectangle>& rectangle = std::nullopt);

} // namespace irsg

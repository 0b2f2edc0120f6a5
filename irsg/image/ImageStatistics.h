#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "irsg/image/DisplayLimits.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// A part of an image; (x, y) is its top left pixel.
struct PixelRectangle {
    int x = 0, y = 0;
    int width = 1, height = 1;

    bool operator==(const PixelRectangle&) const = default;
};

/// `rectangle`, or the whole image without one. Throws InputError for a rectangle without pixels or
/// not wholly inside the image.
PixelRectangle checkedRectangle(const RadianceImage& image,
                                const std::optional<PixelRectangle>& rectangle);

/// What the values of a plane, or of a rectangle of it, are like. NaN and infinities are counted
/// apart and enter no other figure; where no finite value is left, the figures are NaN (the sum 0).
struct ImageStatistics {
    std::size_t finite = 0, nan = 0, positiveInfinite = 0, negativeInfinite = 0;
    double minimum = 0.0, maximum = 0.0;
    int minimumX = -1, minimumY = -1; ///< the first such pixel in reading order, in the whole image
    int maximumX = -1, maximumY = -1;
    double sum = 0.0; ///< in double, compensated
    double mean = 0.0;
    double standardDeviation = 0.0; ///< of the values themselves: divided by n, not by n - 1
    double median = 0.0;            ///< mean of the two middle values where n is even
};

/// Throws InputError for a rectangle without pixels or not wholly inside the image, LogicError for
/// a plane that is not as large as the image.
ImageStatistics imageStatistics(const RadianceImage& image, const ImageChannel& plane,
                                const std::optional<PixelRectangle>& rectangle = std::nullopt);
/// Of the shown plane.
ImageStatistics imageStatistics(const RadianceImage& image,
                                const std::optional<PixelRectangle>& rectangle = std::nullopt);

/// The value below which `percent` (0 to 100, else InputError) of the finite values lie, linear
/// between the two nearest ranks: rank = percent / 100 (n - 1). NaN where no value is finite.
double percentile(std::span<const float> values, double percent);

/// Limits from percentiles of the finite values, 0 and 100 being minimum and maximum. Always
/// usable: low < high. A plane of one value v is shown between v - |v|/100 and v + |v|/100, a plane
/// of zeros, or without a finite value, between 0 and 1. Throws InputError unless 0 <= low < high
/// <= 100.
DisplayLimits percentileLimits(std::span<const float> values, double lowPercent = 0.0,
                               double highPercent = 100.0);
/// Limits that show an object on its background: where one value fills a twentieth of the plane or
/// more (a uniform background), the percentiles 0.5 and 99 of all that differs from it, widened to
/// hold it; else those of the whole plane. A few glowing pixels do not turn the rest of a target
/// black.
DisplayLimits objectLimits(std::span<const float> values);
/// Limits that a scale of colours shows an object with: those above where it is linear by choice; a
/// scale that leaves room for both skin and exhaust pipes, as the automatic one, shows all there
/// is.
DisplayLimits limitsFor(ColorScale scale, std::span<const float> values);
/// Symmetric about 0: the percentile of the absolute values, or the largest where that is 0.
DisplayLimits symmetricLimits(std::span<const float> values, double percent = 100.0);

} // namespace irsg

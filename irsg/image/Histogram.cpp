#include "irsg/image/Histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// The range of the values that a bin can hold.
DisplayLimits rangeOf(const RadianceImage& image, const ImageChannel& plane,
                      const PixelRectangle& area, bool positiveOnly) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x) {
            const double value = plane.values[image.offset(x, y)];
            if (std::isfinite(value) && (!positiveOnly || value > 0.0)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
        }
    if (low > high)
        return positiveOnly ? DisplayLimits{0.1, 1.0} : DisplayLimits{0.0, 1.0};
    if (low < high)
        return {low, high};
    if (positiveOnly)
        return {low / 1.1, low * 1.1};
    const double around = low == 0.0 ? 0.5 : 0.05 * std::abs(low);
    return {low - around, low + around};
}

} // namespace

Histogram imageHistogram(const RadianceImage& image, const ImageChannel& plane, int bins,
                         bool logarithmic, const std::optional<PixelRectangle>& rectangle) {
    if (bins < 1 || plane.values.size() != image.pixelCount())
        throw LogicError("a histogram needs a bin and a plane as large as its image");
    const PixelRectangle area = checkedRectangle(image, rectangle);
    const DisplayLimits range = rangeOf(image, plane, area, logarithmic);

    // The edges, the outer ones exact.
    const auto scaled = [logarithmic](double value) {
        return logarithmic ? std::log10(value) : value;
    };
    const double low = scaled(range.low), width = (scaled(range.high) - low) / bins;
    Histogram result;
    result.logarithmic = logarithmic;
    for (int i = 0; i <= bins; ++i) {
        const double edge = low + i * width;
        result.edges.push_back(logarithmic ? std::pow(10.0, edge) : edge);
    }
    result.edges.front() = range.low;
    result.edges.back() = range.high;

    // A bin by division; a value that rounding put beside its bin is moved.
    result.counts.assign(static_cast<std::size_t>(bins), 0);
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x) {
            const double value = plane.values[image.offset(x, y)];
            if (std::isnan(value)) {
                ++result.nan;
            } else if (value < range.low) {
                ++result.below;
            } else if (value > range.high) {
                ++result.above;
            } else {
                const double part = (scaled(value) - low) / width;
                auto bin = static_cast<std::size_t>(std::clamp(part, 0.0, bins - 1.0));
                if (bin > 0 && value < result.edges[bin])
                    --bin;
                else if (bin + 1 < result.counts.size() && value >= result.edges[bin + 1])
                    ++bin;
                ++result.counts[bin];
            }
        }
    return result;
}

} // namespace irsg

#include "irsg/image/ImageStatistics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/image/CompensatedSum.h"
#include "irsg/image/NotANumber.h"

namespace irsg {

namespace {

std::vector<float> finiteOf(std::span<const float> values) {
    std::vector<float> finite;
    finite.reserve(values.size());
    std::ranges::copy_if(values, std::back_inserter(finite),
                         [](float value) { return std::isfinite(value); });
    return finite;
}

/// Reorders `values`, which are finite.
double valueAtRank(std::vector<float>& values, double rank) {
    if (values.empty())
        return notANumber;
    const auto below = static_cast<std::size_t>(std::floor(rank));
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(below);
    std::ranges::nth_element(values, middle);
    const double low = *middle;
    const double part = rank - static_cast<double>(below);
    if (part == 0.0)
        return low;
    const double high = *std::min_element(middle + 1, values.end());
    return low + part * (high - low);
}

double percentileOfFinite(std::vector<float>& values, double percent) {
    return valueAtRank(values, percent / 100.0 * (static_cast<double>(values.size()) - 1.0));
}

/// A value and how often it occurs.
struct Run {
    float value = 0.0F;
    std::size_t length = 0;
};

Run longestRunOfSorted(const std::vector<float>& sorted) {
    Run longest;
    for (std::size_t i = 0, from = 0; i < sorted.size(); ++i) {
        if (sorted[i] != sorted[from])
            from = i;
        if (i - from + 1 > longest.length)
            longest = {sorted[i], i - from + 1};
    }
    return longest;
}

/// The value that occurs most often. Of a large plane that is looked for among some thousand
/// pixels strewn over it: whatever fills a twentieth is there, and is then counted in all.
Run longestRun(const std::vector<float>& values) {
    constexpr std::size_t few = 65536, strewn = 8192;
    const bool all = values.size() <= few;
    std::vector<float> sample = all ? values : std::vector<float>();
    for (std::uint64_t i = 0; sample.size() < strewn && !all; ++i)
        sample.push_back(values[(i * 0x9E3779B97F4A7C15ULL >> 16U) % values.size()]);
    std::ranges::sort(sample);
    Run longest = longestRunOfSorted(sample);
    if (!all)
        longest.length = static_cast<std::size_t>(std::ranges::count(values, longest.value));
    return longest;
}

void checkPercent(double percent) {
    if (!(percent >= 0.0 && percent <= 100.0))
        throw InputError({"", "percentile", numberText(percent), "0 to 100"});
}

} // namespace

PixelRectangle checkedRectangle(const RadianceImage& image,
                                const std::optional<PixelRectangle>& rectangle) {
    const PixelRectangle all{0, 0, image.width(), image.height()};
    const PixelRectangle r = rectangle.value_or(all);
    // Compared without sums that could overflow.
    if (r.width < 1 || r.height < 1 || r.x < 0 || r.y < 0 || r.width > all.width ||
        r.height > all.height || r.x > all.width - r.width || r.y > all.height - r.height)
        throw InputError({"", "rectangle",
                          std::to_string(r.width) + " x " + std::to_string(r.height) + " at (" +
                              std::to_string(r.x) + ", " + std::to_string(r.y) + ")",
                          "at least one pixel, inside the image of " + std::to_string(all.width) +
                              " x " + std::to_string(all.height)});
    return r;
}

ImageStatistics imageStatistics(const RadianceImage& image, const ImageChannel& plane,
                                const std::optional<PixelRectangle>& rectangle) {
    if (plane.values.size() != image.pixelCount())
        throw LogicError("channel " + plane.name + " is not as large as its image");
    const PixelRectangle area = checkedRectangle(image, rectangle);

    // First sweep: what is finite, its sum and its ends.
    ImageStatistics result;
    std::vector<float> finite;
    finite.reserve(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
    CompensatedSum sum;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x) {
            const float value = plane.values[image.offset(x, y)];
            if (std::isnan(value)) {
                ++result.nan;
            } else if (std::isinf(value)) {
                ++(value > 0.0F ? result.positiveInfinite : result.negativeInfinite);
            } else {
                if (finite.empty() || value < result.minimum) {
                    result.minimum = value;
                    result.minimumX = x;
                    result.minimumY = y;
                }
                if (finite.empty() || value > result.maximum) {
                    result.maximum = value;
                    result.maximumX = x;
                    result.maximumY = y;
                }
                finite.push_back(value);
                sum.add(value);
            }
        }
    result.finite = finite.size();
    result.sum = sum.value();
    if (finite.empty()) {
        result.minimum = result.maximum = notANumber;
        result.mean = result.median = result.standardDeviation = notANumber;
        return result;
    }

    // Second sweep: deviations from the mean, so that a small spread on a large mean survives.
    const auto count = static_cast<double>(result.finite);
    result.mean = result.sum / count;
    CompensatedSum squares;
    for (const float value : finite)
        squares.add((value - result.mean) * (value - result.mean));
    result.standardDeviation = std::sqrt(squares.value() / count);
    result.median = percentileOfFinite(finite, 50.0);
    return result;
}

ImageStatistics imageStatistics(const RadianceImage& image,
                                const std::optional<PixelRectangle>& rectangle) {
    return imageStatistics(image, image.primary(), rectangle);
}

double percentile(std::span<const float> values, double percent) {
    checkPercent(percent);
    std::vector<float> finite = finiteOf(values);
    return percentileOfFinite(finite, percent);
}

DisplayLimits percentileLimits(std::span<const float> values, double lowPercent,
                               double highPercent) {
    checkPercent(lowPercent);
    checkPercent(highPercent);
    if (!(lowPercent < highPercent))
        throw InputError({"", "percentiles of the display limits",
                          numberText(lowPercent) + " and " + numberText(highPercent),
                          "the lower one first"});
    std::vector<float> finite = finiteOf(values);
    if (finite.empty())
        return {};
    const double low = percentileOfFinite(finite, lowPercent);
    const double high = percentileOfFinite(finite, highPercent);
    if (low < high)
        return {low, high};
    return low == 0.0 ? DisplayLimits{}
                      : DisplayLimits{low - 0.01 * std::abs(low), low + 0.01 * std::abs(low)};
}

DisplayLimits objectLimits(std::span<const float> values) {
    constexpr double lowPercent = 0.5, highPercent = 99.0;
    constexpr std::size_t uniformShare = 20;
    std::vector<float> finite = finiteOf(values);
    const Run background = longestRun(finite);
    if (background.length * uniformShare < finite.size() || background.length == finite.size())
        return percentileLimits(values, lowPercent, highPercent);

    std::erase(finite, background.value);
    DisplayLimits limits = percentileLimits(finite, lowPercent, highPercent);
    limits.low = std::min(limits.low, static_cast<double>(background.value));
    limits.high = std::max(limits.high, static_cast<double>(background.value));
    return limits;
}

DisplayLimits limitsFor(ColorScale scale, std::span<const float> values) {
    return scale == ColorScale::linear ? objectLimits(values) : percentileLimits(values);
}

DisplayLimits symmetricLimits(std::span<const float> values, double percent) {
    checkPercent(percent);
    std::vector<float> finite = finiteOf(values);
    for (float& value : finite)
        value = std::abs(value);
    double largest = finite.empty() ? 0.0 : percentileOfFinite(finite, percent);
    if (!(largest > 0.0) && !finite.empty())
        largest = *std::ranges::max_element(finite);
    return largest > 0.0 ? DisplayLimits{-largest, largest} : DisplayLimits{-1.0, 1.0};
}

} // namespace irsg

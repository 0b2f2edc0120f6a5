#include "irsg/image/HotSpots.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

bool isMaximum(const RadianceImage& image, const ImageChannel& plane, int x, int y) {
    const float value = plane.values[image.offset(x, y)];
    bool exceedsOne = false;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height() - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width() - 1); ++u) {
            const float other = plane.values[image.offset(u, v)];
            if (other > value && std::isfinite(other))
                return false;
            exceedsOne = exceedsOne || other < value;
        }
    return exceedsOne;
}

} // namespace

std::vector<HotSpot> hottestSpots(const RadianceImage& image, const ImageChannel& plane,
                                  std::size_t most, int apart_px) {
    if (plane.values.size() != image.pixelCount() || apart_px < 1)
        throw LogicError("hot spots of a plane that is not as large as its image, or no distance");
    std::vector<HotSpot> all;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (const float value = plane.values[image.offset(x, y)];
                std::isfinite(value) && isMaximum(image, plane, x, y))
                all.push_back({x, y, static_cast<double>(value)});
    std::ranges::stable_sort(all, std::ranges::greater(), &HotSpot::value);
    std::vector<HotSpot> chosen;
    for (const HotSpot& spot : all) {
        if (chosen.size() >= most)
            break;
        const auto isNear = [&](const HotSpot& other) {
            return std::abs(other.x - spot.x) < apart_px && std::abs(other.y - spot.y) < apart_px;
        };
        if (std::ranges::none_of(chosen, isNear))
            chosen.push_back(spot);
    }
    return chosen;
}

} // namespace irsg

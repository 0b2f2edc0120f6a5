#include "irsg/image/ImageProfile.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

void checkPixel(const RadianceImage& image, int x, int y) {
    if (x < 0 || y < 0 || x >= image.width() || y >= image.height())
        throw InputError({"profile", "", "pixel " + std::to_string(x) + ", " + std::to_string(y),
                          "a pixel of the image of " + std::to_string(image.width()) + " x " +
                              std::to_string(image.height())});
}

} // namespace

ImageProfile profileAlong(const RadianceImage& image, const ImageChannel& plane, int fromX,
                          int fromY, int toX, int toY) {
    if (plane.values.size() != image.pixelCount())
        throw LogicError("a profile of a plane that is not as large as its image");
    checkPixel(image, fromX, fromY);
    checkPixel(image, toX, toY);
    const int steps = std::max(std::abs(toX - fromX), std::abs(toY - fromY));
    ImageProfile profile;
    for (int i = 0; i <= steps; ++i) {
        const double part = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
        const double alongX = part * (toX - fromX), alongY = part * (toY - fromY);
        const int x = fromX + static_cast<int>(std::lround(alongX));
        const int y = fromY + static_cast<int>(std::lround(alongY));
        profile.distance_px.push_back(std::hypot(alongX, alongY));
        profile.x.push_back(x);
        profile.y.push_back(y);
        profile.values.push_back(static_cast<double>(plane.values[image.offset(x, y)]));
    }
    return profile;
}

} // namespace irsg

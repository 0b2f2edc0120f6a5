#include "irsg/geometry/view/ImageRectangle.h"

namespace irsg {

PixelRegion PixelRegion::unitedWith(const PixelRegion& other) const {
    if (empty())
        return other;
    if (other.empty())
        return *this;
    const int left = std::min(x, other.x), top = std::min(y, other.y);
    const int right = std::max(x + width, other.x + other.width);
    const int bottom = std::max(y + height, other.y + other.height);
    return {left, top, right - left, bottom - top};
}

bool PixelRegion::intersects(const PixelRegion& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
           other.y < y + height;
}

bool ImageRectangle::intersects(const ImageRectangle& other) const {
    return !intersectedWith(other).empty();
}

ImageRectangle ImageRectangle::unitedWith(const ImageRectangle& other) const {
    if (empty())
        return other;
    if (other.empty())
        return *this;
    return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
            std::max(bottom, other.bottom)};
}

ImageRectangle ImageRectangle::intersectedWith(const ImageRectangle& other) const {
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
}

} // namespace irsg

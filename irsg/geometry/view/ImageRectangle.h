#pragma once

#include <algorithm>

namespace irsg {

/// A rectangle of the image plane in pixels, from the top left corner of the frame to the right and
/// down; not bound to whole pixels.
struct ImageRectangle {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

    bool empty() const { return !(left < right && top < bottom); }
    double width() const { return right - left; }
    double height() const { return bottom - top; }
    /// The longer side.
    double extent() const { return std::max(width(), height()); }
    bool intersects(const ImageRectangle& other) const;
    ImageRectangle unitedWith(const ImageRectangle& other) const;
    ImageRectangle intersectedWith(const ImageRectangle& other) const;
    bool operator==(const ImageRectangle&) const = default;
};

/// A rectangle of pixels of the sensor, top left pixel first.
struct PixelRegion {
    int x = 0, y = 0, width = 0, height = 0;

    ImageRectangle rectangle() const {
        return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(x + width),
                static_cast<double>(y + height)};
    }
    bool empty() const { return width <= 0 || height <= 0; }
    PixelRegion unitedWith(const PixelRegion& other) const;
    bool intersects(const PixelRegion& other) const;
    bool operator==(const PixelRegion&) const = default;
};

} // namespace irsg

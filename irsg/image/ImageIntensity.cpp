#include "irsg/image/ImageIntensity.h"

#include <charconv>
#include <cmath>
#include <numbers>

#include "irsg/core/Quantity.h"
#include "irsg/image/CompensatedSum.h"

namespace irsg {

namespace {

std::optional<double> numberOf(const RadianceImage& image, const char* attribute) {
    const auto found = image.attributes.find(attribute);
    if (found == image.attributes.end())
        return std::nullopt;
    double value = 0.0;
    const std::string& text = found->second;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace

std::optional<ImageGeometry> geometryOf(const RadianceImage& image) {
    const auto field = numberOf(image, "sensor.horizontal_field_of_view_deg");
    const auto range = numberOf(image, "range_m");
    const auto background = numberOf(image, "background_W_m2_sr");
    if (!field || !range || !background || *field <= 0.0 || *field >= 180.0 || *range <= 0.0)
        return std::nullopt;
    return ImageGeometry{*field, *range, *background};
}

PixelSolidAngles::PixelSolidAngles(int width, int height, double horizontalFieldOfView_deg)
    : pitch_(2.0 * std::tan(horizontalFieldOfView_deg * std::numbers::pi / 360.0) / width),
      centreX_(0.5 * width - 0.5),
      centreY_(0.5 * height - 0.5) {}

double PixelSolidAngles::at_sr(int x, int y) const {
    const double u = (x - centreX_) * pitch_, v = (y - centreY_) * pitch_;
    const double secant = std::sqrt(1.0 + u * u + v * v);
    return pitch_ * pitch_ / (secant * secant * secant);
}

bool isRadiance(const ImageChannel& plane) {
    return plane.unit == info(Quantity::radiance).unit;
}

std::optional<double> contrastIntensity_W_sr(const RadianceImage& image, const ImageChannel& plane,
                                             const std::optional<PixelRectangle>& rectangle) {
    const PixelRectangle area = checkedRectangle(image, rectangle);
    const std::optional<ImageGeometry> geometry = geometryOf(image);
    if (!geometry || !isRadiance(plane))
        return std::nullopt;

    const PixelSolidAngles angles(image.width(), image.height(),
                                  geometry->horizontalFieldOfView_deg);
    CompensatedSum sum;
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x) {
            const double value = plane.values[image.offset(x, y)];
            if (std::isfinite(value))
                sum.add((value - geometry->background_W_m2_sr) * angles.at_sr(x, y));
        }
    return sum.value() * geometry->range_m * geometry->range_m;
}

} // namespace irsg

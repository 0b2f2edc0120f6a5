#include "irsg/geometry/view/ImageQuantity.h"

#include <algorithm>

#include "irsg/core/Quantity.h"
#include "irsg/image/ApparentTemperature.h"

namespace irsg {

namespace {

/// The shown channel of an image is its first.
void moveLastToFront(RadianceImage& image) {
    std::rotate(image.channels.begin(), image.channels.end() - 1, image.channels.end());
}

} // namespace

void showIrradiance(RadianceImage& image, const Sensor& sensor) {
    ImageChannel irradiance{"E", std::string(info(Quantity::irradiance).unit),
                            image.primary().values};
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            float& value = irradiance.values[image.offset(x, y)];
            value = static_cast<float>(value * sensor.pixelSolidAngle_sr(x, y) *
                                       sensor.cosOffAxis(x, y));
        }
    }
    image.channels.push_back(std::move(irradiance));
    moveLastToFront(image);
}

std::size_t showApparentTemperature(RadianceImage& image, const Sensor& sensor) {
    const std::size_t without = addApparentTemperature(image, sensor.band);
    moveLastToFront(image);
    return without;
}

} // namespace irsg

#include "irsg/image/RadianceImage.h"

#include <algorithm>

#include "irsg/radiometry/Errors.h"

namespace irsg {

RadianceImage::RadianceImage(int width, int height, const std::string& firstChannel,
                             const std::string& unit)
    : width_(width), height_(height) {
    if (width < 1 || height < 1)
        throw LogicError("an image of " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels was asked for");
    channel(firstChannel, unit);
}

ImageChannel& RadianceImage::channel(const std::string& name, const std::string& unit) {
    const auto known = std::ranges::find(channels, name, &ImageChannel::name);
    if (known != channels.end())
        return *known;
    if (empty())
        throw LogicError("a channel was added to an image without pixels");
    return channels.emplace_back(ImageChannel{name, unit, std::vector<float>(pixelCount(), 0.0F)});
}

const ImageChannel* RadianceImage::find(const std::string& name) const {
    const auto known = std::ranges::find(channels, name, &ImageChannel::name);
    return known == channels.end() ? nullptr : &*known;
}

ImageChannel& RadianceImage::primary() {
    if (channels.empty())
        throw LogicError("an empty image has no channel to show");
    return channels.front();
}

const ImageChannel& RadianceImage::primary() const {
    if (channels.empty())
        throw LogicError("an empty image has no channel to show");
    return channels.front();
}

} // namespace irsg

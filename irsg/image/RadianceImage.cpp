#include "irsg/image/RadianceImage.h"

#include <algorithm>
#include <set>

#include "irsg/core/Errors.h"

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

void checkPlanes(const RadianceImage& image) {
    if (image.empty() || image.channels.empty())
        throw LogicError("an empty image cannot be written");
    const auto checkName = [](const std::string& name, const std::string& what) {
        if (name.empty() || name.size() > 200 || name.find('\0') != std::string::npos)
            throw LogicError(what + " of an image has an empty, too long or broken name: '" + name +
                             "'");
    };
    std::set<std::string> seen;
    for (const ImageChannel& channel : image.channels) {
        checkName(channel.name, "a channel");
        if (!seen.insert(channel.name).second)
            throw LogicError("two channels of an image are called " + channel.name);
        if (channel.values.size() != image.pixelCount())
            throw LogicError("channel " + channel.name + " has " +
                             std::to_string(channel.values.size()) + " values, the image has " +
                             std::to_string(image.pixelCount()) + " pixels");
    }
    for (const auto& [name, value] : image.attributes)
        checkName(name, "an attribute");
}

} // namespace irsg

#include "gui/image/ColorPicture.h"

#include <algorithm>

#include "irsg/core/Errors.h"
#include "irsg/image/ImageStatistics.h"

namespace smat::gui {
namespace {

constexpr std::array primaries{"R", "G", "B"};
constexpr std::array<float, 3> luminances{0.2126F, 0.7152F, 0.0722F};
constexpr double brightPercent = 99.5;

} // namespace

bool isColorPicture(const irsg::RadianceImage& image) {
    return std::ranges::all_of(primaries,
                               [&](const char* name) { return image.find(name) != nullptr; });
}

std::shared_ptr<const irsg::RadianceImage> withLuminance(const irsg::RadianceImage& image) {
    auto with = std::make_shared<irsg::RadianceImage>(image);
    std::string name = "Luminance";
    while (with->find(name) != nullptr)
        name += "_";
    irsg::ImageChannel luminance{name, image.find("G")->unit,
                                 std::vector<float>(image.pixelCount())};
    for (std::size_t k = 0; k < primaries.size(); ++k) {
        const std::vector<float>& values = image.find(primaries[k])->values;
        for (std::size_t i = 0; i < values.size(); ++i)
            luminance.values[i] += luminances[k] * values[i];
    }
    with->channels.push_back(std::move(luminance));
    return with;
}

LightPlanes lightOf(const std::shared_ptr<const irsg::RadianceImage>& image) {
    if (!isColorPicture(*image))
        throw irsg::LogicError("an image without red, green and blue has no colours of its own");
    return {shareValues(image, *image->find("R")), shareValues(image, *image->find("G")),
            shareValues(image, *image->find("B"))};
}

FoundLimits findLightLimits(const ColorRule& rule, const SharedValues& luminance,
                            const std::optional<irsg::DisplayLimits>& known) {
    ColorRule straight = rule;
    straight.scale = irsg::ColorScale::linear;
    std::optional<irsg::DisplayLimits> limits = known;
    if (!limits && rule.mode == LimitMode::target)
        limits = irsg::DisplayLimits{
            0.0, std::max(1.0, irsg::percentileLimits(*luminance, 0.0, brightPercent).high)};
    return findLimits(straight, {luminance}, limits);
}

} // namespace smat::gui

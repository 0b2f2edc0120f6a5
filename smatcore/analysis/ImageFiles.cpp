#include "smatcore/analysis/ImageFiles.h"

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/geometry/view/ImageQuantity.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/ImageStatistics.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/settings/SettingInfo.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

/// The limits of the colours: those that are set, the image's own for the others.
irsg::DisplayLimits limitsOf(const irsg::ImageChannel& plane, const Settings& settings,
                             const std::string& whose) {
    const std::vector<float>& values = plane.values;
    const irsg::ColorScale scale = irsg::colorScaleNamed(settings.text(key::displayScale));
    irsg::DisplayLimits limits = irsg::limitsFor(scale, values);
    const auto minimum = settings[key::displayMinimum];
    const auto maximum = settings[key::displayMaximum];
    limits.low = minimum.value_or(limits.low);
    limits.high = maximum.value_or(limits.high);
    limits.marksOutside = settings[key::displayMarkOutside];
    if (limits.low >= limits.high) {
        const OptionalRealKey key = maximum ? key::displayMaximum : key::displayMinimum;
        throw irsg::InputError(
            irsg::Diagnostic{.file = whose,
                             .position = key,
                             .value = settings.text(key),
                             .expected = "a least value below the largest that is shown"});
    }
    return limits.with(scale, {values});
}

} // namespace

irsg::PngViewOptions viewOf(const irsg::ImageChannel& plane, const Settings& settings,
                            const PictureWords& words, const std::string& whose) {
    irsg::PngViewOptions view;
    view.colorMap = settings.text(key::displayColorMap);
    view.limits = limitsOf(plane, settings, whose);
    view.title = words.title;
    view.conditions = lineOf(words.conditions);
    return view;
}

std::string showQuantity(irsg::RadianceImage& image, const irsg::Sensor& sensor,
                         const Settings& settings) {
    const std::string& quantity = settings.text(key::imageQuantity);
    if (quantity == "counts" && image.find("counts") == nullptr)
        throw irsg::InputError({"", key::imageQuantity.name, quantity,
                                "radiance, irradiance or apparent-temperature: no sensor that "
                                "counts reads this image"});
    if (quantity == "irradiance") {
        irsg::showIrradiance(image, sensor);
    } else if (quantity == "apparent-temperature") {
        const std::size_t without = irsg::showApparentTemperature(image, sensor);
        if (without > 0) {
            return fmt::format("{} pixels without radiance have no apparent temperature (nan)",
                               without);
        }
    }
    return "";
}

void saveImage(const irsg::RadianceImage& image, const Settings& settings,
               const PictureWords& words, const std::string& whose,
               const std::filesystem::path& file) {
    irsg::ImageWriting how;
    const irsg::ImageFormat& format = irsg::requiredImageFormat(file);
    if (format.keeps == irsg::ImageFormat::Keeps::picture)
        how.view = viewOf(image.primary(), settings, words, whose);
    format.write(image, file, how);
}

Settings displayOf(const irsg::RadianceImage& image) {
    Settings settings;
    for (const auto& [name, text] : image.attributes)
        if (name.starts_with("display.") && findSetting(name) != nullptr)
            settings.set(name, text);
    return settings;
}

} // namespace smat

#include "smatcore/analysis/ImageFiles.h"

#include <fmt/format.h>

#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageStatistics.h"
#include "irsg/image/PngView.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/analysis/ImageQuantity.h"

namespace smat {

namespace {

/// The limits of the colours: those that are set, the image's own for the others.
irsg::DisplayLimits limitsOf(const irsg::RadianceImage& image, const Settings& settings,
                             const std::string& whose) {
    const std::vector<float>& values = image.primary().values;
    const irsg::ColorScale scale = irsg::colorScaleNamed(settings.text("display.scale"));
    irsg::DisplayLimits limits = irsg::limitsFor(scale, values);
    const auto minimum = settings.optionalReal("display.minimum");
    const auto maximum = settings.optionalReal("display.maximum");
    limits.low = minimum.value_or(limits.low);
    limits.high = maximum.value_or(limits.high);
    if (limits.low >= limits.high) {
        const char* key = maximum ? "display.maximum" : "display.minimum";
        throw irsg::InputError(
            irsg::Diagnostic{.file = whose,
                             .position = key,
                             .value = settings.text(key),
                             .expected = "a least value below the largest that is shown"});
    }
    return limits.with(scale, {values});
}

} // namespace

const std::vector<std::string>& imageExtensions() {
    static const std::vector<std::string> extensions = {".exr", ".csv", ".png"};
    return extensions;
}

std::string showQuantity(irsg::RadianceImage& image, const irsg::Sensor& sensor,
                         const Settings& settings) {
    const std::string& quantity = settings.text("image.quantity");
    if (quantity == "irradiance") {
        showIrradiance(image, sensor);
    } else if (quantity == "apparent-temperature") {
        const std::size_t without = showApparentTemperature(image, sensor);
        if (without > 0) {
            return fmt::format("{} pixels without radiance have no apparent temperature (nan)",
                               without);
        }
    }
    return "";
}

void saveImage(const irsg::RadianceImage& image, const Settings& settings, const std::string& title,
               const std::string& whose, const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".exr") {
        irsg::writeExr(image, file);
    } else if (extension == ".png") {
        irsg::PngViewOptions options;
        options.colorMap = settings.text("display.colorMap");
        options.limits = limitsOf(image, settings, whose);
        options.title = title;
        irsg::writePngView(image, file, options);
    } else {
        irsg::writeCsvImage(image, file);
    }
}

} // namespace smat

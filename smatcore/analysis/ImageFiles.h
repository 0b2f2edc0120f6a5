#pragma once

#include <filesystem>
#include <string>

#include "irsg/geometry/view/Sensor.h"
#include "irsg/image/PngView.h"
#include "irsg/image/RadianceImage.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/settings/Settings.h"

namespace smat {

/// Puts what `image.quantity` asks for in front of an image of radiance. Returns a sentence about
/// pixels that have no such value, or "".
std::string showQuantity(irsg::RadianceImage& image, const irsg::Sensor& sensor,
                         const Settings& settings);

/// What stands above an image that is written as a picture.
struct PictureWords {
    std::string title;
    std::vector<Condition> conditions; ///< on the line below
};

/// How a plane is made into a picture with the colours of `display`. `whose` is the file that
/// errors about the settings name. Throws InputError for limits that are not ascending.
irsg::PngViewOptions viewOf(const irsg::ImageChannel& plane, const Settings& settings,
                            const PictureWords& words, const std::string& whose);

/// The settings of `display` that an image was calculated with, from its attributes; the defaults
/// where it has none.
Settings displayOf(const irsg::RadianceImage& image);

/// Writes an image in the format of its extension (irsg::ImageFormat), a picture with the colours
/// of `display` and these words. `whose` is the file that errors about the settings name. Throws
/// InputError where the file cannot be written, for another extension and for limits of the colours
/// that are not ascending.
void saveImage(const irsg::RadianceImage& image, const Settings& settings,
               const PictureWords& words, const std::string& whose,
               const std::filesystem::path& file);

} // namespace smat

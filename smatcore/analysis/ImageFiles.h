#pragma once

#include <filesystem>
#include <string>

#include "irsg/image/RadianceImage.h"
#include "irsg/scene/view/Sensor.h"
#include "smatcore/settings/Settings.h"

namespace smat {

/// Puts what `image.quantity` asks for in front of an image of radiance. Returns a sentence about
/// pixels that have no such value, or "".
std::string showQuantity(irsg::RadianceImage& image, const irsg::Sensor& sensor,
                         const Settings& settings);

/// Writes an image in the format of its extension (irsg::ImageFormat), a picture with the colours
/// of `display` and this title. `whose` is the file that errors about the settings name. Throws
/// InputError where the file cannot be written, for another extension and for limits of the colours
/// that are not ascending.
void saveImage(const irsg::RadianceImage& image, const Settings& settings, const std::string& title,
               const std::string& whose, const std::filesystem::path& file);

} // namespace smat

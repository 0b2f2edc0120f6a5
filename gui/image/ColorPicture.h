#pragma once

#include <memory>
#include <optional>

#include "gui/image/ColorRule.h"
#include "irsg/image/RadianceImage.h"

namespace smat::gui {

/// Whether an image is a picture in visible light: planes R, G and B, as cameras and painting
/// programs write them, linear.
bool isColorPicture(const irsg::RadianceImage& image);
/// A copy with a plane more, its luminance of ITU-R BT.709, by which it is read and measured.
std::shared_ptr<const irsg::RadianceImage> withLuminance(const irsg::RadianceImage& image);
/// Its three planes. LogicError for another image.
LightPlanes lightOf(const std::shared_ptr<const irsg::RadianceImage>& image);
/// Limits of such a picture: black is 0 and white is 1, or what all but the brightest half a
/// percent stay below. The other modes are those of any plane.
FoundLimits findLightLimits(const ColorRule& rule, const SharedValues& luminance,
                            const std::optional<irsg::DisplayLimits>& known);

} // namespace smat::gui

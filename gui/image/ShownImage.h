#pragma once

#include <memory>

#include "gui/widgets/DisplayUnits.h"
#include "irsg/image/RadianceImage.h"

namespace smat::gui {

/// The unit that a plane is shown in; null for its own. Of temperatures alone: what differs in K,
/// such as the noise of a sensor, has no other zero.
const ShownUnit* unitOfPlane(const irsg::ImageChannel& plane);
/// The plane as it is shown (DisplayUnits), by that of the image; the same where units are its own.
irsg::ImageChannel inShownUnits(const irsg::ImageChannel& plane);
/// An image with such planes: itself where none differs.
std::shared_ptr<const irsg::RadianceImage>
inShownUnits(const std::shared_ptr<const irsg::RadianceImage>& image);

} // namespace smat::gui

#include "gui/image/ShownImage.h"

#include <algorithm>

#include "irsg/image/ApparentTemperature.h"

namespace smat::gui {

const ShownUnit* unitOfPlane(const irsg::ImageChannel& plane) {
    const bool isTemperature = plane.name == irsg::apparentTemperatureChannel || plane.name == "T";
    return isTemperature ? shownUnitOf(plane.unit) : nullptr;
}

irsg::ImageChannel inShownUnits(const irsg::ImageChannel& plane) {
    irsg::ImageChannel made = plane;
    const ShownUnit* unit = unitOfPlane(plane);
    if (unit == nullptr)
        return made;
    std::ranges::transform(made.values, made.values.begin(), [&](float value) {
        return static_cast<float>(unit->shown(static_cast<double>(value)));
    });
    made.unit = unit->unit.toStdString();
    return made;
}

std::shared_ptr<const irsg::RadianceImage>
inShownUnits(const std::shared_ptr<const irsg::RadianceImage>& image) {
    if (std::ranges::none_of(image->channels, unitOfPlane))
        return image;
    auto made = std::make_shared<irsg::RadianceImage>(*image);
    for (irsg::ImageChannel& plane : made->channels)
        plane = inShownUnits(plane);
    return made;
}

} // namespace smat::gui

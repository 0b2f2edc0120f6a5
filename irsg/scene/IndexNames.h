#pragma once

#include <vector>

#include "irsg/geometry/Entity.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Names what the indices of an image's truth layers stand for, as its attributes:
/// `temperature_index.5` "exhaust", likewise of material_index, and of object_index where there is
/// that plane. Where objects have several names for an index they stand with " / " between.
void nameIndices(const std::vector<Entity>& entities, RadianceImage& image);

} // namespace irsg

#pragma once

#include <vector>

#include "irsg/render/sampling/ObjectExtent.h"
#include "irsg/render/sampling/SampleTile.h"

namespace irsg {

/// Objects whose extents overlap, directly or through others: what may hide one another.
struct EntityGroup {
    ImageRectangle extent; ///< of all together
    std::vector<ObjectExtent> members;

    std::vector<int> entities() const;
};

std::vector<EntityGroup> overlappingGroups(const std::vector<ObjectExtent>& objects);

/// The blocks of a level that an extent touches, with one sample each.
SampleTile tileOnBlocks(const ImageRectangle& extent, int level);

} // namespace irsg

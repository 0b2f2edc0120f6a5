#include "irsg/render/sampling/SupersamplingStrategy.h"

#include "irsg/render/sampling/EntityGroups.h"

namespace irsg {

std::vector<SampleTile>
SupersamplingStrategy::tiles(const std::vector<ObjectExtent>& objects) const {
    std::vector<SampleTile> result;
    for (const EntityGroup& group : overlappingGroups(objects)) {
        SampleTile& tile = result.emplace_back(tileOnBlocks(group.extent, 0));
        tile.samplesAcross = samplesAcross_;
        tile.samplesDown = samplesDown_;
        tile.entities = group.entities();
    }
    return result;
}

} // namespace irsg

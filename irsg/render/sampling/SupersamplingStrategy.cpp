#include "irsg/render/sampling/SupersamplingStrategy.h"

#include "irsg/render/sampling/EntityGroups.h"

namespace irsg {

std::vector<SampleWindow>
SupersamplingStrategy::windows(const std::vector<ZoomEntityInfo>& objects) const {
    std::vector<SampleWindow> result;
    for (const EntityGroup& group : overlappingGroups(objects)) {
        SampleWindow& window = result.emplace_back(windowOnTiles(group.extent, 0));
        window.samplesAcross = samplesAcross_;
        window.samplesDown = samplesDown_;
        window.entities = group.entities();
    }
    return result;
}

} // namespace irsg

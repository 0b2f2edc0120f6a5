#include "irsg/render/sampling/EntityGroups.h"

#include <cmath>

#include "irsg/render/sampling/Uniting.h"

namespace irsg {

std::vector<int> EntityGroup::entities() const {
    std::vector<int> result;
    for (const ObjectExtent& member : members)
        result.push_back(member.entity);
    std::ranges::sort(result);
    return result;
}

std::vector<EntityGroup> overlappingGroups(const std::vector<ObjectExtent>& objects) {
    std::vector<EntityGroup> groups;
    for (const ObjectExtent& object : objects)
        groups.push_back({object.extent, {object}});

    uniteAll(
        groups,
        [](const EntityGroup& a, const EntityGroup& b) { return a.extent.intersects(b.extent); },
        [](EntityGroup a, const EntityGroup& b) {
            a.extent = a.extent.unitedWith(b.extent);
            a.members.insert(a.members.end(), b.members.begin(), b.members.end());
            return a;
        });
    return groups;
}

SampleTile tileOnBlocks(const ImageRectangle& extent, int level) {
    const auto block = [&](double place_px) { return std::ldexp(place_px, level); };
    SampleTile tile;
    tile.level = level;
    tile.blockX = static_cast<std::int64_t>(std::floor(block(extent.left)));
    tile.blockY = static_cast<std::int64_t>(std::floor(block(extent.top)));
    const auto past = [&](double place_px, std::int64_t first) {
        const auto end = static_cast<std::int64_t>(std::ceil(block(place_px)));
        return static_cast<int>(std::max<std::int64_t>(end - first, 1));
    };
    tile.blocksWide = past(extent.right, tile.blockX);
    tile.blocksHigh = past(extent.bottom, tile.blockY);
    return tile;
}

} // namespace irsg

#include "irsg/scene/antialiasing/EntityGroups.h"

#include <cmath>

namespace irsg {

std::vector<int> EntityGroup::entities() const {
    std::vector<int> result;
    for (const ZoomEntityInfo& member : members)
        result.push_back(member.entity);
    std::ranges::sort(result);
    return result;
}

std::vector<EntityGroup> overlappingGroups(const std::vector<ZoomEntityInfo>& objects) {
    std::vector<EntityGroup> groups;
    for (const ZoomEntityInfo& object : objects)
        groups.push_back({object.extent, {object}});

    // Two groups become one until no two overlap; a united extent may reach further groups.
    for (std::size_t a = 0; a < groups.size();) {
        bool grew = false;
        for (std::size_t b = a + 1; b < groups.size();) {
            if (!groups[a].extent.intersects(groups[b].extent)) {
                ++b;
                continue;
            }
            groups[a].extent = groups[a].extent.unitedWith(groups[b].extent);
            groups[a].members.insert(groups[a].members.end(), groups[b].members.begin(),
                                     groups[b].members.end());
            groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(b));
            grew = true;
        }
        if (!grew)
            ++a;
    }
    return groups;
}

SampleWindow windowOnTiles(const ImageRectangle& extent, int level) {
    const auto tile = [&](double place_px) { return std::ldexp(place_px, level); };
    SampleWindow window;
    window.level = level;
    window.tileX = static_cast<std::int64_t>(std::floor(tile(extent.left)));
    window.tileY = static_cast<std::int64_t>(std::floor(tile(extent.top)));
    const auto past = [&](double place_px, std::int64_t first) {
        const auto end = static_cast<std::int64_t>(std::ceil(tile(place_px)));
        return static_cast<int>(std::max<std::int64_t>(end - first, 1));
    };
    window.tilesWide = past(extent.right, window.tileX);
    window.tilesHigh = past(extent.bottom, window.tileY);
    return window;
}

} // namespace irsg

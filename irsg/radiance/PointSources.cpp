#include "irsg/radiance/PointSources.h"

#include <cmath>

namespace irsg {

Vec3 PointSources::onGrid(const Vec3& direction, double step) {
    const auto rounded = [step](double component) { return step * std::round(component / step); };
    return normalized({rounded(direction.x), rounded(direction.y), rounded(direction.z)});
}

const PointGeometry& PointSources::of(int entity, const PointAspect& aspect,
                                      const std::function<PointGeometry()>& draw) {
    RecentlyUsed<CacheEntry>& kept = cache_.try_emplace(entity, mostCached).first->second;
    return kept
        .of([&](const CacheEntry& known) { return known.aspect == aspect; },
            [&] {
                return CacheEntry{aspect, draw()};
            })
        .factors;
}

} // namespace irsg

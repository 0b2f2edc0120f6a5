#include "irsg/scene/radiance/PointSources.h"

#include <algorithm>
#include <cmath>

namespace irsg {

Vec3 PointSources::onGrid(const Vec3& direction, double step) {
    const auto rounded = [step](double component) { return step * std::round(component / step); };
    return normalized({rounded(direction.x), rounded(direction.y), rounded(direction.z)});
}

const FactorField<double>&
PointSources::sums_sr_m2(int entity, const PointAspect& aspect,
                         const std::function<FactorField<double>()>& draw) {
    std::list<Kept>& kept = kept_[entity];
    const auto found = std::ranges::find(kept, aspect, &Kept::aspect);
    if (found != kept.end()) {
        kept.splice(kept.begin(), kept, found);
    } else {
        kept.push_front({aspect, draw()});
        if (kept.size() > mostKept)
            kept.pop_back();
    }
    return kept.front().sums_sr_m2;
}

} // namespace irsg

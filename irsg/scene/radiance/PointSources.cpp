#include "irsg/scene/radiance/PointSources.h"

#include <algorithm>
#include <cmath>

namespace irsg {

Vec3 PointSources::onGrid(const Vec3& direction) {
    const auto rounded = [](double component) {
        return directionStep * std::round(component / directionStep);
    };
    return normalized({rounded(direction.x), rounded(direction.y), rounded(direction.z)});
}

const ProjectedFactors& PointSources::sums_sr_m2(int entity, const PointAspect& aspect,
                                                 const std::function<ProjectedFactors()>& draw) {
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

FactorSums atDistance(const FactorSums& sums_sr_m2, double distance_m, double pixel_sr,
                      double cosOffAxis, double background_W_m2_sr) {
    const double scale = 1.0 / (distance_m * distance_m);
    FactorSums sums;
    sums.coverage_sr = scale * sums_sr_m2.coverage_sr;
    sums.thermal_sr = scale * sums_sr_m2.thermal_sr;
    sums.up_sr = scale * sums_sr_m2.up_sr;
    sums.down_sr = scale * sums_sr_m2.down_sr;
    sums.sun_sr = scale * sums_sr_m2.sun_sr;
    sums.coverageCos_sr = cosOffAxis * sums.coverage_sr;
    sums.thermalCos_sr = cosOffAxis * sums.thermal_sr;
    sums.upCos_sr = cosOffAxis * sums.up_sr;
    sums.downCos_sr = cosOffAxis * sums.down_sr;
    sums.sunCos_sr = cosOffAxis * sums.sun_sr;
    sums.pixels = sums.coverage_sr / pixel_sr;
    sums.background_W_m2 = sums.coverage_sr * background_W_m2_sr;
    sums.backgroundCos_W_m2 = cosOffAxis * sums.background_W_m2;
    return sums;
}

} // namespace irsg

#include "irsg/atmosphere/engine/SunPaths.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/PathIntegrator.h"

namespace irsg {

SunPaths::SunPaths(const RayTracer& tracer, const SunPosition& sun)
    : elevation_rad_(sun.elevation_rad),
      strength_(sun.strength()),
      sinElevation_(std::max(std::sin(sun.elevation_rad), 0.0)) {
    const std::vector<double>& altitudes_m = tracer.gridAltitudes_m();
    parts_.resize(altitudes_m.size());
    weights_.resize(altitudes_m.size());
    // The higher the level, the deeper its horizon: the highest is in the dark last.
    for (std::size_t level = altitudes_m.size(); level-- > 0;) {
        const auto [part, ray] = tracer.sunbeam(altitudes_m[level], sun.elevation_rad);
        parts_[level] = part;
        isAnyLit_ = isAnyLit_ || part > 0.0;
        if (!isAnyLit_)
            return;
        weights_[level] = levelWeights(ray, altitudes_m.size());
    }
}

} // namespace irsg

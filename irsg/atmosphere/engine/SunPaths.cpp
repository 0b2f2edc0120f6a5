#include "irsg/atmosphere/engine/SunPaths.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/PathIntegrator.h"

namespace irsg {

SunPaths::SunPaths(const RayTracer& tracer, double trueElevation_rad)
    : elevation_rad_(trueElevation_rad), sinElevation_(std::max(std::sin(trueElevation_rad), 0.0)) {
    const std::vector<double>& altitudes_m = tracer.gridAltitudes_m();
    weights_.resize(altitudes_m.size());
    // Where the sun has set for one level it has for all below.
    for (std::size_t level = altitudes_m.size(); level-- > 0;) {
        const RayPath path = tracer.towardsSun(altitudes_m[level], trueElevation_rad);
        if (path.end != RayPath::End::space)
            return;
        isAnyLit_ = true;
        weights_[level] = levelWeights(path, altitudes_m.size());
    }
}

} // namespace irsg

#include "irsg/atmosphere/engine/SunPaths.h"

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/engine/PathIntegrator.h"

namespace irsg {

SunPaths::SunPaths(const RayTracer& tracer, double trueElevation_rad)
    : elevation_rad_(trueElevation_rad), sinElevation_(std::max(std::sin(trueElevation_rad), 0.0)) {
    const std::vector<double>& altitudes_m = tracer.gridAltitudes_m();
    for (const double altitude_m : altitudes_m) {
        const RayPath path = tracer.towardsSun(altitude_m, trueElevation_rad);
        const bool isLit = path.end == RayPath::End::space;
        isAnyLit_ = isAnyLit_ || isLit;
        weights_.push_back(isLit ? levelWeights(path, altitudes_m.size()) : std::vector<double>());
    }
}

} // namespace irsg

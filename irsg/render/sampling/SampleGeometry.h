#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "irsg/geometry/view/Vec3.h"

namespace irsg {

/// Where a sample lies on a surface, eye space.
struct SampleGeometry {
    Vec3 normal;        ///< unit, to the side that is seen
    Vec3 eyePosition_m; ///< from the eye to the sample
    double nAngleFactor = 0.0;
    const std::vector<std::pair<std::string, Vec3>>& directionsEye; ///< of the frame
};
using GeometryFactorFunction = std::function<double(const SampleGeometry&)>;

} // namespace irsg

#pragma once

#include <vector>

#include "irsg/render/sampling/ObjectExtent.h"

namespace irsg {

/// How each object of a frame is sampled. An object that is seen is in one of the last three.
struct FramePlan {
    std::vector<ObjectExtent> seen;   ///< all that the frame shows, but those along the range
    std::vector<ObjectExtent> drawn;  ///< in tiles of the frame, with their hot details
    std::vector<ObjectExtent> points; ///< as point sources
    /// Their factors are interpolated between distances.
    std::vector<ObjectExtent> alongRange;
};

} // namespace irsg

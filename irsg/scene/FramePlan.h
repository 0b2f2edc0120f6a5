#pragma once

#include <vector>

#include "irsg/render/sampling/ZoomEntityInfo.h"

namespace irsg {

/// How each object of a frame is sampled. An object that is seen is in one of the last three.
struct FramePlan {
    std::vector<ZoomEntityInfo> seen;   ///< all that the frame shows, but those along the range
    std::vector<ZoomEntityInfo> drawn;  ///< in tiles of the frame, with their hot details
    std::vector<ZoomEntityInfo> points; ///< as point sources
    /// Their factors are interpolated between distances.
    std::vector<ZoomEntityInfo> alongRange;
};

} // namespace irsg

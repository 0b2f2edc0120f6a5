#pragma once

#include <vector>

#include "irsg/render/sampling/ObjectExtent.h"

namespace irsg {

/// An object that is not sampled for its range alone.
struct AlongRange {
    ObjectExtent object;
    /// How far it, and terrain that may hide some of it, reach from its reference point.
    double reach_m = 0.0;
    bool isAmongTerrain = false; ///< some of which may hide it
};

/// How each object of a frame is sampled. An object that is seen is in one of the last three.
struct FramePlan {
    std::vector<ObjectExtent> seen;   ///< all that the frame shows, but those along the range
    std::vector<ObjectExtent> drawn;  ///< in tiles of the frame, with their hot details
    std::vector<ObjectExtent> points; ///< as point sources
    /// Their factors are interpolated between distances.
    std::vector<AlongRange> alongRange;
};

} // namespace irsg

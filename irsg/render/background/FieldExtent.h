#pragma once

#include "irsg/render/background/FieldRays.h"

namespace irsg {

/// The directions a frame sees: its span in elevation, and in azimuth relative to a given one.
struct FieldExtent {
    double lowest_rad = 0.0, highest_rad = 0.0;
    double left_rad = 0.0, right_rad = 0.0;
    bool allAround = false; ///< the zenith or the nadir is in the frame

    static FieldExtent of(const FieldRays& rays, double middleAzimuth_rad);
};

} // namespace irsg

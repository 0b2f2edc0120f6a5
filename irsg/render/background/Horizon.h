#pragma once

#include "irsg/render/background/FieldRays.h"

namespace irsg {

/// The horizon of a sensor in its image: the cone of one elevation about the vertical. Within one
/// pixel it is taken as a straight line.
class Horizon {
  public:
    Horizon(const FieldRays& rays, double elevation_rad);

    /// The line through the pixel about (u, v): sky is where level + du * slopeU + dv * slopeV > 0.
    struct Line {
        double level, slopeU, slopeV;
    };
    Line lineAt(double u, double v) const;
    /// How much of the area of the pixel about (u, v) is sky, 0 to 1.
    double skyFraction(double u, double v) const;

    double elevation_rad() const { return elevation_rad_; }

  private:
    double elevation_rad_, sine_;
    double pitch_;
    double rightZ_, upZ_, forwardZ_;
};

} // namespace irsg

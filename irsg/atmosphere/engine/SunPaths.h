#pragma once

#include <vector>

#include "irsg/atmosphere/engine/RayPath.h"

namespace irsg {

/// The refracted paths of sunlight from the top of the air down to every level of the grid, for one
/// place of the sun, as weights of levels (see PathIntegrator.h).
class SunPaths {
  public:
    SunPaths(const RayTracer& tracer, const SunPosition& sun);

    double elevation_rad() const { return elevation_rad_; }
    /// Of the sun's light above the air in terms of that from one astronomical unit.
    double strength() const { return strength_; }
    /// Sine of the elevation, 0 below the horizon: what a horizontal plane gets of the beam.
    double sinElevation() const { return sinElevation_; }
    /// The part of the disc that shines on a level, 0 to 1.
    double part(std::size_t level) const { return parts_[level]; }
    /// Does it shine on any?
    bool isAnyLit() const { return isAnyLit_; }
    /// m per level, along the ray from the middle of that part, or along the one that grazes the
    /// ground where the earth hides the sun. Empty where it shines on no level.
    const std::vector<double>& weights(std::size_t level) const { return weights_[level]; }

  private:
    double elevation_rad_;
    double strength_;
    double sinElevation_;
    bool isAnyLit_ = false;
    std::vector<double> parts_;
    std::vector<std::vector<double>> weights_;
};

} // namespace irsg

#pragma once

#include <vector>

#include "irsg/atmosphere/engine/RayPath.h"

namespace irsg {

/// The refracted paths of sunlight from the top of the air down to every level of the grid, for one
/// elevation of the sun, as weights of levels (see PathIntegrator.h).
class SunPaths {
  public:
    SunPaths(const RayTracer& tracer, double trueElevation_rad);

    double elevation_rad() const { return elevation_rad_; }
    /// Sine of the elevation, 0 below the horizon: what a horizontal plane gets of the beam.
    double sinElevation() const { return sinElevation_; }
    /// Does the sun shine on a level?
    bool isLit(std::size_t level) const { return !weights_[level].empty(); }
    /// On any?
    bool isAnyLit() const { return isAnyLit_; }
    /// m per level; empty where the earth hides the sun.
    const std::vector<double>& weights(std::size_t level) const { return weights_[level]; }

  private:
    double elevation_rad_;
    double sinElevation_;
    bool isAnyLit_ = false;
    std::vector<std::vector<double>> weights_;
};

} // namespace irsg

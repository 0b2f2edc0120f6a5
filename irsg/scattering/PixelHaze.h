#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "irsg/scattering/HazeFunction.h"

namespace irsg {

/// How much of a pixel's light every pixel around it receives as haze: the density of a
/// HazeFunction integrated over square pixels, times a radial taper that ends it at a stated
/// distance, so that its transform cannot wrap around. The taper is a raised cosine over the last
/// quarter. Values depend on the distance to the pixel alone (eight-fold symmetry is exact).
class PixelHaze {
  public:
    /// `pitch_rad`: angle of a pixel (its size over the focal length), > 0. `support_px` >= 1:
    /// where the taper ends.
    PixelHaze(const HazeFunction& function, double pitch_rad, int support_px);

    /// Distances at which the taper begins and beyond which there is no haze, px.
    double taperFrom_px() const { return taperFrom_px_; }
    int support_px() const { return support_px_; }
    /// Sum over all pixels; energy() + cut() is that of the function.
    double energy() const { return energy_; }
    /// What the taper leaves out.
    double cut() const { return cut_; }

    /// 0 beyond the support.
    double at(int dx, int dy) const;
    /// Of other values, for caches.
    std::size_t key() const { return key_; }

  private:
    int support_px_;
    double taperFrom_px_, energy_ = 0.0, cut_ = 0.0;
    std::vector<double> quadrant_; ///< [dy][dx], from 0 to the support
    std::size_t key_ = 0;
};

} // namespace irsg

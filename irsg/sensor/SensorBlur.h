#pragma once

#include <cstddef>
#include <vector>

#include "irsg/sensor/FourierTransform.h"
#include "irsg/sensor/PointSpread.h"

namespace irsg {

/// The blur of frames of one size, with the transforms of what it folds them with: made once, used
/// for every frame. It is for radiance with `samples` x `samples` cells a pixel.
class SensorBlur {
  public:
    /// All at least 1.
    SensorBlur(const PointSpread& spread, std::size_t width_px, std::size_t height_px, int samples);

    int samples() const { return samples_; }

    /// The mean radiance over each pixel's active area, row by row. `radiance` has the cells row by
    /// row (LogicError for another number); beyond the frame its outermost values go on. The
    /// difference to the frame's level is transformed in single precision, so that an even frame is
    /// right to 1e-9, any other to 1e-6 of the greatest difference.
    std::vector<double> blurred(const std::vector<float>& radiance) const;

  private:
    /// Adds the cells at one place within the pixels, less `level`.
    void add(const std::vector<float>& radiance, std::size_t column, std::size_t row, double level,
             HalfSpectrumOf<float>& sum) const;

    std::size_t width_, height_, wide_, high_, cells_;
    int samples_;
    double whole_; ///< what is left of an even frame, all places together
    /// Of the places in the upper left quarter of a pixel; the others are mirrored.
    std::vector<HalfSpectrumOf<float>> kernels_;
};

} // namespace irsg

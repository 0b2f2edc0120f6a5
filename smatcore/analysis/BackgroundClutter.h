#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "irsg/sensor/SensorDescription.h"
#include "smatcore/analysis/PlacedCase.h"

namespace irsg {
class SensorChain;
}

namespace smat {

/// A standard deviation of pixels.
struct PixelDeviation {
    double deviation = 0.0;
    double error = 0.0; ///< at two standard deviations, from how 64 blocks of the picture differ
};

/// The standard deviation of a picture from pixel to pixel, as a filter for points sees it: of each
/// pixel less the mean of its eight neighbours, times sqrt(8/9), so that noise that is independent
/// from pixel to pixel keeps its own. What is even or changes evenly is no clutter. Row by row,
/// `width` pixels each; pixels nearer than `margin` >= 1 to an edge do not count. 0 where fewer
/// than two pixels count.
PixelDeviation pixelDeviation(const std::vector<double>& values, std::size_t width,
                              std::size_t margin = 1);

/// The clutter of a background, as an apparent radiance.
struct MeasuredClutter {
    double deviation_W_m2_sr = 0.0;
    double error_W_m2_sr = 0.0;      ///< of the deviation, as that of PixelDeviation
    double background_W_m2_sr = 0.0; ///< the mean of the pixels
};

/// The clutter of what is behind a target, at the range of each case: the square of 128 x 128
/// pixels about the target is rendered without any object, with 4 x 4 samples a pixel, and blurred
/// as the sensor does, without noise. It may reach beyond the sensor's frame; pixels as near to its
/// edges as the point spread reaches do not count. Cases whose background is the same share it:
/// those of one elevation, unless skybox, terrain, the sun's disc or the atmosphere depend on the
/// azimuth.
class BackgroundClutter {
  public:
    /// The door must outlive it.
    BackgroundClutter(const RenderDoor& door, irsg::SensorDescription sensor);
    ~BackgroundClutter();

    /// Throws InputError where the point spread is wider than the square.
    MeasuredClutter of(const PlacedCase& placed);

  private:
    struct Square;
    std::vector<double> keyOf(const PlacedCase& placed) const;
    MeasuredClutter measure(const PlacedCase& placed);

    const RenderDoor& door_;
    irsg::SensorDescription sensor_;
    std::size_t margin_px_;
    std::unique_ptr<Square> square_; ///< none where the point spread is wider
    std::map<std::vector<double>, MeasuredClutter> known_;
};

} // namespace smat

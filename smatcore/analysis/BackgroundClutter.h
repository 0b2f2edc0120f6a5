#pragma once

#include <cstddef>
#include <vector>

#include "irsg/sensor/SensorDescription.h"
#include "smatcore/analysis/PlacedCase.h"

namespace smat {

/// The standard deviation of a picture's background from pixel to pixel, as a filter for points
/// sees it: of each pixel less the mean of its eight neighbours, times sqrt(8/9), so that noise
/// that is independent from pixel to pixel keeps its own. Only pixels count that are background
/// with all of their neighbours; what is even or changes evenly is no clutter. Row by row, `width`
/// pixels each. 0 where fewer than two pixels count.
double pixelDeviation(const std::vector<double>& values, const std::vector<bool>& isBackground,
                      std::size_t width);

/// The clutter of a background.
struct MeasuredClutter {
    double deviation_W_m2_sr = 0.0;  ///< as an apparent radiance
    double background_W_m2_sr = 0.0; ///< the mean of the pixels
};

/// That of the pixels beside the target: the piece of at most 256 x 256 pixels about the middle of
/// the sensor's frame is drawn with 2 x 2 samples a pixel and blurred as the sensor does, without
/// noise. Pixels of objects, and those as near to them as the point spread reaches, do not count.
/// Throws InputError where no pixel is left.
MeasuredClutter backgroundClutter(const PlacedCase& placed, const RenderDoor& door,
                                  const irsg::SensorDescription& sensor);

} // namespace smat

#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>

#include "irsg/sensor/DetectionRange.h"
#include "irsg/sensor/SensorDescription.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisGenerator.h"

namespace smat {

/// Where in a pixel the image of the target lies.
enum class PointPlace {
    centre, ///< in the middle: the most ensquared energy
    mean,   ///< anywhere: its mean over a pixel
    corner  ///< where four pixels meet: the least
};

/// How far a sensor sees the target over aspect: an analysis of the cases of a polar plot, in which
/// the range of each is sought.
struct DetectionRequest {
    irsg::SensorDescription sensor;
    double threshold = 5.0; ///< signal to noise ratio, > 0
    irsg::RangeLimits limits{.nearest_m = 100.0, .farthest_m = 1e6, .looksPerDecade = 4};
    PointPlace place = PointPlace::centre;
    /// Of the noise; none: that of the scene behind the target, at each range.
    std::optional<double> background_K;
};

/// Fills the table of `data`, whose kind is polar and whose settings place its cases. The signal is
/// the contrast irradiance of all objects in the sensor's band, through the air at each range,
/// times the ensquared energy; the noise is all of the sensor's, pattern included. Columns: where
/// the case is, `detection_range` with its error at two standard deviations (that of the contrast,
/// and of where the root lies), `outcome` (0 found, -1 below the threshold everywhere: range 0, 1
/// above it at the farthest range, which is given), `crossings`, then at that range `snr`,
/// `contrast_irradiance`, `contrast_intensity`, `nei` with the total noise and ensquared energy,
/// and `extent`, the side of the target's image in pixels, whose smallness the method asks for.
/// Ranges that the scene refuses (a path into the ground) count as those without a signal, with a
/// warning; the nearest must not be one. A stop keeps the cases that are done. Throws InputError.
void runDetection(AnalysisData& data, const DetectionRequest& request, const RenderDoor& door,
                  const SceneFactory& scenes, const RunControl& control = {});

} // namespace smat

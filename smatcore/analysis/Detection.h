#pragma once

#include <string>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/DetectionRequest.h"

namespace smat {

/// The command that does the same from a terminal, for a project with these settings in effect.
std::string detectionCommand(const Project& project, const Settings& settings,
                             const DetectionRequest& request, const std::string& outputFile);

/// Fills the table of `data`, whose settings place its cases as those of a polar plot or a
/// signature table do (request.cases). The signal is the contrast irradiance of all objects in the
/// sensor's band, through the air at each range, times the ensquared energy; the noise is all of
/// the sensor's, pattern included. Of bars the mean contrast radiance over the target's solid angle
/// becomes a temperature difference of the background, whose resolved frequency times the root of
/// that solid angle is the number of cycles (ResolvableTemperature, TargetingTask). Columns: where
/// the case is, `detection_range` with its error at two standard deviations (that of the contrast,
/// and of where the root lies), `outcome` (0 found, -1 below the threshold everywhere: range 0, 1
/// above it at the farthest range, which is given), `crossings`, then at that range `snr`,
/// `contrast_irradiance`, `contrast_intensity`, `nei` with the total noise and ensquared energy,
/// and `extent`, the side of the target's image in pixels, whose smallness the ratio of a point
/// asks for; of cycles `temperature_difference`, `cycles` and `probability` as well, of points with
/// a probability this. Where surfaces are left out, contrast and solid angle of cycles and `extent`
/// are those of the others, and `left_out` is their part of the contrast irradiance.
/// With measured clutter (BackgroundClutter) there is a column `clutter` in K with its error, which
/// counts in that of the range, and with sensitivities the relative change of the range per
/// relative change of each number, `sensitivity_NAME` (RangeSensitivity). With ranges the table is
/// that of runDetectionProbability, with a comparison that of runDetectionComparison. Ranges that
/// the scene refuses (a path into the ground) count as those without a signal, with a warning; the
/// nearest must not be one. A stop keeps the cases that are done. Throws InputError.
void runDetection(AnalysisData& data, const DetectionRequest& request, const RenderDoor& door,
                  const SceneFactory& scenes, const RunControl& control = {});

} // namespace smat

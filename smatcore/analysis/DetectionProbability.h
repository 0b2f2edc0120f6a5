#pragma once

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/analysis/DetectionRequest.h"

namespace smat {

/// Fills the table of `data` with the probability over request.ranges_m, of the cases of
/// the request: of points that the signal passes the threshold with its noise, the mean over all
/// places of the image in its pixel; of cycles that of the task (TaskLaw). A row for each range:
/// `range` in m, `probability`, the mean over aspects and draws, `least_probability` and
/// `greatest_probability` of the aspects, each the mean over the draws, and `snr` or `cycles`, the
/// mean. With draws of the scaling files beside the models (sceneScalings, seed `scaling.seed`)
/// also `deviation_probability`, the standard deviation over the draws of the mean over aspects,
/// NaN of one draw.
/// Ranges that the scene refuses have the probability of noise alone, with a warning. A stop keeps
/// the aspects that are done. Throws InputError.
void runDetectionProbability(AnalysisData& data, const DetectionRequest& request,
                             const RenderDoor& door, const SceneFactory& scenes,
                             const RunControl& control);

} // namespace smat

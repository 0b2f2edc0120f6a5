#pragma once

#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/PlacedCase.h"
#include "smatcore/data/SceneDescription.h"

namespace smat {

/// Of an image that is read by a sensor (`image.sensor`): puts columns, rows, field of view and
/// band of its file in the place of those of the settings. Does nothing to other analyses. Throws
/// InputError.
void followSensor(AnalysisData& data);
/// The same of a scene, whose band becomes the sensor's response.
void followSensor(const AnalysisData& data, SceneDescription& scene);

/// Draws `placed` above the pixel grid and reads it by the sensor of the settings: planes `counts`
/// and `L`, the shown one by `image.quantity`, first. Returns what there is to warn of.
std::vector<std::string> drawThroughSensor(irsg::RadianceImage& image, const AnalysisData& data,
                                           const PlacedCase& placed, const RenderDoor& door);

} // namespace smat

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "irsg/sensor/SensorChain.h"
#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/PlacedCase.h"
#include "smatcore/data/SceneDescription.h"

namespace smat {

/// Of an image that is read by a sensor (`image.sensor`): puts columns, rows, field of view and
/// band of its file in the place of those of the settings. Does nothing to other analyses. Throws
/// InputError.
void followSensor(AnalysisData& data);
/// The same of a scene, whose band becomes the sensor's response, with all that drawing through the
/// sensor would refuse.
void followSensor(const AnalysisData& data, SceneDescription& scene);

/// Throws InputError for what was given of an image and does nothing: columns, rows, field of view
/// and band beside a sensor, and how it samples and its seed without one.
void refuseIdleOfSensor(const AnalysisData& data, const Settings& given);

/// Puts columns, rows, field of view and band of a sensor in the place of those of the settings.
void followSensor(const irsg::SensorDescription& sensor, Settings& settings);
/// Of a scene: its band becomes the sensor's response.
void followSensor(const irsg::SensorDescription& sensor, SceneDescription& scene);

/// Throws InputError for more samples along a side of the image than an image may have.
void checkSensorGrid(const irsg::SensorDescription& sensor, const Settings& settings);

/// Whose noise a frame has.
struct FrameNoise {
    std::uint64_t seed = 1;
    std::uint32_t frame = 0;
};

/// Draws `placed`, the view of the sensor's pinhole camera, above the pixel grid and reads it:
/// planes `counts` and `L`, the shown one by `image.quantity`, first. `settings` say how finely it
/// is sampled. Throws InputError.
irsg::SensorReading drawThroughSensor(irsg::RadianceImage& image, const irsg::SensorChain& chain,
                                      const Settings& settings, const PlacedCase& placed,
                                      const RenderDoor& door, const FrameNoise& noise);
/// The same of an image analysis by the sensor of its settings. Returns what there is to warn of.
std::vector<std::string> drawThroughSensor(irsg::RadianceImage& image, const AnalysisData& data,
                                           const PlacedCase& placed, const RenderDoor& door);

} // namespace smat

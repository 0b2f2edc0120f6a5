#pragma once

#include <string>

#include "irsg/image/RadianceImage.h"
#include "irsg/sensor/SensorStages.h"

namespace smat::gui {

/// Four bars of periods of 8, 4 and 2 pixels, each 10 K above a background of 300 K, and a point:
/// a sample of a pixel, 200 K above it. 64 x 48 pixels of 4 x 4 samples.
irsg::StageScene testPattern(const irsg::SensorDescription& sensor);

/// Whether an image has what such a piece needs: radiance, and how wide its field of view is.
bool canBeStageScene(const irsg::RadianceImage& image);
/// The middle of an image of radiance, at most 96 x 72 pixels of the sensor, each sample with the
/// radiance of the image's pixel there, as that of the sensor's band. LogicError for another image.
irsg::StageScene pieceOf(const irsg::RadianceImage& image, const irsg::SensorDescription& sensor);
/// "4 pixels of the image are one of the sensor; its band of 3–5 µm is taken as the sensor's"
std::string wordsOfPiece(const irsg::RadianceImage& image, const irsg::SensorDescription& sensor);

} // namespace smat::gui

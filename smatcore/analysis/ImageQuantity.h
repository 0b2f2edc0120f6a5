#pragma once

#include <cstddef>

#include "irsg/image/RadianceImage.h"
#include "irsg/scene/Sensor.h"

namespace smat {

/// Turns the radiance (channel `L`, W m-2 sr-1) of an image into its irradiance on the detector,
/// E = L omega cos(theta) per pixel (W m-2), omega the pixel's solid angle and theta its angle off
/// the axis. The channel becomes `E`.
void toIrradiance(irsg::RadianceImage& image, const irsg::Sensor& sensor);

/// Turns it into apparent temperature (channel `T`, K): that of the black body of the same radiance
/// in the sensor's band. A radiance <= 0 has no temperature and becomes NaN; their number is
/// returned. Computed through a table over the image's own range, within 1e-4 K of the inverse of
/// Planck's integral.
std::size_t toApparentTemperature(irsg::RadianceImage& image, const irsg::Sensor& sensor);

} // namespace smat

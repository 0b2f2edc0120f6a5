#pragma once

#include <cstddef>

#include "irsg/geometry/view/Sensor.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// Puts the irradiance of each pixel on the detector in front of an image of radiance (channel `L`,
/// W m-2 sr-1): E = L omega cos(theta) (channel `E`, W m-2), omega the pixel's solid angle and
/// theta its angle off the axis. The radiance stays, behind it.
void showIrradiance(RadianceImage& image, const Sensor& sensor);

/// Puts the apparent temperature (channel `T_apparent`, K) in front: that of the black body of the
/// same radiance in the sensor's band. A radiance <= 0 has none and becomes NaN; returns how many.
std::size_t showApparentTemperature(RadianceImage& image, const Sensor& sensor);

} // namespace irsg

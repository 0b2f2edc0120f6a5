#pragma once

#include <vector>

#include "irsg/scene/sampling/Samples.h"

namespace irsg {

/// Brings the listed fragments into the order of the samples, those of each from front to back. At
/// most `maximumLayers` of a sample count: the farthest are left out, and the sample is counted.
/// Depth is reversed, so near is large; fragments of equal depth are taken in the order of their
/// values, so that the result does not depend on the order of drawing. Runs on all cores; the
/// result does not depend on their number. `room`: memory to work in, kept from call to call.
void sortLayers(FactorSamples& samples, int maximumLayers, std::vector<float>& room);

} // namespace irsg

#pragma once

#include <string>

namespace irsg::bench {

/// Stated and true errors of intensity and contrast intensity of the samples with a model: two
/// bands, four elevations of the camera and three ranges, `aspects` azimuths each, with the
/// settings of their projects. Every third of these combinations is told apart: estimators are not
/// tuned to it. `only`: the name of one sample, or empty.
///
/// The truth has tiles of 2048 samples over a frame that the object fills, bins of 1 cm-1, thin
/// slices, 65 rows of background behind it, and a tenth of the error of inter-reflection.
void judgeSamples(int aspects, const std::string& only);

} // namespace irsg::bench

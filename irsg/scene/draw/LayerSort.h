#pragma once

#include <cstdint>
#include <vector>

#include "irsg/scene/sampling/Samples.h"

namespace irsg {

/// What was read back of one drawing of factors, as surface.frag.glsl writes it.
struct DrawnLayers {
    int width = 0, height = 0;   ///< samples
    std::size_t factorCount = 0; ///< of a layer
    /// Listed fragments of transparent surfaces: (sample, depth, row + 1, distance) and the
    /// factors, padded to whole vectors of four words.
    std::vector<std::uint32_t> words;
    std::size_t wordsPerFragment = 8; ///< 8 for up to four factors
    /// (row + 1, first three factors) of the opaque surface of each sample, row + 1 = 0 for none.
    std::vector<float> opaque;
    std::vector<float> moreFactors; ///< the next four of each sample, or empty
    std::vector<float> distances_m; ///< of each sample, or empty
};

/// The layers of each sample from front to back, the opaque one last, at most `maximumLayers`
/// transparent ones (the farthest are left out, and the sample is counted). Depth is reversed, so
/// near is large; fragments of equal depth are taken in the order of their values, so that the
/// result does not depend on the order of drawing. Runs on all cores; the result does not depend on
/// their number.
void gatherLayers(const DrawnLayers& drawn, int maximumLayers, FactorSamples& samples);

} // namespace irsg

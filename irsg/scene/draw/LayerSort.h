#pragma once

#include <cstdint>
#include <vector>

#include "irsg/scene/sampling/SampleWindow.h"
#include "irsg/scene/sampling/Samples.h"

namespace irsg {

/// Sorts the listed fragments of transparent surfaces by sample and from near to far and puts them
/// before the opaque surfaces: planes (radiance, opacity interleaved) become premultiplied sums of
/// all layers, out = A_1 + t_1 (A_2 + t_2 (...)). `words`: (sample, depth, A_pre, opacity) as
/// surface.frag.glsl writes them; reversed depth, so near is large. Fragments of equal depth are
/// taken in the order of their values, so that the result does not depend on the order of drawing.
/// Returns the number of samples with more than `maximumLayers`, whose farthest layers are left
/// out.
int layUnderTransparent(const std::vector<std::uint32_t>& words, int maximumLayers,
                        std::vector<float>& planes);

/// The layers of each sample from front to back, opaque last. `words`: (sample, depth, row + 1,
/// distance) and (thermal, down, sun, 0) of each fragment; `opaque`: (row + 1, thermal, down, sun)
/// of each sample, row + 1 = 0 for none; `opaqueDistance_m` may be empty. What a surface does not
/// see of the sky it sees of the ground, unless fluxes are off.
void gatherFactorLayers(const std::vector<std::uint32_t>& words, const std::vector<float>& opaque,
                        const std::vector<float>& opaqueDistance_m, bool fluxes, int maximumLayers,
                        FactorSamples& samples);

} // namespace irsg

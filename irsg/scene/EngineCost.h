#pragma once

#include <cstddef>
#include <string>

#include "irsg/render/values/RenderSettings.h"

namespace irsg {

/// What there is to do for the samples of a scene, as far as it tells OpenGL that a processor draws
/// from rays.
struct EngineWork {
    double facets = 0.0;  ///< of all objects
    double samples = 0.0; ///< of all windows that are drawn
    double covered = 0.0; ///< of them, those that lie in the circles about objects
    /// Transparent surfaces that such a sample meets, as a mean.
    double layers = 0.0;
};

/// Processor time of a frame, ms, of one core of the machine on which it was measured: what counts
/// is which of the two is less. What shadows and lobes take beside that is the same for both.
/// docs/accuracy-sampling.md has what was measured.
double openGlCost_ms(const EngineWork& work);
double raysCost_ms(const EngineWork& work);

/// The quicker of the two.
EngineChoice quickerEngine(const EngineWork& work);
/// "1540 facets, 65536 samples, 0.7 layers before one and no graphics card: about 2.9 ms by OpenGL,
/// 9.5 by rays".
std::string wordsOf(const EngineWork& work);

} // namespace irsg

#pragma once

#include <cstdint>
#include <vector>

namespace irsg {

/// A surface at one sample as its geometric factors.
struct FactorLayer {
    int row = 0;
    float thermal = 0.0f, up = 0.0f, down = 0.0f, sun = 0.0f;
    float distance_m = 0.0f; ///< of opaque surfaces only where it was asked for
};

/// One window of samples, bottom row first.
struct RadianceSamples {
    int width = 0, height = 0;
    std::vector<float> planes; ///< premultiplied radiance and opacity, interleaved
    int layersLeftOver = 0;    ///< samples with more layers than the scene allows
};
struct FactorSamples {
    int width = 0, height = 0;
    /// Layers of sample i, front to back and the opaque one last: from first[i] to before first[i +
    /// 1].
    std::vector<std::uint32_t> first;
    std::vector<FactorLayer> layers;
    int layersLeftOver = 0;
};

} // namespace irsg

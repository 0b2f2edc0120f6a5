#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace irsg {

/// One window of samples, bottom row first.
struct RadianceSamples {
    int width = 0, height = 0;
    std::vector<float> planes; ///< premultiplied radiance and opacity, interleaved
    int layersLeftOver = 0;    ///< samples with more layers than the scene allows
};

/// One window of samples, bottom row first, each with the surfaces that it meets and what geometry
/// makes of them: factors, which know no wavelength.
struct FactorSamples {
    int width = 0, height = 0;
    std::size_t factorCount = 0; ///< drawn factors of a layer
    /// Layers of sample i, front to back and the opaque one last: from first[i] to before first[i +
    /// 1].
    std::vector<std::uint32_t> first;
    std::vector<std::int32_t> rows; ///< by layer: of the drawing
    std::vector<float> factors;     ///< by layer, `factorCount` each
    /// By layer, m; of opaque surfaces only where it was asked for, else 0.
    std::vector<float> distances_m;
    int layersLeftOver = 0;

    std::span<const float> factorsOf(std::uint32_t layer) const {
        return {&factors[layer * factorCount], factorCount};
    }
};

} // namespace irsg

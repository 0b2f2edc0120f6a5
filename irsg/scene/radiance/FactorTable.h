#pragma once

#include <map>
#include <utility>
#include <vector>

#include "irsg/scene/RenderReport.h"
#include "irsg/scene/radiance/ProjectedFactors.h"
#include "irsg/scene/radiance/SceneRadiometry.h"
#include "irsg/scene/sampling/SampleWindow.h"
#include "irsg/scene/sampling/Samples.h"
#include "irsg/scene/view/FrameBackground.h"
#include "irsg/scene/view/PixelGrid.h"

namespace irsg {

/// Sums factors, sample by sample from front to back, into ProjectedFactors.
class FactorAccumulator {
  public:
    /// The rows of the drawing are the surfaces of `radiometry`. `background` must live as long.
    FactorAccumulator(const Sensor& sensor, const FrameBackground& background,
                      const SceneRadiometry& radiometry);

    void add(const SampleWindow& window, const FactorSamples& samples);

    ProjectedFactors take() const;

  private:
    FactorSums& sumsOf(int prefix, int row);
    int extended(int prefix, int row);

    PixelGrid grid_;
    const FrameBackground& background_;
    std::vector<SceneRadiometry::SurfaceKey> keys_;
    std::vector<bool> transparent_;

    using Prefix = std::vector<std::pair<int, int>>; // sorted (entity, material)
    std::vector<Prefix> prefixes_{Prefix{}};
    std::map<Prefix, int> prefixIds_{{Prefix{}, 0}};
    std::map<std::pair<int, int>, int> extensions_; // (prefix, row) -> prefix
    int layersLeftOver_ = 0;
    std::vector<std::vector<FactorSums>> sums_; // [prefix][row]
};

/// Radiometry of every object at its own range, and the sum of all, from projected factors: exact
/// in the products of spectral transmissivities. Ranges are filled in from `geometry`. What objects
/// hide of a background that varies over the frame is the sum over their own pixels.
void evaluateFactors(const ProjectedFactors& factors, const SceneRadiometry& radiometry,
                     const FrameBackground& background, const std::vector<ObjectGeometry>& geometry,
                     const std::vector<Entity>& entities, RenderReport& report);

/// The same per wavelength.
IntensitySpectrum evaluateSpectrum(const ProjectedFactors& factors,
                                   const SceneRadiometry& radiometry,
                                   const std::vector<ObjectGeometry>& geometry,
                                   const std::vector<Entity>& entities);

} // namespace irsg

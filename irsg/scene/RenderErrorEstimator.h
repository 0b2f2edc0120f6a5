#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "irsg/radiance/CoarseSpectralErrorEstimate.h"
#include "irsg/radiance/Reductions.h"
#include "irsg/scene/Frame.h"
#include "irsg/scene/SceneEvaluator.h"

namespace irsg {

/// By output the errors of each entity, then those of all together.
using ErrorsByOutput = std::vector<std::vector<RadiometryErrors>>;

/// Says how wrong the sums of a view may be, for their samples, their atmosphere, what is behind
/// the objects and the light between them. Keeps the same atmospheres in other spectral bins, and
/// scenes in them.
class RenderErrorEstimator {
  public:
    /// All must live as long; `occluderStacks` may grow.
    RenderErrorEstimator(const RadianceTerms& terms, SceneEvaluator& evaluator,
                         const OccluderStacks& occluderStacks)
        : terms_(terms), evaluator_(evaluator), occluderStacks_(occluderStacks) {}

    /// Of sums in the bands of a frame, whose evaluated scene is turned to it.
    ErrorsByOutput ofBands(const Frame& frame, const ViewGeometry& factors,
                           const std::vector<ObjectSums>& sums);
    /// Of sums at ascending wavelengths. `light`: between surfaces, or null.
    ErrorsByOutput ofSpectrum(const Frame& frame, const ViewGeometry& factors,
                              const EvaluatedSpectrum& evaluated, SceneLight* light,
                              const std::vector<double>& wavelengths_um,
                              const std::vector<ObjectSums>& sums);

  private:
    void addOfAtmosphere(const Frame& frame, const ViewGeometry& factors,
                         const std::vector<ObjectSums>& sums, ErrorsByOutput& errors);
    void addOfBackground(const Frame& frame, const std::vector<ObjectSums>& sums,
                         ErrorsByOutput& errors);
    /// Sums as they are in another atmosphere, or in the same one along other paths.
    std::vector<ObjectSums> sumsElsewhere(const Frame& frame, const ViewGeometry& factors,
                                          const std::vector<ObjectGeometry>& geometry);
    const RadianceTerms& terms_;
    SceneEvaluator& evaluator_;
    const OccluderStacks& occluderStacks_;
    CoarseSpectralErrorEstimate other_;
};

} // namespace irsg

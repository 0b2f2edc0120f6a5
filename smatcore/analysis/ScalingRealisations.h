#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "irsg/signature/random/SobolSequence.h"
#include "smatcore/project/SceneScalings.h"

namespace smat {

/// How the draws of a Monte Carlo analysis are spread.
enum class RealisationSequence {
    plain, ///< independent; adding a scale changes no draw of another
    sobol  ///< Sobol' points in independent scramblings that take turns
};
/// "plain", "sobol".
const char* name(RealisationSequence sequence);

/// Scramblings that the draws of a Sobol' sequence are dealt to: enough to know their spread, few
/// enough to leave each many points.
inline constexpr std::size_t sobolReplicates = 16;

/// The draws of a set of scales. Draw 0 of the plain sequence is what loading the database with the
/// same seed gives.
class ScalingRealisations {
  public:
    /// `companions` gives every draw a second, independent one, as Sobol' indices need it. Throws
    /// InputError where a Sobol' sequence would need more than its 128 dimensions.
    ScalingRealisations(std::vector<SceneScaling> scalings, RealisationSequence sequence,
                        std::uint64_t seed, bool companions = false);

    const std::vector<SceneScaling>& scalings() const { return scalings_; }
    /// One scale each.
    std::vector<double> at(std::size_t draw) const { return valuesOf(draw, false); }
    std::vector<double> companionAt(std::size_t draw) const { return valuesOf(draw, true); }
    /// Draws of different replicates are independent; in plain sequences every draw is.
    std::size_t replicateOf(std::size_t draw) const { return draw % sobolReplicates; }

  private:
    std::vector<double> valuesOf(std::size_t draw, bool companion) const;

    std::vector<SceneScaling> scalings_;
    std::vector<int> dimensions_; ///< of each scale, -1 for a fixed one
    RealisationSequence sequence_;
    std::uint64_t seed_;
    int free_ = 0; ///< scales that vary
    std::vector<irsg::SobolSequence> replicates_;
};

} // namespace smat

#pragma once

#include <vector>

#include "irsg/geometry/view/FrameBackground.h"
#include "irsg/radiance/AtmosphericQueryCache.h"
#include "irsg/radiance/Reductions.h"
#include "irsg/radiance/SceneSampling.h"
#include "irsg/scene/FrameRequest.h"

namespace irsg {

/// What is behind the objects of a frame, where each has a background of its own.
struct BackgroundBehind {
    /// Spectral radiance behind the object that the frame looks at, by node of its bands; null
    /// where the background is not that of the objects' own directions.
    SharedValues background;
    std::size_t lookedAt = 0; ///< the number of that object
    // By entity and output, W m-2 sr-1.
    std::vector<std::vector<double>> radiance, error;
    /// By entity, line of sight and output: what is seen along it.
    std::vector<std::vector<std::vector<double>>> along;

    /// Gives each object its own background, of sums that have another one: by output, what all of
    /// them take. Of one that varies over the frame the object that is looked at keeps what its
    /// pixels have.
    void takeOwn(const FrameRequest& request, const std::vector<ObjectGeometry>& geometry,
                 const std::vector<FrameBackground>& taken, std::vector<ObjectSums>& sums) const;
};

/// What a background has behind an object, as its lines of sight count; of one that varies over the
/// frame in the pixels of these.
double usedBehind(const FrameRequest& request, const ObjectGeometry& object,
                  const FrameBackground& background);

/// True where objects have backgrounds of their own directions: with automatic rows of the
/// environment's background, and no picture behind.
bool hasBackgroundBehind(const Scene& scene);

/// Chooses the lines of sight behind each entity (`geometry.behind`), and sums what is seen along
/// them. Throws InputError where no atmosphere answers.
BackgroundBehind backgroundBehind(AtmosphericQueryCache& answers, const FrameRequest& request,
                                  const std::vector<SampledBand>& bands,
                                  std::vector<ObjectGeometry>& geometry);

/// The same sums along lines of sight that were chosen, in other bands or wavelengths. Errors are
/// those of overlapping parts.
BackgroundBehind backgroundAlong(AtmosphericQueryCache& answers, const FrameRequest& request,
                                 const std::vector<SampledBand>& bands,
                                 const std::vector<ObjectGeometry>& geometry);

} // namespace irsg

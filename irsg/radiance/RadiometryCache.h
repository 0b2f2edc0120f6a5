#pragma once

#include <memory>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/EntityKey.h"
#include "irsg/radiance/PlanckTable.h"
#include "irsg/radiance/SampledScene.h"
#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/radiance/SurfaceRadianceTable.h"
#include "irsg/radiance/exchange/SceneLight.h"

namespace irsg {

/// A scene's spectra with what was evaluated of them.
struct EvaluatedScene {
    EvaluatedScene(const RadianceTerms& terms, const std::vector<Entity>& entities,
                   const std::vector<ObjectGeometry>& geometry,
                   const std::vector<SampledBand>& bands, const OccluderStacks& occluderStacks);
    EvaluatedScene(const RadianceTerms& terms, const std::vector<Entity>& entities,
                   const std::vector<ObjectGeometry>& geometry,
                   const std::shared_ptr<const SampledScene>& sampled,
                   const OccluderStacks& occluderStacks);

    /// Makes it that of other aspects.
    void turnTo(const std::vector<Entity>& entities, const std::vector<ObjectGeometry>& geometry);
    /// Makes it that of a sampled scene which is alike but for path radiance.
    void seeAlong(const std::shared_ptr<const SampledScene>& sampled);
    /// The one that it is of; null where it was made of bands alone.
    const std::shared_ptr<const SampledScene>& along() const { return along_; }

    SceneRadiometry radiometry;
    SurfaceRadianceTable radiances;
    PlanckTable planck; ///< of scaled views
    /// Between the surfaces of this scene, as the renderer set it; null for none.
    std::shared_ptr<SceneLight> light;

  private:
    std::vector<double> aspects_rad_; // by entity
    std::shared_ptr<const SampledScene> along_;
};

/// Evaluated scenes by all that their spectra depend on: samplings, air, databases, states, scales.
/// Cases of a sweep that differ in geometry alone share one; where factors of measured spectra
/// depend on the aspect, or path radiance on the azimuth from the sun, these become others, so that
/// whoever asked for a scene before turns it back.
class RadiometryCache {
  public:
    /// `geometry` has the slices of `sampled`.
    std::shared_ptr<EvaluatedScene> of(const RadianceTerms& terms,
                                       const std::vector<Entity>& entities,
                                       const std::vector<ObjectGeometry>& geometry,
                                       const std::shared_ptr<const SampledScene>& sampled,
                                       const OccluderStacks& occluderStacks);

  private:
    struct CacheEntry {
        std::vector<EntityKey> entities;
        std::vector<double> altitudes_m;
        std::shared_ptr<EvaluatedScene> scene; // by what it is seen along, too
    };
    /// Of each state of the entities two: a table goes through its states at each aspect.
    static constexpr std::size_t mostCached = 16, mostOfState = 2;

    /// Lets go of scenes of other models or databases than the latest, and of old ones of its
    /// state.
    void forget();

    RecentlyUsed<CacheEntry> cache_{mostCached};
};

} // namespace irsg

#pragma once

#include <memory>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/LobeQuadratureTables.h"
#include "irsg/render/background/TerrainRays.h"
#include "irsg/scene/FrameRequest.h"
#include "irsg/scene/InterReflection.h"
#include "irsg/scene/PreparedEntities.h"
#include "irsg/scene/SceneEvaluation.h"
#include "irsg/scene/StageClock.h"
#include "irsg/scene/SurfaceShading.h"

namespace irsg {

/// Finds what shades the surfaces of a frame: what stands before the sun, what they reflect of each
/// other, and the lobes of directional ones. Caches hold the facets that the sun is known to reach,
/// tables of lobes, and what is small and bright.
class SurfaceShader {
  public:
    /// All must live as long.
    SurfaceShader(const RadianceTerms& terms, PreparedEntities& prepared, TerrainRays& terrainRays,
                  InterReflection& interReflection, StageClock& clock)
        : terms_(terms),
          prepared_(prepared),
          terrainRays_(terrainRays),
          interReflection_(interReflection),
          clock_(clock) {}

    /// The evaluation must live as long as what comes out. What a build without rays leaves out is
    /// a warning.
    SurfaceShading shade(const FrameRequest& request, const SceneEvaluation& evaluation);

  private:
    /// What stands in the way of light, entity by entity, and the terrain.
    std::vector<SunShadows::Caster> casters(const Scene& scene, const SceneEvaluation& evaluation);
    /// What is known without rays, for the directions of factors.
    std::vector<SunShadows::Sunlit> sunlitOf(const Scene& scene, const std::vector<int>& shadowed,
                                             const SunShadows& shadows);
    std::shared_ptr<const LobeQuadrature> lobesOf(const RenderSettings& settings,
                                                  const SceneEvaluation& evaluation) const;

    /// Which samples may stand for each other: not where gas is, nor of mirrors.
    JoinLimits joinsOf(const SceneEvaluation& evaluation) const;
    /// Null where nothing is bright.
    std::shared_ptr<const LobeAims> aimsOf(const FrameRequest& request,
                                           const SceneEvaluation& evaluation,
                                           const std::shared_ptr<const LightExchange>& exchange);

    struct KnownAims {
        std::shared_ptr<const LightExchange> exchange;
        std::vector<bool> bright; ///< by drawn row
        std::shared_ptr<const LobeAims> aims;
    };

    const RadianceTerms& terms_;
    PreparedEntities& prepared_;
    TerrainRays& terrainRays_;
    InterReflection& interReflection_;
    StageClock& clock_;
    RecentlyUsed<std::shared_ptr<const SunlitFacets>> sunlitFacets_{8};
    RecentlyUsed<KnownAims> aims_{2};
    std::shared_ptr<LobeQuadratureTables> lobeTables_ = std::make_shared<LobeQuadratureTables>();
};

} // namespace irsg

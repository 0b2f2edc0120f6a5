#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/render/rays/SunShadows.h"
#include "irsg/scene/InterReflected.h"
#include "irsg/scene/PreparedEntities.h"
#include "irsg/scene/Scene.h"
#include "irsg/scene/SceneEvaluation.h"
#include "irsg/scene/StageClock.h"

namespace irsg {

/// Finds what surfaces send each other. Caches hold the exchange of scenes by all that it depends
/// on, and solutions of the balance.
class InterReflection {
  public:
    /// All must live as long; `occluderStacks` may grow.
    InterReflection(PreparedEntities& prepared, const OccluderStacks& occluderStacks,
                    StageClock& clock)
        : prepared_(prepared), occluderStacks_(occluderStacks), clock_(clock) {}

    static bool isAskedFor(const RenderSettings& settings);
    /// `casters`: what stands in the way of light, entity by entity. The light is kept with the
    /// evaluated scene, which turns it to other aspects.
    InterReflected of(const Scene& scene, const SceneEvaluation& evaluation,
                      const std::vector<SunShadows::Caster>& casters);
    /// The light of a known exchange in the outputs of a radiometry, which must live as long; null
    /// for no exchange.
    std::shared_ptr<SceneLight> lightOf(const std::shared_ptr<const LightExchange>& exchange,
                                        const SceneRadiometry& radiometry,
                                        const RenderSettings& settings);

  private:
    /// An exchange, and all that it depends on.
    struct Known {
        std::vector<double> numbers;
        std::vector<std::shared_ptr<const BodyLight>> bodies;
        std::shared_ptr<const Terrain> terrain;
        std::optional<Spectrum> ground;
        std::vector<SurfaceKey> keys;
        bool hasLobes = false;
        std::vector<std::size_t> components;
        std::shared_ptr<const LightExchange> exchange;

        /// Whether all but the exchange is equal.
        bool isAs(const Known& other) const;
    };
    /// Of bodies that do not matter to each other: those that have not turned are known.
    std::shared_ptr<const LightExchange> ofEachAlone(const std::vector<LightExchange::Body>& bodies,
                                                     const std::vector<SunShadows::Caster>& casters,
                                                     const LightSources& sources,
                                                     const Scene& scene, const Known& key);
    LightExchange::Extent extentOf(const Entity& entity, const SunShadows::Caster& caster,
                                   const SceneRadiometry& radiometry, bool isAlone);
    std::shared_ptr<const LightExchange> exchangeOf(const Scene& scene,
                                                    const SceneEvaluation& evaluation,
                                                    const std::vector<SunShadows::Caster>& casters);

    PreparedEntities& prepared_;
    const OccluderStacks& occluderStacks_;
    StageClock& clock_;
    RecentlyUsed<Known> exchanges_{4}, ofBodies_{16};
    LightSolutions solutions_;
};

/// Says of which bodies the view factors are not known as well as was asked.
void warnOfExchange(const LightExchange& exchange, const Scene& scene,
                    std::vector<std::string>& warnings);

} // namespace irsg

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "irsg/core/RecentlyUsed.h"
#include "irsg/radiance/EntityKey.h"
#include "irsg/radiance/SpectraBeforeAir.h"
#include "irsg/scene/AspectSampler.h"
#include "irsg/scene/Frame.h"
#include "irsg/scene/FramePlanner.h"
#include "irsg/scene/SceneEvaluator.h"

namespace irsg {

/// Frames of one object that is sampled once for its line of sight
/// (Outputs::Reports::alongRangeFrom): what it sends is kept as spectra before the atmosphere, so
/// that a frame of another range needs neither radiometry of surfaces nor inter-reflection. Other
/// frames are sampled: with several objects, before terrain or a varying background, of several
/// bands, of single surfaces, with errors, nearer than RangeGeometry::closest, partly behind the
/// horizon, of surfaces with measured spectra.
class AspectSpectra {
  public:
    /// All must live as long.
    AspectSpectra(const RadianceTerms& terms, PreparedEntities& prepared, FramePlanner& planner,
                  SceneEvaluator& evaluator, AspectSampler& sampler,
                  const OccluderStacks& occluderStacks)
        : terms_(terms),
          prepared_(prepared),
          planner_(planner),
          evaluator_(evaluator),
          sampler_(sampler),
          occluderStacks_(occluderStacks) {}

    /// A frame whose object was sampled for another range; nothing where that does not hold here.
    std::optional<Frame> frame(const FrameRequest& request,
                               const std::vector<ObjectGeometry>& geometry,
                               const FrameEngine& engine);
    /// Gives a frame its spectra, where it may have some, and keeps them.
    void addTo(Frame& frame);

  private:
    /// All that they depend on beside the atmosphere.
    struct Key {
        EntityKey entity;
        std::vector<EntityState> otherStates;
        Pose pose;
        std::vector<double> numbers; ///< line of sight, reference point, range of sampling
        RenderSettings settings;
        AtmosphereIdentity atmospheres;
        SunPosition sun;
        std::vector<Band> bands;
        bool operator==(const Key&) const = default;
    };
    struct Known {
        Key key;
        SceneEvaluation evaluation;
        SurfaceShading shading;
        std::shared_ptr<const SpectraBeforeAir> spectra;
    };
    static bool mayHave(const FrameRequest& request);
    Key keyOf(const FrameRequest& request);

    const RadianceTerms& terms_;
    PreparedEntities& prepared_;
    FramePlanner& planner_;
    SceneEvaluator& evaluator_;
    AspectSampler& sampler_;
    const OccluderStacks& occluderStacks_;
    RecentlyUsed<Known> known_{2};
};

} // namespace irsg

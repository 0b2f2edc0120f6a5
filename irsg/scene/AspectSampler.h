#pragma once

#include <cstddef>
#include <memory>

#include "irsg/radiance/PointSources.h"
#include "irsg/radiance/RangeGeometry.h"
#include "irsg/radiance/ViewGeometry.h"
#include "irsg/scene/Frame.h"
#include "irsg/scene/FramePlanner.h"
#include "irsg/scene/PreparedEntities.h"
#include "irsg/scene/StageClock.h"
#include "irsg/scene/SurfaceSampler.h"

namespace irsg {

/// Samples objects alone for an aspect, which serves at many distances. Keeps point sources and the
/// factors at the nodes of ranges by the aspects that they are of.
class AspectSampler {
  public:
    /// All must live as long.
    AspectSampler(const RadianceTerms& terms, PreparedEntities& prepared, FramePlanner& planner,
                  SurfaceSampler& sampler, OccluderStacks& occluderStacks, StageClock& clock)
        : terms_(terms),
          prepared_(prepared),
          planner_(planner),
          sampler_(sampler),
          occluderStacks_(occluderStacks),
          clock_(clock) {}

    /// Factors of a point source of the plan at unit distance; valid until the next call.
    const PointGeometry& pointGeometry(const Frame& frame, const ObjectExtent& object);
    static PointPlace placeOf(const Frame& frame, const ObjectExtent& object);
    /// Adds an object along the range of the plan to a view.
    void addAlongRange(const Frame& frame, const ObjectExtent& object, ViewGeometry& view);

  private:
    /// An entity as it is seen from a direction in its model's axes.
    PointAspect aspectOf(const Frame& frame, int entity, const Vec3& from) const;
    /// Forgets what was sampled in the shadow of another terrain, which aspects do not name.
    void forgetOtherTerrain(const Frame& frame);
    /// Factors of one entity as a camera of its own sees it, with nothing before it.
    ViewGeometry sampleAlone(const Frame& frame, int entity, const CameraFrame& camera,
                             int tileSide_samples, const SurfaceRows& rows);
    /// The same from a distance in a direction of the model's axes, as it is at unit distance.
    ViewGeometry sampleFrom(const Frame& frame, int entity, const Vec3& from, double distance_m,
                            int tileSide_samples, const SurfaceRows& rows);
    /// Whether what is sampled has its contrasts.
    static bool withErrors(const Frame& frame);

    const RadianceTerms& terms_;
    PreparedEntities& prepared_;
    FramePlanner& planner_;
    SurfaceSampler& sampler_;
    OccluderStacks& occluderStacks_;
    StageClock& clock_;
    PointSources pointSources_;
    RangeGeometry rangeFactors_;
    std::shared_ptr<const Terrain> shadowingTerrain_; // of what is kept
};

} // namespace irsg

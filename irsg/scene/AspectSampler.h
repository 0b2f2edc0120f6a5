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
    /// Adds an object along the range of the plan to a view, before backgrounds that vary over the
    /// frame.
    void addAlongRange(const Frame& frame, const AlongRange& one,
                       const std::vector<const FrameBackground*>& varying, ViewGeometry& view);

    /// The factors of an object from the range that the request samples it from, and their rows.
    struct FromOne {
        const RangeGeometry::FromOne& of; ///< valid until the next one
        SurfaceRows rows;
        CameraFrame camera;
    };
    FromOne drawnFromOne(const Frame& frame, const AlongRange& one, bool withPlaces);

  private:
    /// An object along a line of sight, in model axes.
    struct Along {
        const Entity& entity;
        Vec3 from;
        double reach_m = 0.0;
        bool isSliced = false;
        PointAspect aspect;
    };
    Along along(const Frame& frame, const AlongRange& one);
    static SurfaceRows rowsAt(const Frame& frame, const AlongRange& one, const Along& along,
                              double distance_m);
    /// An entity as it is seen from a direction in its model's axes.
    PointAspect aspectOf(const Frame& frame, int entity, const Vec3& from) const;
    /// Forgets what was sampled beside another terrain, which aspects do not name.
    void forgetOtherTerrain(const Frame& frame);
    /// How an object is sampled by itself.
    struct Alone {
        int entity = 0, tileSide_samples = 0;
        const SurfaceRows& rows;
        bool isAmongTerrain = false;     ///< which may hide it; nothing else does
        PixelGeometry* pixels = nullptr; ///< takes the coverage of its pixels, where not null
    };
    /// Factors of one entity as a camera of its own sees it.
    ViewGeometry sampleAlone(const Frame& frame, const CameraFrame& camera, const Alone& alone);
    /// The same from a distance along a line of sight, as it is at unit distance.
    ViewGeometry sampleFrom(const Frame& frame, const CameraFrame& camera, double distance_m,
                            const Alone& alone);
    /// The same with the places of its kinds where they are wanted.
    RangeGeometry::FromOne sampleFromOne(const Frame& frame, const CameraFrame& camera,
                                         double distance_m, bool withPlaces, Alone alone);
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
    std::shared_ptr<const Terrain> terrain_; // beside what is cached
};

} // namespace irsg

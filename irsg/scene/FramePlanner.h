#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "irsg/scene/FramePlan.h"
#include "irsg/scene/FrameRequest.h"
#include "irsg/scene/PreparedEntities.h"
#include "irsg/scene/SceneEvaluation.h"
#include "irsg/scene/SceneSurfaces.h"
#include "irsg/scene/StageClock.h"
#include "irsg/scene/SurfaceSampler.h"
#include "irsg/scene/ViewKey.h"

namespace irsg {

/// Decides how the objects of a frame are sampled: in tiles, as points, or between distances, and
/// where hot parts are worth samples of their own. Keeps the hot parts that the last view showed.
class FramePlanner {
  public:
    /// All must live as long.
    FramePlanner(const RadianceTerms& terms, PreparedEntities& prepared, SurfaceSampler& sampler,
                 StageClock& clock)
        : terms_(terms), prepared_(prepared), sampler_(sampler), clock_(clock) {}

    /// Prepares the entities of a scene. By entity: where it stands towards the sensor, how far
    /// it reaches along the line of sight, and how it appears; the request looks there. Throws
    /// InputError for what is below ground.
    std::vector<ObjectGeometry> geometry(FrameRequest& request);
    FramePlan plan(const FrameRequest& request, const SceneSurfaces& surfaces,
                   const FrameBackgrounds& backgrounds);

    /// An object as a camera sees it, with its long edges and its hot parts; nothing where it does
    /// not.
    std::optional<ObjectExtent> seenBy(const SceneSurfaces& surfaces, const CameraFrame& camera,
                                       int entity);

  private:
    std::optional<ObjectExtent> placeOf(const SceneSurfaces& surfaces, const CameraFrame& camera,
                                        int entity);
    /// Nothing where it can't be sampled for its whole line of sight.
    std::optional<AlongRange> alongRange(const FrameRequest& request, const SceneSurfaces& surfaces,
                                         const FrameBackgrounds& backgrounds,
                                         const std::vector<ObjectExtent>& seen,
                                         const ObjectExtent& object);
    /// The distance of the nearest terrain that may hide an entity from where it is sampled for its
    /// whole line of sight; none where there is none.
    std::optional<double> terrainDistanceAlong_m(const FrameRequest& request,
                                                 const SceneSurfaces& surfaces, int entity,
                                                 double sampledFrom_m);
    /// Where a camera sees the hot parts of an entity that are not hidden by the entity itself.
    std::vector<ImageRectangle> detailsOf(const SceneSurfaces& surfaces, const CameraFrame& camera,
                                          int entity);
    void addDetails(const FrameRequest& request, const SceneSurfaces& surfaces, FramePlan& plan);

    const RadianceTerms& terms_;
    PreparedEntities& prepared_;
    SurfaceSampler& sampler_;
    StageClock& clock_;
    /// The details of the last view, by entity.
    struct {
        std::optional<ViewKey> key;
        std::map<int, std::vector<ImageRectangle>> byEntity;
    } details_;
    /// The last of terrainDistanceAlong_m(), of an entity in its pose.
    struct {
        std::shared_ptr<const Terrain> terrain;
        std::vector<double> numbers;
        std::optional<double> distance_m;
    } terrainAlong_;
};

} // namespace irsg

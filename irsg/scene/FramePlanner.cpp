#include "irsg/scene/FramePlanner.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "irsg/radiance/PointSources.h"
#include "irsg/radiance/RangeGeometry.h"
#include "irsg/render/rays/RayEngine.h"
#include "irsg/scene/EarthHorizon.h"
#include "irsg/scene/KeyNumbers.h"
#include "irsg/scene/SceneCheck.h"

namespace irsg {

namespace {

/// The samples of a probe around its parts.
std::vector<SampleRun> runsAround(const std::vector<HotSpot>& parts, const SampleTile& probe) {
    const auto width = static_cast<std::size_t>(probe.blocksWide);
    std::vector<char> isWanted(width * static_cast<std::size_t>(probe.blocksHigh));
    for (const HotSpot& part : parts) {
        const ProbedBlocks blocks = blocksAround(part, probe);
        for (int row = blocks.top; row <= blocks.bottom; ++row)
            std::fill_n(isWanted.begin() + static_cast<std::ptrdiff_t>(row) * probe.blocksWide +
                            blocks.left,
                        blocks.right - blocks.left + 1, 1);
    }
    std::vector<SampleRun> runs;
    for (int row = 0; row < probe.blocksHigh; ++row)
        for (int column = 0; column < probe.blocksWide; ++column) {
            if (isWanted[static_cast<std::size_t>(row) * width +
                         static_cast<std::size_t>(column)] == 0)
                continue;
            if (runs.empty() || runs.back().row != row ||
                runs.back().firstColumn + runs.back().count != column)
                runs.push_back({row, column, 0});
            ++runs.back().count;
        }
    return runs;
}

/// The long edges of an object as a camera sees them; those that reach behind it are left out.
std::vector<ImageEdge> edgesOf(const std::vector<ModelEdge>& edges, const Pose& pose,
                               const CameraFrame& camera) {
    std::vector<ImageEdge> seen;
    for (const ModelEdge& edge : edges) {
        const auto from = camera.placeOf(pose.toWorld(edge.from_m));
        const auto to = camera.placeOf(pose.toWorld(edge.to_m));
        if (from && to)
            seen.push_back({to->first - from->first, to->second - from->second});
    }
    return seen;
}

/// True where all of an object is inside the frame, and no other object in its part of it.
bool isWholeAndApart(const Sensor& sensor, const std::vector<ObjectExtent>& seen,
                     const ObjectExtent& object) {
    const ImageRectangle& extent = object.extent;
    const bool isWhole = extent.left > 0.0 && extent.right < sensor.width_px && extent.top > 0.0 &&
                         extent.bottom < sensor.height_px;
    return isWhole && std::ranges::none_of(seen, [&](const ObjectExtent& other) {
               return other.entity != object.entity && other.extent.intersects(extent);
           });
}

/// The distance of the nearest terrain in or beside the pixels of a rectangle, each pixel's in the
/// mean over its nearness, which is given times its coverage; none where there is none.
std::optional<double> nearestIn(const std::vector<double>& coverage,
                                const std::vector<double>& nearness_1_m, const Sensor& sensor,
                                const ImageRectangle& extent) {
    const auto pixel = [](double place, int size) {
        return static_cast<int>(std::clamp(place, 0.0, size - 1.0));
    };
    std::optional<double> nearest_m;
    for (int y = pixel(extent.top - 1.0, sensor.height_px);
         y <= pixel(extent.bottom + 1.0, sensor.height_px); ++y)
        for (int x = pixel(extent.left - 1.0, sensor.width_px);
             x <= pixel(extent.right + 1.0, sensor.width_px); ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(sensor.width_px) +
                static_cast<std::size_t>(x);
            if (coverage[i] > 0.0)
                nearest_m = std::min(nearest_m.value_or(std::numeric_limits<double>::infinity()),
                                     coverage[i] / nearness_1_m[i]);
        }
    return nearest_m;
}

/// The same of terrain that may hide objects of a frame.
std::optional<double> terrainDistance_m(const FrameRequest& request,
                                        const FrameBackgrounds& backgrounds,
                                        const ImageRectangle& extent) {
    const BackgroundLayers& layers = backgrounds.layers;
    if (layers.coverage.empty() || !request.scene.settings.terrainHides)
        return std::nullopt;
    return nearestIn(layers.coverage, layers.nearness_1_m, request.view.sensor, extent);
}

HiddenPart hiddenPart(const SceneSurfaces& surfaces, int entity) {
    return surfaces.evaluation.geometry[static_cast<std::size_t>(entity)].hidden;
}

bool isAmong(const std::vector<ObjectExtent>& objects, const ObjectExtent& object) {
    return std::ranges::find(objects, object.entity, &ObjectExtent::entity) != objects.end();
}

} // namespace

std::vector<ObjectGeometry> FramePlanner::geometry(FrameRequest& request) {
    const Scene& scene = request.scene;
    prepared_.keep(scene.entities);
    for (const Entity& entity : scene.entities)
        request.referencePoints_m.push_back(entity.pose.toWorld(prepared_.referencePoint(entity)));
    std::vector<ObjectGeometry> objects =
        objectGeometry(scene.entities, request.referencePoints_m, request.view.viewpoint);
    for (std::size_t e = 0; e < objects.size(); ++e) {
        const Entity& entity = scene.entities[e];
        // About the reference point, so that views from one distance have the same slices.
        const double reach_m = prepared_.reach_m(entity);
        objects[e].nearest_m = std::max(objects[e].path.range_m - reach_m, 0.0);
        objects[e].farthest_m = objects[e].path.range_m + reach_m;
    }
    takeApparentDirections(request, objects);
    return objects;
}

std::optional<ObjectExtent> FramePlanner::placeOf(const SceneSurfaces& surfaces,
                                                  const CameraFrame& camera, int entity) {
    const Entity& own = surfaces.entity(entity);
    const PreparedModel& model = prepared_.of(own);
    auto seen = objectExtent(entity, camera, model.mesh(), own.pose);
    if (seen)
        seen->edges = edgesOf(model.mesh().longEdges, own.pose, camera);
    return seen;
}

std::optional<ObjectExtent> FramePlanner::seenBy(const SceneSurfaces& surfaces,
                                                 const CameraFrame& camera, int entity) {
    auto seen = placeOf(surfaces, camera, entity);
    if (seen)
        seen->details = detailsOf(surfaces, camera, entity);
    return seen;
}

FramePlan FramePlanner::plan(const FrameRequest& request, const SceneSurfaces& surfaces,
                             const FrameBackgrounds& backgrounds) {
    if (!request.withObjects)
        return {};
    const RenderSettings& settings = request.scene.settings;
    std::vector<ObjectExtent> seen;
    for (int e = 0; e < static_cast<int>(request.scene.entities.size()); ++e)
        if (hiddenPart(surfaces, e) != HiddenPart::all)
            if (auto object = placeOf(surfaces, request.camera, e))
                seen.push_back(std::move(*object));

    FramePlan plan;
    // Nodes of ranges have no image of the object, in which a background could vary.
    const bool mayBeAlongRange = request.alongRange && settings.usesAlignedTiles() &&
                                 (request.sampledFrom_m || backgrounds.areUniform());
    const bool mayBePoints = settings.usesAlignedTiles() && settings.pointSourceBelow_px > 0.0;
    for (const ObjectExtent& object : seen) {
        auto along = mayBeAlongRange ? alongRange(request, surfaces, backgrounds, seen, object)
                                     : std::nullopt;
        if (along) {
            plan.alongRange.push_back(std::move(*along));
            continue;
        }
        const std::size_t slices =
            surfaces.evaluation.geometry[static_cast<std::size_t>(object.entity)].slices_m.size();
        const bool isPoint = mayBePoints && slices < 2 &&
                             hiddenPart(surfaces, object.entity) == HiddenPart::none &&
                             object.extent.extent() < settings.pointSourceBelow_px &&
                             isWholeAndApart(request.view.sensor, seen, object) &&
                             !terrainDistance_m(request, backgrounds, object.extent);
        (isPoint ? plan.points : plan.drawn).push_back(object);
        plan.seen.push_back(object);
    }
    addDetails(request, surfaces, plan);
    return plan;
}

std::optional<AlongRange> FramePlanner::alongRange(const FrameRequest& request,
                                                   const SceneSurfaces& surfaces,
                                                   const FrameBackgrounds& backgrounds,
                                                   const std::vector<ObjectExtent>& seen,
                                                   const ObjectExtent& object) {
    const Entity& entity = request.entity(object.entity);
    const double range_m =
        surfaces.evaluation.geometry[static_cast<std::size_t>(object.entity)].path.range_m;
    const double ofItself_m = prepared_.reach_m(entity);
    // A camera so close, in the reference point even, has no direction towards it that counts.
    if (!(ofItself_m > 0.0) || !(ofItself_m <= RangeGeometry::closest * range_m))
        return std::nullopt;
    // Cosines off the axis are those of a camera that looks at the reference point.
    constexpr double nearby = 1e-6;
    const Viewpoint& viewpoint = request.view.viewpoint;
    const bool isLookedAt =
        length(prepared_.towards(entity, viewpoint.position_m) - viewpoint.backward) < nearby;
    if (hiddenPart(surfaces, object.entity) != HiddenPart::none || !isLookedAt ||
        !isWholeAndApart(request.view.sensor, seen, object))
        return std::nullopt;
    AlongRange one{object, ofItself_m};
    const auto terrain_m = terrainDistance_m(request, backgrounds, object.extent);
    if (!terrain_m)
        return one;
    if (!request.sampledFrom_m)
        return std::nullopt;
    // What hides it must do so from here as from where it is sampled.
    const double sampledFrom_m = RangeGeometry::sampledFrom_m(*request.sampledFrom_m, ofItself_m);
    const auto there_m = terrainDistanceAlong_m(request, surfaces, object.entity, sampledFrom_m);
    const double before_m =
        std::max(range_m - *terrain_m, there_m ? sampledFrom_m - *there_m : -range_m);
    one.reach_m = std::max(ofItself_m, before_m);
    // Pixels have means, behind what may hide it at their rims.
    one.isAmongTerrain = before_m > -2.0 * ofItself_m;
    if (one.reach_m > RangeGeometry::closest * std::min(range_m, sampledFrom_m))
        return std::nullopt;
    return one;
}

std::optional<double> FramePlanner::terrainDistanceAlong_m(const FrameRequest& request,
                                                           const SceneSurfaces& surfaces,
                                                           int entity, double sampledFrom_m) {
    const Entity& own = request.entity(entity);
    const Vec3 from = prepared_.lineOfSight(own, request.view.viewpoint.position_m);
    std::vector<double> numbers{static_cast<double>(entity), sampledFrom_m, prepared_.reach_m(own)};
    appendTo(numbers, from);
    appendTo(numbers, prepared_.referencePoint(own));
    appendTo(numbers, own.pose.position_m);
    appendTo(numbers, own.pose.attitude);
    if (terrainAlong_.terrain == request.scene.terrain && terrainAlong_.numbers == numbers)
        return terrainAlong_.distance_m;
    const CameraFrame camera = prepared_.cameraAlong(own, from, sampledFrom_m, request.view.sensor);
    const TerrainImage image =
        surfaces.engine.terrainPainter.paint(request.scene.terrain, camera, 0.0);
    const ImageRectangle whole{0.0, 0.0, static_cast<double>(camera.sensor().width_px),
                               static_cast<double>(camera.sensor().height_px)};
    terrainAlong_ = {request.scene.terrain, std::move(numbers),
                     nearestIn(image.coverage, image.nearness_1_m, camera.sensor(), whole)};
    return terrainAlong_.distance_m;
}

std::vector<ImageRectangle> FramePlanner::detailsOf(const SceneSurfaces& surfaces,
                                                    const CameraFrame& camera, int entity) {
    std::vector<IrCodes> hot;
    const std::vector<SurfaceKey>& keys = surfaces.rows().keys();
    for (std::size_t row = 0; row < surfaces.evaluation.hot.size(); ++row)
        if (surfaces.evaluation.hot[row] && keys[row].first == entity)
            hot.push_back(keys[row].second);
    PreparedModel& model = prepared_.of(surfaces.entity(entity));
    const std::vector<HotSpot> parts =
        model.hotSpots.seenBy(camera, surfaces.entity(entity).pose, model.mesh(), hot);
    std::vector<ImageRectangle> details;
    if (parts.empty())
        return details;
    const SampleTile probe = probeOf(parts, entity);
    SurfaceScene scene = sampler_.sceneOf(surfaces, camera, probe);
    std::erase_if(scene.items, [](const SurfaceItem& item) { return item.transparent; });
    scene.terrain = {};
    scene.groundBefore.clear();
    GeometrySamples samples;
    if (areRaysBuilt()) {
        // A few rays are there while a drawing that was begun before goes on.
        scene.bodies.front().rays = clock_.timed("ray trees", [&] { return model.forRays(); });
        const SheetScene sheet{SampleSheet::of(probe), {std::move(scene)}};
        clock_.timed("hot parts",
                     [&] { RayEngine::traceRuns(sheet, 0, runsAround(parts, probe), samples); });
    } else {
        const SheetScene sheet{SampleSheet::of(probe), {std::move(scene)}};
        sampler_.onEngine(surfaces.engine,
                          [&] { surfaces.engine.engine.sampleGeometry(sheet, true, samples); });
    }
    for (const HotSpot& part : parts)
        if (!isHidden(part, probe, samples))
            details.push_back(part.extent);
    return details;
}

void FramePlanner::addDetails(const FrameRequest& request, const SceneSurfaces& surfaces,
                              FramePlan& plan) {
    const std::vector<bool>& hot = surfaces.evaluation.hot;
    if (std::ranges::find(hot, true) == hot.end())
        return;
    ViewKey key = viewKey(terms_, request, surfaces, plan.alongRange);
    if (details_.key != key) {
        details_.byEntity.clear();
        details_.key = std::move(key);
    }
    for (std::vector<ObjectExtent>* objects : {&plan.seen, &plan.drawn})
        for (ObjectExtent& object : *objects) {
            if (isAmong(plan.points, object) && !request.scene.settings.truthLayers)
                continue;
            if (!details_.byEntity.contains(object.entity))
                details_.byEntity[object.entity] =
                    detailsOf(surfaces, request.camera, object.entity);
            object.details = details_.byEntity.at(object.entity);
        }
}

} // namespace irsg

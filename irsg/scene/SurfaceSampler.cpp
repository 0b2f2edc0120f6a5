#include "irsg/scene/SurfaceSampler.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/StageReport.h"
#include "irsg/render/background/Terrain.h"
#include "irsg/render/sampling/TileSamplingStrategy.h"

namespace irsg {

GeometryFactors SurfaceSampler::geometryFactors(const SceneSurfaces& surfaces,
                                                const CameraFrame& camera) const {
    const bool withNormals = surfaces.shading.lobes != nullptr;
    GeometryFactors making{terms_.factorCount() + (withNormals ? normalFactors : 0),
                           terms_.glsl(surfaces.scene.settings, withNormals),
                           {},
                           {},
                           {}};
    if (making.factorCount > mostFactors)
        throw LogicError("more factors than there is room for beside the normals of surfaces");
    if (surfaces.engine.isRays)
        making.functions = terms_.functions(surfaces.scene.settings, withNormals);
    if (surfaces.shading.shadows)
        making.shadowedFrom = terms_.shadowedFrom(surfaces.scene.settings);
    for (const FrameDirection& direction : terms_.directions)
        making.directionsEye.emplace_back(
            direction.name, camera.toEye(direction.world(surfaces.scene.environment.sun)));
    return making;
}

namespace {

/// The gases of a tile's entities that the eye is in.
void addGasesAboutEye(const SceneSurfaces& surfaces, const CameraFrame& camera,
                      const SampleTile& tile, SurfaceScene& scene) {
    for (const auto& [row, zone] : surfaces.rows().gases()) {
        const auto& [e, codes] = surfaces.rows().keyOf(row);
        if (!std::ranges::binary_search(tile.entities, e))
            continue;
        const Entity& entity = surfaces.entity(e);
        const Vec3 eye_m = entity.pose.attitude.rotation().transposed() *
                           (camera.viewpoint().position_m - entity.pose.position_m);
        if (isInGasZone(*entity.model->mesh(), codes, eye_m))
            scene.gasesAboutEye.push_back(row);
    }
}

} // namespace

SurfaceScene SurfaceSampler::sceneOf(const SceneSurfaces& surfaces, const CameraFrame& camera,
                                     const SampleTile& tile) const {
    const auto stands = [&](int entity) {
        return std::ranges::binary_search(tile.entities, entity);
    };
    SurfaceScene scene;
    scene.camera = &camera;
    scene.factors = geometryFactors(surfaces, camera);
    scene.rows = surfaces.evaluation.rows;
    if (surfaces.scene.terrain && surfaces.scene.settings.terrainHides)
        scene.terrain = surfaces.scene.terrain->bodyFor(camera, surfaces.engine.terrainMesh);
    for (const GroundBefore& ground : surfaces.ground)
        if (stands(ground.entity))
            scene.groundBefore.push_back(
                {-1, ground.mesh, ground.rays, camera.eyeFromModel(ground.pose)});
    for (const SurfaceItem& item : surfaces.items) { // those of an entity follow one another
        if (!stands(item.entity))
            continue;
        if (scene.bodies.empty() || scene.bodies.back().entity != item.entity) {
            const Entity& entity = surfaces.entity(item.entity);
            SurfaceBody& body = scene.bodies.emplace_back();
            body.entity = item.entity;
            body.mesh = entity.model->mesh();
            if (!surfaces.engine.meshes.empty())
                body.rays = surfaces.engine.meshes[static_cast<std::size_t>(item.entity)];
            body.eyeFromModel = camera.eyeFromModel(entity.pose);
        }
        scene.items.push_back(item);
        scene.items.back().body = scene.bodies.size() - 1;
    }

    addGasesAboutEye(surfaces, camera, tile, scene);

    bool isFirst = true;
    for (int e : tile.entities) {
        const Entity& entity = surfaces.entity(e);
        const auto depth = camera.depthOf(entity.model->bounds(), entity.pose);
        if (!depth)
            continue;
        DepthRange& all = scene.depth;
        all.near_m = isFirst ? depth->near_m : std::min(all.near_m, depth->near_m);
        all.far_m = isFirst ? depth->far_m : std::max(all.far_m, depth->far_m);
        isFirst = false;
    }
    return scene;
}

SheetScene SurfaceSampler::scenesOf(const SceneSurfaces& surfaces, const CameraFrame& camera,
                                    const SampleSheet& sheet) const {
    SheetScene result{sheet, {}};
    for (const SampleTile& tile : sheet.tiles)
        result.scenes.push_back(sceneOf(surfaces, camera, tile));
    return result;
}

void SurfaceSampler::onEngine(const FrameEngine& engine, const std::function<void()>& work) {
    double waited_s = 0.0, drawing_s = 0.0, reading_s = 0.0;
    {
        auto waiting = std::make_unique<Stopwatch>(waited_s);
        engine.engine.run([&] {
            waiting.reset(); // for drawings that were begun before
            work();
            drawing_s = engine.engine.takeRenderSeconds();
            reading_s = engine.engine.takeReadSeconds();
        });
    }
    clock_.add("drawing", waited_s + drawing_s);
    clock_.add("read back", reading_s);
}

SurfaceSampler::Sampling SurfaceSampler::begin(const SceneSurfaces& surfaces,
                                               const CameraFrame& camera,
                                               const std::vector<SampleTile>& tiles,
                                               bool withDistance, Take take) {
    const int side = surfaces.engine.engine.largestSide();
    auto planned = std::make_shared<const std::vector<SampleSheet>>(
        tiles.empty() ? std::vector<SampleSheet>{} : sheetsOf(piecesOf(tiles, side), side));
    TileStream::Work work;
    work.drawings = planned->size();
    work.maximumLayers = surfaces.scene.settings.maximumLayers;
    work.draw = [this, &surfaces, &camera, planned, withDistance](
                    std::size_t i, GeometrySamples& samples, TileStream::Seconds& seconds) {
        SampleEngine& engine = surfaces.engine.engine;
        engine.sampleGeometry(scenesOf(surfaces, camera, (*planned)[i]),
                              withDistance || surfaces.shading.isNeeded(), samples);
        seconds.drawing += engine.takeRenderSeconds();
        seconds.reading += engine.takeReadSeconds();
    };
    if (surfaces.shading.isNeeded() || surfaces.shading.hasGas)
        work.shade = [&surfaces, &camera, planned, this](std::size_t i, GeometrySamples& samples) {
            surfaces.shading.apply(scenesOf(surfaces, camera, (*planned)[i]),
                                   surfaces.scene.settings, samples);
        };
    work.take = [planned, take = std::move(take)](std::size_t i, const GeometrySamples& samples) {
        for (const SampleTile& tile : (*planned)[i].tiles)
            take(tile, samples);
    };
    return stream_.start(surfaces.engine.engine, std::move(work));
}

void SurfaceSampler::waitFor(Sampling& sampling, const char* stage) {
    TileStream::Seconds seconds;
    double waited_s = 0.0;
    {
        const StageScope drawing("drawing");
        Stopwatch watch(waited_s);
        seconds = sampling.get();
    }
    const double all_s =
        seconds.drawing + seconds.reading + seconds.sorting + seconds.shading + seconds.taking;
    if (!(all_s > 0.0))
        return; // nothing was drawn
    const double part = waited_s / all_s;
    clock_.add("drawing", part * seconds.drawing);
    clock_.add("read back", part * seconds.reading);
    clock_.add("layer sorting", part * seconds.sorting);
    if (seconds.shading > 0.0)
        clock_.add("sun shadows", part * seconds.shading);
    clock_.add(stage, part * seconds.taking);
}

void SurfaceSampler::sample(const SceneSurfaces& surfaces, const CameraFrame& camera,
                            const std::vector<SampleTile>& tiles, bool withDistance,
                            const char* stage, Take take) {
    if (tiles.empty())
        return;
    Sampling sampling = begin(surfaces, camera, tiles, withDistance, std::move(take));
    waitFor(sampling, stage);
}

} // namespace irsg

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/Errors.h"
#include "irsg/core/NewLines.h"
#include "irsg/radiance/HotSurfaces.h"
#include "irsg/render/background/BandSky.h"
#include "irsg/render/rays/RayEngine.h"
#include "irsg/scene/RendererImpl.h"

namespace irsg {

namespace {

LineOfSight centreOf(const Viewpoint& viewpoint) {
    const Vec3 view = viewpoint.forward();
    LineOfSight sight;
    sight.sensorAltitude_m = std::max(viewpoint.position_m.z, 0.0);
    sight.elevation_rad = std::asin(std::clamp(view.z, -1.0, 1.0));
    sight.azimuth_rad = std::atan2(view.x, view.y);
    return steadied(sight);
}

/// The samples of a probe around its parts.
std::vector<SampleRun> runsAround(const std::vector<HotPart>& parts, const SampleWindow& probe) {
    const auto width = static_cast<std::size_t>(probe.tilesWide);
    std::vector<char> isWanted(width * static_cast<std::size_t>(probe.tilesHigh));
    for (const HotPart& part : parts) {
        const ProbedTiles tiles = tilesAround(part, probe);
        for (int row = tiles.top; row <= tiles.bottom; ++row)
            std::fill_n(isWanted.begin() + static_cast<std::ptrdiff_t>(row) * probe.tilesWide +
                            tiles.left,
                        tiles.right - tiles.left + 1, 1);
    }
    std::vector<SampleRun> runs;
    for (int row = 0; row < probe.tilesHigh; ++row)
        for (int column = 0; column < probe.tilesWide; ++column) {
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

} // namespace

void Renderer::Impl::addTime(const std::string& name, double seconds) {
    auto found = std::ranges::find(stages, name, &StageTimes::Stage::name);
    if (found == stages.end())
        found = stages.insert(stages.end(), {name, 0.0, 0});
    found->seconds += seconds;
    ++found->calls;
}

bool Renderer::Impl::Frame::isTransparent() const {
    return std::ranges::any_of(items, &SurfaceItem::transparent);
}

double Renderer::Impl::reachOf_m(const Entity& entity) {
    const BoundingSphere& sphere = prepared.of(entity).boundingSphere;
    return sphere.radius_m + length(sphere.centre_m - prepared.referencePoint(entity));
}

std::vector<ObjectGeometry> Renderer::Impl::geometry(const Scene& scene, const SensorView& view) {
    prepared.keep(scene.entities);
    std::vector<Vec3> points;
    for (const Entity& entity : scene.entities)
        points.push_back(entity.pose.toWorld(prepared.referencePoint(entity)));
    std::vector<ObjectGeometry> objects = objectGeometry(scene.entities, points, view.viewpoint);
    for (std::size_t e = 0; e < objects.size(); ++e) {
        const Entity& entity = scene.entities[e];
        // About the reference point, so that views from one distance have the same slices.
        const double reach_m = reachOf_m(entity);
        objects[e].nearest_m = std::max(objects[e].path.range_m - reach_m, 0.0);
        objects[e].farthest_m = objects[e].path.range_m + reach_m;
    }
    return objects;
}

Renderer::Impl::Frame Renderer::Impl::frame(const Scene& scene, const SensorView& view,
                                            const Outputs& outputs) {
    const std::vector<Band> bands =
        outputs.bands().empty() ? std::vector<Band>{view.sensor.band} : outputs.bands();
    Frame result(scene, view, bands);
    result.withSources = outputs.hasSource() && !outputs.hasImage();
    result.withErrors =
        outputs.hasErrors() && (outputs.hasReports() || !outputs.wavenumbers_per_cm().empty());
    result.centre = centreOf(view.viewpoint);
    result.geometry = geometry(scene, view);
    checkScene(scene.entities, result.geometry, scene.environment, view.sensor, bands,
               scene.settings);
    takeMirrorGrids(scene, bands.front(), result.geometry);
    takeEngine(result);
    evaluate(result);
    takeShadows(result, outputs);
    takeLobes(result);
    if (outputs.isAlongRange() && !outputs.hasImage())
        planAlongRange(result);
    findDetails(result);
    return result;
}

void Renderer::Impl::evaluate(Frame& frame) {
    timed("radiometry", [&] {
        air.setEnvironment(frame.scene.environment);
        background.setSkybox(frame.scene.skybox);
        background.setTerrain(frame.scene.terrain);
        const std::shared_ptr<const SampledScene> sampled = sample(frame);
        for (std::size_t e = 0; e < frame.geometry.size(); ++e) {
            frame.geometry[e].slices_m = sampled->slices_m[e];
            frame.geometry[e].airError = sampled->airError[e];
            frame.geometry[e].likelyAirError = sampled->likelyAirError[e];
        }
        frame.sampled = sampled;
        frame.answeredBy = sampled->answeredBy;
        frame.warnings = sampled->warnings;
        frame.evaluated =
            radiometry.of(terms, frame.scene.entities, frame.geometry, sampled, fronts);
        frame.background = sampled->background;
        frame.evaluated->radiances.setBackground(frame.background);
        drawBackgrounds(frame);
        fillRows(frame);
        fillItems(frame);
        planPoints(frame);
    });
}

std::shared_ptr<const SampledScene> Renderer::Impl::sample(const Frame& frame) {
    const AirScene scene{terms, frame.scene.entities, frame.geometry, frame.scene.settings,
                         frame.centre};
    return sampledScenes.of(air, scene, frame.bands, frame.withSources, sampler(frame, air));
}

SampledScenes::Sampler Renderer::Impl::sampler(const Frame& frame, AtmosphericQueryCache& answers) {
    return [&](const AirScene& scene, const std::vector<Band>& bands) {
        if (scene.settings.mode != CalculationMode::wideband)
            return sampling.spectral(answers, scene, bands);
        std::vector<SampledBand> sampled;
        sampled.reserve(bands.size());
        for (const Band& band : bands)
            sampled.push_back(SceneSampling::wideband(answers, scene, wideband(frame.scene, band)));
        return sampled;
    };
}

std::shared_ptr<const SpectralSampling> Renderer::Impl::samplingOf(const Frame& frame,
                                                                   std::size_t band) {
    const SampledBand& sampled = frame.sampled->ofOutput(band);
    return sampled.outputs.size() == 1 ? sampled.sampling
                                       : sampling.nodes(frame.scene.environment, frame.bands[band]);
}

std::shared_ptr<const WidebandPoints> Renderer::Impl::wideband(const Scene& scene,
                                                               const Band& band) {
    WidebandSpectra spectra = widebandSpectraOf(scene.entities);
    const double error = scene.settings.widebandError;
    widebandPoints.letGo([](const auto& kept) { return kept->isGone(); });
    return widebandPoints.of(
        [&](const auto& kept) { return kept->areOf(scene.environment, band, spectra, error); },
        [&] {
            return timed("wideband points", [&] {
                return std::make_shared<const WidebandPoints>(scene.environment, band,
                                                              std::move(spectra), error);
            });
        });
}

void Renderer::Impl::drawBackgrounds(Frame& frame) {
    const RenderSettings& settings = frame.scene.settings;
    for (std::size_t k = 0; k < frame.evaluated->radiances.outputs(); ++k) {
        if (frame.sampled->ofOutput(k).isSource) {
            frame.backgrounds.emplace_back(0.0);
            continue;
        }
        const std::shared_ptr<const SpectralSampling> nodes = samplingOf(frame, k);
        const BandSky sky(frame.scene.environment, *nodes);
        BackgroundSettings wanted;
        wanted.asksEnvironment = settings.background == BackgroundMode::environment;
        wanted.uniform_W_m2_sr = frame.evaluated->radiances.background_W_m2_sr(k);
        wanted.rows = settings.backgroundRows;
        wanted.columns = settings.backgroundColumns;
        wanted.sunDisc = settings.sunDisc;
        wanted.skybox = settings.skybox;
        wanted.terrain = settings.terrain;
        BackgroundReport report;
        frame.backgrounds.push_back(background.draw(frame.view.sensor, frame.view.viewpoint, sky,
                                                    wanted, terrainPainter(frame), report));
        frame.backgroundReport.flooredPixels += report.flooredPixels;
        addAnswer(frame.backgroundReport.answeredBy, report.answeredBy);
        addNew(frame.backgroundReport.warnings, report.warnings);
    }
}

void Renderer::Impl::fillRows(Frame& frame) {
    const SurfaceRows& rows = frame.surfaceRows();
    KindRadiances& radiances = frame.evaluated->radiances;
    std::vector<FactorKind> kinds;
    for (std::size_t drawn = 0; drawn < rows.keys().size(); ++drawn)
        kinds.push_back({0, rows.first(static_cast<int>(drawn))});
    radiances.prepare(kinds);
    for (const FactorKind& kind : kinds) {
        const KindRadiance radiance = radiances.of(kind);
        SurfaceRow& row = frame.rows.emplace_back();
        std::ranges::transform(radiance.perFactor, row.radiance.begin(),
                               [](double value) { return static_cast<float>(value); });
        row.constant = static_cast<float>(radiance.constant);
        row.opacity = static_cast<float>(radiance.opacity);
        row.nAngleFactor =
            static_cast<float>(frame.evaluated->radiometry.surface(kind.row).nAngleFactor);
    }
}

std::vector<bool> Renderer::Impl::hotRows(const Frame& frame) {
    std::vector<bool> hot = hotSurfaces(frame.evaluated->radiometry, frame.scene.entities);
    std::vector<Entity> entities = frame.scene.entities;
    const std::size_t states = entities.empty() ? 0 : entities.front().otherStates.size();
    for (std::size_t i = 0; i < states; ++i) {
        for (Entity& entity : entities)
            entity.state = entity.otherStates.at(i);
        const auto other = radiometry.of(terms, entities, frame.geometry, frame.sampled, fronts);
        const std::vector<bool> there = hotSurfaces(other->radiometry, entities);
        for (std::size_t row = 0; row < hot.size(); ++row)
            hot[row] = hot[row] || there.at(row);
    }
    return hot;
}

void Renderer::Impl::fillItems(Frame& frame) {
    const RenderSettings& settings = frame.scene.settings;
    const SurfaceRows& rows = frame.surfaceRows();
    frame.hot.assign(rows.keys().size(), false);
    if (settings.hotSpots && settings.zoomsAligned())
        frame.hot = hotRows(frame);
    for (int e = 0; e < static_cast<int>(frame.scene.entities.size()); ++e) {
        const Entity& entity = frame.entity(e);
        const PreparedModel& model = prepared.of(entity);
        const auto seen = zoomEntityInfo(e, frame.camera, entity.model->bounds(),
                                         model.boundingSphere, entity.pose);
        if (!seen)
            continue;
        frame.seen.push_back(*seen);
        frame.seen.back().edges = edgesOf(frame, frame.camera, e);

        int piece = 0;
        for (const DrawItem& item : model.items) {
            const auto key = std::ranges::lower_bound(rows.keys(), SurfaceKey{e, item.codes});
            if (key == rows.keys().end() || *key != SurfaceKey{e, item.codes})
                throw LogicError("a surface was drawn that the model did not announce");
            const auto drawn = static_cast<int>(key - rows.keys().begin());
            frame.items.push_back({item.geometry.get(), item.modelFromLocal, e, piece++, drawn,
                                   rows.isTransparent(drawn), item.cullsBackFaces, item.layer});
        }
    }
}

void Renderer::Impl::planPoints(Frame& frame) const {
    const RenderSettings& settings = frame.scene.settings;
    const bool mayBePoints = settings.zoomsAligned() && settings.pointSourceBelow_px > 0.0;
    for (const ZoomEntityInfo& object : frame.seen) {
        const bool isOneSlice =
            frame.geometry[static_cast<std::size_t>(object.entity)].slices_m.size() < 2;
        const bool isPoint = mayBePoints && isWholeAndApart(frame, object) && isOneSlice &&
                             object.extent.extent() < settings.pointSourceBelow_px &&
                             !touchesTerrain(frame, object.extent);
        (isPoint ? frame.points : frame.drawn).push_back(object);
    }
}

bool Renderer::Impl::isWholeAndApart(const Frame& frame, const ZoomEntityInfo& object) {
    const Sensor& sensor = frame.view.sensor;
    const ImageRectangle& extent = object.extent;
    const bool isWhole = extent.left > 0.0 && extent.right < sensor.width_px && extent.top > 0.0 &&
                         extent.bottom < sensor.height_px;
    return isWhole && std::ranges::none_of(frame.seen, [&](const ZoomEntityInfo& other) {
               return other.entity != object.entity && other.extent.intersects(extent);
           });
}

bool Renderer::Impl::touchesTerrain(const Frame& frame, const ImageRectangle& extent) const {
    const std::vector<double>& coverage = background.layers().coverage;
    if (coverage.empty() || !frame.scene.settings.terrainHides)
        return false;
    const Sensor& sensor = frame.view.sensor;
    const auto pixel = [](double place, int size) {
        return static_cast<int>(std::clamp(place, 0.0, size - 1.0));
    };
    for (int y = pixel(extent.top - 1.0, sensor.height_px);
         y <= pixel(extent.bottom + 1.0, sensor.height_px); ++y)
        for (int x = pixel(extent.left - 1.0, sensor.width_px);
             x <= pixel(extent.right + 1.0, sensor.width_px); ++x)
            if (coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(sensor.width_px) +
                         static_cast<std::size_t>(x)] > 0.0)
                return true;
    return false;
}

std::vector<ImageRectangle> Renderer::Impl::detailsOf(const Frame& frame, const CameraFrame& camera,
                                                      int entity) {
    std::vector<IrCodes> hot;
    const std::vector<SurfaceKey>& keys = frame.surfaceRows().keys();
    for (std::size_t row = 0; row < frame.hot.size(); ++row)
        if (frame.hot[row] && keys[row].first == entity)
            hot.push_back(keys[row].second);
    PreparedModel& model = prepared.of(frame.entity(entity));
    const std::vector<HotPart> parts =
        model.hotParts.seenBy(camera, frame.entity(entity).pose, model.items, hot);
    std::vector<ImageRectangle> details;
    if (parts.empty())
        return details;
    const SampleWindow probe = probeOf(parts, entity);
    SurfaceScene scene = sceneOf(frame, camera, probe);
    std::erase_if(scene.items, [](const SurfaceItem& item) { return item.transparent; });
    scene.occluders.clear();
    scene.terrain = {};
    FactorSamples samples;
    if (areRaysBuilt()) {
        // A few rays are there while a drawing that was begun before goes on.
        scene.bodies = {{entity, timed("ray trees", [&] { return model.forRays(); }),
                         camera.eyeFromModel(frame.entity(entity).pose)}};
        const SheetScene sheet{SampleSheet::of(probe), {std::move(scene)}};
        timed("hot parts",
              [&] { RayEngine::traceRuns(sheet, 0, runsAround(parts, probe), samples); });
    } else {
        const SheetScene sheet{SampleSheet::of(probe), {std::move(scene)}};
        onEngine(frame, [&] { frame.engine->drawFactors(sheet, true, samples); });
    }
    for (const HotPart& part : parts)
        if (!isHidden(part, probe, samples))
            details.push_back(part.extent);
    return details;
}

void Renderer::Impl::findDetails(Frame& frame) {
    if (std::ranges::find(frame.hot, true) == frame.hot.end())
        return;
    ViewKey key = viewKey(frame);
    if (details.key != key) {
        details.byEntity.clear();
        details.key = std::move(key);
    }
    for (std::vector<ZoomEntityInfo>* objects : {&frame.seen, &frame.drawn})
        for (ZoomEntityInfo& object : *objects) {
            const bool isPoint = std::ranges::find(frame.points, object.entity,
                                                   &ZoomEntityInfo::entity) != frame.points.end();
            if (isPoint && !frame.scene.settings.truthLayers)
                continue;
            const auto [known, isNew] = details.byEntity.try_emplace(object.entity);
            if (isNew)
                known->second = detailsOf(frame, frame.camera, object.entity);
            object.details = known->second;
        }
}

std::vector<ImageEdge> Renderer::Impl::edgesOf(const Frame& frame, const CameraFrame& camera,
                                               int entity) {
    const Pose& pose = frame.entity(entity).pose;
    std::vector<ImageEdge> seen;
    for (const ModelEdge& edge : prepared.of(frame.entity(entity)).longEdges) {
        const auto from = camera.placeOf(pose.toWorld(edge.from_m));
        const auto to = camera.placeOf(pose.toWorld(edge.to_m));
        if (from && to)
            seen.push_back({to->first - from->first, to->second - from->second});
    }
    return seen;
}

} // namespace irsg

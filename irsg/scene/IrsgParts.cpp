#include "irsg/scene/IrsgParts.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <osg/GLObjects>
#include <osg/RenderInfo>
#include <osg/State>

#include "irsg/radiometry/Units.h"
#include "irsg/scene/radiance/FactorTable.h"
#include "irsg/scene/radiance/HotSurfaces.h"
#include "irsg/scene/radiance/TruthLayers.h"
#include "irsg/scene/view/PixelGrid.h"

namespace irsg {

namespace {

/// Largest side of one drawing, samples: bounds the memory of the targets.
constexpr int largestSide = 2048;

/// Sets of wideband terms that are kept, so that sensors and samples can take turns.
constexpr std::size_t mostTermsKept = 4;

int shaderMode(ReflectionMode mode) {
    return mode == ReflectionMode::off ? 0 : mode == ReflectionMode::approx ? 1 : 2;
}

std::string text(double value) {
    std::ostringstream out;
    out.precision(9);
    out << value;
    return out.str();
}

} // namespace

void Irsg::Parts::addTime(const std::string& name, double seconds) {
    auto found = std::ranges::find(stages, name, &StageTimes::Stage::name);
    if (found == stages.end())
        found = stages.insert(stages.end(), {name, 0.0, 0});
    found->seconds += seconds;
    ++found->calls;
}

Vec3 Irsg::Parts::modelReferencePoint(const Entity& entity) const {
    if (entity.referencePoint_m)
        return *entity.referencePoint_m;
    const BoundingBox opaque = entity.model->boundsOf([&](const IrCodes& codes) {
        const Material* material = materialEntry(entity, codes.material);
        return !material || material->isOpaque();
    });
    return opaque.valid() ? opaque.centre() : entity.model->bounds().centre();
}

void Irsg::Parts::prepareEntity(std::size_t e) {
    referencePoints[e] = modelReferencePoint(entities[e]);
}

std::vector<ObjectGeometry> Irsg::Parts::geometry() const {
    std::vector<Vec3> points;
    for (std::size_t e = 0; e < entities.size(); ++e)
        points.push_back(entities[e].pose.toWorld(referencePoints[e]));
    return objectGeometry(entities, points, viewpoint);
}

LineOfSight Irsg::Parts::centre() const {
    const Vec3 view = viewpoint.forward();
    LineOfSight sight;
    sight.sensorAltitude_m = std::max(viewpoint.position_m.z, 0.0);
    sight.elevation_rad = std::asin(std::clamp(view.z, -1.0, 1.0));
    sight.azimuth_rad = std::atan2(view.x, view.y);
    return sight;
}

SurfaceModes Irsg::Parts::modes(const CameraFrame& camera) const {
    SurfaceModes result;
    result.sun = shaderMode(settings.sun);
    result.flux = shaderMode(settings.fluxes);
    if (settings.fluxes == ReflectionMode::smart && settings.fluxWeights == FluxWeights::report)
        result.flux = 3;
    result.zenithEye = camera.toEye({0, 0, 1});
    const SunPosition& sun = environment.sun;
    result.sunEye = camera.toEye(direction(sun.azimuth_rad, sun.elevation_rad));
    return result;
}

Irsg::Parts::Frame Irsg::Parts::frame(CalculationMode mode) {
    const std::vector<ObjectGeometry> objects = geometry();
    checkScene(entities, objects, environment, sensor, settings);
    const WidebandTerms* wideband = mode == CalculationMode::wideband ? &terms() : nullptr;
    Frame result = timed("radiometry", [&] {
        Frame result{CameraFrame(sensor, viewpoint),
                     objects,
                     radiometry(objects, wideband),
                     FrameBackground{},
                     {},
                     {},
                     {},
                     {},
                     {},
                     {}};
        drawBackground(result);
        fillRows(result);
        fillItems(result);
        planPoints(result);
        return result;
    });
    findDetails(result);
    return result;
}

SceneRadiometry Irsg::Parts::radiometry(const std::vector<ObjectGeometry>& objects,
                                        const WidebandTerms* wideband) const {
    if (wideband)
        return {environment, entities, objects, settings, centre(), *wideband};
    return {environment, entities, objects, settings, centre(), sensor.band};
}

const WidebandTerms& Irsg::Parts::terms() {
    WidebandSpectra spectra = widebandSpectraOf(entities);
    const auto found = std::ranges::find_if(widebandTerms, [&](const auto& kept) {
        return kept->areOf(environment, sensor.band, spectra);
    });
    if (found != widebandTerms.end()) {
        std::rotate(widebandTerms.begin(), found, found + 1);
    } else {
        auto made = timed("wideband terms", [&] {
            return std::make_unique<const WidebandTerms>(environment, sensor.band,
                                                         std::move(spectra));
        });
        widebandTerms.insert(widebandTerms.begin(), std::move(made));
        if (widebandTerms.size() > mostTermsKept)
            widebandTerms.pop_back();
    }
    return *widebandTerms.front();
}

void Irsg::Parts::drawBackground(Frame& frame) {
    const SceneRadiometry& radiometry = frame.radiometry;
    const BandSky sky(environment, radiometry.sampling());
    BackgroundSettings wanted;
    wanted.asksEnvironment = settings.background == BackgroundMode::environment;
    wanted.uniform_W_m2_sr = radiometry.backgroundInBand_W_m2_sr();
    wanted.rows = settings.backgroundRows;
    wanted.columns = settings.backgroundColumns;
    wanted.sunDisc = settings.sunDisc;
    wanted.skybox = settings.skybox;
    wanted.terrain = settings.terrain;
    frame.background = background.draw(sensor, viewpoint, sky, wanted, frame.backgroundReport);
}

bool Irsg::Parts::touchesTerrain(const ImageRectangle& extent) const {
    const std::vector<double>& coverage = background.layers().coverage;
    if (coverage.empty() || !settings.terrainHides)
        return false;
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

void Irsg::Parts::fillRows(Frame& frame) {
    const SceneRadiometry& radiometry = frame.radiometry;
    for (std::size_t row = 0; row < radiometry.surfaces().size(); ++row) {
        const SurfaceSpectra& surface = radiometry.surfaces()[row];
        auto inBand = [&](const std::vector<double>& term) {
            return static_cast<float>(radiometry.integrate(term));
        };
        const double t = radiometry.scalarTransmissivity(static_cast<int>(row));
        frame.scene.rows.push_back({inBand(surface.thermal), inBand(surface.up),
                                    inBand(surface.down), inBand(surface.sun), inBand(surface.path),
                                    static_cast<float>(1.0 - t),
                                    static_cast<float>(surface.nAngleFactor)});
    }
}

std::vector<ImageRectangle> Irsg::Parts::detailsOf(const Frame& frame, const CameraFrame& camera,
                                                   std::size_t entity) {
    std::vector<IrCodes> hot;
    for (std::size_t row = 0; row < frame.hot.size(); ++row)
        if (const auto& [e, codes] = frame.radiometry.keys()[row];
            frame.hot[row] && e == static_cast<int>(entity))
            hot.push_back(codes);
    std::vector<HotPart> parts =
        hotParts[entity].seenBy(camera, entities[entity].pose, drawItems[entity], hot);
    std::vector<ImageRectangle> details;
    if (parts.empty())
        return details;
    onContext([&](osg::RenderInfo& info) {
        FactorSamples samples;
        const SampleWindow probe = probeOf(parts, static_cast<int>(entity));
        SurfaceScene scene = sceneOf(frame, camera, probe);
        std::erase_if(scene.items, [](const SurfaceItem& item) { return item.transparent; });
        scene.occluders.clear();
        pass->drawFactors(info, scene, probe, true, samples);
        for (const HotPart& part : parts)
            if (!isHidden(part, probe, samples))
                details.push_back(part.extent);
    });
    return details;
}

void Irsg::Parts::findDetails(Frame& frame) {
    if (std::ranges::find(frame.hot, true) == frame.hot.end())
        return;
    const std::vector<double> view = fingerprint(frame);
    for (std::vector<ZoomEntityInfo>* objects : {&frame.seen, &frame.drawn})
        for (ZoomEntityInfo& object : *objects) {
            const auto e = static_cast<std::size_t>(object.entity);
            const bool isPoint = std::ranges::find(frame.points, object.entity,
                                                   &ZoomEntityInfo::entity) != frame.points.end();
            if (!isPoint || settings.truthLayers)
                object.details =
                    hotParts[e].details(view, [&] { return detailsOf(frame, frame.camera, e); });
        }
}

std::vector<ImageEdge> Irsg::Parts::edgesOf(const CameraFrame& camera, std::size_t entity) const {
    const Pose& pose = entities[entity].pose;
    std::vector<ImageEdge> seen;
    for (const ModelEdge& edge : longEdges[entity]) {
        const auto from = camera.placeOf(pose.toWorld(edge.from_m));
        const auto to = camera.placeOf(pose.toWorld(edge.to_m));
        if (from && to)
            seen.push_back({to->first - from->first, to->second - from->second});
    }
    return seen;
}

void Irsg::Parts::fillItems(Frame& frame) {
    frame.hot.assign(frame.radiometry.keys().size(), false);
    if (settings.hotParts && settings.zoomWindow > 0 &&
        settings.zoomStrategy == ZoomStrategy::aligned)
        frame.hot = hotSurfaces(frame.radiometry, entities);
    frame.scene.maximumLayers = settings.maximumLayers;
    frame.scene.modes = modes(frame.camera);
    for (std::size_t e = 0; e < entities.size(); ++e) {
        const Entity& entity = entities[e];
        const auto seen = zoomEntityInfo(static_cast<int>(e), frame.camera, entity.model->bounds(),
                                         balls[e], entity.pose);
        if (!seen)
            continue;
        frame.seen.push_back(*seen);
        frame.seen.back().edges = edgesOf(frame.camera, e);

        for (const DrawItem& item : drawItems[e]) {
            const int row = frame.radiometry.row(static_cast<int>(e), item.codes);
            const bool transparent =
                frame.radiometry.surfaces()[static_cast<std::size_t>(row)].isTransparent();
            frame.scene.items.push_back({item.geometry.get(), item.modelFromLocal,
                                         static_cast<int>(e), row, transparent, item.cullsBackFaces,
                                         item.layer});
        }
    }
}

int Irsg::Parts::largestDrawing() const {
    return std::min(largestSide, context.maximumTargetSize());
}

SurfaceScene Irsg::Parts::sceneOf(const Frame& frame, const CameraFrame& camera,
                                  const SampleWindow& window) const {
    const auto stands = [&](int entity) {
        return std::ranges::binary_search(window.entities, entity);
    };
    SurfaceScene scene;
    scene.camera = &camera;
    scene.modes = modes(camera);
    scene.rows = frame.scene.rows;
    scene.maximumLayers = frame.scene.maximumLayers;
    if (background.terrain() && settings.terrainHides)
        scene.occluders = background.terrain()->occluders(camera);
    std::optional<osg::Matrixd> eyeFromModel;
    int last = -1; // items of an entity follow one another
    for (const SurfaceItem& item : frame.scene.items)
        if (stands(item.entity)) {
            if (std::exchange(last, item.entity) != item.entity || !eyeFromModel)
                eyeFromModel =
                    camera.eyeFromModel(entities[static_cast<std::size_t>(item.entity)].pose);
            scene.items.push_back(item);
            scene.items.back().eyeFromLocal = item.eyeFromLocal * *eyeFromModel;
        }

    bool isFirst = true;
    for (int e : window.entities) {
        const Entity& entity = entities[static_cast<std::size_t>(e)];
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

FrameReduction Irsg::Parts::drawObjects(const Frame& frame, RenderReport& report) {
    AbstractZoomAntialiasingStrategy& strategy = antialiasing.strategyFor(settings);
    const auto finish = [&](FrameReduction& reduction) {
        for (const ZoomEntityInfo& object : frame.points)
            addPoint(frame, object, reduction);
        report.windows = sampledWindows(strategy.takeWindows(), frame.points);
    };
    if (frame.drawn.empty()) {
        FrameReduction reduction(sensor, {});
        finish(reduction);
        return reduction;
    }

    /// Draws with the surface pass and minds the time that takes.
    class SurfaceRttPass : public RttPass {
      public:
        SurfaceRttPass(Parts& parts, const Frame& frame, RenderReport& report,
                       osg::RenderInfo& info)
            : parts_(parts), frame_(frame), report_(report), info_(info) {}
        int largestSide() const override { return parts_.largestDrawing(); }
        void draw(const CameraFrame& camera, const SampleWindow& window,
                  RadianceSamples& samples) override {
            Stopwatch watch(seconds);
            parts_.pass->drawRadiance(info_, parts_.sceneOf(frame_, camera, window), window,
                                      samples);
            report_.layersLeftOver += samples.layersLeftOver;
        }
        double seconds = 0.0;

      private:
        Parts& parts_;
        const Frame& frame_;
        RenderReport& report_;
        osg::RenderInfo& info_;
    };

    double all_s = 0.0, drawing_s = 0.0;
    std::optional<FrameReduction> reduction;
    onContext([&](osg::RenderInfo& info) {
        Stopwatch watch(all_s);
        SurfaceRttPass rtt(*this, frame, report, info);
        reduction = strategy.draw(frame.camera, frame.drawn, rtt);
        drawing_s = rtt.seconds;
    });
    addTime("reduction", all_s - drawing_s);
    for (std::string& message : strategy.takeMessages())
        report.warnings.push_back(std::move(message));
    finish(*reduction);
    return std::move(*reduction);
}

std::vector<SampledWindow>
Irsg::Parts::sampledWindows(const std::vector<DrawnWindow>& drawn,
                            const std::vector<ZoomEntityInfo>& points) const {
    std::vector<SampledWindow> result;
    const auto tell = [&](const DrawnWindow& window) {
        const ImageRectangle& r = window.rectangle;
        SampledWindow& told = result.emplace_back(
            SampledWindow{r.left, r.top, r.right, r.bottom, window.across, window.down, {}});
        for (const int entity : window.entities) {
            const std::string& name = entities[static_cast<std::size_t>(entity)].name;
            told.objects += (told.objects.empty() ? "" : ", ") + name;
        }
    };
    for (const DrawnWindow& window : drawn)
        tell(window);
    for (const ZoomEntityInfo& point : points)
        tell({point.extent, 0.0, 0.0, {point.entity}});
    return result;
}

void Irsg::Parts::onContext(const std::function<void(osg::RenderInfo&)>& work) {
    context.run([&](osg::RenderInfo& info) {
        osg::flushAllDeletedGLObjects(info.getContextID());
        if (!pass)
            pass = std::make_unique<SurfacePass>();
        work(info);
    });
    addTime("drawing", pass->takeDrawSeconds());
    addTime("read back", pass->takeReadSeconds());
    addTime("layer sorting", pass->takeSortSeconds());
}

std::vector<double> Irsg::Parts::fingerprint(const Frame& frame) const {
    std::vector<double> numbers{static_cast<double>(sensor.width_px),
                                static_cast<double>(sensor.height_px),
                                sensor.horizontalFieldOfView_rad,
                                static_cast<double>(settings.zoomWindow),
                                static_cast<double>(settings.zoomStrategy),
                                static_cast<double>(settings.samplesPerAxis),
                                settings.samplesInAll ? 1.0 : 0.0,
                                settings.pointSourceBelow_px,
                                static_cast<double>(settings.maximumLayers),
                                settings.terrainHides ? 1.0 : 0.0,
                                static_cast<double>(frame.scene.modes.sun),
                                static_cast<double>(frame.scene.modes.flux)};
    auto add = [&](const Vec3& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); };
    add(viewpoint.position_m);
    add(viewpoint.right);
    add(viewpoint.up);
    add(frame.scene.modes.sunEye);
    for (const Entity& entity : entities) {
        add(entity.pose.position_m);
        const Attitude& a = entity.pose.attitude;
        add({a.yaw_rad, a.pitch_rad, a.roll_rad});
    }
    for (const SurfaceSpectra& surface : frame.radiometry.surfaces()) {
        numbers.push_back(surface.nAngleFactor);
        numbers.push_back(surface.isTransparent() ? 1.0 : 0.0);
    }
    numbers.insert(numbers.end(), frame.hot.begin(), frame.hot.end());
    return numbers;
}

const ProjectedFactors& Irsg::Parts::factorsOf(const Frame& frame) {
    std::vector<double> numbers = fingerprint(frame);
    std::vector<std::shared_ptr<const Model>> models;
    for (const Entity& entity : entities)
        models.push_back(entity.model);
    if (numbers == factorFingerprint && models == factorModels &&
        frame.background.variesLike(factorBackground))
        return factors;

    FactorAccumulator accumulator(sensor, frame.background, frame.radiometry);
    drawFactorWindows(frame, frame.drawn, false, "factor sums",
                      [&](const SampleWindow& window, const FactorSamples& samples) {
                          accumulator.add(window, samples);
                      });
    factors = accumulator.take();
    for (const ZoomEntityInfo& object : frame.points) {
        const PointPixel pixel = pixelOf(frame, object);
        const double behind_W_m2_sr =
            frame.background.isUniform() ? 0.0 : frame.background.at(pixel.x, pixel.y);
        for (const auto& [key, sums] : pointFactors(frame, object).sums)
            factors.sums[key] = atDistance(sums, pixel.distance_m, pixel.solidAngle_sr,
                                           pixel.cosOffAxis, behind_W_m2_sr);
    }
    factorFingerprint = std::move(numbers);
    factorModels = std::move(models);
    factorBackground = frame.background;
    return factors;
}

double Irsg::Parts::totalIrradiance_W_m2(const Frame& frame, const RenderReport& report) {
    const PixelGrid grid(sensor);
    if (!frame.background.isUniform()) {
        double behind_W_m2 = 0.0;
        for (int y = 0; y < sensor.height_px; ++y)
            for (int x = 0; x < sensor.width_px; ++x) {
                const PixelGrid::Pixel pixel = grid.at(x, y);
                behind_W_m2 += frame.background.at(x, y) * pixel.solidAngle_sr * pixel.cosOffAxis;
            }
        return report.all.irradiance_W_m2 + behind_W_m2;
    }
    const std::array<double, 3> raster{static_cast<double>(sensor.width_px),
                                       static_cast<double>(sensor.height_px),
                                       sensor.horizontalFieldOfView_rad};
    if (raster != frameRaster) {
        frameRaster = raster;
        frameProjectedSolidAngle_sr = grid.projectedSolidAngle_sr();
    }
    return report.all.irradiance_W_m2 + report.background_W_m2_sr * frameProjectedSolidAngle_sr;
}

void Irsg::Parts::addTruthLayers(const Frame& frame, RadianceImage& image) {
    TruthLayers truth(frame.radiometry, frame.background, image);
    drawFactorWindows(frame, frame.seen, true, "truth layers",
                      [&](const SampleWindow& window, const FactorSamples& samples) {
                          truth.add(window, samples);
                      });
}

void Irsg::Parts::fillReport(const Frame& frame, RenderReport& report) const {
    report.background_W_m2_sr = frame.background.centre_W_m2_sr();
    report.answeredBy = frame.radiometry.answeredBy();
    for (const std::string& line : frame.backgroundReport.answeredBy)
        if (std::ranges::find(report.answeredBy, line) == report.answeredBy.end())
            report.answeredBy.push_back(line);
    std::ranges::copy(frame.radiometry.warnings(), std::back_inserter(report.warnings));
    std::ranges::copy(frame.backgroundReport.warnings, std::back_inserter(report.warnings));
    report.flooredPixels = frame.backgroundReport.flooredPixels;
    if (report.flooredPixels > 0)
        report.warnings.push_back("the background of " + std::to_string(report.flooredPixels) +
                                  " pixels was below 0 and is 0 now");
    report.transmissivityResidue = frame.radiometry.transmissivityResidue();
    report.renderer = context.rendererDescription();
}

void Irsg::Parts::describe(const Frame& frame, RadianceImage& image) const {
    const SpectralRange& range = sensor.band.range();
    image.attributes["band.name"] = sensor.band.name();
    image.attributes["band.min_um"] = text(range.min_um);
    image.attributes["band.max_um"] = text(range.max_um);
    image.attributes["sensor.horizontal_field_of_view_deg"] =
        text(degrees(sensor.horizontalFieldOfView_rad));
    if (settings.zoomWindow > 0)
        image.attributes["zoom_window"] = std::to_string(settings.zoomWindow);
    else
        image.attributes["samples_per_axis"] = std::to_string(settings.samplesPerAxis);
    image.attributes["background_W_m2_sr"] = text(frame.background.centre_W_m2_sr());
    image.attributes["renderer"] = context.rendererDescription();
    if (!frame.geometry.empty())
        image.attributes["range_m"] = text(frame.geometry.front().path.range_m);
}

} // namespace irsg

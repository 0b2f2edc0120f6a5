#include <algorithm>
#include <cmath>
#include <future>
#include <optional>
#include <utility>

#include <osg/GLObjects>
#include <osg/RenderInfo>
#include <osg/State>

#include "irsg/scene/RendererParts.h"
#include "irsg/scene/draw/LayerSort.h"
#include "irsg/scene/radiance/TruthLayers.h"
#include "irsg/scene/sampling/PixelAlignedStrategy.h"

namespace irsg {

namespace {

/// Largest side of one drawing, samples: bounds the memory of the targets.
constexpr int largestSide = 2048;

void append(std::vector<double>& numbers, const Vec3& v) {
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

} // namespace

void Renderer::Parts::onContext(const std::function<void(osg::RenderInfo&)>& work) {
    context.run([&](osg::RenderInfo& info) {
        osg::flushAllDeletedGLObjects(info.getContextID());
        if (!pass)
            pass = std::make_unique<SurfacePass>();
        work(info);
    });
    addTime("drawing", pass->takeDrawSeconds());
    addTime("read back", pass->takeReadSeconds());
}

int Renderer::Parts::largestDrawing() const {
    return std::min(largestSide, context.maximumTargetSize());
}

FactorShader Renderer::Parts::factorShader(const Frame& frame, const CameraFrame& camera) const {
    FactorShader shader{terms.factorCount(), terms.glsl(frame.scene.settings), {}};
    for (const FrameDirection& direction : terms.directions)
        shader.directionsEye.emplace_back(
            direction.name, camera.toEye(direction.world(frame.scene.environment.sun)));
    return shader;
}

SurfaceScene Renderer::Parts::sceneOf(const Frame& frame, const CameraFrame& camera,
                                      const SampleWindow& window) {
    const auto stands = [&](int entity) {
        return std::ranges::binary_search(window.entities, entity);
    };
    SurfaceScene scene;
    scene.camera = &camera;
    scene.factors = factorShader(frame, camera);
    scene.rows = frame.rows;
    if (frame.scene.terrain && frame.scene.settings.terrainHides)
        scene.occluders = frame.scene.terrain->occluders(camera);
    std::optional<osg::Matrixd> eyeFromModel;
    int last = -1; // items of an entity follow one another
    for (const SurfaceItem& item : frame.items)
        if (stands(item.entity)) {
            if (std::exchange(last, item.entity) != item.entity || !eyeFromModel)
                eyeFromModel = camera.eyeFromModel(frame.entity(item.entity).pose);
            scene.items.push_back(item);
            scene.items.back().eyeFromLocal = item.eyeFromLocal * *eyeFromModel;
        }

    bool isFirst = true;
    for (int e : window.entities) {
        const Entity& entity = frame.entity(e);
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

FrameReduction Renderer::Parts::drawObjects(const Frame& frame, std::vector<SampledWindow>& windows,
                                            std::vector<std::string>& warnings,
                                            int& layersLeftOver) {
    AbstractZoomAntialiasingStrategy& strategy = antialiasing.strategyFor(frame.scene.settings);
    const auto finish = [&](FrameReduction& reduction) {
        for (const ZoomEntityInfo& object : frame.points)
            addPointToPixel(pointFactors(frame, object), frame.surfaceRows(),
                            placeOf(frame, object), frame.evaluated->radiances, reduction);
        windows = sampledWindows(frame, strategy.takeWindows());
    };
    if (frame.drawn.empty()) {
        FrameReduction reduction(frame.view.sensor, {});
        finish(reduction);
        return reduction;
    }

    /// Draws windows as radiances: as the shader adds them up, where one scale for each factor is
    /// all there is to know of a surface, else from factors.
    class SurfaceRttPass : public RttPass {
      public:
        SurfaceRttPass(Parts& parts, const Frame& frame, osg::RenderInfo& info)
            : parts_(parts),
              frame_(frame),
              info_(info),
              radiances_(frame.surfaceRows(), parts.fronts, frame.evaluated->radiances) {}
        int largestSide() const override { return parts_.largestDrawing(); }
        void draw(const CameraFrame& camera, const SampleWindow& window,
                  RadianceSamples& samples) override {
            Stopwatch watch(seconds);
            const SurfaceScene scene = parts_.sceneOf(frame_, camera, window);
            const bool isSliced = std::ranges::any_of(window.entities, [&](int e) {
                return frame_.geometry[static_cast<std::size_t>(e)].slices_m.size() > 1;
            });
            if (!isSliced && std::ranges::none_of(scene.items, &SurfaceItem::transparent))
                return parts_.pass->drawRadiance(info_, scene, window, samples);
            parts_.pass->drawFactors(info_, scene, window, isSliced, drawn_);
            {
                Stopwatch sorting(sortSeconds);
                gatherLayers(drawn_, frame_.scene.settings.maximumLayers, factors_);
            }
            Stopwatch evaluating(evaluateSeconds);
            radiances_.evaluate(factors_, samples);
            layersLeftOver += samples.layersLeftOver;
        }
        double seconds = 0.0, sortSeconds = 0.0, evaluateSeconds = 0.0;
        int layersLeftOver = 0;

      private:
        Parts& parts_;
        const Frame& frame_;
        osg::RenderInfo& info_;
        SampleRadiances radiances_;
        DrawnLayers drawn_;
        FactorSamples factors_;
    };

    double all_s = 0.0, drawing_s = 0.0, sorting_s = 0.0, evaluating_s = 0.0;
    std::optional<FrameReduction> reduction;
    onContext([&](osg::RenderInfo& info) {
        Stopwatch watch(all_s);
        SurfaceRttPass rtt(*this, frame, info);
        reduction = strategy.draw(frame.camera, frame.drawn, rtt);
        drawing_s = rtt.seconds;
        sorting_s = rtt.sortSeconds;
        evaluating_s = rtt.evaluateSeconds;
        layersLeftOver += rtt.layersLeftOver;
    });
    addTime("layer sorting", sorting_s);
    addTime("evaluation", evaluating_s);
    addTime("reduction", all_s - drawing_s);
    for (std::string& message : strategy.takeMessages())
        warnings.push_back(std::move(message));
    finish(*reduction);
    return std::move(*reduction);
}

FrameReduction Renderer::Parts::followedPixels(const Frame& frame,
                                               std::vector<SampledWindow>& windows,
                                               std::vector<std::string>& warnings,
                                               int& layersLeftOver) {
    // Points are not drawn here, and the published antialiasing resamples what it draws.
    const RenderSettings& settings = frame.scene.settings;
    const bool isSum = frame.points.empty() &&
                       (settings.zoomWindow == 0 || settings.zoomStrategy == ZoomStrategy::aligned);
    std::optional<ViewKey> key;
    if (isSum)
        key = viewKey(frame);
    if (!isSum || key != pixels.key) {
        pixels.key = std::move(key);
        pixels.factors.reset();
        return drawObjects(frame, windows, warnings, layersLeftOver);
    }

    const std::vector<SampleWindow> planned =
        antialiasing.strategyFor(settings).windows(frame.drawn);
    windows = sampledWindows(frame, DrawnWindow::of(planned));
    if (!pixels.factors) {
        FactorSums sums(frame.view.sensor, frame.surfaceRows(), fronts, terms.factorCount());
        pixels.factors = sums.emptyPixels();
        drawFactorWindows(frame, frame.drawn, frame.surfaceRows().isSliced(), "factors of pixels",
                          [&](const SampleWindow& window, const FactorSamples& samples) {
                              sums.addToPixels(window, samples, *pixels.factors);
                          });
    }
    FrameReduction reduction(frame.view.sensor, piecesOf(planned, largestDrawing()));
    timed("sums of pixels", [&] {
        addPixels(*pixels.factors, frame.view.sensor.width_px, frame.evaluated->radiances,
                  reduction);
    });
    return reduction;
}

std::vector<SampledWindow>
Renderer::Parts::sampledWindows(const Frame& frame, const std::vector<DrawnWindow>& drawn) const {
    std::vector<SampledWindow> result;
    const auto tell = [&](const DrawnWindow& window) {
        const ImageRectangle& r = window.rectangle;
        SampledWindow& told = result.emplace_back(
            SampledWindow{r.left, r.top, r.right, r.bottom, window.across, window.down, {}});
        for (const int entity : window.entities)
            told.objects += (told.objects.empty() ? "" : ", ") + frame.entity(entity).name;
    };
    for (const DrawnWindow& window : drawn)
        tell(window);
    for (const ZoomEntityInfo& point : frame.points)
        tell({point.extent, 0.0, 0.0, {point.entity}});
    return result;
}

void Renderer::Parts::drawFactorWindows(
    const Frame& frame, const std::vector<ZoomEntityInfo>& objects, bool withDistance,
    const char* stage, const std::function<void(const SampleWindow&, const FactorSamples&)>& sink) {
    if (objects.empty())
        return;
    const std::vector<SampleWindow> windows =
        piecesOf(antialiasing.strategyFor(frame.scene.settings).windows(objects), largestDrawing());
    // While one window is sorted and summed the next is drawn; what is drawn lies in two buffers.
    // Of the time beside a drawing only what drawing waits for counts.
    struct Seconds {
        double sorting = 0.0, sinking = 0.0;
    } beside, alone;
    double waited_s = 0.0;
    onContext([&](osg::RenderInfo& info) {
        DrawnLayers drawn[2];
        FactorSamples samples;
        std::future<void> summing;
        for (std::size_t i = 0; i < windows.size(); ++i) {
            DrawnLayers& own = drawn[i % 2];
            pass->drawFactors(info, sceneOf(frame, frame.camera, windows[i]), windows[i],
                              withDistance, own);
            if (summing.valid()) {
                Stopwatch watch(waited_s);
                summing.get();
            }
            const auto sum = [&, i](Seconds& seconds) {
                {
                    Stopwatch watch(seconds.sorting);
                    gatherLayers(own, frame.scene.settings.maximumLayers, samples);
                }
                Stopwatch watch(seconds.sinking);
                sink(windows[i], samples);
            };
            if (i + 1 < windows.size())
                summing = std::async(std::launch::async, sum, std::ref(beside));
            else
                sum(alone);
        }
    });
    const double all_s = beside.sorting + beside.sinking;
    const double part = all_s > 0.0 ? std::min(waited_s / all_s, 1.0) : 0.0;
    addTime("layer sorting", alone.sorting + part * beside.sorting);
    addTime(stage, alone.sinking + part * beside.sinking);
}

Renderer::Parts::ViewKey Renderer::Parts::viewKey(const Frame& frame) const {
    const RenderSettings& settings = frame.scene.settings;
    const Sensor& sensor = frame.view.sensor;
    ViewKey key;
    key.numbers = {static_cast<double>(sensor.width_px),
                   static_cast<double>(sensor.height_px),
                   sensor.horizontalFieldOfView_rad,
                   static_cast<double>(settings.zoomWindow),
                   static_cast<double>(settings.zoomStrategy),
                   static_cast<double>(settings.samplesPerAxis),
                   settings.samplesInAll ? 1.0 : 0.0,
                   settings.pointSourceBelow_px,
                   static_cast<double>(settings.maximumLayers),
                   settings.terrainHides ? 1.0 : 0.0};
    const Viewpoint& viewpoint = frame.view.viewpoint;
    for (const Vec3& v : {viewpoint.position_m, viewpoint.right, viewpoint.up})
        append(key.numbers, v);
    for (const FrameDirection& direction : terms.directions)
        append(key.numbers, direction.world(frame.scene.environment.sun));
    for (const Entity& entity : frame.scene.entities) {
        append(key.numbers, entity.pose.position_m);
        const Attitude& a = entity.pose.attitude;
        append(key.numbers, {a.yaw_rad, a.pitch_rad, a.roll_rad});
        key.models.push_back(entity.model);
    }
    for (const SurfaceRow& row : frame.rows)
        key.numbers.push_back(static_cast<double>(row.nAngleFactor));
    key.numbers.insert(key.numbers.end(), frame.hot.begin(), frame.hot.end());
    key.terrain = frame.scene.terrain;
    key.rows = frame.surfaceRows();
    key.shader = terms.glsl(settings);
    return key;
}

std::vector<const FrameBackground*> Renderer::Parts::varyingBackgrounds(const Frame& frame) {
    std::vector<const FrameBackground*> varying;
    for (const FrameBackground& background : frame.backgrounds)
        if (!background.isUniform())
            varying.push_back(&background);
    return varying;
}

const ViewFactors& Renderer::Parts::factorsOf(const Frame& frame) {
    ViewKey key = viewKey(frame);
    const std::vector<const FrameBackground*> varying = varyingBackgrounds(frame);
    const bool sameBackgrounds = std::ranges::equal(
        varying, view.varying,
        [](const FrameBackground* a, const FrameBackground& b) { return a->variesLike(b); });
    if (view.key == key && sameBackgrounds)
        return view.factors;

    view.key.reset();
    FactorSums sums(frame.view.sensor, frame.surfaceRows(), fronts, terms.factorCount(), varying);
    view.factors = sums.emptyView();
    drawFactorWindows(frame, frame.drawn, frame.surfaceRows().isSliced(), "factor sums",
                      [&](const SampleWindow& window, const FactorSamples& samples) {
                          sums.addToView(window, samples, view.factors);
                      });
    for (const ZoomEntityInfo& object : frame.points)
        addPointToView(pointFactors(frame, object), frame.surfaceRows(), placeOf(frame, object),
                       varying, view.factors);
    view.varying.clear();
    for (const FrameBackground* background : varying)
        view.varying.push_back(*background);
    view.key = std::move(key);
    return view.factors;
}

PointPlace Renderer::Parts::placeOf(const Frame& frame, const ZoomEntityInfo& object) const {
    const ImageRectangle& extent = object.extent;
    const int x = static_cast<int>(0.5 * (extent.left + extent.right));
    const int y = static_cast<int>(0.5 * (extent.top + extent.bottom));
    const PixelGrid::Pixel pixel = PixelGrid(frame.view.sensor).at(x, y);
    return {x, y, length(object.centre_m - frame.view.viewpoint.position_m), pixel.solidAngle_sr,
            pixel.cosOffAxis};
}

const FactorField<double>& Renderer::Parts::pointFactors(const Frame& frame,
                                                         const ZoomEntityInfo& object) {
    const Entity& entity = frame.entity(object.entity);
    const RenderSettings& settings = frame.scene.settings;
    const SurfaceRows& rows = frame.surfaceRows();
    const Rotation toWorld = entity.pose.attitude.rotation();
    const Rotation toModel = toWorld.transposed();
    const Vec3 from = PointSources::onGrid(
        toModel * normalized(frame.view.viewpoint.position_m - object.centre_m));
    PointAspect aspect{
        entity.model,
        {static_cast<double>(settings.zoomWindow), static_cast<double>(settings.maximumLayers)},
        terms.glsl(settings)};
    append(aspect.numbers, from);
    for (const FrameDirection& direction : terms.directions)
        append(aspect.numbers, toModel * direction.world(frame.scene.environment.sun));
    for (std::size_t row = 0; row < rows.keys().size(); ++row) {
        // Rows are numbered through the scene.
        aspect.numbers.push_back(rows.keys()[row].first);
        if (rows.keys()[row].first == object.entity) {
            aspect.numbers.push_back(static_cast<double>(frame.rows[row].nAngleFactor));
            aspect.numbers.push_back(rows.isTransparent(static_cast<int>(row)) ? 1.0 : 0.0);
            aspect.numbers.push_back(frame.hot[row] ? 1.0 : 0.0);
        }
    }

    const double distance_m = PointSources::cameraDistance_radii * object.radius_m;
    return pointSources.sums_sr_m2(object.entity, aspect, [&] {
        // A few pixels of a camera that looks at it from far. No phases average its error, so its
        // window is larger than that of other objects, but not by much: one that turns is drawn
        // anew for every frame.
        Sensor few = frame.view.sensor;
        few.width_px = few.height_px = 4;
        few.horizontalFieldOfView_rad = 2.0 * std::asin(1.0 / PointSources::cameraDistance_radii);
        const Vec3 place = object.centre_m + toWorld * from * distance_m;
        const CameraFrame zoom(few,
                               Viewpoint::lookAt(place, object.centre_m, toWorld * Vec3{0, 0, 1},
                                                 toWorld * Vec3{0, 1, 0}));
        auto seen = zoomEntityInfo(object.entity, zoom, entity.model->bounds(),
                                   prepared.of(entity).ball, entity.pose);
        // Rows as they are drawn: the air is no matter here.
        std::vector<bool> transparent;
        for (std::size_t row = 0; row < rows.keys().size(); ++row)
            transparent.push_back(rows.isTransparent(static_cast<int>(row)));
        const SurfaceRows drawnRows(rows.keys(), std::move(transparent),
                                    std::vector<SliceNodes>(frame.scene.entities.size()));
        FactorSums sums(few, drawnRows, fronts, terms.factorCount());
        ViewFactors view = sums.emptyView();
        if (seen) {
            seen->details = detailsOf(frame, zoom, object.entity);
            seen->edges = edgesOf(frame, zoom, object.entity);
            onContext([&](osg::RenderInfo& info) {
                DrawnLayers drawn;
                FactorSamples samples;
                const PixelAlignedStrategy strategy(settings.zoomWindow * 3 / 2);
                for (const SampleWindow& window :
                     piecesOf(strategy.windows({*seen}), largestDrawing())) {
                    SurfaceScene alone = sceneOf(frame, zoom, window);
                    alone.occluders.clear(); // no terrain is before a point as the sensor sees it
                    pass->drawFactors(info, alone, window, false, drawn);
                    gatherLayers(drawn, settings.maximumLayers, samples);
                    sums.addToView(window, samples, view);
                }
            });
        }
        FactorField<double> atUnitDistance(1, terms.factorCount() + 1);
        view.field.forEach(0, [&](std::size_t kind, std::span<const double> numbers) {
            double* own = atUnitDistance.at(0, atUnitDistance.kindOf(view.field.kinds()[kind]));
            for (std::size_t i = 0; i < atUnitDistance.width(); ++i)
                own[i] = numbers[i] * distance_m * distance_m;
        });
        return atUnitDistance;
    });
}

void Renderer::Parts::addTruthLayers(const Frame& frame, RadianceImage& image) {
    TruthLayers truth(frame.evaluated->radiometry, frame.evaluated->radiances, fronts,
                      frame.backgrounds.front(), image);
    drawFactorWindows(frame, frame.seen, true, "truth layers",
                      [&](const SampleWindow& window, const FactorSamples& samples) {
                          truth.add(window, samples);
                      });
}

} // namespace irsg

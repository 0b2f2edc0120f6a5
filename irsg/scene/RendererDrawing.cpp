#include <algorithm>
#include <optional>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/radiance/SampleRadiances.h"
#include "irsg/radiance/TruthLayers.h"
#include "irsg/render/sampling/LayerSort.h"
#include "irsg/render/sampling/PixelAlignedStrategy.h"
#include "irsg/render/sampling/SampleSheet.h"
#include "irsg/scene/RendererImpl.h"

namespace irsg {

void Renderer::Impl::onEngine(const Frame& frame, const std::function<void()>& work) {
    double waited_s = 0.0, drawing_s = 0.0, reading_s = 0.0;
    {
        auto waiting = std::make_unique<Stopwatch>(waited_s);
        frame.engine->run([&] {
            waiting.reset(); // for drawings that were begun before
            work();
            drawing_s = frame.engine->takeDrawSeconds();
            reading_s = frame.engine->takeReadSeconds();
        });
    }
    addTime("drawing", waited_s + drawing_s);
    addTime("read back", reading_s);
}

FactorMaking Renderer::Impl::factorMaking(const Frame& frame, const CameraFrame& camera) const {
    const bool withNormals = frame.lobes != nullptr;
    FactorMaking making{terms.factorCount() + (withNormals ? normalFactors : 0),
                        terms.glsl(frame.scene.settings, withNormals),
                        {},
                        {},
                        {}};
    if (making.factorCount > mostFactors)
        throw LogicError("more factors than there is room for beside the normals of surfaces");
    if (usesRays(frame))
        making.functions = terms.functions(frame.scene.settings, withNormals);
    if (frame.shadows)
        making.shadowedFrom = terms.shadowedFrom(frame.scene.settings);
    for (const FrameDirection& direction : terms.directions)
        making.directionsEye.emplace_back(
            direction.name, camera.toEye(direction.world(frame.scene.environment.sun)));
    return making;
}

SurfaceScene Renderer::Impl::sceneOf(const Frame& frame, const CameraFrame& camera,
                                     const SampleWindow& window) {
    const auto stands = [&](int entity) {
        return std::ranges::binary_search(window.entities, entity);
    };
    SurfaceScene scene;
    scene.camera = &camera;
    scene.factors = factorMaking(frame, camera);
    scene.rows = frame.rows;
    if (frame.scene.terrain && frame.scene.settings.terrainHides) {
        scene.occluders = frame.scene.terrain->occluders(camera);
        if (frame.terrainMesh)
            scene.terrain = {-1, frame.terrainMesh,
                             camera.eyeFromModel(frame.scene.terrain->pose())};
    }
    std::optional<osg::Matrixd> eyeFromModel;
    int last = -1; // items of an entity follow one another
    for (const SurfaceItem& item : frame.items)
        if (stands(item.entity)) {
            if (std::exchange(last, item.entity) != item.entity || !eyeFromModel) {
                eyeFromModel = camera.eyeFromModel(frame.entity(item.entity).pose);
                if (!frame.meshes.empty())
                    scene.bodies.push_back({item.entity,
                                            frame.meshes[static_cast<std::size_t>(item.entity)],
                                            *eyeFromModel});
            }
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

SheetScene Renderer::Impl::scenesOf(const Frame& frame, const CameraFrame& camera,
                                    const SampleSheet& sheet) {
    SheetScene result{sheet, {}};
    for (const SampleWindow& window : sheet.windows)
        result.scenes.push_back(sceneOf(frame, camera, window));
    return result;
}

FrameReduction Renderer::Impl::drawObjects(const Frame& frame, std::vector<SampledWindow>& windows,
                                           std::vector<std::string>& warnings,
                                           int& layersLeftOver) {
    AbstractZoomAntialiasingStrategy& strategy = antialiasing.strategyFor(frame.scene.settings);
    const auto finish = [&](FrameReduction& reduction) {
        for (const ZoomEntityInfo& object : frame.points)
            addPointToPixel(pointFactors(frame, object), frame.surfaceRows(),
                            placeOf(frame, object), frame.evaluated->radiances, frame.light.get(),
                            reduction);
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
        SurfaceRttPass(Impl& parts, const Frame& frame)
            : impl_(parts),
              frame_(frame),
              radiances_(frame.surfaceRows(), parts.fronts, frame.evaluated->radiances,
                         frame.light.get()) {}
        int largestSide() const override { return frame_.engine->largestSide(); }
        void draw(const CameraFrame& camera, const SampleSheet& sheet,
                  RadianceSamples& samples) override {
            Stopwatch watch(seconds);
            const SheetScene scene = impl_.scenesOf(frame_, camera, sheet);
            const auto isSlicedIn = [&](const SampleWindow& window) {
                return std::ranges::any_of(window.entities, [&](int e) {
                    return frame_.geometry[static_cast<std::size_t>(e)].slices_m.size() > 1;
                });
            };
            const bool isSliced = std::ranges::any_of(sheet.windows, isSlicedIn);
            if (!isSliced && !isShaded(frame_) &&
                std::ranges::none_of(scene.scenes, &SurfaceScene::hasTransparent))
                return frame_.engine->drawRadiance(scene, samples);
            FactorSamples& factors = impl_.pictureFactors;
            frame_.engine->drawFactors(scene, isSliced || isShaded(frame_), factors);
            {
                Stopwatch sorting(sortSeconds);
                impl_.sortAndShade(frame_, scene, factors);
            }
            Stopwatch evaluating(evaluateSeconds);
            radiances_.evaluate(factors, samples);
            if (factors.size() > mostSamplesKept)
                factors = {};
            layersLeftOver += samples.layersLeftOver;
        }
        double seconds = 0.0, sortSeconds = 0.0, evaluateSeconds = 0.0;
        int layersLeftOver = 0;

      private:
        Impl& impl_;
        const Frame& frame_;
        SampleRadiances radiances_;
    };

    double all_s = 0.0, drawing_s = 0.0, sorting_s = 0.0, evaluating_s = 0.0;
    std::optional<FrameReduction> reduction;
    onEngine(frame, [&] {
        Stopwatch watch(all_s);
        SurfaceRttPass rtt(*this, frame);
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

FrameReduction Renderer::Impl::followedPixels(const Frame& frame,
                                              std::vector<SampledWindow>& windows,
                                              std::vector<std::string>& warnings,
                                              int& layersLeftOver) {
    // Points are not drawn here, and the published antialiasing resamples what it draws.
    const RenderSettings& settings = frame.scene.settings;
    const bool isSum = frame.points.empty() && !settings.zoomsAsPublished();
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
        FactorSums sums(frame.view.sensor, frame.surfaceRows(), fronts, terms.factorCount(), {},
                        frame.exchange);
        pixels.factors = sums.emptyPixels();
        drawFactorWindows(frame, frame.drawn, frame.surfaceRows().isSliced(), "factors of pixels",
                          [&](const SampleWindow& window, const FactorSamples& samples) {
                              sums.addToPixels(window, samples, *pixels.factors);
                          });
    }
    FrameReduction reduction(frame.view.sensor, piecesOf(planned, frame.engine->largestSide()));
    timed("sums of pixels", [&] {
        addPixels(*pixels.factors, frame.view.sensor.width_px, frame.evaluated->radiances,
                  frame.light.get(), reduction);
    });
    return reduction;
}

std::vector<SampledWindow>
Renderer::Impl::sampledWindows(const Frame& frame, const std::vector<DrawnWindow>& drawn) const {
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

std::future<WindowStream::Seconds>
Renderer::Impl::beginWindows(const Frame& frame, const std::vector<SampleWindow>& windows,
                             bool withDistance, TakeWindow take) {
    const int side = frame.engine->largestSide();
    auto planned = std::make_shared<const std::vector<SampleSheet>>(
        windows.empty() ? std::vector<SampleSheet>{} : sheetsOf(piecesOf(windows, side), side));
    WindowStream::Work work;
    work.drawings = planned->size();
    work.maximumLayers = frame.scene.settings.maximumLayers;
    work.draw = [this, &frame, planned, withDistance](std::size_t i, FactorSamples& samples,
                                                      WindowStream::Seconds& seconds) {
        SampleEngine& engine = *frame.engine;
        engine.drawFactors(scenesOf(frame, frame.camera, (*planned)[i]),
                           withDistance || isShaded(frame), samples);
        seconds.drawing += engine.takeDrawSeconds();
        seconds.reading += engine.takeReadSeconds();
    };
    if (isShaded(frame))
        work.shade = [this, &frame, planned](std::size_t i, FactorSamples& samples) {
            shade(frame, scenesOf(frame, frame.camera, (*planned)[i]), samples);
        };
    work.take = [planned, take = std::move(take)](std::size_t i, const FactorSamples& samples) {
        for (const SampleWindow& window : (*planned)[i].windows)
            take(window, samples);
    };
    return stream.start(*frame.engine, std::move(work));
}

void Renderer::Impl::waitFor(std::future<WindowStream::Seconds>& drawn, const char* stage) {
    WindowStream::Seconds seconds;
    double waited_s = 0.0;
    {
        Stopwatch watch(waited_s);
        seconds = drawn.get();
    }
    const double all_s =
        seconds.drawing + seconds.reading + seconds.sorting + seconds.shading + seconds.taking;
    if (!(all_s > 0.0))
        return; // nothing was drawn
    const double part = waited_s / all_s;
    addTime("drawing", part * seconds.drawing);
    addTime("read back", part * seconds.reading);
    addTime("layer sorting", part * seconds.sorting);
    if (seconds.shading > 0.0)
        addTime("sun shadows", part * seconds.shading);
    addTime(stage, part * seconds.taking);
}

void Renderer::Impl::drawFactorWindows(const Frame& frame,
                                       const std::vector<ZoomEntityInfo>& objects,
                                       bool withDistance, const char* stage, TakeWindow take) {
    if (objects.empty())
        return;
    auto drawn =
        beginWindows(frame, antialiasing.strategyFor(frame.scene.settings).windows(objects),
                     withDistance, std::move(take));
    waitFor(drawn, stage);
}

void Renderer::Impl::addTruthLayers(const Frame& frame, RadianceImage& image) {
    TruthLayers truth(frame.evaluated->radiometry, frame.evaluated->radiances, fronts,
                      frame.backgrounds.front(), frame.light.get(), image);
    drawFactorWindows(frame, frame.seen, true, "truth layers",
                      [&](const SampleWindow& window, const FactorSamples& samples) {
                          truth.add(window, samples);
                      });
}

} // namespace irsg

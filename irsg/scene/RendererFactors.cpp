#include <algorithm>
#include <utility>

#include "irsg/scene/RendererImpl.h"

namespace irsg {

namespace {

std::vector<const FrameBackground*> pointersTo(const std::vector<FrameBackground>& backgrounds) {
    std::vector<const FrameBackground*> pointers;
    for (const FrameBackground& background : backgrounds)
        pointers.push_back(&background);
    return pointers;
}

} // namespace

Renderer::Impl::ViewKey Renderer::Impl::viewKey(const Frame& frame) const {
    const RenderSettings& settings = frame.scene.settings;
    const Sensor& sensor = frame.view.sensor;
    ViewKey key;
    key.numbers = {static_cast<double>(sensor.width_px),
                   static_cast<double>(sensor.height_px),
                   sensor.horizontalFieldOfView_rad,
                   static_cast<double>(settings.zoomWindow),
                   static_cast<double>(settings.zoomStrategy),
                   static_cast<double>(settings.samplesPerAxis),
                   settings.countsPerPixel ? 1.0 : 0.0,
                   settings.pointSourceBelow_px,
                   static_cast<double>(settings.maximumLayers),
                   settings.terrainHides ? 1.0 : 0.0,
                   usesRays(frame) ? 1.0 : 0.0,
                   frame.withErrors ? 1.0 : 0.0,
                   frame.shadows ? static_cast<double>(settings.sunShadows) : 0.0};
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
    if (frame.shadows)
        key.numbers.insert(key.numbers.end(), frame.shadows->reflects().begin(),
                           frame.shadows->reflects().end());
    appendReceivers(frame, key.numbers);
    appendLobes(frame, key.numbers);
    for (const ZoomEntityInfo& object : frame.alongRange)
        key.numbers.push_back(static_cast<double>(object.entity));
    key.terrain = frame.scene.terrain;
    key.rows = frame.surfaceRows();
    key.shader = terms.glsl(settings);
    return key;
}

std::vector<SampleWindow> Renderer::Impl::windowsOfSums(const Frame& frame) {
    if (frame.drawn.empty())
        return {};
    return antialiasing.strategyFor(frame.scene.settings).windowsOfSums(frame.drawn);
}

bool Renderer::Impl::sumsSampleAsPictures(const Frame& frame) {
    return frame.drawn.empty() ||
           windowsOfSums(frame) ==
               antialiasing.strategyFor(frame.scene.settings).windows(frame.drawn);
}

std::shared_ptr<Renderer::Impl::FactorDrawing> Renderer::Impl::beginFactors(const Frame& frame) {
    ViewKey key = viewKey(frame);
    std::vector<FrameBackground> varying;
    for (const FrameBackground& background : frame.backgrounds)
        if (!background.isUniform())
            varying.push_back(background);
    const auto variesAlike = [](const FrameBackground& a, const FrameBackground& b) {
        return a.variesLike(b);
    };
    if (view && view->key == key && std::ranges::equal(varying, view->varying, variesAlike))
        return view;

    view.reset();
    auto drawing = std::make_shared<FactorDrawing>();
    drawing->key = std::move(key);
    drawing->varying = std::move(varying);
    drawing->sums.emplace(frame.view.sensor, drawing->key.rows, drawing->fronts,
                          terms.factorCount(), pointersTo(drawing->varying), frame.exchange,
                          frame.withErrors);
    drawing->factors = drawing->sums->emptyView();
    // The drawing outlives what is begun here: it waits for that when it goes.
    drawing->windows = beginWindows(
        frame, windowsOfSums(frame), frame.surfaceRows().isSliced(),
        [own = drawing.get()](const SampleWindow& window, const FactorSamples& samples) {
            own->sums->addToView(window, samples, own->factors);
        });
    return view = drawing;
}

const ViewFactors& Renderer::Impl::factorsOf(const Frame& frame, FactorDrawing& drawing) {
    if (drawing.failure)
        std::rethrow_exception(drawing.failure);
    if (!drawing.windows.valid())
        return drawing.factors;
    try {
        waitFor(drawing.windows, "factor sums");
        ViewFactors own = std::exchange(drawing.factors, drawing.sums->emptyView());
        drawing.factors.layersLeftOver = own.layersLeftOver;
        const auto take = [&](ViewFactors& from, ViewFactors& to) {
            for (auto& [kind, sums] : from.light)
                to.light[{fronts.numberOf(drawing.fronts.materials(kind.first)), kind.second}] =
                    std::move(sums);
            to.field.add(
                from.field, [](std::size_t) { return std::size_t{0}; },
                [&](int front) { return fronts.numberOf(drawing.fronts.materials(front)); });
        };
        take(own, drawing.factors);
        for (std::size_t k = 0; k < own.contrasts.size(); ++k)
            take(own.contrasts[k], drawing.factors.contrasts[k]);
        for (const ZoomEntityInfo& object : frame.points)
            addPointToView(pointFactors(frame, object), frame.surfaceRows(), placeOf(frame, object),
                           pointersTo(drawing.varying), drawing.factors);
        for (const ZoomEntityInfo& object : frame.alongRange)
            addAlongRange(frame, object, drawing.factors);
    } catch (...) {
        drawing.failure = std::current_exception();
        view.reset(); // the next one tries again
        throw;
    }
    return drawing.factors;
}

const ViewFactors& Renderer::Impl::factorsOf(const Frame& frame) {
    return factorsOf(frame, *beginFactors(frame));
}

} // namespace irsg

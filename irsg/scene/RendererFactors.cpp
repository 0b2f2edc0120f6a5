#include <algorithm>
#include <cmath>
#include <utility>

#include <osg/RenderInfo>

#include "irsg/scene/RendererParts.h"
#include "irsg/scene/draw/LayerSort.h"
#include "irsg/scene/sampling/PixelAlignedStrategy.h"

namespace irsg {

namespace {

void append(std::vector<double>& numbers, const Vec3& v) {
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

std::vector<const FrameBackground*> pointersTo(const std::vector<FrameBackground>& backgrounds) {
    std::vector<const FrameBackground*> pointers;
    for (const FrameBackground& background : backgrounds)
        pointers.push_back(&background);
    return pointers;
}

} // namespace

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

std::shared_ptr<Renderer::Parts::FactorDrawing> Renderer::Parts::beginFactors(const Frame& frame) {
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
                          terms.factorCount(), pointersTo(drawing->varying));
    drawing->factors = drawing->sums->emptyView();
    // The drawing outlives what is begun here: it waits for that when it goes.
    drawing->windows = beginWindows(
        frame, frame.drawn, frame.surfaceRows().isSliced(),
        [own = drawing.get()](const SampleWindow& window, const FactorSamples& samples) {
            own->sums->addToView(window, samples, own->factors);
        });
    return view = drawing;
}

const ViewFactors& Renderer::Parts::factorsOf(const Frame& frame, FactorDrawing& drawing) {
    if (drawing.failure)
        std::rethrow_exception(drawing.failure);
    if (!drawing.windows.valid())
        return drawing.factors;
    try {
        waitFor(drawing.windows, "factor sums");
        ViewFactors own = std::exchange(drawing.factors, drawing.sums->emptyView());
        drawing.factors.layersLeftOver = own.layersLeftOver;
        drawing.factors.field.add(
            own.field, [](std::size_t) { return std::size_t{0}; },
            [&](int front) { return fronts.numberOf(drawing.fronts.materials(front)); });
        for (const ZoomEntityInfo& object : frame.points)
            addPointToView(pointFactors(frame, object), frame.surfaceRows(), placeOf(frame, object),
                           pointersTo(drawing.varying), drawing.factors);
    } catch (...) {
        drawing.failure = std::current_exception();
        view.reset(); // the next one tries again
        throw;
    }
    return drawing.factors;
}

const ViewFactors& Renderer::Parts::factorsOf(const Frame& frame) {
    return factorsOf(frame, *beginFactors(frame));
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
                FactorSamples samples;
                const PixelAlignedStrategy strategy(settings.zoomWindow * 3 / 2);
                for (const SampleWindow& window :
                     piecesOf(strategy.windows({*seen}), largestDrawing())) {
                    SurfaceScene alone = sceneOf(frame, zoom, window);
                    alone.occluders.clear(); // no terrain is before a point as the sensor sees it
                    pass->drawFactors(info, alone, window, false, samples);
                    sortLayers(samples, settings.maximumLayers);
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

} // namespace irsg

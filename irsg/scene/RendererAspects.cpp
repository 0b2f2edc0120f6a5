#include <algorithm>
#include <cmath>

#include "irsg/render/sampling/LayerSort.h"
#include "irsg/render/sampling/PixelAlignedStrategy.h"
#include "irsg/scene/RendererImpl.h"

namespace irsg {

namespace {

/// The rows of a frame as they are drawn, without or with slices of one entity alone.
SurfaceRows drawnRows(const SurfaceRows& rows, std::size_t entities, int sliced = -1,
                      SliceNodes slices_m = {}) {
    std::vector<bool> transparent;
    for (std::size_t row = 0; row < rows.keys().size(); ++row)
        transparent.push_back(rows.isTransparent(static_cast<int>(row)));
    std::vector<SliceNodes> slices(entities);
    if (sliced >= 0)
        slices[static_cast<std::size_t>(sliced)] = std::move(slices_m);
    return {rows.keys(), transparent, std::move(slices), rows.lobes()};
}

/// Slices about a distance of what reaches so far before and behind it.
SliceNodes slicesAbout(double distance_m, double reach_m) {
    SliceNodes slices_m;
    for (std::size_t i = 0; i <= RangeFactors::slices; ++i) {
        const double part = static_cast<double>(i) / RangeFactors::slices;
        slices_m.push_back(distance_m + (2.0 * part - 1.0) * reach_m);
    }
    return slices_m;
}

/// A view of one object from far away, as it is at unit distance.
PointFactors pointOf(const ViewFactors& view, double distance_m) {
    PointFactors point{FactorField<double>(1, view.layout.factorCount + 1), {}, {}};
    FactorField<double>& field = point.sums_sr_m2;
    view.field.forEach(0, [&](std::size_t kind, std::span<const double> numbers) {
        double* own = field.at(0, field.kindOf(view.field.kinds()[kind]));
        for (std::size_t i = 0; i < field.width(); ++i)
            own[i] = numbers[i] * distance_m * distance_m;
    });
    addLight(view.light, distance_m * distance_m, point.light_sr_m2);
    for (const ViewFactors& contrast : view.contrasts)
        point.contrasts.push_back(pointOf(contrast, distance_m));
    return point;
}

/// A view of one object as it is at unit distance, in pixels 1 m wide there.
ViewFactors atUnitDistance(const ViewFactors& view, double distance_m, double pixel_sr) {
    ViewFactors unit{
        view.layout, FactorField<double>(1, view.layout.width()), {}, view.layersLeftOver, {}};
    const double square_m2 = distance_m * distance_m;
    addLight(view.light, square_m2, unit.light);
    view.field.forEach(0, [&](std::size_t kind, std::span<const double> numbers) {
        double* sums = unit.field.at(0, unit.field.kindOf(view.field.kinds()[kind]));
        for (std::size_t i = 0; i < numbers.size(); ++i)
            sums[i] = numbers[i] * square_m2;
        sums[view.layout.pixels()] *= pixel_sr;
    });
    for (const ViewFactors& contrast : view.contrasts)
        unit.contrasts.push_back(atUnitDistance(contrast, distance_m, pixel_sr));
    return unit;
}

} // namespace

PointAspect Renderer::Impl::aspectOf(const Frame& frame, int entity, const Vec3& from) const {
    const RenderSettings& settings = frame.scene.settings;
    const SurfaceRows& rows = frame.surfaceRows();
    const Rotation toModel = frame.entity(entity).pose.attitude.rotation().transposed();
    PointAspect aspect{frame.entity(entity).model,
                       {static_cast<double>(settings.zoomWindow),
                        static_cast<double>(settings.maximumLayers), usesRays(frame) ? 1.0 : 0.0},
                       terms.glsl(settings)};
    append(aspect.numbers, from);
    aspect.numbers.push_back(frame.withErrors ? 1.0 : 0.0);
    aspect.numbers.push_back(frame.shadows ? static_cast<double>(settings.sunShadows) : 0.0);
    appendReceivers(frame, aspect.numbers);
    appendLobes(frame, aspect.numbers);
    if (frame.shadows)
        aspect.numbers.insert(aspect.numbers.end(), frame.shadows->reflects().begin(),
                              frame.shadows->reflects().end());
    // Others may stand between it and the sun.
    for (const Entity& other : frame.scene.entities)
        if (frame.shadows && (frame.scene.entities.size() > 1 || frame.scene.terrain)) {
            append(aspect.numbers, other.pose.position_m);
            const Attitude& a = other.pose.attitude;
            append(aspect.numbers, {a.yaw_rad, a.pitch_rad, a.roll_rad});
        }
    for (const FrameDirection& direction : terms.directions)
        append(aspect.numbers, toModel * direction.world(frame.scene.environment.sun));
    for (std::size_t row = 0; row < rows.keys().size(); ++row) {
        // Rows are numbered through the scene.
        aspect.numbers.push_back(rows.keys()[row].first);
        if (rows.keys()[row].first == entity) {
            aspect.numbers.push_back(static_cast<double>(frame.rows[row].nAngleFactor));
            aspect.numbers.push_back(rows.isTransparent(static_cast<int>(row)) ? 1.0 : 0.0);
            aspect.numbers.push_back(frame.hot[row] ? 1.0 : 0.0);
        }
    }
    return aspect;
}

ViewFactors Renderer::Impl::drawAlone(const Frame& frame, int entity, const CameraFrame& camera,
                                      int zoomWindow, const SurfaceRows& rows) {
    const Entity& own = frame.entity(entity);
    FactorSums sums(camera.sensor(), rows, fronts, terms.factorCount(), {}, frame.exchange,
                    frame.withErrors);
    ViewFactors view = sums.emptyView();
    auto seen = zoomEntityInfo(entity, camera, own.model->bounds(), prepared.of(own).boundingSphere,
                               own.pose);
    if (!seen)
        return view;
    seen->details = detailsOf(frame, camera, entity);
    seen->edges = edgesOf(frame, camera, entity);
    onEngine(frame, [&] {
        FactorSamples samples;
        const PixelAlignedStrategy strategy(zoomWindow);
        for (const SampleWindow& window :
             piecesOf(strategy.windows({*seen}), frame.engine->largestSide())) {
            SurfaceScene alone = sceneOf(frame, camera, window);
            alone.occluders.clear();
            alone.terrain = {};
            frame.engine->drawFactors({SampleSheet::of(window), {alone}},
                                      rows.isSliced() || isShaded(frame), samples);
            timed("layer sorting", [&] {
                sortAndShade(frame, {SampleSheet::of(window), {alone}}, samples);
            });
            timed("factor sums", [&] { sums.addToView(window, samples, view); });
        }
    });
    return view;
}

PointPlace Renderer::Impl::placeOf(const Frame& frame, const ZoomEntityInfo& object) const {
    const ImageRectangle& extent = object.extent;
    const int x = static_cast<int>(0.5 * (extent.left + extent.right));
    const int y = static_cast<int>(0.5 * (extent.top + extent.bottom));
    const PixelGrid::Pixel pixel = PixelGrid(frame.view.sensor).at(x, y);
    return {x, y, length(object.centre_m - frame.view.viewpoint.position_m), pixel.solidAngle_sr,
            pixel.cosOffAxis};
}

const PointFactors& Renderer::Impl::pointFactors(const Frame& frame, const ZoomEntityInfo& object) {
    const Rotation toWorld = frame.entity(object.entity).pose.attitude.rotation();
    const Vec3 from = PointSources::onGrid(
        toWorld.transposed() * normalized(frame.view.viewpoint.position_m - object.centre_m));
    const double distance_m = PointSources::cameraDistance_radii * object.radius_m;
    return pointSources.of(object.entity, aspectOf(frame, object.entity, from), [&] {
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
        // The air is no matter here.
        const SurfaceRows rows = drawnRows(frame.surfaceRows(), frame.scene.entities.size());
        const ViewFactors view =
            drawAlone(frame, object.entity, zoom, frame.scene.settings.zoomWindow * 3 / 2, rows);
        return pointOf(view, distance_m);
    });
}

bool Renderer::Impl::isAlongRange(const Frame& frame, const ZoomEntityInfo& object) {
    const Entity& entity = frame.entity(object.entity);
    const double range_m = frame.geometry[static_cast<std::size_t>(object.entity)].path.range_m;
    const double reach_m = reachOf_m(entity);
    if (!(reach_m > 0.0) || reach_m > RangeFactors::closest * range_m)
        return false;
    // Cosines off the axis are those of a camera that looks at the reference point.
    constexpr double nearby = 1e-6;
    const Viewpoint& viewpoint = frame.view.viewpoint;
    const bool isLookedAt =
        length(towardsSensor(frame, object.entity) - viewpoint.backward) < nearby;
    return isLookedAt && isWholeAndApart(frame, object) && !touchesTerrain(frame, object.extent);
}

Vec3 Renderer::Impl::towardsSensor(const Frame& frame, int entity) {
    const Entity& own = frame.entity(entity);
    return normalized(frame.view.viewpoint.position_m -
                      own.pose.toWorld(prepared.referencePoint(own)));
}

void Renderer::Impl::planAlongRange(Frame& frame) {
    if (!frame.scene.settings.zoomsAligned() ||
        !std::ranges::all_of(frame.backgrounds, &FrameBackground::isUniform))
        return;
    for (const ZoomEntityInfo& object : frame.seen)
        if (isAlongRange(frame, object))
            frame.alongRange.push_back(object);
    const auto isElsewhere = [&](const ZoomEntityInfo& object) {
        return std::ranges::find(frame.alongRange, object.entity, &ZoomEntityInfo::entity) !=
               frame.alongRange.end();
    };
    for (auto* objects : {&frame.seen, &frame.drawn, &frame.points})
        std::erase_if(*objects, isElsewhere);
}

void Renderer::Impl::addAlongRange(const Frame& frame, const ZoomEntityInfo& object,
                                   ViewFactors& view) {
    const Entity& entity = frame.entity(object.entity);
    const ObjectGeometry& geometry = frame.geometry[static_cast<std::size_t>(object.entity)];
    // In air every range takes the same drawings, whether it is sliced there or not.
    const bool isSliced = geometry.slices_m.size() > 1 || geometry.airError > 0.0;
    const double reach_m = reachOf_m(entity);
    const Vec3 from = PointSources::onGrid(entity.pose.attitude.rotation().transposed() *
                                               towardsSensor(frame, object.entity),
                                           RangeFactors::directionStep);
    PointAspect aspect = aspectOf(frame, object.entity, from);
    append(aspect.numbers, prepared.referencePoint(entity));
    aspect.numbers.push_back(isSliced ? 1.0 : 0.0);

    const RangePlace place{geometry.path.range_m, frame.view.sensor.pixelPitch()};
    const auto addNode = [&](std::size_t node, double weight, bool isError) {
        const double distance_m = reach_m / RangeFactors::nodes[node];
        const SurfaceRows rows =
            drawnRows(frame.surfaceRows(), frame.scene.entities.size(), object.entity,
                      isSliced ? slicesAbout(distance_m, reach_m) : SliceNodes{});
        const ViewFactors& drawn = rangeFactors.at(object.entity, aspect, node, [&] {
            return drawAtNode(frame, object.entity, from, node, rows);
        });
        if (!isError)
            return addAtRange(drawn, weight, rows, distance_m, frame.surfaceRows(), place, view);
        // Its own contrasts are those of the sum already.
        addAtRange(drawn, weight, rows, distance_m, frame.surfaceRows(), place,
                   view.contrasts.back());
    };
    const double nearness = reach_m / place.range_m;
    for (const auto& [node, weight] : RangeFactors::weightsAt(nearness))
        addNode(node, weight, false);
    if (!view.contrasts.empty())
        for (const auto& [node, weight] : RangeFactors::errorWeightsAt(nearness))
            addNode(node, weight, true);
}

ViewFactors Renderer::Impl::drawAtNode(const Frame& frame, int entity, const Vec3& from,
                                       std::size_t node, const SurfaceRows& rows) {
    // Pixels that are small in terms of the object, as each has the solid angle of its middle.
    constexpr int pixels = 32;
    // No phases average the error of a node, so that its window is larger than that of a frame.
    const int zoomWindow = frame.scene.settings.zoomWindow * 3 / 2;
    const Entity& own = frame.entity(entity);
    const double distance_m = reachOf_m(own) / RangeFactors::nodes[node];
    const Rotation toWorld = own.pose.attitude.rotation();
    const Vec3 at_m = own.pose.toWorld(prepared.referencePoint(own));
    Sensor sensor = frame.view.sensor;
    sensor.width_px = sensor.height_px = pixels;
    sensor.horizontalFieldOfView_rad = 2.0 * std::asin(RangeFactors::nodes[node]);
    const CameraFrame camera(sensor,
                             Viewpoint::lookAt(at_m + toWorld * from * distance_m, at_m,
                                               toWorld * Vec3{0, 0, 1}, toWorld * Vec3{0, 1, 0}));

    return atUnitDistance(drawAlone(frame, entity, camera, zoomWindow, rows), distance_m,
                          sensor.pixelPitch() * sensor.pixelPitch());
}

} // namespace irsg

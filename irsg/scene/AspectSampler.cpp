#include "irsg/scene/AspectSampler.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "irsg/render/sampling/PixelAlignedStrategy.h"
#include "irsg/scene/KeyNumbers.h"
#include "irsg/scene/ViewKey.h"

namespace irsg {

namespace {

/// The rows of a frame as they are drawn, without or with slices of one entity alone.
SurfaceRows renderedRows(const SurfaceRows& rows, std::size_t entities, int sliced = -1,
                         SliceNodes slices_m = {}) {
    std::vector<bool> transparent;
    for (std::size_t row = 0; row < rows.keys().size(); ++row)
        transparent.push_back(rows.isTransparent(static_cast<int>(row)));
    std::vector<SliceNodes> slices(entities);
    if (sliced >= 0)
        slices[static_cast<std::size_t>(sliced)] = std::move(slices_m);
    return {rows.keys(), transparent, std::move(slices), rows.lobes(), rows.gases()};
}

/// Slices about a distance of what reaches so far before and behind it.
SliceNodes slicesAbout(double distance_m, double reach_m, std::size_t slices) {
    SliceNodes slices_m;
    for (std::size_t i = 0; i <= slices; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(slices);
        slices_m.push_back(distance_m + (2.0 * part - 1.0) * reach_m);
    }
    return slices_m;
}

/// A view of one object from far away, as it is at unit distance.
PointGeometry pointOf(const ViewGeometry& view, double distance_m) {
    PointGeometry point{GeometryBuffer<double>(1, view.layout.factorCount + 1), {}, {}};
    GeometryBuffer<double>& field = point.sums_sr_m2;
    view.field.forEach(0, [&](std::size_t kind, std::span<const double> numbers) {
        double* own = field.at(0, field.kindOf(view.field.kinds()[kind]));
        for (std::size_t i = 0; i < field.width(); ++i)
            own[i] = numbers[i] * distance_m * distance_m;
    });
    addLight(view.light, distance_m * distance_m, point.light_sr_m2);
    for (const ViewGeometry& contrast : view.sublatticeDifferences)
        point.sublatticeDifferences.push_back(pointOf(contrast, distance_m));
    return point;
}

/// A view of one object as it is at unit distance, in pixels 1 m wide there.
ViewGeometry atUnitDistance(const ViewGeometry& view, double distance_m, double pixel_sr) {
    ViewGeometry unit{
        view.layout, GeometryBuffer<double>(1, view.layout.width()), {}, view.layersLeftOver, {}};
    const double square_m2 = distance_m * distance_m;
    addLight(view.light, square_m2, unit.light);
    view.field.forEach(0, [&](std::size_t kind, std::span<const double> numbers) {
        double* sums = unit.field.at(0, unit.field.kindOf(view.field.kinds()[kind]));
        for (std::size_t i = 0; i < numbers.size(); ++i)
            sums[i] = numbers[i] * square_m2;
        sums[view.layout.pixels()] *= pixel_sr;
    });
    for (const ViewGeometry& contrast : view.sublatticeDifferences)
        unit.sublatticeDifferences.push_back(atUnitDistance(contrast, distance_m, pixel_sr));
    return unit;
}

/// Where what the pixels show is, in the plane at a distance.
RangeGeometry::KindPlaces placesOf(const PixelGeometry& pixels, const Sensor& sensor,
                                   double distance_m) {
    const double side_m = sensor.pixelPitch() * distance_m;
    const auto width = static_cast<std::size_t>(sensor.width_px);
    RangeGeometry::KindPlaces places{side_m, {}};
    for (std::size_t cell = 0; cell < pixels.field.cells(); ++cell) {
        const std::size_t row = cell / width, column = cell % width;
        const double right_m = (static_cast<double>(column) + 0.5 - 0.5 * sensor.width_px) * side_m;
        const double up_m = (0.5 * sensor.height_px - static_cast<double>(row) - 0.5) * side_m;
        pixels.field.forEach(cell, [&](std::size_t number, std::span<const float> numbers) {
            const SurfaceStackId& kind = pixels.field.kinds()[number];
            if (const float coverage = numbers[ViewLayout::coverage()]; coverage > 0.0f)
                places.byKind[{kind.stack, kind.row}].push_back(
                    {right_m, up_m, static_cast<double>(coverage)});
        });
    }
    return places;
}

/// Calls visit(pixel, part) for the pixels along one axis of so many that an interval has a part
/// in; what is beyond the ends counts for them.
template <typename Visit>
void forEachPixelOf(double middle, double side, int pixels, Visit visit) {
    const auto inside = [&](double place) { return std::clamp(place, 0.0, pixels - 1.0); };
    const double begin = middle - 0.5 * side, end = middle + 0.5 * side;
    const int first = static_cast<int>(inside(begin)), last = static_cast<int>(inside(end));
    for (int pixel = first; pixel <= last; ++pixel) {
        const double from = pixel == first ? begin : static_cast<double>(pixel);
        const double to = pixel == last ? end : pixel + 1.0;
        visit(pixel, (to - from) / side);
    }
}

/// The mean of each background behind places of the drawing of a camera, as another one that looks
/// along the same line from another range sees them. Places are squares, upright in both.
RadianceBehindKind radianceBehind(const RangeGeometry::KindPlaces& places,
                                  const std::vector<const FrameBackground*>& varying,
                                  const Viewpoint& drawnFrom, const Vec3& at_m,
                                  const CameraFrame& camera) {
    const Sensor& sensor = camera.sensor();
    const double range_m = length(at_m - camera.viewpoint().position_m);
    const double side_px = places.side_m / (range_m * sensor.pixelPitch());
    std::map<std::pair<int, int>, std::vector<double>> behind;
    std::vector<double> all(varying.size());
    double coverageOfAll = 0.0;
    for (const auto& [kind, own] : places.byKind) {
        std::vector<double> sums(varying.size());
        double coverage = 0.0;
        for (const RangeGeometry::KindPlace& one : own) {
            coverage += one.coverage;
            const auto seen =
                camera.placeOf(at_m + drawnFrom.right * one.right_m + drawnFrom.up * one.up_m);
            for (std::size_t k = 0; !seen && k < varying.size(); ++k)
                sums[k] += one.coverage * varying[k]->centre_W_m2_sr();
            if (!seen)
                continue;
            forEachPixelOf(seen->second, side_px, sensor.height_px, [&](int y, double partOfRow) {
                forEachPixelOf(seen->first, side_px, sensor.width_px, [&](int x, double part) {
                    for (std::size_t k = 0; k < varying.size(); ++k)
                        sums[k] += one.coverage * partOfRow * part * varying[k]->at(x, y);
                });
            });
        }
        for (std::size_t k = 0; k < varying.size(); ++k)
            all[k] += sums[k];
        coverageOfAll += coverage;
        for (double& sum : sums)
            sum /= coverage;
        behind[kind] = std::move(sums);
    }
    for (std::size_t k = 0; k < varying.size(); ++k)
        all[k] = coverageOfAll > 0.0 ? all[k] / coverageOfAll : varying[k]->centre_W_m2_sr();
    // Gas may be of other columns in the sums of pixels.
    return [behind = std::move(behind), all = std::move(all)](const SurfaceStackId& kind) {
        const auto known = behind.find({kind.stack, kind.row});
        return known != behind.end() ? known->second : all;
    };
}

} // namespace

bool AspectSampler::withErrors(const Frame& frame) {
    return frame.request.withErrors || frame.request.sampledFrom_m;
}

PointAspect AspectSampler::aspectOf(const Frame& frame, int entity, const Vec3& from) const {
    const RenderSettings& settings = frame.settings();
    const SurfaceRows& rows = frame.rows();
    const Rotation toModel = frame.request.entity(entity).pose.attitude.rotation().transposed();
    PointAspect aspect{frame.request.entity(entity).model,
                       {static_cast<double>(settings.tileSide_samples),
                        static_cast<double>(settings.maximumLayers),
                        frame.surfaces.engine.isRays ? 1.0 : 0.0},
                       terms_.glsl(settings)};
    appendTo(aspect.numbers, from);
    aspect.numbers.push_back(withErrors(frame) ? 1.0 : 0.0);
    aspect.numbers.push_back(frame.shading().shadows ? static_cast<double>(settings.sunShadows)
                                                     : 0.0);
    appendReceivers(frame.shading(), frame.settings().lightError, aspect.numbers);
    appendLobes(frame.surfaces, aspect.numbers);
    if (frame.shading().shadows)
        aspect.numbers.insert(aspect.numbers.end(), frame.shading().shadows->reflects().begin(),
                              frame.shading().shadows->reflects().end());
    // Others may stand between it and the sun.
    for (const Entity& other : frame.scene().entities)
        if (frame.shading().shadows &&
            (frame.scene().entities.size() > 1 || frame.scene().terrain)) {
            appendTo(aspect.numbers, other.pose.position_m);
            appendTo(aspect.numbers, other.pose.attitude);
        }
    for (const FrameDirection& direction : terms_.directions)
        appendTo(aspect.numbers, toModel * direction.world(frame.scene().environment.sun));
    for (std::size_t row = 0; row < rows.keys().size(); ++row) {
        // Rows are numbered through the scene.
        aspect.numbers.push_back(rows.keys()[row].first);
        if (rows.keys()[row].first == entity) {
            aspect.numbers.push_back(
                static_cast<double>(frame.evaluation().rows[row].nAngleFactor));
            aspect.numbers.push_back(rows.isTransparent(static_cast<int>(row)) ? 1.0 : 0.0);
            // Which parts are hot changes with the air; those of the first look are sampled.
            if (!frame.request.sampledFrom_m)
                aspect.numbers.push_back(frame.evaluation().hot[row] ? 1.0 : 0.0);
            const GasZone* gas = rows.gas(static_cast<int>(row));
            for (std::size_t k = 0; gas && k < gas->columns->numbers.size(); ++k)
                aspect.numbers.push_back(static_cast<double>(gas->columns->numbers[k]));
        }
    }
    return aspect;
}

void AspectSampler::forgetOtherTerrain(const Frame& frame) {
    if (terrain_ == frame.scene().terrain)
        return;
    terrain_ = frame.scene().terrain;
    pointSources_ = {};
    rangeFactors_ = {};
}

ViewGeometry AspectSampler::sampleAlone(const Frame& frame, const CameraFrame& camera,
                                        const Alone& alone) {
    GeometrySums sums(camera.sensor(), alone.rows, occluderStacks_, terms_.factorCount(), {},
                      frame.exchange(), withErrors(frame));
    ViewGeometry view = sums.emptyView();
    // Coverage alone.
    GeometrySums ofPixels(camera.sensor(), alone.rows, occluderStacks_, 0);
    if (alone.pixels)
        *alone.pixels = ofPixels.emptyPixels();
    const auto seen = planner_.seenBy(frame.surfaces, camera, alone.entity);
    if (!seen)
        return view;
    sampler_.onEngine(frame.surfaces.engine, [&] {
        GeometrySamples samples;
        const PixelAlignedStrategy strategy(alone.tileSide_samples);
        for (const SampleTile& tile :
             piecesOf(strategy.tiles({*seen}), frame.surfaces.engine.engine.largestSide())) {
            SurfaceScene scene = sampler_.sceneOf(frame.surfaces, camera, tile);
            if (!alone.isAmongTerrain)
                scene.terrain = {};
            scene.groundBefore.clear();
            const SheetScene sheet{SampleSheet::of(tile), {std::move(scene)}};
            frame.surfaces.engine.engine.sampleGeometry(
                sheet, alone.rows.needsDistances() || frame.shading().isNeeded(), samples);
            clock_.timed("layer sorting",
                         [&] { frame.shading().sortAndApply(sheet, frame.settings(), samples); });
            clock_.timed("factor sums", [&] {
                sums.addToView(tile, samples, view);
                if (alone.pixels)
                    ofPixels.addToPixels(tile, samples, *alone.pixels);
            });
        }
    });
    return view;
}

PointPlace AspectSampler::placeOf(const Frame& frame, const ObjectExtent& object) {
    const ImageRectangle& extent = object.extent;
    const int x = static_cast<int>(0.5 * (extent.left + extent.right));
    const int y = static_cast<int>(0.5 * (extent.top + extent.bottom));
    const PixelGrid::Pixel pixel = PixelGrid(frame.sensor()).at(x, y);
    const Viewpoint& viewpoint = frame.request.view.viewpoint;
    const Vec3 towards = object.centre_m - viewpoint.position_m;
    const double distance_m = length(towards);
    const double cosine = dot(towards, viewpoint.forward()) / distance_m;
    return {x, y, distance_m, pixel.solidAngle_sr, cosine, cosine / pixel.cosOffAxis};
}

const PointGeometry& AspectSampler::pointGeometry(const Frame& frame, const ObjectExtent& object) {
    forgetOtherTerrain(frame);
    const Rotation toWorld = frame.request.entity(object.entity).pose.attitude.rotation();
    const Vec3 from =
        PointSources::onGrid(toWorld.transposed() *
                             normalized(frame.request.view.viewpoint.position_m - object.centre_m));
    const double distance_m = PointSources::cameraDistance_radii * object.radius_m;
    return pointSources_.of(object.entity, aspectOf(frame, object.entity, from), [&] {
        // A few pixels of a camera that looks at it from far. No phases average its error, so its
        // tile is larger than that of other objects, but not by much: one that turns is drawn
        // anew for every frame.
        Sensor few = frame.sensor();
        few.width_px = few.height_px = 4;
        few.horizontalFieldOfView_rad = 2.0 * std::asin(1.0 / PointSources::cameraDistance_radii);
        const Vec3 place = object.centre_m + toWorld * from * distance_m;
        const CameraFrame zoom(few,
                               Viewpoint::lookAt(place, object.centre_m, toWorld * Vec3{0, 0, 1},
                                                 toWorld * Vec3{0, 1, 0}));
        // The air is no matter here.
        const SurfaceRows rows = renderedRows(frame.rows(), frame.scene().entities.size());
        const ViewGeometry view = sampleAlone(
            frame, zoom, {object.entity, frame.settings().tileSide_samples * 3 / 2, rows});
        return pointOf(view, distance_m);
    });
}

AspectSampler::Along AspectSampler::along(const Frame& frame, const AlongRange& one) {
    forgetOtherTerrain(frame);
    const int number = one.object.entity;
    const Entity& entity = frame.request.entity(number);
    const ObjectGeometry& geometry = frame.evaluation().geometry[static_cast<std::size_t>(number)];
    const Vec3 from = prepared_.lineOfSight(entity, frame.request.view.viewpoint.position_m);
    // In air every range takes the same drawings, whether it is sliced there or not.
    const bool isSliced = geometry.slices_m.size() > 1 || geometry.atmosphereError > 0.0;
    PointAspect aspect = aspectOf(frame, number, from);
    appendTo(aspect.numbers, prepared_.referencePoint(entity));
    aspect.numbers.push_back(isSliced ? 1.0 : 0.0);
    if (one.isAmongTerrain) {
        appendTo(aspect.numbers, entity.pose.position_m);
        appendTo(aspect.numbers, entity.pose.attitude);
    }
    return {entity, from, prepared_.reach_m(entity), isSliced, std::move(aspect)};
}

SurfaceRows AspectSampler::rowsAt(const Frame& frame, const AlongRange& one, const Along& along,
                                  double distance_m) {
    const std::size_t slices =
        frame.request.sampledFrom_m ? RangeGeometry::slicesFromOne : RangeGeometry::slices;
    return renderedRows(frame.rows(), frame.scene().entities.size(), one.object.entity,
                        along.isSliced ? slicesAbout(distance_m, along.reach_m, slices)
                                       : SliceNodes{});
}

AspectSampler::FromOne AspectSampler::drawnFromOne(const Frame& frame, const AlongRange& one,
                                                   bool withPlaces) {
    const Along along = this->along(frame, one);
    const double distance_m =
        RangeGeometry::sampledFrom_m(*frame.request.sampledFrom_m, along.reach_m);
    SurfaceRows rows = rowsAt(frame, one, along, distance_m);
    CameraFrame camera =
        prepared_.cameraAlong(along.entity, along.from, distance_m, frame.sensor());
    const RangeGeometry::FromOne& drawn =
        rangeFactors_.from(one.object.entity, along.aspect, distance_m, withPlaces, [&] {
            return sampleFromOne(
                frame, camera, distance_m, withPlaces,
                {one.object.entity, frame.settings().tileSide_samples, rows, one.isAmongTerrain});
        });
    return {drawn, std::move(rows), std::move(camera)};
}

void AspectSampler::addAlongRange(const Frame& frame, const AlongRange& one,
                                  const std::vector<const FrameBackground*>& varying,
                                  ViewGeometry& view) {
    const ObjectExtent& object = one.object;
    const ObjectGeometry& geometry =
        frame.evaluation().geometry[static_cast<std::size_t>(object.entity)];
    const RangePlace place{geometry.path.range_m, frame.sensor().pixelPitch()};
    const auto add = [&](const ViewGeometry& drawn, const SurfaceRows& rows, double distance_m,
                         double weight, const RadianceBehindKind& behind, bool isError) {
        // The contrasts of an error are those of the sum already.
        addAtRange(drawn, weight, rows, distance_m, frame.rows(), place, behind,
                   isError ? view.sublatticeDifferences.back() : view);
    };
    const bool withErrors = !view.sublatticeDifferences.empty();
    if (frame.request.sampledFrom_m) {
        const FromOne drawn = drawnFromOne(frame, one, !varying.empty());
        const double distance_m = drawn.of.distance_m;
        const Entity& entity = frame.request.entity(object.entity);
        const RadianceBehindKind behind =
            varying.empty() ? RadianceBehindKind()
                            : radianceBehind(*drawn.of.places, varying, drawn.camera.viewpoint(),
                                             entity.pose.toWorld(prepared_.referencePoint(entity)),
                                             frame.request.camera);
        add(drawn.of.view, drawn.rows, distance_m, 1.0, behind, false);
        if (withErrors)
            add(drawn.of.view, drawn.rows, distance_m,
                RangeGeometry::errorFrom(one.reach_m / distance_m, one.reach_m / place.range_m),
                behind, true);
        return;
    }
    const Along along = this->along(frame, one);
    const double nearness = along.reach_m / place.range_m;
    const auto addNode = [&](std::size_t node, double weight, bool isError) {
        const double distance_m = along.reach_m / RangeGeometry::nodes[node];
        const SurfaceRows rows = rowsAt(frame, one, along, distance_m);
        const ViewGeometry& drawn = rangeFactors_.at(object.entity, along.aspect, node, [&] {
            // No phases average the error of a node, so that its tile is larger than that of a
            // frame.
            return sampleFrom(
                frame, prepared_.cameraAlong(along.entity, along.from, distance_m, frame.sensor()),
                distance_m, {object.entity, frame.settings().tileSide_samples * 3 / 2, rows});
        });
        add(drawn, rows, distance_m, weight, {}, isError);
    };
    for (const auto& [node, weight] : RangeGeometry::weightsAt(nearness))
        addNode(node, weight, false);
    if (withErrors)
        for (const auto& [node, weight] : RangeGeometry::errorWeightsAt(nearness))
            addNode(node, weight, true);
}

ViewGeometry AspectSampler::sampleFrom(const Frame& frame, const CameraFrame& camera,
                                       double distance_m, const Alone& alone) {
    const double pitch = camera.sensor().pixelPitch();
    return atUnitDistance(sampleAlone(frame, camera, alone), distance_m, pitch * pitch);
}

RangeGeometry::FromOne AspectSampler::sampleFromOne(const Frame& frame, const CameraFrame& camera,
                                                    double distance_m, bool withPlaces,
                                                    Alone alone) {
    PixelGeometry pixels;
    alone.pixels = withPlaces ? &pixels : nullptr;
    RangeGeometry::FromOne one{distance_m, sampleFrom(frame, camera, distance_m, alone), {}};
    if (withPlaces)
        one.places = placesOf(pixels, camera.sensor(), distance_m);
    return one;
}

} // namespace irsg

#include <algorithm>
#include <cmath>

#include <osg/RenderInfo>

#include "irsg/scene/IrsgParts.h"
#include "irsg/scene/radiance/FactorTable.h"
#include "irsg/scene/sampling/PixelAlignedStrategy.h"
#include "irsg/scene/view/PixelGrid.h"

namespace irsg {

void Irsg::Parts::planPoints(Frame& frame) const {
    const bool mayBePoints = settings.zoomWindow > 0 &&
                             settings.zoomStrategy == ZoomStrategy::aligned &&
                             settings.pointSourceBelow_px > 0.0;
    const ImageRectangle field{0.0, 0.0, static_cast<double>(sensor.width_px),
                               static_cast<double>(sensor.height_px)};
    for (const ZoomEntityInfo& object : frame.seen) {
        const ImageRectangle& extent = object.extent;
        const bool isWhole = extent.left > field.left && extent.right < field.right &&
                             extent.top > field.top && extent.bottom < field.bottom;
        const bool standsApart = std::ranges::none_of(frame.seen, [&](const ZoomEntityInfo& other) {
            return other.entity != object.entity && other.extent.intersects(extent);
        });
        const bool isPoint = mayBePoints && isWhole && standsApart &&
                             extent.extent() < settings.pointSourceBelow_px &&
                             !touchesTerrain(extent);
        (isPoint ? frame.points : frame.drawn).push_back(object);
    }
}

Irsg::Parts::PointPixel Irsg::Parts::pixelOf(const Frame& frame,
                                             const ZoomEntityInfo& object) const {
    const ImageRectangle& extent = object.extent;
    const int x = static_cast<int>(0.5 * (extent.left + extent.right));
    const int y = static_cast<int>(0.5 * (extent.top + extent.bottom));
    const PixelGrid::Pixel pixel = PixelGrid(sensor).at(x, y);
    return {x, y, length(object.centre_m - frame.camera.viewpoint().position_m),
            pixel.solidAngle_sr, pixel.cosOffAxis};
}

const ProjectedFactors& Irsg::Parts::pointFactors(const Frame& frame,
                                                  const ZoomEntityInfo& object) {
    const Entity& entity = entities[static_cast<std::size_t>(object.entity)];
    const Rotation toWorld = entity.pose.attitude.rotation();
    const Rotation toModel = toWorld.transposed();
    const Vec3 from = PointSources::onGrid(
        toModel * normalized(frame.camera.viewpoint().position_m - object.centre_m));
    PointAspect aspect{
        entity.model,
        {static_cast<double>(settings.zoomWindow), static_cast<double>(settings.maximumLayers),
         static_cast<double>(frame.scene.modes.sun), static_cast<double>(frame.scene.modes.flux)}};
    const SunPosition& sun = environment.sun;
    for (const Vec3& v :
         {from, toModel * direction(sun.azimuth_rad, sun.elevation_rad), toModel * Vec3{0, 0, 1}})
        aspect.numbers.insert(aspect.numbers.end(), {v.x, v.y, v.z});
    for (std::size_t row = 0; row < frame.radiometry.keys().size(); ++row)
        if (frame.radiometry.keys()[row].first == object.entity) {
            const SurfaceSpectra& surface = frame.radiometry.surfaces()[row];
            aspect.numbers.push_back(surface.nAngleFactor);
            aspect.numbers.push_back(surface.isTransparent() ? 1.0 : 0.0);
            aspect.numbers.push_back(frame.hot[row] ? 1.0 : 0.0);
        }

    const double distance_m = PointSources::cameraDistance_radii * object.radius_m;
    return pointSources.sums_sr_m2(object.entity, aspect, [&] {
        // A few pixels of a camera that looks at it from far. No phases average its error, so its
        // window is larger than that of other objects, but not by much: one that turns is drawn
        // anew for every frame.
        Sensor few = sensor;
        few.width_px = few.height_px = 4;
        few.horizontalFieldOfView_rad = 2.0 * std::asin(1.0 / PointSources::cameraDistance_radii);
        const Vec3 place = object.centre_m + toWorld * from * distance_m;
        const CameraFrame zoom(few,
                               Viewpoint::lookAt(place, object.centre_m, toWorld * Vec3{0, 0, 1},
                                                 toWorld * Vec3{0, 1, 0}));
        auto seen = zoomEntityInfo(object.entity, zoom, entity.model->bounds(),
                                   balls[static_cast<std::size_t>(object.entity)], entity.pose);
        const FrameBackground none;
        FactorAccumulator accumulator(zoom.sensor(), none, frame.radiometry);
        if (seen) {
            seen->details = detailsOf(frame, zoom, static_cast<std::size_t>(object.entity));
            seen->edges = edgesOf(zoom, static_cast<std::size_t>(object.entity));
            onContext([&](osg::RenderInfo& info) {
                FactorSamples samples;
                const PixelAlignedStrategy strategy(settings.zoomWindow * 3 / 2);
                for (const SampleWindow& window :
                     piecesOf(strategy.windows({*seen}), largestDrawing())) {
                    SurfaceScene alone = sceneOf(frame, zoom, window);
                    alone.occluders.clear(); // no terrain is before a point as the sensor sees it
                    pass->drawFactors(info, alone, window, false, samples);
                    accumulator.add(window, samples);
                }
            });
        }
        ProjectedFactors atUnitDistance = accumulator.take();
        for (auto& [key, sums] : atUnitDistance.sums)
            sums = atDistance(sums, 1.0 / distance_m, 1.0, 1.0, 0.0);
        return atUnitDistance;
    });
}

void Irsg::Parts::addPoint(const Frame& frame, const ZoomEntityInfo& object,
                           FrameReduction& reduction) {
    const PointPixel pixel = pixelOf(frame, object);
    double radiance_W_m2 = 0.0, opaque_sr = 0.0;
    for (const auto& [key, kept] : pointFactors(frame, object).sums) {
        const FactorSums sums =
            atDistance(kept, pixel.distance_m, pixel.solidAngle_sr, pixel.cosOffAxis, 0.0);
        const SurfaceRow& row =
            frame.scene.rows[static_cast<std::size_t>(frame.radiometry.row(key.entity, key.codes))];
        double passed = 1.0;
        for (const auto& [entity, material] : key.inFront)
            passed *= frame.radiometry.scalarTransmissivityOf(entity, material);
        radiance_W_m2 += passed * (static_cast<double>(row.thermal) * sums.thermal_sr +
                                   static_cast<double>(row.up) * sums.up_sr +
                                   static_cast<double>(row.down) * sums.down_sr +
                                   static_cast<double>(row.sun) * sums.sun_sr +
                                   static_cast<double>(row.path) * sums.coverage_sr);
        opaque_sr += passed * static_cast<double>(row.opacity) * sums.coverage_sr;
    }
    reduction.addPoint(pixel.x, pixel.y, radiance_W_m2 / pixel.solidAngle_sr,
                       opaque_sr / pixel.solidAngle_sr);
}

} // namespace irsg

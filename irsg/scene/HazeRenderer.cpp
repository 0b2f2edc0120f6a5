#include "irsg/scene/HazeRenderer.h"

#include <span>

#include "irsg/atmosphere/AtmosphereScatteringLut.h"
#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Wording.h"
#include "irsg/radiance/Reductions.h"
#include "irsg/radiance/ScatteringDepth.h"
#include "irsg/scene/PictureBackground.h"

namespace irsg {

namespace {

/// What one kind of surface sends, of factors that begin with the coverage.
template <typename Real>
double sentBy(const SurfaceStackRadiance& kind, std::span<const Real> numbers) {
    double sum = kind.constant * static_cast<double>(numbers[0]);
    for (std::size_t f = 0; f < kind.perFactor.size(); ++f)
        sum += kind.perFactor[f] * static_cast<double>(numbers[1 + f]);
    return sum;
}

} // namespace

std::vector<ScatteredObject> HazeRenderer::objectsOf(const Frame& frame,
                                                     std::vector<std::string>& warnings) {
    std::vector<ScatteredObject> objects;
    for (std::size_t e = 0; e < frame.scene().entities.size(); ++e) {
        const PathScattering path = scatteringAlong(
            evaluator_.answers(), frame.evaluation().geometry[e].path, frame.request.bands.front());
        const std::string& name = frame.scene().entities[e].name;
        objects.push_back({name, frame.request.pathDepth * path.opticalDepth, {}});
        if (path.fromTransmittance)
            appendUnique(warnings,
                         {"scattering: no atmosphere has a scattering optical depth, so that "
                          "eq. 10 takes it from the transmittance of " +
                          withoutNearestRun(path.providedBy) +
                          ": absorption by gases blurs as if it scattered"});
        else if (path.opticalDepth == 0.0)
            appendUnique(warnings,
                         {"scattering: nothing scatters on the path to '" + name + "', as " +
                          withoutNearestRun(path.providedBy) + " says: it has no haze"});
    }
    return objects;
}

void HazeRenderer::warnOfOutside(const Frame& frame, int support_px,
                                 std::vector<std::string>& warnings) {
    const Sensor& sensor = frame.sensor();
    const auto reach = static_cast<double>(support_px);
    const ImageRectangle seen{0.0, 0.0, static_cast<double>(sensor.width_px),
                              static_cast<double>(sensor.height_px)};
    const ImageRectangle near{-reach, -reach, seen.right + reach, seen.bottom + reach};
    for (const Entity& entity : frame.scene().entities) {
        const BoundingSphere& sphere = entity.model->mesh()->sphere;
        const auto extent = frame.request.camera.extentOfSphere(
            entity.pose.toWorld(sphere.centre_m), sphere.radius_m);
        const auto box = frame.request.camera.extentOf(entity.model->bounds(), entity.pose);
        if (!extent || !box)
            continue;
        const ImageRectangle whole = extent->intersectedWith(*box);
        if (whole.intersects(near) && !(whole.intersectedWith(seen) == whole))
            appendUnique(warnings,
                         {"scattering: '" + entity.name +
                          "' reaches beyond the frame: what of it lies outside sends no haze "
                          "into the picture"});
    }
}

void HazeRenderer::addPixels(const Frame& frame, const PixelGeometry& factors,
                             std::vector<ScatteredObject>& objects) {
    const GeometryBuffer<float>& field = factors.field;
    std::vector<double> ofReceivers;
    if (frame.light())
        ofReceivers = radiancesOf(factors.light.kinds(), factors.receivers, *frame.light());
    SurfaceRadianceTable& radiances = frame.evaluation().evaluated->radiances;
    const SurfaceRows& rows = frame.rows();
    const auto objectOf = [&](const SurfaceStackId& kind) -> ScatteredObject& {
        return objects[static_cast<std::size_t>(rows.keyOf(rows.renderedOf(kind.row)).first)];
    };
    radiances.prepare(field.kinds());
    const int width = frame.sensor().width_px;
    for (std::size_t cell = 0; cell < field.cells(); ++cell) {
        const int x = static_cast<int>(cell) % width, y = static_cast<int>(cell) / width;
        field.forEach(cell, [&](std::size_t number, std::span<const float> numbers) {
            const SurfaceStackId& kind = field.kinds()[number];
            const SurfaceStackRadiance radiance = radiances.of(kind);
            std::vector<ScatteredObject::Pixel>& pixels = objectOf(kind).pixels;
            if (pixels.empty() || pixels.back().x != x || pixels.back().y != y)
                pixels.push_back({x, y, 0.0, 0.0, 1.0});
            pixels.back().radiance_W_m2_sr += sentBy(radiance, numbers);
            pixels.back().opacity += radiance.opacity * static_cast<double>(numbers[0]);
        });
        if (frame.light())
            factors.light.forEach(cell, [&](std::size_t number, std::span<const float> part) {
                const SurfaceStackId& kind = factors.light.kinds()[number];
                const int row = factors.receivers.receiverOf(kind.row).first;
                objectOf({kind.stack, row}).pixels.back().radiance_W_m2_sr +=
                    ofReceivers[number] * static_cast<double>(part[0]);
            });
    }
}

void HazeRenderer::addPoints(const Frame& frame, std::vector<ScatteredObject>& objects) {
    SurfaceRadianceTable& radiances = frame.evaluation().evaluated->radiances;
    const SurfaceRows& rows = frame.rows();
    for (const ObjectExtent& object : frame.plan.points) {
        const PointPlace place = AspectSampler::placeOf(frame, object);
        const double scale = 1.0 / (place.distance_m * place.distance_m * place.solidAngle_sr);
        ScatteredObject::Pixel pixel{place.x, place.y, 0.0, 0.0, place.cosineShare};
        const PointGeometry& point = aspects_.pointGeometry(frame, object);
        if (frame.light())
            pixel.radiance_W_m2_sr += scale * lightOfPoint(point, rows, *frame.light());
        const GeometryBuffer<double>& sums_sr_m2 = point.sums_sr_m2;
        sums_sr_m2.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
            const SurfaceStackId& own = sums_sr_m2.kinds()[number];
            const SurfaceStackId kind{own.stack, rows.first(own.row)};
            radiances.prepare({kind});
            const SurfaceStackRadiance radiance = radiances.of(kind);
            pixel.radiance_W_m2_sr += scale * sentBy(radiance, numbers);
            pixel.opacity += scale * radiance.opacity * numbers[0];
        });
        objects[static_cast<std::size_t>(object.entity)].pixels.push_back(pixel);
    }
}

void HazeRenderer::check(const Environment& environment) {
    if (const AtmosphereScatteringLut* droplets = scatteringLutOf(environment))
        scattering_.check(droplets->database());
}

HazeGains HazeRenderer::gains(const Frame& frame) {
    std::vector<std::string> warnings; // those of the picture
    std::vector<ScatteredObject> objects = objectsOf(frame, warnings);
    const PixelGeometry factors = sampler_.pixelFactors(frame);
    return clock_.timed("scattering", [&] {
        addPixels(frame, factors, objects);
        addPoints(frame, objects);
        SampleTile whole;
        whole.blocksWide = frame.sensor().width_px;
        whole.blocksHigh = frame.sensor().height_px;
        FrameReduction pixels(frame.sensor(), {whole});
        for (const ScatteredObject& object : objects)
            for (const ScatteredObject::Pixel& pixel : object.pixels)
                pixels.addPoint(pixel.x, pixel.y, pixel.radiance_W_m2_sr, pixel.opacity,
                                pixel.cosineShare);
        return scattering_.gains(scatteringLutOf(frame.scene().environment)->database(),
                                 frame.sensor(), pictureBackground(frame, pixels), objects,
                                 frame.evaluation().ranges_m());
    });
}

HazeGains HazeRenderer::add(const Frame& frame, const FrameBackground& background, bool withGains,
                            RadianceImage& image, std::vector<std::string>& warnings) {
    std::vector<ScatteredObject> objects = objectsOf(frame, warnings);
    // What every pixel shows of each object, from the tiles of the sampling. The published zoom
    // resamples what it draws, so that its objects are drawn on the pixels' own grid here.
    const PixelGeometry factors = sampler_.pixelFactors(frame);
    return clock_.timed("scattering", [&] {
        addPixels(frame, factors, objects);
        addPoints(frame, objects);
        const auto& database = scatteringLutOf(frame.scene().environment)->database();
        warnOfOutside(frame, scattering_.support_px(database, frame.sensor()), warnings);
        for (const ScatteredLight& light :
             scattering_.addHaze(database, frame.sensor(), background, objects, image, warnings)) {
            const std::string key = "scattering." + light.name + ".";
            image.attributes[key + "optical_depth"] = roundedText(light.opticalDepth, 9);
            image.attributes[key + "gain"] = roundedText(light.gain, 9);
            image.attributes[key + "cut"] = roundedText(light.cut, 9);
        }
        image.attributes["scattering.database"] = database.string();
        return withGains ? scattering_.gains(database, frame.sensor(), background, objects,
                                             frame.evaluation().ranges_m())
                         : HazeGains{};
    });
}

} // namespace irsg

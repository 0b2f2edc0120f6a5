#include "irsg/scene/Irsg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <osg/GLObjects>
#include <osg/RenderInfo>
#include <osg/State>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/CameraFrame.h"
#include "irsg/scene/DrawList.h"
#include "irsg/scene/FactorTable.h"
#include "irsg/scene/FrameReduction.h"
#include "irsg/scene/OffscreenContext.h"
#include "irsg/scene/PixelGrid.h"
#include "irsg/scene/SceneCheck.h"
#include "irsg/scene/SceneRadiometry.h"
#include "irsg/scene/Stopwatch.h"
#include "irsg/scene/SurfacePass.h"
#include "irsg/scene/TruthLayers.h"

namespace irsg {

namespace {

/// Largest side of one drawing, samples: bounds the memory of the targets.
constexpr int largestDrawing = 2048;

bool isTransparent(const SurfaceSpectra& surface) {
    return std::ranges::any_of(surface.transmissivity, [](double t) { return t > 0.0; });
}

/// Cuts a window into pieces of at most `side` pixels.
std::vector<PixelWindow> tiles(const PixelWindow& window, int side) {
    std::vector<PixelWindow> result;
    for (int y = 0; y < window.height; y += side)
        for (int x = 0; x < window.width; x += side)
            result.push_back({window.x + x, window.y + y, std::min(side, window.width - x),
                              std::min(side, window.height - y)});
    return result;
}

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

struct Irsg::Parts {
    OffscreenContext& context = OffscreenContext::shared();
    std::unique_ptr<SurfacePass> pass; // made and destroyed on the context's thread

    Environment environment = Environment::vacuum();
    Sensor sensor;
    RenderSettings settings;
    std::vector<Entity> entities;
    Viewpoint viewpoint;

    std::vector<std::vector<DrawItem>> drawItems; // by entity
    std::vector<Vec3> referencePoints;            // in model axes, by entity
    std::vector<StageTimes::Stage> stages;

    // The factors of the last view, kept while nothing they depend on changes.
    std::vector<double> factorFingerprint;
    std::vector<std::shared_ptr<const Model>> factorModels;
    ProjectedFactors factors;

    // Sum of omega cos(theta) over the frame, kept for one raster.
    std::array<double, 3> frameRaster{};
    double frameProjectedSolidAngle_sr = 0.0;

    /// Everything one drawing needs, made anew for each.
    struct Frame {
        CameraFrame camera;
        std::vector<ObjectGeometry> geometry;
        SceneRadiometry radiometry;
        SurfaceScene scene;
        PixelWindow window; // of all objects
    };

    template <typename Work>
    auto timed(const char* stage, Work work) {
        double seconds = 0.0;
        if constexpr (std::is_void_v<decltype(work())>) {
            {
                Stopwatch watch(seconds);
                work();
            }
            addTime(stage, seconds);
        } else {
            auto result = [&] {
                Stopwatch watch(seconds);
                return work();
            }();
            addTime(stage, seconds);
            return result;
        }
    }

    void addTime(const std::string& name, double seconds) {
        auto found = std::ranges::find(stages, name, &StageTimes::Stage::name);
        if (found == stages.end())
            found = stages.insert(stages.end(), {name, 0.0, 0});
        found->seconds += seconds;
        ++found->calls;
    }

    /// Centre of the box around what does not let light through, or around all of it.
    Vec3 modelReferencePoint(const Entity& entity) const {
        if (entity.referencePoint_m)
            return *entity.referencePoint_m;
        const BoundingBox opaque = entity.model->boundsOf([&](const IrCodes& codes) {
            const Material* material = materialEntry(entity, codes.material);
            return !material || material->isOpaque();
        });
        return opaque.valid() ? opaque.centre() : entity.model->bounds().centre();
    }

    void prepareEntity(std::size_t e) { referencePoints[e] = modelReferencePoint(entities[e]); }

    std::vector<ObjectGeometry> geometry() const {
        std::vector<Vec3> points;
        for (std::size_t e = 0; e < entities.size(); ++e)
            points.push_back(entities[e].pose.toWorld(referencePoints[e]));
        return objectGeometry(entities, points, viewpoint);
    }

    /// The unbounded line of sight through the middle of the field.
    LineOfSight centre() const {
        const Vec3 view = viewpoint.forward();
        LineOfSight sight;
        sight.sensorAltitude_m = std::max(viewpoint.position_m.z, 0.0);
        sight.elevation_rad = std::asin(std::clamp(view.z, -1.0, 1.0));
        sight.azimuth_rad = std::atan2(view.x, view.y);
        return sight;
    }

    SurfaceModes modes(const CameraFrame& camera) const {
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

    Frame frame() {
        const std::vector<ObjectGeometry> objects = geometry();
        checkScene(entities, objects, environment, sensor, settings);
        return timed("radiometry", [&] {
            Frame result{
                CameraFrame(sensor, viewpoint),
                objects,
                SceneRadiometry(environment, entities, objects, settings, centre(), sensor.band),
                {},
                {}};
            fillRows(result);
            fillItems(result);
            return result;
        });
    }

    static void fillRows(Frame& frame) {
        const SceneRadiometry& radiometry = frame.radiometry;
        for (std::size_t row = 0; row < radiometry.surfaces().size(); ++row) {
            const SurfaceSpectra& surface = radiometry.surfaces()[row];
            auto inBand = [&](const std::vector<double>& term) {
                return static_cast<float>(radiometry.integrate(term));
            };
            const double t = radiometry.scalarTransmissivity(static_cast<int>(row));
            frame.scene.rows.push_back({inBand(surface.thermal), inBand(surface.up),
                                        inBand(surface.down), inBand(surface.sun),
                                        inBand(surface.path), static_cast<float>(1.0 - t),
                                        static_cast<float>(surface.nAngleFactor)});
        }
    }

    void fillItems(Frame& frame) const {
        frame.scene.maximumLayers = settings.maximumLayers;
        frame.scene.modes = modes(frame.camera);
        for (std::size_t e = 0; e < entities.size(); ++e) {
            const Entity& entity = entities[e];
            const auto depth = frame.camera.depthOf(entity.model->bounds(), entity.pose);
            const PixelWindow window = frame.camera.windowOf(entity.model->bounds(), entity.pose);
            if (!depth || window.empty())
                continue;
            DepthRange& all = frame.scene.depth;
            if (frame.window.empty())
                all = *depth;
            all.near_m = std::min(all.near_m, depth->near_m);
            all.far_m = std::max(all.far_m, depth->far_m);
            frame.window = frame.window.unitedWith(window);

            const osg::Matrixd eyeFromModel = frame.camera.eyeFromModel(entity.pose);
            for (const DrawItem& item : drawItems[e]) {
                const int row = frame.radiometry.row(static_cast<int>(e), item.codes);
                const bool transparent =
                    isTransparent(frame.radiometry.surfaces()[static_cast<std::size_t>(row)]);
                frame.scene.items.push_back({item.geometry.get(),
                                             item.modelFromLocal * eyeFromModel, row, transparent,
                                             item.cullsBackFaces, item.layer});
            }
        }
    }

    int tileSide() const {
        return std::max(1, std::min(largestDrawing, context.maximumTargetSize()) /
                               settings.samplesPerAxis);
    }

    void onContext(const std::function<void(osg::RenderInfo&)>& work) {
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

    /// Draws the factors of the objects' window, tile by tile, and times what `sink` makes of them.
    template <typename Sink>
    void drawFactorTiles(const Frame& frame, bool withDistance, const char* stage, Sink sink) {
        if (frame.window.empty())
            return;
        double sinking_s = 0.0;
        onContext([&](osg::RenderInfo& info) {
            SurfaceScene scene = frame.scene;
            scene.camera = &frame.camera;
            FactorSamples samples;
            for (const PixelWindow& tile : tiles(frame.window, tileSide())) {
                pass->drawFactors(info, scene, tile, settings.samplesPerAxis, withDistance,
                                  samples);
                Stopwatch watch(sinking_s);
                sink(tile, samples);
            }
        });
        addTime(stage, sinking_s);
    }

    /// What the projected factors depend on, as numbers.
    std::vector<double> fingerprint(const Frame& frame) const {
        std::vector<double> numbers{static_cast<double>(sensor.width_px),
                                    static_cast<double>(sensor.height_px),
                                    sensor.horizontalFieldOfView_rad,
                                    static_cast<double>(settings.samplesPerAxis),
                                    static_cast<double>(settings.maximumLayers),
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
            numbers.push_back(isTransparent(surface) ? 1.0 : 0.0);
        }
        return numbers;
    }

    const ProjectedFactors& factorsOf(const Frame& frame) {
        std::vector<double> numbers = fingerprint(frame);
        std::vector<std::shared_ptr<const Model>> models;
        for (const Entity& entity : entities)
            models.push_back(entity.model);
        if (numbers == factorFingerprint && models == factorModels)
            return factors;

        std::vector<bool> transparent;
        for (const SurfaceSpectra& surface : frame.radiometry.surfaces())
            transparent.push_back(isTransparent(surface));
        FactorAccumulator accumulator(frame.radiometry.keys(), transparent);
        drawFactorTiles(frame, false, "factor sums",
                        [&](const PixelWindow& tile, const FactorSamples& samples) {
                            accumulator.add(sensor, tile, settings.samplesPerAxis, samples);
                        });
        factors = accumulator.take();
        factorFingerprint = std::move(numbers);
        factorModels = std::move(models);
        return factors;
    }

    /// Of the whole frame on the detector: the objects' contrast upon the background.
    double totalIrradiance_W_m2(const RenderReport& report) {
        const std::array<double, 3> raster{static_cast<double>(sensor.width_px),
                                           static_cast<double>(sensor.height_px),
                                           sensor.horizontalFieldOfView_rad};
        if (raster != frameRaster) {
            frameRaster = raster;
            frameProjectedSolidAngle_sr = PixelGrid(sensor).projectedSolidAngle_sr();
        }
        return report.all.irradiance_W_m2 + report.background_W_m2_sr * frameProjectedSolidAngle_sr;
    }

    void addTruthLayers(const Frame& frame, RadianceImage& image) {
        TruthLayers truth(frame.radiometry, image);
        drawFactorTiles(frame, true, "truth layers",
                        [&](const PixelWindow& tile, const FactorSamples& samples) {
                            truth.add(tile, settings.samplesPerAxis, samples);
                        });
    }

    void fillReport(const Frame& frame, RenderReport& report) const {
        report.background_W_m2_sr = frame.radiometry.backgroundInBand_W_m2_sr();
        report.answeredBy = frame.radiometry.answeredBy();
        report.warnings = frame.radiometry.warnings();
        report.transmissivityResidue = frame.radiometry.transmissivityResidue();
        report.renderer = context.rendererDescription();
    }

    void describe(const Frame& frame, RadianceImage& image) const {
        const SpectralRange& range = sensor.band.range();
        image.attributes["band.name"] = sensor.band.name();
        image.attributes["band.min_um"] = text(range.min_um);
        image.attributes["band.max_um"] = text(range.max_um);
        image.attributes["sensor.horizontal_field_of_view_deg"] =
            text(degrees(sensor.horizontalFieldOfView_rad));
        image.attributes["samples_per_axis"] = std::to_string(settings.samplesPerAxis);
        image.attributes["background_W_m2_sr"] = text(frame.radiometry.backgroundInBand_W_m2_sr());
        image.attributes["renderer"] = context.rendererDescription();
        if (!frame.geometry.empty())
            image.attributes["range_m"] = text(frame.geometry.front().path.range_m);
    }
};

Irsg::Irsg() : parts_(std::make_unique<Parts>()) {}

Irsg::~Irsg() {
    parts_->context.run([&](osg::RenderInfo&) { parts_->pass.reset(); });
}

void Irsg::setEnvironment(Environment environment) {
    parts_->environment = std::move(environment);
}
const Environment& Irsg::environment() const {
    return parts_->environment;
}
void Irsg::setSensor(const Sensor& sensor) {
    parts_->sensor = sensor;
}
const Sensor& Irsg::sensor() const {
    return parts_->sensor;
}
void Irsg::setSettings(const RenderSettings& settings) {
    parts_->settings = settings;
}
const RenderSettings& Irsg::settings() const {
    return parts_->settings;
}
void Irsg::setViewpoint(const Viewpoint& viewpoint) {
    parts_->viewpoint = viewpoint;
}
const Viewpoint& Irsg::viewpoint() const {
    return parts_->viewpoint;
}
const std::vector<Entity>& Irsg::entities() const {
    return parts_->entities;
}

void Irsg::setEntities(std::vector<Entity> entities) {
    for (const Entity& entity : entities)
        if (!entity.model || !entity.database)
            throw LogicError("an entity needs a model and a database");
    parts_->entities = std::move(entities);
    parts_->drawItems.clear();
    parts_->referencePoints.resize(parts_->entities.size());
    for (std::size_t e = 0; e < parts_->entities.size(); ++e) {
        parts_->drawItems.push_back(collectDrawItems(*parts_->entities[e].model));
        parts_->prepareEntity(e);
    }
}

void Irsg::setPose(std::size_t entity, const Pose& pose) {
    parts_->entities.at(entity).pose = pose;
}

void Irsg::setState(std::size_t entity, const EntityState& state) {
    parts_->entities.at(entity).state = state;
}

void Irsg::setDatabase(std::size_t entity, std::shared_ptr<const SignatureDatabase> database) {
    if (!database)
        throw LogicError("an entity needs a database");
    parts_->entities.at(entity).database = std::move(database);
    parts_->prepareEntity(entity);
}

Vec3 Irsg::referencePoint(std::size_t entity) const {
    return parts_->entities.at(entity).pose.toWorld(parts_->referencePoints.at(entity));
}

void Irsg::checkConfiguration() const {
    checkScene(parts_->entities, parts_->geometry(), parts_->environment, parts_->sensor,
               parts_->settings);
}

RenderedImage Irsg::render() {
    Parts& p = *parts_;
    const Parts::Frame frame = p.frame();
    FrameReduction reduction(p.sensor, frame.window,
                             static_cast<double>(frame.radiometry.backgroundInBand_W_m2_sr()));
    RenderedImage result;

    // Draw the pixels that can see an object; everything else is background.
    double reducing_s = 0.0;
    if (!frame.window.empty())
        p.onContext([&](osg::RenderInfo& info) {
            SurfaceScene scene = frame.scene;
            scene.camera = &frame.camera;
            RadianceSamples samples;
            for (const PixelWindow& tile : tiles(frame.window, p.tileSide())) {
                p.pass->drawRadiance(info, scene, tile, p.settings.samplesPerAxis, samples);
                result.report.layersLeftOver += samples.layersLeftOver;
                Stopwatch watch(reducing_s);
                reduction.add(tile, p.settings.samplesPerAxis, samples);
            }
        });
    p.addTime("reduction", reducing_s);

    // Sums in double on the objects' own window, then the picture.
    p.timed("composition", [&] {
        result.image = reduction.compose();
        p.fillReport(frame, result.report);
        p.describe(frame, result.image);
    });
    if (p.entities.size() > 1) {
        evaluateFactors(p.factorsOf(frame), frame.radiometry, frame.geometry, p.entities,
                        result.report);
    }
    const double range_m = frame.geometry.empty() ? 0.0 : frame.geometry.front().path.range_m;
    result.report.all = reduction.objects(range_m);
    result.report.totalIrradiance_W_m2 = p.totalIrradiance_W_m2(result.report);
    if (p.entities.size() == 1) {
        result.report.objects = {result.report.all};
        result.report.objects.front().name = p.entities.front().name;
    }

    if (p.settings.truthLayers)
        p.addTruthLayers(frame, result.image);
    return result;
}

RenderReport Irsg::measure() {
    Parts& p = *parts_;
    const Parts::Frame frame = p.frame();
    RenderReport report;
    const ProjectedFactors& factors = p.factorsOf(frame);
    p.timed("evaluation", [&] {
        evaluateFactors(factors, frame.radiometry, frame.geometry, p.entities, report);
        p.fillReport(frame, report);
        report.totalIrradiance_W_m2 = p.totalIrradiance_W_m2(report);
    });
    return report;
}

IntensitySpectrum Irsg::measureSpectrum(const std::vector<double>& wavenumbers_cm1) {
    Parts& p = *parts_;
    const Parts::Frame frame = p.frame();
    const ProjectedFactors& factors = p.factorsOf(frame);
    return p.timed("evaluation", [&] {
        std::vector<double> wavelengths_um;
        for (double wavenumber_cm1 : wavenumbers_cm1) {
            if (!(wavenumber_cm1 > 0.0))
                throw LogicError("a wavenumber that is not positive was asked for");
            wavelengths_um.push_back(wavelengthFromWavenumber_um(wavenumber_cm1));
        }
        std::ranges::sort(wavelengths_um);
        wavelengths_um.erase(std::ranges::unique(wavelengths_um).begin(), wavelengths_um.end());

        const SceneRadiometry radiometry(p.environment, p.entities, frame.geometry, p.settings,
                                         p.centre(), wavelengths_um);
        const double range_m = frame.geometry.empty() ? 0.0 : frame.geometry.front().path.range_m;
        const IntensitySpectrum ascending = evaluateSpectrum(factors, radiometry, range_m);

        // Back in the order that was asked for.
        IntensitySpectrum result;
        result.coveredPixels = ascending.coveredPixels;
        result.warnings = ascending.warnings;
        for (double wavenumber_cm1 : wavenumbers_cm1) {
            const double wavelength_um = wavelengthFromWavenumber_um(wavenumber_cm1);
            const auto i = static_cast<std::size_t>(
                std::ranges::lower_bound(wavelengths_um, wavelength_um) - wavelengths_um.begin());
            result.wavenumbers_cm1.push_back(wavenumber_cm1);
            result.wavelengths_um.push_back(wavelength_um);
            result.intensity_W_sr_um.push_back(ascending.intensity_W_sr_um[i]);
            result.contrastIntensity_W_sr_um.push_back(ascending.contrastIntensity_W_sr_um[i]);
            result.irradiance_W_m2_um.push_back(ascending.irradiance_W_m2_um[i]);
        }
        return result;
    });
}

ProjectedFactors Irsg::projectFactors() {
    const Parts::Frame frame = parts_->frame();
    return parts_->factorsOf(frame);
}

std::string Irsg::rendererDescription() {
    return parts_->context.rendererDescription();
}
StageTimes Irsg::stageTimes() const {
    return {parts_->stages};
}
void Irsg::resetStageTimes() {
    parts_->stages.clear();
}

} // namespace irsg

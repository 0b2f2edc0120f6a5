#include "irsg/scene/Irsg.h"

#include <algorithm>

#include <osg/RenderInfo>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/IrsgParts.h"
#include "irsg/scene/model/DrawPieces.h"
#include "irsg/scene/radiance/FactorTable.h"
#include "irsg/scene/sampling/FrameReduction.h"

namespace irsg {

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
void Irsg::setSkybox(std::shared_ptr<const Skybox> skybox) {
    parts_->background.setSkybox(std::move(skybox));
}
void Irsg::setTerrain(std::shared_ptr<const Terrain> terrain) {
    if (terrain == parts_->background.terrain())
        return;
    parts_->background.setTerrain(std::move(terrain));
    parts_->factorFingerprint.clear();
    parts_->pixelView = {};
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
    parts_->balls.clear();
    parts_->hotParts.assign(parts_->entities.size(), {});
    parts_->longEdges.clear();
    parts_->referencePoints.resize(parts_->entities.size());
    for (std::size_t e = 0; e < parts_->entities.size(); ++e) {
        const Model& model = *parts_->entities[e].model;
        parts_->drawItems.push_back(collectDrawItems(model));
        parts_->balls.push_back(boundingBall(parts_->drawItems.back(), model.bounds()));
        parts_->longEdges.push_back(
            longEdges(parts_->drawItems.back(), parts_->balls.back().radius_m));
        parts_->drawItems.back() = inDrawPieces(parts_->drawItems.back());
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
    RenderedImage result;
    const FrameReduction reduction = p.drawObjects(frame, result.report);

    // Sums in double on the objects' own windows, then the picture.
    p.timed("composition", [&] {
        result.image = reduction.compose(frame.background);
        p.fillReport(frame, result.report);
        p.describe(frame, result.image);
        describeWindows(result.report.windows, result.image);
    });
    if (p.entities.size() > 1) {
        evaluateFactors(p.factorsOf(frame), frame.radiometry, frame.background, frame.geometry,
                        p.entities, result.report);
    }
    const double range_m = frame.geometry.empty() ? 0.0 : frame.geometry.front().path.range_m;
    const ObjectRadiometry separate = result.report.all;
    result.report.all = reduction.objects(frame.background, range_m);
    if (p.entities.size() > 1) {
        // The pixels do not tell whose they are; the objects' own sums do.
        result.report.all.intensity_W_sr = separate.intensity_W_sr;
        result.report.all.contrastIntensity_W_sr = separate.contrastIntensity_W_sr;
    }
    result.report.totalIrradiance_W_m2 = p.totalIrradiance_W_m2(frame, result.report);
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
        evaluateFactors(factors, frame.radiometry, frame.background, frame.geometry, p.entities,
                        report);
        p.fillReport(frame, report);
        report.totalIrradiance_W_m2 = p.totalIrradiance_W_m2(frame, report);
    });
    return report;
}

IntensitySpectrum Irsg::measureSpectrum(const std::vector<double>& wavenumbers_cm1) {
    Parts& p = *parts_;
    const Parts::Frame frame = p.frame(CalculationMode::spectral);
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
        const IntensitySpectrum ascending =
            evaluateSpectrum(factors, radiometry, frame.geometry, p.entities);

        // Back in the order that was asked for.
        IntensitySpectrum result;
        result.coveredPixels = ascending.coveredPixels;
        result.warnings = ascending.warnings;
        for (const ObjectSpectrum& object : ascending.objects)
            result.objects.push_back({object.name, {}, {}, {}});
        if (p.settings.mode == CalculationMode::wideband)
            result.warnings.push_back("spectra are computed in the spectral mode: a wideband term "
                                      "stands for the band, not for its wavelength");
        for (double wavenumber_cm1 : wavenumbers_cm1) {
            const double wavelength_um = wavelengthFromWavenumber_um(wavenumber_cm1);
            const auto i = static_cast<std::size_t>(
                std::ranges::lower_bound(wavelengths_um, wavelength_um) - wavelengths_um.begin());
            result.wavenumbers_cm1.push_back(wavenumber_cm1);
            result.wavelengths_um.push_back(wavelength_um);
            result.intensity_W_sr_um.push_back(ascending.intensity_W_sr_um[i]);
            result.contrastIntensity_W_sr_um.push_back(ascending.contrastIntensity_W_sr_um[i]);
            result.irradiance_W_m2_um.push_back(ascending.irradiance_W_m2_um[i]);
            for (std::size_t e = 0; e < result.objects.size(); ++e) {
                const ObjectSpectrum& from = ascending.objects[e];
                ObjectSpectrum& to = result.objects[e];
                to.intensity_W_sr_um.push_back(from.intensity_W_sr_um[i]);
                to.contrastIntensity_W_sr_um.push_back(from.contrastIntensity_W_sr_um[i]);
                to.irradiance_W_m2_um.push_back(from.irradiance_W_m2_um[i]);
            }
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
std::size_t Irsg::graphicsMemory_bytes() const {
    return parts_->pass ? parts_->pass->bytes() : 0;
}
StageTimes Irsg::stageTimes() const {
    return {parts_->stages};
}
void Irsg::resetStageTimes() {
    parts_->stages.clear();
}

} // namespace irsg

#include "irsg/scene/SceneEvaluator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/radiance/HotSpotSurfaces.h"
#include "irsg/radiance/PathDepth.h"
#include "irsg/render/background/BandSky.h"

namespace irsg {

namespace {

/// Gives objects with directional surfaces the directions of the sky that these reflect.
void takeSpecularEnvironmentGrids(const Scene& scene, const Band& band,
                                  std::vector<ObjectGeometry>& geometry) {
    if (scene.settings.ambientReflection != ReflectionMode::smart)
        return;
    const bool byAzimuth =
        std::ranges::any_of(scene.environment.atmospheres(), [](const auto& atmosphere) {
            return atmosphere->dependsOnAzimuth(AtmosphereProperty::backgroundRadiance);
        });
    for (std::size_t e = 0; e < geometry.size(); ++e) {
        const Entity& entity = scene.entities[e];
        const bool hasLobes = std::ranges::any_of(entity.model->codes(), [&](const auto& use) {
            const Material* material = materialEntry(entity, use.first.material);
            return material != nullptr && !material->surfaceModel.empty();
        });
        if (!hasLobes)
            continue;
        // The same grid whatever the range, which altitudes are rounded by.
        constexpr double step_rad = 1e-9;
        const double horizon_rad =
            scene.environment.horizonElevation_rad(geometry[e].path.targetAltitude_m, band.range());
        geometry[e].mirror =
            SpecularEnvironmentGrid(step_rad * std::round(horizon_rad / step_rad), byAzimuth);
    }
}

/// True where the background changes so much over an object of many pixels that it matters how its
/// parts hide each other. Less is summed better along lines of sight, which are finer than pixels
/// and rows of a picture.
bool isBackgroundSummedByPixel(const FrameRequest& request, const SceneEvaluation& evaluation) {
    constexpr double fewest_px = 16.0; // over an object's sphere
    constexpr double matters = 1e-3;   // of the background
    const BackgroundBehind& behind = evaluation.behind;
    for (std::size_t e = 0; !request.alongRange && e < evaluation.geometry.size(); ++e) {
        const ObjectGeometry& object = evaluation.geometry[e];
        const double reach_m = object.farthest_m - object.path.range_m;
        if (2.0 * reach_m < fewest_px * request.view.sensor.pixelPitch() * object.path.range_m)
            continue;
        for (std::size_t k = 0; k < behind.error[e].size(); ++k)
            if (behind.error[e][k] > matters * behind.radiance[e][k])
                return true;
    }
    return false;
}

/// What the shader is told of each drawn row, in the first output.
std::vector<SurfaceRow> rowsOf(EvaluatedScene& evaluated) {
    const SurfaceRows& rows = evaluated.radiometry.rows();
    SurfaceRadianceTable& radiances = evaluated.radiances;
    std::vector<SurfaceStackId> kinds;
    for (std::size_t drawn = 0; drawn < rows.keys().size(); ++drawn)
        kinds.push_back({0, rows.first(static_cast<int>(drawn))});
    radiances.prepare(kinds);
    std::vector<SurfaceRow> all;
    all.reserve(kinds.size());
    for (const SurfaceStackId& kind : kinds) {
        const SurfaceStackRadiance radiance = radiances.of(kind);
        SurfaceRow& row = all.emplace_back();
        std::ranges::transform(radiance.perFactor, row.radiance.begin(),
                               [](double value) { return static_cast<float>(value); });
        row.constant = static_cast<float>(radiance.constant);
        row.opacity = static_cast<float>(radiance.opacity);
        row.nAngleFactor = static_cast<float>(evaluated.radiometry.surface(kind.row).nAngleFactor);
    }
    return all;
}

/// What of an answer for the background is seen through the air of a request in an output, before
/// the object that is looked at.
BandSky::Seen throughDepth(const FrameRequest& request, const SceneEvaluation& evaluation,
                           std::size_t output) {
    const std::size_t lookedAt = static_cast<std::size_t>(std::max(request.lookedAt, 0));
    std::size_t ofBand = output;
    for (const SampledBand& band : evaluation.sampled->bands) {
        if (ofBand >= band.outputs.size()) {
            ofBand -= band.outputs.size();
            continue;
        }
        if (lookedAt >= band.behind.size())
            return {};
        return [&behind = band.behind[lookedAt], first = band.outputs[ofBand].first](
                   const std::vector<double>& values) { return behind.of(values, first); };
    }
    return {};
}

} // namespace

SceneEvaluation SceneEvaluator::pathsOf(const FrameRequest& request,
                                        std::vector<ObjectGeometry> geometry) {
    const Scene& scene = request.scene;
    answers_.setEnvironment(scene.environment);
    takeSpecularEnvironmentGrids(scene, request.bands.front(), geometry);
    SceneEvaluation made;
    made.sampled = sampledScenes_.of(answers_, airScene(request, geometry), request.bands,
                                     request.withSources, sampler(scene, answers_));
    for (std::size_t e = 0; e < geometry.size(); ++e) {
        geometry[e].slices_m = made.sampled->slices_m[e];
        geometry[e].atmosphereError = made.sampled->atmosphereError[e];
        geometry[e].likelyAtmosphereError = made.sampled->likelyAtmosphereError[e];
    }
    if (hasBackgroundBehind(scene))
        made.behind = backgroundBehind(answers_, request, made.sampled->bands, geometry);
    if (!made.behind.background && request.withErrors &&
        scene.settings.background == BackgroundMode::environment) {
        made.compared.geometry = geometry;
        made.compared.behind =
            backgroundBehind(answers_, request, made.sampled->bands, made.compared.geometry);
    }
    made.geometry = std::move(geometry);
    return made;
}

SceneEvaluation SceneEvaluator::evaluate(const FrameRequest& request,
                                         std::vector<ObjectGeometry> geometry) {
    return clock_.timed("radiometry", [&] {
        const Scene& scene = request.scene;
        SceneEvaluation made = pathsOf(request, std::move(geometry));
        made.evaluated =
            radiometry_.of(terms_, scene.entities, made.geometry, made.sampled, occluderStacks_);
        made.evaluated->radiances.setBackground(made.background());
        made.rows = rowsOf(*made.evaluated);
        made.hot = hotRows(scene, made.geometry, made.sampled, made.evaluated->radiometry);
        return made;
    });
}

SceneEvaluation SceneEvaluator::atOtherRange(const FrameRequest& request,
                                             std::vector<ObjectGeometry> geometry,
                                             const SceneEvaluation& known) {
    return clock_.timed("radiometry", [&] {
        SceneEvaluation made = pathsOf(request, std::move(geometry));
        made.evaluated = known.evaluated;
        made.evaluated->radiances.setBackground(made.background());
        made.rows = known.rows;
        made.hot.assign(known.hot.size(), false);
        return made;
    });
}

FrameBackgrounds SceneEvaluator::backgrounds(const FrameRequest& request,
                                             const SceneEvaluation& evaluation,
                                             TerrainPainter& terrainPainter) {
    return clock_.timed("background", [&] {
        const Scene& scene = request.scene;
        const RenderSettings& settings = scene.settings;
        background_.setSkybox(scene.skybox);
        background_.setTerrain(scene.terrain);
        const SurfaceRadianceTable& radiances = evaluation.evaluated->radiances;
        FrameBackgrounds all;
        for (std::size_t k = 0; k < radiances.outputs(); ++k) {
            if (evaluation.sampled->ofOutput(k).isSource) {
                all.byOutput.emplace_back(0.0);
                all.ofSums.emplace_back(0.0);
                continue;
            }
            const std::shared_ptr<const SpectralSampling> nodes =
                samplingOf(request, evaluation, k);
            BandSky sky(scene.environment, *nodes, request.raised_rad);
            if (request.pathDepth != 1.0)
                sky.seenThrough(throughDepth(request, evaluation, k));
            BackgroundSettings wanted;
            wanted.queriesEnvironment = settings.background == BackgroundMode::environment;
            wanted.uniform_W_m2_sr = radiances.background_W_m2_sr(k);
            // Where objects have their own, a picture shows the field's, and what large objects
            // hide of it is summed pixel by pixel.
            const bool haveOwn = evaluation.behind.background != nullptr;
            const bool isByPixel = haveOwn && isBackgroundSummedByPixel(request, evaluation);
            wanted.rows = haveOwn && !request.withImage && !isByPixel ? 1 : settings.backgroundRows;
            wanted.columns = settings.backgroundColumns;
            wanted.sunDisc = settings.sunDisc;
            wanted.skybox = settings.skybox;
            wanted.terrain = settings.terrain;
            BackgroundReport report;
            all.byOutput.push_back(background_.draw(request.view.sensor, request.view.viewpoint,
                                                    sky, wanted, terrainPainter, report));
            all.ofSums.push_back(haveOwn && !isByPixel ? FrameBackground(wanted.uniform_W_m2_sr)
                                                       : all.byOutput.back());
            all.report.flooredPixels += report.flooredPixels;
            addProvider(all.report.providedBy, report.providedBy);
            appendUnique(all.report.warnings, report.warnings);
        }
        all.layers = background_.takeLayers();
        return all;
    });
}

EvaluatedSpectrum SceneEvaluator::atWavelengths(const FrameRequest& request,
                                                const std::vector<ObjectGeometry>& geometry,
                                                const std::vector<double>& wavelengths_um) {
    std::vector<SampledBand> bands{
        SceneSampling::wavelengths(answers_, airScene(request, geometry), wavelengths_um)};
    deepenPaths(answers_, airScene(request, geometry), bands.front());
    auto scene = std::make_unique<EvaluatedScene>(terms_, request.scene.entities, geometry, bands,
                                                  occluderStacks_);
    BackgroundBehind behind = backgroundAlong(answers_, request, bands, geometry);
    scene->radiances.setBackground(behind.background ? behind.background
                                                     : backgroundOf(bands, request.scene.settings));
    return {std::move(bands), std::move(scene), std::move(behind)};
}

SampledScenes::Sampler SceneEvaluator::sampler(const Scene& ofScene,
                                               AtmosphericQueryCache& answers) {
    return
        [this, &ofScene, &answers](const AtmosphereScene& scene, const std::vector<Band>& bands) {
            if (scene.settings.mode != CalculationMode::wideband)
                return sampling_.spectral(answers, scene, bands);
            std::vector<SampledBand> sampled;
            sampled.reserve(bands.size());
            for (const Band& band : bands)
                sampled.push_back(SceneSampling::wideband(answers, scene, wideband(ofScene, band)));
            return sampled;
        };
}

std::shared_ptr<const SpectralSampling>
SceneEvaluator::samplingOf(const FrameRequest& request, const SceneEvaluation& evaluation,
                           std::size_t band) {
    const SampledBand& sampled = evaluation.sampled->ofOutput(band);
    return sampled.outputs.size() == 1
               ? sampled.sampling
               : sampling_.nodes(request.scene.environment, request.bands[band]);
}

std::shared_ptr<const WidebandPoints> SceneEvaluator::wideband(const Scene& scene,
                                                               const Band& band) {
    WidebandSpectra spectra = widebandSpectraOf(scene.entities);
    const double error = scene.settings.widebandError;
    widebandPoints_.letGo([](const auto& kept) { return kept->isGone(); });
    return widebandPoints_.of(
        [&](const auto& kept) { return kept->areOf(scene.environment, band, spectra, error); },
        [&] {
            return clock_.timed("wideband points", [&] {
                return std::make_shared<const WidebandPoints>(scene.environment, band,
                                                              std::move(spectra), error);
            });
        });
}

std::vector<bool> SceneEvaluator::hotRows(const Scene& scene,
                                          const std::vector<ObjectGeometry>& geometry,
                                          const std::shared_ptr<const SampledScene>& sampled,
                                          const SceneRadiometry& radiometry) {
    if (!scene.settings.hotSpots || !scene.settings.usesAlignedTiles())
        return std::vector<bool>(radiometry.rows().keys().size(), false);
    std::vector<bool> hot = hotSpotSurfaces(radiometry, scene.entities);
    std::vector<Entity> entities = scene.entities;
    const std::size_t states = entities.empty() ? 0 : entities.front().otherStates.size();
    for (std::size_t i = 0; i < states; ++i) {
        for (Entity& entity : entities)
            entity.state = entity.otherStates.at(i);
        const auto other = radiometry_.of(terms_, entities, geometry, sampled, occluderStacks_);
        const std::vector<bool> there = hotSpotSurfaces(other->radiometry, entities);
        for (std::size_t row = 0; row < hot.size(); ++row)
            hot[row] = hot[row] || there.at(row);
    }
    return hot;
}

} // namespace irsg

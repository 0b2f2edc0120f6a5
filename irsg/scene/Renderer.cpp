#include "irsg/scene/Renderer.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/SceneAtmosphere.h"
#include "irsg/radiance/SceneScaledView.h"
#include "irsg/scene/PictureBackground.h"
#include "irsg/scene/RendererImpl.h"
#include "irsg/scene/SceneCheck.h"

namespace irsg {

namespace {

void requireNoScales(const std::vector<Entity>& entities) {
    for (const Entity& entity : entities)
        if (!entity.temperatureScale.empty() || !entity.emissivityScale.empty())
            throw LogicError("a view as a function of scales was asked of a scaled scene");
}

Scene withRays(Scene scene) {
    scene.settings.engine = EngineChoice::rays;
    return scene;
}

/// With the haze of one object, or of all.
std::unique_ptr<const ScaledView> hazed(std::unique_ptr<const ScaledView> direct,
                                        const HazeGains& gains,
                                        const std::vector<ObjectRadiometry>& objects,
                                        std::optional<int> only) {
    if (gains.empty())
        return direct;
    return std::make_unique<const HazedScaledView>(std::move(direct),
                                                   only ? gains[static_cast<std::size_t>(*only)]
                                                        : gainOfAll(gains, objects));
}

ScaledValues valuesOf(const ObjectRadiometry& sum) {
    return {{sum.intensity_W_sr}, {sum.contrastIntensity_W_sr}, {sum.irradiance_W_m2}};
}

} // namespace

Renderer::Renderer() : Renderer(RadianceTerms::standard()) {}
Renderer::Renderer(const RadianceTerms& terms) : impl_(std::make_unique<Impl>(terms)) {
    if (terms.factorCount() == 0 || terms.factorCount() > mostFactors)
        throw LogicError("a list of terms has 1 to 7 drawn factors");
}
Renderer::~Renderer() = default;

Rendered Renderer::render(const Scene& scene, const SensorView& view, const Outputs& outputs) {
    Impl& p = *impl_;
    if (!outputs.scalings().empty())
        requireNoScales(scene.entities);
    Rendered result;
    const bool inBands = outputs.hasImage() || outputs.hasReports() ||
                         (!outputs.scalings().empty() && outputs.wavenumbers_per_cm().empty());
    if (inBands) {
        const Frame frame = p.frame(scene, view, outputs);
        if (outputs.hasImage())
            p.renderImage(frame, outputs, result);
        else if (outputs.hasReports())
            result.reports = p.reports(frame);
        if (!outputs.scalings().empty() && outputs.wavenumbers_per_cm().empty()) {
            const ViewGeometry& factors = p.sampler.factorsOf(frame);
            const std::vector<RenderReport> nominal = p.reporter.reports(frame, factors);
            std::vector<HazeGains> gains;
            for (const Band& band : frame.request.bands)
                gains.push_back(scene.settings.scattering
                                    ? p.hazeGains(scene, view, band, outputs.pathDepth())
                                    : HazeGains{});
            p.clock.timed("scaled view", [&] {
                EvaluatedScene& evaluated = frame.evaluation().turned(scene.entities);
                const auto add = [&](std::size_t band, const ObjectRadiometry& sum,
                                     std::optional<int> only) {
                    auto direct = std::make_unique<const SceneScaledView>(
                        factors, evaluated.radiometry, evaluated.radiances, frame.light(),
                        evaluated.planck, frame.evaluation().ranges_m(),
                        evaluated.radiometry.outputs()[band], outputs.scalings(), false,
                        valuesOf(sum), only);
                    result.scaled.push_back(
                        hazed(std::move(direct), gains[band], nominal[band].objects, only));
                };
                for (std::size_t k = 0; k < frame.request.bands.size(); ++k) {
                    add(k, nominal[k].all, {});
                    for (std::size_t i = 0; outputs.isByObject() && i < scene.entities.size(); ++i)
                        add(k, nominal[k].objects[i], static_cast<int>(i));
                }
            });
        }
    }
    if (!outputs.wavenumbers_per_cm().empty()) {
        Scene spectral = scene;
        spectral.settings.mode = CalculationMode::spectral;
        const Frame frame = p.frame(spectral, view, outputs);
        SpectrumOfView ofView = p.spectra.spectrum(
            frame, p.sampler.factorsOf(frame), outputs.wavenumbers_per_cm(), outputs.scalings());
        result.spectrum = std::move(ofView.spectrum);
        HazeGains gains;
        std::vector<ObjectRadiometry> direct;
        if (scene.settings.scattering) {
            gains = p.hazeGains(spectral, view, frame.request.bands.front(), outputs.pathDepth());
            direct = p.reporter.reports(frame, p.sampler.factorsOf(frame)).front().objects;
            addHaze(gains, result.spectrum);
        }
        if (ofView.scaled)
            result.scaled.push_back(hazed(std::move(ofView.scaled), gains, direct, {}));
        if (scene.settings.mode == CalculationMode::wideband)
            result.spectrum.warnings.push_back(
                "spectra are computed in the spectral mode: a quadrature point of wideband-ck "
                "stands for the band, "
                "not for its wavelength");
    }
    return result;
}

PendingRender Renderer::begin(const Scene& scene, const SensorView& view, const Outputs& outputs) {
    if (outputs.hasImage() || !outputs.hasReports()) {
        auto made = std::make_shared<Rendered>(render(scene, view, outputs));
        return PendingRender([made] { return std::move(*made); });
    }
    auto begun = std::make_shared<Begun>(*impl_, scene, view, outputs);
    if (!begun->frame.spectra)
        begun->drawing = impl_->sampler.begin(begun->frame);
    return PendingRender(
        [this, begun] {
            Rendered made;
            made.reports =
                begun->drawing
                    ? impl_->reports(begun->frame,
                                     impl_->sampler.factorsOf(begun->frame, *begun->drawing))
                    : impl_->reports(begun->frame);
            return made;
        },
        mostThreads() > 1);
}

void Renderer::Impl::renderImage(const Frame& frame, const Outputs& outputs, Rendered& result) {
    // Frames share evaluated scenes, and another may have been begun since.
    frame.evaluation().turned(frame.scene().entities);
    // Sums are those of a sweep, which samples as the picture does.
    const bool isPictures = outputs.hasReports() && frame.scene().entities.size() <= 1 &&
                            frame.request.bands.size() == 1;
    const bool withSums = outputs.hasReports() && (!isPictures || frame.request.withErrors);
    SampledPicture picture = outputs.isFollowed() ? sampler.followedPicture(frame, withSums)
                                                  : sampler.picture(frame, withSums);
    const FrameBackground background = pictureBackground(frame, picture.pixels);
    clock.timed("composition", [&] {
        result.image = picture.pixels.compose(background);
        RenderReporter::describe(frame, background, result.image);
        describeTiles(picture.tiles, result.image);
    });
    HazeGains gains;
    if (frame.settings().scattering)
        gains = haze.add(frame, background, isPictures, result.image, picture.warnings);
    if (isPictures) {
        RenderReport own = reporter.report(frame, picture.pixels, background);
        if (frame.request.withErrors) {
            // Lattices are told apart in sums alone.
            const RenderReport sums = reporter.reports(frame, sampler.factorsOf(frame)).front();
            own.all.errors = sums.all.errors;
            for (std::size_t e = 0; e < own.objects.size(); ++e)
                own.objects[e].errors = sums.objects[e].errors;
        }
        addHaze(gains, own);
        result.reports = {std::move(own)};
    } else if (outputs.hasReports()) {
        result.reports = reports(frame);
    } else {
        result.reports.emplace_back();
    }
    RenderReport& first = result.reports.front();
    first.tiles = std::move(picture.tiles);
    for (std::string& warning : picture.warnings)
        first.warnings.push_back(std::move(warning));
    first.layersLeftOver = picture.layersLeftOver;
    if (frame.settings().truthLayers)
        sampler.addTruthLayers(frame, background, result.image);
}

HazeGains Renderer::Impl::hazeGains(const Scene& scene, const SensorView& view, const Band& band,
                                    double pathDepth) {
    SensorView picture = view;
    picture.sensor.band = band;
    return haze.gains(frame(scene, picture, Outputs::image().throughDepth(pathDepth)));
}

std::vector<RenderReport> Renderer::Impl::reports(const Frame& frame, const ViewGeometry& factors) {
    return withHaze(frame, reporter.reports(frame, factors));
}

std::vector<RenderReport> Renderer::Impl::withHaze(const Frame& frame,
                                                   std::vector<RenderReport> all) {
    // Behind the bands their sources, which no droplets are before.
    for (std::size_t k = 0; frame.settings().scattering && k < frame.request.bands.size(); ++k)
        addHaze(hazeGains(frame.scene(), frame.request.view, frame.request.bands[k],
                          frame.request.pathDepth),
                all[k]);
    return all;
}

Frame Renderer::Impl::frame(const Scene& scene, const SensorView& view, const Outputs& outputs) {
    FrameRequest request(scene, view, outputs);
    std::vector<ObjectGeometry> geometry = planner.geometry(request);
    checkScene(scene.entities, geometry, scene.environment, view.sensor, request.bands,
               scene.settings);
    FrameEngine engine = engines.of(request, geometry);
    if (std::optional<Frame> known = spectraAlong.frame(request, geometry, engine))
        return *std::move(known);
    SceneEvaluation evaluation = evaluator.evaluate(request, std::move(geometry));
    FrameBackgrounds backgrounds =
        evaluator.backgrounds(request, evaluation, engine.terrainPainter);
    const bool isAllHidden = std::ranges::all_of(
        evaluation.geometry, [](const auto& object) { return object.hidden == HiddenPart::all; });
    SurfaceShading shading = isAllHidden ? SurfaceShading{} : shader.shade(request, evaluation);
    std::vector<SurfaceItem> items = surfaceItems(scene.entities, evaluation.surfaceRows());
    std::vector<GroundBefore> ground = groundBefore(request, evaluation.geometry, engine.isRays);
    SceneSurfaces ofScene{scene,
                          std::move(engine),
                          std::move(evaluation),
                          std::move(shading),
                          std::move(items),
                          std::move(ground)};
    FramePlan plan = planner.plan(request, ofScene, backgrounds);
    Frame frame{std::move(request), std::move(ofScene), std::move(backgrounds), std::move(plan)};
    spectraAlong.addTo(frame);
    return frame;
}

struct Renderer::Explainer {
    Explainer(Impl& of, const Scene& ofScene, SensorView ofView)
        : scene(withRays(ofScene)),
          view(std::move(ofView)),
          frame(of.frame(scene, view, Outputs::image())),
          pixels(frame, of.sampler, of.surfaces, of.aspects, of.terrainRays, of.occluderStacks) {}
    Explainer(const Explainer&) = delete;
    Explainer& operator=(const Explainer&) = delete;

    const Scene scene;
    const SensorView view;
    const Frame frame; // of these
    PixelExplainer pixels;
};

std::function<PixelExplanation(int x, int y)> Renderer::explainer(const Scene& scene,
                                                                  const SensorView& view) {
    return [ready = std::make_shared<Explainer>(*impl_, scene, view)](int x, int y) {
        return ready->pixels.at(x, y);
    };
}

void Renderer::check(const Scene& scene, const SensorView& view, const Outputs& outputs) {
    FrameRequest request(scene, view, outputs);
    const std::vector<ObjectGeometry> geometry = impl_->planner.geometry(request);
    checkScene(scene.entities, geometry, scene.environment, view.sensor, request.bands,
               scene.settings);
    std::vector<Diagnostic> diagnostics;
    std::set<AtmosphereProperty> quantities;
    for (const AtmosphericQueryKey& query : atmosphereQueries(
             scene.environment, impl_->terms, geometry, scene.settings, request.centre))
        quantities.insert(query.quantity);
    const bool isWideband = scene.settings.mode == CalculationMode::wideband;
    for (const AtmosphereProperty quantity : quantities)
        for (const Band& band : request.bands)
            collect(diagnostics,
                    [&] { scene.environment.checkProvided(quantity, band.range(), isWideband); });
    if (scene.settings.scattering)
        collect(diagnostics, [&] { impl_->haze.check(scene.environment); });
    if (!diagnostics.empty())
        throw InputError(diagnostics);
}

Vec3 Renderer::referencePoint(const Entity& entity) {
    return impl_->prepared.referencePoint(entity);
}
double Renderer::reach_m(const Entity& entity) {
    return impl_->prepared.reach_m(entity);
}
std::string Renderer::rendererDescription(const Scene& scene) {
    return impl_->engines.description(scene);
}
std::size_t Renderer::graphicsMemory_bytes() const {
    return impl_->engines.graphicsMemory_bytes();
}
StageTimes Renderer::stageTimes() const {
    return {impl_->clock.stages()};
}

} // namespace irsg

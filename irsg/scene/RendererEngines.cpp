#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/render/background/TerrainPass.h"
#include "irsg/render/opengl/GlEngine.h"
#include "irsg/render/rays/RayEngine.h"
#include "irsg/render/sampling/LayerSort.h"
#include "irsg/scene/RendererImpl.h"

namespace irsg {

namespace {

/// Part of the square about an object's bounding sphere in which the object is seen: that of a
/// sphere in the sphere about its box.
constexpr double coveredPart = 0.25;
/// Surfaces of a closed shell that a ray meets.
constexpr double wallsOfShell = 2.0;

/// Mesa's renderers that have no graphics card.
bool isSoftware(const std::string& renderer) {
    return std::ranges::any_of(
        std::initializer_list<const char*>{"llvmpipe", "softpipe", "SWR"},
        [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

} // namespace

SampleEngine& Renderer::Impl::engineOf(EngineChoice engine) {
    if (engine == EngineChoice::rays) {
        if (!areRaysBuilt())
            throw InputError(
                {"settings", "render.engine", whyNoRays(), "opengl, or a build with Embree 3"});
        if (!rays)
            rays = std::make_unique<RayEngine>();
        return *rays;
    }
    if (!opengl)
        opengl = std::make_unique<GlEngine>();
    return *opengl;
}

EngineWork Renderer::Impl::workOf(const Scene& scene, const Frame* frame) {
    const RenderSettings& settings = scene.settings;
    const Sensor sensor = frame != nullptr ? frame->camera.sensor() : Sensor();
    const double width_px = sensor.width_px, height_px = sensor.height_px;
    const double perAxis =
        settings.countsPerPixel ? std::sqrt(settings.samplesPerAxis) : settings.samplesPerAxis;
    EngineWork work;
    double transparentFacets = 0.0;
    for (std::size_t e = 0; e < scene.entities.size(); ++e) {
        const Entity& entity = scene.entities[e];
        const PreparedModel& model = prepared.of(entity);
        work.facets += static_cast<double>(model.facets());
        for (const DrawItem& item : model.items) {
            const Material* material = materialEntry(entity, item.codes.material);
            if (material == nullptr)
                continue;
            if (!material->isOpaque())
                for (const auto& primitives : item.geometry->getPrimitiveSetList())
                    transparentFacets += primitives->getNumIndices() / 3.0;
        }
        double across_px = std::min(width_px, height_px);
        if (frame != nullptr)
            across_px = entity.model->bounds().diagonal_m() /
                        (std::max(frame->geometry[e].path.range_m, 1e-3) * sensor.pixelPitch());
        // Windows are as fine as an object needs, and the frame is no larger.
        const double square = settings.zoomWindow > 0
                                  ? std::pow(std::max<double>(settings.zoomWindow, across_px), 2)
                                  : std::pow(across_px * perAxis, 2);
        const double most = width_px * height_px * perAxis * perAxis;
        if (settings.zoomWindow > 0)
            work.samples += std::min(square, std::max(most, std::pow(settings.zoomWindow, 2)));
        work.covered += coveredPart * std::min(square, most / coveredPart);
    }
    if (settings.zoomWindow == 0)
        work.samples = width_px * height_px * perAxis * perAxis;
    work.covered = std::min(work.covered, work.samples);
    if (work.facets > 0.0)
        work.layers = wallsOfShell * transparentFacets / work.facets;
    return work;
}

Renderer::Impl::ChosenEngine Renderer::Impl::chosenEngine(const Scene& scene, const Frame* frame) {
    if (scene.settings.engine != EngineChoice::automatic)
        return {scene.settings.engine, ""};
    if (!areRaysBuilt())
        return {EngineChoice::opengl, "this build has no rays"};
    try {
        if (!isSoftware(engineOf(EngineChoice::opengl).description()))
            return {EngineChoice::opengl, "there is a graphics card"};
    } catch (const InputError&) {
        return {EngineChoice::rays, "this machine has no OpenGL"};
    }
    const EngineWork work = workOf(scene, frame);
    return {quickerEngine(work), wordsOf(work)};
}

std::string Renderer::Impl::descriptionOf(const ChosenEngine& chosen) {
    const std::string who = engineOf(chosen.engine).description();
    return chosen.why.empty() ? who : who + " (auto: " + chosen.why + ")";
}

TerrainPainter& Renderer::Impl::terrainPainter(const Frame& frame) {
    if (usesRays(frame))
        return rayTerrain;
    if (!glTerrain)
        glTerrain = std::make_unique<GlTerrain>();
    return *glTerrain;
}

void Renderer::Impl::takeEngine(Frame& frame) {
    const ChosenEngine chosen = chosenEngine(frame.scene, &frame);
    frame.engine = &engineOf(chosen.engine);
    frame.renderer = descriptionOf(chosen);
    if (frame.scene.settings.engine == EngineChoice::automatic)
        lastChosen = frame.renderer;
    if (!usesRays(frame))
        return;
    timed("ray trees", [&] {
        for (const Entity& entity : frame.scene.entities)
            frame.meshes.push_back(prepared.of(entity).forRays());
        if (frame.scene.terrain && frame.scene.settings.terrainHides)
            frame.terrainMesh = rayTerrain.meshOf(frame.scene.terrain);
    });
}

std::vector<SunShadows::Caster> Renderer::Impl::casters(const Frame& frame) {
    return timed("ray trees", [&] {
        const SurfaceRows& rows = frame.surfaceRows();
        std::vector<SunShadows::Caster> casters;
        for (int e = 0; e < static_cast<int>(frame.scene.entities.size()); ++e) {
            PreparedModel& model = prepared.of(frame.entity(e));
            SunShadows::Caster& caster = casters.emplace_back();
            caster.entity = e;
            caster.mesh = model.forRays();
            caster.pose = frame.entity(e).pose;
            caster.uses = PieceUses(model.items.size());
            for (std::size_t i = 0; i < model.items.size(); ++i) {
                const DrawItem& item = model.items[i];
                const auto key = std::ranges::lower_bound(rows.keys(), SurfaceKey{e, item.codes});
                const auto row = static_cast<int>(key - rows.keys().begin());
                caster.rows.push_back(row);
                caster.materials.push_back(rows.material(row).second);
                caster.uses.set(i,
                                {true, rows.isTransparent(row), item.cullsBackFaces, item.layer});
            }
        }
        if (frame.scene.terrain && frame.scene.settings.terrainHides) {
            SunShadows::Caster& caster = casters.emplace_back();
            caster.mesh = rayTerrain.meshOf(frame.scene.terrain);
            caster.pose = frame.scene.terrain->pose();
            caster.uses = PieceUses(caster.mesh->pieces());
            for (std::size_t i = 0; i < caster.mesh->pieces(); ++i)
                caster.uses.set(i, {.isThere = true});
        }
        return casters;
    });
}

std::vector<SunShadows::Sunlit> Renderer::Impl::sunlitOf(const Frame& frame,
                                                         const std::vector<int>& shadowed,
                                                         const SunShadows& shadows) {
    sunlitFacets.letGo([](const auto& one) { return one->isGone(); });
    std::vector<SunShadows::Sunlit> all;
    for (const int from : shadowed) {
        if (from < 0)
            continue;
        const Vec3 towards =
            terms.directions[static_cast<std::size_t>(from)].world(frame.scene.environment.sun);
        const auto isKnown = [&](const SunShadows::Sunlit& one) { return one.towards == towards; };
        if (std::ranges::any_of(all, isKnown))
            continue;
        SunShadows::Sunlit& sunlit = all.emplace_back(SunShadows::Sunlit{towards, {}});
        for (const SunShadows::Caster& caster : shadows.casters()) {
            std::shared_ptr<const SunlitFacets>& facets = sunlit.facets.emplace_back();
            if (caster.rows.empty() || caster.mesh->facets() > SunlitFacets::mostFacets)
                continue;
            const Vec3 there = caster.pose.attitude.rotation().transposed() * towards;
            facets = sunlitFacets.of(
                [&](const std::shared_ptr<const SunlitFacets>& one) {
                    return one->isOf(caster.mesh, caster.uses, there, shadows.radius_rad());
                },
                [&] {
                    return std::make_shared<const SunlitFacets>(caster.mesh, caster.uses, there,
                                                                shadows.radius_rad());
                });
        }
    }
    return all;
}

void Renderer::Impl::takeShadows(Frame& frame, const Outputs& outputs) {
    const std::vector<int> shadowed = terms.shadowedFrom(frame.scene.settings);
    const bool hasShadows = std::ranges::any_of(shadowed, [](int from) { return from >= 0; });
    const bool hasLight = hasLightBetween(frame);
    if (!hasShadows && !hasLight)
        return;
    if (!areRaysBuilt()) {
        if (hasShadows)
            frame.warnings.push_back("shadows of the sun are left out: " + whyNoRays());
        if (hasLight)
            frame.warnings.push_back("light between surfaces is left out: " + whyNoRays());
        return;
    }
    std::vector<SunShadows::Caster> all = casters(frame);
    if (hasLight)
        takeExchange(frame, all);
    if (hasShadows || frame.exchange) {
        // What reflects nothing, such as gas, may where its emissivity is scaled.
        constexpr double rounding_per_sr = 1e-9;
        std::vector<bool> reflects;
        if (outputs.scalings().empty())
            for (const SurfaceSpectra& surface : frame.evaluated->radiometry.surfaces())
                reflects.push_back(std::ranges::any_of(
                    surface.reflectance, [](double value) { return value > rounding_per_sr; }));
        auto shadows =
            std::make_shared<SunShadows>(std::move(all), std::move(reflects),
                                         frame.scene.settings.sunShadows == SunShadowMode::disc);
        if (frame.exchange)
            shadows->setPlaces(placesOf(frame));
        shadows->setSunlit(sunlitOf(frame, shadowed, *shadows));
        frame.shadows = std::move(shadows);
    }
    if (shadowingTerrain != frame.scene.terrain) {
        shadowingTerrain = frame.scene.terrain;
        pointSources = {};
        rangeFactors = {};
    }
}

void Renderer::Impl::sortAndShade(const Frame& frame, const SheetScene& sheet,
                                  FactorSamples& samples) {
    sortLayers(samples, frame.scene.settings.maximumLayers);
    shade(frame, sheet, samples);
}

void Renderer::Impl::shade(const Frame& frame, const SheetScene& sheet,
                           FactorSamples& samples) const {
    if (frame.shadows)
        frame.shadows->apply(sheet, frame.scene.settings.truthLayers, samples);
    if (frame.lobes)
        frame.lobes->apply(sheet, frame.exchange ? frame.shadows.get() : nullptr, samples);
}

} // namespace irsg

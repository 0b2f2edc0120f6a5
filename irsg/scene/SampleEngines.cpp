#include "irsg/scene/SampleEngines.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/render/background/TerrainPass.h"
#include "irsg/render/opengl/GlEngine.h"
#include "irsg/render/rays/RayEngine.h"

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

SampleEngine& SampleEngines::engineOf(EngineChoice engine) {
    if (engine == EngineChoice::rays) {
        if (!areRaysBuilt())
            throw InputError(
                {"settings", "render.engine", whyNoRays(), "opengl, or a build with Embree 3"});
        if (!rays_)
            rays_ = std::make_unique<RayEngine>();
        return *rays_;
    }
    if (!opengl_)
        opengl_ = std::make_unique<GlEngine>();
    return *opengl_;
}

EngineWork SampleEngines::workOf(const Scene& scene, const Sensor& sensor,
                                 const std::vector<ObjectGeometry>& geometry) {
    const RenderSettings& settings = scene.settings;
    const double width_px = sensor.width_px, height_px = sensor.height_px;
    const double perAxis =
        settings.countsPerPixel ? std::sqrt(settings.samplesPerAxis) : settings.samplesPerAxis;
    EngineWork work;
    double transparentFacets = 0.0;
    for (std::size_t e = 0; e < scene.entities.size(); ++e) {
        const Entity& entity = scene.entities[e];
        const Mesh& mesh = *entity.model->mesh();
        work.facets += static_cast<double>(mesh.facets());
        for (const Mesh::Part& part : mesh.parts) {
            const Material* material = materialEntry(entity, part.codes.material);
            if (material != nullptr && !material->isOpaque())
                transparentFacets += static_cast<double>(part.triangles.size()) / 3.0;
        }
        double across_px = std::min(width_px, height_px);
        if (e < geometry.size())
            across_px = entity.model->bounds().diagonal_m() /
                        (std::max(geometry[e].path.range_m, 1e-3) * sensor.pixelPitch());
        // Windows are as fine as an object needs, and the frame is no larger.
        const double square =
            settings.tileSide_samples > 0
                ? std::pow(std::max<double>(settings.tileSide_samples, across_px), 2)
                : std::pow(across_px * perAxis, 2);
        const double most = width_px * height_px * perAxis * perAxis;
        if (settings.tileSide_samples > 0)
            work.samples +=
                std::min(square, std::max(most, std::pow(settings.tileSide_samples, 2)));
        work.covered += coveredPart * std::min(square, most / coveredPart);
    }
    if (settings.tileSide_samples == 0)
        work.samples = width_px * height_px * perAxis * perAxis;
    work.covered = std::min(work.covered, work.samples);
    if (work.facets > 0.0)
        work.layers = wallsOfShell * transparentFacets / work.facets;
    return work;
}

SampleEngines::Choice SampleEngines::choose(const Scene& scene, const Sensor& sensor,
                                            const std::vector<ObjectGeometry>& geometry) {
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
    const EngineWork work = workOf(scene, sensor, geometry);
    return {quickerEngine(work), wordsOf(work)};
}

std::string SampleEngines::descriptionOf(const Choice& choice) {
    const std::string who = engineOf(choice.engine).description();
    return choice.why.empty() ? who : who + " (auto: " + choice.why + ")";
}

TerrainPainter& SampleEngines::terrainPainter(EngineChoice engine) {
    if (engine == EngineChoice::rays)
        return terrainRays_;
    if (!glTerrain_)
        glTerrain_ = std::make_unique<GlTerrain>();
    return *glTerrain_;
}

FrameEngine SampleEngines::of(const FrameRequest& request,
                              const std::vector<ObjectGeometry>& geometry) {
    const Scene& scene = request.scene;
    const Choice choice = choose(scene, request.camera.sensor(), geometry);
    SampleEngine& engine = engineOf(choice.engine);
    const bool isRays = choice.engine == EngineChoice::rays;
    std::string description = descriptionOf(choice);
    if (scene.settings.engine == EngineChoice::automatic)
        lastChosen_ = description;
    std::vector<std::shared_ptr<const RayMesh>> meshes;
    std::shared_ptr<const RayMesh> terrainMesh;
    if (isRays)
        clock_.timed("ray trees", [&] {
            for (const Entity& entity : scene.entities)
                meshes.push_back(prepared_.of(entity).forRays());
            if (scene.terrain && scene.settings.terrainHides)
                terrainMesh = terrainRays_.meshOf(scene.terrain);
        });
    return {engine,
            terrainPainter(choice.engine),
            isRays,
            std::move(description),
            std::move(meshes),
            std::move(terrainMesh)};
}

std::string SampleEngines::description(const Scene& scene) {
    prepared_.keep(scene.entities);
    if (scene.settings.engine == EngineChoice::automatic && !lastChosen_.empty())
        return lastChosen_;
    return descriptionOf(choose(scene, Sensor(), {}));
}

} // namespace irsg

#include "irsg/scene/SurfaceShader.h"

#include <algorithm>
#include <utility>

#include "irsg/radiance/HotSpotSurfaces.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// What is transparent and reflects less everywhere is gas, which has no surface: inter-reflection
/// passes it unchanged.
constexpr double leastReflectivityOfPanes = 1e-4;

bool reflects(const SurfaceSpectra& surface) {
    // By the material itself: a scale of a gas' emissivity makes no pane of it.
    for (std::size_t node = 0; node < surface.emissivity.size(); ++node)
        if (surface.absorbsAtMost(node) - surface.emissivity[node] > leastReflectivityOfPanes)
            return true;
    return false;
}

/// Which triangles the samples of a drawing lie in.
SunShadows::LightPlaces placesOf(const InterReflected& between, const SurfaceRows& rows) {
    SunShadows::LightPlaces places;
    for (std::size_t b = 0; b < between.exchange->bodies().size(); ++b) {
        places.meshes.push_back(between.exchange->bodies()[b].light->nodes().shared());
        places.firstCell.push_back(between.exchange->firstCell(b));
    }
    for (int drawn = 0; drawn < static_cast<int>(rows.keys().size()); ++drawn)
        places.matters.push_back(between.light->matters(drawn));
    places.openAt = [exchange = between.exchange](std::uint32_t place) {
        return exchange->openAt(place);
    };
    return places;
}

} // namespace

std::vector<SunShadows::Caster> SurfaceShader::casters(const Scene& scene,
                                                       const SceneEvaluation& evaluation) {
    const SurfaceRows& rows = evaluation.surfaceRows();
    return clock_.timed("ray trees", [&] {
        std::vector<SunShadows::Caster> casters;
        for (int e = 0; e < static_cast<int>(scene.entities.size()); ++e) {
            const Entity& entity = scene.entities[static_cast<std::size_t>(e)];
            PreparedModel& model = prepared_.of(entity);
            SunShadows::Caster& caster = casters.emplace_back();
            caster.entity = e;
            caster.mesh = model.forRays();
            caster.pose = entity.pose;
            const Mesh& mesh = model.mesh();
            caster.uses = PieceUses(mesh.pieces.size());
            for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
                const Mesh::Part& part = mesh.partOf(mesh.pieces[i]);
                const auto key = std::ranges::lower_bound(rows.keys(), SurfaceKey{e, part.codes});
                const auto row = static_cast<int>(key - rows.keys().begin());
                caster.rows.push_back(row);
                caster.materials.push_back(rows.material(row).second);
                const bool isTransparent = rows.isTransparent(row);
                const bool isPane =
                    isTransparent &&
                    reflects(
                        evaluation.evaluated->radiometry.surfaces()[static_cast<std::size_t>(row)]);
                // Gas takes away nothing of the light that surfaces get.
                caster.uses.set(i, {rows.gas(row) == nullptr, isTransparent, part.culled,
                                    part.layer, isPane ? caster.materials.back() + 1 : 0});
            }
        }
        if (scene.terrain && scene.settings.terrainHides) {
            SunShadows::Caster& caster = casters.emplace_back();
            caster.mesh = terrainRays_.meshOf(scene.terrain);
            caster.pose = scene.terrain->pose();
            caster.uses = PieceUses(caster.mesh->pieces());
            for (std::size_t i = 0; i < caster.mesh->pieces(); ++i)
                caster.uses.set(i, {.isThere = true});
        }
        return casters;
    });
}

std::vector<SunShadows::Sunlit> SurfaceShader::sunlitOf(const Scene& scene,
                                                        const std::vector<int>& shadowed,
                                                        const SunShadows& shadows) {
    sunlitFacets_.letGo([](const auto& one) { return one->isGone(); });
    std::vector<SunShadows::Sunlit> all;
    for (const int from : shadowed) {
        if (from < 0)
            continue;
        const Vec3 towards =
            terms_.directions[static_cast<std::size_t>(from)].world(scene.environment.sun);
        const auto isKnown = [&](const SunShadows::Sunlit& one) { return one.towards == towards; };
        if (std::ranges::any_of(all, isKnown))
            continue;
        SunShadows::Sunlit& sunlit = all.emplace_back(SunShadows::Sunlit{towards, {}});
        for (const SunShadows::Caster& caster : shadows.casters()) {
            std::shared_ptr<const SunlitFacets>& facets = sunlit.facets.emplace_back();
            if (caster.rows.empty() || caster.mesh->facets() > SunlitFacets::mostFacets)
                continue;
            const Vec3 there = caster.pose.attitude.rotation().transposed() * towards;
            facets = sunlitFacets_.of(
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

SurfaceShading SurfaceShader::shade(const FrameRequest& request,
                                    const SceneEvaluation& evaluation) {
    const Scene& scene = request.scene;
    SurfaceShading shading;
    shading.hasGas = evaluation.surfaceRows().hasGas();
    shading.lobes = lobesOf(scene.settings, evaluation);
    const std::vector<int> shadowed = terms_.shadowedFrom(scene.settings);
    const bool hasShadows = std::ranges::any_of(shadowed, [](int from) { return from >= 0; });
    const bool hasLight = InterReflection::isAskedFor(scene.settings);
    if (!hasShadows && !hasLight)
        return shading;
    if (!areRaysBuilt()) {
        if (hasShadows)
            shading.warnings.push_back("shadows of the sun are left out: " + whyNoRays());
        if (hasLight)
            shading.warnings.push_back("inter-reflection is left out: " + whyNoRays());
        return shading;
    }
    std::vector<SunShadows::Caster> all = casters(scene, evaluation);
    if (hasLight)
        shading.between = interReflection_.of(scene, evaluation, all);
    if (shading.lobes && shading.between.exchange)
        shading.aims = aimsOf(request, evaluation, shading.between.exchange);
    if (!hasShadows && !shading.between.exchange)
        return shading;
    // What reflects nothing, such as gas, may where its emissivity is scaled.
    constexpr double rounding_per_sr = 1e-9;
    std::vector<bool> reflects;
    if (!request.isScaled)
        for (const SurfaceSpectra& surface : evaluation.evaluated->radiometry.surfaces())
            reflects.push_back(std::ranges::any_of(
                surface.reflectance, [](double value) { return value > rounding_per_sr; }));
    auto shadows = std::make_shared<SunShadows>(std::move(all), std::move(reflects),
                                                scene.settings.sunShadows == SunShadowMode::disc);
    if (shading.between.exchange)
        shadows->setPlaces(placesOf(shading.between, evaluation.surfaceRows()));
    shadows->setSunlit(sunlitOf(scene, shadowed, *shadows));
    shading.shadows = std::move(shadows);
    shading.joins = joinsOf(evaluation);
    return shading;
}

JoinLimits SurfaceShader::joinsOf(const SceneEvaluation& evaluation) const {
    JoinLimits limits;
    // What sums of factors make of them does not depend on it; places and lobes are those of one.
    constexpr double mostDifference = 0.2, bendOfRoughness = 0.25;
    limits.firstNormal = terms_.lobeRoles().size();
    const SurfaceRows& rows = evaluation.surfaceRows();
    for (int row = 0; row < static_cast<int>(rows.renderedCount()); ++row)
        limits.isGas.push_back(rows.gas(row) != nullptr);
    for (const auto& model : evaluation.evaluated->radiometry.models()) {
        const bool isMirror = model && model->facets().size() == 1;
        limits.mostDifference.push_back(isMirror ? 0.0 : mostDifference);
        limits.mostBend.push_back(
            model ? std::min(bendOfRoughness * model->roughness(), mostDifference)
                  : mostDifference);
    }
    return limits;
}

std::shared_ptr<const LobeAims>
SurfaceShader::aimsOf(const FrameRequest& request, const SceneEvaluation& evaluation,
                      const std::shared_ptr<const LightExchange>& exchange) {
    std::vector<bool> bright =
        hotSurfaces(evaluation.evaluated->radiometry, request.scene.entities);
    if (std::ranges::find(bright, true) == bright.end())
        return nullptr;
    return aims_
        .of([&](const KnownAims& one) { return one.exchange == exchange && one.bright == bright; },
            [&] {
                auto aims = std::make_shared<const LobeAims>(*exchange, bright);
                return KnownAims{exchange, bright, std::move(aims)};
            })
        .aims;
}

std::shared_ptr<const LobeQuadrature>
SurfaceShader::lobesOf(const RenderSettings& settings, const SceneEvaluation& evaluation) const {
    const SurfaceRows& rows = evaluation.surfaceRows();
    if (rows.lobes().empty())
        return nullptr;
    LobeQuadrature::Making making;
    making.models = evaluation.evaluated->radiometry.models();
    making.mirrors = MirrorReflectivity(evaluation.evaluated->radiometry, settings.bounces);
    for (const ObjectGeometry& object : evaluation.geometry)
        making.grids.push_back(object.mirror);
    making.roles = terms_.lobeRoles();
    making.tables = lobeTables_;
    making.isSunSmart = settings.sun == ReflectionMode::smart;
    for (std::size_t i = 0; i < terms_.directions.size(); ++i) {
        if (terms_.directions[i].name == "zenithEye")
            making.zenith = static_cast<int>(i);
        if (terms_.directions[i].name == "sunEye")
            making.sun = static_cast<int>(i);
    }
    return std::make_shared<const LobeQuadrature>(rows, std::move(making));
}

} // namespace irsg

#include "irsg/scene/InterReflection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "irsg/atmosphere/ReflectingGround.h"
#include "irsg/core/Errors.h"
#include "irsg/radiance/MirrorReflectivity.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/KeyNumbers.h"

namespace irsg {

namespace {

/// What a surface of a cosine to the zenith sees of the sky.
double skyFactor(double cosine) {
    return 0.5 * (1.0 + cosine);
}
double publishedSkyFactor(double cosine) {
    return 1.0 - std::acos(std::clamp(cosine, -1.0, 1.0)) / pi;
}

/// Of the atmosphere that answers for the light of the ground; nothing where it is not known, or
/// the ground is black.
std::optional<Spectrum> groundReflectivityOf(const Environment& environment) {
    for (const auto& atmosphere : environment.atmospheres()) {
        if (!atmosphere->supports(AtmosphereProperty::upwardFlux))
            continue;
        const auto* ground = dynamic_cast<const ReflectingGround*>(atmosphere.get());
        if (ground == nullptr)
            return std::nullopt;
        Spectrum reflectivity = ground->groundReflectivity();
        const bool isBlack =
            std::ranges::none_of(reflectivity.values(), [](double value) { return value > 1e-4; });
        return isBlack ? std::nullopt : std::optional(std::move(reflectivity));
    }
    return std::nullopt;
}

LightSources sourcesOf(const Scene& scene) {
    const RenderSettings& settings = scene.settings;
    LightSources sources;
    sources.towardsSun =
        direction(scene.environment.sun.azimuth_rad, scene.environment.sun.elevation_rad);
    sources.skyOf = settings.fluxWeights == FluxWeights::report ? publishedSkyFactor : skyFactor;
    sources.isSkyOn = settings.ambientReflection != ReflectionMode::off;
    sources.isSunOn = settings.sun != ReflectionMode::off;
    sources.isSunShadowed = settings.sunShadows != SunShadowMode::off;
    if (settings.sun == ReflectionMode::approx)
        sources.sunAlways = 0.25;
    if (settings.ambientReflection == ReflectionMode::smart && !scene.terrain)
        sources.groundReflectivity = groundReflectivityOf(scene.environment);
    return sources;
}

/// All that light of sky, ground and sun on a body depends on beside its attitude and the ground's
/// reflectivity.
std::vector<double> numbersOf(const LightSources& sources, const RenderSettings& settings) {
    std::vector<double> all;
    appendTo(all, sources.towardsSun);
    all.insert(all.end(),
               {settings.lightError, sources.sunAlways, sources.isSkyOn ? 1.0 : 0.0,
                sources.isSunOn ? 1.0 : 0.0, sources.isSunShadowed ? 1.0 : 0.0,
                settings.terrainHides ? 1.0 : 0.0, static_cast<double>(settings.fluxWeights)});
    return all;
}

/// The mean of what surfaces emit, by output, W m-2 sr-1, with their areas by row.
std::vector<double> emissionOf(const std::map<int, double>& areas_m2, double whole_m2,
                               const SceneRadiometry& radiometry) {
    std::vector<double> means(radiometry.outputs().size());
    for (const auto& [row, area_m2] : areas_m2) {
        const SurfaceSpectra& surface = radiometry.surfaces()[static_cast<std::size_t>(row)];
        for (const SurfaceSpectra::Emission& part : surface.emission)
            for (std::size_t output = 0; output < means.size(); ++output)
                for (std::size_t i = radiometry.outputs()[output].first;
                     i < radiometry.outputs()[output].second; ++i)
                    means[output] += area_m2 / whole_m2 * part.factor * part.radiance[i] *
                                     radiometry.weights_um()[i];
    }
    return means;
}

/// The gas of each entity that has any.
std::vector<LightExchange::Gas> gasesOf(const Scene& scene, const SceneRadiometry& radiometry,
                                        const std::vector<SunShadows::Caster>& casters) {
    std::vector<LightExchange::Gas> gases;
    const SurfaceRows& rows = radiometry.rows();
    for (std::size_t e = 0; e < scene.entities.size() && rows.hasGas(); ++e) {
        const Mesh& mesh = *scene.entities[e].model->mesh();
        LightExchange::Gas gas{e, PieceUses(mesh.pieces.size()), {}, {}, {}};
        BoundingBox box = BoundingBox::nowhere();
        std::vector<double> brightest(radiometry.outputs().size(), 0.0);
        for (std::size_t piece = 0; piece < mesh.pieces.size(); ++piece) {
            const int row = casters[e].rows[piece];
            const GasZone* const zone = rows.gas(row);
            gas.volumes_m3.push_back(zone ? zone->shape.volume_m3 : 0.0);
            gas.codes.push_back(rows.keyOf(row).second);
            gas.walls.set(piece, {.isThere = zone != nullptr, .transparent = true});
            if (zone == nullptr)
                continue;
            box.include(mesh.partOf(mesh.pieces[piece]).bounds);
            const std::vector<double> own = emissionOf({{row, 1.0}}, 1.0, radiometry);
            for (std::size_t output = 0; output < own.size(); ++output)
                brightest[output] = std::max(brightest[output], own[output]);
        }
        if (!box.valid())
            continue;
        double radius_m = 0.0;
        for (std::size_t piece = 0; piece < mesh.pieces.size(); ++piece)
            for (const Float3& vertex : mesh.partOf(mesh.pieces[piece]).vertices)
                if (gas.volumes_m3[piece] > 0.0)
                    radius_m = std::max(radius_m, length(toVec3(vertex) - box.centre()));
        gas.extent = {scene.entities[e].pose.toWorld(box.centre()), radius_m, 0.0,
                      std::move(brightest)};
        gas.extent.crossSection_m2 = pi * gas.extent.radius_m * gas.extent.radius_m;
        gases.push_back(std::move(gas));
    }
    return gases;
}

} // namespace

bool InterReflection::Known::isAs(const Known& other) const {
    return numbers == other.numbers && bodies == other.bodies && terrain == other.terrain &&
           ground == other.ground && keys == other.keys && hasLobes == other.hasLobes &&
           components == other.components;
}

LightExchange::Extent InterReflection::extentOf(const Entity& entity,
                                                const SunShadows::Caster& caster,
                                                const SceneRadiometry& radiometry, bool isAlone) {
    const BoundingBox& box = entity.model->bounds();
    LightExchange::Extent extent{
        entity.pose.toWorld(box.centre()), 0.5 * box.diagonal_m(), 0.0, {}};
    if (isAlone)
        return extent;
    std::map<int, double> areas_m2;
    double whole_m2 = 0.0;
    const std::vector<double>& ofPieces_m2 = prepared_.of(entity).areasOfPieces_m2();
    for (std::size_t piece = 0; piece < ofPieces_m2.size(); ++piece)
        if ((!caster.uses[piece].transparent || caster.uses[piece].pane > 0) &&
            ofPieces_m2[piece] > 0.0) {
            areas_m2[caster.rows[piece]] += ofPieces_m2[piece];
            whole_m2 += ofPieces_m2[piece];
        }
    // Whatever a body hides, it does not hide more than half of its surface.
    extent.crossSection_m2 = std::min(pi * extent.radius_m * extent.radius_m, 0.5 * whole_m2);
    extent.emits = emissionOf(areas_m2, whole_m2, radiometry);
    return extent;
}

bool InterReflection::isAskedFor(const RenderSettings& settings) {
    return settings.bounces != 0 && settings.ambientReflection != ReflectionMode::approx;
}

std::shared_ptr<const LightExchange>
InterReflection::exchangeOf(const Scene& scene, const SceneEvaluation& evaluation,
                            const std::vector<SunShadows::Caster>& casters) {
    const RenderSettings& settings = scene.settings;
    Known key;
    LightSources sources = sourcesOf(scene);
    std::vector<LightExchange::Extent> extents;
    const SceneRadiometry& radiometry = evaluation.evaluated->radiometry;
    for (std::size_t e = 0; e < scene.entities.size(); ++e)
        extents.push_back(
            extentOf(scene.entities[e], casters[e], radiometry, scene.entities.size() == 1));
    const std::vector<LightExchange::Gas> gases = gasesOf(scene, radiometry, casters);
    std::vector<bool> isNearGround;
    for (const LightExchange::Extent& extent : extents)
        isNearGround.push_back(
            sources.groundReflectivity &&
            LightExchange::isNearGround(extent, settings.lightError, *sources.groundReflectivity));
    if (std::ranges::find(isNearGround, true) == isNearGround.end())
        sources.groundReflectivity.reset();
    std::vector<LightExchange::Body> bodies;
    bool isPlaceOfMatter = scene.terrain != nullptr;
    for (std::size_t e = 0; e < scene.entities.size(); ++e) {
        const Entity& entity = scene.entities[e];
        bool isAmongOthers = isNearGround[e];
        for (const LightExchange::Gas& gas : gases) {
            const bool isNear =
                gas.body == e || LightExchange::isNear(extents[e], gas.extent, settings.lightError);
            key.numbers.push_back(isNear ? 1.0 : 0.0);
            isAmongOthers = isAmongOthers || isNear;
            isPlaceOfMatter = isPlaceOfMatter || (isNear && gas.body != e);
        }
        isPlaceOfMatter = isPlaceOfMatter || isNearGround[e];
        for (std::size_t o = 0; o < extents.size(); ++o) {
            if (o == e)
                continue;
            const bool areNear =
                LightExchange::isNear(extents[e], extents[o], settings.lightError) ||
                LightExchange::isNear(extents[o], extents[e], settings.lightError);
            key.numbers.push_back(areNear ? 1.0 : 0.0);
            isAmongOthers = isAmongOthers || areNear;
            isPlaceOfMatter = isPlaceOfMatter || isAmongOthers ||
                              LightExchange::mayShade(extents[e], extents[o], sources.towardsSun);
        }
        bodies.push_back(
            {static_cast<int>(e),
             prepared_.of(entity).lightBetween(casters[e].uses, settings.lightError,
                                               isAmongOthers ? BodyPlace::amongOthers
                                               : !(evaluation.geometry[e].nearest_m > 0.0)
                                                   ? BodyPlace::seenFromWithin
                                               : scene.terrain ? BodyPlace::overTerrain
                                                               : BodyPlace::alone),
             extents[e]});
        key.bodies.push_back(bodies.back().light);
        appendTo(key.numbers, entity.pose.attitude);
    }
    // Those that are far from each other are lit alike wherever they stand.
    for (const Entity& entity : scene.entities)
        if (isPlaceOfMatter)
            appendTo(key.numbers, entity.pose.position_m);
    appendTo(key.numbers, numbersOf(sources, settings));
    for (const auto& [row, zone] : radiometry.rows().gases())
        key.numbers.push_back(static_cast<double>(row));
    key.hasLobes = !evaluation.surfaceRows().lobes().empty();
    if (key.hasLobes && MirrorReflectivity(radiometry, settings.bounces).isAnyFollowed())
        for (const auto& model : radiometry.models())
            key.components.push_back(model ? model->components() : 0);
    key.terrain = scene.terrain;
    key.ground = sources.groundReflectivity;
    key.keys = evaluation.surfaceRows().keys();
    if (const Known* known = exchanges_.find([&](const Known& one) { return one.isAs(key); }))
        return known->exchange;
    const bool areApart = bodies.size() > 1 && !isPlaceOfMatter && gases.empty();
    key.exchange = areApart
                       ? ofEachAlone(bodies, casters, sources, scene, key)
                       : std::make_shared<const LightExchange>(std::move(bodies), casters, sources,
                                                               settings.lightError, key.hasLobes,
                                                               key.components, gases);
    return exchanges_.add(std::move(key)).exchange;
}

std::shared_ptr<const LightExchange>
InterReflection::ofEachAlone(const std::vector<LightExchange::Body>& bodies,
                             const std::vector<SunShadows::Caster>& casters,
                             const LightSources& sources, const Scene& scene, const Known& key) {
    std::vector<std::shared_ptr<const LightExchange>> all;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const SunShadows::Caster& caster = casters[b];
        Known own;
        own.bodies = {bodies[b].light};
        own.hasLobes = key.hasLobes;
        appendTo(own.numbers, caster.pose.attitude);
        appendTo(own.numbers, numbersOf(sources, scene.settings));
        own.numbers.push_back(caster.entity);
        own.numbers.insert(own.numbers.end(), caster.rows.begin(), caster.rows.end());
        own.numbers.insert(own.numbers.end(), caster.materials.begin(), caster.materials.end());
        const auto make = [&] {
            own.exchange = std::make_shared<const LightExchange>(
                std::vector{bodies[b]}, std::vector{caster}, sources, scene.settings.lightError,
                key.hasLobes);
            return std::move(own);
        };
        all.push_back(ofBodies_.of([&](const Known& one) { return one.isAs(own); }, make).exchange);
    }
    return std::make_shared<const LightExchange>(std::move(all), casters, key.hasLobes,
                                                 key.components);
}

InterReflected InterReflection::of(const Scene& scene, const SceneEvaluation& evaluation,
                                   const std::vector<SunShadows::Caster>& casters) {
    InterReflected found;
    found.exchange =
        clock_.timed("inter-reflection", [&] { return exchangeOf(scene, evaluation, casters); });
    if (found.exchange->changesNothing())
        found.exchange = nullptr;
    EvaluatedScene& evaluated = *evaluation.evaluated;
    const bool isKnown = evaluated.light && &evaluated.light->exchange() == found.exchange.get() &&
                         evaluated.light->bounces() == scene.settings.bounces;
    if (!isKnown)
        evaluated.light = lightOf(found.exchange, evaluated.radiometry, scene.settings);
    found.light = evaluated.light;
    return found;
}

std::shared_ptr<SceneLight>
InterReflection::lightOf(const std::shared_ptr<const LightExchange>& exchange,
                         const SceneRadiometry& radiometry, const RenderSettings& settings) {
    if (!exchange)
        return nullptr;
    return clock_.timed("inter-reflection", [&] {
        return std::make_shared<SceneLight>(exchange, radiometry, occluderStacks_, settings,
                                            solutions_);
    });
}

void warnOfExchange(const LightExchange& exchange, const Scene& scene,
                    std::vector<std::string>& warnings) {
    for (const LightExchange::Body& body : exchange.bodies()) {
        if (!body.light->isLimited())
            continue;
        const auto entity = static_cast<std::size_t>(body.entity);
        warnings.push_back("the view factors between the surfaces of '" +
                           scene.entities[entity].name + "' are known to " +
                           numberText(std::round(1e4 * body.light->error()) / 1e4) + " only (" +
                           numberText(scene.settings.lightError) +
                           " was asked): that takes more rays than are sent for a model");
    }
}

} // namespace irsg

#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/scene/RendererImpl.h"

namespace irsg {

namespace {

/// What a surface of a cosine to the zenith sees of the sky.
double skyFactor(double cosine) {
    return 0.5 * (1.0 + cosine);
}
double publishedSkyFactor(double cosine) {
    return 1.0 - std::acos(std::clamp(cosine, -1.0, 1.0)) / pi;
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
    return sources;
}

} // namespace

bool Renderer::Impl::hasLightBetween(const Frame& frame) const {
    const RenderSettings& settings = frame.scene.settings;
    return settings.bounces != 0 && settings.ambientReflection != ReflectionMode::approx;
}

std::shared_ptr<const LightExchange>
Renderer::Impl::exchangeOf(const Frame& frame, const std::vector<SunShadows::Caster>& casters) {
    const RenderSettings& settings = frame.scene.settings;
    KnownExchange key;
    std::vector<LightExchange::Body> bodies;
    for (std::size_t e = 0; e < frame.scene.entities.size(); ++e) {
        const Entity& entity = frame.scene.entities[e];
        bool isAmongOthers = false;
        for (const Entity& other : frame.scene.entities) {
            const BoundingBox &box = entity.model->bounds(), &others = other.model->bounds();
            isAmongOthers =
                isAmongOthers ||
                (&other != &entity &&
                 LightExchange::areNear(entity.pose.toWorld(box.centre()), 0.5 * box.diagonal_m(),
                                        other.pose.toWorld(others.centre()),
                                        0.5 * others.diagonal_m(), settings.lightError));
        }
        bodies.push_back(
            {static_cast<int>(e),
             prepared.of(entity).lightBetween(casters[e].uses, settings.lightError, isAmongOthers),
             entity.model->bounds()});
        key.bodies.push_back(bodies.back().light);
        const Attitude& a = entity.pose.attitude;
        append(key.numbers, {a.yaw_rad, a.pitch_rad, a.roll_rad});
        // One alone is lit alike wherever it stands.
        if (frame.scene.entities.size() > 1 || frame.scene.terrain)
            append(key.numbers, entity.pose.position_m);
    }
    const LightSources sources = sourcesOf(frame.scene);
    append(key.numbers, sources.towardsSun);
    key.numbers.insert(key.numbers.end(),
                       {settings.lightError, sources.sunAlways, sources.isSkyOn ? 1.0 : 0.0,
                        sources.isSunOn ? 1.0 : 0.0, sources.isSunShadowed ? 1.0 : 0.0,
                        settings.terrainHides ? 1.0 : 0.0,
                        static_cast<double>(settings.fluxWeights)});
    key.terrain = frame.scene.terrain;
    key.keys = frame.surfaceRows().keys();
    const auto isAsked = [&](const KnownExchange& one) {
        return one.numbers == key.numbers && one.bodies == key.bodies &&
               one.terrain == key.terrain && one.keys == key.keys;
    };
    if (const KnownExchange* known = exchanges.find(isAsked))
        return known->exchange;
    key.exchange = std::make_shared<const LightExchange>(std::move(bodies), casters, sources,
                                                         settings.lightError);
    return exchanges.add(std::move(key)).exchange;
}

void Renderer::Impl::warnOfLight(const LightExchange& exchange, const Scene& scene,
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

void Renderer::Impl::takeExchange(Frame& frame, const std::vector<SunShadows::Caster>& casters) {
    frame.exchange = timed("light between surfaces", [&] { return exchangeOf(frame, casters); });
    if (frame.exchange->changesNothing())
        frame.exchange = nullptr;
    EvaluatedScene& evaluated = *frame.evaluated;
    const bool isKnown = evaluated.light && &evaluated.light->exchange() == frame.exchange.get() &&
                         evaluated.light->bounces() == frame.scene.settings.bounces;
    if (!isKnown)
        evaluated.light = lightOf(frame, evaluated.radiometry);
    frame.light = evaluated.light;
}

std::shared_ptr<SceneLight> Renderer::Impl::lightOf(const Frame& frame,
                                                    const SceneRadiometry& radiometry) {
    if (!frame.exchange)
        return nullptr;
    return timed("light between surfaces", [&] {
        return std::make_shared<SceneLight>(frame.exchange, radiometry, fronts,
                                            frame.scene.settings, lightSolutions);
    });
}

void Renderer::Impl::takeMirrorGrids(const Scene& scene, const Band& band,
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
        if (hasLobes)
            geometry[e].mirror = MirrorGrid(scene.environment.horizonElevation_rad(
                                                geometry[e].path.targetAltitude_m, band.range()),
                                            byAzimuth);
    }
}

void Renderer::Impl::takeLobes(Frame& frame) {
    const SurfaceRows& rows = frame.surfaceRows();
    if (rows.lobes().empty())
        return;
    LobeSamples::Making making;
    making.models = frame.evaluated->radiometry.models();
    for (const ObjectGeometry& object : frame.geometry)
        making.grids.push_back(object.mirror);
    making.roles = terms.lobeRoles();
    making.tables = lobeTables;
    making.isSunSmart = frame.scene.settings.sun == ReflectionMode::smart;
    for (std::size_t i = 0; i < terms.directions.size(); ++i) {
        if (terms.directions[i].name == "zenithEye")
            making.zenith = static_cast<int>(i);
        if (terms.directions[i].name == "sunEye")
            making.sun = static_cast<int>(i);
    }
    frame.lobes = std::make_shared<const LobeSamples>(rows, std::move(making));
}

void Renderer::Impl::appendLobes(const Frame& frame, std::vector<double>& numbers) {
    if (!frame.lobes)
        return;
    for (const auto& model : frame.evaluated->radiometry.models()) {
        numbers.push_back(model ? 1.0 : 0.0);
        if (model)
            numbers.insert(numbers.end(), model->key().begin(), model->key().end());
    }
    for (const ObjectGeometry& object : frame.geometry)
        for (const double number : object.mirror.key())
            numbers.push_back(number);
}

void Renderer::Impl::appendReceivers(const Frame& frame, std::vector<double>& numbers) {
    if (!frame.exchange)
        return;
    numbers.push_back(frame.scene.settings.lightError);
    for (const LightExchange::Body& body : frame.exchange->bodies()) {
        numbers.push_back(static_cast<double>(body.light->nodes().receivers()));
        numbers.push_back(static_cast<double>(body.light->mesh().triangles()));
    }
}

SunShadows::LightPlaces Renderer::Impl::placesOf(const Frame& frame) {
    SunShadows::LightPlaces places;
    for (std::size_t b = 0; b < frame.exchange->bodies().size(); ++b) {
        places.meshes.push_back(frame.exchange->bodies()[b].light->nodes().shared());
        places.firstTriangle.push_back(frame.exchange->firstTriangle(b));
    }
    for (int drawn = 0; drawn < static_cast<int>(frame.surfaceRows().keys().size()); ++drawn)
        places.matters.push_back(frame.light->matters(drawn));
    places.openAt = [exchange = frame.exchange](std::uint32_t place) {
        return exchange->openAt(place);
    };
    return places;
}

} // namespace irsg

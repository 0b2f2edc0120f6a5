#include "irsg/scene/SceneCheck.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "irsg/atmosphere/AtmosphereScatteringLut.h"
#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/gas/GasLayer.h"
#include "irsg/radiance/SceneSampling.h"
#include "irsg/radiance/SurfaceTemperatures.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "irsg/scene/scattering/SceneScattering.h"
#include "irsg/signature/SurfaceModels.h"

namespace irsg {

namespace {

/// An altitude that is negative by rounding alone is the ground.
double altitude_m(double z_m, double range_m, const std::string& what,
                  std::vector<Diagnostic>& diagnostics) {
    if (z_m < -1e-6 * std::max(1.0, range_m))
        diagnostics.push_back({what, "altitude", roundedText(z_m) + " m",
                               "at least 0 m: raise the target, or look from above"});
    return std::max(z_m, 0.0);
}

/// Nothing that is solid, and no flame, is near it.
constexpr double hottest_K = 1e5;

std::string faces(int count) {
    return std::to_string(count) + (count == 1 ? " face" : " faces");
}

/// A gas fills closed meshes, and its tables reach what it holds at its temperature.
void checkGases(const Entity& entity, const std::vector<EntityState>& states,
                std::vector<Diagnostic>& diagnostics) {
    for (const auto& [codes, use] : entity.model->codes()) {
        const Material* material = materialEntry(entity, codes.material);
        const TemperatureEntry* temperature = temperatureEntry(entity, codes.temperature);
        if (!material || !temperature || !material->isGas())
            continue;
        const std::string place = "gas of material index " + std::to_string(codes.material) + " (" +
                                  material->name + ") and temperature index " +
                                  std::to_string(codes.temperature);
        if (temperature->mode == EmissionMode::userSpectrum) {
            diagnostics.push_back({entity.name, place,
                                   "the spectrum '" + temperature->userSpectrum + "'",
                                   "a temperature of eq. 7: a gas has no spectrum of its own"});
            continue;
        }
        // The present state, then the others of a sweep: the first that is out of reach.
        for (const EntityState& state : states) {
            GasLayer gas = gasOf(*material, surfaceTemperature_K(entity, codes.temperature, state));
            gas.length_m = 1.0;
            auto wrong = gasLayerDiagnostics(gas, entity.name);
            if (wrong.empty())
                continue;
            for (Diagnostic& one : wrong) {
                one.position = place + " at time " + roundedText(state.time_s) + " s and power " +
                               roundedText(state.power) + ", " + one.position;
                diagnostics.push_back(std::move(one));
            }
            break;
        }
        const GasZoneShape shape = gasZoneShape(entity.model->mesh(), codes);
        if (shape.openEdges > 0)
            diagnostics.push_back({entity.name, place,
                                   std::to_string(shape.openEdges) +
                                       " edges of an open mesh, or of faces that are turned over",
                                   "closed meshes, whose faces all look outwards"});
    }
}

/// The states that an entity's surfaces are evaluated in: the present one, then the others of its
/// sweep.
std::vector<EntityState> statesInPlace(const Entity& entity, const ObjectGeometry& geometry,
                                       double ambient_K) {
    std::vector<EntityState> states{stateInPlace(entity, geometry, ambient_K)};
    Entity other = entity;
    for (const EntityState& state : entity.otherStates) {
        other.state = state;
        states.push_back(stateInPlace(other, geometry, ambient_K));
    }
    return states;
}

/// A temperature that no surface has, in the first of the states that has one.
void checkTemperature(const Entity& entity, int index, const std::string& place,
                      const std::vector<EntityState>& states,
                      std::vector<Diagnostic>& diagnostics) {
    for (const EntityState& state : states) {
        const double temperature_K = surfaceTemperature_K(entity, index, state);
        const std::string when = place + " at time " + roundedText(state.time_s) + " s";
        const std::string found = roundedText(temperature_K) + " K";
        if (!(temperature_K > 0.0) || !std::isfinite(temperature_K))
            diagnostics.push_back({entity.name, when, found,
                                   "a positive temperature at power " + roundedText(state.power) +
                                       ", Mach " + roundedText(state.mach)});
        else if (temperature_K > hottest_K)
            diagnostics.push_back({entity.name, when, found,
                                   "at most " + roundedText(hottest_K) +
                                       " K: no surface is hotter; is a unit or a factor wrong?"});
        else
            continue;
        return;
    }
}

void checkEntity(const Entity& entity, const ObjectGeometry& geometry, double ambient_K,
                 const std::vector<Band>& bands, std::vector<Diagnostic>& diagnostics) {
    // One diagnostic an index, with all the faces that carry it.
    std::map<int, int> missingTemperatures, missingMaterials;
    for (const auto& [codes, use] : entity.model->codes()) {
        if (!temperatureEntry(entity, codes.temperature))
            missingTemperatures[codes.temperature] += use.faces;
        if (!materialEntry(entity, codes.material))
            missingMaterials[codes.material] += use.faces;
    }
    auto missing = [&](const char* kind, const std::map<int, int>& indices) {
        for (const auto& [index, count] : indices)
            diagnostics.push_back({entity.name,
                                   std::string(kind) + " index " + std::to_string(index),
                                   faces(count) + " of " + entity.model->name() + " carry it",
                                   "an entry in the signature database, or a fallback entry"});
    };
    missing("temperature", missingTemperatures);
    missing("material", missingMaterials);

    const std::vector<EntityState> states = statesInPlace(entity, geometry, ambient_K);
    std::map<int, const TemperatureEntry*> temperatures;
    std::map<int, const Material*> materials;
    for (const auto& [codes, use] : entity.model->codes()) {
        if (const TemperatureEntry* entry = temperatureEntry(entity, codes.temperature))
            temperatures.emplace(codes.temperature, entry);
        if (const Material* material = materialEntry(entity, codes.material))
            materials.emplace(codes.material, material);
    }
    for (const auto& [index, entry] : temperatures) {
        const std::string place =
            "temperature index " + std::to_string(index) + " (" + entry->name + ")";
        if (entry->mode == EmissionMode::userSpectrum) {
            if (!entity.database->spectra.contains(entry->userSpectrum))
                diagnostics.push_back({entity.name, place, "spectrum '" + entry->userSpectrum + "'",
                                       "the name of a spectrum of the database"});
            continue;
        }
        checkTemperature(entity, index, place, states, diagnostics);
    }
    checkGases(entity, states, diagnostics);
    for (const auto& [index, material] : materials) {
        if (material->isGas())
            continue;
        collect(
            diagnostics, [&, &of = *material] { surfaceModelOf(of); },
            [&, index = index, &of = *material](Diagnostic& one) {
                one.file = entity.name;
                one.position = "material index " + std::to_string(index) + " (" + of.name + ") " +
                               one.position;
            });
    }
    const auto check = [&](int index, const Material* material, const Band& band) {
        for (const auto& [name, spectrum] :
             {std::pair("emissivity", &material->emissivity),
              std::pair("transmissivity", &material->transmissivity),
              std::pair("refractive index", &material->refractiveIndex),
              std::pair("extinction", &material->extinction)})
            if (!spectrum->covers(band.range()))
                diagnostics.push_back({entity.name,
                                       "material index " + std::to_string(index) + " (" +
                                           material->name + ") " + name,
                                       roundedText(spectrum->wavelengths_um().front()) + " to " +
                                           roundedText(spectrum->wavelengths_um().back()) + " um",
                                       "a spectrum that covers the band " +
                                           roundedText(band.range().min_um) + " to " +
                                           roundedText(band.range().max_um) + " um"});
    };
    for (const auto& [index, material] : materials)
        for (const Band& band : bands)
            check(index, material, band);
}

} // namespace

std::vector<ObjectGeometry> objectGeometry(const std::vector<Entity>& entities,
                                           const std::vector<Vec3>& referencePoints,
                                           const Viewpoint& viewpoint) {
    std::vector<ObjectGeometry> result;
    std::vector<Diagnostic> diagnostics;
    for (std::size_t e = 0; e < entities.size(); ++e) {
        const Vec3 toSensor = viewpoint.position_m - referencePoints[e];
        ObjectGeometry geometry;
        geometry.path.range_m = length(toSensor);
        geometry.path.sensorAltitude_m =
            altitude_m(viewpoint.position_m.z, geometry.path.range_m, "sensor", diagnostics);
        geometry.path.targetAltitude_m =
            altitude_m(referencePoints[e].z, geometry.path.range_m, entities[e].name, diagnostics);
        if (geometry.path.range_m > 0.0) {
            geometry.path.azimuth_rad = std::atan2(-toSensor.x, -toSensor.y);
            const Vec3 nose = entities[e].pose.attitude.rotation() * Vec3{0, 1, 0};
            const double cosine = dot(nose, toSensor) / geometry.path.range_m;
            geometry.aspectAngle_rad = std::acos(std::clamp(cosine, -1.0, 1.0));
            geometry.path.azimuth_rad = std::atan2(-toSensor.x, -toSensor.y);
        }
        geometry.path = steadied(geometry.path);
        // To the last bit alike from wherever it is seen: temperatures follow from it.
        geometry.altitude_m = std::round(1e6 * geometry.path.targetAltitude_m) / 1e6;
        result.push_back(geometry);
    }
    if (!diagnostics.empty()) {
        // A sensor below ground is one diagnostic, however many targets it looks at.
        auto last = std::unique(diagnostics.begin(), diagnostics.end(),
                                [](const Diagnostic& a, const Diagnostic& b) {
                                    return a.file == b.file && a.value == b.value;
                                });
        diagnostics.erase(last, diagnostics.end());
        throw InputError(diagnostics);
    }
    return result;
}

void checkScene(const std::vector<Entity>& entities, const std::vector<ObjectGeometry>& geometry,
                const Environment& environment, const Sensor& sensor,
                const std::vector<Band>& bands, const RenderSettings& settings) {
    std::vector<Diagnostic> diagnostics;
    collect(diagnostics, [&] { sensor.check(); });
    if (settings.tileSide_samples != 0 &&
        (settings.tileSide_samples < 8 || settings.tileSide_samples > 2048))
        diagnostics.push_back({"settings", "zoom window", std::to_string(settings.tileSide_samples),
                               "0, or 8 to 2048 samples"});
    if (settings.usesPublishedTiles() &&
        !std::has_single_bit(static_cast<unsigned>(settings.tileSide_samples)))
        diagnostics.push_back({"settings", "zoom window", std::to_string(settings.tileSide_samples),
                               "a power of two for the published zoom"});
    if (!(settings.pointSourceBelow_px >= 0.0 &&
          settings.pointSourceBelow_px <= largestPointSource_px))
        diagnostics.push_back({"settings", "point source below",
                               roundedText(settings.pointSourceBelow_px),
                               "0 to " + roundedText(largestPointSource_px) + " pixels"});
    if (settings.samplesPerAxis < 1 || settings.samplesPerAxis > 16)
        diagnostics.push_back(
            {"settings", "samples per axis", std::to_string(settings.samplesPerAxis), "1 to 16"});
    if (settings.maximumLayers < 1)
        diagnostics.push_back(
            {"settings", "maximum layers", std::to_string(settings.maximumLayers), "at least 1"});
    if (settings.backgroundRows < 0 || settings.backgroundRows > largestBackgroundGrid ||
        settings.backgroundColumns < 1 || settings.backgroundColumns > largestBackgroundGrid)
        diagnostics.push_back({"settings", "background rows and columns",
                               std::to_string(settings.backgroundRows) + " x " +
                                   std::to_string(settings.backgroundColumns),
                               "1 to " + std::to_string(largestBackgroundGrid) +
                                   " each, or 0 rows for as many as are needed"});
    for (const TextureScale& scale : {settings.skybox, settings.terrain})
        if (!std::isfinite(scale.slope_W_m2_sr) || !std::isfinite(scale.offset))
            diagnostics.push_back(
                {"settings", "slope and offset of a texture",
                 roundedText(scale.slope_W_m2_sr) + " and " + roundedText(scale.offset),
                 "finite numbers"});
    if (settings.background == BackgroundMode::constant &&
        !(settings.background_W_m2_sr >= 0.0 && std::isfinite(settings.background_W_m2_sr)))
        diagnostics.push_back({"settings", "background", roundedText(settings.background_W_m2_sr),
                               "a finite radiance of at least 0 W m-2 sr-1"});

    if (settings.engine == EngineChoice::rays && !areRaysBuilt())
        diagnostics.push_back(
            {"settings", "render.engine", whyNoRays(), "opengl, or a build with Embree 3"});
    if (settings.scattering) {
        if (!hasScattering())
            diagnostics.push_back(
                {"settings", "scattering", whyNoScattering(),
                 "scattering off, or the package irsg-scattering or a build with FFTW"});
        else if (!scatteringLutOf(environment))
            diagnostics.push_back({"environment", "scattering", "no scattering atmosphere",
                                   "an AtmosphereScatteringLUT or an MTF database"});
    }
    if (settings.mode == CalculationMode::wideband)
        for (const Band& band : bands)
            collect(diagnostics, [&] { environment.requireWideband(band.range()); });

    if (settings.mode == CalculationMode::wideband)
        for (const Entity& entity : entities)
            if (std::ranges::any_of(entity.model->codes(), [&](const auto& use) {
                    const Material* material = materialEntry(entity, use.first.material);
                    return material != nullptr && material->isGas();
                }))
                diagnostics.push_back({entity.name, "gas", "the wideband mode",
                                       "the spectral mode: its points are not trained for gas"});

    for (std::size_t e = 0; e < entities.size(); ++e) {
        const double ambient_K = environment.ambientTemperature_K(geometry[e].altitude_m).value;
        checkEntity(entities[e], geometry[e], ambient_K, bands, diagnostics);
    }
    if (!diagnostics.empty())
        throw InputError(diagnostics);
}

} // namespace irsg

#include "irsg/scene/radiance/SceneRadiometry.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <ranges>

#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Quadrature.h"
#include "irsg/scene/radiance/WidebandTerms.h"

namespace irsg {

namespace {

/// Colder bodies give nothing that a float keeps, in any band this program has data for.
constexpr double coldestThatMatters_K = 30.0;

/// The surfaces of a scene, entity by entity, codes ascending.
std::vector<SceneRadiometry::SurfaceKey> surfaceKeys(const std::vector<Entity>& entities) {
    std::vector<SceneRadiometry::SurfaceKey> keys;
    for (std::size_t e = 0; e < entities.size(); ++e)
        for (const auto& [codes, use] : entities[e].model->codes())
            keys.emplace_back(static_cast<int>(e), codes);
    return keys;
}

double scaleOf(const std::map<int, double>& scales, int index) {
    const auto found = scales.find(index);
    return found == scales.end() ? 1.0 : found->second;
}

SurfaceInput surfaceInput(const Entity& entity, const IrCodes& codes,
                          const ObjectGeometry& geometry, double ambient_K) {
    SurfaceInput input;
    input.temperature = temperatureEntry(entity, codes.temperature);
    input.material = materialEntry(entity, codes.material);
    if (!input.temperature || !input.material)
        throw LogicError("a surface without an entry reached the radiometry");
    input.userSpectrum = userSpectrumOf(entity, *input.temperature);
    input.state = entity.state;
    input.state.altitude_m = geometry.path.targetAltitude_m;
    input.state.ambient_K = ambient_K;
    input.state.aspectAngle_rad = geometry.aspectAngle_rad;
    input.temperatureScale = scaleOf(entity.temperatureScale, codes.temperature);
    input.emissivityScale = scaleOf(entity.emissivityScale, codes.material);
    return input;
}

/// Every spectrum of a scene's surfaces, for its kinks.
void addSpectra(const std::vector<SceneRadiometry::SurfaceKey>& keys,
                const std::vector<Entity>& entities, std::vector<const Spectrum*>& spectra) {
    for (const auto& [e, codes] : keys) {
        const Entity& entity = entities[static_cast<std::size_t>(e)];
        if (const Material* material = materialEntry(entity, codes.material)) {
            spectra.push_back(&material->emissivity);
            spectra.push_back(&material->transmissivity);
        }
        if (const TemperatureEntry* entry = temperatureEntry(entity, codes.temperature))
            if (const UserSpectrum* user = userSpectrumOf(entity, *entry))
                for (const SpectrumComponent& component : user->components)
                    spectra.push_back(&component.radiance);
    }
    std::ranges::sort(spectra);
    spectra.erase(std::ranges::unique(spectra).begin(), spectra.end());
}

} // namespace

SceneRadiometry::SceneRadiometry(const Environment& environment,
                                 const std::vector<Entity>& entities,
                                 const std::vector<ObjectGeometry>& geometry,
                                 const RenderSettings& settings, const LineOfSight& centre,
                                 const Band& band)
    : keys_(surfaceKeys(entities)) {
    NativeAir native(environment, band.range());
    const SceneAir air =
        sceneAir(environment, entities, geometry, settings, centre, native.unsampled());

    // The coldest surface decides how fine the quadrature must be.
    double coldest_K = 300.0;
    for (const auto& [e, codes] : keys_) {
        const auto index = static_cast<std::size_t>(e);
        const SurfaceInput input =
            surfaceInput(entities[index], codes, geometry[index], air.objects[index].ambient_K);
        if (input.temperature->mode == EmissionMode::temperature)
            coldest_K = std::min(coldest_K, surfaceTemperature_K(input));
    }
    std::vector<const Spectrum*> kinked = native.spectra();
    addSpectra(keys_, entities, kinked);
    sampling_ = std::make_shared<const SpectralQuadrature>(
        band, kinked, std::max(coldest_K, coldestThatMatters_K));
    fill(
        entities, geometry, settings,
        sceneAir(environment, entities, geometry, settings, centre, native.at(*sampling_)),
        [this](const Spectrum& spectrum) { return sampling_->sampled(spectrum); }, band.area_um());
}

SceneRadiometry::SceneRadiometry(const Environment& environment,
                                 const std::vector<Entity>& entities,
                                 const std::vector<ObjectGeometry>& geometry,
                                 const RenderSettings& settings, const LineOfSight& centre,
                                 const WidebandTerms& terms)
    : sampling_(terms.sampling()), keys_(surfaceKeys(entities)), answeredBy_{terms.description()} {
    fill(
        entities, geometry, settings,
        sceneAir(environment, entities, geometry, settings, centre, *sampling_),
        [&terms](const Spectrum& spectrum) { return terms.sampled(spectrum); }, terms.area_um());
}

SceneRadiometry::SceneRadiometry(const Environment& environment,
                                 const std::vector<Entity>& entities,
                                 const std::vector<ObjectGeometry>& geometry,
                                 const RenderSettings& settings, const LineOfSight& centre,
                                 std::vector<double> wavelengths_um)
    : sampling_(std::make_shared<const SpectralPoints>(std::move(wavelengths_um))),
      keys_(surfaceKeys(entities)) {
    fill(
        entities, geometry, settings,
        sceneAir(environment, entities, geometry, settings, centre, *sampling_),
        [this](const Spectrum& spectrum) { return sampling_->sampled(spectrum); },
        sampling_->range().width_um());
}

void SceneRadiometry::fill(const std::vector<Entity>& entities,
                           const std::vector<ObjectGeometry>& geometry,
                           const RenderSettings& settings, SceneAir air,
                           const SpectrumSampler& sample, double bandArea_um) {
    background_ =
        settings.background == BackgroundMode::constant
            ? std::vector<double>(sampling_->size(), settings.background_W_m2_sr / bandArea_um)
            : std::move(air.background);
    std::ranges::move(air.answeredBy, std::back_inserter(answeredBy_));
    warnings_ = std::move(air.warnings);

    for (ObjectAir& object : air.objects)
        air_.push_back({std::move(object.transmittance), std::move(object.pathRadiance),
                        std::move(object.solarIrradiance), std::move(object.upwardFlux),
                        std::move(object.downwardFlux)});

    for (const auto& [e, codes] : keys_) {
        const auto index = static_cast<std::size_t>(e);
        const ObjectAir& object = air.objects[index];
        SurfaceInput input =
            surfaceInput(entities[index], codes, geometry[index], object.ambient_K);
        if (input.userSpectrum) {
            const std::string& name = input.temperature->userSpectrum;
            const auto reference = object.toReference.find(name);
            if (reference != object.toReference.end())
                input.referenceTransmittance = reference->second;
            input.insideReference = object.insideReference.contains(name);
        }
        surfaces_.push_back(apparentRadiance(input, air_[index], wavelengths_um(), sample));
        transmissivities_.emplace(std::pair(e, codes.material), surfaces_.back().transmissivity);
    }
    fillScalarTransmissivities();
}

int SceneRadiometry::row(int entity, const IrCodes& codes) const {
    const auto found = std::ranges::lower_bound(keys_, SurfaceKey{entity, codes});
    if (found == keys_.end() || *found != SurfaceKey{entity, codes})
        throw LogicError("a surface was drawn that the model did not announce");
    return static_cast<int>(found - keys_.begin());
}

const std::vector<double>& SceneRadiometry::transmissivity(int entity, int material) const {
    return transmissivities_.at({entity, material});
}

double SceneRadiometry::scalarTransmissivity(int row) const {
    const auto& [entity, codes] = keys_[static_cast<std::size_t>(row)];
    return scalarTransmissivityOf(entity, codes.material);
}

double SceneRadiometry::scalarTransmissivityOf(int entity, int material) const {
    return scalarTransmissivities_.at({entity, material});
}

void SceneRadiometry::fillScalarTransmissivities() {
    const double background = backgroundInBand_W_m2_sr();
    const double area_um = sampling_->area_um();
    for (const auto& [place, t] : transmissivities_)
        scalarTransmissivities_[place] =
            background > 0.0 ? integrate(t, background_) / background : integrate(t) / area_um;
}

double SceneRadiometry::transmissivityResidue() const {
    double worst = 0.0;
    std::vector<double> leaving(sampling_->size());
    const auto transparent = [](const auto& kept) { return std::ranges::max(kept.second) > 0.0; };
    if (std::ranges::none_of(transmissivities_, transparent))
        return 0.0;
    for (const SurfaceSpectra& behind : surfaces_) {
        std::ranges::transform(behind.thermal, behind.path, leaving.begin(), std::plus{});
        const double emitted = integrate(leaving);
        if (!(emitted > 0.0))
            continue;
        for (const auto& front : transmissivities_ | std::views::filter(transparent)) {
            const double scalar = scalarTransmissivities_.at(front.first);
            const double passed = integrate(front.second, leaving);
            worst = std::max(worst, std::abs(passed - scalar * emitted) / emitted);
        }
    }
    return worst;
}

} // namespace irsg

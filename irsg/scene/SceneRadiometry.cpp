#include "irsg/scene/SceneRadiometry.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Quadrature.h"

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

const UserSpectrum* userSpectrumOf(const Entity& entity, const TemperatureEntry& entry) {
    if (entry.mode != EmissionMode::userSpectrum)
        return nullptr;
    const auto found = entity.database->spectra.find(entry.userSpectrum);
    return found == entity.database->spectra.end() ? nullptr : &found->second;
}

double scaleOf(const std::map<int, double>& scales, int index) {
    const auto found = scales.find(index);
    return found == scales.end() ? 1.0 : found->second;
}

/// Values at wideband terms as a spectrum whose nodes are the terms.
Spectrum overTerms(const SensorCkData& ck, std::vector<double> values) {
    return ck.size() == 1 ? Spectrum::constant(values.front())
                          : Spectrum(ck.wavelengths_um(), std::move(values));
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

} // namespace

const TemperatureEntry* temperatureEntry(const Entity& entity, int index) {
    const auto& entries = entity.database->temperatures;
    auto found = entries.find(index);
    if (found == entries.end() && entity.fallbackTemperature)
        found = entries.find(*entity.fallbackTemperature);
    return found == entries.end() ? nullptr : &found->second;
}

const Material* materialEntry(const Entity& entity, int index) {
    const auto& entries = entity.database->materials;
    auto found = entries.find(index);
    if (found == entries.end() && entity.fallbackMaterial)
        found = entries.find(*entity.fallbackMaterial);
    return found == entries.end() ? nullptr : &found->second;
}

SceneRadiometry::SceneRadiometry(const Environment& environment,
                                 const std::vector<Entity>& entities,
                                 const std::vector<ObjectGeometry>& geometry,
                                 const RenderSettings& settings, const LineOfSight& centre,
                                 const Band& band)
    : keys_(surfaceKeys(entities)) {
    ask(environment, entities, geometry, settings, centre, band.range());

    // The coldest surface decides how fine the quadrature must be.
    double coldest_K = 300.0;
    for (const auto& [e, codes] : keys_) {
        const auto index = static_cast<std::size_t>(e);
        const SurfaceInput input =
            surfaceInput(entities[index], codes, geometry[index], air_[index].ambient_K);
        if (input.temperature->mode == EmissionMode::temperature)
            coldest_K = std::min(coldest_K, surfaceTemperature_K(input));
    }
    const std::vector<const Spectrum*> spectra = allSpectra(entities);
    const SpectralQuadrature quadrature(band, spectra, std::max(coldest_K, coldestThatMatters_K));
    wavelengths_um_ = quadrature.wavelengths_um();
    weights_um_ = quadrature.weights_um();
    sample(entities, geometry, settings, band.area_um());
}

SceneRadiometry::SceneRadiometry(const Environment& environment,
                                 const std::vector<Entity>& entities,
                                 const std::vector<ObjectGeometry>& geometry,
                                 const RenderSettings& settings, const LineOfSight& centre,
                                 std::shared_ptr<const SensorCkData> ck)
    : ck_(std::move(ck)),
      wavelengths_um_(ck_->wavelengths_um()),
      weights_um_(ck_->weights_um()),
      keys_(surfaceKeys(entities)) {
    note("wideband-ck", std::to_string(ck_->size()) + " terms, trained to " +
                            std::to_string(100.0 * ck_->largestError()) + " %");
    ask(environment, entities, geometry, settings, centre, ck_->band().range());
    sample(entities, geometry, settings, ck_->band().area_um());
}

SceneRadiometry::SceneRadiometry(const Environment& environment,
                                 const std::vector<Entity>& entities,
                                 const std::vector<ObjectGeometry>& geometry,
                                 const RenderSettings& settings, const LineOfSight& centre,
                                 std::vector<double> wavelengths_um)
    : wavelengths_um_(std::move(wavelengths_um)),
      weights_um_(wavelengths_um_.size(), 1.0),
      keys_(surfaceKeys(entities)) {
    if (wavelengths_um_.empty())
        throw LogicError("a spectrum without wavelengths was asked for");
    // An interval of no width is widened by parts in 1e9, so that one wavelength can be asked for.
    const SpectralRange range{wavelengths_um_.front() * (1.0 - 1e-9),
                              wavelengths_um_.back() * (1.0 + 1e-9)};
    ask(environment, entities, geometry, settings, centre, range);
    sample(entities, geometry, settings, range.width_um());
}

const UserSpectrum* SceneRadiometry::inMode(const UserSpectrum* spectrum) {
    if (!ck_ || !spectrum)
        return spectrum;
    const auto [place, isNew] = converted_.emplace(spectrum, *spectrum);
    if (isNew)
        for (SpectrumComponent& component : place->second.components)
            component.radiance = overTerms(*ck_, ck_->sampled(component.radiance));
    return &place->second;
}

void SceneRadiometry::note(const std::string& quantity, const std::string& who) {
    const std::string line = quantity + ": " + who;
    if (std::ranges::find(answeredBy_, line) == answeredBy_.end())
        answeredBy_.push_back(line);
}

void SceneRadiometry::ask(const Environment& environment, const std::vector<Entity>& entities,
                          const std::vector<ObjectGeometry>& geometry,
                          const RenderSettings& settings, const LineOfSight& centre,
                          const SpectralRange& range) {
    auto take = [&](const char* quantity, auto answer) {
        note(quantity, answer.answeredBy);
        return answer.value;
    };
    // A quantity of the air: spectral, or its values at the wideband terms.
    auto asked = [&](const char* quantity, auto spectral, auto wideband) {
        return ck_ ? overTerms(*ck_, take(quantity, wideband())) : take(quantity, spectral());
    };
    std::set<std::string> said;
    for (std::size_t e = 0; e < entities.size(); ++e) {
        const AirPath& path = geometry[e].path;
        Air air;
        auto transmittance = [&](const AirPath& through) {
            return asked(
                "transmittance", [&] { return environment.transmittance(through, range); },
                [&] { return environment.ckTransmittance(through, *ck_); });
        };
        air.transmittance = transmittance(path);
        air.pathRadiance = asked(
            "path radiance", [&] { return environment.pathRadiance(path, range); },
            [&] { return environment.ckPathRadiance(path, *ck_); });
        if (settings.sun != ReflectionMode::off)
            air.solarIrradiance = asked(
                "solar irradiance",
                [&] { return environment.solarIrradiance(path.targetAltitude_m, range); },
                [&] { return environment.ckSolarIrradiance(path.targetAltitude_m, *ck_); });
        if (settings.fluxes != ReflectionMode::off) {
            air.upwardFlux = asked(
                "upward flux", [&] { return environment.upwardFlux(path.targetAltitude_m, range); },
                [&] { return environment.ckUpwardFlux(path.targetAltitude_m, *ck_); });
            air.downwardFlux = asked(
                "downward flux",
                [&] { return environment.downwardFlux(path.targetAltitude_m, range); },
                [&] { return environment.ckDownwardFlux(path.targetAltitude_m, *ck_); });
        }
        air.ambient_K =
            take("ambient temperature", environment.ambientTemperature_K(path.targetAltitude_m));

        // What a measured spectrum already holds of the air is taken out again. The part of the
        // path next to the target is the one that was inside the measurement.
        for (const auto& [name, spectrum] : entities[e].database->spectra) {
            const double inside_m = spectrum.referenceDistance_m;
            if (inside_m <= 0.0)
                continue;
            if (path.range_m <= inside_m) {
                if (said.insert(name).second)
                    warnings_.push_back("spectrum '" + name + "' was measured at " +
                                        std::to_string(inside_m) +
                                        " m and is seen from nearer: no air is added or removed");
                air.insideReference.insert(name);
                continue;
            }
            AirPath reference = path;
            reference.range_m = inside_m;
            reference.sensorAltitude_m =
                path.targetAltitude_m +
                (path.sensorAltitude_m - path.targetAltitude_m) * inside_m / path.range_m;
            air.toReference.emplace(name, transmittance(reference));
        }
        air_.push_back(std::move(air));
    }
    if (settings.background == BackgroundMode::environment)
        backgroundSpectrum_ = asked(
            "background", [&] { return environment.backgroundRadiance(centre, range); },
            [&] { return environment.ckBackgroundRadiance(centre, *ck_); });
}

std::vector<const Spectrum*>
SceneRadiometry::allSpectra(const std::vector<Entity>& entities) const {
    std::vector<const Spectrum*> spectra{&backgroundSpectrum_};
    for (const Air& air : air_) {
        spectra.insert(spectra.end(), {&air.transmittance, &air.pathRadiance, &air.solarIrradiance,
                                       &air.upwardFlux, &air.downwardFlux});
        for (const auto& [name, spectrum] : air.toReference)
            spectra.push_back(&spectrum);
    }
    for (const auto& [e, codes] : keys_) {
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
    return spectra;
}

void SceneRadiometry::sample(const std::vector<Entity>& entities,
                             const std::vector<ObjectGeometry>& geometry,
                             const RenderSettings& settings, double bandArea_um) {
    background_ =
        settings.background == BackgroundMode::constant
            ? std::vector<double>(wavelengths_um_.size(), settings.background_W_m2_sr / bandArea_um)
            : backgroundSpectrum_.sample(wavelengths_um_);

    std::vector<AirSamples> samples;
    for (const Air& air : air_)
        samples.push_back(
            {air.transmittance.sample(wavelengths_um_), air.pathRadiance.sample(wavelengths_um_),
             air.solarIrradiance.sample(wavelengths_um_), air.upwardFlux.sample(wavelengths_um_),
             air.downwardFlux.sample(wavelengths_um_)});

    for (const auto& [e, codes] : keys_) {
        const auto index = static_cast<std::size_t>(e);
        SurfaceInput input =
            surfaceInput(entities[index], codes, geometry[index], air_[index].ambient_K);
        input.userSpectrum = inMode(input.userSpectrum);
        if (input.userSpectrum) {
            const std::string& name = input.temperature->userSpectrum;
            const auto reference = air_[index].toReference.find(name);
            if (reference != air_[index].toReference.end())
                input.referenceTransmittance = reference->second.sample(wavelengths_um_);
            input.insideReference = air_[index].insideReference.contains(name);
        }
        surfaces_.push_back(apparentRadiance(input, samples[index], wavelengths_um_));
        transmissivities_.emplace(std::pair(e, codes.material), surfaces_.back().transmissivity);
    }
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

double SceneRadiometry::integrate(const std::vector<double>& values) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
        sum += weights_um_[i] * values[i];
    return sum;
}

double SceneRadiometry::integrate(const std::vector<double>& a,
                                  const std::vector<double>& b) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += weights_um_[i] * a[i] * b[i];
    return sum;
}

double SceneRadiometry::scalarTransmissivity(int row) const {
    const auto& [entity, codes] = keys_[static_cast<std::size_t>(row)];
    return scalarTransmissivityOf(entity, codes.material);
}

double SceneRadiometry::scalarTransmissivityOf(int entity, int material) const {
    const std::vector<double>& t = transmissivity(entity, material);
    const double background = backgroundInBand_W_m2_sr();
    if (background > 0.0)
        return integrate(t, background_) / background;
    double area_um = 0.0;
    for (double weight : weights_um_)
        area_um += weight;
    return integrate(t) / area_um;
}

double SceneRadiometry::transmissivityResidue() const {
    double worst = 0.0;
    for (std::size_t front = 0; front < surfaces_.size(); ++front) {
        const std::vector<double>& t = surfaces_[front].transmissivity;
        if (std::ranges::max(t) <= 0.0)
            continue;
        const double scalar = scalarTransmissivity(static_cast<int>(front));
        for (const SurfaceSpectra& behind : surfaces_) {
            const double emitted = integrate(behind.thermal) + integrate(behind.path);
            const double passed = integrate(t, behind.thermal) + integrate(t, behind.path);
            if (emitted > 0.0)
                worst = std::max(worst, std::abs(passed - scalar * emitted) / emitted);
        }
    }
    return worst;
}

std::vector<const Spectrum*> spectraOf(const std::vector<Entity>& entities) {
    std::vector<const Spectrum*> spectra;
    for (const Entity& entity : entities)
        for (const auto& [codes, use] : entity.model->codes()) {
            if (const Material* material = materialEntry(entity, codes.material))
                spectra.insert(spectra.end(), {&material->emissivity, &material->transmissivity});
            if (const TemperatureEntry* entry = temperatureEntry(entity, codes.temperature))
                if (const UserSpectrum* user = userSpectrumOf(entity, *entry))
                    for (const SpectrumComponent& component : user->components)
                        spectra.push_back(&component.radiance);
        }
    std::erase_if(spectra, [](const Spectrum* spectrum) { return spectrum->isConstant(); });
    std::ranges::sort(spectra);
    spectra.erase(std::ranges::unique(spectra).begin(), spectra.end());
    return spectra;
}

} // namespace irsg

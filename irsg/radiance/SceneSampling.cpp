#include "irsg/radiance/SceneSampling.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "irsg/atmosphere/AtmosphereNodes.h"
#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/radiance/GasColumnSpectra.h"
#include "irsg/radiance/SurfaceTemperatures.h"
#include "irsg/radiometry/Quadrature.h"
#include "irsg/signature/SurfaceModels.h"

namespace irsg {

namespace {

/// Colder bodies give nothing that a float keeps, in any band this program has data for.
constexpr double coldestThatMatters_K = 30.0;
/// Temperatures that share a quadrature: it is made for the coldest of them.
constexpr double coldestStep_K = 10.0;

/// The spectra of a scene's surfaces, for their kinks.
void addSurfaceSpectra(const std::vector<Entity>& entities, std::vector<const Spectrum*>& spectra) {
    for (const auto& [e, codes] : surfaceKeys(entities)) {
        const Entity& entity = entities[static_cast<std::size_t>(e)];
        if (const Material* material = materialEntry(entity, codes.material)) {
            if (material->isGas()) {
                spectra.push_back(&gasKinks());
                continue; // its temperature is no measured spectrum
            }
            spectra.push_back(&material->emissivity);
            spectra.push_back(&material->transmissivity);
            if (const auto model = surfaceModelOf(*material))
                for (const Spectrum* input : model->inputs(*material))
                    spectra.push_back(input);
        }
        if (const TemperatureEntry* entry = temperatureEntry(entity, codes.temperature))
            if (const UserSpectrum* user = userSpectrumOf(entity, *entry))
                for (const SpectrumComponent& component : user->components)
                    spectra.push_back(&component.radiance);
    }
}

/// Bands from one on, to before another, that a sampling may have in one: they ascend, and what
/// lies between them is not more than they are.
std::size_t endOfRun(const std::vector<Band>& bands, std::size_t first) {
    std::size_t end = first + 1;
    double held_um = bands[first].range().width_um();
    for (; end < bands.size(); ++end) {
        const SpectralRange& next = bands[end].range();
        held_um += next.width_um();
        if (next.min_um < bands[end - 1].range().max_um ||
            next.max_um - bands[first].range().min_um > 2.0 * held_um)
            break;
    }
    return end;
}

SampledBand sampledBand(std::shared_ptr<const SpectralSampling> sampling) {
    SampledBand band;
    band.outputs = {{0, sampling->size()}};
    band.areas_um = {sampling->area_um()};
    band.sample = [sampling](const Spectrum& spectrum) { return sampling->sampled(spectrum); };
    band.sampling = std::move(sampling);
    return band;
}

/// How much of a bin from one wavelength to another a spectrum leaves empty, 0 to 1, by its mean
/// there: 0 for one that fills a third of it.
double narrowness(const Spectrum& spectrum, double from_um, double to_um, double mean) {
    double peak = std::max(std::abs(spectrum.at(from_um)), std::abs(spectrum.at(to_um)));
    const std::vector<double>& axis = spectrum.wavelengths_um();
    for (auto at = std::ranges::lower_bound(axis, from_um); at != axis.end() && *at <= to_um; ++at)
        peak = std::max(peak,
                        std::abs(spectrum.values()[static_cast<std::size_t>(at - axis.begin())]));
    return peak > 0.0 ? std::max(0.0, 1.0 - 3.0 * std::abs(mean) / peak) : 0.0;
}

/// What may be wrong of what arrives from a spectrum, as a part of it, at two standard deviations,
/// as its lines are narrower than the bins of the air: a line passes the air of its own wavenumber,
/// one of the nodes of the bin, and the mean over the nodes is taken. Neighbours in the sampling
/// with one wavelength are the nodes of a bin.
double errorOfLines(const SampledBand& band, const Spectrum& spectrum,
                    const std::vector<double>& transmittance) {
    const std::vector<double>& at_um = band.sampling->wavelengths_um();
    const std::vector<double>& weights_um = band.sampling->weights_um();
    const std::vector<double> sent = band.sample(spectrum);
    double arrives = 0.0, variance = 0.0;
    for (std::size_t first = 0, end = 0; first < at_um.size(); first = end) {
        double weight_um = 0.0, sum = 0.0, squares = 0.0;
        for (end = first; end < at_um.size() && at_um[end] == at_um[first]; ++end) {
            weight_um += weights_um[end];
            sum += weights_um[end] * transmittance[end];
            squares += weights_um[end] * transmittance[end] * transmittance[end];
        }
        if (!(weight_um > 0.0) || sent[first] == 0.0)
            continue;
        const double mean = sum / weight_um;
        const double from_um = first > 0 ? at_um[first - 1] : at_um[first];
        const double to_um = end < at_um.size() ? at_um[end] : at_um[first];
        const double alone = narrowness(spectrum, from_um, to_um, sent[first]) * sent[first];
        arrives += sent[first] * sum;
        variance += alone * alone * weight_um * weight_um *
                    std::max(0.0, squares / weight_um - mean * mean);
    }
    return arrives > 0.0 ? 2.0 * std::sqrt(variance) / arrives : 0.0;
}

/// The measured spectra of a scene whose lines are narrower than the bins of the air, with the
/// error of it rounded up, so that a sweep says it once.
std::vector<std::string> warningsOfLines(const AtmosphereScene& scene, const SampledBand& band) {
    constexpr double matters = 0.01;
    std::map<std::string, double> errors;
    for (const auto& [e, codes] : surfaceKeys(scene.entities)) {
        const auto entity = static_cast<std::size_t>(e);
        const TemperatureEntry* entry = temperatureEntry(scene.entities[entity], codes.temperature);
        const UserSpectrum* user = entry ? userSpectrumOf(scene.entities[entity], *entry) : nullptr;
        if (user == nullptr || band.air.objects[entity].nodes.empty())
            continue;
        const SharedValues& passes = band.air.objects[entity].nodes.front().transmittance;
        double& worst = errors[entry->userSpectrum];
        for (const SpectrumComponent& component : user->components)
            if (passes && !component.radiance.isConstant())
                worst = std::max(worst, errorOfLines(band, component.radiance, *passes));
    }
    std::vector<std::string> sentences;
    for (const auto& [name, error] : errors) {
        if (error < matters)
            continue;
        std::string most = "half of it or more";
        for (const int percent : {50, 20, 10, 5, 2})
            if (error <= 0.01 * percent)
                most = std::to_string(percent) + " %";
        sentences.push_back("spectrum '" + name +
                            "' has lines narrower than the bins of the air: what arrives of it may "
                            "be wrong by up to " +
                            most);
    }
    return sentences;
}

/// The nodes of an entity's slices that some output takes; none where all outputs take all.
std::vector<bool> nodesTaken(const SampledBand& band, std::size_t entity, std::size_t nodes) {
    const auto last = static_cast<int>(nodes) - 1;
    std::vector<bool> taken;
    for (int node = 0; node <= last; ++node) {
        bool isTaken = false;
        for (std::size_t k = 0; k < band.outputs.size() && !isTaken; ++k)
            isTaken = sliceBetween(node, band.sliceStep(entity, k), last).below == node;
        taken.push_back(isTaken);
    }
    return std::ranges::all_of(taken, std::identity()) ? std::vector<bool>() : taken;
}

/// What the air has between the nodes that an output takes is linear in range.
void fillBetween(const RadianceTerms& terms, SampledBand& band, std::size_t entity) {
    std::vector<AtmosphereSamples>& nodes = band.air.objects[entity].nodes;
    const auto last = static_cast<int>(nodes.size()) - 1;
    // `of(samples)` of all nodes.
    const auto fill = [&](const auto& of) {
        std::vector<SharedValues> filled;
        for (int node = 0; node <= last; ++node) {
            std::vector<double> values(band.sampling->size());
            for (std::size_t k = 0; k < band.outputs.size(); ++k) {
                const auto [below, above, part] =
                    sliceBetween(node, band.sliceStep(entity, k), last);
                const std::vector<double>& a = *of(nodes[static_cast<std::size_t>(below)]);
                const std::vector<double>& b = *of(nodes[static_cast<std::size_t>(above)]);
                for (std::size_t i = band.outputs[k].first; i < band.outputs[k].second; ++i)
                    values[i] = (1.0 - part) * a[i] + part * b[i];
            }
            filled.push_back(std::make_shared<const std::vector<double>>(std::move(values)));
        }
        for (std::size_t node = 0; node < nodes.size(); ++node)
            of(nodes[node]) = std::move(filled[node]);
    };
    fill([](AtmosphereSamples& node) -> SharedValues& { return node.transmittance; });
    for (std::size_t k = 0; k < terms.terms.size(); ++k) {
        if (!nodes.front().light[k])
            continue;
        if (geometryOf(*terms.terms[k].light) == QueryGeometry::path)
            fill([k](AtmosphereSamples& node) -> SharedValues& { return node.light[k]; });
        else // light onto the object is the same at all nodes
            for (AtmosphereSamples& node : nodes)
                node.light[k] = nodes.front().light[k];
    }
}

} // namespace

SampledBand SampledBand::ofSource(const RadianceTerms& terms) const {
    const auto all = [this](double value) {
        return std::make_shared<const std::vector<double>>(sampling->size(), value);
    };
    const SharedValues one = all(1.0), none = all(0.0);
    SampledBand source = *this;
    source.isSource = true;
    source.behind.clear();
    source.air.background = air.background ? none : nullptr;
    for (ObjectAtmosphere& object : source.air.objects) {
        // What the air has taken of a measured spectrum cannot be given back where it took all.
        for (auto& [name, transmittance] : object.toReference)
            transmittance = one;
        for (AtmosphereSamples& node : object.nodes) {
            node.transmittance = one;
            for (std::size_t k = 0; k < terms.terms.size(); ++k) {
                const auto& light = terms.terms[k].light;
                if (light && node.light[k] && geometryOf(*light) == QueryGeometry::path)
                    node.light[k] = none;
            }
        }
    }
    return source;
}

std::vector<SurfaceKey> surfaceKeys(const std::vector<Entity>& entities) {
    std::vector<SurfaceKey> keys;
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
    input.state = stateInPlace(entity, geometry, ambient_K);
    if (input.temperature->mode == EmissionMode::temperature)
        input.temperature_K = scaleOf(entity.temperatureScale, codes.temperature) *
                              surfaceTemperature_K(entity, codes.temperature, input.state);
    input.emissivityScale = scaleOf(entity.emissivityScale, codes.material);
    return input;
}

double coldestOf_K(const AtmosphericQueryCache& answers, const AtmosphereScene& scene) {
    double coldest_K = 300.0;
    std::vector<double> ambient_K;
    ambient_K.reserve(scene.geometry.size());
    for (const ObjectGeometry& object : scene.geometry)
        ambient_K.push_back(ambientOf(answers, object).value);
    for (const auto& [e, codes] : surfaceKeys(scene.entities)) {
        const auto index = static_cast<std::size_t>(e);
        const SurfaceInput input =
            surfaceInput(scene.entities[index], codes, scene.geometry[index], ambient_K[index]);
        if (input.temperature->mode == EmissionMode::temperature)
            coldest_K = std::min(coldest_K, input.temperature_K);
    }
    return std::max(coldestStep_K * std::floor(coldest_K / coldestStep_K), coldestThatMatters_K);
}

std::shared_ptr<const SpectralSampling> SceneSampling::quadrature(AtmosphericQueryCache& answers,
                                                                  const AtmosphereScene& scene,
                                                                  const Band& band) {
    std::vector<const Spectrum*> spectra =
        atmosphereSpectra(answers, scene.terms, scene.entities, scene.geometry, scene.settings,
                          scene.centre, band.range());
    addSurfaceSpectra(scene.entities, spectra);
    std::ranges::sort(spectra);
    spectra.erase(std::ranges::unique(spectra).begin(), spectra.end());
    std::vector<double> edges_um = mergeAxes(spectra, band.range());
    const double finest_K = coldestOf_K(answers, scene);

    const CacheEntry* const known = cache_.find([&](const CacheEntry& kept) {
        return kept.band == band && kept.coldest_K == finest_K && kept.edges_um == edges_um;
    });
    if (known != nullptr)
        return known->sampling;
    auto made = std::make_shared<const SpectralQuadrature>(band, spectra, finest_K);
    const CacheEntry& latest = cache_.add({band, finest_K, std::move(edges_um), std::move(made)});
    std::size_t numbers = 0;
    cache_.letGo([&](const CacheEntry& kept) {
        numbers += kept.edges_um.size() + kept.sampling->size();
        return &kept != &latest && numbers > mostNumbers;
    });
    return latest.sampling;
}

void SceneSampling::takeAtmosphere(AtmosphericQueryCache& answers, const AtmosphereScene& scene,
                                   SampledBand& band) {
    std::vector<std::vector<bool>> taken(scene.geometry.size());
    for (std::size_t e = 0; e < taken.size(); ++e)
        taken[e] = nodesTaken(band, e, scene.geometry[e].slices_m.size());
    band.air = sceneAtmosphere(answers, scene.terms, scene.entities, scene.geometry, scene.settings,
                               scene.centre, band.sampling, taken);
    for (std::size_t e = 0; e < taken.size(); ++e)
        if (!taken[e].empty())
            fillBetween(scene.terms, band, e);
    if (!band.description.empty())
        band.air.providedBy.insert(band.air.providedBy.begin(), band.description);
}

std::vector<double> SampledSpectra::of(const Spectrum& spectrum) {
    if (spectrum.isConstant())
        return sampling_->sampled(spectrum);
    const std::scoped_lock lock(mutex_);
    return cache_
        .of([&](const CacheEntry& kept) { return kept.spectrum == spectrum; },
            [&] {
                return CacheEntry{spectrum, sampling_->sampled(spectrum)};
            })
        .values;
}

const SceneSampling::CachedNodes* SceneSampling::nodesCached(const Environment& environment,
                                                             std::vector<Band> bands) {
    cachedNodes_.letGo([](const CachedNodes& kept) { return kept.atmospheres.isGone(); });
    const CachedNodes* const known = cachedNodes_.find([&](const CachedNodes& kept) {
        return kept.bands == bands && kept.atmospheres.isOf(environment);
    });
    if (known != nullptr)
        return known;
    auto made = bands.size() == 1 ? environment.nodesOf(bands.front()) : environment.nodesOf(bands);
    if (!made)
        return nullptr;
    auto spectra = std::make_shared<SampledSpectra>(made);
    return &cachedNodes_.add(
        {std::move(bands), AtmosphereIdentity(environment), std::move(made), std::move(spectra)});
}

std::shared_ptr<const SpectralSampling> SceneSampling::nodes(const Environment& environment,
                                                             const Band& band) {
    const CachedNodes* const kept = nodesCached(environment, {band});
    return kept == nullptr ? nullptr : kept->sampling;
}

std::vector<SampledBand> SceneSampling::spectral(AtmosphericQueryCache& answers,
                                                 const AtmosphereScene& scene,
                                                 const std::vector<Band>& bands) {
    std::vector<SampledBand> all;
    for (std::size_t first = 0; first < bands.size();) {
        std::size_t end = endOfRun(bands, first);
        const auto at = [&](std::size_t band) {
            return bands.begin() + static_cast<std::ptrdiff_t>(band);
        };
        const CachedNodes* kept = nodesCached(answers.environment(), {at(first), at(end)});
        if (!kept && end > first + 1)
            kept = nodesCached(answers.environment(), {at(first), at(end = first + 1)});
        SampledBand made =
            sampledBand(kept ? kept->sampling : quadrature(answers, scene, bands[first]));
        if (kept)
            made.sample = [spectra = kept->spectra](const Spectrum& spectrum) {
                return spectra->of(spectrum);
            };
        if (const AtmosphereNodes* nodes = AtmosphereNodes::of(*made.sampling))
            made.outputs = nodes->outputs();
        made.areas_um.clear();
        for (; first < end; ++first)
            made.areas_um.push_back(bands[first].area_um());
        takeAtmosphere(answers, scene, made);
        if (kept)
            appendUnique(made.air.warnings, warningsOfLines(scene, made));
        all.push_back(std::move(made));
    }
    return all;
}

SampledBand SceneSampling::wideband(AtmosphericQueryCache& answers, const AtmosphereScene& scene,
                                    const std::shared_ptr<const WidebandPoints>& points) {
    SampledBand made = sampledBand(points->sampling());
    made.sample = [points](const Spectrum& spectrum) { return points->sampled(spectrum); };
    made.description = points->description();
    takeAtmosphere(answers, scene, made);
    return made;
}

SampledBand SceneSampling::wavelengths(AtmosphericQueryCache& answers, const AtmosphereScene& scene,
                                       const std::vector<double>& wavelengths_um) {
    if (wavelengths_um.empty())
        throw LogicError("a spectrum without wavelengths was asked for");
    std::shared_ptr<const SpectralSampling> sampling =
        answers.environment().nodesAt(wavelengths_um);
    if (!sampling)
        sampling = std::make_shared<const SpectralPoints>(wavelengths_um);
    SampledBand made = sampledBand(sampling);
    if (const AtmosphereNodes* nodes = AtmosphereNodes::of(*sampling)) {
        made.outputs = nodes->outputs();
    } else {
        made.outputs.clear();
        for (std::size_t i = 0; i < wavelengths_um.size(); ++i)
            made.outputs.emplace_back(i, i + 1);
    }
    made.areas_um.assign(made.outputs.size(), sampling->range().width_um());
    takeAtmosphere(answers, scene, made);
    return made;
}

} // namespace irsg

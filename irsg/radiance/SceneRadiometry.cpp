#include "irsg/radiance/SceneRadiometry.h"

#include <algorithm>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/DotProducts.h"
#include "irsg/signature/SurfaceModels.h"

namespace irsg {

namespace {

void append(std::vector<double>& all, const std::vector<double>& some) {
    all.insert(all.end(), some.begin(), some.end());
}

/// What `of(band)` has in each band, one behind the other; null where no band has any.
template <typename Of>
SharedValues joined(const std::vector<SampledBand>& bands, Of of) {
    if (bands.size() == 1)
        return of(bands.front());
    std::vector<double> all;
    for (const SampledBand& band : bands)
        if (const SharedValues& some = of(band))
            append(all, *some);
    return all.empty() ? nullptr : std::make_shared<const std::vector<double>>(std::move(all));
}

} // namespace

SceneRadiometry::SceneRadiometry(const RadianceTerms& terms, const std::vector<Entity>& entities,
                                 const std::vector<ObjectGeometry>& geometry,
                                 const std::vector<SampledBand>& bands)
    : terms_(&terms) {
    std::vector<SliceNodes> slices;
    for (const ObjectGeometry& object : geometry) {
        slices.push_back(object.slices_m);
        air_.emplace_back(std::max<std::size_t>(object.slices_m.size(), 1));
    }
    for (const SampledBand& band : bands) {
        for (const auto& [first, last] : band.outputs)
            outputs_.emplace_back(wavelengths_um_.size() + first, wavelengths_um_.size() + last);
        append(wavelengths_um_, band.sampling->wavelengths_um());
        append(weights_um_, band.sampling->weights_um());
        appendUnique(warnings_, band.air.warnings);
    }
    for (std::size_t e = 0; e < geometry.size(); ++e) {
        std::vector<int>& steps = sliceSteps_.emplace_back();
        for (const SampledBand& band : bands)
            for (std::size_t k = 0; k < band.outputs.size(); ++k)
                steps.push_back(band.sliceStep(e, k));
    }
    joinAtmosphere(bands);

    std::vector<SurfaceKey> keys = surfaceKeys(entities);
    std::vector<bool> transparent;
    for (const auto& [e, codes] : keys) {
        const Material* material =
            materialEntry(entities[static_cast<std::size_t>(e)], codes.material);
        if (!material)
            throw LogicError("a surface without an entry reached the radiometry");
        const auto place = transmissivities_.try_emplace({e, codes.material}).first;
        if (place->second.empty())
            place->second = material->isGas() ? std::vector<double>(wavelengths_um_.size(), 1.0)
                                              : sampled(material->transmissivity, bands);
        transparent.push_back(std::ranges::any_of(place->second, [](double t) { return t > 0.0; }));
        models_.push_back(material->isGas() ? nullptr : surfaceModelOf(*material));
    }
    std::map<int, GasZone> gases = gasZones(keys, entities, geometry);
    std::vector<LobeQuadratureRow> lobes;
    for (std::size_t drawn = 0; drawn < keys.size(); ++drawn) {
        const SurfaceModel* model = models_[drawn].get();
        const auto entity = static_cast<std::size_t>(keys[drawn].first);
        const std::size_t lights = model ? specular_[entity].size() : std::size_t{0};
        const auto add = [&](std::size_t component, int light) {
            lobes.push_back({static_cast<int>(drawn), static_cast<int>(component), light});
        };
        // Components first, by which `scaling` finds them.
        for (std::size_t k = 0; model && k < model->components(); ++k)
            add(k, LobeQuadratureRow::none);
        for (std::size_t k = 0; model && k < model->components() && model->hasLobe(k); ++k)
            for (std::size_t light = 0; light < lights; ++light)
                add(k, static_cast<int>(light));
        for (std::size_t k = 0; model && k < model->components() && model->hasLobe(k); ++k)
            add(k, LobeQuadratureRow::surfaces);
    }
    rows_ = SurfaceRows(std::move(keys), std::move(transparent), std::move(slices),
                        std::move(lobes), std::move(gases));

    for (int lobe = static_cast<int>(rows_.keys().size());
         lobe < static_cast<int>(rows_.renderedCount()); ++lobe)
        if (rows_.lobe(lobe).light == LobeQuadratureRow::none)
            transmissivities_[{rows_.keyOf(lobe).first, mirrorMaterial(lobe)}];

    surfaces_.resize(rows_.renderedCount());
    thermal_W_m2_sr_.resize(surfaces_.size());
    parallelFor(rows_.keys().size(), [&](std::size_t drawn) {
        fillSurface(static_cast<int>(drawn), entities, geometry, bands);
    });
    parallelFor(surfaces_.size(), [&](std::size_t drawn) { fillThermal(static_cast<int>(drawn)); });
    if (rows_.hasGas())
        takeGases(entities, bands);
    samples_.clear();
}

std::map<int, GasZone>
SceneRadiometry::gasZones(const std::vector<SurfaceKey>& keys, const std::vector<Entity>& entities,
                          const std::vector<ObjectGeometry>& geometry) const {
    struct OfEntity {
        std::map<IrCodes, GasLayer> gases;
        std::vector<int> rows;
    };
    std::map<int, OfEntity> ofEntities;
    for (std::size_t drawn = 0; drawn < keys.size(); ++drawn) {
        const auto& [e, codes] = keys[drawn];
        const auto entity = static_cast<std::size_t>(e);
        const Material* material = materialEntry(entities[entity], codes.material);
        if (!material->isGas())
            continue;
        const SurfaceInput input =
            surfaceInput(entities[entity], codes, geometry[entity], ambient_K_[entity]);
        ofEntities[e].gases.emplace(codes, gasOf(*material, input.temperature_K));
        ofEntities[e].rows.push_back(static_cast<int>(drawn));
    }
    std::map<int, GasZone> zones;
    for (const auto& [e, of] : ofEntities) {
        const std::shared_ptr<const Mesh> mesh =
            entities[static_cast<std::size_t>(e)].model->mesh();
        const auto columns = gasColumnsOf(mesh, of.gases, wavelengths_um_);
        for (const int drawn : of.rows) {
            const IrCodes& codes = keys[static_cast<std::size_t>(drawn)].second;
            const auto number = std::distance(of.gases.begin(), of.gases.find(codes));
            zones.emplace(drawn, GasZone{gasZoneShape(mesh, codes), columns,
                                         static_cast<std::size_t>(number), of.rows.front()});
        }
    }
    return zones;
}

std::vector<int> SceneRadiometry::partsOf(int drawn) const {
    if (!isGas(drawn))
        return {drawn};
    std::vector<int> parts;
    for (const auto& [row, zone] : rows_.gases())
        if (zone.firstRow == drawn)
            parts.push_back(row);
    return parts;
}

void SceneRadiometry::takeGases(const std::vector<Entity>& entities,
                                const std::vector<SampledBand>& bands) {
    for (const auto& [drawn, zone] : rows_.gases()) {
        const auto& [e, codes] = rows_.keyOf(drawn);
        const auto entity = static_cast<std::size_t>(e);
        gases_[e].gases.emplace(codes,
                                gasOf(*materialEntry(entities[entity], codes.material),
                                      surfaces_[static_cast<std::size_t>(drawn)].temperature_K));
    }
    std::map<int, GasColumnSpectra::OfEntity> gases = gases_;
    for (auto& [e, of] : gases)
        of.air = bands.front().air.objects[static_cast<std::size_t>(e)].beforeGas;
    const auto [least, most] = std::ranges::minmax(wavelengths_um_);
    std::vector<GasColumnSpectra::Nodes> nodes;
    nodes.reserve(bands.size());
    for (const SampledBand& band : bands)
        nodes.push_back({band.sampling, !band.isSource});
    gasColumns_ =
        std::make_unique<GasColumnSpectra>(gases, SpectralRange{least, most}, std::move(nodes));
}

void SceneRadiometry::joinAtmosphere(const std::vector<SampledBand>& bands) {
    for (std::size_t e = 0; e < air_.size(); ++e) {
        ambient_K_.push_back(bands.front().air.objects[e].ambient_K);
        std::vector<SharedValues>& mirrored = specular_.emplace_back();
        for (std::size_t k = 0; k < bands.front().air.objects[e].specular.size(); ++k)
            mirrored.push_back(joined(
                bands, [&](const SampledBand& band) { return band.air.objects[e].specular[k]; }));
        for (std::size_t node = 0; node < air_[e].size(); ++node) {
            const auto ofNode = [&](const SampledBand& band) -> const AtmosphereSamples& {
                return band.air.objects[e].nodes[node];
            };
            AtmosphereSamples& air = air_[e][node];
            air.transmittance =
                joined(bands, [&](const SampledBand& b) { return ofNode(b).transmittance; });
            for (std::size_t k = 0; k < terms_->terms.size(); ++k) {
                // Light onto an object is the same at all nodes.
                const auto& light = terms_->terms[k].light;
                const bool isKnown = node > 0 && light && geometryOf(*light) != QueryGeometry::path;
                air.light.push_back(isKnown ? air_[e].front().light[k]
                                            : joined(bands, [&](const SampledBand& b) {
                                                  return ofNode(b).light[k];
                                              }));
            }
        }
    }
}

void SceneRadiometry::seeAlong(const std::vector<SampledBand>& bands) {
    warnings_.clear();
    for (const SampledBand& band : bands)
        appendUnique(warnings_, band.air.warnings);
    for (std::size_t e = 0; e < air_.size(); ++e)
        for (std::size_t node = 0; node < air_[e].size(); ++node)
            for (std::size_t k = 0; k < terms_->terms.size(); ++k)
                if (terms_->terms[k].isAlongPath())
                    air_[e][node].light[k] = joined(bands, [&](const SampledBand& band) {
                        return band.air.objects[e].nodes[node].light[k];
                    });
}

SliceBetween SceneRadiometry::rowsAbout(int row, std::size_t output) const {
    const int drawn = rows_.renderedOf(row);
    const int first = rows_.first(drawn);
    const auto entity = static_cast<std::size_t>(rows_.keyOf(drawn).first);
    SliceBetween about =
        sliceBetween(row - first, sliceSteps_[entity][output], rows_.first(drawn + 1) - first - 1);
    about.below += first;
    about.above += first;
    return about;
}

SurfaceInput SceneRadiometry::inputOf(int drawn, const std::vector<Entity>& entities,
                                      const std::vector<ObjectGeometry>& geometry) const {
    const auto& [e, codes] = rows_.keys()[static_cast<std::size_t>(drawn)];
    const auto index = static_cast<std::size_t>(e);
    return surfaceInput(entities[index], codes, geometry[index], ambient_K_[index]);
}

void SceneRadiometry::fillSurface(int drawn, const std::vector<Entity>& entities,
                                  const std::vector<ObjectGeometry>& geometry,
                                  const std::vector<SampledBand>& bands) {
    const auto entity =
        static_cast<std::size_t>(rows_.keys()[static_cast<std::size_t>(drawn)].first);
    SurfaceInput input = inputOf(drawn, entities, geometry);
    if (input.userSpectrum) {
        const std::string& name = input.temperature->userSpectrum;
        for (const SampledBand& band : bands) {
            const ObjectAtmosphere& object = band.air.objects[entity];
            const auto reference = object.toReference.find(name);
            if (reference != object.toReference.end())
                append(input.referenceTransmittance, *reference->second);
            input.insideReference = object.insideReference.contains(name);
        }
    }
    const SpectrumSampler sample = [&](const Spectrum& spectrum) {
        return sampled(spectrum, bands);
    };
    const DirectionalSpectra directional = directionalSpectra(input, sample);
    surfaces_[static_cast<std::size_t>(drawn)] =
        surfaceSpectra(input, wavelengths_um_, sample, directional);
    if (directional.model)
        fillLobes(drawn, directional);
}

void SceneRadiometry::fillLobes(int drawn, const DirectionalSpectra& directional) {
    const auto entity = static_cast<std::size_t>(rows_.keyOf(drawn).first);
    const SurfaceSpectra& whole = surfaces_[static_cast<std::size_t>(drawn)];
    const std::vector<SharedValues> amounts = lobeAmounts(directional);
    for (auto lobe = static_cast<std::size_t>(rows_.firstLobe(drawn)); lobe < surfaces_.size();
         ++lobe) {
        const LobeQuadratureRow& row = rows_.lobe(static_cast<int>(lobe));
        if (row.surface != drawn)
            break;
        const auto component = static_cast<std::size_t>(row.component);
        if (row.isOfAtmosphere())
            surfaces_[lobe] = specularSpectra(
                whole, amounts[component], specular_[entity][static_cast<std::size_t>(row.light)]);
        else
            surfaces_[lobe] = lobeSpectra(whole, directional, component, wavelengths_um_);
        if (row.light == LobeQuadratureRow::none)
            transmissivities_.at({static_cast<int>(entity),
                                  mirrorMaterial(static_cast<int>(lobe))}) = *amounts[component];
        if (row.isOfSurfaces())
            surfaces_[lobe] = surfacesReflection(std::move(surfaces_[lobe]));
    }
}

void SceneRadiometry::fillThermal(int drawn) {
    const SurfaceSpectra& surface = surfaces_[static_cast<std::size_t>(drawn)];
    const AtmosphereSamples& samples = air(rows_.first(drawn));
    // A gas is no hot spot: how much it emits is known by column alone.
    const double counts = surface.isGas ? 0.0 : 1.0;
    std::vector<double>& all = thermal_W_m2_sr_[static_cast<std::size_t>(drawn)];
    for (const SurfaceSpectra::Emission& part : surface.emission) {
        SurfaceSpectra alone;
        alone.emission.push_back({1.0, part.radiance});
        alone.emissionPassesAtmosphere = surface.emissionPassesAtmosphere;
        std::vector<double> ofPart(outputs_.size(), 0.0);
        for (std::size_t k = 0; k < terms_->terms.size(); ++k) {
            if (terms_->terms[k].surface != SurfaceQuantity::emission)
                continue;
            const std::vector<double> sent = apparentTerm(alone, *terms_, k, samples);
            for (std::size_t output = 0; output < outputs_.size() && !sent.empty(); ++output)
                ofPart[output] += counts * integrate(sent, output);
        }
        append(all, ofPart);
    }
}

std::vector<int> SceneRadiometry::turn(const std::vector<Entity>& entities,
                                       const std::vector<ObjectGeometry>& geometry) {
    std::vector<int> turned;
    for (int drawn = 0; drawn < static_cast<int>(rows_.keys().size()); ++drawn) {
        const auto& [e, codes] = rows_.keys()[static_cast<std::size_t>(drawn)];
        const TemperatureEntry* entry =
            temperatureEntry(entities[static_cast<std::size_t>(e)], codes.temperature);
        if (!entry || !dependsOnAspect(*entry))
            continue;
        turned.push_back(drawn);
        const std::vector<double> factors = componentFactors(inputOf(drawn, entities, geometry));
        for (std::size_t j = 0; j < factors.size(); ++j)
            surfaces_[static_cast<std::size_t>(drawn)].emission[j].factor = factors[j];
    }
    return turned;
}

bool dependsOnAspect(const TemperatureEntry& entry) {
    return entry.mode == EmissionMode::userSpectrum &&
           std::ranges::any_of(entry.factors,
                               [](const ComponentFactor& factor) { return !factor.angle.empty(); });
}

std::vector<double> SceneRadiometry::sampled(const Spectrum& spectrum,
                                             const std::vector<SampledBand>& bands) {
    {
        const std::lock_guard lock(sampling_);
        if (const auto known = samples_.find(&spectrum); known != samples_.end())
            return known->second;
    }
    std::vector<double> values;
    for (const SampledBand& band : bands)
        append(values, band.sample(spectrum));
    const std::lock_guard lock(sampling_);
    return samples_.try_emplace(&spectrum, std::move(values)).first->second;
}

const AtmosphereSamples& SceneRadiometry::air(int row) const {
    const auto entity = static_cast<std::size_t>(rows_.keyOf(rows_.renderedOf(row)).first);
    return air_[entity][static_cast<std::size_t>(rows_.nodeOf(row))];
}

const SurfaceSpectra& SceneRadiometry::scaling(int drawn) const {
    if (rows_.isLobe(drawn) && rows_.lobe(drawn).light != LobeQuadratureRow::none) {
        const LobeQuadratureRow& row = rows_.lobe(drawn);
        drawn = rows_.firstLobe(row.surface) + row.component;
    }
    return surfaces_[static_cast<std::size_t>(drawn)];
}

const std::vector<double>& SceneRadiometry::transmissivity(int entity, int material) const {
    return transmissivities_.at({entity, material});
}

void SceneRadiometry::fillPassed(const std::vector<OccluderMaterial>& front, std::size_t first,
                                 std::size_t count, double* values, bool throughAir,
                                 int drawn) const {
    std::copy_n(weights_um_.data() + first, count, values);
    const auto multiply = [&](const GasColumnSpectra::Values& of) {
        const bool isChanged = throughAir && !of.throughAir.empty();
        fillProducts(values, (isChanged ? of.throughAir : of.plain).data() + first, count, values);
    };
    bool isWithoutOwn = drawn >= 0 && isGas(drawn);
    for (const auto& [entity, material] : front) {
        if (!isGasColumn(material)) {
            fillProducts(values, transmissivity(entity, material).data() + first, count, values);
            continue;
        }
        const GasColumnSpectra::Column& column = gasColumns_->of(entity, material);
        if (!isWithoutOwn || rows_.keyOf(drawn).first != entity) {
            multiply(column.transmittance);
            continue;
        }
        const auto share = column.shares.find(rows_.keyOf(drawn).second);
        if (share == column.shares.end())
            break;
        multiply(share->second);
        isWithoutOwn = false;
    }
    if (isWithoutOwn)
        std::fill_n(values, count, 0.0);
}

double SceneRadiometry::integrate(const std::vector<double>& values, std::size_t output) const {
    const auto& [first, last] = outputs_[output];
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i)
        sum += weights_um_[i] * values[i];
    return sum;
}

double SceneRadiometry::thermal_W_m2_sr(int drawn, std::size_t output) const {
    const auto row = static_cast<std::size_t>(drawn);
    double sum = 0.0;
    for (std::size_t j = 0; j < surfaces_[row].emission.size(); ++j)
        sum +=
            surfaces_[row].emission[j].factor * thermal_W_m2_sr_[row][j * outputs_.size() + output];
    return sum;
}

SharedValues joinedOver(const std::vector<SampledBand>& bands,
                        const std::function<SharedValues(const SampledBand&)>& of) {
    return joined(bands, of);
}

SharedValues backgroundOf(const std::vector<SampledBand>& bands, const RenderSettings& settings) {
    return joined(bands, [&](const SampledBand& band) -> SharedValues {
        if (settings.background == BackgroundMode::environment)
            return band.air.background;
        const bool isConstant = settings.background == BackgroundMode::constant && !band.isSource;
        const double uniform_W_m2_sr = isConstant ? settings.background_W_m2_sr : 0.0;
        std::vector<double> values(band.sampling->size(), 0.0);
        for (std::size_t k = 0; k < band.outputs.size(); ++k)
            std::fill(values.begin() + static_cast<std::ptrdiff_t>(band.outputs[k].first),
                      values.begin() + static_cast<std::ptrdiff_t>(band.outputs[k].second),
                      uniform_W_m2_sr / band.areas_um[k]);
        return std::make_shared<const std::vector<double>>(std::move(values));
    });
}

} // namespace irsg

#include "irsg/scene/radiance/SceneRadiometry.h"

#include <algorithm>
#include <iterator>

#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/ParallelFor.h"

namespace irsg {

namespace {

void append(std::vector<double>& all, const std::vector<double>& some) {
    all.insert(all.end(), some.begin(), some.end());
}

void appendNew(std::vector<std::string>& all, const std::vector<std::string>& some) {
    std::ranges::copy_if(some, std::back_inserter(all), [&](const std::string& line) {
        return std::ranges::find(all, line) == all.end();
    });
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
        appendNew(answeredBy_, band.air.answeredBy);
        appendNew(warnings_, band.air.warnings);
        for (std::size_t e = 0; e < entities.size(); ++e)
            for (std::size_t node = 0; node < air_[e].size(); ++node) {
                const AirSamples& some = band.air.objects[e].nodes[node];
                AirSamples& all = air_[e][node];
                append(all.transmittance, some.transmittance);
                all.light.resize(some.light.size());
                for (std::size_t k = 0; k < some.light.size(); ++k)
                    append(all.light[k], some.light[k]);
            }
    }

    std::vector<SurfaceKey> keys = surfaceKeys(entities);
    std::vector<bool> transparent;
    for (const auto& [e, codes] : keys) {
        const Material* material =
            materialEntry(entities[static_cast<std::size_t>(e)], codes.material);
        if (!material)
            throw LogicError("a surface without an entry reached the radiometry");
        const auto place = transmissivities_.try_emplace({e, codes.material}).first;
        if (place->second.empty())
            place->second = sampled(material->transmissivity, bands);
        transparent.push_back(std::ranges::any_of(place->second, [](double t) { return t > 0.0; }));
    }
    rows_ = SurfaceRows(std::move(keys), std::move(transparent), std::move(slices));

    surfaces_.resize(static_cast<std::size_t>(rows_.size()));
    parallelFor(surfaces_.size(), [&](std::size_t row) {
        fillRow(static_cast<int>(row), entities, geometry, bands);
    });
}

void SceneRadiometry::fillRow(int row, const std::vector<Entity>& entities,
                              const std::vector<ObjectGeometry>& geometry,
                              const std::vector<SampledBand>& bands) {
    const auto& [e, codes] = rows_.keys()[static_cast<std::size_t>(rows_.drawnOf(row))];
    const auto index = static_cast<std::size_t>(e);
    SurfaceInput input = surfaceInput(entities[index], codes, geometry[index],
                                      bands.front().air.objects[index].ambient_K);
    if (input.userSpectrum) {
        const std::string& name = input.temperature->userSpectrum;
        for (const SampledBand& band : bands) {
            const ObjectAir& object = band.air.objects[index];
            const auto reference = object.toReference.find(name);
            if (reference != object.toReference.end())
                append(input.referenceTransmittance, reference->second);
            input.insideReference = object.insideReference.contains(name);
        }
    }
    surfaces_[static_cast<std::size_t>(row)] =
        apparentRadiance(input, *terms_, air(row), wavelengths_um_,
                         [&](const Spectrum& spectrum) { return sampled(spectrum, bands); });
}

std::vector<int> SceneRadiometry::turn(const std::vector<Entity>& entities,
                                       const std::vector<ObjectGeometry>& geometry,
                                       const std::vector<SampledBand>& bands) {
    std::vector<int> turned;
    for (int row = 0; row < rows_.size(); ++row) {
        const auto& [e, codes] = rows_.keys()[static_cast<std::size_t>(rows_.drawnOf(row))];
        const TemperatureEntry* entry =
            temperatureEntry(entities[static_cast<std::size_t>(e)], codes.temperature);
        if (entry && dependsOnAspect(*entry))
            turned.push_back(row);
    }
    parallelFor(turned.size(),
                [&](std::size_t i) { fillRow(turned[i], entities, geometry, bands); });
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

const AirSamples& SceneRadiometry::air(int row) const {
    const int drawn = rows_.drawnOf(row);
    const auto entity =
        static_cast<std::size_t>(rows_.keys()[static_cast<std::size_t>(drawn)].first);
    return air_[entity][static_cast<std::size_t>(rows_.nodeOf(row))];
}

const std::vector<double>& SceneRadiometry::transmissivity(int entity, int material) const {
    return transmissivities_.at({entity, material});
}

double SceneRadiometry::integrate(const std::vector<double>& values, std::size_t output) const {
    const auto& [first, last] = outputs_[output];
    double sum = 0.0;
    for (std::size_t i = first; i < last; ++i)
        sum += weights_um_[i] * values[i];
    return sum;
}

double SceneRadiometry::thermal_W_m2_sr(int row, std::size_t output) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < terms_->terms.size(); ++k)
        if (terms_->terms[k].surface == SurfaceQuantity::emission)
            sum += integrate(surfaces_[static_cast<std::size_t>(row)].terms[k], output);
    return sum;
}

std::vector<double> backgroundOf(const std::vector<SampledBand>& bands,
                                 const RenderSettings& settings) {
    std::vector<double> all;
    for (const SampledBand& band : bands) {
        const double uniform_W_m2_sr =
            settings.background == BackgroundMode::constant ? settings.background_W_m2_sr : 0.0;
        append(all,
               settings.background == BackgroundMode::environment
                   ? band.air.background
                   : std::vector<double>(band.sampling->size(), uniform_W_m2_sr / band.area_um));
    }
    return all;
}

} // namespace irsg

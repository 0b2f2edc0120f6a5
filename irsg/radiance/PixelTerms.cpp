#include "irsg/radiance/PixelTerms.h"

#include <algorithm>
#include <functional>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Columns stand for one gas at several lengths.
std::vector<OccluderMaterial> withoutGas(std::vector<OccluderMaterial> materials) {
    std::erase_if(materials, [](const OccluderMaterial& one) { return isGasColumn(one.second); });
    return materials;
}

} // namespace

PixelTerms::PixelTerms(const SceneRadiometry& radiometry, SurfaceRadianceTable& radiances,
                       OccluderStacks& occluderStacks, SceneLight* light, double background_W_m2_sr)
    : radiometry_(radiometry),
      radiances_(radiances),
      occluderStacks_(occluderStacks),
      light_(light),
      background_W_m2_sr_(background_W_m2_sr),
      walk_(radiometry.rows()) {}

const PixelTerms::KnownSurfaceStack& PixelTerms::knownOf(const SurfaceStackId& kind) {
    const auto [place, isNew] = known_.try_emplace({kind.stack, kind.row});
    if (isNew) {
        radiances_.prepare({kind});
        place->second.terms = radiances_.terms(kind);
        place->second.opacity = radiances_.of(kind).opacity;
        if (light_ && light_->matters(radiometry_.rows().renderedOf(kind.row)))
            place->second.light = &light_->atReceivers(kind);
    }
    return place->second;
}

PixelTerms::Sums& PixelTerms::sumsOf(const Key& key, int row) {
    const auto [place, isNew] = sums_.try_emplace(key);
    if (isNew) {
        const std::size_t count = radiometry_.terms().terms.size();
        Sums& sums = place->second;
        for (std::vector<double>* of : {&sums.drawn, &sums.radiance_W_m2_sr, &sums.atOne_W_m2_sr})
            of->assign(count, 0.0);
        sums.row = row;
    }
    return place->second;
}

template <typename Drawn>
void PixelTerms::addKind(const SurfaceStackId& kind, Sums& sums, double coverage,
                         const Drawn& drawn) {
    const KnownSurfaceStack& known = knownOf(kind);
    const std::vector<RadianceTerm>& list = radiometry_.terms().terms;
    const bool isLobe = radiometry_.rows().isLobe(radiometry_.rows().renderedOf(kind.row));
    for (std::size_t k = 0; k < list.size(); ++k) {
        const TermGeometryFactor& factor = list[k].factor;
        double of = factor.drawn >= 0 ? drawn(static_cast<std::size_t>(factor.drawn)) : coverage;
        if (factor.complement)
            of = coverage - of;
        sums.radiance_W_m2_sr[k] += of * known.terms[k];
        if (isLobe)
            continue;
        sums.drawn[k] += of;
        sums.atOne_W_m2_sr[k] += coverage * known.terms[k];
    }
    if (isLobe)
        return;
    sums.coverage += coverage;
    sums.hidden_W_m2_sr += coverage * known.opacity * background_W_m2_sr_;
}

void PixelTerms::add(const GeometrySamples& samples, std::size_t sample, double share) {
    const SurfaceRows& rows = radiometry_.rows();
    int number = 0, ofLayer = 0, lastRow = -1;
    float last_m = 0.0f;
    const auto forEachRow = [&](const SurfaceRows::Between& between,
                                const GeometrySamples::Layer& layer, const auto& visitRow) {
        const auto next = static_cast<double>(between.next);
        visitRow(between.row, share * (1.0 - next));
        if (rows.isSliced(layer.row))
            visitRow(between.row + 1, share * next);
    };
    const auto sumsAt = [&](int solid, bool isLightAlone, const SurfaceRows::Between& between,
                            const GeometrySamples::Layer& layer) -> Sums& {
        return sumsOf({number, isLightAlone, rows.surfaceOf(layer.row), solid},
                      layer.isLobe ? rows.first(rows.surfaceOf(layer.row)) : between.row);
    };
    const auto addReceived = [&](const SurfaceStackId& kind, Sums& sums, double part,
                                 const GeometrySamples::Layer& layer) {
        const KnownSurfaceStack& known = knownOf(kind);
        if (!known.light || !layer.place)
            return;
        const SceneLight::AtReceiver at = lightAt(light_->exchange(), *known.light, *layer.place);
        const double lit = part * static_cast<double>(layer.coverage);
        const auto give = [&](int term, double radiance) {
            if (term >= 0)
                sums.radiance_W_m2_sr[static_cast<std::size_t>(term)] += lit * radiance;
        };
        give(light_->skyTerm(), at[0]);
        give(light_->groundTerm(), at[1]);
        sums.between_W_m2_sr += lit * at[2];
    };
    walk_.forEachPlace(
        samples, sample,
        [&](int stack, const SurfaceRows::Between& between, const GeometrySamples::Layer& layer) {
            const std::vector<OccluderMaterial>& front = walk_.occluderStacks().materials(stack);
            const int solid = occluderStacks_.numberOf(withoutGas(front));
            // A lobe belongs to its surface.
            const bool isLightAlone = layer.isLobe ? solid != ofLayer : layer.coverage == 0.0f;
            if (!isLightAlone && !layer.isLobe) {
                // Behind gas, and of gas itself, a layer comes once for each column.
                if (layer.row != lastRow || layer.distance_m != last_m)
                    ++number;
                lastRow = layer.row;
                last_m = layer.distance_m;
                ofLayer = solid;
            }
            const int shared = occluderStacks_.numberOf(front);
            Sums& sums = sumsAt(solid, isLightAlone, between, layer);
            // Behind gas, and of gas, each column has its weight.
            if (!layer.isLobe)
                sums.range_m += share * static_cast<double>(layer.coverage) *
                                static_cast<double>(layer.distance_m);
            forEachRow(between, layer, [&](int row, double part) {
                const SurfaceStackId kind{shared, row};
                addKind(kind, sums, part * static_cast<double>(layer.coverage), [&](std::size_t f) {
                    return part * static_cast<double>(layer.factors[f]);
                });
                addReceived(kind, sums, part, layer);
            });
        },
        [&](int stack, const SurfaceRows::Between& between, const GeometrySamples::Layer& layer) {
            const std::vector<OccluderMaterial>& front = walk_.occluderStacks().materials(stack);
            const int shared = occluderStacks_.numberOf(front);
            Sums& sums = sumsAt(occluderStacks_.numberOf(withoutGas(front)), false, between, layer);
            forEachRow(between, layer, [&](int row, double part) {
                addReceived({shared, row}, sums, part, layer);
            });
        });
}

void PixelTerms::addPoint(const PointGeometry& atUnitDistance, double scale, double range_m) {
    const GeometryBuffer<double>& field = atUnitDistance.sums_sr_m2;
    field.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
        const SurfaceStackId& drawn = field.kinds()[number];
        const SurfaceStackId kind{drawn.stack, radiometry_.rows().first(drawn.row)};
        const int layer = 1 + static_cast<int>(occluderStacks_.materials(drawn.stack).size());
        const bool isLobe = radiometry_.rows().isLobe(drawn.row);
        const int surface = radiometry_.rows().surfaceOf(drawn.row);
        Sums& sums = sumsOf({layer, !isLobe && numbers[0] == 0.0, surface, drawn.stack},
                            radiometry_.rows().first(surface));
        const double coverage = scale * numbers[0];
        addKind(kind, sums, coverage, [&](std::size_t f) { return scale * numbers[1 + f]; });
        if (!isLobe)
            sums.range_m += coverage * range_m;
    });
}

double PixelTerms::mean(const std::vector<double>& values) const {
    return radiometry_.integrate(values) /
           radiometry_.integrate(std::vector<double>(values.size(), 1.0));
}

ExplainedSurface PixelTerms::explained(const Key& key, const Sums& sums,
                                       const std::vector<Entity>& entities) const {
    const auto& [layer, isLightAlone, drawn, stack] = key;
    const auto& [e, codes] = radiometry_.rows().keys()[static_cast<std::size_t>(drawn)];
    const Entity& entity = entities[static_cast<std::size_t>(e)];
    const SurfaceSpectra& spectra = radiometry_.surfaces()[static_cast<std::size_t>(drawn)];
    ExplainedSurface surface;
    surface.layer = layer;
    surface.lightAlone = isLightAlone;
    surface.object = entity.name;
    surface.temperatureIndex = codes.temperature;
    surface.materialIndex = codes.material;
    if (const TemperatureEntry* entry = temperatureEntry(entity, codes.temperature)) {
        surface.temperatureName = entry->name;
        if (entry->mode == EmissionMode::userSpectrum)
            surface.measuredSpectrum = entry->userSpectrum;
    }
    if (const Material* material = materialEntry(entity, codes.material))
        surface.materialName = material->name;
    surface.temperature_K = spectra.temperature_K;
    surface.transmissivity = mean(spectra.transmissivity);
    surface.reflectivity = pi * mean(spectra.reflectance);
    surface.emissivity = 1.0 - surface.transmissivity - surface.reflectivity;
    surface.nAngleFactor = spectra.nAngleFactor;

    // What it is seen through.
    const AtmosphereSamples& air = radiometry_.air(sums.row);
    surface.atmosphereTransmittance = mean(*air.transmittance);
    std::vector<double> through(spectra.transmissivity.size(), 1.0);
    for (const auto& [of, material] : occluderStacks_.materials(stack)) {
        const std::vector<double>& lets = radiometry_.transmissivity(of, material);
        for (std::size_t i = 0; i < through.size(); ++i)
            through[i] *= lets[i];
        const Entity& other = entities[static_cast<std::size_t>(of)];
        const int lobe = mirrorLobe(material);
        const int index = lobe < 0 ? material : radiometry_.rows().material(lobe).second;
        const Material* known = materialEntry(other, index);
        surface.throughMaterials.push_back((lobe < 0 ? "" : "mirrored by ") + other.name + ": " +
                                           std::to_string(index) +
                                           (known ? " " + known->name : ""));
    }
    surface.throughTransmittance = mean(through);

    surface.share = sums.coverage;
    surface.range_m = sums.coverage > 0.0 ? sums.range_m / sums.coverage : 0.0;
    const std::vector<RadianceTerm>& list = radiometry_.terms().terms;
    for (std::size_t k = 0; k < list.size(); ++k) {
        if (list[k].surface == SurfaceQuantity::specular && radiometry_.rows().firstLobe(drawn) < 0)
            continue;
        ExplainedTerm& term = surface.terms.emplace_back();
        term.name = list[k].name;
        term.radiance_W_m2_sr = sums.radiance_W_m2_sr[k];
        if (sums.coverage > 0.0) {
            term.factor = sums.drawn[k] / sums.coverage;
            term.atFactorOne_W_m2_sr = sums.atOne_W_m2_sr[k] / sums.coverage;
        }
        // Lobes are in its radiance, and so in what its factor comes to.
        if (sums.coverage > 0.0 && radiometry_.rows().firstLobe(drawn) >= 0) {
            const double own = term.radiance_W_m2_sr / sums.coverage;
            const bool isMirror = list[k].surface == SurfaceQuantity::specular;
            if (isMirror)
                term.atFactorOne_W_m2_sr = own;
            if (term.atFactorOne_W_m2_sr != 0.0)
                term.factor = own / term.atFactorOne_W_m2_sr;
        }
        if (list[k].light && air.light[k])
            term.light = radiometry_.integrate(*air.light[k]);
        surface.radiance_W_m2_sr += term.radiance_W_m2_sr;
    }
    surface.betweenSurfaces_W_m2_sr = sums.between_W_m2_sr;
    surface.radiance_W_m2_sr += sums.between_W_m2_sr;
    surface.hidden_W_m2_sr = sums.hidden_W_m2_sr;
    return surface;
}

std::vector<ExplainedSurface> PixelTerms::surfaces(const std::vector<Entity>& entities) const {
    std::vector<ExplainedSurface> all;
    for (const auto& [key, sums] : sums_)
        all.push_back(explained(key, sums, entities));
    std::ranges::stable_sort(all, [](const ExplainedSurface& a, const ExplainedSurface& b) {
        return a.layer != b.layer ? a.layer < b.layer : a.share > b.share;
    });
    return all;
}

} // namespace irsg

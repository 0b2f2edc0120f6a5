#include "irsg/radiance/SpectraBeforeAir.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/DotProducts.h"

namespace irsg {

namespace {

using Front = std::vector<OccluderMaterial>;

void addScaled(double scale, const double* values, std::vector<double>& sum) {
    if (scale != 0.0)
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += scale * values[i];
}

/// Of light at one place whose altitude has other last digits on paths of other lengths.
constexpr double roundingOfLight = 1e-7;

bool areAlmostEqual(const SharedValues& a, const SharedValues& b) {
    if (a == b || !a || !b)
        return a == b;
    double largest = 0.0, apart = 0.0;
    for (std::size_t i = 0; i < a->size() && a->size() == b->size(); ++i) {
        largest = std::max(largest, std::abs((*a)[i]));
        apart = std::max(apart, std::abs((*a)[i] - (*b)[i]));
    }
    return a->size() == b->size() && apart <= roundingOfLight * largest;
}

/// A term of a surface at a geometric factor of 1, before the atmosphere.
struct TermSpectrum {
    TermGeometryFactor factor;
    std::vector<double> values;

    /// Of numbers that begin with the coverage.
    double times(const double* numbers) const {
        if (factor.drawn < 0)
            return numbers[0];
        const double drawn = numbers[1 + factor.drawn];
        return factor.complement ? numbers[0] - drawn : drawn;
    }
};

std::vector<TermSpectrum> termSpectra(const SceneRadiometry& radiometry, int drawn) {
    const SurfaceSpectra& surface = radiometry.surfaces()[static_cast<std::size_t>(drawn)];
    const AtmosphereSamples& air = radiometry.air(radiometry.rows().first(drawn));
    const std::size_t nodes = radiometry.wavelengths_um().size();
    std::vector<TermSpectrum> all;
    for (std::size_t k = 0; k < radiometry.terms().terms.size(); ++k) {
        const RadianceTerm& term = radiometry.terms().terms[k];
        if ((term.light && !air.light[k]) || surface.isWithout(term.surface) || term.isAlongPath())
            continue;
        TermSpectrum one{term.factor, std::vector<double>(nodes, 0.0)};
        if (term.surface == SurfaceQuantity::emission)
            for (const SurfaceSpectra::Emission& part : surface.emission)
                addScaled(part.factor, part.radiance.data(), one.values);
        else
            one.values = surface.quantity(term.surface);
        if (term.surface == SurfaceQuantity::specular)
            fillProducts(one.values.data(), surface.lobeLight->data(), nodes, one.values.data());
        if (term.light)
            fillProducts(one.values.data(), air.light[k]->data(), nodes, one.values.data());
        all.push_back(std::move(one));
    }
    return all;
}

} // namespace

/// Sorts what a drawing has seen by what it is multiplied with, so that each product of spectra is
/// made once.
class SpectraBeforeAir::Making {
  public:
    Making(const ViewGeometry& view, const SurfaceRows& drawn, const EvaluatedScene& evaluated,
           const OccluderStacks& occluderStacks, std::size_t slices)
        : layout_(view.layout),
          rows_(drawn),
          radiometry_(evaluated.radiometry),
          light_(evaluated.light.get()),
          occluderStacks_(occluderStacks),
          slices_(slices),
          hidden_(slices) {
        // Whatever was seen before, the same order.
        std::map<std::pair<Front, int>, const double*> seen;
        view.field.forEach(0, [&](std::size_t number, std::span<const double> numbers) {
            const SurfaceStackId& kind = view.field.kinds()[number];
            seen[{occluderStacks.materials(kind.stack), kind.row}] = numbers.data();
        });
        for (const auto& [kind, numbers] : seen)
            take(kind.first, kind.second, numbers);
        if (light_ == nullptr)
            return;
        sources_ = light_->sourcesByNode();
        for (const SurfaceStackId& kind : light_->inOrder(view.light)) {
            const int row = rows_.renderedOf(kind.row);
            if (!light_->matters(row))
                continue;
            const Split split = splitOf(occluderStacks_.materials(kind.stack), -1);
            of(*split.path, kind.row)
                .light[{split.panes, row}]
                .addScaled(view.light.at({kind.stack, kind.row}), 1.0);
        }
    }

    std::map<GasPath, std::vector<Sent>> sent() const {
        std::map<GasPath, std::vector<Sent>> all;
        std::vector<std::pair<Sent*, const Sums*>> tasks;
        for (const auto& [path, bySlice] : sums_) {
            std::vector<Sent>& own = all[path];
            own.resize(slices_);
            for (std::size_t slice = 0; slice < slices_; ++slice)
                if (!bySlice[slice].factors.empty() || !bySlice[slice].light.empty())
                    tasks.emplace_back(&own[slice], &bySlice[slice]);
        }
        parallelFor(tasks.size(), [&](std::size_t i) { fill(*tasks[i].second, *tasks[i].first); });
        return all;
    }

    std::vector<Hidden> hidden() const {
        std::vector<Hidden> all(slices_);
        parallelFor(slices_, [&](std::size_t slice) {
            const std::size_t nodes = radiometry_.wavelengths_um().size();
            Hidden& own = all[slice];
            own = {Spectrum(nodes, 0.0), Spectrum(nodes, 0.0), Spectrum(nodes, 0.0)};
            Spectrum values(nodes);
            for (const auto& [surface, numbers] : hidden_[slice]) {
                const auto& [front, part] = surface;
                const Spectrum& opacity =
                    radiometry_.surfaces()[static_cast<std::size_t>(part)].opacity;
                if (opacity.empty()) // a lobe
                    continue;
                radiometry_.fillPassed(front, 0, nodes, values.data(), false, part);
                fillProducts(values.data(), opacity.data(), nodes, values.data());
                addScaled(numbers[0], values.data(), own.plain);
                addScaled(numbers[1], values.data(), own.cosine);
                addScaled(numbers[2], values.data(), own.pixels);
            }
        });
        return all;
    }

  private:
    /// By the panes in front and the drawn row.
    using Key = std::pair<Front, int>;
    struct Sums {
        std::map<Key, std::vector<double>> factors; ///< coverage and factors, then with cosine
        std::map<Key, ReceiverSums> light;
    };
    /// What is in front of a surface: panes, and gas. No path: nothing of a gas is seen.
    struct Split {
        Front panes;
        std::optional<GasPath> path;
    };

    /// As SceneRadiometry::fillPassed takes it.
    Split splitOf(const Front& front, int part) const {
        Split split{{}, GasPath()};
        bool isWithoutOwn = part >= 0 && radiometry_.isGas(part);
        for (const auto& [entity, material] : front) {
            if (!isGasColumn(material)) {
                split.panes.emplace_back(entity, material);
                continue;
            }
            GasFactor factor{entity, material, {}};
            if (isWithoutOwn && rows_.keyOf(part).first == entity) {
                factor.sender = rows_.keyOf(part).second;
                if (!radiometry_.gasColumn(entity, material).shares.contains(*factor.sender))
                    return {};
                isWithoutOwn = false;
            }
            split.path->push_back(factor);
        }
        if (isWithoutOwn)
            split.path.reset();
        return split;
    }

    std::size_t sliceOf(int row) const {
        return slices_ > 1 ? static_cast<std::size_t>(rows_.nodeOf(row)) : 0;
    }
    Sums& of(const GasPath& path, int row) {
        std::vector<Sums>& bySlice = sums_[path];
        bySlice.resize(slices_);
        return bySlice[sliceOf(row)];
    }

    void take(const Front& front, int row, const double* numbers) {
        const int drawn = rows_.renderedOf(row);
        const std::size_t cosine = layout_.withCosine(layout_.coverage());
        const std::array<double, 3> covers{numbers[layout_.coverage()], numbers[cosine],
                                           numbers[layout_.pixels()]};
        for (const int part : radiometry_.partsOf(drawn)) {
            const Split split = splitOf(front, part);
            if (!split.path)
                continue;
            std::array<double, 3>& hides = hidden_[sliceOf(row)][{front, part}];
            for (std::size_t q = 0; q < hides.size(); ++q)
                hides[q] += covers[q];
            if (!spectra_.contains(part))
                spectra_.emplace(part, termSpectra(radiometry_, part));
            std::vector<double>& sums = of(*split.path, row).factors[{split.panes, part}];
            sums.resize(2 * cosine, 0.0);
            for (std::size_t i = 0; i < sums.size(); ++i)
                sums[i] += numbers[i];
        }
    }

    void fill(const Sums& sums, Sent& sent) const {
        const std::size_t nodes = radiometry_.wavelengths_um().size();
        sent = {Spectrum(nodes, 0.0), Spectrum(nodes, 0.0)};
        Spectrum passed(nodes), values(nodes);
        for (const auto& [key, numbers] : sums.factors) {
            radiometry_.fillPassed(key.first, 0, nodes, passed.data());
            for (const auto& [to, first] :
                 {std::pair{&sent.plain, std::size_t{0}}, {&sent.cosine, numbers.size() / 2}}) {
                std::ranges::fill(values, 0.0);
                for (const TermSpectrum& term : spectra_.at(key.second))
                    addScaled(term.times(numbers.data() + first), term.values.data(), values);
                for (std::size_t i = 0; i < nodes; ++i)
                    (*to)[i] += passed[i] * values[i];
            }
        }
        for (const auto& [key, receivers] : sums.light) {
            const int row = radiometry_.rows().first(key.second);
            radiometry_.fillPassed(key.first, 0, nodes, passed.data());
            fillProducts(passed.data(), radiometry_.surface(row).reflectance.data(), nodes,
                         passed.data());
            const auto fallen = light_->reflectable(row, receivers, sources_);
            for (std::size_t i = 0; i < nodes; ++i) {
                sent.plain[i] += passed[i] * fallen[0][i];
                sent.cosine[i] += passed[i] * fallen[1][i];
            }
        }
    }

    const ViewLayout& layout_;
    const SurfaceRows& rows_;
    const SceneRadiometry& radiometry_;
    SceneLight* light_;
    const OccluderStacks& occluderStacks_;
    std::size_t slices_;
    std::map<GasPath, std::vector<Sums>> sums_;                // by slice
    std::vector<std::map<Key, std::array<double, 3>>> hidden_; // by slice; with all in front
    std::map<int, std::vector<TermSpectrum>> spectra_;         // by drawn row
    std::vector<double> sources_;                              // of light, by node and column
};

SpectraBeforeAir::SpectraBeforeAir(const ViewGeometry& atUnitDistance, const SurfaceRows& drawn,
                                   double drawn_m, const EvaluatedScene& evaluated,
                                   const OccluderStacks& occluderStacks)
    : terms_(&evaluated.radiometry.terms()),
      gases_(evaluated.radiometry.gases()),
      layersLeftOver_(atUnitDistance.layersLeftOver) {
    const SliceNodes& slices_m = drawn.slices().front();
    offsets_m_.push_back(slices_m.size() > 1 ? slices_m.front() - drawn_m : 0.0);
    for (std::size_t slice = 1; slice < slices_m.size(); ++slice)
        offsets_m_.push_back(slices_m[slice] - drawn_m);
    const Making making(atUnitDistance, drawn, evaluated, occluderStacks, offsets_m_.size());
    sent_ = making.sent();
    hidden_ = making.hidden();
}

bool SpectraBeforeAir::existOf(const SceneRadiometry& radiometry, const SampledScene& sampled) {
    if (sampled.bands.size() != 1 || sampled.bands.front().outputs.size() != 1 ||
        sampled.slices_m.size() != 1)
        return false;
    const ObjectAtmosphere& object = sampled.bands.front().air.objects.front();
    if (!object.toReference.empty() || !object.insideReference.empty())
        return false;
    return std::ranges::all_of(radiometry.surfaces(), &SurfaceSpectra::emissionPassesAtmosphere) &&
           std::ranges::all_of(radiometry.terms().terms, [](const RadianceTerm& term) {
               return term.isAlongPath()
                          ? term.surface == SurfaceQuantity::opacity && term.factor.drawn < 0 &&
                                !term.passesAtmosphere
                          : term.passesAtmosphere || term.surface == SurfaceQuantity::emission;
           });
}

bool SpectraBeforeAir::differByPathAlone(const RadianceTerms& terms, const SampledScene& a,
                                         const SampledScene& b) {
    const auto areAlike = [&](const ObjectAtmosphere& one, const ObjectAtmosphere& other) {
        const AtmosphereSamples &own = one.nodes.front(), &others = other.nodes.front();
        for (std::size_t k = 0; k < terms.terms.size(); ++k)
            if (!terms.terms[k].isAlongPath() && !areAlmostEqual(own.light[k], others.light[k]))
                return false;
        return std::abs(one.ambient_K - other.ambient_K) <= roundingOfLight * one.ambient_K &&
               one.toReference.empty() && other.toReference.empty() &&
               one.insideReference.empty() && other.insideReference.empty() &&
               std::ranges::equal(one.specular, other.specular, areAlmostEqual);
    };
    return std::ranges::equal(
        a.bands, b.bands, [&](const SampledBand& one, const SampledBand& other) {
            return one.sampling == other.sampling && one.outputs == other.outputs &&
                   one.isSource == other.isSource &&
                   std::ranges::equal(one.air.objects, other.air.objects, areAlike);
        });
}

std::vector<SpectraBeforeAir::Through> SpectraBeforeAir::throughAir(const AirAtRange& air) const {
    const SampledBand& band = air.sampled.bands.front();
    const std::size_t nodes = band.sampling->size();
    const std::vector<AtmosphereSamples>& places = band.air.objects.front().nodes;
    const SurfaceRows rows({SurfaceKey{0, {}}}, {false}, air.sampled.slices_m);
    std::vector<Through> all;
    for (const double offset_m : offsets_m_) {
        Through& own = all.emplace_back(Through{Spectrum(nodes, 0.0), Spectrum(nodes, 0.0)});
        const auto add = [&](int place, double part) {
            const AtmosphereSamples& there = places[static_cast<std::size_t>(place)];
            addScaled(part, part != 0.0 ? there.transmittance->data() : nullptr, own.transmittance);
            for (std::size_t k = 0; k < terms_->terms.size(); ++k)
                if (part != 0.0 && terms_->terms[k].isAlongPath() && there.light[k])
                    addScaled(part, there.light[k]->data(), own.path);
        };
        rows.forEachRow(0, static_cast<float>(air.range_m + offset_m), [&](int row, float part) {
            const SliceBetween about = sliceBetween(row, band.sliceStep(0, 0), rows.size() - 1);
            add(about.below, static_cast<double>(part) * (1.0 - about.part));
            add(about.above, static_cast<double>(part) * about.part);
        });
    }
    return all;
}

ObjectSums SpectraBeforeAir::at(const AirAtRange& air) const {
    const SampledBand& band = air.sampled.bands.front();
    const std::size_t nodes = band.sampling->size();
    const std::vector<Through> through = throughAir(air);

    double sent = 0.0, sentCos = 0.0; // times the square of the range
    std::optional<GasColumnSpectra> gases;
    if (!gases_.empty()) {
        std::map<int, GasColumnSpectra::OfEntity> ofRange = gases_;
        for (auto& [entity, of] : ofRange)
            of.air = band.air.objects[static_cast<std::size_t>(entity)].beforeGas;
        const auto [least, most] = std::ranges::minmax(band.sampling->wavelengths_um());
        gases.emplace(ofRange, SpectralRange{least, most},
                      std::vector<GasColumnSpectra::Nodes>{{band.sampling, !band.isSource}});
    }
    Spectrum values(nodes);
    for (const auto& [path, bySlice] : sent_)
        for (std::size_t slice = 0; slice < bySlice.size(); ++slice) {
            const Sent& own = bySlice[slice];
            if (own.plain.empty())
                continue;
            const double* passes = through[slice].transmittance.data();
            for (const GasFactor& factor : path) {
                const GasColumnSpectra::Column& column = gases->of(factor.entity, factor.column);
                const GasColumnSpectra::Values& of =
                    factor.sender ? column.shares.at(*factor.sender) : column.transmittance;
                fillProducts(passes, (of.throughAir.empty() ? of.plain : of.throughAir).data(),
                             nodes, values.data());
                passes = values.data();
            }
            sent += dotProduct(own.plain.data(), passes, nodes);
            sentCos += dotProduct(own.cosine.data(), passes, nodes);
        }

    double inBand = 0.0;
    for (std::size_t i = 0; i < nodes; ++i)
        inBand += band.sampling->weights_um()[i] * (*air.background)[i];
    double hides = 0.0, hidesCos = 0.0, opacity = 0.0, pixels = 0.0;
    for (std::size_t slice = 0; slice < hidden_.size(); ++slice) {
        const Hidden& own = hidden_[slice];
        sent += dotProduct(own.plain.data(), through[slice].path.data(), nodes);
        sentCos += dotProduct(own.cosine.data(), through[slice].path.data(), nodes);
        const double* behind = air.background->data();
        hides += dotProduct(own.plain.data(), behind, nodes);
        hidesCos += dotProduct(own.cosine.data(), behind, nodes);
        // As parts of the background, or of the response where there is none.
        const auto partOf = [&](const Spectrum& of) {
            double sum = 0.0;
            if (inBand > 0.0)
                return dotProduct(of.data(), behind, nodes) / inBand;
            for (const double value : of)
                sum += value;
            return sum / band.areas_um.front();
        };
        opacity += partOf(own.plain);
        pixels += partOf(own.pixels);
    }

    const double scale = 1.0 / (air.range_m * air.range_m);
    ObjectRadiometry object;
    object.intensity_W_sr = sent;
    object.contrastIntensity_W_sr = sent - hides;
    object.irradiance_W_m2 = scale * (sentCos - hidesCos);
    object.solidAngle_sr = scale * opacity;
    object.coveredPixels = scale * pixels / (air.pixel_rad * air.pixel_rad);
    ObjectSums sums{{object}, {}};
    sums.all.addSums(object);
    return sums;
}

} // namespace irsg

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "irsg/radiance/GasWalk.h"
#include "irsg/radiance/GeometryBuffer.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/render/sampling/Samples.h"

namespace irsg {

/// Goes through the layers of samples from front to back and knows what lies before each. One for
/// each thread: its numbers of fronts are its own.
class LayerWalk {
  public:
    explicit LayerWalk(const SurfaceRows& rows)
        : rows_(rows), drawn_(rows.keys().size()), hasGas_(rows.hasGas()), gas_(rows) {}

    const OccluderStacks& occluderStacks() const { return occluderStacks_; }

    /// Calls visit(front, between, layer) for every layer of a sample, front to back. Light that a
    /// layer gets through something comes after it, as if that stood before the layer, too, and
    /// with no coverage: what materials let through is multiplied, wherever they stand. Lobes of
    /// directional surfaces come after their layer in the same way, place by place of what they
    /// mirror.
    /// Walls of gases are not visited: in their place come the columns of gas before each layer,
    /// and behind all, each as a layer of the gas that is met first, with the row of the entity's
    /// first gas, the column in its stack and its weight for coverage. What is behind gas is
    /// visited once for each column, likewise, and once for no gas.
    /// Lobes come behind fewer of the columns, and so does what a layer receives of other surfaces,
    /// which is visited apart: visitReceived(front, between, layer), with coverage for the weight
    /// of what is received at the place; the layer itself then comes without a place.
    template <typename Visit, typename VisitReceived>
    void forEachPlace(const GeometrySamples& samples, std::size_t sample, const Visit& visit,
                      const VisitReceived& visitReceived) {
        forEachPlace(samples, sample, visit, visitReceived,
                     [&](int stack, const GeometrySamples::Layer& layer,
                         const GeometrySamples::Specular& mirror) {
                         forEachShare(samples, mirror, [&](std::size_t place, float coverage) {
                             const int row = mirror.row + static_cast<int>(place);
                             visit(stack, rows_.at(row, layer.distance_m),
                                   GeometrySamples::Layer{row,
                                                          layer.distance_m,
                                                          {noFactors.data(), layer.factors.size()},
                                                          coverage,
                                                          nullptr,
                                                          true});
                         });
                     });
    }
    /// The same, with visitSpecular(front, layer, mirror) for what lobes mirror.
    template <typename Visit, typename VisitReceived, typename VisitSpecular>
    void forEachPlace(const GeometrySamples& samples, std::size_t sample, const Visit& visit,
                      const VisitReceived& visitReceived, const VisitSpecular& visitSpecular) {
        forEachPlace(
            samples, sample, visit, visitReceived, visitSpecular,
            [&](int stack, const SurfaceRows::Between& between, const GasWalk::Emission& gas) {
                forEachColumn(stack, gas, [&](int behind, double weight) {
                    const auto part = static_cast<float>(gas.before.weight * gas.share * weight);
                    part_.fill(part);
                    visit(behind, between,
                          GeometrySamples::Layer{gas.metFirst,
                                                 gas.distance_m,
                                                 {part_.data(), samples.factorCount},
                                                 part,
                                                 nullptr,
                                                 false});
                });
            });
    }
    /// The same, with visitGas(front, between, emission) for what gas emits, before its columns.
    template <typename Visit, typename VisitReceived, typename VisitSpecular, typename VisitGas>
    void forEachPlace(const GeometrySamples& samples, std::size_t sample, const Visit& visit,
                      const VisitReceived& visitReceived, const VisitSpecular& visitSpecular,
                      const VisitGas& visitGas) {
        if (hasGas_)
            return forEachPlaceInGas(samples, sample, visit, visitReceived, visitSpecular,
                                     visitGas);
        if (samples.through.empty() && samples.lobes.empty() && samples.speculars.empty() &&
            samples.reflected.empty())
            return forEachLayerAlone(samples, sample, visit);
        int stack = 0;
        LightOfLayers light(*this, samples, sample);
        samples.forEachLayer(sample, [&](const GeometrySamples::Layer& layer) {
            visitLayer(samples, stack, layer, light, visit);
            visitLobes(samples, stack, layer, light, visit, visitSpecular);
            light.goOn();
            if (rows_.isTransparent(layer.row))
                stack = behind(stack, layer.row);
        });
    }
    /// Calls visit(kind, weight, layer) for every layer of a sample, front to back, and
    /// visitReceived(kind, weight, layer) likewise; twice for one between two nodes of its entity's
    /// slices.
    template <typename Visit, typename VisitReceived>
    void forEachLayer(const GeometrySamples& samples, std::size_t sample, const Visit& visit,
                      const VisitReceived& visitReceived) {
        forEachPlace(samples, sample, byRows(visit), byRows(visitReceived));
    }
    /// The same, with visitSpecular(front, layer, mirror) for what lobes mirror.
    template <typename Visit, typename VisitReceived, typename VisitSpecular>
    void forEachLayer(const GeometrySamples& samples, std::size_t sample, const Visit& visit,
                      const VisitReceived& visitReceived, const VisitSpecular& visitSpecular) {
        forEachPlace(samples, sample, byRows(visit), byRows(visitReceived), visitSpecular);
    }

    /// Calls visit(front, weight) for the columns of what gas emits, or of a sum of such.
    template <typename Gas, typename Visit>
    void forEachColumn(int stack, const Gas& gas, const Visit& visit) {
        forEachColumn(stack, gas, gas.values, visit);
    }
    template <typename Gas, typename Visit>
    void forEachColumn(int stack, const Gas& gas, std::span<const double> values,
                       const Visit& visit) {
        weights_.resize(gas.columns->numbers.size());
        gas.columns->basis.weightsOf(values, weights_);
        for (std::size_t k = 0; k < weights_.size(); ++k)
            if (weights_[k] != 0.0)
                visit(behindColumns(stack, gas.firstSet + static_cast<int>(k)), weights_[k]);
    }

    /// Calls visit(place, coverage) for the places of what a lobe mirrors, by component.
    template <typename Visit>
    static void forEachShare(const GeometrySamples& samples,
                             const GeometrySamples::Specular& mirror, Visit visit) {
        const SpecularEnvironmentTable& table = *samples.specularTables[mirror.table];
        const float* const nodes[] = {table.of(mirror.nodes[0]), table.of(mirror.nodes[1]),
                                      table.of(mirror.nodes[2])};
        for (std::size_t k = 0; k < table.components; ++k)
            for (std::size_t i = k * table.places; i < (k + 1) * table.places; ++i) {
                const float share = mirror.weights[0] * nodes[0][i] +
                                    mirror.weights[1] * nodes[1][i] +
                                    mirror.weights[2] * nodes[2][i];
                if (share != 0.0f)
                    visit(i, samples.specularScales[mirror.scales + k] * share);
            }
    }

  private:
    static constexpr std::array<float, mostFactors> noFactors{};

    /// A layer, and light that it gets through something.
    template <typename Light, typename Visit>
    void visitLayer(const GeometrySamples& samples, int stack, const GeometrySamples::Layer& layer,
                    const Light& all, const Visit& visit) {
        const SurfaceRows::Between between = rows_.at(layer.row, layer.distance_m);
        visit(stack, between, layer);
        visitThrough(samples, stack, layer, between, 1.0, all, visit);
    }
    template <typename Light, typename Visit>
    void visitThrough(const GeometrySamples& samples, int stack,
                      const GeometrySamples::Layer& layer, const SurfaceRows::Between& between,
                      double scale, const Light& all, const Visit& visit) {
        all.light.ofThisLayer([&](const GeometrySamples::Through& one) {
            visit(behindSet(stack, samples.throughSets[one.set]), between,
                  lightAlone(layer, one, static_cast<float>(scale)));
        });
    }
    /// What lobes of a layer send and reflect.
    template <typename Light, typename Visit, typename VisitSpecular>
    void visitLobes(const GeometrySamples& samples, int stack, const GeometrySamples::Layer& layer,
                    const Light& all, const Visit& visit, const VisitSpecular& visitSpecular) {
        all.lobes.ofThisLayer([&](const GeometrySamples::Lobe& one) {
            const GeometrySamples::Layer lobe = lobeOf(samples, layer, one);
            const SurfaceRows::Between between = rows_.at(lobe.row, lobe.distance_m);
            visit(stack, between, lobe);
            if (one.sun != 0.0f)
                visitThrough(samples, stack, lobe, between, static_cast<double>(one.sun), all,
                             visit);
        });
        all.mirrors.ofThisLayer(
            [&](const GeometrySamples::Specular& one) { visitSpecular(stack, layer, one); });
        all.reflected.ofThisLayer([&](const GeometrySamples::Reflected& one) {
            visit(one.set == 0 ? stack : behindSet(stack, samples.reflectedSets[one.set]),
                  rows_.at(one.row, layer.distance_m),
                  GeometrySamples::Layer{one.row,
                                         layer.distance_m,
                                         {noFactors.data(), layer.factors.size()},
                                         one.weight,
                                         &one.from,
                                         true});
        });
    }

    template <typename Visit, typename VisitReceived, typename VisitSpecular, typename VisitGas>
    void forEachPlaceInGas(const GeometrySamples& samples, std::size_t sample, const Visit& visit,
                           const VisitReceived& visitReceived, const VisitSpecular& visitSpecular,
                           const VisitGas& visitGas) {
        int stack = 0; // of materials that are no gas
        LightOfLayers light(*this, samples, sample);
        gas_.begin(samples.gasesAboutEye);
        samples.forEachLayer(sample, [&](const GeometrySamples::Layer& layer) {
            gas_.goTo(layer.distance_m);
            if (rows_.gas(layer.row) != nullptr) {
                gas_.cross(layer.row);
                return light.goOn();
            }
            emitGas(stack, samples.gasShare(sample), visitGas);
            const auto visitPart = [&](float part) {
                return [&visit, this, part](int own, const SurfaceRows::Between& between,
                                            const GeometrySamples::Layer& whole) {
                    visit(own, between, partOf(whole, part));
                };
            };
            GeometrySamples::Layer alone = layer;
            alone.place = nullptr;
            for (const GasWalk::Branch& branch : gas_.branches())
                visitLayer(samples, behindColumns(stack, branch.set), alone, light,
                           visitPart(static_cast<float>(branch.weight)));
            if (layer.place != nullptr || light.hasLobes())
                for (const GasWalk::Branch& branch : gas_.reflectionBranches()) {
                    const int here = behindColumns(stack, branch.set);
                    const auto part = static_cast<float>(branch.weight);
                    if (layer.place != nullptr)
                        visitReceived(here, rows_.at(layer.row, layer.distance_m),
                                      receivedBy(layer, part));
                    visitLobes(samples, here, layer, light, visitPart(part),
                               [&](int own, const GeometrySamples::Layer& whole,
                                   GeometrySamples::Specular mirror) {
                                   for (float& weight : mirror.weights)
                                       weight *= part;
                                   visitSpecular(own, whole, mirror);
                               });
                }
            light.goOn();
            if (rows_.isTransparent(layer.row))
                stack = behind(stack, layer.row);
        });
        emitGas(stack, samples.gasShare(sample), visitGas);
    }
    /// Visits what gas emits since the last layer that was none.
    template <typename VisitGas>
    void emitGas(int stack, double share, const VisitGas& visitGas) {
        if (!gas_.hasNew())
            return;
        for (const GasWalk::Emission& one : gas_.takeEmission(share))
            visitGas(behindColumns(stack, one.before.set), rows_.at(one.row, one.distance_m), one);
    }
    GeometrySamples::Layer partOf(const GeometrySamples::Layer& whole, float part) {
        for (std::size_t f = 0; f < whole.factors.size(); ++f)
            part_[f] = part * whole.factors[f];
        return {whole.row,
                whole.distance_m,
                {part_.data(), whole.factors.size()},
                part * whole.coverage,
                whole.place,
                whole.isLobe};
    }

    /// What it receives of other surfaces alone.
    static GeometrySamples::Layer receivedBy(const GeometrySamples::Layer& layer, float part) {
        return {layer.row,
                layer.distance_m,
                {noFactors.data(), layer.factors.size()},
                part * layer.coverage,
                layer.place,
                layer.isLobe};
    }

    /// Of samples that nothing of the light belongs to.
    template <typename Visit>
    [[gnu::always_inline]] void forEachLayerAlone(const GeometrySamples& samples,
                                                  std::size_t sample, const Visit& visit) {
        int stack = 0;
        samples.forEachLayer(
            sample, [&](const GeometrySamples::Layer& layer) __attribute__((always_inline)) {
                visit(stack, rows_.at(layer.row, layer.distance_m), layer);
                if (rows_.isTransparent(layer.row))
                    stack = behind(stack, layer.row);
            });
    }

    template <typename Visit>
    auto byRows(const Visit& visit) const {
        return [ this, &visit ](int stack, const SurfaceRows::Between& between,
                                const GeometrySamples::Layer& layer)
            __attribute__((always_inline)) {
            visit(SurfaceStackId{stack, between.row}, 1.0f - between.next, layer);
            if (rows_.isSliced(layer.row))
                visit(SurfaceStackId{stack, between.row + 1}, between.next, layer);
        };
    }

    /// What a list has of a sample's layers, one layer after the other.
    template <typename One>
    class OfLayers {
      public:
        /// `from`: where those of the sample before it ended, as a rule; where its own end from now
        /// on.
        OfLayers(const std::vector<One>& all, std::size_t sample, std::size_t& from) {
            if (all.empty())
                return;
            end_ = all.data() + all.size();
            sample_ = sample;
            const auto isBefore = [](const One& one, std::size_t number) {
                return one.sample < number;
            };
            const bool isThere = from <= all.size() &&
                                 (from == 0 || isBefore(all[from - 1], sample)) &&
                                 (from == all.size() || !isBefore(all[from], sample));
            next_ =
                isThere ? all.data() + from : std::lower_bound(all.data(), end_, sample, isBefore);
            const One* last = next_;
            while (last != end_ && last->sample == sample_)
                ++last;
            from = static_cast<std::size_t>(last - all.data());
        }
        template <typename Visit>
        void ofThisLayer(const Visit& visit) const {
            for (const One* one = next_;
                 one != end_ && one->sample == sample_ && one->layer == layer_; ++one)
                visit(*one);
        }
        bool isThere() const {
            return next_ != end_ && next_->sample == sample_ && next_->layer == layer_;
        }
        void goOn() {
            while (next_ != end_ && next_->sample == sample_ && next_->layer == layer_)
                ++next_;
            ++layer_;
        }

      private:
        const One *next_ = nullptr, *end_ = nullptr;
        std::size_t sample_ = 0;
        std::uint32_t layer_ = 0;
    };

    /// What the lists of light have of a sample's layers.
    struct LightOfLayers {
        LightOfLayers(LayerWalk& walk, const GeometrySamples& samples, std::size_t sample)
            : light(samples.through, sample, walk.lightFrom_),
              lobes(samples.lobes, sample, walk.lobesFrom_),
              mirrors(samples.speculars, sample, walk.specularsFrom_),
              reflected(samples.reflected, sample, walk.reflectedFrom_) {}
        void goOn() {
            light.goOn();
            lobes.goOn();
            mirrors.goOn();
            reflected.goOn();
        }
        bool hasLobes() const {
            return lobes.isThere() || mirrors.isThere() || reflected.isThere();
        }
        OfLayers<GeometrySamples::Through> light;
        OfLayers<GeometrySamples::Lobe> lobes;
        OfLayers<GeometrySamples::Specular> mirrors;
        OfLayers<GeometrySamples::Reflected> reflected;
    };

    GeometrySamples::Layer lightAlone(const GeometrySamples::Layer& layer,
                                      const GeometrySamples::Through& light, float scale) {
        light_.fill(0.0f);
        light_[light.factor] = scale * light.value;
        return {layer.row, layer.distance_m, {light_.data(), layer.factors.size()},
                0.0f,      nullptr,          layer.isLobe};
    }
    GeometrySamples::Layer lobeOf(const GeometrySamples& samples,
                                  const GeometrySamples::Layer& layer,
                                  const GeometrySamples::Lobe& lobe) {
        for (std::size_t f = 0; f < layer.factors.size(); ++f) {
            const LobeRole role = samples.lobeRoles[f];
            lobe_[f] = layer.factors[f] * (role == LobeRole::emission ? lobe.emission
                                           : role == LobeRole::sun    ? lobe.sun
                                                                      : lobe.flux);
        }
        // What lobes reflect of the air is nothing of other surfaces.
        return {lobe.row,
                layer.distance_m,
                {lobe_.data(), layer.factors.size()},
                lobe.flux,
                rows_.lobe(lobe.row).isOfAtmosphere() ? nullptr : layer.place,
                true};
    }
    int behindSet(int stack, const std::vector<OccluderMaterial>& set) {
        for (const OccluderMaterial& material : set)
            stack = occluderStacks_.behind(stack, material);
        return stack;
    }
    int behindColumns(int stack, int set) {
        if (set == 0)
            return stack;
        const auto number = static_cast<std::size_t>(set), place = static_cast<std::size_t>(stack);
        if (place >= nextColumns_.size())
            nextColumns_.resize(place + 1);
        if (number >= nextColumns_[place].size())
            nextColumns_[place].resize(number + 1, -1);
        int& next = nextColumns_[place][number];
        if (next < 0)
            next = behindSet(stack, gas_.columns(set));
        return next;
    }
    [[gnu::always_inline]] int behind(int stack, int drawn) {
        const std::size_t place =
            static_cast<std::size_t>(stack) * drawn_ + static_cast<std::size_t>(drawn);
        return place < next_.size() && next_[place] >= 0 ? next_[place]
                                                         : newBehind(place, stack, drawn);
    }
    [[gnu::noinline]] int newBehind(std::size_t place, int stack, int drawn) {
        if (place >= next_.size())
            next_.resize((static_cast<std::size_t>(stack) + 1) * drawn_, -1);
        return next_[place] = occluderStacks_.behind(stack, rows_.material(drawn));
    }

    const SurfaceRows& rows_;
    std::size_t drawn_; // rows of the drawing
    OccluderStacks occluderStacks_;
    std::vector<int> next_;                     // by front and drawn row
    std::vector<std::vector<int>> nextColumns_; // by front and set of columns
    bool hasGas_;
    GasWalk gas_;
    std::array<float, mostFactors> light_{}, lobe_{}, part_{};
    std::vector<double> weights_; // of columns
    std::size_t lightFrom_ = 0, lobesFrom_ = 0, specularsFrom_ = 0, reflectedFrom_ = 0;
};

} // namespace irsg

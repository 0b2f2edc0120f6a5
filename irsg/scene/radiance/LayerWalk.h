#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/scene/radiance/FactorField.h"
#include "irsg/scene/radiance/Fronts.h"
#include "irsg/scene/radiance/SurfaceRows.h"
#include "irsg/scene/sampling/Samples.h"

namespace irsg {

/// Goes through the layers of samples from front to back and knows what lies before each. One for
/// each thread: its numbers of fronts are its own.
class LayerWalk {
  public:
    explicit LayerWalk(const SurfaceRows& rows) : rows_(rows), drawn_(rows.keys().size()) {}

    const Fronts& fronts() const { return fronts_; }

    /// Calls visit(front, between, layer) for every layer of a sample, front to back. Light that a
    /// layer gets through something comes after it, as if that stood before the layer, too, and
    /// with no coverage: what materials let through is multiplied, wherever they stand.
    template <typename Visit>
    void forEachPlace(const FactorSamples& samples, std::size_t sample, Visit visit) {
        int front = 0;
        LightThrough light(samples, sample);
        samples.forEachLayer(sample, [&](const FactorSamples::Layer& layer) {
            const SurfaceRows::Between between = rows_.at(layer.row, layer.distance_m);
            visit(front, between, layer);
            light.ofNextLayer([&](const FactorSamples::Through& one) {
                visit(behindSet(front, samples.throughSets[one.set]), between,
                      lightAlone(layer, one));
            });
            if (rows_.isTransparent(layer.row))
                front = behind(front, layer.row);
        });
    }
    /// Calls visit(kind, weight, layer) for every layer of a sample, front to back; twice for one
    /// between two nodes of its entity's slices.
    template <typename Visit>
    void forEachLayer(const FactorSamples& samples, std::size_t sample, Visit visit) {
        int front = 0;
        LightThrough light(samples, sample);
        samples.forEachLayer(sample, [&](const FactorSamples::Layer& layer) {
            rows_.forEachRow(layer.row, layer.distance_m, [&](int row, float weight) {
                visit(FactorKind{front, row}, weight, layer);
            });
            light.ofNextLayer([&](const FactorSamples::Through& one) {
                const int through = behindSet(front, samples.throughSets[one.set]);
                const FactorSamples::Layer alone = lightAlone(layer, one);
                rows_.forEachRow(layer.row, layer.distance_m, [&](int row, float weight) {
                    visit(FactorKind{through, row}, weight, alone);
                });
            });
            if (rows_.isTransparent(layer.row))
                front = behind(front, layer.row);
        });
    }

  private:
    /// The light through something of a sample's layers, one layer after the other.
    class LightThrough {
      public:
        LightThrough(const FactorSamples& samples, std::size_t sample) {
            if (samples.through.empty())
                return;
            end_ = samples.through.data() + samples.through.size();
            next_ = std::lower_bound(samples.through.data(), end_, sample,
                                     [](const FactorSamples::Through& one, std::size_t number) {
                                         return one.sample < number;
                                     });
            sample_ = sample;
        }
        template <typename Visit>
        void ofNextLayer(Visit visit) {
            for (; next_ != end_ && next_->sample == sample_ && next_->layer == layer_; ++next_)
                visit(*next_);
            ++layer_;
        }

      private:
        const FactorSamples::Through *next_ = nullptr, *end_ = nullptr;
        std::size_t sample_ = 0;
        std::uint32_t layer_ = 0;
    };

    FactorSamples::Layer lightAlone(const FactorSamples::Layer& layer,
                                    const FactorSamples::Through& light) {
        light_.fill(0.0f);
        light_[light.factor] = light.value;
        return {layer.row, layer.distance_m, {light_.data(), layer.factors.size()}, 0.0f, nullptr};
    }
    int behindSet(int front, const std::vector<FrontMaterial>& set) {
        for (const FrontMaterial& material : set)
            front = fronts_.behind(front, material);
        return front;
    }
    int behind(int front, int drawn) {
        const std::size_t place =
            static_cast<std::size_t>(front) * drawn_ + static_cast<std::size_t>(drawn);
        if (place >= next_.size())
            next_.resize((static_cast<std::size_t>(front) + 1) * drawn_, -1);
        int& next = next_[place];
        return next >= 0 ? next : next = fronts_.behind(front, rows_.material(drawn));
    }

    const SurfaceRows& rows_;
    std::size_t drawn_; // rows of the drawing
    Fronts fronts_;
    std::vector<int> next_; // by front and drawn row
    std::array<float, mostFactors> light_{};
};

} // namespace irsg

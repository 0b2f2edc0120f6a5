#pragma once

#include <cstddef>
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

    /// Calls visit(front, between, layer) for every layer of a sample, front to back.
    template <typename Visit>
    void forEachPlace(const FactorSamples& samples, std::size_t sample, Visit visit) {
        int front = 0;
        samples.forEachLayer(sample, [&](const FactorSamples::Layer& layer) {
            visit(front, rows_.at(layer.row, layer.distance_m), layer);
            if (rows_.isTransparent(layer.row))
                front = behind(front, layer.row);
        });
    }
    /// Calls visit(kind, weight, layer) for every layer of a sample, front to back; twice for one
    /// between two nodes of its entity's slices.
    template <typename Visit>
    void forEachLayer(const FactorSamples& samples, std::size_t sample, Visit visit) {
        int front = 0;
        samples.forEachLayer(sample, [&](const FactorSamples::Layer& layer) {
            rows_.forEachRow(layer.row, layer.distance_m, [&](int row, float weight) {
                visit(FactorKind{front, row}, weight, layer);
            });
            if (rows_.isTransparent(layer.row))
                front = behind(front, layer.row);
        });
    }

  private:
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
};

} // namespace irsg

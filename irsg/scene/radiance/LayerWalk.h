#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/scene/radiance/FactorField.h"
#include "irsg/scene/radiance/Fronts.h"
#include "irsg/scene/radiance/SurfaceRows.h"
#include "irsg/scene/sampling/SampleWindow.h"
#include "irsg/scene/sampling/Samples.h"

namespace irsg {

/// Goes through the layers of samples from front to back and knows what lies before each. One for
/// each thread: its numbers of fronts are its own.
class LayerWalk {
  public:
    explicit LayerWalk(const SurfaceRows& rows) : rows_(rows) {}

    const Fronts& fronts() const { return fronts_; }

    /// Calls visit(kind, weight, layer) for every layer of a sample, front to back; twice for one
    /// between two nodes of its entity's slices.
    template <typename Visit>
    void forEachLayer(const FactorSamples& samples, std::size_t sample, Visit visit) {
        int front = 0;
        for (std::uint32_t layer = samples.first[sample]; layer < samples.first[sample + 1];
             ++layer) {
            const int drawn = samples.rows[layer];
            rows_.forEachRow(drawn, samples.distances_m[layer], [&](int row, float weight) {
                visit(FactorKind{front, row}, weight, layer);
            });
            if (rows_.isTransparent(drawn))
                front = behind(front, drawn);
        }
    }

  private:
    int behind(int front, int drawn) {
        const auto number = static_cast<std::size_t>(front);
        if (number >= next_.size())
            next_.resize(number + 1);
        if (next_[number].empty())
            next_[number].assign(rows_.keys().size(), -1);
        int& next = next_[number][static_cast<std::size_t>(drawn)];
        return next >= 0 ? next : next = fronts_.behind(front, rows_.material(drawn));
    }

    const SurfaceRows& rows_;
    Fronts fronts_;
    std::vector<std::vector<int>> next_; // [front][drawn row]
};

/// Sums the factors of samples over runs that fall to one pixel, kind by kind: sink(x, y, weight,
/// kind, sums) with sums[0] the number of samples and sums[1 + f] the sum of factor f, of which
/// each counts with `weight` of a sample.
class RunSums {
  public:
    RunSums(const SurfaceRows& rows, LayerWalk& walk, std::size_t factorCount)
        : rows_(static_cast<std::size_t>(rows.size())), walk_(walk), width_(factorCount + 1) {}

    template <typename Sink>
    void add(const SampleWindow& window, const FactorSamples& samples, int firstRow, int lastRow,
             Sink sink) {
        window.forEachRun(
            firstRow, lastRow, [&](std::size_t first, int count, int x, int y, double weight) {
                const std::size_t last = first + static_cast<std::size_t>(count);
                if (samples.first[first] == samples.first[last])
                    return;
                for (std::size_t i = first; i < last; ++i)
                    walk_.forEachLayer(
                        samples, i, [&](const FactorKind& kind, float part, std::uint32_t layer) {
                            double* sums = sumsOf(kind);
                            const auto share = static_cast<double>(part);
                            sums[0] += share;
                            const float* factors = &samples.factors[layer * samples.factorCount];
                            for (std::size_t f = 1; f < width_; ++f)
                                sums[f] += share * static_cast<double>(factors[f - 1]);
                        });
                for (const FactorKind& kind : touched_) {
                    const std::size_t place = placeOf(kind);
                    double* sums = &sums_[place * width_];
                    sink(x, y, weight, kind, sums);
                    std::fill(sums, sums + width_, 0.0);
                    isTouched_[place] = 0;
                }
                touched_.clear();
            });
    }

  private:
    std::size_t placeOf(const FactorKind& kind) const {
        return static_cast<std::size_t>(kind.front) * rows_ + static_cast<std::size_t>(kind.row);
    }
    double* sumsOf(const FactorKind& kind) {
        const std::size_t place = placeOf(kind);
        if (place >= isTouched_.size()) {
            isTouched_.resize((static_cast<std::size_t>(kind.front) + 1) * rows_, 0);
            sums_.resize(isTouched_.size() * width_, 0.0);
        }
        if (!isTouched_[place]) {
            isTouched_[place] = 1;
            touched_.push_back(kind);
        }
        return &sums_[place * width_];
    }

    std::size_t rows_;
    LayerWalk& walk_;
    std::size_t width_;
    std::vector<double> sums_; // by front and row
    std::vector<char> isTouched_;
    std::vector<FactorKind> touched_;
};

} // namespace irsg

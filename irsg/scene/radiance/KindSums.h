#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "irsg/scene/radiance/FactorField.h"
#include "irsg/scene/radiance/LayerWalk.h"
#include "irsg/scene/radiance/SceneLight.h"
#include "irsg/scene/radiance/SurfaceRows.h"
#include "irsg/scene/radiance/ViewFactors.h"
#include "irsg/scene/view/FrameBackground.h"
#include "irsg/scene/view/PixelGrid.h"

namespace irsg {

/// Sums of a part of a view's samples by kind, as ViewLayout has them, for `Factors` drawn factors.
/// Every layer of every sample comes here: sums are dense, and their number is known when this is
/// compiled.
template <std::size_t Factors>
class ViewKindSums {
  public:
    /// All must live as long. `share`: a sample's part of a pixel.
    ViewKindSums(const SurfaceRows& rows, const PixelGrid& grid,
                 const std::vector<const FrameBackground*>& varying, const LightExchange* exchange,
                 double share)
        : rows_(static_cast<std::size_t>(rows.size())),
          surfaces_(rows),
          grid_(grid),
          varying_(varying),
          exchange_(exchange),
          share_(share),
          behind_W_m2_sr_(varying.size()) {}

    /// Samples that are added now lie in a pixel and count with `weight`.
    void goTo(int x, int y, double weight) {
        const PixelGrid::Pixel pixel = grid_.at(x, y);
        part_ = weight * share_;
        omega_sr_ = pixel.solidAngle_sr * part_;
        projected_sr_ = omega_sr_ * pixel.cosOffAxis;
        for (std::size_t k = 0; k < varying_.size(); ++k)
            behind_W_m2_sr_[k] = varying_[k]->at(x, y);
    }

    /// The same as others, times a factor.
    void goTo(const ViewKindSums& others, double factor) {
        part_ = factor * others.part_;
        omega_sr_ = factor * others.omega_sr_;
        projected_sr_ = factor * others.projected_sr_;
        behind_W_m2_sr_ = others.behind_W_m2_sr_;
    }

    [[gnu::always_inline]] void add(int front, const SurfaceRows::Between& between,
                                    const FactorSamples::Layer& layer) {
        const std::size_t place =
            static_cast<std::size_t>(front) * rows_ + static_cast<std::size_t>(between.row);
        if (place >= places_)
            grow(front);
        const float* factors = layer.factors.data();
        if (layer.place && layer.place->triangle != FactorSamples::Place::none) {
            addReceivers(place, between.row, 1.0 - static_cast<double>(between.next), *layer.place);
            if (between.next > 0.0f)
                addReceivers(place + 1, between.row, static_cast<double>(between.next),
                             *layer.place);
        }
        addTo(place, 1.0 - static_cast<double>(between.next), factors,
              std::make_index_sequence<Factors>());
        if (between.next > 0.0f)
            addTo(place + 1, static_cast<double>(between.next), factors,
                  std::make_index_sequence<Factors>());
    }

    /// Factors of what is covered already, and what lobes have for coverage.
    void addLight(int front, const SurfaceRows::Between& between,
                  const FactorSamples::Layer& layer) {
        const std::size_t place =
            static_cast<std::size_t>(front) * rows_ + static_cast<std::size_t>(between.row);
        if (place >= places_)
            grow(front);
        const auto coverage = static_cast<double>(layer.coverage);
        const auto addTo = [&](std::size_t to, double weight) {
            Sums& sums = sums_[to];
            sums.plain[0] += weight * omega_sr_ * coverage;
            sums.cosine[0] += weight * projected_sr_ * coverage;
            for (std::size_t f = 0; f < Factors; ++f) {
                const auto factor = static_cast<double>(layer.factors[f]);
                sums.plain[1 + f] += weight * omega_sr_ * factor;
                sums.cosine[1 + f] += weight * projected_sr_ * factor;
            }
            if (layer.place && layer.place->triangle != FactorSamples::Place::none)
                addReceivers(to, between.row, weight * coverage, *layer.place);
        };
        addTo(place, 1.0 - static_cast<double>(between.next));
        if (between.next > 0.0f)
            addTo(place + 1, static_cast<double>(between.next));
    }

    /// What lobes mirror of the air, which is divided among its places once all is added.
    void addMirror(int front, const FactorSamples& samples, const FactorSamples::Layer& layer,
                   const FactorSamples::Mirror& mirror) {
        const SurfaceRows::Between between = surfaces_.at(mirror.row, layer.distance_m);
        const MirrorTable& table = *samples.mirrorTables[mirror.table];
        const float* scales = &samples.mirrorScales[mirror.scales];
        const auto addTo = [&](int row, double weight) {
            std::vector<double>& sums = mirrorsOf(front, row, samples, mirror);
            for (std::size_t n = 0; n < mirror.nodes.size(); ++n) {
                const std::size_t first = 2 * table.components * mirror.nodes[n];
                if (first + 2 * table.components > sums.size())
                    sums.resize(first + 2 * table.components);
                const double ofNode = weight * static_cast<double>(mirror.weights[n]);
                for (std::size_t k = 0; k < table.components; ++k) {
                    const double own = ofNode * static_cast<double>(scales[k]);
                    sums[first + 2 * k] += own * omega_sr_;
                    sums[first + 2 * k + 1] += own * projected_sr_;
                }
            }
        };
        addTo(between.row, 1.0 - static_cast<double>(between.next));
        if (between.next > 0.0f)
            addTo(between.row + 1, static_cast<double>(between.next));
    }
    /// Divides it; nothing is added afterwards.
    void finish() {
        for (const auto& [key, mirrors] : mirrors_) {
            const auto& [front, row, number] = key;
            const std::shared_ptr<const MirrorTable>& table = mirrors.table;
            // In an order that what was seen before does not change.
            std::vector<std::size_t> nodes(mirrors.sums.size() / (2 * table->components));
            std::iota(nodes.begin(), nodes.end(), std::size_t{0});
            std::ranges::sort(nodes, {}, [&](std::size_t node) { return table->keys[node]; });
            const auto last = static_cast<std::size_t>(
                row + static_cast<int>(table->valuesOfNode() - 1) * mirrors.rowsOfPlace);
            const std::size_t first = static_cast<std::size_t>(front) * rows_;
            if (first + last >= places_)
                grow(front);
            for (const std::size_t node : nodes)
                for (std::size_t k = 0; k < table->components; ++k) {
                    const double* seen = &mirrors.sums[2 * (node * table->components + k)];
                    if (seen[0] == 0.0)
                        continue;
                    const float* shares = table->of(static_cast<std::uint32_t>(node));
                    for (std::size_t i = k * table->places; i < (k + 1) * table->places; ++i) {
                        Sums& sums =
                            sums_[first + static_cast<std::size_t>(row + static_cast<int>(i) *
                                                                             mirrors.rowsOfPlace)];
                        sums.plain[0] += static_cast<double>(shares[i]) * seen[0];
                        sums.cosine[0] += static_cast<double>(shares[i]) * seen[1];
                    }
                }
        }
        mirrors_.clear();
        lastMirrors_ = nullptr;
    }

    /// Ends the runs of receivers; no sample comes after it.
    void finishLight() {
        for (std::size_t place = 0; place < receivers_.size(); ++place)
            if (!receivers_[place].empty())
                addRun(std::exchange(runs_[place], {}), receivers_[place]);
    }
    /// Adds what was seen of receivers of light, finished, times a sign; see addTo.
    template <typename FrontOf>
    void addLightTo(LightSums& light, FrontOf frontOf, double sign) const {
        for (std::size_t place = 0; place < receivers_.size(); ++place)
            if (!receivers_[place].empty())
                addScaled(receivers_[place], sign,
                          light[{frontOf(static_cast<int>(place / rows_)),
                                 static_cast<int>(place % rows_)}]);
    }

    /// Adds what was seen times a sign to the one cell of a field. `frontOf(front)` is the number
    /// there of one here.
    template <typename FrontOf>
    void addTo(FactorField<double>& field, const ViewLayout& layout, FrontOf frontOf,
               double sign) const {
        for (std::size_t place = 0; place < sums_.size(); ++place) {
            const Sums& sums = sums_[place];
            if (std::ranges::all_of(sums.plain, [](double sum) { return sum == 0.0; }))
                continue;
            double* numbers = field.at(0, field.kindOf({frontOf(static_cast<int>(place / rows_)),
                                                        static_cast<int>(place % rows_)}));
            for (std::size_t i = 0; i <= Factors; ++i) {
                numbers[i] += sign * sums.plain[i];
                numbers[layout.withCosine(i)] += sign * sums.cosine[i];
            }
            numbers[layout.pixels()] += sign * sums.pixels;
            for (std::size_t k = 0; k < varying_.size(); ++k) {
                const double* behind_W_m2 = &behind_W_m2_[2 * (place * varying_.size() + k)];
                numbers[layout.background(k)] += sign * behind_W_m2[0];
                numbers[layout.backgroundCosine(k)] += sign * behind_W_m2[1];
            }
        }
    }

  private:
    using Numbers = std::array<double, Factors + 1>;
    /// Coverage and factors, times solid angle and times projected solid angle, sr.
    struct Sums {
        Numbers plain{}, cosine{};
        double pixels = 0.0;
    };

    /// Each number in a register of its own: an array would go through memory twice, in pieces of
    /// different sizes, for which processors wait.
    template <std::size_t... I>
    void addTo(std::size_t place, double weight, const float* factors, std::index_sequence<I...>) {
        Sums& sums = sums_[place];
        const double omega_sr = weight * omega_sr_, projected_sr = weight * projected_sr_;
        sums.plain[0] += omega_sr;
        sums.cosine[0] += projected_sr;
        ((sums.plain[1 + I] += omega_sr * static_cast<double>(factors[I]),
          sums.cosine[1 + I] += projected_sr * static_cast<double>(factors[I])),
         ...);
        sums.pixels += weight * part_;
        for (std::size_t k = 0; k < behind_W_m2_sr_.size(); ++k) {
            double* behind_W_m2 = &behind_W_m2_[2 * (place * behind_W_m2_sr_.size() + k)];
            behind_W_m2[0] += omega_sr * behind_W_m2_sr_[k];
            behind_W_m2[1] += projected_sr * behind_W_m2_sr_[k];
        }
    }

    /// Samples that follow each other in one triangle, by the weights of its corners.
    struct Run {
        std::uint32_t triangle = FactorSamples::Place::none;
        std::array<double, 3> plain{}, cosine{};
    };
    void addReceivers(std::size_t place, int row, double weight, const FactorSamples::Place& at) {
        if (place >= receivers_.size()) {
            receivers_.resize(places_);
            runs_.resize(places_);
        }
        Run& run = runs_[place];
        if (run.triangle != at.triangle) {
            std::vector<double>& sums = receivers_[place];
            if (sums.empty())
                sums.resize(2 *
                            exchange_->ofRow(surfaces_.surfaceOf(surfaces_.drawnOf(row))).size());
            addRun(run, sums);
            run = {};
            run.triangle = at.triangle;
        }
        const auto u = static_cast<double>(at.u), v = static_cast<double>(at.v);
        const std::array<double, 3> parts{1.0 - u - v, u, v};
        for (std::size_t c = 0; c < 3; ++c) {
            run.plain[c] += weight * omega_sr_ * parts[c];
            run.cosine[c] += weight * projected_sr_ * parts[c];
        }
    }
    void addRun(const Run& run, std::vector<double>& sums) const {
        if (run.triangle == FactorSamples::Place::none)
            return;
        exchange_->forEachReceiver(
            run.triangle, [&](std::uint32_t receiver, std::size_t corner, float part) {
                const std::size_t own = 2 * static_cast<std::size_t>(exchange_->localOf(receiver));
                sums[own] += run.plain[corner] * static_cast<double>(part);
                sums[own + 1] += run.cosine[corner] * static_cast<double>(part);
            });
    }

    /// By node, component, and without and with cosine.
    struct Mirrors {
        std::shared_ptr<const MirrorTable> table;
        int rowsOfPlace = 1;
        std::vector<double> sums;
    };
    using MirrorKey = std::tuple<int, int, std::uint32_t>; // front, row of the first place, table
    std::vector<double>& mirrorsOf(int front, int row, const FactorSamples& samples,
                                   const FactorSamples::Mirror& mirror) {
        const MirrorKey key{front, row, mirror.table};
        if (lastMirrors_ == nullptr || key != lastKey_) {
            lastKey_ = key;
            lastMirrors_ = &mirrors_[key];
            lastMirrors_->table = samples.mirrorTables[mirror.table];
            lastMirrors_->rowsOfPlace =
                surfaces_.first(mirror.row + 1) - surfaces_.first(mirror.row);
        }
        return lastMirrors_->sums;
    }

    void grow(int front) {
        places_ = (static_cast<std::size_t>(front) + 1) * rows_;
        sums_.resize(places_);
        behind_W_m2_.resize(2 * sums_.size() * varying_.size());
    }

    std::size_t rows_, places_ = 0;
    const SurfaceRows& surfaces_;
    const PixelGrid& grid_;
    const std::vector<const FrameBackground*>& varying_;
    const LightExchange* exchange_;
    std::vector<std::vector<double>> receivers_; // by front and row
    std::vector<Run> runs_;                      // likewise
    double share_;
    double part_ = 0.0, omega_sr_ = 0.0, projected_sr_ = 0.0; // of a sample in its pixel
    std::vector<double> behind_W_m2_sr_;                      // by varying background
    std::vector<Sums> sums_;                                  // by front and row
    std::map<MirrorKey, Mirrors> mirrors_;
    MirrorKey lastKey_{};
    Mirrors* lastMirrors_ = nullptr;
    std::vector<double> behind_W_m2_; // by front, row and background: without and with cosine
};

/// The same by pixel: coverage and factors as parts of a pixel.
class PixelKindSums {
  public:
    /// `pixels`: those of the part. `share`: a sample's part of a pixel.
    PixelKindSums(const SurfaceRows& rows, const PixelWindow& pixels, std::size_t factorCount,
                  const LightExchange* exchange, const ReceiverRows& receivers, double share)
        : rows_(static_cast<std::size_t>(rows.size())),
          surfaces_(rows),
          pixels_(pixels),
          factorCount_(factorCount),
          exchange_(exchange),
          receivers_(receivers),
          share_(share),
          field_(cellsOf(pixels), factorCount + 1),
          light_(exchange ? cellsOf(pixels) : 0, 1) {}

    void goTo(int x, int y, double weight) {
        part_ = weight * share_;
        cell_ = static_cast<std::size_t>(y - pixels_.y) * static_cast<std::size_t>(pixels_.width) +
                static_cast<std::size_t>(x - pixels_.x);
    }

    void add(int front, const SurfaceRows::Between& between, const FactorSamples::Layer& layer) {
        const float* factors = layer.factors.data();
        const auto next = static_cast<double>(between.next);
        addTo({front, between.row}, 1.0 - next, factors);
        if (next > 0.0)
            addTo({front, between.row + 1}, next, factors);
        if (!layer.place || layer.place->triangle == FactorSamples::Place::none)
            return;
        addReceivers({front, between.row}, 1.0 - next, *layer.place);
        if (next > 0.0)
            addReceivers({front, between.row + 1}, next, *layer.place);
    }

    void addLight(int front, const SurfaceRows::Between& between,
                  const FactorSamples::Layer& layer) {
        const auto next = static_cast<double>(between.next);
        const auto coverage = static_cast<double>(layer.coverage);
        const auto addTo = [&](int row, double weight) {
            this->addTo({front, row}, weight, layer.factors.data(), coverage);
            if (layer.place && layer.place->triangle != FactorSamples::Place::none)
                addReceivers({front, row}, weight * coverage, *layer.place);
        };
        addTo(between.row, 1.0 - next);
        if (next > 0.0)
            addTo(between.row + 1, next);
    }

    void addMirror(int front, const FactorSamples& samples, const FactorSamples::Layer& layer,
                   const FactorSamples::Mirror& mirror) {
        static constexpr std::array<float, mostFactors> none{};
        LayerWalk::forEachShare(samples, mirror, [&](std::size_t place, float coverage) {
            const SurfaceRows::Between between =
                surfaces_.at(mirror.row + static_cast<int>(place), layer.distance_m);
            const auto next = static_cast<double>(between.next);
            addTo({front, between.row}, 1.0 - next, none.data(), static_cast<double>(coverage));
            if (next > 0.0)
                addTo({front, between.row + 1}, next, none.data(), static_cast<double>(coverage));
        });
    }
    void finish() {}

    const FactorField<double>& field() const { return field_; }
    /// Of receivers of light, whose kinds are numbered by ReceiverRows.
    const FactorField<double>& light() const { return light_; }
    const PixelWindow& pixels() const { return pixels_; }

  private:
    static std::size_t cellsOf(const PixelWindow& pixels) {
        return static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
    }
    void addReceivers(const FactorKind& kind, double weight, const FactorSamples::Place& at) {
        exchange_->forEachReceiver(
            at.triangle, at.u, at.v, [&](std::uint32_t receiver, float part) {
                const int number = receivers_.numberOf(kind.row, exchange_->localOf(receiver));
                *light_.at(cell_, light_.kindOf({kind.front, number})) +=
                    weight * part_ * static_cast<double>(part);
            });
    }
    void addTo(const FactorKind& kind, double weight, const float* factors, double coverage = 1.0) {
        const std::size_t place =
            static_cast<std::size_t>(kind.front) * rows_ + static_cast<std::size_t>(kind.row);
        if (place >= numbers_.size())
            numbers_.resize((static_cast<std::size_t>(kind.front) + 1) * rows_, -1);
        int& number = numbers_[place];
        if (number < 0)
            number = field_.kindOf(kind);
        double* sums = field_.at(cell_, number);
        const double own = weight * part_;
        sums[0] += coverage * own;
        for (std::size_t f = 0; f < factorCount_; ++f)
            sums[1 + f] += own * static_cast<double>(factors[f]);
    }

    std::size_t rows_;
    const SurfaceRows& surfaces_;
    PixelWindow pixels_;
    std::size_t factorCount_;
    const LightExchange* exchange_;
    const ReceiverRows& receivers_;
    double share_;
    FactorField<double> field_; // float would round thousands of samples of a pixel
    FactorField<double> light_;
    std::vector<int> numbers_; // of the field, by front and row
    double part_ = 0.0;
    std::size_t cell_ = 0;
};

} // namespace irsg

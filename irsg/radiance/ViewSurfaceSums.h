#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "irsg/geometry/view/FrameBackground.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/radiance/GasSums.h"
#include "irsg/radiance/GeometryBuffer.h"
#include "irsg/radiance/LayerWalk.h"
#include "irsg/radiance/SeenReceivers.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/radiance/ViewGeometry.h"
#include "irsg/radiance/exchange/ReceiverSums.h"

namespace irsg {

/// Sums of a part of a view's samples by kind, as ViewLayout has them, for `Factors` drawn factors.
/// Every layer of every sample comes here: sums are dense, and their number is known when this is
/// compiled.
template <std::size_t Factors>
class ViewSurfaceSums {
  public:
    /// A sample counts with those that it stands for.
    static constexpr bool isByPixel = false;
    /// All must live as long. `share`: a sample's part of a pixel.
    ViewSurfaceSums(const SurfaceRows& rows, const PixelGrid& grid,
                    const std::vector<const FrameBackground*>& varying,
                    const LightExchange* exchange, double share)
        : rows_(static_cast<std::size_t>(rows.size())),
          surfaces_(rows),
          grid_(grid),
          varying_(varying),
          received_(exchange),
          share_(share),
          behind_W_m2_sr_(varying.size()) {}

    /// Samples that are added now lie in a pixel and count with `weight`.
    void goTo(int x, int y, double weight) {
        endRun();
        const PixelGrid::Pixel pixel = pixelAt(x, y);
        const double part = weight * share_, omega_sr = pixel.solidAngle_sr * part;
        sample_ = whole_ = {part, omega_sr, omega_sr * pixel.cosOffAxis};
        for (std::size_t k = 0; k < varying_.size(); ++k)
            behind_W_m2_sr_[k] = varying_[k]->at(x, y);
    }

    /// The same as others, times a factor.
    void goTo(const ViewSurfaceSums& others, double factor) {
        endRun();
        sample_ = whole_ = others.whole_.times(factor);
        behind_W_m2_sr_ = others.behind_W_m2_sr_;
    }

    /// Samples that are added now count so much beside others of their pixel.
    void setShare(const PixelGrid::Share& share) {
        endRun();
        sample_ = whole_.times(share);
    }

    [[gnu::always_inline]] void add(int stack, const SurfaceRows::Between& between,
                                    const GeometrySamples::Layer& layer) {
        const std::size_t place = placeOf(stack, between.row);
        const float* factors = layer.factors.data();
        const auto coverage = static_cast<double>(layer.coverage);
        addReceived(place, between, layer);
        addToRun(place, static_cast<double>(between.next), coverage, factors,
                 std::make_index_sequence<Factors>());
    }

    /// Factors of what is covered already, and what lobes have for coverage.
    void addLight(int stack, const SurfaceRows::Between& between,
                  const GeometrySamples::Layer& layer) {
        const std::size_t place = placeOf(stack, between.row);
        const auto coverage = static_cast<double>(layer.coverage);
        const auto addTo = [&](std::size_t to, double weight) {
            Sums& sums = sums_[slotOf(to)];
            sums.plain[0] += weight * sample_.omega_sr * coverage;
            sums.cosine[0] += weight * sample_.projected_sr * coverage;
            for (std::size_t f = 0; f < Factors; ++f) {
                const auto factor = static_cast<double>(layer.factors[f]);
                sums.plain[1 + f] += weight * sample_.omega_sr * factor;
                sums.cosine[1 + f] += weight * sample_.projected_sr * factor;
            }
            if (layer.place && layer.place->cell != GeometrySamples::Place::none)
                addReceivers(to, weight * coverage, *layer.place);
        };
        addTo(place, 1.0 - static_cast<double>(between.next));
        if (between.next > 0.0f)
            addTo(place + 1, static_cast<double>(between.next));
    }

    /// What is received of other surfaces, of layers whose coverage is visited apart.
    void addReceived(int stack, const SurfaceRows::Between& between,
                     const GeometrySamples::Layer& layer) {
        addReceived(placeOf(stack, between.row), between, layer);
    }

    /// What lobes mirror of the air, which is divided among its places once all is added.
    void addSpecular(int stack, const GeometrySamples& samples, const GeometrySamples::Layer& layer,
                     const GeometrySamples::Specular& mirror) {
        const SurfaceRows::Between between = surfaces_.at(mirror.row, layer.distance_m);
        const SpecularEnvironmentTable& table = *samples.specularTables[mirror.table];
        const float* scales = &samples.specularScales[mirror.scales];
        const auto addTo = [&](int row, double weight) {
            Speculars& mirrors = specularsOf(stack, row, samples, mirror);
            for (std::size_t n = 0; n < mirror.nodes.size(); ++n) {
                double* sums = mirrors.of(mirror.nodes[n], 2 * table.components);
                const double ofNode = weight * static_cast<double>(mirror.weights[n]);
                for (std::size_t k = 0; k < table.components; ++k) {
                    const double own = ofNode * static_cast<double>(scales[k]);
                    sums[2 * k] += own * sample_.omega_sr;
                    sums[2 * k + 1] += own * sample_.projected_sr;
                }
            }
        };
        addTo(between.row, 1.0 - static_cast<double>(between.next));
        if (between.next > 0.0f)
            addTo(between.row + 1, static_cast<double>(between.next));
    }
    /// What gas emits, which is divided among its columns once all is added.
    void addGas(int stack, const SurfaceRows::Between& between, const GasWalk::Emission& gas) {
        gas_.add(stack, between, gas);
    }
    /// Divides it.
    void finishGas(LayerWalk& walk) {
        endRun();
        const std::vector<GasSums::Place>& places = gas_.places();
        for (std::size_t number = 0; number < ofGas_.size(); ++number) {
            const int row = places[number].row;
            const auto divide = [&](std::size_t part, const auto& addTo) {
                const std::size_t width = places[number].values.size();
                walk.forEachColumn(
                    places[number].stack, places[number],
                    std::span(ofGas_[number]).subspan(part * width, width),
                    [&](int stack, double weight) { addTo(slotOf(placeOf(stack, row)), weight); });
            };
            divide(0, [&](std::size_t slot, double sum) {
                for (double& plain : sums_[slot].plain)
                    plain += sum;
            });
            divide(1, [&](std::size_t slot, double sum) {
                for (double& cosine : sums_[slot].cosine)
                    cosine += sum;
            });
            divide(2, [&](std::size_t slot, double sum) { sums_[slot].pixels += sum; });
            for (std::size_t k = 0; k < 2 * varying_.size(); ++k)
                divide(3 + k, [&](std::size_t slot, double sum) {
                    behind_W_m2_[2 * slot * varying_.size() + k] += sum;
                });
        }
        ofGas_.clear();
    }
    /// Divides it; nothing but light is added afterwards.
    void finish() {
        endRun();
        for (const auto& [key, mirrors] : mirrors_) {
            const auto& [stack, row, number] = key;
            const std::shared_ptr<const SpecularEnvironmentTable>& table = mirrors.table;
            const std::size_t first = placeOf(stack, row);
            std::array<double, 2>* const sums = specularFrom(
                first, table->valuesOfNode(), static_cast<std::size_t>(mirrors.rowsOfPlace));
            // In an order that what was seen before does not change.
            std::vector<std::uint32_t> nodes = mirrors.nodes;
            std::ranges::sort(nodes, {}, [&](std::uint32_t node) { return table->keys[node]; });
            for (const std::uint32_t node : nodes)
                for (std::size_t k = 0; k < table->components; ++k) {
                    const double* seen = mirrors.sumsOf(node, 2 * table->components) + 2 * k;
                    if (seen[0] == 0.0)
                        continue;
                    const float* shares = table->of(node);
                    for (std::size_t i = k * table->places; i < (k + 1) * table->places; ++i) {
                        sums[i][0] += static_cast<double>(shares[i]) * seen[0];
                        sums[i][1] += static_cast<double>(shares[i]) * seen[1];
                    }
                }
        }
        mirrors_.clear();
        lastSpeculars_ = nullptr;
        findPlaces();
    }

    /// Ends the run of receivers; no sample comes after it.
    void finishLight() { light_ = received_.take(); }
    /// Adds what was seen of receivers of light, finished, times a sign; see addTo.
    template <typename StackOf>
    void addLightTo(LightSums& light, StackOf stackOf, double sign) const {
        for (const std::size_t place : places_) {
            const auto slot = static_cast<std::size_t>(slots_[place]);
            if (slots_[place] == none || slot >= light_.size() || light_[slot].isEmpty())
                continue;
            const SurfaceStackId kind = kindOf(place, stackOf);
            light[{kind.stack, kind.row}].addScaled(light_[slot], sign);
        }
    }

    /// Adds what was seen times a sign to the one cell of a field. `stackOf(front)` is the number
    /// there of one here.
    template <typename StackOf>
    void addTo(GeometryBuffer<double>& field, const ViewLayout& layout, StackOf stackOf,
               double sign) const {
        for (const std::size_t place : places_) {
            if (slots_[place] != none)
                addSumsTo(field, layout, kindOf(place, stackOf),
                          static_cast<std::size_t>(slots_[place]), sign);
            if (place >= specularSlots_.size() || specularSlots_[place] == none)
                continue;
            const auto& [plain, cosine] =
                specular_[static_cast<std::size_t>(specularSlots_[place])];
            if (plain == 0.0)
                continue;
            double* numbers = field.at(0, field.kindOf(kindOf(place, stackOf)));
            numbers[layout.coverage()] += sign * plain;
            numbers[layout.withCosine(layout.coverage())] += sign * cosine;
        }
    }

  private:
    static constexpr std::int32_t none = -1;
    /// What a sample counts: of the pixel, in solid angle and in that times cosine.
    struct SampleMeasure {
        double part = 0.0, omega_sr = 0.0, projected_sr = 0.0;

        SampleMeasure times(double factor) const { return times({factor, factor}); }
        SampleMeasure times(const PixelGrid::Share& share) const {
            return {share.solidAngle * part, share.solidAngle * omega_sr,
                    share.projected * projected_sr};
        }
    };
    using Numbers = std::array<double, Factors + 1>;
    /// Coverage and factors, times solid angle and times projected solid angle, sr.
    struct Sums {
        Numbers plain{}, cosine{};
        double pixels = 0.0;
    };

    /// Rows of samples go through the same pixels again and again.
    PixelGrid::Pixel pixelAt(int x, int y) {
        if (x < 0)
            return grid_.at(x, y);
        if (y != y_) {
            y_ = y;
            pixels_.assign(pixels_.size(), {});
        }
        const auto place = static_cast<std::size_t>(x);
        if (place >= pixels_.size())
            pixels_.resize(place + 1);
        PixelGrid::Pixel& pixel = pixels_[place];
        if (pixel.solidAngle_sr == 0.0)
            pixel = grid_.at(x, y);
        return pixel;
    }

    /// Coverage and factors of the samples of one pixel, whose solid angle is that of all: without
    /// and with the weights of the row behind. Aligned, so that what was stored in pairs is read
    /// in the same ones: processors wait for others.
    struct alignas(32) OfRun {
        Numbers all{}, next{};
        std::size_t place = 0;
    };

    /// Of a front and a row, for which there is a place from now on, and for the rows behind it.
    [[gnu::always_inline]] std::size_t placeOf(int stack, int row) {
        const std::size_t place =
            static_cast<std::size_t>(stack) * rows_ + static_cast<std::size_t>(row);
        if (place >= slots_.size())
            growTo(stack);
        return place;
    }
    [[gnu::noinline]] void growTo(int stack) {
        slots_.resize((static_cast<std::size_t>(stack) + 1) * rows_, none);
    }
    template <typename StackOf>
    SurfaceStackId kindOf(std::size_t place, StackOf stackOf) const {
        return {stackOf(static_cast<int>(place / rows_)), static_cast<int>(place % rows_)};
    }
    /// Where the sums of a place are: few of them are seen in a part of a view, of lobes above all.
    [[gnu::always_inline]] std::size_t slotOf(std::size_t place) {
        const std::int32_t slot = slots_[place];
        return slot != none ? static_cast<std::size_t>(slot) : newSlotOf(place);
    }
    [[gnu::noinline]] std::size_t newSlotOf(std::size_t place) {
        slots_[place] = static_cast<std::int32_t>(sums_.size());
        sums_.emplace_back();
        ofRun_.emplace_back().place = place;
        behind_W_m2_.resize(2 * sums_.size() * varying_.size());
        return sums_.size() - 1;
    }

    /// Those that were seen, of thousands that there are, so that none of the others is asked.
    void findPlaces() {
        places_.clear();
        for (const OfRun& run : ofRun_)
            places_.push_back(run.place);
        places_.insert(places_.end(), specularPlaces_.begin(), specularPlaces_.end());
        std::ranges::sort(places_);
        const auto twice = std::ranges::unique(places_);
        places_.erase(twice.begin(), twice.end());
    }

    void addSumsTo(GeometryBuffer<double>& field, const ViewLayout& layout,
                   const SurfaceStackId& kind, std::size_t slot, double sign) const {
        const Sums& sums = sums_[slot];
        if (std::ranges::all_of(sums.plain, [](double sum) { return sum == 0.0; }))
            return;
        double* numbers = field.at(0, field.kindOf(kind));
        for (std::size_t i = 0; i <= Factors; ++i) {
            numbers[i] += sign * sums.plain[i];
            numbers[layout.withCosine(i)] += sign * sums.cosine[i];
        }
        numbers[layout.pixels()] += sign * sums.pixels;
        for (std::size_t k = 0; k < varying_.size(); ++k) {
            const double* behind_W_m2 = &behind_W_m2_[2 * (slot * varying_.size() + k)];
            numbers[layout.background(k)] += sign * behind_W_m2[0];
            numbers[layout.backgroundCosine(k)] += sign * behind_W_m2[1];
        }
    }

    /// Each number in a register of its own: an array would go through memory twice, in pieces of
    /// different sizes, for which processors wait.
    template <std::size_t... I>
    [[gnu::always_inline]] void addToRun(std::size_t place, double next, double coverage,
                                         const float* factors, std::index_sequence<I...>) {
        const std::size_t slot = slotOf(place);
        OfRun& run = ofRun_[slot];
        if (run.all[0] == 0.0)
            noteSeen(slot);
        run.all[0] += coverage;
        ((run.all[1 + I] += static_cast<double>(factors[I])), ...);
        if (next == 0.0)
            return;
        run.next[0] += next * coverage;
        ((run.next[1 + I] += next * static_cast<double>(factors[I])), ...);
    }
    [[gnu::noinline]] void noteSeen(std::size_t slot) { seen_.push_back(slot); }
    /// Adds what was seen in the pixel to the sums.
    void endRun() {
        for (const std::size_t slot : seen_) {
            const OfRun run = ofRun_[slot];
            ofRun_[slot].all.fill(0.0);
            ofRun_[slot].next.fill(0.0);
            Numbers here;
            for (std::size_t i = 0; i <= Factors; ++i)
                here[i] = run.all[i] - run.next[i];
            addPixel(slot, here);
            if (run.next[0] != 0.0) // weights of columns of gas may be below 0
                addPixel(slotOf(run.place + 1), run.next);
        }
        seen_.clear();
        gas_.take([&](std::size_t number, const GasSums::Place& place) { addGas(number, place); });
    }
    /// Adds what gas emits in the pixel to its sums.
    void addGas(std::size_t number, const GasSums::Place& place) {
        const std::size_t width = place.values.size();
        if (number >= ofGas_.size())
            ofGas_.resize(number + 1);
        ofGas_[number].resize((3 + 2 * varying_.size()) * width);
        double* sums = ofGas_[number].data();
        const auto add = [&](double scale) {
            for (std::size_t i = 0; i < width; ++i)
                sums[i] += scale * place.values[i];
            sums += width;
        };
        add(sample_.omega_sr);
        add(sample_.projected_sr);
        add(sample_.part);
        for (const double behind : behind_W_m2_sr_) {
            add(sample_.omega_sr * behind);
            add(sample_.projected_sr * behind);
        }
    }
    void addPixel(std::size_t slot, const Numbers& samples) {
        Sums& sums = sums_[slot];
        for (std::size_t i = 0; i <= Factors; ++i) {
            sums.plain[i] += sample_.omega_sr * samples[i];
            sums.cosine[i] += sample_.projected_sr * samples[i];
        }
        sums.pixels += sample_.part * samples[0];
        for (std::size_t k = 0; k < behind_W_m2_sr_.size(); ++k) {
            double* behind_W_m2 = &behind_W_m2_[2 * (slot * behind_W_m2_sr_.size() + k)];
            behind_W_m2[0] += sample_.omega_sr * samples[0] * behind_W_m2_sr_[k];
            behind_W_m2[1] += sample_.projected_sr * samples[0] * behind_W_m2_sr_[k];
        }
    }

    [[gnu::always_inline]] void addReceived(std::size_t place, const SurfaceRows::Between& between,
                                            const GeometrySamples::Layer& layer) {
        if (!layer.place || layer.place->cell == GeometrySamples::Place::none)
            return;
        const auto coverage = static_cast<double>(layer.coverage);
        addReceivers(place, coverage * (1.0 - static_cast<double>(between.next)), *layer.place);
        if (between.next > 0.0f)
            addReceivers(place + 1, coverage * static_cast<double>(between.next), *layer.place);
    }
    void addReceivers(std::size_t place, double weight, const GeometrySamples::Place& at) {
        received_.add(slotOf(place), place % rows_, weight * sample_.omega_sr,
                      weight * sample_.projected_sr, at);
    }

    /// Of the nodes of a table that were seen, by component, and without and with cosine: a table
    /// has those of all frames, of which a part of a view sees few.
    struct Speculars {
        std::shared_ptr<const SpecularEnvironmentTable> table;
        int rowsOfPlace = 1;
        std::vector<std::uint32_t> nodes;
        std::vector<std::int32_t> numbers; // by node: place in the list
        std::vector<double> sums;          // by that

        const double* sumsOf(std::uint32_t node, std::size_t width) const {
            return &sums[static_cast<std::size_t>(numbers[node]) * width];
        }
        double* of(std::uint32_t node, std::size_t width) {
            if (node >= numbers.size())
                numbers.resize(std::max<std::size_t>(node + 1, table->keys.size()), none);
            std::int32_t& number = numbers[node];
            if (number == none) {
                number = static_cast<std::int32_t>(nodes.size());
                nodes.push_back(node);
                sums.resize(sums.size() + width);
            }
            return &sums[static_cast<std::size_t>(number) * width];
        }
    };
    using SpecularKey = std::tuple<int, int, std::uint32_t>; // front, row of the first place, table
    Speculars& specularsOf(int stack, int row, const GeometrySamples& samples,
                           const GeometrySamples::Specular& mirror) {
        const SpecularKey key{stack, row, mirror.table};
        if (lastSpeculars_ == nullptr || key != lastKey_) {
            lastKey_ = key;
            lastSpeculars_ = &mirrors_[key];
            lastSpeculars_->table = samples.specularTables[mirror.table];
            lastSpeculars_->rowsOfPlace =
                surfaces_.first(mirror.row + 1) - surfaces_.first(mirror.row);
        }
        return *lastSpeculars_;
    }
    /// The sums of what is mirrored in so many places from one on, one behind the other.
    std::array<double, 2>* specularFrom(std::size_t place, std::size_t count, std::size_t step) {
        specularSlots_.resize(slots_.size(), none);
        if (specularSlots_[place] == none)
            for (std::size_t i = 0; i < count; ++i) {
                specularSlots_[place + i * step] = static_cast<std::int32_t>(specular_.size());
                specular_.emplace_back();
                specularPlaces_.push_back(place + i * step);
            }
        return &specular_[static_cast<std::size_t>(specularSlots_[place])];
    }

    std::size_t rows_;
    const SurfaceRows& surfaces_;
    const PixelGrid& grid_;
    const std::vector<const FrameBackground*>& varying_;
    SeenReceivers received_;
    std::vector<ReceiverSums> light_; // by slot, of what is finished
    int y_ = -1;
    std::vector<PixelGrid::Pixel> pixels_; // of that row, by x; no solid angle: not known yet
    double share_;
    SampleMeasure whole_;                // of a sample of its pixel, on the mean of all
    SampleMeasure sample_;               // of those that are added
    std::vector<double> behind_W_m2_sr_; // by varying background
    std::vector<std::int32_t> slots_, specularSlots_; // by place: front, then row
    std::vector<std::size_t> places_;         // that were seen, in their order, once all is added
    std::vector<std::size_t> specularPlaces_; // by slot of a mirror
    std::vector<Sums> sums_;                  // by slot
    std::vector<OfRun> ofRun_;                // likewise
    std::vector<std::size_t> seen_;           // slots, since the pixel was gone to
    GasSums gas_;                             // likewise
    /// By number of their places: times solid angle, projected solid angle and part of a pixel, and
    /// times both angles by varying background.
    std::vector<std::vector<double>> ofGas_;
    std::vector<std::array<double, 2>> specular_; // by slot of a mirror: without and with cosine
    std::map<SpecularKey, Speculars> mirrors_;
    SpecularKey lastKey_{};
    Speculars* lastSpeculars_ = nullptr;
    std::vector<double> behind_W_m2_; // by slot and background: without and with cosine
};

} // namespace irsg

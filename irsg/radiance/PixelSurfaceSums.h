#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "irsg/geometry/view/ImageRectangle.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/radiance/GasSums.h"
#include "irsg/radiance/GeometryBuffer.h"
#include "irsg/radiance/LayerWalk.h"
#include "irsg/radiance/SurfaceRows.h"
#include "irsg/radiance/exchange/SceneLight.h"

namespace irsg {

/// Sums of a part of a view's samples by pixel and kind: coverage and factors as parts of a pixel.
/// Takes what ViewSurfaceSums takes.
class PixelSurfaceSums {
  public:
    /// A sample counts in its own pixel, also where another stands for it.
    static constexpr bool isByPixel = true;
    /// `walk`: through the samples of the part. `pixels`: those of the part. `share`: a sample's
    /// part of a pixel.
    PixelSurfaceSums(const SurfaceRows& rows, LayerWalk& walk, const PixelRegion& pixels,
                     std::size_t factorCount, const LightExchange* exchange,
                     const ReceiverRows& receivers, double share)
        : rows_(static_cast<std::size_t>(rows.size())),
          surfaces_(rows),
          walk_(walk),
          pixels_(pixels),
          factorCount_(factorCount),
          exchange_(exchange),
          receivers_(receivers),
          share_(share),
          field_(cellsOf(pixels), factorCount + 1),
          light_(exchange ? cellsOf(pixels) : 0, 1) {}

    void goTo(int x, int y, double weight) {
        endGas();
        part_ = weight * share_;
        cell_ = static_cast<std::size_t>(y - pixels_.y) * static_cast<std::size_t>(pixels_.width) +
                static_cast<std::size_t>(x - pixels_.x);
    }

    /// Samples that are added now count so much beside others of their pixel.
    void setShare(const PixelGrid::Share& share) { ofSample_ = share.solidAngle; }

    void add(int stack, const SurfaceRows::Between& between, const GeometrySamples::Layer& layer) {
        const float* factors = layer.factors.data();
        const auto next = static_cast<double>(between.next);
        const auto coverage = static_cast<double>(layer.coverage);
        addTo({stack, between.row}, 1.0 - next, factors, coverage);
        if (next > 0.0)
            addTo({stack, between.row + 1}, next, factors, coverage);
        addReceived(stack, between, layer);
    }

    /// What is received of other surfaces, of layers whose coverage is visited apart.
    void addReceived(int stack, const SurfaceRows::Between& between,
                     const GeometrySamples::Layer& layer) {
        if (!layer.place || layer.place->cell == GeometrySamples::Place::none)
            return;
        const auto next = static_cast<double>(between.next);
        const auto coverage = static_cast<double>(layer.coverage);
        addReceivers({stack, between.row}, coverage * (1.0 - next), *layer.place);
        if (next > 0.0)
            addReceivers({stack, between.row + 1}, coverage * next, *layer.place);
    }

    void addLight(int stack, const SurfaceRows::Between& between,
                  const GeometrySamples::Layer& layer) {
        const auto next = static_cast<double>(between.next);
        const auto coverage = static_cast<double>(layer.coverage);
        const auto addTo = [&](int row, double weight) {
            this->addTo({stack, row}, weight, layer.factors.data(), coverage);
            if (layer.place && layer.place->cell != GeometrySamples::Place::none)
                addReceivers({stack, row}, weight * coverage, *layer.place);
        };
        addTo(between.row, 1.0 - next);
        if (next > 0.0)
            addTo(between.row + 1, next);
    }

    void addSpecular(int stack, const GeometrySamples& samples, const GeometrySamples::Layer& layer,
                     const GeometrySamples::Specular& mirror) {
        static constexpr std::array<float, mostFactors> none{};
        LayerWalk::forEachShare(samples, mirror, [&](std::size_t place, float coverage) {
            const SurfaceRows::Between between =
                surfaces_.at(mirror.row + static_cast<int>(place), layer.distance_m);
            const auto next = static_cast<double>(between.next);
            addTo({stack, between.row}, 1.0 - next, none.data(), static_cast<double>(coverage));
            if (next > 0.0)
                addTo({stack, between.row + 1}, next, none.data(), static_cast<double>(coverage));
        });
    }
    /// What gas emits is divided among its columns pixel by pixel.
    void addGas(int stack, const SurfaceRows::Between& between, const GasWalk::Emission& gas) {
        gas_.add(stack, between, gas, ofSample_);
    }
    void finishGas(LayerWalk&) { endGas(); }
    void finish() {}

    const GeometryBuffer<double>& field() const { return field_; }
    /// Of receivers of light, whose kinds are numbered by ReceiverRows.
    const GeometryBuffer<double>& light() const { return light_; }
    const PixelRegion& pixels() const { return pixels_; }

  private:
    static std::size_t cellsOf(const PixelRegion& pixels) {
        return static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
    }
    void endGas() {
        ofSample_ = 1.0; // which its sums hold already
        constexpr std::array<float, mostFactors> ones = [] {
            std::array<float, mostFactors> all{};
            all.fill(1.0f);
            return all;
        }();
        gas_.take([&](std::size_t, const GasSums::Place& place) {
            walk_.forEachColumn(place.stack, place, [&](int stack, double weight) {
                addTo({stack, place.row}, weight, ones.data());
            });
        });
    }
    void addReceivers(const SurfaceStackId& kind, double weight, const GeometrySamples::Place& at) {
        if (exchange_ == nullptr) // of coverage alone
            return;
        exchange_->forEachReceiver(at.cell, at.u, at.v, [&](std::uint32_t receiver, float part) {
            const int number = receivers_.numberOf(kind.row, exchange_->localOf(receiver));
            *light_.at(cell_, light_.kindOf({kind.stack, number})) +=
                weight * part_ * ofSample_ * static_cast<double>(part);
        });
    }
    void addTo(const SurfaceStackId& kind, double weight, const float* factors,
               double coverage = 1.0) {
        const std::size_t place =
            static_cast<std::size_t>(kind.stack) * rows_ + static_cast<std::size_t>(kind.row);
        if (place >= numbers_.size())
            numbers_.resize((static_cast<std::size_t>(kind.stack) + 1) * rows_, -1);
        int& number = numbers_[place];
        if (number < 0)
            number = field_.kindOf(kind);
        double* sums = field_.at(cell_, number);
        const double own = weight * part_ * ofSample_;
        sums[0] += coverage * own;
        for (std::size_t f = 0; f < factorCount_; ++f)
            sums[1 + f] += own * static_cast<double>(factors[f]);
    }

    std::size_t rows_;
    const SurfaceRows& surfaces_;
    LayerWalk& walk_;
    PixelRegion pixels_;
    std::size_t factorCount_;
    const LightExchange* exchange_;
    const ReceiverRows& receivers_;
    double share_;
    GeometryBuffer<double> field_; // float would round thousands of samples of a pixel
    GeometryBuffer<double> light_;
    std::vector<int> numbers_;           // of the field, by front and row
    GasSums gas_;                        // since the pixel was gone to
    double part_ = 0.0, ofSample_ = 1.0; ///< of a sample on the mean; beside that
    std::size_t cell_ = 0;
};

} // namespace irsg

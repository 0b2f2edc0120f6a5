#include "irsg/scene/radiance/ViewFactors.h"

#include <algorithm>
#include <array>
#include <memory>

#include "irsg/radiometry/ParallelFor.h"

namespace irsg {

namespace {

/// Pieces that the rows of a window are divided into, whatever the number of cores.
constexpr std::size_t parts = 8;

} // namespace

FactorSums::FactorSums(const Sensor& sensor, const SurfaceRows& rows, Fronts& fronts,
                       std::size_t factorCount, std::vector<const FrameBackground*> varying)
    : width_px_(sensor.width_px),
      height_px_(sensor.height_px),
      grid_(sensor),
      rows_(rows),
      fronts_(fronts),
      layout_{factorCount, varying.size()},
      varying_(std::move(varying)) {}

ViewFactors FactorSums::emptyView() const {
    return {layout_, FactorField<double>(1, layout_.width()), 0};
}

FactorField<float> FactorSums::emptyPixels() const {
    return {static_cast<std::size_t>(width_px_) * static_cast<std::size_t>(height_px_),
            layout_.factorCount + 1};
}

template <typename Real, typename Weigh>
void FactorSums::add(const SampleWindow& window, const FactorSamples& samples, bool byPixel,
                     FactorField<Real>& into, Weigh weigh) {
    struct Part {
        std::unique_ptr<LayerWalk> walk;
        FactorField<Real> field;
    };
    std::array<Part, parts> all;
    const PixelWindow pixels = window.pixels();
    const auto width = static_cast<std::size_t>(pixels.width);
    const auto rows = static_cast<std::size_t>(window.height());
    const auto pixelRow = [&](std::size_t row) {
        return static_cast<std::size_t>(
            static_cast<int>((window.tileY + static_cast<int>(row) / window.samplesDown) >>
                             window.level) -
            pixels.y);
    };
    std::array<std::size_t, parts> firstPixelRow{};
    parallelFor(parts, [&](std::size_t p) {
        const std::size_t begin = beginOfPart(p, parts, rows),
                          end = beginOfPart(p + 1, parts, rows);
        if (begin == end)
            return;
        Part& part = all[p];
        part.walk = std::make_unique<LayerWalk>(rows_);
        firstPixelRow[p] = pixelRow(begin);
        const std::size_t pixelRows = pixelRow(end - 1) - firstPixelRow[p] + 1;
        part.field = FactorField<Real>(byPixel ? width * pixelRows : 1, into.width());
        RunSums sums(rows_, *part.walk, layout_.factorCount);
        sums.add(window, samples, static_cast<int>(begin), static_cast<int>(end),
                 [&](int x, int y, double weight, const FactorKind& kind, const double* run) {
                     const std::size_t cell =
                         byPixel
                             ? (static_cast<std::size_t>(y - pixels.y) - firstPixelRow[p]) * width +
                                   static_cast<std::size_t>(x - pixels.x)
                             : 0;
                     weigh(x, y, weight, run, part.field.at(cell, part.field.kindOf(kind)));
                 });
    });
    for (std::size_t p = 0; p < parts; ++p) {
        if (!all[p].walk)
            continue;
        const Fronts& own = all[p].walk->fronts();
        std::vector<int> fronts;
        for (std::size_t front = 0; front < own.size(); ++front)
            fronts.push_back(fronts_.numberOf(own.materials(static_cast<int>(front))));
        into.add(
            all[p].field,
            [&](std::size_t cell) {
                if (!byPixel)
                    return std::size_t{0};
                const std::size_t y =
                    static_cast<std::size_t>(pixels.y) + firstPixelRow[p] + cell / width;
                return y * static_cast<std::size_t>(width_px_) +
                       static_cast<std::size_t>(pixels.x) + cell % width;
            },
            [&](int front) { return fronts[static_cast<std::size_t>(front)]; });
    }
}

void FactorSums::addToView(const SampleWindow& window, const FactorSamples& samples,
                           ViewFactors& view) {
    view.layersLeftOver += samples.layersLeftOver;
    const double share = window.share();
    const std::size_t count = layout_.factorCount + 1;
    add(window, samples, false, view.field,
        [&](int x, int y, double weight, const double* run, double* sums) {
            const PixelGrid::Pixel pixel = grid_.at(x, y);
            const double part = weight * share;
            const double omega_sr = pixel.solidAngle_sr * part;
            for (std::size_t i = 0; i < count; ++i) {
                const double sum_sr = omega_sr * run[i];
                sums[i] += sum_sr;
                sums[layout_.withCosine(i)] += sum_sr * pixel.cosOffAxis;
            }
            sums[layout_.pixels()] += part * run[0];
            for (std::size_t k = 0; k < varying_.size(); ++k) {
                const double behind_W_m2 = omega_sr * run[0] * varying_[k]->at(x, y);
                sums[layout_.background(k)] += behind_W_m2;
                sums[layout_.backgroundCosine(k)] += behind_W_m2 * pixel.cosOffAxis;
            }
        });
}

void FactorSums::addToPixels(const SampleWindow& window, const FactorSamples& samples,
                             FactorField<float>& pixels) {
    const double share = window.share();
    const std::size_t count = layout_.factorCount + 1;
    add(window, samples, true, pixels,
        [&](int, int, double weight, const double* run, float* sums) {
            for (std::size_t i = 0; i < count; ++i)
                sums[i] += static_cast<float>(weight * share * run[i]);
        });
}

void addPointToView(const FactorField<double>& atUnitDistance_sr_m2, const SurfaceRows& rows,
                    const PointPlace& place, const std::vector<const FrameBackground*>& varying,
                    ViewFactors& view) {
    const double scale = 1.0 / (place.distance_m * place.distance_m);
    const ViewLayout& layout = view.layout;
    atUnitDistance_sr_m2.forEach(0, [&](std::size_t number, std::span<const double> source) {
        const FactorKind& drawn = atUnitDistance_sr_m2.kinds()[number];
        double* sums = view.field.at(0, view.field.kindOf({drawn.front, rows.first(drawn.row)}));
        for (std::size_t i = 0; i <= layout.factorCount; ++i) {
            sums[i] += scale * source[i];
            sums[layout.withCosine(i)] += scale * source[i] * place.cosOffAxis;
        }
        const double coverage_sr = scale * source[0];
        sums[layout.pixels()] += coverage_sr / place.solidAngle_sr;
        for (std::size_t k = 0; k < varying.size(); ++k) {
            const double behind_W_m2 = coverage_sr * varying[k]->at(place.x, place.y);
            sums[layout.background(k)] += behind_W_m2;
            sums[layout.backgroundCosine(k)] += behind_W_m2 * place.cosOffAxis;
        }
    });
}

} // namespace irsg

#include "irsg/radiance/ViewGeometry.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/radiance/LayerWalk.h"
#include "irsg/radiance/PixelSurfaceSums.h"
#include "irsg/radiance/SublatticeDifferences.h"
#include "irsg/radiance/ViewSurfaceSums.h"
#include "irsg/render/sampling/JoinedSamples.h"
#include "irsg/render/sampling/OffAxisShares.h"

namespace irsg {

namespace {

/// Parts whose contrasts are kept apart: what edges far from each other do is not lost between
/// them.
constexpr std::size_t sublatticeStrips = 4;

/// Adds the samples of some rows of a tile, counted from the top, to sums of theirs.
template <typename Sums>
void addRows(const SampleTile& tile, const PixelGrid& grid, const GeometrySamples& samples,
             std::size_t firstRow, std::size_t lastRow, LayerWalk& walk, Sums& sums) {
    const OffAxisShares shares(tile, grid);
    tile.forEachRun(
        static_cast<int>(firstRow), static_cast<int>(lastRow),
        [&](std::size_t first, int count, int x, int y, double weight) {
            const std::size_t last = first + static_cast<std::size_t>(count);
            const auto isLeftOut = [&](std::size_t i) {
                return samples.isEmpty(i) && !(Sums::isByPixel && samples.isOfAnother(i));
            };
            while (first < last && isLeftOut(first))
                ++first;
            if (first == last)
                return;
            sums.goTo(x, y, weight);
            const bool areUnequal = shares.areUnequalIn(x, y);
            for (std::size_t i = first; i < last; ++i) {
                if (isLeftOut(i))
                    continue;
                const bool isOfGroup = !Sums::isByPixel && samples.standsForGroup(i);
                if constexpr (requires { sums.at(i, isOfGroup); })
                    sums.at(i, isOfGroup);
                else if (isOfGroup)
                    sums.goTo(x, y, GeometrySamples::samplesOfGroup * weight);
                if (areUnequal)
                    sums.setShare(shares.of(i, x, y, isOfGroup));
                walk.forEachPlace(
                    samples, samples.standingFor(i, tile.stride()),
                    [&](int stack, const SurfaceRows::Between& between,
                        const GeometrySamples::Layer& layer) __attribute__((always_inline)) {
                        if (layer.coverage != 0.0f && !layer.isLobe)
                            sums.add(stack, between, layer);
                        else
                            sums.addLight(stack, between, layer);
                    },
                    [&](int stack, const SurfaceRows::Between& between,
                        const GeometrySamples::Layer& layer) {
                        sums.addReceived(stack, between, layer);
                    },
                    [&](int stack, const GeometrySamples::Layer& layer,
                        const GeometrySamples::Specular& mirror) {
                        sums.addSpecular(stack, samples, layer, mirror);
                    },
                    [&](int stack, const SurfaceRows::Between& between,
                        const GasWalk::Emission& gas) { sums.addGas(stack, between, gas); });
                if constexpr (!requires { sums.at(i, isOfGroup); })
                    if (isOfGroup)
                        sums.goTo(x, y, weight);
            }
        });
    sums.finishGas(walk);
    sums.finish();
}

/// Samples of a tile, which may share the drawing, that have more layers than are kept.
int layersLeftOver(const SampleTile& tile, const GeometrySamples& samples) {
    int count = 0;
    if (samples.layersLeftOver > 0)
        tile.forEachRun([&](std::size_t first, int length, int, int, double) {
            for (std::size_t i = first; i < first + static_cast<std::size_t>(length); ++i)
                count += samples.isLeftOver(i);
        });
    return count;
}

/// The numbers that a walk's fronts have in a common list.
std::vector<int> numbersOf(const OccluderStacks& own, OccluderStacks& common) {
    std::vector<int> numbers;
    for (std::size_t stack = 0; stack < own.size(); ++stack)
        numbers.push_back(common.numberOf(own.materials(static_cast<int>(stack))));
    return numbers;
}

} // namespace

GeometrySums::GeometrySums(const Sensor& sensor, const SurfaceRows& rows,
                           OccluderStacks& occluderStacks, std::size_t factorCount,
                           std::vector<const FrameBackground*> varying,
                           std::shared_ptr<const LightExchange> exchange,
                           bool withSublatticeDifferences)
    : width_px_(sensor.width_px),
      height_px_(sensor.height_px),
      grid_(sensor),
      rows_(rows),
      occluderStacks_(occluderStacks),
      layout_{factorCount, varying.size()},
      varying_(std::move(varying)),
      exchange_(std::move(exchange)),
      withSublatticeDifferences_(withSublatticeDifferences) {}

ViewGeometry GeometrySums::emptyView() const {
    const ViewGeometry empty{layout_, GeometryBuffer<double>(1, layout_.width()), {}, 0, {}};
    ViewGeometry view = empty;
    if (withSublatticeDifferences_)
        view.sublatticeDifferences.assign(sublatticeStrips * sublatticeDifferenceKinds + 1, empty);
    return view;
}

PixelGeometry GeometrySums::emptyPixels() const {
    const std::size_t pixels =
        static_cast<std::size_t>(width_px_) * static_cast<std::size_t>(height_px_);
    return {GeometryBuffer<float>(pixels, layout_.factorCount + 1),
            GeometryBuffer<float>(exchange_ ? pixels : 0, 1),
            exchange_ ? ReceiverRows(rows_, *exchange_) : ReceiverRows()};
}

template <std::size_t Factors>
void GeometrySums::addGeometryToView(const SampleTile& tile, const GeometrySamples& samples,
                                     ViewGeometry& view) {
    const auto rows = static_cast<std::size_t>(tile.height());
    std::vector<LayerWalk> walks(partsOfTile, LayerWalk(rows_));
    const ViewSurfaceSums<Factors> none(rows_, grid_, varying_, exchange_.get(), tile.share());
    std::array<std::optional<ViewSurfaceSums<Factors>>, partsOfTile> sums;
    std::array<std::optional<SublatticeDifferences<Factors>>, partsOfTile> sublatticeDifferences;
    parallelFor(partsOfTile, [&](std::size_t p) {
        const std::size_t begin = beginOfPart(p, partsOfTile, rows),
                          end = beginOfPart(p + 1, partsOfTile, rows);
        const auto addTo = [&](auto& own) {
            addRows(tile, grid_, samples, begin, end, walks[p], own);
            own.finishLight();
        };
        if (withSublatticeDifferences_)
            addTo(sublatticeDifferences[p].emplace(tile, begin, end, none));
        else
            addTo(sums[p].emplace(none));
    });
    for (std::size_t p = 0; p < partsOfTile; ++p) {
        const std::vector<int> occluderStacks =
            numbersOf(walks[p].occluderStacks(), occluderStacks_);
        const auto addTo = [&](ViewGeometry& to) {
            return [&](const ViewSurfaceSums<Factors>& own, double sign) {
                const auto stackOf = [&](int stack) {
                    return occluderStacks[static_cast<std::size_t>(stack)];
                };
                own.addTo(to.field, layout_, stackOf, sign);
                own.addLightTo(to.light, stackOf, sign);
            };
        };
        if (!withSublatticeDifferences_) {
            addTo(view)(*sums[p], 1.0);
            continue;
        }
        sublatticeDifferences[p]->forEachOfSum(addTo(view));
        for (std::size_t k = 0; k < sublatticeDifferenceKinds; ++k)
            sublatticeDifferences[p]->forEachOf(
                static_cast<SublatticeDifference>(k),
                addTo(
                    view.sublatticeDifferences[sublatticeDifferenceKinds * (p % sublatticeStrips) +
                                               k]));
    }
}

void GeometrySums::addToView(const SampleTile& tile, const GeometrySamples& samples,
                             ViewGeometry& view) {
    view.layersLeftOver += layersLeftOver(tile, samples);
    const auto addFor = [&]<std::size_t... I>(std::index_sequence<I...>) {
        ((layout_.factorCount == I + 1 ? addGeometryToView<I + 1>(tile, samples, view) : void()),
         ...);
    };
    addFor(std::make_index_sequence<mostFactors>());
}

void GeometrySums::addToPixels(const SampleTile& tile, const GeometrySamples& samples,
                               PixelGeometry& pixels) {
    const auto rows = static_cast<std::size_t>(tile.height());
    std::vector<LayerWalk> walks(partsOfTile, LayerWalk(rows_));
    std::array<std::optional<PixelSurfaceSums>, partsOfTile> sums;
    parallelFor(partsOfTile, [&](std::size_t p) {
        const std::size_t begin = beginOfPart(p, partsOfTile, rows),
                          end = beginOfPart(p + 1, partsOfTile, rows);
        if (begin == end)
            return;
        const auto pixelRow = [&](std::size_t row) {
            return static_cast<int>((tile.blockY + static_cast<int>(row) / tile.samplesDown) >>
                                    tile.level);
        };
        PixelRegion own = tile.pixels();
        own.y = pixelRow(begin);
        own.height = pixelRow(end - 1) - own.y + 1;
        sums[p].emplace(rows_, walks[p], own, layout_.factorCount, exchange_.get(),
                        pixels.receivers, tile.share());
        addRows(tile, grid_, samples, begin, end, walks[p], *sums[p]);
    });
    for (std::size_t p = 0; p < partsOfTile; ++p) {
        if (!sums[p])
            continue;
        const std::vector<int> occluderStacks =
            numbersOf(walks[p].occluderStacks(), occluderStacks_);
        const PixelRegion& own = sums[p]->pixels();
        const auto width = static_cast<std::size_t>(own.width);
        const auto cellOf = [&](std::size_t cell) {
            return (static_cast<std::size_t>(own.y) + cell / width) *
                       static_cast<std::size_t>(width_px_) +
                   static_cast<std::size_t>(own.x) + cell % width;
        };
        const auto stackOf = [&](int stack) {
            return occluderStacks[static_cast<std::size_t>(stack)];
        };
        pixels.field.add(sums[p]->field(), cellOf, stackOf);
        pixels.light.add(sums[p]->light(), cellOf, stackOf);
    }
}

void addPointToView(const PointGeometry& atUnitDistance, const SurfaceRows& rows,
                    const PointPlace& place, const std::vector<const FrameBackground*>& varying,
                    ViewGeometry& view) {
    const double scale = 1.0 / (place.distance_m * place.distance_m);
    const ViewLayout& layout = view.layout;
    LightSums light;
    for (const auto& [kind, sums] : atUnitDistance.light_sr_m2) {
        std::vector<ReceiverSums::Entry> entries = sums.entries();
        for (ReceiverSums::Entry& entry : entries)
            entry.weights[1] = entry.weights[0] * place.cosOffAxis;
        light[{kind.first, rows.first(kind.second)}] = ReceiverSums(std::move(entries));
    }
    addLight(light, scale, view.light);
    const GeometryBuffer<double>& field = atUnitDistance.sums_sr_m2;
    field.forEach(0, [&](std::size_t number, std::span<const double> source) {
        const SurfaceStackId& drawn = field.kinds()[number];
        double* sums = view.field.at(0, view.field.kindOf({drawn.stack, rows.first(drawn.row)}));
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
    for (std::size_t k = 0; k < std::min(view.sublatticeDifferences.size(),
                                         atUnitDistance.sublatticeDifferences.size());
         ++k)
        addPointToView(atUnitDistance.sublatticeDifferences[k], rows, place, varying,
                       view.sublatticeDifferences[k]);
}

} // namespace irsg

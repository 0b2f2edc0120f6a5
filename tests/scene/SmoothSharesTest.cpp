#include "irsg/render/sampling/SmoothShares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "irsg/render/sampling/PixelAlignedStrategy.h"

using namespace irsg;

namespace {

/// Shares of the samples of a tile that is drawn alone.
GeometrySamples sharesOf(const SampleTile& tile) {
    const SampleSheet sheet = SampleSheet::of(tile);
    GeometrySamples samples;
    samples.opaque.resize(4 * static_cast<std::size_t>(sheet.width) *
                          static_cast<std::size_t>(sheet.height));
    shareOutGas(sheet, samples);
    return samples;
}

/// Calls visit(index, column, row, x, y, weight) for the samples of a tile.
template <typename Visit>
void forEachSample(const SampleTile& tile, const Visit& visit) {
    tile.forEachRun([&](std::size_t first, int count, int x, int y, double weight) {
        const std::size_t drawn = first - tile.firstSample;
        const int row = tile.height() - 1 - static_cast<int>(drawn / tile.stride());
        for (int s = 0; s < count; ++s) {
            visit(first + static_cast<std::size_t>(s), static_cast<int>(drawn % tile.stride()) + s,
                  row, x, y, weight);
        }
    });
}

/// A level or upright object, 60 by 25 pixels, with a detail in it that is drawn apart.
struct Cut {
    bool isUpright = false;
    double place = 0.5, detail_px = 1.0;

    double along() const { return 28.9; }
    double middle() const { return 7.3 + 25.0 * place; }
    std::vector<SampleTile> tiles() const {
        ImageRectangle whole{4.9, 7.3, 64.9, 32.3};
        ImageRectangle detail{along(), middle() - 0.5 * detail_px, along() + 1.7 * detail_px,
                              middle() + 0.5 * detail_px};
        if (isUpright) {
            whole = {whole.top, whole.left, whole.bottom, whole.right};
            detail = {detail.top, detail.left, detail.bottom, detail.right};
        }
        ObjectExtent object{0, whole, {}, 1.0};
        object.details = {detail};
        return PixelAlignedStrategy(160).tiles({object});
    }
};

std::vector<Cut> cuts() {
    std::vector<Cut> all;
    for (const bool isUpright : {false, true}) {
        for (const double place : {0.31, 0.5, 0.62}) {
            for (const double detail_px : {0.8, 2.3, 6.1}) {
                all.push_back({isUpright, place, detail_px});
            }
        }
    }
    return all;
}

} // namespace

TEST(SmoothShares, SumWhatShinesAcrossTheBordersOfDetails) {
    // A plume that begins in the detail and goes on beyond it, a few rows wide.
    constexpr double sigma_px = 1.0, length_px = 8.0;
    double worstAlike = 0.0;
    for (const Cut& cut : cuts()) {
        const double rise_px = 1.7 * cut.detail_px;
        const auto radiance = [&](double x, double y) {
            if (cut.isUpright) {
                std::swap(x, y);
            }
            const double beyond_px = std::max(x - cut.along() - rise_px, 0.0);
            const double risen = std::clamp((x - cut.along()) / rise_px, 0.0, 1.0);
            return std::pow(std::sin(0.5 * std::numbers::pi * risen), 2) *
                   std::exp(-0.5 * std::pow(beyond_px / length_px, 2) -
                            0.5 * std::pow((y - cut.middle()) / sigma_px, 2));
        };
        const std::vector<SampleTile> tiles = cut.tiles();
        ASSERT_GE(tiles.size(), 2u);
        double sum = 0.0, sumAlike = 0.0;
        for (const SampleTile& tile : tiles) {
            const GeometrySamples samples = sharesOf(tile);
            forEachSample(tile, [&](std::size_t i, int column, int row, int, int, double weight) {
                const auto [x, y] = tile.placeOf(column, row);
                const double own = weight * tile.share() * radiance(x, y);
                sumAlike += own;
                sum += samples.gasShare(i) * own;
            });
        }
        const double across_px = std::sqrt(2.0 * std::numbers::pi) * sigma_px;
        const double truth =
            across_px * (0.5 * rise_px + std::sqrt(0.5 * std::numbers::pi) * length_px);
        EXPECT_NEAR(sum / truth, 1.0, 1.5e-3)
            << (cut.isUpright ? "upright, " : "level, ") << cut.place << ", " << cut.detail_px;
        worstAlike = std::max(worstAlike, std::abs(sumAlike / truth - 1.0));
    }
    EXPECT_GT(worstAlike, 4e-3); // what this is for
}

TEST(SmoothShares, KeepTheAreaOfPixels) {
    for (const Cut& cut : cuts()) {
        std::map<std::pair<int, int>, double> alike, shared;
        for (const SampleTile& tile : cut.tiles()) {
            const GeometrySamples samples = sharesOf(tile);
            forEachSample(tile, [&](std::size_t i, int, int, int x, int y, double weight) {
                EXPECT_GE(samples.gasShare(i), -1.0);
                EXPECT_LE(samples.gasShare(i), 5.0); // three of a row and three of a column
                alike[{x, y}] += weight * tile.share();
                shared[{x, y}] += weight * tile.share() * samples.gasShare(i);
            });
        }
        for (const auto& [pixel, area] : alike) {
            EXPECT_NEAR(shared[pixel], area, 1e-6) << pixel.first << ", " << pixel.second;
        }
    }
}

TEST(SmoothShares, AreNoneWhereATileIsWhole) {
    ObjectExtent object{0, {4.9, 7.3, 64.9, 32.3}, {}, 1.0};
    SampleTile tile = PixelAlignedStrategy(96).tiles({object}).front();
    tile.only.reset();
    EXPECT_TRUE(sharesOf(tile).gasShares.empty());
}

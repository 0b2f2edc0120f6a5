#include "irsg/render/sampling/SampleLattice.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"
#include "irsg/render/sampling/PixelAlignedStrategy.h"

using namespace irsg;

namespace {

/// A rectangle, turned.
struct Bar {
    double angle_rad;
    double long_px = 14.3, short_px = 3.1;

    std::vector<ImageEdge> edges() const {
        const double c = std::cos(angle_rad), s = std::sin(angle_rad);
        const ImageEdge along{long_px * c, long_px * s}, across{-short_px * s, short_px * c};
        return {along, across, along, across};
    }
    bool holds(double right_px, double down_px) const {
        const double c = std::cos(angle_rad), s = std::sin(angle_rad);
        return std::abs(c * right_px + s * down_px) < 0.5 * long_px &&
               std::abs(c * down_px - s * right_px) < 0.5 * short_px;
    }
};

SampleTile sampleTileOf(int across, int down, int shearRows, int fall = 0) {
    SampleTile tile;
    tile.blocksWide = tile.blocksHigh = 20;
    tile.samplesAcross = across;
    tile.samplesDown = down;
    tile.shearRows = shearRows;
    tile.fall = fall;
    return tile;
}

/// Of the area that the samples of a tile find, counted one by one at many phases.
double countedVariance_px4(const SampleTile& tile, const Bar& bar) {
    constexpr int phases = 30;
    const double wide_px = tile.cellWidth_px(), high_px = tile.cellHeight_px();
    double squares = 0.0;
    for (int i = 0; i < phases; ++i) {
        const double right_px = 10.0 + std::fmod(i * 0.7548776662, 1.0) * wide_px;
        const double down_px = 10.0 + std::fmod(i * 0.5698402910, 1.0) * high_px;
        int inside = 0;
        tile.forEachRun([&](std::size_t first, int count, int, int, double) {
            const int drawn = static_cast<int>(first);
            const int row = tile.height() - 1 - drawn / tile.width();
            for (int s = 0; s < count; ++s) {
                const int place = drawn % tile.width() + s;
                const double column = place + 0.5 - tile.shift(row);
                inside += bar.holds(column * wide_px - right_px,
                                    (row + 0.5 + tile.drop(place)) * high_px - down_px);
            }
        });
        const double error = inside * wide_px * high_px - bar.long_px * bar.short_px;
        squares += error * error;
    }
    return squares / phases;
}

TEST(SampleLattice, KnowsTheErrorThatCountingFinds) {
    for (const SampleTile& tile : {sampleTileOf(10, 16, 26), sampleTileOf(8, 12, 24),
                                   sampleTileOf(10, 16, 26, 1), sampleTileOf(8, 12, 24, -1)}) {
        double counted = 0.0, computed = 0.0;
        for (double angle_deg = 2.5; angle_deg < 180.0; angle_deg += 5.0) {
            // Equal edges add up or cancel, as far apart as they are.
            double found = 0.0, said = 0.0;
            for (const double apart_px : {2.83, 3.01, 3.14, 3.37}) {
                const Bar bar{radians(angle_deg), 14.3, apart_px};
                found += countedVariance_px4(tile, bar);
                said += varianceOfEdges_px4(tile, bar.edges());
            }
            if (found > 1.6e-3) { // 0.05 % of the area
                EXPECT_NEAR(std::log2(said / found), 0.0, 2.0) << angle_deg;
            }
            counted += found;
            computed += said;
        }
        EXPECT_NEAR(computed / counted, 1.0, 0.3);
    }
}

TEST(SampleLattice, HasOthersNearItOfWhichOneSuitsAnyEdge) {
    const SampleTile tile = sampleTileOf(10, 16, 26);
    const std::vector<SampleTile> lattices = latticesNear(tile, 256);
    EXPECT_EQ(lattices.front().shearRows, 26);
    for (const SampleTile& lattice : lattices) {
        EXPECT_GE(lattice.samplesAcross * lattice.samplesDown, 10 * 16);
        EXPECT_LE(lattice.samplesAcross * lattice.samplesDown * 20 * 20, 256 * 256);
        EXPECT_EQ(lattice.rectangle().right, tile.rectangle().right);
    }
    double worst = 0.0, worstOfBest = 0.0;
    for (double angle_deg = 5.0; angle_deg <= 85.0; angle_deg += 0.5) {
        const std::vector<ImageEdge> edges = Bar{radians(angle_deg)}.edges();
        double best = varianceOfEdges_px4(tile, edges);
        worst = std::max(worst, best);
        for (const SampleTile& lattice : lattices) {
            best = std::min(best, varianceOfEdges_px4(lattice, edges));
        }
        worstOfBest = std::max(worstOfBest, best);
    }
    EXPECT_LT(worstOfBest, worst / 16.0);
    EXPECT_EQ(varianceOfEdges_px4(tile, {{0.0, 0.0}}), 0.0);
}

TEST(SampleLattice, ThatIsTiltedDoesNotMeetALevelEdgeAlongItsRows) {
    const std::vector<ImageEdge> level = {{17.0, 0.0}, {-17.0, 0.0}};
    const double flat = varianceOfEdges_px4(sampleTileOf(10, 16, 26), level);
    for (const int fall : {1, -1}) {
        const SampleTile tile = sampleTileOf(10, 16, 26, fall);
        EXPECT_LT(varianceOfEdges_px4(tile, level), flat / 10.0);
        // A row's samples fall from end to end by one, each within its cell.
        EXPECT_NEAR(tile.drop(tile.width() - 0.5) - tile.drop(-0.5), fall, 1e-12);
        EXPECT_LT(std::abs(tile.drop(0)), 0.5);
        EXPECT_LT(std::abs(tile.drop(tile.width() - 1)), 0.5);
    }
    // Not all edges want the same: along tilted rows it is the other way round.
    const double slope = 1.0 / sampleTileOf(10, 16, 26).width() * 10.0 / 16.0;
    const std::vector<ImageEdge> along = {{17.0, 17.0 * slope}};
    EXPECT_GT(varianceOfEdges_px4(sampleTileOf(10, 16, 26, 1), along),
              10.0 * varianceOfEdges_px4(sampleTileOf(10, 16, 26), along));
}

TEST(SampleLattice, CountsEqualEdgesOnce) {
    const std::vector<ImageEdge> edges = {{3.0, 1.0}, {-3.0, -1.0}, {3.001, 1.001}, {1.0, 3.0}};
    const SampleTile tile = sampleTileOf(10, 16, 26);
    const std::vector<ImageEdge> counted = withEqualsCounted(edges, tile);
    ASSERT_EQ(counted.size(), 2u);
    EXPECT_EQ(counted.back().count, 3);
    const std::vector<ImageEdge> backwards =
        withEqualsCounted({edges.rbegin(), edges.rend()}, tile);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(backwards[i].right_px, counted[i].right_px);
        EXPECT_EQ(backwards[i].count, counted[i].count);
    }
    const double each = varianceOfEdges_px4(tile, edges);
    EXPECT_NEAR(varianceOfEdges_px4(tile, counted), each, 0.02 * each);
}

TEST(SampleLattice, OfATileIsTheOneForItsEdges) {
    ObjectExtent bar{.entity = 0, .extent = {2.2, 2.3, 17.1, 16.2}, .centre_m = {}};
    double before = 0.0, after = 0.0;
    for (double angle_deg = 5.0; angle_deg <= 85.0; angle_deg += 0.5) {
        const std::vector<ImageEdge> edges = Bar{radians(angle_deg)}.edges();
        const PixelAlignedStrategy strategy(256);
        bar.edges.clear();
        before = std::max(before, varianceOfEdges_px4(strategy.tiles({bar}).front(), edges));
        bar.edges = edges;
        after = std::max(after, varianceOfEdges_px4(strategy.tiles({bar}).front(), edges));
    }
    EXPECT_LT(after, before / 16.0);
}

} // namespace

// The upper and the lower edge of a wing go as far to the right, up to rounding: which of them
// comes first must not choose the lattice.
TEST(SampleLattice, TakesEdgesAsOneWhateverRoundingSays) {
    const SampleTile tile = sampleTileOf(4, 4, 16);
    const double little_px = 0.04 * tile.cellHeight_px();
    const auto edgeFor = [&](double error_px) {
        const std::vector<ImageEdge> different =
            withEqualsCounted({{9.0 + error_px, little_px}, {9.0 - error_px, -little_px}}, tile);
        EXPECT_EQ(different.size(), 1u);
        EXPECT_EQ(different.front().count, 2);
        return different.front();
    };
    for (const double error_px : {1e-12, -1e-12, 3e-11, -3e-11}) {
        EXPECT_NEAR(edgeFor(error_px).right_px, 9.0, 1e-9);
        EXPECT_NEAR(edgeFor(error_px).down_px, 0.0, 1e-9);
    }
}

// Tiles share drawings, and neither samples nor numbers know of it.
#include "irsg/render/sampling/SampleSheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "irsg/render/sampling/PixelAlignedStrategy.h"
#include "irsg/scene/InteractiveRenderer.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;

namespace {

SampleTile tile(int wide, int high, int shearRows = 0) {
    SampleTile made;
    made.blocksWide = wide;
    made.blocksHigh = high;
    made.samplesAcross = 2;
    made.samplesDown = 3;
    made.shearRows = shearRows;
    return made;
}

std::vector<SampleTile> someTiles(std::size_t count, int longest) {
    std::mt19937 random(11);
    std::vector<SampleTile> tiles;
    for (std::size_t i = 0; i < count; ++i) {
        const auto side = [&] { return 1 + static_cast<int>(random() % unsigned(longest)); };
        const int wide = side(), high = side();
        tiles.push_back(tile(wide, high, i % 2 ? 7 : 0));
    }
    return tiles;
}

} // namespace

TEST(SampleSheet, HoldsEverySampleOfEveryTileOnce) {
    constexpr int largestSide = 2048;
    const std::vector<SampleTile> tiles = someTiles(60, 150);
    const std::vector<SampleSheet> sheets = sheetsOf(tiles, largestSide);
    EXPECT_LT(sheets.size(), tiles.size() / 2);
    std::size_t number = 0;
    for (const SampleSheet& sheet : sheets) {
        EXPECT_LE(sheet.width, largestSide);
        EXPECT_LE(sheet.height, largestSide);
        std::vector<int> times(static_cast<std::size_t>(sheet.width) *
                               static_cast<std::size_t>(sheet.height));
        for (const SampleTile& placed : sheet.tiles) {
            ASSERT_LT(number, tiles.size());
            EXPECT_EQ(placed.blocksWide, tiles[number].blocksWide); // in their order
            EXPECT_EQ(placed.blocksHigh, tiles[number].blocksHigh);
            int counted = 0;
            placed.forEachRun([&](std::size_t first, int count, int, int, double) {
                ASSERT_LE(first % placed.stride() + static_cast<std::size_t>(count),
                          placed.stride());
                for (std::size_t i = first; i < first + static_cast<std::size_t>(count); ++i) {
                    ASSERT_EQ(++times.at(i), 1) << "window " << number;
                }
                counted += count;
            });
            EXPECT_EQ(counted, 6 * placed.blocksWide * placed.blocksHigh);
            ++number;
        }
    }
    EXPECT_EQ(number, tiles.size());
}

TEST(SampleSheet, LeavesALargeTileAlone) {
    const std::vector<SampleSheet> sheets =
        sheetsOf({tile(10, 10), tile(500, 500), tile(10, 10)}, 2048);
    ASSERT_EQ(sheets.size(), 3u);
    EXPECT_EQ(sheets[1].width, 1000);
    EXPECT_EQ(sheets[1].height, 1500);
    EXPECT_TRUE(sheetsOf({}, 2048).empty());
}

TEST(SampleSheet, IsNeverHigherThanADrawingMayBe) {
    // One wide tile and many high ones do not fit on shelves.
    std::vector<SampleTile> tiles{tile(50, 1)};
    for (int i = 0; i < 12; ++i) {
        tiles.push_back(tile(40, 40));
    }
    for (const SampleSheet& sheet : sheetsOf(tiles, 128)) {
        EXPECT_LE(sheet.width, 128);
        EXPECT_LE(sheet.height, 128);
    }
}

TEST(PixelAlignedStrategy, GivesEveryPixelOfAVeryLargeObjectFourSamples) {
    // Of pictures and sums alike, which so are one number.
    const ObjectExtent object{0, {0, 0, 800.0, 300.0}, {}, 1.0};
    double samples = 0.0;
    for (const SampleTile& one : PixelAlignedStrategy(256).tiles({object})) {
        samples += one.rectangle().width() * one.rectangle().height() / one.share();
    }
    EXPECT_EQ(samples, 4 * 800 * 300);
}

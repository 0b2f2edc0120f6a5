#include "irsg/render/sampling/SampleTile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "irsg/render/sampling/PixelAlignedStrategy.h"
#include "irsg/render/sampling/SupersamplingStrategy.h"

using namespace irsg;

namespace {

ObjectExtent object(int entity, double left, double top, double width, double height) {
    return {entity, {left, top, left + width, top + height}, {}, 1.0};
}

/// Area that the samples of tiles add to each pixel, px.
std::map<std::pair<int, int>, double> areas(const std::vector<SampleTile>& tiles) {
    std::map<std::pair<int, int>, double> area;
    for (const SampleTile& tile : tiles) {
        tile.forEachRun([&](std::size_t, int count, int x, int y, double weight) {
            area[{x, y}] += count * weight * tile.share();
        });
    }
    return area;
}

/// The tiles that draw a point of the image plane.
int drawnTimes(const std::vector<SampleTile>& tiles, double x, double y) {
    int times = 0;
    for (const SampleTile& tile : tiles) {
        const auto holds = [&](const ImageRectangle& r) {
            return x >= r.left && x < r.right && y >= r.top && y < r.bottom;
        };
        if (holds(tile.region()) && std::ranges::none_of(tile.leftOut, holds)) {
            ++times;
        }
    }
    return times;
}

} // namespace

TEST(SampleTile, GivesEverySampleToThePixelOfItsBlock) {
    SampleTile tile;
    tile.level = 2;
    tile.blockX = 4 * 10 + 3; // the last quarter of pixel 10
    tile.blockY = 4 * 7;
    tile.blocksWide = 2;
    tile.blocksHigh = 1;
    tile.samplesAcross = 3;
    tile.samplesDown = 2;
    EXPECT_EQ(tile.pixels(), (PixelRegion{10, 7, 2, 1}));
    EXPECT_DOUBLE_EQ(tile.rectangle().left, 10.75);
    EXPECT_DOUBLE_EQ(tile.rectangle().bottom, 7.25);

    std::set<std::size_t> seen;
    tile.forEachRun([&](std::size_t first, int count, int x, int y, double) {
        EXPECT_EQ(y, 7);
        for (int s = 0; s < count; ++s) {
            const std::size_t index = first + static_cast<std::size_t>(s);
            EXPECT_TRUE(seen.insert(index).second);
            EXPECT_EQ(x, index % 6 < 3 ? 10 : 11);
        }
    });
    EXPECT_EQ(seen.size(), 12u);
    const auto area = areas({tile});
    EXPECT_DOUBLE_EQ(area.at({10, 7}), 1.0 / 16.0);
}

TEST(SampleTile, ShearsItsRowsAndKeepsTheirSamplesInEveryBlock) {
    SampleTile tile;
    tile.blockX = 5;
    tile.blockY = 3;
    tile.blocksWide = 3;
    tile.blocksHigh = 4;
    tile.samplesAcross = tile.samplesDown = 5;
    tile.shearRows = 4;
    EXPECT_EQ(tile.width(), 15 + 5);
    for (const auto& [pixel, area] : areas({tile})) {
        EXPECT_DOUBLE_EQ(area, 1.0);
    }
    // The sample of column c stands at (c + 1/2 - shift) fifths of a pixel, inside its pixel.
    tile.forEachRun([&](std::size_t first, int count, int x, int y, double) {
        const int row = tile.height() - 1 - static_cast<int>(first) / tile.width();
        for (int s = 0; s < count; ++s) {
            const int column = static_cast<int>(first) % tile.width() + s;
            const double place = 5.0 + (column + 0.5 - tile.shift(row)) / 5.0;
            EXPECT_GE(place, x - 1e-12);
            EXPECT_LT(place, x + 1.0);
        }
        EXPECT_EQ(y, 3 + row / 5);
    });
}

TEST(SampleTile, IsTheSameInPieces) {
    SampleTile tile;
    tile.blockX = 5;
    tile.blockY = 3;
    tile.blocksWide = 7;
    tile.blocksHigh = 5;
    tile.samplesAcross = tile.samplesDown = 3;
    tile.leftOut = {{6.0, 4.0, 8.0, 5.0}};
    const std::vector<SampleTile> pieces = tile.pieces(7);
    EXPECT_EQ(pieces.size(), 12u);
    const auto whole = areas({tile}), cut = areas(pieces);
    ASSERT_EQ(whole.size(), 33u);
    EXPECT_EQ(whole.count({6, 4}), 0u);
    for (const auto& [pixel, area] : whole) {
        EXPECT_DOUBLE_EQ(cut.at(pixel), area);
    }
}

TEST(PixelAlignedStrategy, SpendsItsSamplesOnTheObjectHoweverSmall) {
    const PixelAlignedStrategy strategy(256);
    for (double size_px : {60.0, 3.0, 1.0, 0.7, 0.3, 0.01, 1e-3, 1e-6}) {
        const auto tiles = strategy.tiles({object(0, 100.3, 50.9, size_px, 0.5 * size_px)});
        // A large one may have two densities, one above the other.
        ASSERT_LE(tiles.size(), size_px > 50.0 ? 2u : 1u);
        int samples = 0;
        for (const SampleTile& tile : tiles) {
            EXPECT_GE(size_px * size_px / tile.share(), 180.0 * 180.0) << size_px << " px";
            EXPECT_GE(size_px * tile.density(), 150.0) << size_px << " px";
            samples += tile.width() * tile.height();
        }
        EXPECT_LE(samples, 256 * 256 * 1.1) << size_px << " px";
    }
}

TEST(PixelAlignedStrategy, KeepsTwoSamplesAnAxisAboveItsSize) {
    const auto tiles = PixelAlignedStrategy(128).tiles({object(0, 0, 0, 640, 512)});
    ASSERT_EQ(tiles.size(), 1u);
    EXPECT_EQ(tiles.front().samplesAcross, 2);
    EXPECT_EQ(tiles.front().pixels(), (PixelRegion{0, 0, 640, 512}));
}

TEST(PixelAlignedStrategy, SpendsEqualSamplesHoweverPixelsDivideItsSize) {
    // 2 x 2 samples in each of 113 pixels would leave a fifth of 256 x 256 unused.
    for (double size_px = 20.0; size_px < 125.0; size_px += 0.7) {
        const auto tiles = PixelAlignedStrategy(256).tiles({object(0, 10, 10, size_px, size_px)});
        double samples = 0.0;
        for (const SampleTile& tile : tiles) {
            samples += size_px * tile.rectangle().height() / tile.share();
        }
        EXPECT_NEAR(samples / (256.0 * 256.0), 0.93, 0.1) << size_px << " px";
        for (const auto& [pixel, area] : areas(tiles)) {
            ASSERT_NEAR(area, 1.0, 1e-12) << pixel.first << ", " << pixel.second;
        }
    }
}

TEST(PixelAlignedStrategy, SpendsItsSamplesWhateverTheShape) {
    // As long as no pixel needs more than two samples an axis, and no drawing more than 2048.
    for (const int size : {128, 256, 512}) {
        for (double long_px = 0.02; long_px < 0.35 * size; long_px *= 1.13) {
            for (const double slimness : {1.0, 2.0, 5.3, 21.0, 86.0, 300.0}) {
                for (const bool upright : {false, true}) {
                    const double short_px = long_px / slimness;
                    const auto tiles = PixelAlignedStrategy(size).tiles(
                        {upright ? object(0, 10.3, 10.7, short_px, long_px)
                                 : object(0, 10.3, 10.7, long_px, short_px)});
                    double counted = 0.0, drawn = 0.0;
                    for (const SampleTile& tile : tiles) {
                        counted +=
                            tile.rectangle().width() * tile.rectangle().height() / tile.share();
                        drawn += static_cast<double>(tile.width()) * tile.height();
                        EXPECT_LE(tile.pieces(2048).size(), 1u)
                            << size << ": " << long_px << " by " << short_px << upright;
                    }
                    const double budget = static_cast<double>(size) * size;
                    EXPECT_GE(counted, 0.8 * budget)
                        << size << ": " << long_px << " by " << short_px << upright;
                    EXPECT_LE(drawn, 1.2 * budget)
                        << size << ": " << long_px << " by " << short_px << upright;
                }
            }
        }
    }
}

TEST(PixelAlignedStrategy, SpendsItsSamplesSmoothlyAsAnExtentGrows) {
    // The samples that fall to an object 86 pixels long, as it becomes thicker by parts of a pixel.
    double before = 0.0;
    for (double short_px = 2.0; short_px < 12.0; short_px += 0.05) {
        const auto tiles = PixelAlignedStrategy(256).tiles({object(0, 10.3, 10.7, 86.0, short_px)});
        double on = 0.0;
        for (const SampleTile& tile : tiles) {
            on += tile.rectangle().intersectedWith({10.3, 10.7, 96.3, 10.7 + short_px}).height() *
                  86.0 / tile.share();
        }
        if (before > 0.0) {
            EXPECT_NEAR(on / before, 1.0, 0.25) << short_px;
        }
        EXPECT_GE(on, 0.6 * 256.0 * 256.0) << short_px;
        before = on;
    }
}

TEST(PixelAlignedStrategy, SharesTilesAmongDetailsWithoutEnd) {
    // Details all over an object, ever more of them: as many tiles as is sensible, no samples
    // beyond the budget, and every detail at least as fine as what is around it.
    for (const int count : {10, 100, 1000}) {
        ObjectExtent body = object(0, 20.0, 20.0, 90.0, 70.0);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> u(0.0, 1.0);
        for (int i = 0; i < count; ++i) {
            const double left = 20.0 + 89.5 * u(random), top = 20.0 + 69.5 * u(random);
            body.details.push_back({left, top, left + 0.3, top + 0.25});
        }
        const auto tiles = PixelAlignedStrategy(256).tiles({body});
        EXPECT_GE(tiles.size(), std::min<std::size_t>(static_cast<std::size_t>(count), 20u));
        EXPECT_LE(tiles.size(), 520u);
        double samples = 0.0;
        for (const SampleTile& tile : tiles) {
            samples += tile.width() * static_cast<double>(tile.height());
        }
        EXPECT_LE(samples, 4.0 * 256 * 256) << count;
        for (const auto& [pixel, area] : areas(tiles)) {
            ASSERT_NEAR(area, 1.0, 1e-9) << pixel.first << ", " << pixel.second;
        }
    }
}

TEST(PixelAlignedStrategy, DrawsObjectsThatDoNotOverlapApart) {
    const auto tiles =
        PixelAlignedStrategy(256).tiles({object(0, 10, 10, 5, 5), object(1, 15.5, 10, 5, 5)});
    ASSERT_EQ(tiles.size(), 2u);
    EXPECT_EQ(tiles[0].entities, std::vector<int>{0});
    EXPECT_EQ(tiles[1].entities, std::vector<int>{1});
}

TEST(PixelAlignedStrategy, DrawsAPointNearALargeObjectFinelyAndEveryPointOnce) {
    const std::vector<ObjectExtent> objects{
        object(0, 100.2, 80.7, 90, 40), object(1, 150.37, 99.61, 0.01, 0.02),
        object(2, 150.1, 99.2, 0.6, 0.6), object(3, 120.6, 90.4, 4.0, 3.0)};
    for (int size : {128, 256, 512}) {
        const auto tiles = PixelAlignedStrategy(size).tiles(objects);
        EXPECT_GT(tiles.size(), 3u);
        for (const SampleTile& tile : tiles) {
            EXPECT_EQ(tile.entities, (std::vector<int>{0, 1, 2, 3}));
        }

        // Over the point object the samples are dense; every point is drawn exactly once.
        double densest = 0.0;
        for (const SampleTile& tile : tiles) {
            if (tile.rectangle().intersects(objects[1].extent)) {
                densest = std::max(densest, tile.density());
            }
        }
        EXPECT_GE(densest * 0.02, size / 6.0);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> u(0.0, 1.0);
        for (const ObjectExtent& part : objects) {
            for (int i = 0; i < 4000; ++i) {
                EXPECT_EQ(drawnTimes(tiles, part.extent.left + u(random) * part.extent.width(),
                                     part.extent.top + u(random) * part.extent.height()),
                          1);
            }
        }
        // Samples fill the pixels as their areas do: no sample lies across a border.
        for (const auto& [pixel, area] : areas(tiles)) {
            EXPECT_NEAR(area, 1.0, 1e-12) << pixel.first << ", " << pixel.second;
        }
    }
}

TEST(PixelAlignedStrategy, CutsTilesForDetailsAndRendersEveryPointOnce) {
    ObjectExtent aircraft = object(0, 100.2, 80.7, 30.3, 12.1);
    aircraft.details = {{104.13, 85.2, 105.3, 86.4},
                        {104.9, 86.1, 106.2, 87.2}, // overlaps the first
                        {121.4, 84.9, 121.45, 84.92},
                        {129.9, 92.0, 130.5, 92.8}}; // at the object's corner
    for (int size : {128, 256, 512}) {
        const auto tiles = PixelAlignedStrategy(size).tiles({aircraft});
        ASSERT_GE(tiles.size(), 4u);
        for (const ImageRectangle& detail : aircraft.details) {
            double densest = 0.0;
            for (const SampleTile& tile : tiles) {
                if (tile.region().intersects(detail)) {
                    densest = std::max(densest, tile.density());
                }
            }
            EXPECT_GE(densest * detail.extent(), size / 8.0);
        }
        std::mt19937 random(11);
        std::uniform_real_distribution<double> u(0.0, 1.0);
        for (int i = 0; i < 20000; ++i) {
            EXPECT_EQ(drawnTimes(tiles, 100.2 + 30.3 * u(random), 80.7 + 12.1 * u(random)), 1);
        }
        for (const auto& [pixel, area] : areas(tiles)) {
            EXPECT_NEAR(area, 1.0, 1e-12) << pixel.first << ", " << pixel.second;
        }
    }
}

TEST(PixelAlignedStrategy, DoesNotMindTheOrderOfItsObjects) {
    // The first two overlap, and the rectangle around them reaches the third.
    std::vector<ObjectExtent> objects{object(0, 10, 10, 10, 2), object(1, 18, 11, 2, 10),
                                      object(2, 11, 15, 3, 3)};
    std::set<std::vector<double>> seen;
    std::ranges::sort(objects, {}, &ObjectExtent::entity);
    do {
        std::vector<double> numbers;
        for (const SampleTile& tile : PixelAlignedStrategy(256).tiles(objects)) {
            const ImageRectangle r = tile.region();
            numbers.insert(numbers.end(), {r.left, r.top, r.right, r.bottom, tile.density()});
        }
        seen.insert(numbers);
    } while (std::ranges::next_permutation(objects, {}, &ObjectExtent::entity).found);
    EXPECT_EQ(seen.size(), 1u);
}

TEST(SupersamplingStrategy, SamplesEveryPixelAlike) {
    const auto tiles =
        SupersamplingStrategy(2, 1).tiles({object(0, 10.2, 5.1, 3, 2), object(1, 11, 6, 9, 2)});
    ASSERT_EQ(tiles.size(), 1u);
    EXPECT_EQ(tiles.front().pixels(), (PixelRegion{10, 5, 10, 3}));
    EXPECT_EQ(tiles.front().width(), 20);
    EXPECT_EQ(tiles.front().height(), 3);
}

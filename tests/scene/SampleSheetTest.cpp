// Windows share drawings, and neither samples nor numbers know of it.
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

SampleWindow window(int wide, int high, int shearRows = 0) {
    SampleWindow made;
    made.tilesWide = wide;
    made.tilesHigh = high;
    made.samplesAcross = 2;
    made.samplesDown = 3;
    made.shearRows = shearRows;
    return made;
}

std::vector<SampleWindow> someWindows(std::size_t count, int longest) {
    std::mt19937 random(11);
    std::vector<SampleWindow> windows;
    for (std::size_t i = 0; i < count; ++i) {
        const auto side = [&] { return 1 + static_cast<int>(random() % unsigned(longest)); };
        const int wide = side(), high = side();
        windows.push_back(window(wide, high, i % 2 ? 7 : 0));
    }
    return windows;
}

} // namespace

TEST(SampleSheet, HoldsEverySampleOfEveryWindowOnce) {
    constexpr int largestSide = 2048;
    const std::vector<SampleWindow> windows = someWindows(60, 150);
    const std::vector<SampleSheet> sheets = sheetsOf(windows, largestSide);
    EXPECT_LT(sheets.size(), windows.size() / 2);
    std::size_t number = 0;
    for (const SampleSheet& sheet : sheets) {
        EXPECT_LE(sheet.width, largestSide);
        EXPECT_LE(sheet.height, largestSide);
        std::vector<int> times(static_cast<std::size_t>(sheet.width) *
                               static_cast<std::size_t>(sheet.height));
        for (const SampleWindow& placed : sheet.windows) {
            ASSERT_LT(number, windows.size());
            EXPECT_EQ(placed.tilesWide, windows[number].tilesWide); // in their order
            EXPECT_EQ(placed.tilesHigh, windows[number].tilesHigh);
            int counted = 0;
            placed.forEachRun([&](std::size_t first, int count, int, int, double) {
                ASSERT_LE(first % placed.stride() + static_cast<std::size_t>(count),
                          placed.stride());
                for (std::size_t i = first; i < first + static_cast<std::size_t>(count); ++i) {
                    ASSERT_EQ(++times.at(i), 1) << "window " << number;
                }
                counted += count;
            });
            EXPECT_EQ(counted, 6 * placed.tilesWide * placed.tilesHigh);
            ++number;
        }
    }
    EXPECT_EQ(number, windows.size());
}

TEST(SampleSheet, LeavesALargeWindowAlone) {
    const std::vector<SampleSheet> sheets =
        sheetsOf({window(10, 10), window(500, 500), window(10, 10)}, 2048);
    ASSERT_EQ(sheets.size(), 3u);
    EXPECT_EQ(sheets[1].width, 1000);
    EXPECT_EQ(sheets[1].height, 1500);
    EXPECT_TRUE(sheetsOf({}, 2048).empty());
}

TEST(SampleSheet, IsNeverHigherThanADrawingMayBe) {
    // One wide window and many high ones do not fit on shelves.
    std::vector<SampleWindow> windows{window(50, 1)};
    for (int i = 0; i < 12; ++i) {
        windows.push_back(window(40, 40));
    }
    for (const SampleSheet& sheet : sheetsOf(windows, 128)) {
        EXPECT_LE(sheet.width, 128);
        EXPECT_LE(sheet.height, 128);
    }
}

TEST(PixelAlignedStrategy, SpendsNoMoreOnTheSumOfAVeryLargeObjectThanItsPixels) {
    const auto samplesOf = [](double wide_px, double high_px, bool ofSums) {
        const ZoomEntityInfo object{0, {0, 0, wide_px, high_px}, {}, 1.0};
        const PixelAlignedStrategy strategy(256);
        double samples = 0.0;
        for (const SampleWindow& one :
             ofSums ? strategy.windowsOfSums({object}) : strategy.windows({object})) {
            samples += one.rectangle().width() * one.rectangle().height() / one.share();
        }
        return samples;
    };
    EXPECT_EQ(samplesOf(800, 300, false), 4 * 800 * 300);
    EXPECT_EQ(samplesOf(800, 300, true), 800 * 300);
    EXPECT_EQ(samplesOf(300, 150, true), 2 * 300 * 150); // 98,304 are enough, if they do
    // What takes no more than that is sampled as in a picture.
    for (const double side_px : {0.3, 7.0, 60.0, 128.0, 150.0}) {
        EXPECT_EQ(samplesOf(side_px, side_px, true), samplesOf(side_px, side_px, false)) << side_px;
    }
}

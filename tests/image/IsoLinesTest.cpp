#include "irsg/image/IsoLines.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace irsg {
namespace {

using testing::ElementsAre;

double lengthOf(const std::vector<IsoSegment>& segments) {
    double length = 0.0;
    for (const IsoSegment& part : segments) {
        length += std::hypot(part.toX - part.fromX, part.toY - part.fromY);
    }
    return length;
}

TEST(IsoLines, OfARampIsAStraightLine) {
    // x + 0.25 in 4 x 3 pixels: the level 1.5 is at x = 1.25 of the middles, 1.75 of the corner.
    std::vector<float> ramp;
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            ramp.push_back(static_cast<float>(x) + 0.25F);
        }
    }
    const auto segments = isoLines(ramp, 4, 3, 1.5);
    ASSERT_EQ(segments.size(), 2u);
    for (const IsoSegment& part : segments) {
        EXPECT_DOUBLE_EQ(part.fromX, 1.75);
        EXPECT_DOUBLE_EQ(part.toX, 1.75);
    }
    EXPECT_DOUBLE_EQ(lengthOf(segments), 2.0);
    EXPECT_TRUE(isoLines(ramp, 4, 3, 9.0).empty());
    EXPECT_TRUE(isoLines(ramp, 4, 3, -9.0).empty());
}

TEST(IsoLines, OfAConeAreCircles) {
    constexpr int side = 121;
    constexpr double middle = 60.5, radius = 47.3;
    std::vector<float> cone;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            cone.push_back(static_cast<float>(std::hypot(x + 0.5 - middle, y + 0.5 - middle)));
        }
    }
    const auto segments = isoLines(cone, side, side, radius);
    for (const IsoSegment& part : segments) {
        EXPECT_NEAR(std::hypot(part.fromX - middle, part.fromY - middle), radius, 0.005);
    }
    EXPECT_NEAR(lengthOf(segments), 2.0 * std::numbers::pi * radius, 0.1);
}

TEST(IsoLines, CutASaddleByTheMeanOfItsCorners) {
    // High at top left and bottom right; the mean is 0.5.
    const std::vector<float> saddle{1.0F, 0.0F, 0.0F, 1.0F};
    const auto below = isoLines(saddle, 2, 2, 0.4); // the middle is high: low corners are cut off
    ASSERT_EQ(below.size(), 2u);
    for (const IsoSegment& part : below) {
        const double x = 0.5 * (part.fromX + part.toX), y = 0.5 * (part.fromY + part.toY);
        EXPECT_GT(std::abs(x - y), 0.3) << "beside the top right or the bottom left corner";
    }
    for (const IsoSegment& part : isoLines(saddle, 2, 2, 0.6)) {
        const double x = 0.5 * (part.fromX + part.toX), y = 0.5 * (part.fromY + part.toY);
        EXPECT_LT(std::abs(x - y), 1e-9);
    }
}

TEST(IsoLines, AreNowhereBesideAPixelWithoutAValue) {
    std::vector<float> plane{0, 1, 2, 0, 1, 2, 0, 1, 2};
    plane[4] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(isoLines(plane, 3, 3, 0.5).empty());
    plane[4] = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(isoLines(plane, 3, 3, 0.5).empty());
    EXPECT_TRUE(isoLines({}, 0, 0, 1.0).empty());
    EXPECT_TRUE(isoLines(std::vector<float>{1.0F}, 1, 1, 1.0).empty());
    EXPECT_THROW(isoLines(plane, 2, 3, 0.5), LogicError);
}

TEST(IsoLines, RoundLevelsLieInsideTheInterval) {
    EXPECT_THAT(roundLevels(0.0, 10.0, 5), ElementsAre(0.0, 2.0, 4.0, 6.0, 8.0, 10.0));
    EXPECT_THAT(roundLevels(291.3, 318.9, 6), ElementsAre(295.0, 300.0, 305.0, 310.0, 315.0));
    EXPECT_THAT(roundLevels(-0.3, 0.3, 3),
                ElementsAre(testing::DoubleEq(-0.2), 0.0, testing::DoubleEq(0.2)));
    EXPECT_TRUE(roundLevels(1.0, 1.0).empty());
    EXPECT_TRUE(roundLevels(std::nan(""), 1.0).empty());
    EXPECT_LE(roundLevels(1e-9, 9.99e-9).size(), 8u);
}

} // namespace
} // namespace irsg

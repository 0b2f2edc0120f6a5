#include "irsg/image/DisplayLimits.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/image/AxisTicks.h"
#include "irsg/image/ColorMap.h"
#include "irsg/image/ImageStatistics.h"

namespace irsg {
namespace {

DisplayLimits of(ColorScale scale, double low, double high, const std::vector<float>& shown = {}) {
    return DisplayLimits{low, high}.with(scale, {shown});
}

TEST(ColorScale, HasTheNamesThatItIsFoundBy) {
    for (const std::string& name : colorScaleNames()) {
        EXPECT_EQ(nameOf(colorScaleNamed(name)), name);
    }
    try {
        colorScaleNamed("cubic");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("cubic"));
        EXPECT_THAT(error.what(), testing::HasSubstr("square-root"));
    }
}

TEST(ColorScale, FollowsItsFormula) {
    EXPECT_DOUBLE_EQ(of(ColorScale::linear, 2, 6).position(3), 0.25);
    EXPECT_DOUBLE_EQ(of(ColorScale::squareRoot, 2, 6).position(3), 0.5);
    // A thousandth and a hundredth of the way: ln 11 / ln 10001 and ln 101 / ln 10001.
    EXPECT_NEAR(of(ColorScale::logarithmic, -1, 9).position(-0.99), 0.260345, 1e-6);
    EXPECT_NEAR(of(ColorScale::logarithmic, -1, 9).position(-0.9), 0.501074, 1e-6);
}

TEST(ColorScale, GivesEveryColourToAsManyValues) {
    // The squares of 0 to 256, in any order, and 2.25 many times: half of the values lie below
    // 128^2.
    std::vector<float> values(5000, 2.25F);
    for (int i = 256; i >= 0; --i) {
        values.push_back(static_cast<float>(i * i));
    }
    const DisplayLimits limits = of(ColorScale::equalized, 0, 256 * 256, values);
    EXPECT_NEAR(limits.position(128 * 128), 0.5, 0.005);
    EXPECT_NEAR(limits.position(64 * 64), 0.25, 0.005);
    EXPECT_NEAR(limits.value(0.5), 128 * 128, 300);
}

TEST(ColorScale, RisesFromEndToEndAndTurnsBack) {
    const std::vector<float> values{1.0F, 1.5F, 1.5F, 2.0F, 7.0F, 300.0F, std::nanf(""), 900.0F};
    for (const std::string& name : colorScaleNames()) {
        const DisplayLimits limits = of(colorScaleNamed(name), 1.0, 500.0, values);
        EXPECT_EQ(limits.position(1.0), 0.0) << name;
        EXPECT_EQ(limits.position(500.0), 1.0) << name;
        EXPECT_EQ(limits.position(-1e30), 0.0) << name;
        EXPECT_EQ(limits.position(1e30), 1.0) << name;
        double before = -1.0;
        for (int i = 0; i <= 1000; ++i) {
            const double value = 1.0 + 0.499 * i;
            EXPECT_GT(limits.position(value), before) << name << " at " << value;
            before = limits.position(value);
            EXPECT_NEAR(limits.value(before), value, 1e-9 * 500.0) << name;
        }
    }
}

TEST(ColorScale, ByItselfLeavesColoursForWhatDoesNotGlow) {
    // A background, a skin of 200 values and one pipe, hotter and hotter.
    const auto chosenFor = [](float pipe) {
        std::vector<float> values(300, 1.0F);
        for (int i = 0; i < 200; ++i) {
            values.push_back(1.0F + 0.01F * static_cast<float>(i));
        }
        values.push_back(pipe);
        const DisplayLimits limits =
            limitsFor(ColorScale::automatic, values).with(ColorScale::automatic, {values});
        EXPECT_EQ(limits.high, pipe);
        // The skin has a fifth of the colours at least.
        EXPECT_GT(limits.position(3.0) - limits.position(1.0), 0.18) << pipe;
        return limits.scale;
    };
    EXPECT_EQ(chosenFor(4.0F), ColorScale::linear);
    EXPECT_EQ(chosenFor(40.0F), ColorScale::squareRoot);
    EXPECT_EQ(chosenFor(500.0F), ColorScale::logarithmic);
    // Nothing but a background, and nothing at all.
    EXPECT_EQ(DisplayLimits{}.with(ColorScale::automatic, {}).scale, ColorScale::linear);
}

TEST(ColorScale, IsLinearWhereNothingIsShown) {
    const DisplayLimits limits = of(ColorScale::equalized, 0.0, 10.0);
    EXPECT_DOUBLE_EQ(limits.position(2.5), 0.25);
    DisplayLimits bare{0.0, 10.0, ColorScale::equalized, {}};
    EXPECT_DOUBLE_EQ(bare.position(2.5), 0.25);
    EXPECT_DOUBLE_EQ(bare.value(0.25), 2.5);
}

TEST(ColorScale, ColoursWhatIsDimBesideWhatGlows) {
    const ColorMap& map = ColorMap::named("white-hot");
    // Skin at 1 and 2 beside a pipe at 1000: one byte apart on a straight line, many on the others.
    const auto apart = [&](ColorScale scale) {
        const DisplayLimits limits = of(scale, 0.0, 1000.0, {0.0F, 1.0F, 2.0F, 1000.0F});
        return map.color(2.0, limits).red - map.color(1.0, limits).red;
    };
    EXPECT_LE(apart(ColorScale::linear), 1);
    EXPECT_GE(apart(ColorScale::squareRoot), 3);
    EXPECT_GE(apart(ColorScale::logarithmic), 15);
    EXPECT_GE(apart(ColorScale::equalized), 80);
    // What is outside of the limits keeps its marks with another scale.
    DisplayLimits marking{.low = 0.0, .high = 1000.0, .marksOutside = true};
    marking = marking.with(ColorScale::logarithmic, {});
    EXPECT_EQ(map.color(1001.0, marking), map.above());
    EXPECT_EQ(map.color(-1.0, marking), map.below());
}

TEST(ColorScale, TicksAreRoundRiseAndLieApart) {
    for (const std::string& name : colorScaleNames()) {
        for (const double high : {2.0, 500.0, 3e7, 2e-5}) {
            const DisplayLimits limits =
                of(colorScaleNamed(name), 0.1 * high, high,
                   {static_cast<float>(0.2 * high), static_cast<float>(0.5 * high)});
            const AxisTicks ticks = axisTicks(limits, 8);
            ASSERT_GE(ticks.values.size(), 2u) << name << " to " << high;
            ASSERT_LE(ticks.values.size(), 8u);
            for (std::size_t i = 0; i < ticks.values.size(); ++i) {
                EXPECT_GE(ticks.values[i], limits.low);
                EXPECT_LE(ticks.values[i], limits.high);
                // The label says the value.
                EXPECT_NEAR(std::stod(ticks.labels[i]) * std::pow(10.0, ticks.exponent),
                            ticks.values[i], 1e-6 * high)
                    << name << " " << ticks.labels[i];
                if (i > 0) {
                    EXPECT_GT(limits.position(ticks.values[i]) -
                                  limits.position(ticks.values[i - 1]),
                              0.05);
                }
            }
        }
    }
}

} // namespace
} // namespace irsg

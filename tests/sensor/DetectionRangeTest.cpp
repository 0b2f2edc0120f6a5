#include "irsg/sensor/DetectionRange.h"

#include <cmath>
#include <cstddef>
#include <set>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

using Found = DetectionRange::Found;

/// The branch of Lambert's function that is positive for x > 0, by Newton's method.
double lambert(double x) {
    double w = std::log1p(x);
    for (int i = 0; i < 50; ++i) {
        w -= (w * std::exp(w) - x) / (std::exp(w) * (1.0 + w));
    }
    return w;
}

TEST(DetectionRange, InVacuumItIsTheRootOfIntensityOverNoise) {
    for (const double intensity : {1e-3, 20.0, 5e4}) {
        for (const double threshold : {1.0, 5.0, 12.0}) {
            const double nei = 3e-9;
            const auto ratio = [&](double r) { return intensity / (r * r) / nei; };
            const DetectionRange found =
                detectionRange(ratio, threshold, {.nearest_m = 10.0, .farthest_m = 1e8});
            EXPECT_EQ(found.found, Found::atRange);
            EXPECT_EQ(found.crossings, 1);
            EXPECT_NEAR(found.range_m / std::sqrt(intensity / (nei * threshold)), 1.0, 1e-6);
            EXPECT_NEAR(found.slope, -2.0, 1e-6);
        }
    }
}

TEST(DetectionRange, InAirOfBeersLawItIsLambertsFunction) {
    // exp(-k r) / r^2 = c has r = 2 W(k / (2 sqrt(c))) / k.
    for (const double k : {1e-6, 2e-4, 1e-3, 5e-2}) {
        const double intensity = 300.0, nei = 1e-9, threshold = 5.0;
        const auto ratio = [&](double r) { return intensity * std::exp(-k * r) / (r * r) / nei; };
        const DetectionRange found =
            detectionRange(ratio, threshold, {.nearest_m = 10.0, .farthest_m = 1e7});
        const double expected = 2.0 / k * lambert(0.5 * k / std::sqrt(nei * threshold / intensity));
        EXPECT_NEAR(found.range_m / expected, 1.0, 1e-6) << k;
        EXPECT_NEAR(found.slope, -2.0 - k * expected, 1e-3 * (2.0 + k * expected)) << k;
    }
}

TEST(DetectionRange, TheFarthestOfSeveralCrossingsCounts) {
    // A contrast that passes through zero at 3 km and comes back.
    const auto ratio = [](double r) { return std::abs(1.0 - r / 3000.0) * 1e8 / (r * r); };
    const DetectionRange found =
        detectionRange(ratio, 1.0, {.nearest_m = 100.0, .farthest_m = 1e6, .looksPerDecade = 200});
    EXPECT_EQ(found.crossings, 3);
    EXPECT_NEAR(ratio(found.range_m), 1.0, 1e-4);
    EXPECT_GT(found.range_m, 3000.0);
}

TEST(DetectionRange, AStepInTheRatioIsFound) {
    // Behind the horizon nothing is seen.
    const auto ratio = [](double r) { return r < 18123.0 ? 1e10 / (r * r) : 0.0; };
    const DetectionRange found = detectionRange(ratio, 1.0, {});
    EXPECT_EQ(found.found, Found::atRange);
    EXPECT_NEAR(found.range_m, 18123.0, 0.5);
}

TEST(DetectionRange, AllTargetsAreLookedAtAtRangesOfOneGrid) {
    std::set<double> ranges;
    std::size_t calls = 0;
    for (int target = 0; target < 200; ++target) {
        const double intensity = 100.0 * std::pow(1.01, target);
        std::set<double> own;
        const auto ratio = [&](double r) {
            ++calls;
            EXPECT_TRUE(own.insert(r).second) << "twice";
            ranges.insert(r);
            return intensity * std::exp(-2e-4 * r) / (r * r) / 1e-9;
        };
        const DetectionRange found = detectionRange(ratio, 5.0, {.looksPerDecade = 4});
        const double expected =
            2.0 / 2e-4 * lambert(0.5 * 2e-4 / std::sqrt(1e-9 * 5.0 / intensity));
        EXPECT_NEAR(found.range_m / expected, 1.0, 1e-6);
    }
    EXPECT_LT(ranges.size(), 120u);
    EXPECT_LT(calls / 200, 40u);
}

TEST(DetectionRange, NearRangesThatCostMoreAreLookedAtOnlyWhereNothingIsSeenBeyond) {
    const RangeLimits limits{.nearest_m = 100.0, .farthest_m = 1e6, .costlyBelow_m = 5000.0};
    for (const double intensity : {1e-3, 1e-1, 10.0}) { // seen as far as 100 m to 30 km
        double nearest_m = 1e9;
        const DetectionRange found = detectionRange(
            [&](double r) {
                nearest_m = std::min(nearest_m, r);
                return intensity / (r * r) / 1e-9;
            },
            1.1, limits);
        const double expected_m = std::sqrt(intensity / 1.1e-9);
        EXPECT_EQ(found.found, Found::atRange);
        EXPECT_NEAR(found.range_m / expected_m, 1.0, 1e-6);
        if (expected_m > 5000.0) {
            EXPECT_GE(nearest_m, 5000.0 * (1.0 - 1e-12));
        } else {
            EXPECT_LE(nearest_m, expected_m);
        }
    }
}

TEST(DetectionRange, CostlyRangesAreLookedAtFromTheFarthestToTheFirstThatIsSeen) {
    const RangeLimits limits{
        .nearest_m = 100.0, .farthest_m = 1e6, .looksPerDecade = 4, .costlyBelow_m = 1e6};
    for (const double range_m : {150.0, 3e3, 4e4, 7e5}) {
        double nearest_m = 1e9;
        const DetectionRange found = detectionRange(
            [&](double r) {
                nearest_m = std::min(nearest_m, r);
                return range_m * range_m / (r * r);
            },
            1.0, limits);
        EXPECT_NEAR(found.range_m / range_m, 1.0, 1e-6);
        EXPECT_EQ(found.crossings, 1);
        const double look = std::pow(10.0, 0.25);
        EXPECT_GE(nearest_m, range_m / (look * look * look)) << "with one for the curvature";
    }
}

// As where the texture of terrain behind a target goes up and down with the range.
TEST(DetectionRange, OfARatioThatScattersAsMuchIsSaidAndNoMoreLookedAt) {
    std::size_t calls = 0;
    const auto ratio = [&](double r) {
        ++calls;
        return 1.7e9 / (r * r) * (1.0 + 0.01 * std::sin(1e3 * r));
    };
    const DetectionRange found =
        detectionRange(ratio, 1.0, {.nearest_m = 100.0, .farthest_m = 1e6, .looksPerDecade = 4});
    EXPECT_NEAR(found.range_m / std::sqrt(1.7e9), 1.0, 0.01);
    EXPECT_GT(found.relativeError, 1e-4);
    EXPECT_LT(found.relativeError, 0.02);
    EXPECT_NEAR(found.slope, -2.0, 0.2);
    EXPECT_LT(calls, 28u);
    calls = 0;
    const DetectionRange smooth =
        detectionRange([](double r) { return 1.7e9 / (r * r); }, 1.0,
                       {.nearest_m = 100.0, .farthest_m = 1e6, .looksPerDecade = 4});
    EXPECT_LE(smooth.relativeError, 1e-5);
}

// A contrast that changes its sign between two looks dips below the threshold there, however large
// it is at both.
TEST(DetectionRange, AChangeOfSignBetweenTwoLooksIsLookedInto) {
    const double zero_m = 3011.0;
    const auto ratio = [&](double r) {
        return std::tanh(40.0 * (1.0 - r / zero_m)) * (r < 3100.0 ? 10.0 : 0.02);
    };
    const DetectionRange found =
        detectionRange(ratio, 1.0, {.nearest_m = 100.0, .farthest_m = 1e6, .looksPerDecade = 2000});
    EXPECT_EQ(found.crossings, 3);
    std::size_t calls = 0;
    const auto signless = [&](double r) {
        ++calls;
        return 1e12 / (r * r);
    };
    (void)detectionRange(signless, 1.0,
                         {.nearest_m = 100.0, .farthest_m = 1e6, .looksPerDecade = 2000});
    EXPECT_LT(calls, 40u) << "where nothing crosses four looks per decade are enough";
}

TEST(DetectionRange, WhatIsNeverOrAlwaysSeenIsSaid) {
    const RangeLimits limits{.nearest_m = 100.0, .farthest_m = 1000.0};
    EXPECT_EQ(detectionRange([](double) { return 0.0; }, 5.0, limits).found, Found::nowhere);
    EXPECT_EQ(detectionRange([](double) { return 0.0; }, 5.0, limits).range_m, 0.0);
    const DetectionRange far = detectionRange([](double) { return 9.0; }, 5.0, limits);
    EXPECT_EQ(far.found, Found::beyond);
    EXPECT_EQ(far.range_m, 1000.0);
}

TEST(DetectionRange, RefusesLimitsThatAreNone) {
    const auto one = [](double) { return 1.0; };
    EXPECT_THROW(detectionRange(one, 5.0, {.nearest_m = 0.0}), InputError);
    EXPECT_THROW(detectionRange(one, 5.0, {.nearest_m = 10.0, .farthest_m = 10.0}), InputError);
    EXPECT_THROW(detectionRange(one, 0.0, {}), InputError);
    EXPECT_THROW(detectionRange(one, NAN, {}), InputError);
}

} // namespace

} // namespace irsg

#include "irsg/image/ImageStatistics.h"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>

#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using test::infinity;
using test::inputErrorOf;
using test::nanValue;
using testing::HasSubstr;

RadianceImage imageOf(int width, int height, std::vector<float> values) {
    RadianceImage image(width, height);
    image.primary().values = std::move(values);
    return image;
}

TEST(ImageStatistics, OfOneToN) {
    // Closed forms: mean (n + 1)/2, variance (n^2 - 1)/12, median as the mean.
    for (const int n : {1, 2, 7, 100, 1009}) {
        SCOPED_TRACE(n);
        std::vector<float> values(static_cast<std::size_t>(n));
        std::iota(values.rbegin(), values.rend(), 1.0F);
        const ImageStatistics s = imageStatistics(imageOf(n, 1, values));
        EXPECT_EQ(s.finite, static_cast<std::size_t>(n));
        EXPECT_EQ(s.minimum, 1.0);
        EXPECT_EQ(s.minimumX, n - 1);
        EXPECT_EQ(s.maximum, n);
        EXPECT_EQ(s.maximumX, 0);
        EXPECT_EQ(s.sum, 0.5 * n * (n + 1));
        EXPECT_DOUBLE_EQ(s.mean, 0.5 * (n + 1));
        EXPECT_DOUBLE_EQ(s.median, 0.5 * (n + 1));
        EXPECT_NEAR(s.standardDeviation, std::sqrt((n * n - 1.0) / 12.0), 1e-12 * n);
    }
}

TEST(ImageStatistics, SumAMillionPixelsInDouble) {
    // In float this sum is 0.25 % and more wrong.
    const RadianceImage image = imageOf(1000, 1000, std::vector<float>(1000000, 0.1F));
    const ImageStatistics s = imageStatistics(image);
    EXPECT_NEAR(s.sum, 1e6 * static_cast<double>(0.1F), 1e-9);
    EXPECT_DOUBLE_EQ(s.mean, static_cast<double>(0.1F));
    EXPECT_NEAR(s.standardDeviation, 0.0, 1e-15);
}

TEST(ImageStatistics, KeepASmallSpreadOnALargeMean) {
    std::vector<float> values(1000);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = i % 2 == 0 ? 1e6F : 1e6F + 0.125F;
    }
    const ImageStatistics s = imageStatistics(imageOf(100, 10, values));
    EXPECT_NEAR(s.standardDeviation, 0.0625, 1e-12);
}

TEST(ImageStatistics, SurviveLargeNumbersThatCancel) {
    const float huge = std::numeric_limits<float>::max();
    const ImageStatistics s = imageStatistics(imageOf(4, 1, {huge, 1.0F, -huge, 2.0F}));
    EXPECT_EQ(s.sum, 3.0);
    EXPECT_TRUE(std::isfinite(s.standardDeviation));
}

TEST(ImageStatistics, CountNaNAndInfinitiesApart) {
    const ImageStatistics s =
        imageStatistics(imageOf(3, 2, {nanValue, infinity, 4.0F, -infinity, nanValue, 2.0F}));
    EXPECT_EQ(s.nan, 2U);
    EXPECT_EQ(s.positiveInfinite, 1U);
    EXPECT_EQ(s.negativeInfinite, 1U);
    EXPECT_EQ(s.finite, 2U);
    EXPECT_EQ(s.mean, 3.0);
    EXPECT_EQ(s.minimum, 2.0);
    EXPECT_EQ(s.minimumX, 2);
    EXPECT_EQ(s.minimumY, 1);
    EXPECT_EQ(s.maximumX, 2);
    EXPECT_EQ(s.maximumY, 0);
}

TEST(ImageStatistics, AreNaNWhereNothingIsFinite) {
    const ImageStatistics s = imageStatistics(imageOf(2, 1, {nanValue, infinity}));
    EXPECT_EQ(s.finite, 0U);
    EXPECT_EQ(s.sum, 0.0);
    EXPECT_EQ(s.minimumX, -1);
    for (const double value : {s.minimum, s.maximum, s.mean, s.median, s.standardDeviation}) {
        EXPECT_TRUE(std::isnan(value));
    }
}

TEST(ImageStatistics, OfARectangleSeeItsPixelsAlone) {
    std::vector<float> values(35);
    std::iota(values.begin(), values.end(), 0.0F);
    const RadianceImage image = imageOf(7, 5, values);
    const ImageStatistics s = imageStatistics(image, PixelRectangle{2, 1, 3, 2});
    EXPECT_EQ(s.finite, 6U);
    EXPECT_EQ(s.minimum, 9.0);
    EXPECT_EQ(s.maximum, 18.0);
    EXPECT_EQ(s.maximumX, 4);
    EXPECT_EQ(s.maximumY, 2);
    EXPECT_EQ(s.sum, 9 + 10 + 11 + 16 + 17 + 18);
    EXPECT_EQ(imageStatistics(image, PixelRectangle{6, 4, 1, 1}).mean, 34.0);
}

TEST(ImageStatistics, RefuseRectanglesThatAreNotInTheImage) {
    const RadianceImage image(7, 5);
    const int most = std::numeric_limits<int>::max();
    const PixelRectangle rows[] = {{0, 0, 0, 1},    {0, 0, 1, 0},    {-1, 0, 1, 1}, {0, -1, 1, 1},
                                   {0, 0, 8, 1},    {0, 0, 1, 6},    {7, 0, 1, 1},  {6, 0, 2, 1},
                                   {0, 0, most, 1}, {most, 0, 1, 1}, {0, 0, -3, 1}};
    for (const PixelRectangle& r : rows) {
        EXPECT_THAT(inputErrorOf([&] { imageStatistics(image, r); }),
                    HasSubstr("inside the image of 7 x 5"))
            << r.x << " " << r.y << " " << r.width << " " << r.height;
    }
    EXPECT_THROW(imageStatistics(image, ImageChannel{"x", "", {1.0F}}), LogicError);
    EXPECT_THROW(imageStatistics(RadianceImage()), LogicError);
}

TEST(Percentile, IsLinearBetweenRanks) {
    const std::vector<float> values = {4, nanValue, 1, 3, 2, infinity, 5};
    const struct {
        double percent, expected;
    } rows[] = {{0, 1}, {10, 1.4}, {25, 2}, {50, 3}, {62.5, 3.5}, {99, 4.96}, {100, 5}};
    for (const auto& row : rows) {
        EXPECT_NEAR(percentile(values, row.percent), row.expected, 1e-12) << row.percent;
    }
    EXPECT_EQ(percentile(std::vector<float>{7}, 33), 7.0);
    EXPECT_TRUE(std::isnan(percentile(std::vector<float>{nanValue}, 50)));
    EXPECT_TRUE(std::isnan(percentile({}, 50)));
}

TEST(Percentile, RefusesWhatIsNoPercentage) {
    const std::vector<float> values = {1, 2};
    for (const double percent : {-1.0, 100.1, static_cast<double>(nanValue)}) {
        EXPECT_THAT(inputErrorOf([&] { percentile(values, percent); }), HasSubstr("0 to 100"));
    }
    EXPECT_THAT(inputErrorOf([&] { percentileLimits(values, 50, 50); }), HasSubstr("lower one"));
    EXPECT_THAT(inputErrorOf([&] { percentileLimits(values, 90, 10); }), HasSubstr("lower one"));
}

TEST(DisplayLimits, AreAlwaysUsable) {
    const struct {
        const char* name;
        std::vector<float> values;
        DisplayLimits expected;
    } rows[] = {
        {"two values", {3, -1, nanValue}, {-1, 3}},       {"one value", {300, 300}, {297, 303}},
        {"one negative value", {-2}, {-2.02, -1.98}},     {"zeros", {0, 0}, {0, 1}},
        {"nothing finite", {nanValue, infinity}, {0, 1}}, {"no pixel", {}, {0, 1}},
    };
    for (const auto& row : rows) {
        const DisplayLimits limits = percentileLimits(row.values);
        EXPECT_DOUBLE_EQ(limits.low, row.expected.low) << row.name;
        EXPECT_DOUBLE_EQ(limits.high, row.expected.high) << row.name;
    }
}

TEST(DisplayLimits, LeaveOutliersToThePercentiles) {
    std::vector<float> values(101);
    std::iota(values.begin(), values.end(), 0.0F);
    values[50] = 1e9F;
    const DisplayLimits limits = percentileLimits(values, 1, 99);
    EXPECT_DOUBLE_EQ(limits.low, 1.0);
    EXPECT_DOUBLE_EQ(limits.high, 100.0);
}

TEST(DisplayLimits, OfDifferencesAreSymmetric) {
    EXPECT_EQ(symmetricLimits(std::vector<float>{1, -4, nanValue}), (DisplayLimits{-4, 4}));
    EXPECT_EQ(symmetricLimits(std::vector<float>{0}), (DisplayLimits{-1, 1}));
    EXPECT_EQ(symmetricLimits(std::vector<float>{1, -2, 3}, 50), (DisplayLimits{-2, 2}));
    // Where most values are 0, the few others are still shown.
    EXPECT_EQ(symmetricLimits(std::vector<float>{0, 0, 0, 0, 0, -3, 1}, 50),
              (DisplayLimits{-3, 3}));
}

} // namespace
} // namespace irsg

TEST(ObjectLimits, AreThoseOfTheTargetAndNotOfItsFewGlowingPixels) {
    // A background of 2, a body from 1 to 11 and three pixels of 1000.
    std::vector<float> values(20000, 2.0f);
    for (int i = 0; i < 1000; ++i) {
        values[static_cast<std::size_t>(i)] = 1.0f + 0.01f * static_cast<float>(i);
    }
    values[0] = values[1] = values[2] = 1000.0f;
    const irsg::DisplayLimits limits = irsg::objectLimits(values);
    EXPECT_NEAR(limits.low, 1.08, 0.01);
    EXPECT_NEAR(limits.high, 10.93, 0.05);
}

TEST(ObjectLimits, HoldTheBackgroundAlso) {
    std::vector<float> values(1000, 0.0f);
    for (std::size_t i = 0; i < 100; ++i) {
        values[i] = 5.0f + 0.01f * static_cast<float>(i);
    }
    EXPECT_EQ(irsg::objectLimits(values).low, 0.0);
    std::vector<float> even(100);
    for (std::size_t i = 0; i < even.size(); ++i) {
        even[i] = static_cast<float>(i);
    }
    EXPECT_NEAR(irsg::objectLimits(even).high, 98.01, 1e-4);
    EXPECT_LT(irsg::objectLimits(std::vector<float>(9, 3.0f)).low, 3.0);
    EXPECT_LT(irsg::objectLimits({}).low, irsg::objectLimits({}).high);
}

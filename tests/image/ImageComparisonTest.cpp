#include "irsg/image/ImageComparison.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/image/ComparisonFigures.h"
#include "irsg/image/ImageIntensity.h"
#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using test::infinity;
using test::inputErrorOf;
using test::nanValue;
using testing::HasSubstr;

RadianceImage imageOf(int width, int height, std::vector<float> values,
                      const std::string& channel = "L") {
    RadianceImage image(width, height, channel);
    image.primary().values = std::move(values);
    return image;
}

RadianceImage ramp(int width = 40, int height = 30) {
    RadianceImage image(width, height);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        image.primary().values[i] = 1.0F + 0.01F * static_cast<float>(i);
    }
    return image;
}

TEST(ImageComparison, FindsOneChangedPixelWithSignAndPlaceAndBothValues) {
    const RadianceImage b = ramp();
    for (const float change : {0.5F, -0.25F}) {
        RadianceImage a = b;
        a.primary().values[a.offset(17, 22)] += change;
        const Comparison compared = compareImages(a, b);
        EXPECT_EQ(compared.largest.x, 17);
        EXPECT_EQ(compared.largest.y, 22);
        EXPECT_EQ(compared.largest.a, a.at(17, 22));
        EXPECT_EQ(compared.largest.b, b.at(17, 22));
        EXPECT_NEAR(compared.largest.error, change, 1e-6);
        EXPECT_NEAR(compared.meanError, change / 1200.0, 1e-9);
        EXPECT_EQ(compared.overFail, 1u);
        EXPECT_EQ(compared.verdict, Verdict::failure);
        const ImageChannel plane =
            differencePlane(a.primary(), b.primary(), DifferenceMode::signedDifference);
        for (std::size_t i = 0; i < plane.values.size(); ++i) {
            EXPECT_EQ(plane.values[i] != 0.0F, i == a.offset(17, 22));
        }
        EXPECT_EQ(plane.values[a.offset(17, 22)] > 0.0F, change > 0.0F);
    }
}

TEST(ImageComparison, GivesTheNumbersOfTheirClosedForms) {
    const RadianceImage a = imageOf(2, 2, {1.0F, 2.0F, 3.0F, 8.0F});
    const RadianceImage b = imageOf(2, 2, {1.0F, 4.0F, 2.0F, 4.0F});
    const Comparison compared = compareImages(a, b);
    // Differences 0, -2, 1, 4.
    EXPECT_DOUBLE_EQ(compared.meanError, 0.75);
    EXPECT_DOUBLE_EQ(compared.meanAbsoluteError, 1.75);
    EXPECT_DOUBLE_EQ(compared.rmsError, std::sqrt(21.0 / 4.0));
    EXPECT_DOUBLE_EQ(compared.peak, 8.0);
    EXPECT_DOUBLE_EQ(compared.peakSignalToNoise_dB, 10.0 * std::log10(64.0 / (21.0 / 4.0)));
    EXPECT_DOUBLE_EQ(compared.epsilon, 0.01 * (1.0 + 16.0 + 4.0 + 16.0) / 4.0);
    const double e = compared.epsilon;
    EXPECT_DOUBLE_EQ(compared.relativeMeanSquareError,
                     (4.0 / (16.0 + e) + 1.0 / (4.0 + e) + 16.0 / (16.0 + e)) / 4.0);
    EXPECT_DOUBLE_EQ(compared.largest.error, 4.0);
    // |2 - 4| / 3 and |8 - 4| / 6 are equal: the first in reading order.
    EXPECT_DOUBLE_EQ(compared.largestRelative.error, -2.0 / 3.0);
    EXPECT_EQ(compared.largestRelative.x, 1);
    EXPECT_EQ(compared.largestRelative.y, 0);
    EXPECT_EQ(compared.overFail, 3u);
    EXPECT_DOUBLE_EQ(compared.percentOverFail(), 75.0);
    EXPECT_FALSE(compared.totalIsIntensity);
    EXPECT_DOUBLE_EQ(compared.totalA - compared.totalB, 3.0);
    EXPECT_EQ(compared.totalUnit, "W m-2 sr-1 px");
}

TEST(ImageComparison, EqualImagesPassWithInfinitePsnr) {
    const Comparison compared = compareImages(ramp(), ramp());
    EXPECT_EQ(compared.verdict, Verdict::pass);
    EXPECT_EQ(compared.peakSignalToNoise_dB, std::numeric_limits<double>::infinity());
    EXPECT_EQ(compared.meanAbsoluteError, 0.0);
    EXPECT_EQ(compared.relativeMeanSquareError, 0.0);
    const RadianceImage dark(3, 3);
    EXPECT_EQ(compareImages(dark, dark).relativeMeanSquareError, 0.0);
    EXPECT_EQ(compareImages(dark, dark).largestRelative.error, 0.0);
}

TEST(ImageComparison, ChangesSignWithTheOrderOfTheImages) {
    const RadianceImage a = imageOf(2, 1, {1.0F, 5.0F}), b = imageOf(2, 1, {2.0F, 3.0F});
    const Comparison ab = compareImages(a, b), ba = compareImages(b, a);
    EXPECT_DOUBLE_EQ(ab.meanError, -ba.meanError);
    EXPECT_DOUBLE_EQ(ab.largest.error, -ba.largest.error);
    EXPECT_DOUBLE_EQ(ab.rmsError, ba.rmsError);
    EXPECT_EQ(ab.verdict, ba.verdict);
}

TEST(ImageComparison, SmallDifferencesOnLargeValuesAreNotLostInTheSum) {
    RadianceImage a(1000, 1000), b(1000, 1000);
    for (std::size_t i = 0; i < a.pixelCount(); ++i) {
        b.primary().values[i] = 1.0e6F;
        a.primary().values[i] = i % 2 == 0 ? 1.0e6F + 0.125F : 1.0e6F;
    }
    EXPECT_DOUBLE_EQ(compareImages(a, b).meanError, 0.0625);
}

/// A pair of images that is wrong, with thresholds that let it pass and ones that do not.
struct Level {
    const char* name;
    ComparisonLevel passes, rejects;
};
void PrintTo(const Level& row, std::ostream* out) {
    *out << row.name;
}

class Thresholds : public testing::TestWithParam<Level> {};

// 100 pixels of 10; five are wrong by 0.5, one of them by 2.
TEST_P(Thresholds, RejectAWrongPictureAndLetTheAllowedOnePass) {
    const RadianceImage b = imageOf(10, 10, std::vector<float>(100, 10.0F));
    RadianceImage a = b;
    for (const std::size_t i : {3u, 40u, 41u, 77u}) {
        a.primary().values[i] = 10.5F;
    }
    a.primary().values[99] = 12.0F;

    ComparisonOptions options;
    options.warn = options.fail = GetParam().passes;
    EXPECT_EQ(compareImages(a, b, options).verdict, Verdict::pass);
    options.warn = GetParam().rejects;
    EXPECT_EQ(compareImages(a, b, options).verdict, Verdict::warning);
    options.fail = GetParam().rejects;
    EXPECT_EQ(compareImages(a, b, options).verdict, Verdict::failure);
}

constexpr double none = std::numeric_limits<double>::infinity();
INSTANTIATE_TEST_SUITE_P(
    OfIdiff, Thresholds,
    testing::Values(
        Level{"absolute", {.absolute = 2.0}, {.absolute = 1.999}},
        Level{"relative", {.relative = 0.19}, {.relative = 0.18}},
        Level{"bothMustBeExceeded",
              {.absolute = 0.4, .relative = 0.19},
              {.absolute = 0.4, .relative = 0.04}},
        Level{"percent", {.percent = 5.0}, {.percent = 4.9}},
        Level{"allowed", {.allowed = 5}, {.allowed = 4}},
        Level{"theLargerAllowance", {.percent = 1.0, .allowed = 5}, {.percent = 1.0, .allowed = 2}},
        Level{"hard", {.percent = 5.0, .hard = 2.0}, {.percent = 5.0, .hard = 1.9}},
        Level{"none", {.absolute = 3.0, .hard = none}, {}}),
    [](const auto& row) { return row.param.name; });

TEST(ImageComparison, NaNAndInfinityNeverPassAndAreCountedWithTheirFirstPlace) {
    const RadianceImage good = ramp();
    ComparisonOptions lenient;
    lenient.fail = lenient.warn = {.absolute = 1e30, .percent = 99.0, .allowed = 100000};
    EXPECT_EQ(compareImages(good, good, lenient).verdict, Verdict::pass);
    for (const float bad : {nanValue, infinity, -infinity}) {
        RadianceImage a = good;
        a.primary().values[a.offset(5, 2)] = bad;
        a.primary().values[a.offset(4, 3)] = bad;
        for (const auto& [first, second] : {std::pair(a, good), {good, a}, {a, a}}) {
            const Comparison compared = compareImages(first, second, lenient);
            EXPECT_EQ(compared.verdict, Verdict::failure);
            EXPECT_EQ(compared.compared, 1198u);
            EXPECT_EQ(compared.overFail, 2u);
            EXPECT_TRUE(std::isfinite(compared.rmsError));
        }
        const NonFinite& counted = compareImages(a, good).nonFiniteA;
        EXPECT_EQ(std::isnan(bad) ? counted.nan : counted.infinite, 2u);
        const PixelPair& place = std::isnan(bad) ? counted.firstNan : counted.firstInfinite;
        EXPECT_EQ(place.x, 5);
        EXPECT_EQ(place.y, 2);
    }
    const Comparison nothing = compareImages(imageOf(1, 1, {nanValue}), imageOf(1, 1, {1.0F}));
    EXPECT_TRUE(std::isnan(nothing.rmsError));
    EXPECT_EQ(nothing.largest.x, -1);
    EXPECT_EQ(nothing.verdict, Verdict::failure);
}

TEST(ImageComparison, ARectangleIsComparedAlone) {
    RadianceImage a = ramp();
    const RadianceImage b = a;
    a.primary().values[a.offset(17, 22)] += 1.0F;
    a.primary().values[0] = nanValue;
    ComparisonOptions options;
    options.rectangle = PixelRectangle{16, 21, 4, 2};
    const Comparison inside = compareImages(a, b, options);
    EXPECT_EQ(inside.pixels, 8u);
    EXPECT_NEAR(inside.meanError, 1.0 / 8.0, 1e-6);
    EXPECT_EQ(inside.largest.x, 17);
    EXPECT_EQ(inside.nonFiniteA.nan, 0u);
    options.rectangle = PixelRectangle{20, 21, 20, 9};
    EXPECT_EQ(compareImages(a, b, options).verdict, Verdict::pass);
}

/// Something that cannot be compared, and the words that must be said of it.
struct Refused {
    const char* name;
    std::function<void()> attempt;
    std::vector<std::string> words;
};
void PrintTo(const Refused& row, std::ostream* out) {
    *out << row.name;
}

class Refusals : public testing::TestWithParam<Refused> {};

TEST_P(Refusals, NameWhatIsWrongAndWhatWasExpected) {
    const std::string message = inputErrorOf(GetParam().attempt);
    for (const std::string& word : GetParam().words) {
        EXPECT_THAT(message, HasSubstr(word));
    }
}

Refused badLevel(const char* name, const ComparisonLevel& level, const std::string& word,
                 const std::string& value) {
    return {name,
            [level] {
                ComparisonOptions options;
                options.fail = level;
                compareImages(ramp(), ramp(), options);
            },
            {word, value}};
}

INSTANTIATE_TEST_SUITE_P(
    OfComparisons, Refusals,
    testing::Values(
        Refused{"size",
                [] { compareImages(ramp(40, 30), ramp(30, 40), {.nameB = "b.exr"}); },
                {"b.exr", "30 x 40 pixels", "40 x 30 pixels"}},
        Refused{"sizeBeforeAnythingElse",
                [] {
                    ComparisonOptions options;
                    options.fail.absolute = -1.0;
                    options.channel = "nothing";
                    compareImages(ramp(40, 30), ramp(40, 31), options);
                },
                {"40 x 31 pixels"}},
        Refused{"unknownChannel",
                [] { compareImages(ramp(), ramp(), {.channel = "M", .nameA = "a.exr"}); },
                {"a.exr", "'M'", "L"}},
        Refused{"noTellingWhichChannel",
                [] {
                    RadianceImage image = imageOf(1, 1, {1.0F}, "R");
                    image.channel("G");
                    compareImages(image, image);
                },
                {"R, G", "L or Y"}},
        Refused{"rectangleOutside",
                [] {
                    compareImages(ramp(), ramp(), {.rectangle = PixelRectangle{39, 0, 2, 1}});
                },
                {"2 x 1 at (39, 0)", "40 x 30"}},
        badLevel("negativeThreshold", {.absolute = -0.5}, "fail threshold", "-0.5"),
        badLevel("thresholdNaN", {.absolute = std::nan("")}, "fail threshold", "nan"),
        badLevel("relativeThatNothingExceeds", {.relative = 2.0}, "relative", "less than 2"),
        badLevel("percentThatAllPass", {.percent = 100.0}, "percent", "less than 100"),
        badLevel("hardNaN", {.hard = std::nan("")}, "hard fail", "nan")),
    [](const auto& row) { return row.param.name; });

TEST(ImageComparison, UnitsAndBandsThatDifferAreWarnedOfAndNeverPass) {
    RadianceImage a = ramp(), b = ramp();
    a.attributes["band.name"] = "3-5 um";
    EXPECT_EQ(compareImages(a, b).verdict, Verdict::pass);
    b.attributes["band.name"] = "8-12 um";
    const Comparison bands = compareImages(a, b);
    ASSERT_EQ(bands.warnings.size(), 1u);
    EXPECT_THAT(bands.warnings[0], HasSubstr("A is 3-5 um, B is 8-12 um"));
    EXPECT_EQ(bands.verdict, Verdict::warning);
    b = ramp();
    a.primary().unit = "mW cm-2";
    b.primary().unit = "K";
    EXPECT_THAT(compareImages(a, b).warnings.at(0), HasSubstr("A is in mW cm-2, B in K"));
    EXPECT_EQ(compareImages(a, b).verdict, Verdict::warning);
}

RadianceImage withGeometry(RadianceImage image, double range_m) {
    image.attributes["sensor.horizontal_field_of_view_deg"] = "2";
    image.attributes["range_m"] = std::to_string(range_m);
    image.attributes["background_W_m2_sr"] = "0.5";
    return image;
}

TEST(ImageComparison, GivesTheDifferenceOfContrastIntensityWhereTheGeometryIsKnown) {
    // A narrow field: the solid angle of a pixel is the square of its pitch.
    const RadianceImage a = withGeometry(imageOf(2, 1, {3.5F, 0.5F}), 1000.0);
    const RadianceImage b = withGeometry(imageOf(2, 1, {1.5F, 0.5F}), 1000.0);
    const double pixel_sr = std::pow(std::tan(std::numbers::pi / 180.0), 2.0);
    const Comparison compared = compareImages(a, b);
    ASSERT_TRUE(compared.totalIsIntensity);
    EXPECT_EQ(compared.totalUnit, "W sr-1");
    EXPECT_NEAR(compared.totalA, 3.0 * pixel_sr * 1e6, 3.0 * pixel_sr * 1e6 * 2e-4);
    EXPECT_NEAR(compared.totalB, 1.0 * pixel_sr * 1e6, 1.0 * pixel_sr * 1e6 * 2e-4);
    EXPECT_NEAR(*contrastIntensity_W_sr(a, a.primary()), compared.totalA, 1e-9);
    EXPECT_TRUE(compared.warnings.empty());

    // A plain matrix has no camera of its own.
    RadianceImage plain = imageOf(2, 1, {1.5F, 0.5F});
    plain.primary().unit.clear();
    const Comparison borrowed = compareImages(a, plain);
    EXPECT_TRUE(borrowed.totalIsIntensity);
    EXPECT_DOUBLE_EQ(borrowed.totalB, compared.totalB);
    EXPECT_THAT(borrowed.warnings.at(0), HasSubstr("A are taken for B"));
    EXPECT_EQ(borrowed.verdict, Verdict::failure);
}

TEST(ImageComparison, GeometryThatCannotBeUsedIsNone) {
    for (const char* range : {"", "far", "-1", "nan", "1000 m", "0"}) {
        RadianceImage image = withGeometry(ramp(), 1.0);
        image.attributes["range_m"] = range;
        EXPECT_FALSE(geometryOf(image)) << range;
    }
    EXPECT_FALSE(geometryOf(ramp()));
    RadianceImage kelvin = withGeometry(ramp(), 1.0);
    kelvin.primary().unit = "K";
    EXPECT_FALSE(contrastIntensity_W_sr(kelvin, kelvin.primary()));
}

TEST(ImageComparison, EveryKindOfDifferenceHasItsFormulaNameAndUnit) {
    const RadianceImage a = imageOf(4, 1, {1.0F, 0.0F, nanValue, 3.0F});
    const RadianceImage b = imageOf(4, 1, {3.0F, 0.0F, 1.0F, 0.0F});
    const auto values = [&](DifferenceMode mode) {
        return differencePlane(a.primary(), b.primary(), mode);
    };
    EXPECT_EQ(values(DifferenceMode::signedDifference).values[0], -2.0F);
    EXPECT_EQ(values(DifferenceMode::absolute).values[0], 2.0F);
    EXPECT_EQ(values(DifferenceMode::relative).values[0], -1.0F);
    EXPECT_EQ(values(DifferenceMode::ratio).values[0], 1.0F / 3.0F);
    EXPECT_EQ(values(DifferenceMode::relative).values[1], 0.0F);
    EXPECT_TRUE(std::isnan(values(DifferenceMode::ratio).values[1]));
    EXPECT_EQ(values(DifferenceMode::ratio).values[3], infinity);
    for (const DifferenceMode mode : allDifferenceModes) {
        EXPECT_TRUE(std::isnan(values(mode).values[2]));
    }
    EXPECT_EQ(values(DifferenceMode::absolute).unit, "W m-2 sr-1");
    EXPECT_EQ(values(DifferenceMode::ratio).unit, "");
}

TEST(ComparisonFigures, SayEverythingAndTheDifferenceImageKeepsIt) {
    RadianceImage a = ramp();
    const RadianceImage b = ramp();
    a.primary().values[a.offset(1, 2)] += 1.0F;
    const ComparisonOptions options{.nameA = "a.exr", .nameB = "b.csv"};
    const Comparison compared = compareImages(a, b, options);
    std::string keys;
    for (const ComparisonFigure& figure : comparisonFigures(compared, options)) {
        keys += figure.key + " ";
        if (figure.key == "max_error") {
            EXPECT_THAT(figure.detail, HasSubstr("at (1, 2), A 2.81, B 1.81")) << figure.detail;
        }
        if (figure.key == "psnr") {
            EXPECT_THAT(figure.detail, HasSubstr("peak 12.99"));
        }
        if (figure.key == "rel_mse") {
            EXPECT_THAT(figure.detail, HasSubstr("epsilon "));
        }
    }
    for (const char* key :
         {"mean_error", "mean_absolute_error", "rms_error", "psnr", "rel_mse", "max_relative_error",
          "fail_pixels", "fail_percent", "warn_pixels", "nan_a", "infinite_b", "sum_difference"}) {
        EXPECT_THAT(keys, HasSubstr(key));
    }
    const RadianceImage image = differenceImage(a, b, compared, options);
    EXPECT_EQ(image.primary().name, "difference");
    EXPECT_EQ(image.find("A")->values, a.primary().values);
    EXPECT_EQ(image.attributes.at("compare.verdict"), "FAILURE");
    EXPECT_EQ(image.attributes.at("compare.A"), "a.exr, channel L");
}

} // namespace
} // namespace irsg

#include "irsg/radiometry/Spectrum.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

using namespace irsg;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

double integral(std::initializer_list<const Spectrum*> factors, const SpectralRange& range) {
    const std::vector<const Spectrum*> list(factors);
    return integrateProduct(list, range);
}

/// A spectrum of random nodes over `range`, reproducible.
Spectrum randomSpectrum(std::mt19937& generator, const SpectralRange& range, int nodes) {
    std::uniform_real_distribution<double> step(0.1, 1.0);
    std::uniform_real_distribution<double> height(-1.0, 2.0);
    std::vector<double> axis = {0.0};
    std::vector<double> values = {height(generator)};
    while (static_cast<int>(axis.size()) < nodes) {
        axis.push_back(axis.back() + step(generator));
        values.push_back(height(generator));
    }
    const double scale = range.width_um() / axis.back();
    for (double& x : axis) {
        x = range.min_um + x * scale;
    }
    return {axis, values};
}

} // namespace

TEST(Spectrum, IsLinearBetweenItsNodesAndExactAtThem) {
    const Spectrum spectrum({3.0, 4.0, 5.0}, {1.0, 3.0, -1.0});
    EXPECT_EQ(spectrum.at(3.0), 1.0);
    EXPECT_EQ(spectrum.at(4.0), 3.0);
    EXPECT_EQ(spectrum.at(5.0), -1.0);
    EXPECT_DOUBLE_EQ(spectrum.at(3.25), 1.5);
    EXPECT_DOUBLE_EQ(spectrum.at(4.75), 0.0);
}

TEST(Spectrum, HoldsItsEndsOrIsZeroOutsideItsAxis) {
    const Spectrum held({3.0, 5.0}, {1.0, 2.0}, Spectrum::Outside::hold);
    EXPECT_EQ(held.at(2.999), 1.0);
    EXPECT_EQ(held.at(50.0), 2.0);
    const Spectrum zero({3.0, 5.0}, {1.0, 2.0}, Spectrum::Outside::zero);
    EXPECT_EQ(zero.at(2.999), 0.0);
    EXPECT_EQ(zero.at(3.0), 1.0);
    EXPECT_EQ(zero.at(5.0), 2.0);
    EXPECT_EQ(zero.at(std::nextafter(5.0, 6.0)), 0.0);
}

TEST(Spectrum, ThatIsConstantHoldsEverywhere) {
    const Spectrum constant = Spectrum::constant(0.9);
    EXPECT_TRUE(constant.isConstant());
    EXPECT_EQ(constant.size(), 1u);
    EXPECT_EQ(constant.at(0.2), 0.9);
    EXPECT_EQ(constant.at(40.0), 0.9);
    EXPECT_TRUE(constant.covers({1e-3, 1e6}));
    EXPECT_EQ(Spectrum().at(4.0), 0.0);
}

TEST(Spectrum, SamplesInOneSweepWhatItGivesPointByPoint) {
    std::mt19937 generator(1);
    const Spectrum spectrum = randomSpectrum(generator, {2.0, 6.0}, 50);
    std::vector<double> wavelengths;
    for (int i = 0; i <= 1000; ++i) {
        wavelengths.push_back(1.0 + 0.006 * i);
    }
    const std::vector<double> samples = spectrum.sample(wavelengths);
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        EXPECT_EQ(samples[i], spectrum.at(wavelengths[i]));
    }
    EXPECT_THROW((void)spectrum.sample(std::vector{4.0, 3.0}), LogicError);
}

TEST(Spectrum, KnowsItsExtremesAndWhatItCovers) {
    const Spectrum spectrum({3.0, 4.0, 5.0}, {1.0, 3.0, -1.0});
    EXPECT_EQ(spectrum.minimum(), -1.0);
    EXPECT_EQ(spectrum.maximum(), 3.0);
    EXPECT_TRUE(spectrum.covers({3.0, 5.0}));
    EXPECT_FALSE(spectrum.covers({2.999, 5.0}));
    EXPECT_FALSE(spectrum.covers({3.0, 5.001}));
}

TEST(Spectrum, MapsEveryValueAndKeepsItsNodes) {
    const Spectrum spectrum({3.0, 4.0}, {1.0, 3.0}, Spectrum::Outside::zero);
    const Spectrum doubled = spectrum.mapped([](double value) { return 2.0 * value; });
    EXPECT_EQ(doubled, Spectrum({3.0, 4.0}, {2.0, 6.0}, Spectrum::Outside::zero));
    EXPECT_EQ(Spectrum::constant(0.25).mapped([](double v) { return 1.0 - v; }),
              Spectrum::constant(0.75));
}

TEST(Spectrum, AxesMergeIntoTheirUnionInsideTheRange) {
    const Spectrum a({2.0, 3.5, 4.0, 9.0}, {0, 0, 0, 0});
    const Spectrum b({3.0, 4.0, 4.5, 5.0}, {0, 0, 0, 0});
    const Spectrum c = Spectrum::constant(1.0);
    const Spectrum* const all[] = {&a, &b, &c};
    EXPECT_THAT(mergeAxes(all, {3.0, 5.0}), ElementsAre(3.0, 3.5, 4.0, 4.5, 5.0));
    EXPECT_THAT(mergeAxes(all, {5.5, 6.0}), ElementsAre(5.5, 6.0));
    EXPECT_THAT(mergeAxes({}, {3.0, 5.0}), ElementsAre(3.0, 5.0));
    EXPECT_THROW(mergeAxes(all, {5.0, 3.0}), LogicError);
}

TEST(Spectrum, IntegralOfALineIsItsTrapezium) {
    const Spectrum line({3.0, 5.0}, {1.0, 2.0});
    EXPECT_DOUBLE_EQ(integral({&line}, {3.0, 5.0}), 3.0);
    EXPECT_DOUBLE_EQ(integral({&line}, {4.0, 5.0}), 1.75);
    // Held and zero ends.
    EXPECT_DOUBLE_EQ(integral({&line}, {2.0, 6.0}), 1.0 + 3.0 + 2.0);
    const Spectrum zero({3.0, 5.0}, {1.0, 2.0}, Spectrum::Outside::zero);
    EXPECT_DOUBLE_EQ(integral({&zero}, {2.0, 6.0}), 3.0);
}

TEST(Spectrum, IntegralsOfProductsOfLinesAreExact) {
    // t^n and t^n (1 - t) over 0 to 1 are 1 / (n + 1) and 1 / (n + 1)(n + 2).
    const SpectralRange unit{1.0, 2.0};
    const Spectrum rising({1.0, 2.0}, {0.0, 1.0});
    const Spectrum falling({1.0, 2.0}, {1.0, 0.0});
    std::vector<const Spectrum*> factors;
    for (int n = 1; n <= 9; ++n) {
        factors.push_back(&rising);
        EXPECT_NEAR(integrateProduct(factors, unit) * (n + 1), 1.0, 1e-14) << n;
        factors.push_back(&falling);
        EXPECT_NEAR(integrateProduct(factors, unit) * (n + 1) * (n + 2), 1.0, 1e-14) << n;
        factors.pop_back();
    }
}

TEST(Spectrum, IntegralsOfProductsOnDifferentAxesAreExact) {
    // A hat over 3, 4, 5 times a line that bends at 3.5: polynomials on four quarters, by hand.
    const Spectrum hat({3.0, 4.0, 5.0}, {0.0, 1.0, 0.0});
    const Spectrum bent({3.0, 3.5, 5.0}, {2.0, 1.0, 1.0});
    // 3 to 3.5: t (2 - 2 t) from 0 to 1/2 = 1/4 - 1/12; 3.5 to 5: the hat alone, 1 - 1/8.
    EXPECT_NEAR(integral({&hat, &bent}, {3.0, 5.0}), 1.0 / 4.0 - 1.0 / 12.0 + 7.0 / 8.0, 1e-15);
}

TEST(Spectrum, SplittingARangeInTwoGivesTheSum) {
    std::mt19937 generator(7);
    const SpectralRange whole{3.0, 5.0};
    for (int trial = 0; trial < 50; ++trial) {
        const Spectrum a = randomSpectrum(generator, {2.5, 5.5}, 40);
        const Spectrum b = randomSpectrum(generator, {3.2, 4.9}, 23);
        const Spectrum c = randomSpectrum(generator, {1.0, 9.0}, 5);
        const double cut_um = std::uniform_real_distribution<double>(3.01, 4.99)(generator);
        const double all = integral({&a, &b, &c}, whole);
        const double parts =
            integral({&a, &b, &c}, {3.0, cut_um}) + integral({&a, &b, &c}, {cut_um, 5.0});
        EXPECT_NEAR(all, parts, 1e-13);
    }
}

TEST(Spectrum, ConstantFactorsScaleTheIntegral) {
    const Spectrum hat({3.0, 4.0, 5.0}, {0.0, 1.0, 0.0});
    const Spectrum half = Spectrum::constant(0.5);
    EXPECT_DOUBLE_EQ(integral({&hat, &half, &half}, {3.0, 5.0}), 0.25);
    EXPECT_DOUBLE_EQ(integral({&half}, {3.0, 5.0}), 1.0);
    EXPECT_DOUBLE_EQ(integral({}, {3.0, 5.0}), 2.0);
}

TEST(Spectrum, SumsAndProductsFollowTheirPartsEverywhere) {
    std::mt19937 generator(3);
    const SpectralRange range{3.0, 5.0};
    const Spectrum a = randomSpectrum(generator, {2.5, 5.5}, 20);
    const Spectrum b = randomSpectrum(generator, {3.2, 4.9}, 11);
    const Spectrum added = sum(a, b, range);
    const Spectrum multiplied = product(a, b, range, 1e-6);
    for (int i = 0; i <= 10000; ++i) {
        const double x = 3.0 + 0.0002 * i;
        EXPECT_NEAR(added.at(x), a.at(x) + b.at(x), 1e-12);
        EXPECT_NEAR(multiplied.at(x), a.at(x) * b.at(x), 4e-6);
    }
}

TEST(Spectrum, ProductsStayWithinTheirRelativeTolerance) {
    const Spectrum rising({3.0, 5.0}, {1.0, 3.0});
    const Spectrum falling({3.0, 5.0}, {5.0, 2.0});
    const Spectrum squared = product(rising, falling, {3.0, 5.0}, 1e-6);
    double worst = 0.0;
    for (int i = 0; i <= 100000; ++i) {
        const double x = 3.0 + 0.00002 * i;
        worst = std::max(worst, std::abs(squared.at(x) / (rising.at(x) * falling.at(x)) - 1.0));
    }
    EXPECT_LT(worst, 2e-6);
    EXPECT_GT(worst, 1e-8);
}

TEST(Spectrum, SumsAndProductsKeepTheJumpAtTheEndOfAnEmission) {
    const Spectrum emission({3.5, 4.5}, {2.0, 4.0}, Spectrum::Outside::zero);
    const Spectrum air({3.0, 5.0}, {0.5, 0.5});
    const SpectralRange range{3.0, 5.0};
    const Spectrum seen = product(emission, air, range);
    EXPECT_EQ(seen.at(3.49), 0.0);
    EXPECT_EQ(seen.at(3.5), 1.0);
    EXPECT_EQ(seen.at(4.5), 2.0);
    EXPECT_EQ(seen.at(4.51), 0.0);
    EXPECT_NEAR(integral({&seen}, range), 1.5, 1e-12);
    EXPECT_NEAR(integral({&emission, &air}, range), 1.5, 1e-14);
    const Spectrum both = sum(emission, air, range);
    EXPECT_EQ(both.at(3.49), 0.5);
    EXPECT_EQ(both.at(3.5), 2.5);
}

TEST(Spectrum, SumsAndProductsOfConstantsAreConstant) {
    const Spectrum a = Spectrum::constant(0.5);
    const Spectrum b = Spectrum::constant(0.25);
    EXPECT_EQ(sum(a, b, {3.0, 5.0}), Spectrum::constant(0.75));
    EXPECT_EQ(product(a, b, {3.0, 5.0}), Spectrum::constant(0.125));
}

namespace {

struct BadAxis {
    const char* name;
    std::vector<double> wavelengths_um;
    std::vector<double> values;
    const char* position;
    const char* found;
};
void PrintTo(const BadAxis& row, std::ostream* out) {
    *out << row.name;
}

class SpectrumRefuses : public testing::TestWithParam<BadAxis> {};

} // namespace

TEST_P(SpectrumRefuses, TheAxisAndNamesTheFirstBadNode) {
    const BadAxis& row = GetParam();
    try {
        const Spectrum spectrum(row.wavelengths_um, row.values, Spectrum::Outside::hold, "paint");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        ASSERT_EQ(error.diagnostics().size(), 1u);
        EXPECT_EQ(error.diagnostics()[0].file, "paint");
        EXPECT_EQ(error.diagnostics()[0].position, row.position);
        EXPECT_THAT(error.diagnostics()[0].value, HasSubstr(row.found));
        EXPECT_FALSE(error.diagnostics()[0].expected.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, SpectrumRefuses,
    testing::Values(
        BadAxis{"empty", {}, {}, "", "0 nodes"},
        BadAxis{"aSingleNode", {4.0}, {1.0}, "", "1 nodes"},
        BadAxis{"unequalLengths", {3.0, 4.0}, {1.0}, "", "2 wavelengths and 1 values"},
        BadAxis{"reversed", {5.0, 4.0, 3.0}, {1, 1, 1}, "node 2", "4 um"},
        BadAxis{"reversedAtTheEnd", {3.0, 4.0, 3.5}, {1, 1, 1}, "node 3", "3.5 um"},
        BadAxis{"duplicated", {3.0, 4.0, 4.0}, {1, 1, 1}, "node 3", "4 um"},
        BadAxis{"wavelengthNotANumber", {3.0, notANumber, 5.0}, {1, 1, 1}, "node 2", "nan"},
        BadAxis{"firstWavelengthNotANumber", {notANumber, 4.0}, {1, 1}, "node 1", "nan"},
        BadAxis{"infiniteWavelength", {3.0, infinity}, {1, 1}, "node 2", "inf"},
        BadAxis{"zeroWavelength", {0.0, 1.0}, {1, 1}, "node 1", "0 um"},
        BadAxis{"negativeWavelength", {-3.0, 4.0}, {1, 1}, "node 1", "-3 um"},
        BadAxis{"valueNotANumber", {3.0, 4.0}, {1, notANumber}, "node 2", "nan"},
        BadAxis{"infiniteValue", {3.0, 4.0}, {-infinity, 1}, "node 1", "-inf"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Spectrum, RefusesAConstantThatIsNotFinite) {
    EXPECT_THROW(Spectrum::constant(notANumber), InputError);
    EXPECT_THROW(Spectrum::constant(infinity), InputError);
}

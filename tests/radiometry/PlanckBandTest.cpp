#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/reference/PlanckReference.h"

using namespace irsg;

namespace {

struct NamedRange {
    const char* name;
    SpectralRange range;
};
void PrintTo(const NamedRange& row, std::ostream* out) {
    *out << row.name;
}

const NamedRange ranges[] = {{"Swir", {1.9, 2.9}},      {"Mwir", {3.0, 5.0}},
                             {"Lwir", {8.0, 12.0}},     {"Whole", {0.2, 40.0}},
                             {"Short", {0.2, 0.3}},     {"Long", {30.0, 40.0}},
                             {"Narrow", {4.2, 4.2001}}, {"Wide", {0.1, 1000.0}}};

class BandRadiance : public testing::TestWithParam<NamedRange> {};

std::string nameOf(const testing::TestParamInfo<NamedRange>& row) {
    return row.param.name;
}

} // namespace

TEST_P(BandRadiance, AgreesWithSimpsonsRuleInLongDouble) {
    const SpectralRange range = GetParam().range;
    const Band band = Band::topHat(range.min_um, range.max_um);
    double worst = 0.0;
    for (const double temperature_K : {1.0, 5.0, 20.0, 77.0, 150.0, 205.0, 300.0, 600.0, 1000.0,
                                       2200.0, 5000.0, 5772.0, 1e5, 1e6}) {
        const long double truth = reference::bandRadiance(range, temperature_K);
        const double value = bandRadiance_W_m2_sr(band, temperature_K);
        ASSERT_TRUE(std::isfinite(value));
        if (truth > 1e-280L) {
            const auto error = static_cast<double>(std::abs(value / truth - 1.0L));
            EXPECT_LT(error, 1e-9) << temperature_K << " K";
            worst = std::max(worst, error);
        }
    }
    std::printf("band radiance, %g-%g um, 1 to 1e6 K: largest relative error %.2e\n", range.min_um,
                range.max_um, worst);
}

TEST_P(BandRadiance, GivesTheApparentTemperatureBack) {
    const SpectralRange range = GetParam().range;
    const Band band = Band::topHat(range.min_um, range.max_um);
    double worst = 0.0;
    for (int i = 0; i <= 60; ++i) {
        const double temperature_K = std::pow(10.0, 0.1 * i);
        const double radiance = bandRadiance_W_m2_sr(band, temperature_K);
        const auto found_K = apparentTemperature_K(band, radiance);
        if (radiance > 1e-280) {
            ASSERT_TRUE(found_K) << temperature_K << " K";
            worst = std::max(worst, std::abs(*found_K / temperature_K - 1.0));
        } else if (radiance == 0.0) {
            EXPECT_FALSE(found_K) << temperature_K << " K";
        }
    }
    EXPECT_LT(worst, 1e-9);
    std::printf("apparent temperature, %g-%g um, 1 to 1e6 K: largest relative error %.2e\n",
                range.min_um, range.max_um, worst);
}

INSTANTIATE_TEST_SUITE_P(Of, BandRadiance, testing::ValuesIn(ranges), nameOf);

TEST(PlanckBand, OverTheWholeSpectrumIsTheLawOfStefanAndBoltzmann) {
    // sigma = 2 pi^5 k^4 / 15 h^3 c^2; less than 1e-7 of it lies outside x = 1.4e-3 to 60.
    const double sigma = 2.0 * std::pow(std::numbers::pi, 5) * std::pow(boltzmannConstant_J_K, 4) /
                         (15.0 * std::pow(planckConstant_J_s, 3) * std::pow(speedOfLight_m_s, 2));
    EXPECT_NEAR(sigma, 5.670374419e-8, 1e-17);
    for (const double temperature_K : {1.0, 300.0, 5772.0, 1e5}) {
        const double unit_um = secondRadiationConstant_um_K / temperature_K;
        const Band everything = Band::topHat(unit_um / 80.0, unit_um / 1e-4);
        const double expected = sigma * std::pow(temperature_K, 4) / std::numbers::pi;
        EXPECT_NEAR(bandRadiance_W_m2_sr(everything, temperature_K) / expected, 1.0, 1e-11);
    }
}

TEST(PlanckBand, FractionBelowAWavelengthIsThePublishedBlackbodyFunction) {
    // F(0 to lambda T) = 15 / pi^4 sum exp(-n x) / n (x^3 + 3 x^2 / n + 6 x / n^2 + 6 / n^3) (Chang
    // and Rhee, 1984). Printed tables (Siegel and Howell: 0.066728 at 2000 um K, 0.480877 at 4000,
    // 0.914199 at 10000) rest on older constants and differ by up to 5e-5.
    struct Row {
        double wavelength_um;
        double printed;
    };
    const double total = 5.670374419184430e-8 * std::pow(1000.0, 4) / std::numbers::pi;
    for (const Row& row : {Row{2.0, 0.066728}, Row{4.0, 0.480877}, Row{10.0, 0.914199}}) {
        const double x = secondRadiationConstant_um_K / (row.wavelength_um * 1000.0);
        double series = 0.0;
        for (int n = 1; n < 100; ++n) {
            series += std::exp(-n * x) / n *
                      (x * x * x + 3.0 * x * x / n + 6.0 * x / (n * n) + 6.0 / std::pow(n, 3));
        }
        series *= 15.0 / std::pow(std::numbers::pi, 4);
        const double value =
            bandRadiance_W_m2_sr(Band::topHat(0.05, row.wavelength_um), 1000.0) / total;
        EXPECT_NEAR(value, series, 1e-10);
        EXPECT_NEAR(value, row.printed, 5e-5);
    }
}

TEST(PlanckBand, WeighsWithTheResponse) {
    // A triangle of three nodes is a sum of two linear flanks: integrate each with Simpson's rule.
    const Band triangle =
        Band::fromResponse({{3.0, 4.0, 5.0}, {0.0, 0.8, 0.0}, Spectrum::Outside::zero});
    for (const double temperature_K : {100.0, 300.0, 2000.0}) {
        long double truth = 0.0L;
        constexpr int intervals = 4000;
        for (int i = 0; i <= intervals; ++i) {
            const long double wavelength_um = 3.0L + 2.0L * i / intervals;
            const long double response = 0.8L * (1.0L - std::abs(wavelength_um - 4.0L));
            const int weight = i == 0 || i == intervals ? 1 : (i % 2 == 1 ? 4 : 2);
            truth += weight * response * reference::planck(wavelength_um, temperature_K);
        }
        truth *= 2.0L / intervals / 3.0L;
        const double value = bandRadiance_W_m2_sr(triangle, temperature_K);
        EXPECT_NEAR(static_cast<double>(value / truth), 1.0, 1e-10) << temperature_K << " K";
    }
}

TEST(PlanckBand, SplittingABandInTwoGivesTheSum) {
    for (const double temperature_K : {20.0, 200.0, 300.0, 5000.0}) {
        const double whole = bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
        const double parts = bandRadiance_W_m2_sr(Band::topHat(3.0, 4.17), temperature_K) +
                             bandRadiance_W_m2_sr(Band::topHat(4.17, 5.0), temperature_K);
        EXPECT_NEAR(parts / whole, 1.0, 1e-12);
    }
}

TEST(PlanckBand, AResponseThatIsZeroInTheLongWavesStillSeesTheShortOnes) {
    // All the response lies where the black body is 1e-40 of what it is at the other end.
    const Band band = Band::fromResponse(
        {{3.0, 3.1, 3.2, 14.0}, {0.0, 1.0, 0.0, 0.0}, Spectrum::Outside::zero}, "short");
    const Band same =
        Band::fromResponse({{3.0, 3.1, 3.2}, {0.0, 1.0, 0.0}, Spectrum::Outside::zero}, "same");
    const double expected = bandRadiance_W_m2_sr(same, 40.0);
    EXPECT_GT(expected, 0.0);
    EXPECT_NEAR(bandRadiance_W_m2_sr(band, 40.0) / expected, 1.0, 1e-12);
}

TEST(PlanckBand, ThereIsNoApparentTemperatureOfWhatNoBlackBodyGives) {
    const Band band = Band::topHat(8.0, 12.0);
    const double infinity = std::numeric_limits<double>::infinity();
    const double tooHot = 1.01 * bandRadiance_W_m2_sr(band, 1e6);
    for (const double radiance :
         {0.0, -1.0, -1e-300, infinity, -infinity, std::nan(""), tooHot, 5e-324}) {
        EXPECT_FALSE(apparentTemperature_K(band, radiance)) << radiance;
    }
    // Over 30 to 40 um a body of 1 K still radiates: what is less has no temperature from 1 K up.
    const Band far = Band::topHat(30.0, 40.0);
    EXPECT_FALSE(apparentTemperature_K(far, 0.99 * bandRadiance_W_m2_sr(far, 1.0)));
    EXPECT_TRUE(apparentTemperature_K(far, 1.01 * bandRadiance_W_m2_sr(far, 1.0)));
}

TEST(PlanckBand, BodiesAtOrBelowZeroKelvinAreDark) {
    const Band band = Band::topHat(3.0, 5.0);
    EXPECT_EQ(bandRadiance_W_m2_sr(band, 0.0), 0.0);
    EXPECT_EQ(bandRadiance_W_m2_sr(band, -10.0), 0.0);
    EXPECT_EQ(bandRadiance_W_m2_sr(band, std::nan("")), 0.0);
}

#include "irsg/radiometry/Planck.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/reference/PlanckReference.h"

using namespace irsg;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

double relativeError(double value, long double truth) {
    return static_cast<double>(std::abs((value - truth) / truth));
}

struct WorstCase {
    double error = 0.0;
    double wavelength_um = 0.0;
    double temperature_K = 0.0;

    void note(double candidate, double wavelength, double temperature) {
        if (!(candidate <= error)) {
            *this = {candidate, wavelength, temperature};
        }
    }
};

} // namespace

TEST(Planck, RadiationConstantsAreThoseOfTheExactSiUnits) {
    // CODATA 2018: c1L = 1.191042972397...e-16 W m2 sr-1, c2 = 1.438776877...e-2 m K.
    EXPECT_NEAR(firstRadiationConstant_W_um4_m2_sr, 1.191042972397e8, 1e-4);
    EXPECT_NEAR(secondRadiationConstant_um_K, 14387.76877, 1e-5);
}

TEST(Planck, RadianceAt10MicrometresAnd300KelvinIsThePublishedValue) {
    // 9.924 W m-2 sr-1 um-1: the value every table of thermal radiation prints.
    EXPECT_NEAR(planckRadiance_W_m2_sr_um(10.0, 300.0), 9.9240, 5e-4);
}

TEST(Planck, RadianceIsWithin1e12OfLongDoubleFrom1To5000KelvinAnd02To40Micrometres) {
    WorstCase worst;
    for (int i = 0; i <= 400; ++i) {
        for (int k = 0; k <= 400; ++k) {
            const double wavelength_um = 0.2 * std::pow(200.0, k / 400.0);
            const double temperature = 1.0 * std::pow(5000.0, i / 400.0);
            const long double truth = reference::planck(wavelength_um, temperature);
            const double value = planckRadiance_W_m2_sr_um(wavelength_um, temperature);
            if (truth > 1.0000001e-290L) {
                worst.note(relativeError(value, truth), wavelength_um, temperature);
            } else if (truth < 0.9999999e-290L) {
                ASSERT_EQ(value, 0.0) << wavelength_um << " um, " << temperature << " K";
            }
        }
    }
    EXPECT_LT(worst.error, 1e-12) << worst.wavelength_um << " um, " << worst.temperature_K << " K";
    RecordProperty("largest_relative_error", std::to_string(worst.error * 1e15) + "e-15");
    std::printf("Planck, 1-5000 K, 0.2-40 um: largest relative error %.2e at %g um, %g K\n",
                worst.error, worst.wavelength_um, worst.temperature_K);
}

TEST(Planck, RadiancesOfManyWavelengthsAreThoseOfEachToTheLastBit) {
    std::vector<double> wavelengths_um{0.0, -1.0, notANumber, infinity};
    for (int i = 0; i <= 1003; ++i) {
        wavelengths_um.push_back(1e-3 * std::pow(1e9, i / 1003.0));
    }
    for (const double temperature_K :
         {0.0, -5.0, notANumber, infinity, 1e-6, 0.1, 30.0, 293.15, 2200.0, 1e9}) {
        std::vector<double> radiances(wavelengths_um.size(), 7.0);
        planckRadiances_W_m2_sr_um(wavelengths_um, temperature_K, radiances);
        for (std::size_t i = 0; i < radiances.size(); ++i) {
            ASSERT_EQ(radiances[i], planckRadiance_W_m2_sr_um(wavelengths_um[i], temperature_K))
                << wavelengths_um[i] << " um, " << temperature_K << " K";
        }
    }
    std::vector<double> few(2);
    EXPECT_THROW(planckRadiances_W_m2_sr_um(wavelengths_um, 300.0, few), LogicError);
}

TEST(Planck, RadianceIsWithin1e12ForExponentsFrom1eMinus12To1e5) {
    WorstCase worst;
    for (const double wavelength_um : {0.2, 1.0, 4.0, 10.0, 40.0}) {
        for (int i = 0; i <= 1700; ++i) {
            const double exponent = std::pow(10.0, -12.0 + 0.01 * i);
            const double temperature_K = secondRadiationConstant_um_K / (wavelength_um * exponent);
            const double value = planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
            ASSERT_TRUE(std::isfinite(value));
            const long double truth =
                exponent > 11000.0 ? 0.0L : reference::planck(wavelength_um, temperature_K);
            if (truth > 1.0000001e-290L) {
                worst.note(relativeError(value, truth), wavelength_um, temperature_K);
            } else if (truth < 0.9999999e-290L) {
                ASSERT_EQ(value, 0.0) << wavelength_um << " um, " << temperature_K << " K";
            }
        }
    }
    EXPECT_LT(worst.error, 1e-12) << worst.wavelength_um << " um, " << worst.temperature_K << " K";
    std::printf("Planck, hc/lkT 1e-12 to 1e5: largest relative error %.2e at %g um, %g K\n",
                worst.error, worst.wavelength_um, worst.temperature_K);
}

TEST(Planck, RadianceIsNeverNotANumber) {
    const double extremes[] = {-infinity, -300.0, -0.0,  0.0, 5e-324, 1e-300, 1e-60,    1e-10,
                               0.2,       40.0,   300.0, 1e5, 1e30,   1e300,  infinity, notANumber};
    for (const double wavelength_um : extremes) {
        for (const double temperature_K : extremes) {
            const double radiance = planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
            EXPECT_FALSE(std::isnan(radiance)) << wavelength_um << " um, " << temperature_K << " K";
            EXPECT_GE(radiance, 0.0);
            const double slope = planckDerivative_W_m2_sr_um_K(wavelength_um, temperature_K);
            EXPECT_FALSE(std::isnan(slope)) << wavelength_um << " um, " << temperature_K << " K";
        }
    }
}

TEST(Planck, RadianceOfNothingColderThanZeroKelvinIsZero) {
    EXPECT_EQ(planckRadiance_W_m2_sr_um(10.0, 0.0), 0.0);
    EXPECT_EQ(planckRadiance_W_m2_sr_um(10.0, -5.0), 0.0);
    EXPECT_EQ(planckRadiance_W_m2_sr_um(4.0, 1.0), 0.0);
    EXPECT_EQ(planckDerivative_W_m2_sr_um_K(10.0, 0.0), 0.0);
}

TEST(Planck, RadianceFollowsRayleighAndJeansWhereTheExponentIsSmall) {
    // L = 2 c k T / lambda^4 (1 - x / 2 + ...).
    const double wavelength_um = 40.0;
    const double temperature_K = 1e5;
    const double x = secondRadiationConstant_um_K / (wavelength_um * temperature_K);
    const double expected = 2.0 * speedOfLight_m_s * boltzmannConstant_J_K * temperature_K /
                            std::pow(wavelength_um, 4) * 1e18;
    EXPECT_NEAR(planckRadiance_W_m2_sr_um(wavelength_um, temperature_K) / expected,
                1.0 - x / 2.0 + x * x / 12.0, 1e-12);
}

TEST(Planck, RadiancePeaksWhereWiensDisplacementLawSays) {
    // lambda_max T = 2897.771955 um K (CODATA 2018): the radiance falls to both sides of it.
    for (const double temperature_K : {77.0, 300.0, 1000.0, 5772.0}) {
        const double peak_um = 2897.771955 / temperature_K;
        const double peak = planckRadiance_W_m2_sr_um(peak_um, temperature_K);
        EXPECT_LT(planckRadiance_W_m2_sr_um(peak_um * 1.0001, temperature_K), peak);
        EXPECT_LT(planckRadiance_W_m2_sr_um(peak_um * 0.9999, temperature_K), peak);
    }
}

TEST(Planck, DerivativeIsTheSlopeOfTheRadiance) {
    for (const double wavelength_um : {0.2, 2.0, 4.0, 10.0, 40.0}) {
        for (const double temperature_K : {50.0, 200.0, 300.0, 1000.0, 1e5}) {
            // The central difference of the long double reference.
            const long double step = temperature_K * 1e-5L;
            const long double slope = (reference::planck(wavelength_um, temperature_K + step) -
                                       reference::planck(wavelength_um, temperature_K - step)) /
                                      (2.0L * step);
            if (slope > 1e-280L) {
                const double value = planckDerivative_W_m2_sr_um_K(wavelength_um, temperature_K);
                EXPECT_LT(relativeError(value, slope), 1e-4)
                    << wavelength_um << " um, " << temperature_K << " K";
            }
        }
    }
    const long double step = 0.01L;
    const long double slope =
        (reference::planck(10.0L, 300.0L + step) - reference::planck(10.0L, 300.0L - step)) /
        (2.0L * step);
    EXPECT_LT(relativeError(planckDerivative_W_m2_sr_um_K(10.0, 300.0), slope), 1e-8);
}

TEST(Planck, BrightnessTemperatureGivesTheTemperatureBack) {
    double worst = 0.0;
    for (int k = 0; k <= 100; ++k) {
        for (int i = 0; i <= 100; ++i) {
            const double wavelength_um = 0.2 * std::pow(200.0, k / 100.0);
            const double temperature_K = std::pow(1e5, i / 100.0);
            const double radiance = planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
            const auto found_K = brightnessTemperature_K(wavelength_um, radiance);
            ASSERT_EQ(found_K.has_value(), radiance > 0.0);
            if (found_K) {
                worst = std::max(worst, std::abs(*found_K / temperature_K - 1.0));
            }
        }
    }
    EXPECT_LT(worst, 1e-13);
}

TEST(Planck, BrightnessTemperatureOfTheSmallestRadianceIsFinite) {
    const auto found_K = brightnessTemperature_K(0.2, 5e-324);
    ASSERT_TRUE(found_K);
    // ln(2 h c^2 / lambda^5 / 5e-324) = 744.44 + 26.64: T = c2 / (0.2 um * 771.08).
    EXPECT_NEAR(*found_K, 93.3, 0.1);
}

struct NoTemperature {
    const char* name;
    double wavelength_um;
    double radiance;
};
void PrintTo(const NoTemperature& row, std::ostream* out) {
    *out << row.name;
}

class PlanckHasNoInverse : public testing::TestWithParam<NoTemperature> {};

TEST_P(PlanckHasNoInverse, BrightnessTemperatureHasNoValue) {
    EXPECT_FALSE(brightnessTemperature_K(GetParam().wavelength_um, GetParam().radiance));
}

INSTANTIATE_TEST_SUITE_P(Of, PlanckHasNoInverse,
                         testing::Values(NoTemperature{"zeroRadiance", 4.0, 0.0},
                                         NoTemperature{"negativeRadiance", 4.0, -1.0},
                                         NoTemperature{"infiniteRadiance", 4.0, infinity},
                                         NoTemperature{"radianceNotANumber", 4.0, notANumber},
                                         NoTemperature{"zeroWavelength", 0.0, 1.0},
                                         NoTemperature{"negativeWavelength", -4.0, 1.0},
                                         NoTemperature{"infiniteWavelength", infinity, 1.0},
                                         NoTemperature{"wavelengthNotANumber", notANumber, 1.0}),
                         [](const auto& row) { return std::string(row.param.name); });

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/SolarSpectrum.h"
#include "irsg/atmosphere/engine/SolarTable.h"
#include "irsg/core/Errors.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

/// W m-2 between two wavelengths.
double irradiance_W_m2(double lower_um, double upper_um) {
    const double lower_per_cm = 1e4 / upper_um, upper_per_cm = 1e4 / lower_um;
    return solarIrradiance_W_m2_per_cm(lower_per_cm, upper_per_cm) * (upper_per_cm - lower_per_cm);
}

TEST(SolarSpectrum, HoldsTheSolarConstant) {
    EXPECT_NEAR(irradiance_W_m2(0.2, 40.0), 1367.98, 0.02);
}

TEST(SolarSpectrum, HoldsThePublishedIrradianceOfItsBands) {
    // The spectrum of Kurucz (1992) in the bands of its description, W m-2.
    for (const auto& [lower_um, upper_um, published] : {std::array{0.25, 0.4, 110.6},
                                                        {0.4, 0.7, 532.8},
                                                        {1.0, 1.7, 282.6},
                                                        {1.7, 2.5, 85.43},
                                                        {3.0, 5.0, 21.07},
                                                        {5.0, 8.0, 4.69},
                                                        {8.0, 9.9, 0.746},
                                                        {10.0, 14.0, 0.523}}) {
        EXPECT_NEAR(irradiance_W_m2(lower_um, upper_um), published, 0.004 * published)
            << lower_um << " um";
    }
}

TEST(SolarSpectrum, IsThatOfABodyOfFiveToSixThousandKelvin) {
    constexpr double sunSolidAngle_sr = 6.794e-5, c1 = 1.191042972e-8, c2 = 1.438776877;
    for (const auto& [nu, lowest_K, highest_K] : {std::array{300.0, 4600.0, 5000.0},
                                                  {1000.0, 4900.0, 5400.0},
                                                  {2500.0, 5400.0, 5900.0},
                                                  {6250.0, 6300.0, 6900.0},
                                                  {18000.0, 5700.0, 6100.0}}) {
        const double radiance =
            solarIrradiance_W_m2_per_cm(nu - 50.0, nu + 50.0) / sunSolidAngle_sr;
        const double temperature_K = c2 * nu / std::log1p(c1 * nu * nu * nu / radiance);
        EXPECT_GT(temperature_K, lowest_K) << nu;
        EXPECT_LT(temperature_K, highest_K) << nu;
    }
}

TEST(SolarSpectrum, AddsUpWhereverItIsCut) {
    for (const double cut_per_cm : {2000.4, 2511.7, 6999.9, 7000.0, 7003.0, 19999.5, 20004.0}) {
        const double lower_per_cm = 1999.3, upper_per_cm = 21234.5;
        const double left =
            solarIrradiance_W_m2_per_cm(lower_per_cm, cut_per_cm) * (cut_per_cm - lower_per_cm);
        const double right =
            solarIrradiance_W_m2_per_cm(cut_per_cm, upper_per_cm) * (upper_per_cm - cut_per_cm);
        EXPECT_NEAR(left + right,
                    solarIrradiance_W_m2_per_cm(lower_per_cm, upper_per_cm) *
                        (upper_per_cm - lower_per_cm),
                    1e-9);
    }
}

TEST(SolarSpectrum, KeepsItsDigitsOverNarrowIntervals) {
    // Within one step of the table the mean is that of the step.
    const double step = solarIrradiance_W_m2_per_cm(2500.0, 2501.0);
    EXPECT_NEAR(solarIrradiance_W_m2_per_cm(2500.4, 2500.4 + 1e-4), step, 1e-6 * step);
}

TEST(SolarSpectrum, IsNothingOutsideItsTable) {
    EXPECT_EQ(solarIrradiance_W_m2_per_cm(100.0, 200.0), 0.0);
    EXPECT_EQ(solarIrradiance_W_m2_per_cm(60000.0, 70000.0), 0.0);
    // Half of it outside: half the mean.
    EXPECT_NEAR(solarIrradiance_W_m2_per_cm(249.0, 251.0),
                0.5 * solarIrradiance_W_m2_per_cm(250.0, 251.0), 1e-12);
}

TEST(SolarSpectrum, RefusesAnIntervalOfNoWidth) {
    EXPECT_THROW((void)solarIrradiance_W_m2_per_cm(2000.0, 2000.0), LogicError);
    EXPECT_THROW((void)solarIrradiance_W_m2_per_cm(2001.0, 2000.0), LogicError);
    EXPECT_THROW((void)solarIrradiance_W_m2_per_cm(std::nan(""), 2000.0), LogicError);
}

struct BadSun {
    const char* name;
    const char* rows;
    const char* expected;
};
void PrintTo(const BadSun& row, std::ostream* out) {
    *out << row.name;
}

class BadSolarTable : public testing::TestWithParam<BadSun> {};

TEST_P(BadSolarTable, IsRefusedByName) {
    const auto file = smat::test::writtenFile(smat::test::ownFolder() / "bad.csv", GetParam().rows);
    try {
        (void)SolarTable::read(file);
        FAIL() << "it was read";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(GetParam().expected), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos);
    }
}

#define SUN_HEADER "lower [cm-1],upper [cm-1],irradiance [W m-2 cm]\n"

INSTANTIATE_TEST_SUITE_P(
    Tables, BadSolarTable,
    testing::Values(BadSun{"empty", "# nothing\n", "0 rows"},
                    BadSun{"noRows", SUN_HEADER, "1 rows"},
                    BadSun{"otherColumn", "lower [cm-1],upper [cm-1],x\n1,2,3\n", "as column 3"},
                    BadSun{"short", SUN_HEADER "1,2,3\n2,3\n", "line 3"},
                    BadSun{"noNumber", SUN_HEADER "1,2,3\n2,3,x\n", "line 3, column 3"},
                    BadSun{"gap", SUN_HEADER "1,2,3\n3,4,3\n",
                           "the upper end of the row before, 2"},
                    BadSun{"backwards", SUN_HEADER "1,1,3\n", "more than 1"},
                    BadSun{"negative", SUN_HEADER "1,2,-3\n", "an irradiance >= 0"}),
    [](const auto& info) { return std::string(info.param.name); });

} // namespace
} // namespace irsg

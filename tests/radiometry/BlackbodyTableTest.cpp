#include "irsg/radiometry/BlackbodyTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "irsg/radiometry/Planck.h"

using namespace irsg;

namespace {

struct TableRow {
    const char* name;
    double min_um;
    double max_um;
    double straightLineError; ///< largest of all temperatures, near 205 K
};

class BlackbodyTableOf : public testing::TestWithParam<TableRow> {};

} // namespace

TEST_P(BlackbodyTableOf, IsAtMostSevenTenThousandthsWrongAtMidNodes) {
    const BlackbodyTable table(Band::topHat(GetParam().min_um, GetParam().max_um));
    double worst = 0.0;
    for (int i = 0; i + 1 < BlackbodyTable::nodes; ++i) {
        const double middle_K =
            BlackbodyTable::minimum_K + BlackbodyTable::step_K * (static_cast<double>(i) + 0.5);
        const double truth = bandRadiance_W_m2_sr(table.band(), middle_K);
        worst = std::max(worst, std::abs(table.radiance_W_m2_sr(middle_K) / truth - 1.0));
    }
    EXPECT_LE(worst, 7e-4);
    std::printf("blackbody table, %g-%g um, mid nodes: ln L over 1/T at most %.4f %% wrong\n",
                GetParam().min_um, GetParam().max_um, 100.0 * worst);
}

TEST_P(BlackbodyTableOf, IsFarBetterThanTheStraightLineOfTheReport) {
    const BlackbodyTable table(Band::topHat(GetParam().min_um, GetParam().max_um));
    double worst = 0.0;
    double worstLine = 0.0;
    double worstLine_K = 0.0;
    for (int i = 1; i < 20000; ++i) {
        const double temperature_K = 200.0 + 0.1 * i;
        const double truth = bandRadiance_W_m2_sr(table.band(), temperature_K);
        worst = std::max(worst, std::abs(table.radiance_W_m2_sr(temperature_K) / truth - 1.0));
        const double line =
            std::abs(table.radianceLinearInTemperature_W_m2_sr(temperature_K) / truth - 1.0);
        if (line > worstLine) {
            worstLine = line;
            worstLine_K = temperature_K;
        }
    }
    EXPECT_LE(worst, 7e-4);
    EXPECT_NEAR(worstLine, GetParam().straightLineError, 0.01 * GetParam().straightLineError);
    EXPECT_NEAR(worstLine_K, 205.0, 1.0);
    std::printf("blackbody table, %g-%g um, everywhere: ln L over 1/T %.4f %%, straight line "
                "%.2f %% at %.1f K\n",
                GetParam().min_um, GetParam().max_um, 100.0 * worst, 100.0 * worstLine,
                worstLine_K);
}

TEST_P(BlackbodyTableOf, IsExactAtItsNodes) {
    const BlackbodyTable table(Band::topHat(GetParam().min_um, GetParam().max_um));
    for (int i = 0; i < BlackbodyTable::nodes; i += 8) {
        const double node_K = BlackbodyTable::minimum_K + BlackbodyTable::step_K * i;
        const double truth = bandRadiance_W_m2_sr(table.band(), node_K);
        EXPECT_NEAR(table.radiance_W_m2_sr(node_K) / truth, 1.0, 1e-13);
        EXPECT_NEAR(table.radianceLinearInTemperature_W_m2_sr(node_K) / truth, 1.0, 1e-13);
    }
}

TEST_P(BlackbodyTableOf, IntegratesDirectlyOutsideItsGrid) {
    const BlackbodyTable table(Band::topHat(GetParam().min_um, GetParam().max_um));
    for (const double temperature_K : {1.0, 150.0, 199.999, 2200.001, 3000.0, 1e5}) {
        const double truth = bandRadiance_W_m2_sr(table.band(), temperature_K);
        EXPECT_EQ(table.radiance_W_m2_sr(temperature_K), truth);
        EXPECT_EQ(table.radianceLinearInTemperature_W_m2_sr(temperature_K), truth);
    }
}

INSTANTIATE_TEST_SUITE_P(Band, BlackbodyTableOf,
                         testing::Values(TableRow{"3to5", 3.0, 5.0, 0.096},
                                         TableRow{"8to12", 8.0, 12.0, 0.016},
                                         TableRow{"1_9to2_9", 1.9, 2.9, 0.30}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(BlackbodyTable, DarkensToZeroAtAndBelowZeroKelvin) {
    const BlackbodyTable table(Band::topHat(3.0, 5.0));
    for (const double temperature_K : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(table.radiance_W_m2_sr(temperature_K), 0.0);
    }
}

TEST(BlackbodyTable, OfABandWhoseColdNodesAreDarkHoldsNoNaN) {
    // At 200 K and 0.05 um the exponent is 1439: the first nodes of the table are zero.
    const BlackbodyTable table(Band::topHat(0.05, 0.06));
    for (double temperature_K = 200.0; temperature_K <= 2200.0; temperature_K += 3.125) {
        const double radiance = table.radiance_W_m2_sr(temperature_K);
        ASSERT_TRUE(std::isfinite(radiance)) << temperature_K << " K";
        ASSERT_GE(radiance, 0.0);
    }
}

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "tests/lines/LineMixing.h"
#include "tests/lines/ModtranColumns.h"
#include "tests/support/SharedMaterial.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"

// What line mixing would make of the wing beyond the head of CO2's band at 4.3 um.

namespace irsg::lbl {
namespace {

// CO2 in N2 and in O2 (Niro et al. 2004).
std::vector<CollisionLaw> air() {
    return {{0.0180, 0.81, 0.008, 2.2e-10, 44.0 * 28.0 / 72.0, 0.79},
            {0.0168, 0.82, 0.007, 2.4e-10, 44.0 * 32.0 / 76.0, 0.21}};
}

TEST(LineMixing, HasTheSymbolsOfTheTables) {
    EXPECT_NEAR(wigner3j(2, 2, 2), -std::sqrt(2.0 / 35.0), 1e-12);
    EXPECT_NEAR(wigner3j(1, 1, 2), std::sqrt(2.0 / 15.0), 1e-12);
    EXPECT_EQ(wigner3j(1, 1, 1), 0.0);
    EXPECT_NEAR(wigner6j(1, 1, 1, 1, 1, 1), 1.0 / 6.0, 1e-12);
    EXPECT_NEAR(wigner6j(2, 2, 2, 2, 2, 2), -3.0 / 70.0, 1e-12);
    EXPECT_EQ(wigner6j(1, 1, 3, 1, 1, 1), 0.0);
}

TEST(LineMixing, OfTheCarbonDioxideWingAbsorbsMoreBesideTheHeadThanTheRunDoes) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    if (data.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const LineList list = completeLineList(Gas::CO2, data);
    constexpr double temperature_K = 299.7, pressure_hPa = 1013.0, fraction = 409e-6;
    const LineMixing band(list, temperature_K, pressure_hPa / 1013.25, air());
    ASSERT_GT(band.count(), 100u);
    EXPECT_LT(band.leak(), 1e-9);
    const std::vector<double>& scales = band.scales();
    // The rates of the law alone add up to the widths of the 25 strongest lines within a quarter.
    for (std::size_t i = 0; i < 25; ++i) {
        EXPECT_NEAR(scales[i], 1.1, 0.15) << i;
    }
    // Without collisions between lines the matrix has Lorentzian lines.
    const LineMixing apart(list, temperature_K, 1.0, {});
    EXPECT_NEAR(apart.mixed_cm2(2380.3) / apart.lorentz_cm2(2380.3), 1.0, 1e-9);

    for (const double nu :
         {2392.0, 2397.0, 2402.0, 2407.0, 2412.0, 2422.0, 2432.0, 2452.0, 2472.0}) {
        std::printf("%.0f cm-1: %.3f of Lorentzian lines, %.3f of Perrin and Hartmann's wings\n",
                    nu, band.mixed_cm2(nu) / band.lorentz_cm2(nu),
                    band.mixed_cm2(nu) / band.winged_cm2(nu));
    }
    // Farther out it is the wing that was fitted to measurements, beside the head it is not.
    for (const double nu : {2417.0, 2432.0, 2452.0, 2472.0}) {
        EXPECT_NEAR(band.mixed_cm2(nu) / band.winged_cm2(nu), 1.0, 0.06) << nu;
    }
    for (const double nu : {2395.0, 2400.0}) {
        EXPECT_GT(band.mixed_cm2(nu) / band.winged_cm2(nu), 1.25) << nu;
    }

    // The whole gas with the wing of this band changed as much.
    WavenumberGrid grid{2375.0, 0.01, 6000};
    std::vector<double> cross_cm2 =
        crossSection_cm2(list, PartitionSums::read(data / "lines" / "partition"), grid,
                         temperature_K, pressure_hPa, fraction, defaultLineShape(Gas::CO2));
    const double column_per_cm2 = fraction * 2.44813e19 * 5e5;
    const SlitMean winged(grid, cross_cm2, column_per_cm2);
    constexpr std::size_t coarse = 50;
    double before = 1.0, after = 1.0;
    for (std::size_t i = 0; i < grid.count; ++i) {
        if (i % coarse == 0) {
            before = band.mixed_cm2(grid.at(i)) / band.winged_cm2(grid.at(i));
            after = band.mixed_cm2(grid.at(i + coarse)) / band.winged_cm2(grid.at(i + coarse));
        }
        const double share = static_cast<double>(i % coarse) / coarse;
        cross_cm2[i] *= before + share * (after - before);
    }
    const SlitMean mixed(grid, cross_cm2, column_per_cm2);
    double wingedSquares = 0.0, mixedSquares = 0.0, count = 0.0, worst = 0.0, difference = 0.0;
    for (const auto& row : modtranColumns(data / "modtran" / "pyradi" / "horizon5kmtropical.fl7")) {
        if (row[0] < 2390.0 || row[0] > 2420.0) {
            continue;
        }
        wingedSquares += std::pow(winged.at(row[0]) - row[13], 2.0);
        mixedSquares += std::pow(mixed.at(row[0]) - row[13], 2.0);
        worst = std::min(worst, mixed.at(row[0]) - row[13]);
        difference += winged.at(row[0]) - mixed.at(row[0]);
        count += 1.0;
    }
    std::printf("2390-2420 cm-1 against MODTRAN: %.4f rms as it is, %.4f with line mixing, %+.4f "
                "worst; as it is transmits %.4f more\n",
                std::sqrt(wingedSquares / count), std::sqrt(mixedSquares / count), worst,
                difference / count);
    EXPECT_LT(std::sqrt(wingedSquares / count), 0.011);
    EXPECT_GT(std::sqrt(mixedSquares / count), 0.03);
    EXPECT_NEAR(difference / count, 0.044, 0.01);
}

} // namespace
} // namespace irsg::lbl

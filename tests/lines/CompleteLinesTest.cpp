#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/Continuum.h"
#include "irsg/core/Errors.h"
#include "tests/lines/ModtranColumns.h"
#include "tests/support/SharedMaterial.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"
#include "tools/atmosphere-tables/lines/PublishedRun.h"

namespace irsg::lbl {
namespace {

/// A range of wavenumbers, the largest RMS difference in transmittance allowed over it and that of
/// any wavenumber of the run.
struct Range {
    double from_per_cm, to_per_cm, rms, worst = 1.0;
};

/// A gas, its column in the published run, its mole fraction there.
struct Case {
    Gas gas;
    std::size_t column;
    double fraction;
    std::vector<Range> ranges;
};

// 5 km of tropical air at the ground: 1013 hPa, 299.7 K, 2.44813e25 molecules per m3. The run does
// not state its CO2: see TellTheCarbonDioxideOfTheRun.
constexpr double pressure_hPa = 1013.0, temperature_K = 299.7;
constexpr double air_per_cm2 = 2.44813e19 * 5e5;

std::vector<Case> cases() {
    return {
        {Gas::H2O,
         2,
         0.0259498,
         {{660, 1200, 0.025},
          {1200, 2500, 0.025},
          {2500, 5400, 0.025},
          {5405, 6000, 0.06},
          {6400, 8000, 0.06},
          {8000, 11000, 0.06},
          {11000, 17800, 0.06}}},
        {Gas::CO2,
         13,
         409e-6,
         {{700, 800, 0.015},
          {800, 1200, 0.025},
          {1200, 2000, 0.03},
          {2000, 2300, 0.01},
          {2300, 2500, 0.005, 0.02},
          // The wing beyond the band head, without line mixing.
          {2390, 2420, 0.011, 0.02},
          {2500, 3340, 0.025},
          {3340, 4000, 0.015},
          {4000, 5200, 0.025},
          {5200, 10000, 0.025}}},
        {Gas::O3,
         4,
         0.0287119e-6,
         {{660, 980, 0.025},
          {983, 1275, 0.001, 0.003},
          {1630, 2295, 0.0002, 0.001},
          {2670, 3260, 0.06}}},
        {Gas::N2O,
         16,
         0.32e-6,
         {{660, 2000, 0.025},
          // The rarer isotopologues below the main band: 0.012 without them.
          {2110, 2178, 0.004, 0.03},
          {2000, 5200, 0.025}}},
        {Gas::CO, 14, 0.15e-6, {{2000, 2300, 0.025}, {4000, 4400, 0.025}}},
        {Gas::CH4,
         15,
         1.7e-6,
         {{800, 1200, 0.025},
          {1200, 1775, 0.005, 0.03},
          {1250, 1400, 0.01, 0.03},
          {2000, 2500, 0.002},
          {2500, 2833, 0.005},
          // The Q branch of 13CH4: 0.03 without it.
          {2990, 3050, 0.008, 0.03},
          {2833, 4100, 0.025},
          {4100, 4690, 0.06},
          {5865, 6135, 0.06}}},
        {Gas::O2, 17, 0.20916, {{7700, 8100, 0.025}, {12900, 13250, 0.025}}},
    };
}

/// What the run counts with the lines of a gas: oxygen's collision-induced absorption, whose band
/// at 1.27 um was fitted to this very column.
double besideLines(Gas gas, double wavenumber_per_cm) {
    if (gas != Gas::O2) {
        return 1.0;
    }
    return std::exp(-5e3 * continuumAbsorption_per_m(Continuum::oxygen, PublishedRun::air(),
                                                     wavenumber_per_cm));
}

TEST(CompleteLines, TransmitAsAPublishedRunOfMODTRANGasByGas) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    if (data.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const auto rows = modtranColumns(data / "modtran" / "pyradi" / "horizon5kmtropical.fl7");
    ASSERT_GT(rows.size(), 3000u);
    const PartitionSums partition = PartitionSums::read(data / "lines" / "partition");

    for (const Case& gas : cases()) {
        const LineList list = completeLineList(gas.gas, data);
        const std::string name = gasNames[static_cast<std::size_t>(gas.gas)];
        EXPECT_TRUE(std::ranges::is_sorted(list.lines, {}, &Line::wavenumber_per_cm)) << name;
        EXPECT_FALSE(list.origins.empty()) << name;
        for (const Range& range : gas.ranges) {
            WavenumberGrid grid{range.from_per_cm - 11.0, 0.01, 0};
            grid.count =
                static_cast<std::size_t>((range.to_per_cm - range.from_per_cm + 22.0) / 0.01);
            const SlitMean slit(grid,
                                crossSection_cm2(list, partition, grid, temperature_K, pressure_hPa,
                                                 gas.fraction, defaultLineShape(gas.gas)),
                                gas.fraction * air_per_cm2);
            double squares = 0.0, count = 0.0, ours = 0.0, theirs = 0.0, worst = 0.0;
            for (const auto& row : rows) {
                if (row[0] < range.from_per_cm || row[0] > range.to_per_cm) {
                    continue;
                }
                const double value = slit.at(row[0]) * besideLines(gas.gas, row[0]);
                squares += (value - row[gas.column]) * (value - row[gas.column]);
                worst = std::max(worst, std::abs(value - row[gas.column]));
                ours += value;
                theirs += row[gas.column];
                count += 1.0;
            }
            EXPECT_LT(std::sqrt(squares / count), range.rms)
                << name << " at " << range.from_per_cm << "-" << range.to_per_cm << ": mean "
                << ours / count << ", published " << theirs / count;
            EXPECT_LT(worst, range.worst) << name << " at " << range.from_per_cm;
        }
    }
}

// Three bands far from the wing beyond 2390 cm-1: 12.5, 10.4 and 2.03 um.
TEST(CompleteLines, TellTheCarbonDioxideOfTheRun) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    if (data.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const auto rows = modtranColumns(data / "modtran" / "pyradi" / "horizon5kmtropical.fl7");
    const PartitionSums partition = PartitionSums::read(data / "lines" / "partition");
    const LineList list = completeLineList(Gas::CO2, data);
    for (const auto& [from_per_cm, to_per_cm] :
         {std::pair{770.0, 840.0}, std::pair{915.0, 995.0}, std::pair{4900.0, 4940.0}}) {
        const WavenumberGrid grid{from_per_cm - 11.0, 0.01,
                                  static_cast<std::size_t>((to_per_cm - from_per_cm + 22.0) * 100)};
        const std::vector<double> cross_cm2 = crossSection_cm2(
            list, partition, grid, temperature_K, pressure_hPa, 409e-6, defaultLineShape(Gas::CO2));
        double best_ppmv = 0.0, least = 1.0;
        for (int i = 360; i <= 450; ++i) {
            const double ppmv = i;
            const SlitMean slit(grid, cross_cm2, ppmv * 1e-6 * air_per_cm2);
            double squares = 0.0, count = 0.0;
            for (const auto& row : rows) {
                if (row[0] < from_per_cm || row[0] > to_per_cm) {
                    continue;
                }
                squares += std::pow(slit.at(row[0]) - row[13], 2.0);
                count += 1.0;
            }
            if (const double rms = std::sqrt(squares / count); rms < least) {
                least = rms;
                best_ppmv = ppmv;
            }
        }
        EXPECT_NEAR(best_ppmv, 409.0, 3.0) << from_per_cm;
        EXPECT_LT(least, 0.001) << from_per_cm;
    }
}

TEST(CompleteLines, CountEveryLineOfCarbonDioxideOnce) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    if (data.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const LineList original = readLineList(Gas::CO2, data / "lines" / "CO2.par.gz");
    const LineList complete = completeLineList(Gas::CO2, data);
    auto sum = [](const LineList& list, double from_per_cm, double to_per_cm,
                  std::optional<int> only) {
        double total = 0.0;
        for (const Line& line : list.lines) {
            if (line.wavenumber_per_cm >= from_per_cm && line.wavenumber_per_cm < to_per_cm &&
                (!only || line.isotopologue == *only)) {
                total += line.intensity;
            }
        }
        return total;
    };
    // The main isotopologue is complete there already; the others are 1.6 percent of all.
    EXPECT_NEAR(sum(complete, 2000, 2400, 1) / sum(original, 2000, 2400, 1), 1.0, 2e-3);
    EXPECT_NEAR(sum(complete, 2000, 2400, {}) / sum(original, 2000, 2400, {}), 1.016, 3e-3);
    // 13C16O2 and 16O12C17O at 4.3 um (Lamouroux et al. 2010, the first 4 percent up since).
    EXPECT_NEAR(sum(complete, 2200, 2350, 2) / 1.05e-18, 1.0, 0.02);
    EXPECT_NEAR(sum(complete, 2200, 2350, 4) / 4.88e-20, 1.0, 0.02);
    // 10011 and 10012 from the ground state: 1.5e-18 and 1.0e-18 (Lamouroux et al. 2010).
    EXPECT_NEAR(sum(complete, 3500, 3800, 1) / 2.7e-18, 1.0, 0.05);
    EXPECT_NEAR(sum(complete, 4900, 5100, {}) / sum(original, 4900, 5100, {}), 1.0, 1e-3);
}

TEST(CompleteLines, AreNotThereForAGasWithoutLinesOrWithoutFiles) {
    EXPECT_THROW((void)completeLineList(Gas::HNO3, "nowhere"), LogicError);
    EXPECT_THROW((void)completeLineList(Gas::CO2, "nowhere"), InputError);
    EXPECT_THROW((void)completeLineLists("nowhere"), InputError);
}

} // namespace
} // namespace irsg::lbl

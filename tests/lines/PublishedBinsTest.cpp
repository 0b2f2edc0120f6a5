#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lines/BandModel.h"
#include "tests/lines/ModtranColumns.h"
#include "tests/support/SharedMaterial.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"
#include "tools/atmosphere-tables/lines/Voigt.h"

// What the bins of MODTRAN's band model make of our lines, where its columns differ from them line
// by line.

namespace irsg::lbl {
namespace {

constexpr double boltzmann_J_K = 1.380649e-23;

struct Differences {
    double squares = 0.0, worst = 0.0;
    int count = 0;

    void add(double difference) {
        squares += difference * difference;
        if (std::abs(difference) > std::abs(worst)) {
            worst = difference;
        }
        ++count;
    }
    double rms() const { return std::sqrt(squares / count); }
};

GasPath levelPath(double temperature_K, double pressure_hPa, double fraction, double length_m) {
    return {temperature_K, pressure_hPa, fraction,
            fraction * 1e-4 * pressure_hPa * 100.0 / (boltzmann_J_K * temperature_K) * length_m};
}

/// Differences from a column of a run, line by line and by bins.
struct Comparison {
    Differences lines, bins;
};

Comparison compare(const std::vector<std::vector<double>>& rows, std::size_t column,
                   const LineList& list, const PartitionSums& partition, const GasPath& path,
                   double from_per_cm, double to_per_cm, bool slit) {
    const double step_per_cm = slit ? 0.01 : 0.0025;
    WavenumberGrid grid{from_per_cm - 11.0, step_per_cm,
                        static_cast<std::size_t>((to_per_cm - from_per_cm + 22.0) / step_per_cm)};
    const SlitMean fine(grid,
                        crossSection_cm2(list, partition, grid, path.temperature_K,
                                         path.pressure_hPa, path.fraction,
                                         defaultLineShape(list.gas)),
                        path.column_per_cm2);
    const BandModel bins(list, partition, path);
    Comparison comparison;
    for (const auto& row : rows) {
        if (row[0] < from_per_cm || row[0] > to_per_cm) {
            continue;
        }
        const int nu = static_cast<int>(std::lround(row[0]));
        comparison.lines.add((slit ? fine.at(row[0]) : fine.box(row[0] - 0.5)) - row[column]);
        comparison.bins.add((slit ? bins.at(nu) : bins.bin(nu)) - row[column]);
    }
    std::printf("%s %.0f-%.0f cm-1: line by line %.4f rms, %+.4f worst; by bins %.4f, %+.4f\n",
                std::string(gasNames[static_cast<std::size_t>(list.gas)]).c_str(), from_per_cm,
                to_per_cm, comparison.lines.rms(), comparison.lines.worst, comparison.bins.rms(),
                comparison.bins.worst);
    return comparison;
}

// A line in the middle of its bin, alone: its own bin is that of a Voigt line, the next one that of
// its tail; far from the middle the tail is too weak, as rule has it.
TEST(PublishedBins, OfASingleLineAreThoseOfItsProfile) {
    LineList list{Gas::CO, {}, {}};
    Line line;
    line.intensity = 1e-20;
    line.widthExponent = 0.7f;
    const GasPath path{296.0, 1013.25, 0.0, 3e19};
    auto mean = [&](double lower_per_cm) {
        const VoigtProfile profile(3.581163e-7 * line.wavenumber_per_cm *
                                       std::sqrt(296.0 / molarMass_g(Gas::CO, 1)),
                                   static_cast<double>(line.airWidth_cm_atm));
        double sum = 0.0;
        for (int i = 0; i < 1000; ++i) {
            sum += std::exp(-0.3 *
                            profile.at(lower_per_cm + (i + 0.5) / 1000.0 - line.wavenumber_per_cm));
        }
        return sum / 1000.0;
    };
    for (const double nu : {2100.0, 2100.2, 2099.7}) {
        line.wavenumber_per_cm = nu;
        list.lines = {line};
        const BandModel bins(list, PartitionSums::rigidRotor(), path);
        for (const int centre : {2098, 2099, 2100, 2101, 2102}) {
            EXPECT_NEAR(bins.bin(centre), mean(centre - 0.5), 2e-4) << nu << " " << centre;
        }
    }
    line.wavenumber_per_cm = 2100.48;
    list.lines = {line};
    const BandModel bins(list, PartitionSums::rigidRotor(), path);
    EXPECT_GT(bins.bin(2101), mean(2100.5) + 0.03);
}

// Equal lines that stand apart overlap at random; a weak one counts for more far from a strong one.
TEST(PublishedBins, CountWeakLinesLessNearStrongOnes) {
    Line line;
    line.wavenumber_per_cm = 2100.0;
    line.intensity = 1e-20;
    const GasPath path{296.0, 1013.25, 0.0, 2e20};
    auto bin = [&](const Line& one, const Line& other) {
        return BandModel({Gas::CO, {one, other}, {}}, PartitionSums::rigidRotor(), path).bin(2100);
    };
    Line none = line, before = line, after = line, weak = line, more = line;
    none.intensity = 0.0;
    before.wavenumber_per_cm -= 0.25;
    after.wavenumber_per_cm += 0.25;
    const LineList apart{Gas::CO, {before, after}, {}};
    EXPECT_NEAR(BandModel(apart, PartitionSums::rigidRotor(), path).bin(2100),
                std::pow(bin(line, none), 2.0), 1e-9);
    weak.intensity *= 0.01;
    more.intensity *= 1.01;
    const double beside = bin(line, weak);
    EXPECT_NEAR(beside, bin(more, none), 0.003);
    weak.wavenumber_per_cm += 0.3;
    EXPECT_LT(bin(line, weak), beside - 0.02);
}

// 2 km at 2 km of US standard air, 275.15 K and 795 hPa, in single bins. Neither amount is stated;
// both are those that fit best. The lines of both gases are HITRAN's own there.
TEST(PublishedBins, OfOneWavenumberLoseTailsThatBeginNearTheirEdges) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    if (data.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const auto rows = modtranColumns(data / "modtran" / "pyradi" / "tape7-01");
    ASSERT_EQ(rows.size(), 51u);
    const PartitionSums partition = PartitionSums::read(data / "lines" / "partition");
    const Comparison monoxide =
        compare(rows, 14, completeLineList(Gas::CO, data), partition,
                levelPath(275.15, 795.0, 0.1425e-6, 2000.0), 2050.0, 2100.0, false);
    EXPECT_GT(monoxide.lines.rms(), 7e-4);
    EXPECT_LT(monoxide.bins.rms(), 5e-4);
    const LineList dioxide = completeLineList(Gas::CO2, data);
    // Line by line 390 ppmv fit best, by bins 372.
    EXPECT_GT(compare(rows, 13, dioxide, partition, levelPath(275.15, 795.0, 390e-6, 2000.0),
                      2050.0, 2100.0, false)
                  .lines.rms(),
              0.011);
    EXPECT_LT(compare(rows, 13, dioxide, partition, levelPath(275.15, 795.0, 372e-6, 2000.0),
                      2050.0, 2100.0, false)
                  .bins.rms(),
              0.008);
}

// 5 km of tropical air, two bands of N2O and CO, with the same three numbers: bins leave half of
// what line by line differs, in the interval that has generated isotopologues as where all is
// listed.
TEST(PublishedBins, MakeTheRunOfTheLinesOfNitrousOxideAndCarbonMonoxide) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    if (data.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const auto rows = modtranColumns(data / "modtran" / "pyradi" / "horizon5kmtropical.fl7");
    ASSERT_GT(rows.size(), 3000u);
    const PartitionSums partition = PartitionSums::read(data / "lines" / "partition");
    const LineList nitrous = completeLineList(Gas::N2O, data);
    const GasPath path = levelPath(299.7, 1013.0, 0.32e-6, 5000.0);
    struct Band {
        double from_per_cm, to_per_cm, bins, lines;
    };
    for (const Band& band : {Band{2140.0, 2220.0, 0.005, 0.006}, Band{2180.0, 2280.0, 0.007, 0.011},
                             Band{1240.0, 1320.0, 0.005, 0.006}}) {
        const Comparison comparison =
            compare(rows, 16, nitrous, partition, path, band.from_per_cm, band.to_per_cm, true);
        EXPECT_LT(comparison.bins.rms(), band.bins) << band.from_per_cm;
        EXPECT_LT(std::abs(comparison.bins.worst), 0.02) << band.from_per_cm;
        EXPECT_GT(comparison.lines.rms(), band.lines) << band.from_per_cm;
    }
    const Comparison monoxide =
        compare(rows, 14, completeLineList(Gas::CO, data), partition,
                levelPath(299.7, 1013.0, 0.15e-6, 5000.0), 2050.0, 2250.0, true);
    EXPECT_LT(monoxide.bins.rms(), 0.002);
    EXPECT_GT(monoxide.lines.rms(), 0.002);
}

// Methane at 7.7 um is generated, at 3.3 um listed. Line by line both absorb more than the run
// where the R branch ends, and by the same share of what they absorb: 3 percent at J of about 8, 9
// percent at 11. That lines are generated is not what differs there.
TEST(PublishedBins, OfMethaneDifferAlikeWhereItIsGeneratedAndWhereItIsListed) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    if (data.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const auto rows = modtranColumns(data / "modtran" / "pyradi" / "horizon5kmtropical.fl7");
    const PartitionSums partition = PartitionSums::read(data / "lines" / "partition");
    const LineList methane = completeLineList(Gas::CH4, data);
    const GasPath path = levelPath(299.7, 1013.0, 1.7e-6, 5000.0);
    std::vector<std::vector<double>> shares;
    for (const double first_per_cm : {1352.0, 3117.0}) {
        const WavenumberGrid grid{first_per_cm - 11.0, 0.01, 4200};
        const SlitMean fine(grid,
                            crossSection_cm2(methane, partition, grid, path.temperature_K,
                                             path.pressure_hPa, path.fraction,
                                             defaultLineShape(Gas::CH4)),
                            path.column_per_cm2);
        std::vector<double>& of = shares.emplace_back();
        for (const auto& row : rows) {
            if (row[0] >= first_per_cm && row[0] <= first_per_cm + 20.0) {
                of.push_back((row[15] - fine.at(row[0])) / (1.0 - row[15]));
            }
        }
        ASSERT_EQ(of.size(), 5u);
        std::printf("CH4 from %.0f cm-1: %.3f %.3f %.3f %.3f %.3f of the absorption more\n",
                    first_per_cm, of[0], of[1], of[2], of[3], of[4]);
    }
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(shares[0][i], shares[1][i], 0.025) << i;
        EXPECT_GT(shares[1][i], 0.02) << i;
    }
}

} // namespace
} // namespace irsg::lbl

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "tests/support/SharedMaterial.h"
#include "tools/atmosphere-tables/lines/CarbonDioxideLines.h"
#include "tools/atmosphere-tables/lines/CompleteLines.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"
#include "tools/atmosphere-tables/lines/NitrousOxideLines.h"

namespace irsg::lbl {
namespace {

std::filesystem::path sharedLines() {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    return data.empty() ? data : data / "lines";
}

// A rigid rotor whose B is that of the main one times 0.9, at its own origin.
TEST(RareIsotopologues, MoveAsTheLinesOfAnotherRotor) {
    const double B = 0.42, upper = 0.4165, r = 0.9, origin = 2223.0, other = 2180.0;
    const double q = r * r * origin / other;
    const RareIsotopologue to{3, 0.004, other, r * B, origin, B, upper + B, upper - B};
    for (const int J : {0, 3, 20, 45}) {
        for (const bool up : {true, false}) {
            if (J == 0 && !up) {
                continue;
            }
            AssignedLine line;
            line.J = J;
            line.m = up ? J + 1 : -J;
            const double m = line.m;
            line.line.wavenumber_per_cm = origin + (upper + B) * m + (upper - B) * m * m;
            line.line.lowerEnergy_per_cm = B * J * (J + 1.0);
            line.line.intensity = 1e-20 * std::exp(-1.438776877 * B * J * (J + 1.0) / 296.0);
            const Line moved = movedLine(line, to);
            EXPECT_NEAR(moved.wavenumber_per_cm,
                        other + r * (upper + B) * m + q * (upper - B) * m * m, 1e-9);
            EXPECT_NEAR(moved.lowerEnergy_per_cm, r * B * J * (J + 1.0), 1e-9);
            EXPECT_NEAR(moved.intensity / (1e-20 * 0.004 * r *
                                           std::exp(-1.438776877 * r * B * J * (J + 1.0) / 296.0)),
                        1.0, 1e-12);
            EXPECT_EQ(moved.isotopologue, 3);
        }
    }
}

// The sum over a band goes with the abundance: what a smaller B takes from a line it gives to more.
TEST(RareIsotopologues, OfNitrousOxideHaveTheStrengthOfTheirAbundance) {
    const auto folder = sharedLines();
    if (folder.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const auto texts = readTextLines(folder / "N2O.par.gz");
    double main = 0.0;
    for (const AssignedLine& line : assignedLines(texts, 1, 2000.0, 2400.0)) {
        main += line.line.intensity;
    }
    EXPECT_NEAR(main / 5.9e-17, 1.0, 0.05) << "nu3 with its hot bands";
    std::map<int, double> sums, positions;
    for (const Line& line : rareNitrousOxide(texts)) {
        sums[line.isotopologue] += line.intensity;
        positions[line.isotopologue] += line.intensity * line.wavenumber_per_cm;
    }
    const double abundances[] = {3.64093e-3, 3.64093e-3, 1.98582e-3, 3.6928e-4};
    const double origins_per_cm[] = {2177.66, 2201.61, 2216.71, 2220.07};
    ASSERT_EQ(sums.size(), 4u);
    for (int i = 0; i < 4; ++i) {
        EXPECT_NEAR(sums[i + 2] / (main * abundances[i] / 0.990333), 1.0, 0.05) << i + 2;
        // The middle of a band with its hot bands stands a little below its origin.
        EXPECT_NEAR(positions[i + 2] / sums[i + 2], origins_per_cm[i] - 2.5, 2.0) << i + 2;
    }
}

// 1000-0110, where the list has all of them: with the origins of the list itself the rule for B
// places the lines of the P and R branches.
TEST(RareIsotopologues, OfNitrousOxideAreWhereTheListHasThemAll) {
    const auto folder = sharedLines();
    if (folder.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    // From the assigned lines of 1000-0110 of each: origin, B of 0110 and of 1000.
    struct Band {
        int number;
        double origin_per_cm, lower_per_cm;
    };
    constexpr double origin_per_cm = 696.13622, lower_per_cm = 0.4191831, upper_per_cm = 0.4172575;
    for (const Band& band : {Band{2, 704.92053, 0.4191083}, Band{3, 684.58069, 0.4050545},
                             Band{4, 662.65878, 0.3958045}, Band{5, 678.34280, 0.4068687}}) {
        const RareIsotopologue to{
            band.number,   1.0,          band.origin_per_cm,          band.lower_per_cm,
            origin_per_cm, lower_per_cm, upper_per_cm + lower_per_cm, upper_per_cm - lower_per_cm};
        double squares = 0.0;
        int count = 0;
        std::map<std::pair<char, int>, double> main, rare;
        for (const std::string& text : readTextLines(folder / "N2O.par.gz")) {
            const double nu = std::strtod(text.substr(3, 12).c_str(), nullptr);
            if (nu < 650.0 || nu > 750.0 || text.find("1 0 0 0", 67) > 78 ||
                text.find("0 1 1 0", 82) > 93) {
                continue;
            }
            const std::size_t at = text.find_first_of("PR", 112);
            if (at >= 127) {
                continue;
            }
            const std::pair key{text[at], std::atoi(text.c_str() + at + 1)};
            if (text[2] == '1') {
                main[key] = nu;
            }
            if (text[2] == static_cast<char>('0' + band.number)) {
                rare[key] = nu;
            }
        }
        for (const auto& [key, nu] : main) {
            const auto known = rare.find(key);
            if (known == rare.end() || key.second > 40) {
                continue;
            }
            AssignedLine line;
            line.J = key.second;
            line.m = key.first == 'P' ? -line.J : line.J + 1;
            line.line.wavenumber_per_cm = nu;
            const double off = movedLine(line, to).wavenumber_per_cm - known->second;
            squares += off * off;
            ++count;
        }
        ASSERT_GT(count, 20) << band.number;
        std::printf("N2O isotopologue %d, 1000-0110: %d lines, positions to %.4f cm-1 rms\n",
                    band.number, count, std::sqrt(squares / count));
        // A resonance with 0200 that differs from one to another moves this band by as much.
        EXPECT_LT(std::sqrt(squares / count), 0.12) << band.number;
    }
}

// 20 km at 10 km of US standard air, 223.3 K, 265 hPa and 0.3179 ppmv, and longer paths: what the
// four take from the transmittance that the main isotopologue leaves, over 2140 to 2220 cm-1.
TEST(RareIsotopologues, OfNitrousOxideTakeOneToFiveHundredthsOfALevelPathAtTenKilometres) {
    const auto folder = sharedLines();
    if (folder.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    LineList all = completeLineList(Gas::N2O, folder.parent_path()), main = all;
    std::erase_if(main.lines, [](const Line& line) { return line.isotopologue != 1; });
    const PartitionSums partition = PartitionSums::read(folder / "partition");
    const WavenumberGrid grid{2140.0, 0.002, 40000};
    auto cross = [&](const LineList& list) {
        return crossSection_cm2(list, partition, grid, 223.3, 265.0, 0.3179e-6,
                                defaultLineShape(Gas::N2O));
    };
    const std::vector<double> withAll = cross(all), withMain = cross(main);
    struct Loss {
        double mean, worst;
    };
    auto lossOf = [&](double length_m, double bin_per_cm) {
        const double column_per_cm2 =
            0.3179e-6 * 26500.0 / (1.380649e-23 * 223.3) * length_m * 1e-4;
        const auto count = static_cast<std::size_t>(std::lround(bin_per_cm / grid.step_per_cm));
        Loss loss{0.0, 0.0};
        for (std::size_t first = 0; first < grid.count; first += count) {
            double bin = 0.0;
            for (std::size_t i = first; i < first + count; ++i) {
                bin += (std::exp(-column_per_cm2 * withMain[i]) -
                        std::exp(-column_per_cm2 * withAll[i])) /
                       static_cast<double>(count);
            }
            loss.mean += bin * static_cast<double>(count) / static_cast<double>(grid.count);
            loss.worst = std::max(loss.worst, bin);
        }
        std::printf("N2O, %.0f km at 10 km, %.0f cm-1: %.4f lost on the average, %.4f at most\n",
                    length_m / 1000.0, bin_per_cm, loss.mean, loss.worst);
        return loss;
    };
    EXPECT_NEAR(lossOf(20e3, 10.0).mean, 0.0186, 0.0010);
    EXPECT_NEAR(lossOf(20e3, 10.0).worst, 0.036, 0.002);
    EXPECT_NEAR(lossOf(20e3, 1.0).worst, 0.052, 0.003);
    EXPECT_NEAR(lossOf(50e3, 10.0).mean, 0.033, 0.002);
    EXPECT_NEAR(lossOf(100e3, 10.0).mean, 0.048, 0.002);
}

TEST(RareIsotopologues, OfMethaneHaveTheirQBranchWhereHitranHasIt) {
    const auto folder = sharedLines();
    if (folder.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const LineList list = readLineList(Gas::CH4, folder / "CH4.par.gz");
    const auto middle = [](const auto& lines) {
        double sum = 0.0, moment = 0.0;
        for (const auto& line : lines) {
            if (line.wavenumber_per_cm > 3007.0 && line.wavenumber_per_cm < 3010.1 &&
                line.intensity > 3e-23) {
                sum += line.intensity;
                moment += line.intensity * line.wavenumber_per_cm;
            }
        }
        return std::pair{sum, moment / sum};
    };
    std::vector<BareLine> bare = readBareLines(folder / "extra" / "CH4_nu_S_2000-3333.txt.gz");
    std::erase_if(bare, [](const BareLine& line) {
        return line.wavenumber_per_cm < 3000.0 || line.wavenumber_per_cm > 3015.0;
    });
    std::vector<Line> near = list.lines;
    std::erase_if(near, [](const Line& line) {
        return line.wavenumber_per_cm < 2999.0 || line.wavenumber_per_cm > 3030.0;
    });
    const auto found = middle(missingLines(bare, near));
    const auto moved = middle(heavyMethane(near));
    std::printf("Q branch of 13CH4: %.3f cm-1 and %.3g in the list, %.3f and %.3g moved\n",
                found.second, found.first, moved.second, moved.first);
    EXPECT_NEAR(moved.second, found.second, 0.2);
    // The list's are found between those of 12CH4, where not all can be told apart.
    EXPECT_NEAR(moved.first / found.first, 1.0, 0.35);
}

} // namespace
} // namespace irsg::lbl

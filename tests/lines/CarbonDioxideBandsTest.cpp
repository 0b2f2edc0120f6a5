#include <cmath>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/CarbonDioxideBands.h"
#include "tools/atmosphere-tables/lines/CarbonDioxideLines.h"

namespace irsg::lbl {
namespace {

struct State {
    const char* name;
    double G, B, D;
};
// Levels of 16O12C16O, cm-1 (Rothman et al. 1992, J. Quant. Spectrosc. Radiat. Transfer 48, 537).
constexpr State ground = {"00001", 0.0, 0.39021894, 1.33373e-7};
constexpr State bend = {"01101", 667.3801, 0.3906389, 1.3526e-7};
constexpr State stretch = {"00011", 2349.1429, 0.38714139, 1.33034e-7};

double energy_per_cm(const State& state, int J) {
    const double x = J * (J + 1);
    return state.G + state.B * x - state.D * x * x;
}

std::string spaced(const std::string& state) { // " 2 2 2 02", as HITRAN writes 22202
    return std::string("       ") + state[0] + " " + state[1] + " " + state[2] + " " + state[3] +
           state[4];
}

std::string record(int isotopologue, const State& upper, const State& lower, char branch, int J) {
    const int step = branch == 'P' ? -1 : branch == 'R' ? 1 : 0;
    char text[200];
    std::snprintf(
        text, sizeof text,
        " 2%d%12.6f %9.3E %9.3E.%04d%5.3f%10.4f%4.2f-.002000%15s%15s%15s     %c%3d%c     ",
        isotopologue, energy_per_cm(upper, J + step) - energy_per_cm(lower, J), 1e-20, 1.0,
        900 - 5 * J, 0.1, energy_per_cm(lower, J), 0.7, spaced(upper.name).c_str(),
        spaced(lower.name).c_str(), "", branch, J, 'e');
    return text;
}

/// Every second line to J = 60 of the bands 00011-00001 and 01101-00001, and some without quanta.
CarbonDioxideLevels someLevels(int isotopologue = 1) {
    std::vector<std::string> records(20, record(1, stretch, ground, 'R', 2).substr(0, 67));
    for (int J = 0; J <= 60; J += 2) {
        for (const char branch : {'P', 'R'}) {
            if (J + (branch == 'P' ? -1 : 1) > 0) {
                for (const State& upper : {stretch, bend}) {
                    records.push_back(record(isotopologue, upper, ground, branch, J));
                }
            }
        }
        if (J > 0) {
            records.push_back(record(isotopologue, bend, ground, 'Q', J));
        }
    }
    return CarbonDioxideLevels(records, "records");
}

double sumOf(const std::vector<Line>& lines) {
    double sum = 0.0;
    for (const Line& line : lines) {
        sum += line.intensity;
    }
    return sum;
}

const Line* nearest(const std::vector<Line>& lines, double wavenumber_per_cm) {
    const Line* best = nullptr;
    for (const Line& line : lines) {
        if (!best || std::abs(line.wavenumber_per_cm - wavenumber_per_cm) <
                         std::abs(best->wavenumber_per_cm - wavenumber_per_cm)) {
            best = &line;
        }
    }
    return best;
}

TEST(CarbonDioxideBands, HaveTheLinesOfTheFundamentalWhereTheyWereMeasured) {
    const auto lines = bandLines({1, "00011", "00001", 9.2e-17}, someLevels());
    // HITRAN: R(0), R(20), P(2), P(20), P(60).
    for (const double known_per_cm : {2349.9171, 2364.1055, 2347.5763, 2332.3690, 2291.5417}) {
        ASSERT_NE(nearest(lines, known_per_cm), nullptr);
        EXPECT_NEAR(nearest(lines, known_per_cm)->wavenumber_per_cm, known_per_cm, 0.05)
            << known_per_cm;
    }
    // R(16) is the strongest, 3.5e-18 (HITRAN).
    const Line* strongest = &lines.front();
    for (const Line& line : lines) {
        if (line.intensity > strongest->intensity) {
            strongest = &line;
        }
    }
    EXPECT_NEAR(strongest->lowerEnergy_per_cm, 0.39022 * 16 * 17, 0.1);
    EXPECT_NEAR(strongest->intensity, 3.5e-18, 0.15e-18);
    EXPECT_NEAR(strongest->airWidth_cm_atm, 0.0900 - 0.0005 * 17, 1e-3);
}

TEST(CarbonDioxideBands, KeepTheStrengthOfTheBand) {
    for (const char* upper : {"00011", "01101"}) {
        EXPECT_NEAR(sumOf(bandLines({1, upper, "00001", 3e-19}, someLevels())) / 3e-19, 1.0, 1e-12);
    }
}

TEST(CarbonDioxideBands, HaveEveryLevelOnlyWhereTheOxygensDiffer) {
    std::map<int, std::size_t> counts;
    for (const int isotopologue : {1, 2, 3, 4}) {
        for (const Line& line :
             bandLines({isotopologue, "00011", "00001", 1e-18}, someLevels(isotopologue))) {
            counts[isotopologue] += line.lowerEnergy_per_cm < 0.39 * 40 * 41;
        }
    }
    EXPECT_EQ(counts[1], 39u); // J = 0 has no P line; 2, 4 ... 38 have both, 40 lies above
    EXPECT_EQ(counts[2], counts[1]);
    EXPECT_EQ(counts[3], 79u);
    EXPECT_EQ(counts[4], counts[3]);
}

TEST(CarbonDioxideBands, HaveAQBranchWhereTheBendingChanges) {
    std::size_t near = 0;
    double strength = 0.0;
    for (const Line& line : bandLines({1, "01101", "00001", 1.0}, someLevels())) {
        if (std::abs(line.wavenumber_per_cm - 668.0) < 1.4 && line.lowerEnergy_per_cm > 2.0) {
            ++near;
            strength += line.intensity;
        }
    }
    EXPECT_GT(near, 25u);
    EXPECT_NEAR(strength, 0.5, 0.05);
    for (const Line& line : bandLines({1, "00011", "00001", 1.0}, someLevels())) {
        EXPECT_GT(std::abs(line.wavenumber_per_cm - stretch.G), 0.7);
    }
}

TEST(CarbonDioxideBands, AreNothingWhereAStateIsNotKnown) {
    EXPECT_TRUE(bandLines({1, "10012", "00001", 1e-18}, someLevels()).empty());
    EXPECT_TRUE(bandLines({2, "00011", "00001", 1e-18}, someLevels()).empty());
}

TEST(HoenlLondonFactors, OfOneLevelSumToItsWeight) {
    for (const auto& [lower, upper] :
         {std::pair{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {1, 0}, {2, 1}}) {
        for (int J = lower + 2; J < 60; ++J) {
            double sum = 0.0;
            for (const int branch : {-1, 0, 1}) {
                sum += hoenlLondonFactor(branch, J, lower, upper);
            }
            const double expected = lower == upper ? 2.0 * J + 1.0 : 2.0 * (2.0 * J + 1.0);
            EXPECT_NEAR(sum / expected, 1.0, 1e-12) << lower << " " << upper << " " << J;
        }
    }
    EXPECT_EQ(hoenlLondonFactor(-1, 0, 0, 0), 0.0);
    EXPECT_EQ(hoenlLondonFactor(0, 5, 0, 0), 0.0);
    EXPECT_EQ(hoenlLondonFactor(-1, 1, 0, 1), 0.0);
}

TEST(RotationalTerm, FollowsLevelsAndPassesOverPerturbedOnes) {
    std::map<int, double> energies_per_cm;
    for (int J = 1; J < 60; J += 2) {
        energies_per_cm[J] = energy_per_cm(stretch, J);
    }
    energies_per_cm[31] += 0.5;
    const auto term = RotationalTerm::fit(energies_per_cm);
    ASSERT_TRUE(term);
    EXPECT_EQ(term->highestJ(), 59);
    for (const int J : {0, 20, 31, 70}) {
        EXPECT_NEAR(term->energy_per_cm(J), energy_per_cm(stretch, J), 1e-3) << J;
    }
    EXPECT_FALSE(RotationalTerm::fit({{0, 0.0}, {2, 2.0}, {4, 8.0}}));
}

TEST(BandList, AddsTheHalvesOfABand) {
    const auto bands = readCarbonDioxideBands(
        {"10001100001    0.9E-16  1416.4  3313.8  124  -1 124", "30001100001I   0.2E-18  1 2 3 4 5",
         "", "30001100001II  0.3E-18  1 2 3 4 5"},
        "bands");
    ASSERT_EQ(bands.size(), 2u);
    EXPECT_EQ(bands[0].upper, "00011");
    EXPECT_EQ(bands[0].lower, "00001");
    EXPECT_EQ(bands[1].isotopologue, 3);
    EXPECT_NEAR(bands[1].strength, 0.5e-18, 1e-24);
}

TEST(BandList, RefusesWhatIsNoBand) {
    const std::map<std::string, std::vector<std::string>> bad = {
        {"no band", {}},
        {"short code", {"100011 1e-20"}},
        {"no strength", {"10001100001"}},
        {"negative strength", {"10001100001 -1e-20"}},
        {"letters in the code", {"1000110000x 1e-20"}},
        {"unknown half", {"10001100001III 1e-20"}},
    };
    for (const auto& [name, lines] : bad) {
        EXPECT_THROW((void)readCarbonDioxideBands(lines, "bands"), InputError) << name;
    }
    EXPECT_THROW(CarbonDioxideLevels({"no record"}, "records"), InputError);
}

TEST(BareLines, TakeTheirPropertiesFromTheNearestGeneratedLine) {
    std::vector<Line> generated(3);
    for (std::size_t i = 0; i < 3; ++i) {
        generated[i].wavenumber_per_cm = 2300.0 + 0.004 * static_cast<double>(i);
        generated[i].intensity = i == 1 ? 1e-22 : 1e-24;
        generated[i].lowerEnergy_per_cm = 100.0 * static_cast<double>(i + 1);
        generated[i].isotopologue = static_cast<int>(i + 1);
    }
    Line otherwise;
    otherwise.lowerEnergy_per_cm = 1500.0;
    const std::vector<BareLine> bare = {{2300.001, 1.1e-22}, {2300.009, 0.9e-24}, {2301.0, 1e-22}};
    const auto described = describedLines(bare, generated, otherwise);
    ASSERT_EQ(described.size(), 3u);
    EXPECT_EQ(described[0].isotopologue, 2);
    EXPECT_EQ(described[1].isotopologue, 3);
    EXPECT_EQ(described[2].lowerEnergy_per_cm, 1500.0);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(described[i].wavenumber_per_cm, bare[i].wavenumber_per_cm);
        EXPECT_EQ(described[i].intensity, bare[i].intensity);
    }
}

TEST(BareLines, AreMissingOnlyWhereTheListLacksThem) {
    std::vector<Line> list(2);
    list[0].wavenumber_per_cm = 2300.0;
    list[0].intensity = 1e-22;
    list[1].wavenumber_per_cm = 2301.0;
    list[1].intensity = 1e-22;
    const std::vector<BareLine> bare = {
        {2300.0005, 1.05e-22}, {2300.0006, 1.05e-22}, {2301.0, 3e-22}, {2301.01, 1e-22}};
    const auto missing = missingLines(bare, list);
    ASSERT_EQ(missing.size(), 3u);
    EXPECT_EQ(missing[0].wavenumber_per_cm, 2300.0006); // the list's line stands for one of the two
    EXPECT_EQ(missing[1].intensity, 3e-22);
    EXPECT_EQ(missing[2].wavenumber_per_cm, 2301.01);
}

} // namespace
} // namespace irsg::lbl

// Lines that lists lack since nothing of them is seen at 296 K: carbon monoxide in closed form, hot
// bands of carbon dioxide.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/SharedMaterial.h"
#include "tools/atmosphere-tables/lines/CarbonDioxideBands.h"
#include "tools/atmosphere-tables/lines/CarbonDioxidePolyads.h"
#include "tools/atmosphere-tables/lines/CarbonMonoxideLines.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

using namespace irsg;
using namespace irsg::lbl;

namespace {

std::filesystem::path linesFolder() {
    return smat::test::sharedMaterial("data/atmosphere/lines");
}

const PolyadState& state(const std::vector<PolyadState>& polyad, int rank) {
    return polyad.at(static_cast<std::size_t>(rank - 1));
}

TEST(HotLines, OfCarbonMonoxideStandWhereSpectraHaveThem) {
    // R(0) and P(1) of 1-0: 2147.081 and 2139.426 cm-1; the origin of 1-0 is 2143.271 (NIST).
    const auto at = [](int v, int J, int upperJ) {
        return carbonMonoxideLevel_per_cm(v + 1, upperJ) - carbonMonoxideLevel_per_cm(v, J);
    };
    EXPECT_NEAR(at(0, 0, 1), 2147.0811, 0.003);
    EXPECT_NEAR(at(0, 1, 0), 2139.4261, 0.003);
    EXPECT_NEAR(carbonMonoxideLevel_per_cm(1, 0), 2143.2711, 0.003);
    EXPECT_NEAR(carbonMonoxideLevel_per_cm(2, 0), 4260.0622, 0.005);
    EXPECT_EQ(carbonMonoxideLevel_per_cm(0, 0), 0.0);
    // 13CO: the origin of 1-0 is 2096.067.
    EXPECT_NEAR(carbonMonoxideLevel_per_cm(1, 0, 0.977707), 2096.067, 0.05);
    // Hot bands move by 2 omega_e x_e less a part of omega_e y_e (Huber and Herzberg 1979).
    for (int v = 0; v < 10; ++v) {
        EXPECT_NEAR(at(v, 0, 0) - at(v + 1, 0, 0), 26.5766 - 6.0 * 0.01051 * (v + 1.5), 0.1) << v;
    }
}

TEST(HotLines, OfCarbonMonoxideAreThoseOfTheList) {
    if (linesFolder().empty()) {
        GTEST_SKIP() << "no shared material";
    }
    const LineList listed = readLineList(Gas::CO, linesFolder() / "CO.par.gz");
    const LineList made = carbonMonoxideLines();
    std::size_t compared = 0;
    double listedSum = 0.0, madeSum = 0.0;
    for (const Line& line : listed.lines) {
        if (line.wavenumber_per_cm < 1950.0 || line.wavenumber_per_cm > 2280.0 ||
            line.intensity < 1e-25 || line.isotopologue > 3) {
            continue;
        }
        const auto near = std::ranges::min_element(made.lines, {}, [&](const Line& other) {
            return std::abs(other.wavenumber_per_cm - line.wavenumber_per_cm) +
                   (other.isotopologue == line.isotopologue && other.intensity > 1e-26 ? 0.0 : 1e3);
        });
        EXPECT_NEAR(near->wavenumber_per_cm, line.wavenumber_per_cm, 0.06);
        EXPECT_NEAR(near->intensity, line.intensity, 0.03 * line.intensity)
            << line.wavenumber_per_cm << " of isotopologue " << line.isotopologue;
        EXPECT_NEAR(near->airWidth_cm_atm, line.airWidth_cm_atm, 0.1f * line.airWidth_cm_atm);
        listedSum += line.intensity;
        madeSum += near->intensity;
        ++compared;
    }
    EXPECT_GT(compared, 150u);
    EXPECT_NEAR(madeSum, listedSum, 0.003 * listedSum);
}

TEST(HotLines, PolyadsOfCarbonDioxideHaveItsLevels) {
    // Origins from the literature (L. S. Rothman et al. 1992, J. Quant. Spectrosc. Radiat. Transfer
    // 48, 537): 01101, 10002, 10001, 00011, 10012, 10011, 00021; 13CO2 00011.
    EXPECT_NEAR(state(carbonDioxidePolyad(1, 0, 1, 0), 1).energy_per_cm, 667.380, 0.2);
    EXPECT_NEAR(state(carbonDioxidePolyad(1, 1, 0, 0), 2).energy_per_cm, 1285.408, 0.2);
    EXPECT_NEAR(state(carbonDioxidePolyad(1, 1, 0, 0), 1).energy_per_cm, 1388.184, 0.2);
    EXPECT_NEAR(state(carbonDioxidePolyad(1, 0, 0, 1), 1).energy_per_cm, 2349.143, 0.2);
    EXPECT_NEAR(state(carbonDioxidePolyad(1, 1, 0, 1), 2).energy_per_cm, 3612.841, 0.2);
    EXPECT_NEAR(state(carbonDioxidePolyad(1, 1, 0, 1), 1).energy_per_cm, 3714.782, 0.2);
    EXPECT_NEAR(state(carbonDioxidePolyad(1, 0, 0, 2), 1).energy_per_cm, 4673.325, 0.3);
    EXPECT_NEAR(state(carbonDioxidePolyad(2, 0, 0, 1), 1).energy_per_cm, 2283.488, 0.5);
    EXPECT_NEAR(state(carbonDioxidePolyad(1, 0, 0, 0), 1).rotation_per_cm, 0.390219, 1e-4);
    EXPECT_NEAR(state(carbonDioxidePolyad(1, 0, 0, 1), 1).rotation_per_cm, 0.387141, 3e-4);
    for (const PolyadState& mixed : carbonDioxidePolyad(1, 5, 2, 1)) {
        double norm = 0.0;
        for (const double amplitude : mixed.amplitudes) {
            norm += amplitude * amplitude;
        }
        EXPECT_NEAR(norm, 1.0, 1e-12);
    }
}

TEST(HotLines, BandsOfCarbonDioxideHaveTheirStrengths) {
    const auto ground = state(carbonDioxidePolyad(1, 0, 0, 0), 1);
    const auto strength = [](int quanta, int l2, int rank, int more, int upperRank) {
        return polyadBandStrength(1, state(carbonDioxidePolyad(1, quanta + more, l2, 1), upperRank),
                                  state(carbonDioxidePolyad(1, quanta, l2, 0), rank));
    };
    // Lamouroux et al. 2010: 00011, 10011 and 10012 from the ground are what the dipoles are fitted
    // to, all others follow.
    EXPECT_NEAR(strength(0, 0, 1, 0, 1) / 9.153e-17, 1.0, 1e-3);
    EXPECT_NEAR(strength(0, 0, 1, 1, 1) / 1.504e-18, 1.0, 0.02);
    EXPECT_NEAR(strength(0, 1, 1, 1, 1) / 1.180e-19, 1.0, 0.03); // 11111-01101
    EXPECT_NEAR(strength(0, 2, 1, 0, 1) / 2.600e-19, 1.0, 0.05); // 02211-02201
    EXPECT_NEAR(strength(1, 0, 1, 0, 1) / 1.020e-19, 1.0, 0.05); // 10011-10001
    EXPECT_NEAR(strength(0, 4, 1, 0, 1) / 3.906e-22, 1.0, 0.05); // 04411-04401
    EXPECT_NEAR(strength(2, 1, 3, 0, 3) / 3.207e-23, 1.0, 0.05); // 21113-21103
    EXPECT_NEAR(strength(3, 0, 3, 0, 3) / 3.939e-25, 1.0, 0.05); // 30013-30003
    EXPECT_EQ(polyadBandStrength(1, ground, ground), 0.0);
}

TEST(HotLines, FillWhatTheListLacksAndRepeatNothing) {
    if (linesFolder().empty()) {
        GTEST_SKIP() << "no shared material";
    }
    const auto file = linesFolder() / "CO2.par.gz";
    const CarbonDioxideLevels levels(readTextLines(file), file.string());
    // The list has the main isotopologue at 2262 to 2400 cm-1 whole up to 1000 K, but next to
    // nothing at 2162 to 2187.
    LineList list = readLineList(Gas::CO2, file);
    const std::vector<Line> hot = hotCarbonDioxide(levels, 9000.0, 900.0, 1e-23);
    const auto sum = [](const std::vector<Line>& lines, double from_per_cm, double to_per_cm) {
        double total = 0.0;
        for (const Line& line : lines) {
            if (line.isotopologue == 1 && line.wavenumber_per_cm >= from_per_cm &&
                line.wavenumber_per_cm < to_per_cm) {
                total += line.intensity *
                         std::exp(secondRadiationConstant_cm_K * line.lowerEnergy_per_cm *
                                  (1.0 / 296.0 - 1.0 / 900.0));
            }
        }
        return total;
    };
    const double blue = sum(list.lines, 2280.0, 2380.0), red = sum(list.lines, 2162.0, 2187.0);
    EXPECT_NEAR(sum(hot, 2280.0, 2380.0), blue, 0.06 * blue);
    addMissingLines(list, hot);
    EXPECT_NEAR(sum(list.lines, 2280.0, 2380.0), blue, 0.08 * blue);
    const double filled = sum(list.lines, 2162.0, 2187.0);
    EXPECT_GT(filled, 8.0 * red);
    EXPECT_TRUE(std::ranges::is_sorted(list.lines, {}, &Line::wavenumber_per_cm));
    // Added once more, nothing is missing.
    const std::size_t count = list.lines.size();
    addMissingLines(list, hot);
    EXPECT_LT(list.lines.size() - count, count / 200);
}

} // namespace

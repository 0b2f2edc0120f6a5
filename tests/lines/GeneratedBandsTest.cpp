#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/support/SharedMaterial.h"
#include "tools/atmosphere-tables/lines/AngularMomentum.h"
#include "tools/atmosphere-tables/lines/AsymmetricTop.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"
#include "tools/atmosphere-tables/lines/MethaneLines.h"
#include "tools/atmosphere-tables/lines/OzoneLines.h"
#include "tools/atmosphere-tables/lines/SymmetricEigen.h"

// The bands of ozone and methane that no list at hand has, and the mechanics that generates them.

namespace irsg::lbl {
namespace {

std::vector<std::string> sharedTexts(const char* file) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    return data.empty() ? std::vector<std::string>{} : readTextLines(data / "lines" / file);
}

double number(const std::string& text, std::size_t first, std::size_t count) {
    return std::strtod(text.substr(first, count).c_str(), nullptr);
}

std::string without(std::string text, char what) {
    std::erase(text, what);
    return text;
}

double rms(const std::vector<double>& values) {
    return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0) /
                     static_cast<double>(values.size()));
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Without a list all widths are the same.
const std::vector<Line>& generatedOzone() {
    static const std::vector<Line> lines = ozoneLines({});
    return lines;
}

TEST(SymmetricEigen, FindsTheNormalModesOfAChain) {
    // 2 on the diagonal, -1 beside it: 2 - 2 cos(pi i / (n + 1)).
    constexpr std::size_t n = 12;
    SquareMatrix chain(n);
    for (std::size_t i = 0; i < n; ++i) {
        chain(i, i) = 2.0;
        if (i + 1 < n) {
            chain(i, i + 1) = chain(i + 1, i) = -1.0;
        }
    }
    const EigenSystem system = eigenSystem(chain);
    for (std::size_t i = 0; i < n; ++i) {
        EXPECT_NEAR(system.values[i],
                    2.0 - 2.0 * std::cos(M_PI * static_cast<double>(i + 1) / (n + 1.0)), 1e-12);
        for (std::size_t row = 0; row < n; ++row) {
            double image = 0.0;
            for (std::size_t k = 0; k < n; ++k) {
                image += chain(row, k) * system.vectors[i][k];
            }
            EXPECT_NEAR(image, system.values[i] * system.vectors[i][row], 1e-12);
        }
    }
    chain(0, 0) = std::nan("");
    EXPECT_THROW((void)eigenSystem(chain), LogicError);
}

TEST(AngularMomentum, CouplesToAWhole) {
    EXPECT_NEAR(clebschGordan(1, 0, 0, 0), -std::sqrt(1.0 / 3.0), 1e-15);
    EXPECT_NEAR(clebschGordan(1, 1, -1, 1), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(clebschGordan(1, 1, 1, 2), 1.0, 1e-15);
    EXPECT_EQ(clebschGordan(0, 0, 0, 0), 0.0);
    for (const int J : {0, 1, 2, 9}) {
        for (int k = -J; k <= J; ++k) {
            for (const int q : {-1, 0, 1}) {
                double sum = 0.0;
                for (int to = J - 1; to <= J + 1; ++to) {
                    sum += std::pow(clebschGordan(J, k, q, to), 2);
                }
                EXPECT_NEAR(sum, 1.0, 1e-14) << J << " " << k << " " << q;
            }
        }
    }
}

TEST(AsymmetricTop, HasTheLevelsOfARigidRotor) {
    constexpr double A = 3.5, B = 0.45, C = 0.39;
    TopState state;
    state.mean = 0.5 * (B + C);
    state.axial = A - state.mean;
    state.half = 0.5 * (B - C);
    TopState other = state;
    other.isAntisymmetric = true;
    // J = 1: A + C of 1(11) where Ka + Kc is even, B + C of 1(01) and A + B of 1(10) where it is
    // odd.
    const auto even = AsymmetricTop({state}, {}).levels(1),
               odd = AsymmetricTop({other}, {}).levels(1);
    ASSERT_EQ(even.size(), 1u);
    EXPECT_NEAR(even[0].energy_per_cm, A + C, 1e-12);
    EXPECT_EQ(even[0].Ka, 1);
    EXPECT_EQ(even[0].Kc, 1);
    ASSERT_EQ(odd.size(), 2u);
    for (const TopLevel& level : odd) {
        EXPECT_NEAR(level.energy_per_cm, level.Ka == 0 ? B + C : A + B, 1e-12);
    }
    // 2(02) and 2(20): 2 (A + B + C) -+ 2 sqrt((B - C)^2 + (A - C)(A - B)).
    const double root = 2.0 * std::sqrt((B - C) * (B - C) + (A - C) * (A - B));
    double found = 0.0;
    for (const TopLevel& level : AsymmetricTop({state}, {}).levels(2)) {
        if (level.Ka != 1) {
            EXPECT_NEAR(level.energy_per_cm, 2.0 * (A + B + C) + (level.Ka == 0 ? -root : root),
                        1e-12);
            ++found;
        }
    }
    EXPECT_EQ(found, 2);
}

TEST(AsymmetricTop, GivesEveryLevelAllOfItsDipole) {
    const TopMoment both[] = {{0, 0, TopMoment::Axis::b, 0.3, 0.0, 0.0},
                              {0, 1, TopMoment::Axis::a, 0.7, 0.0, 0.0}};
    std::map<std::tuple<int, int, int>, double> sums;
    for (const TopTransition& t :
         transitions(ozoneGround(), ozoneStretching(), {both[0], both[1]}, 12, 0.0, 1e4)) {
        sums[{t.lower.J, t.lower.Ka, t.lower.Kc}] += t.strength_debye2;
    }
    EXPECT_EQ(sums.size(), 85u); // J + 1 levels of every even J, J of every odd one
    for (const auto& [level, sum] : sums) {
        EXPECT_NEAR(sum, (0.09 + 0.49) * (2.0 * std::get<0>(level) + 1.0), 1e-9);
    }
}

// What a hot band starts from or a line ends at is a level of the list.
TEST(OzoneLines, HaveTheLevelsOfTheList) {
    const auto texts = sharedTexts("O3.par.gz");
    if (texts.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    using Key = std::tuple<std::string, int, int, int>;
    std::map<Key, double> listed;
    for (const std::string& text : texts) {
        if (text[2] != '1') {
            continue;
        }
        const auto level = [&](std::size_t state, std::size_t at, double energy) {
            if (energy > 0.0) {
                listed[{without(text.substr(state, 15), ' '), static_cast<int>(number(text, at, 3)),
                        static_cast<int>(number(text, at + 3, 3)),
                        static_cast<int>(number(text, at + 6, 3))}] = energy;
            }
        };
        level(82, 112, number(text, 45, 10));
        level(67, 97, number(text, 45, 10) + number(text, 3, 12));
    }
    struct Case {
        AsymmetricTop top;
        std::vector<std::string> names;
        double rms_per_cm;
    };
    for (const Case& one :
         {Case{ozoneGround(), {"000"}, 0.002}, Case{ozoneBending(), {"010"}, 0.003},
          Case{ozoneStretching(), {"100", "001"}, 0.003},
          Case{ozoneBentStretching(), {"110", "011"}, 0.003},
          Case{ozoneOvertones(), {"200", "101", "002"}, 0.01}}) {
        std::vector<double> differences;
        std::size_t exchanged = 0;
        for (int J = 1; J <= 36; ++J) {
            for (const TopLevel& level : one.top.levels(J)) {
                if (level.Ka > 12) {
                    continue;
                }
                const auto found = listed.find({one.names[level.state], J, level.Ka, level.Kc});
                if (found == listed.end()) {
                    continue;
                }
                const double difference = level.energy_per_cm - found->second;
                // Two that lie in each other's way have exchanged their names.
                if (std::abs(difference) > 0.1) {
                    ++exchanged;
                } else {
                    differences.push_back(difference);
                }
            }
        }
        EXPECT_GT(differences.size(), 350u) << one.names[0];
        EXPECT_LE(exchanged, 6u) << one.names[0];
        EXPECT_LT(rms(differences), one.rms_per_cm) << one.names[0];
    }
}

// Integrals of the cross section of 16O3 at 279.1 K and 1013.95 hPa, cm-1 cm2, that
// others computed from HITRAN with HAPI (github.com/satpyscene/NNLBL_test, an HDF5 file named after
// them), over 10 cm-1 each. Our dipoles were fitted to the same file: of shape, this is a check, of
// strength, none; that is the comparison with MODTRAN in docs/atmosphere-accuracy.md.
TEST(OzoneLines, AbsorbAsCrossSectionsComputedFromHITRAN) {
    constexpr std::array<std::pair<double, double>, 6> integrals = {{{1000.0, 7.401e-19},
                                                                     {1010.0, 1.627e-18},
                                                                     {1020.0, 2.482e-18},
                                                                     {1030.0, 2.486e-18},
                                                                     {1040.0, 1.806e-18},
                                                                     {1050.0, 4.023e-18}}};
    const PartitionSums partition = PartitionSums::rigidRotor();
    LineList list{Gas::O3, generatedOzone(), {}};
    std::erase_if(list.lines, [](const Line& line) { return line.isotopologue != 1; });
    for (const auto& [from_per_cm, integral] : integrals) {
        const WavenumberGrid grid{from_per_cm, 0.01, 1000};
        const auto cross =
            crossSection_cm2(list, partition, grid, 279.1, 1013.95, 0.0, defaultLineShape(Gas::O3));
        const double ours = 0.01 * std::accumulate(cross.begin(), cross.end(), 0.0);
        EXPECT_NEAR(ours / integral, 1.0, 0.03) << from_per_cm;
    }
}

/// How far lines, by m, are from those of another rotor at m = 0: B goes with a factor r, what it
/// changes by with the band as NitrousOxideLines has it. The r that leaves the least spread.
double distanceOfOrigins(const std::vector<std::pair<double, double>>& moved, double sumOfB,
                         double differenceOfB, double ratioOfOrigins) {
    double best = 0.0, least = HUGE_VAL;
    for (int i = 0; i < 15000; ++i) {
        const double r = 0.9 + 1e-5 * i;
        double sum = 0.0, squares = 0.0;
        for (const auto& [m, distance] : moved) {
            const double rest = distance - (r - 1.0) * sumOfB * m -
                                (r * r * ratioOfOrigins - 1.0) * differenceOfB * m * m;
            sum += rest;
            squares += rest * rest;
        }
        const auto count = static_cast<double>(moved.size());
        if (const double spread = squares / count - sum * sum / count / count; spread < least) {
            least = spread;
            best = sum / count;
        }
    }
    return best;
}

// nu3 of 16O16O18O and 16O18O16O, whose origins are literature: the P branches that the list has
// below 983 cm-1, followed to m = 0.
TEST(OzoneLines, HaveTheOriginsOfTheIsotopologuesOfTheList) {
    const auto texts = sharedTexts("O3.par.gz");
    if (texts.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    std::map<std::tuple<int, int, int, int>, double> ground, excited; // state, J, Ka, Kc
    for (int J = 0; J <= 66; ++J) {
        for (const TopLevel& level : ozoneGround().levels(J)) {
            ground[{0, J, level.Ka, level.Kc}] = level.energy_per_cm;
        }
        for (const TopLevel& level : ozoneStretching().levels(J)) {
            excited[{static_cast<int>(level.state), J, level.Ka, level.Kc}] = level.energy_per_cm;
        }
    }
    for (const auto& [isotopologue, origin_per_cm] :
         {std::pair{'2', 1028.112}, std::pair{'3', 1008.453}}) {
        std::vector<std::pair<double, double>> moved;
        for (const std::string& text : texts) {
            const double nu = number(text, 3, 12);
            if (text[2] != isotopologue || nu < 930.0 || nu > 983.0 ||
                without(text.substr(67, 15), ' ') != "001" ||
                without(text.substr(82, 15), ' ') != "000") {
                continue;
            }
            const auto quantum = [&](std::size_t at) {
                return static_cast<int>(number(text, at, 3));
            };
            if (quantum(115) > 2 || quantum(97) != quantum(112) - 1) {
                continue;
            }
            const auto upper = excited.find({1, quantum(97), quantum(100), quantum(103)});
            const auto lower = ground.find({0, quantum(112), quantum(115), quantum(118)});
            if (upper != excited.end() && lower != ground.end()) {
                moved.emplace_back(-quantum(112), nu - (upper->second - lower->second));
            }
        }
        const double distance = distanceOfOrigins(moved, 0.41650 + 0.42002, 0.41650 - 0.42002,
                                                  1042.084 / origin_per_cm);
        std::printf("nu3 of ozone's isotopologue %c: %zu lines, %.2f cm-1\n", isotopologue,
                    moved.size(), distance + 1042.084);
        ASSERT_GT(moved.size(), 25u);
        // A top that is substituted in its middle changes A more than B: the rule is as wrong.
        EXPECT_NEAR(distance, origin_per_cm - 1042.084, 1.0) << isotopologue;
    }
}

TEST(OzoneLines, CoverTheirRangesAlone) {
    const std::vector<Line>& lines = generatedOzone();
    EXPECT_TRUE(std::ranges::is_sorted(lines, {}, &Line::wavenumber_per_cm));
    for (const Line& line : lines) {
        EXPECT_TRUE((line.wavenumber_per_cm >= ozoneFrom_per_cm &&
                     line.wavenumber_per_cm < ozoneTo_per_cm) ||
                    (line.wavenumber_per_cm >= ozoneOvertoneFrom_per_cm - 30.0 &&
                     line.wavenumber_per_cm < ozoneOvertoneTo_per_cm));
        EXPECT_GT(line.intensity, 0.0);
        EXPECT_GE(line.lowerEnergy_per_cm, 0.0);
    }
}

// A rigid sphere that turns in a field of cubes: J = 3 splits into A2, F2 and F1.
TEST(MethaneLines, OfTheGroundStateHaveTheirSpecies) {
    const std::array<std::vector<TetrahedralSpecies>, 5> expected = {
        {{TetrahedralSpecies::A1},
         {TetrahedralSpecies::F1},
         {TetrahedralSpecies::E, TetrahedralSpecies::F2},
         {TetrahedralSpecies::A2, TetrahedralSpecies::F1, TetrahedralSpecies::F2},
         {TetrahedralSpecies::A1, TetrahedralSpecies::E, TetrahedralSpecies::F1,
          TetrahedralSpecies::F2}}};
    for (int J = 0; J < 5; ++J) {
        std::set<TetrahedralSpecies> found;
        for (const TetrahedralLevel& level : methaneGround(J)) {
            found.insert(level.species);
        }
        const auto& species = expected[static_cast<std::size_t>(J)];
        EXPECT_EQ(found, std::set<TetrahedralSpecies>(species.begin(), species.end())) << J;
    }
    // J = 1 of nu4: R = 0, 1 and 2 have A2... as F2 turns with F1: A2 + E + F1 + F2, of nu2: F1 +
    // F2.
    std::map<TetrahedralSpecies, int> count;
    for (const TetrahedralLevel& level : methaneDyad(1)) {
        ++count[level.species];
    }
    EXPECT_EQ(count[TetrahedralSpecies::A2], 1);
    EXPECT_EQ(count[TetrahedralSpecies::E], 2); // in both blocks
    EXPECT_EQ(count[TetrahedralSpecies::F1], 2);
    EXPECT_EQ(count[TetrahedralSpecies::F2], 2);
}

TEST(MethaneLines, HaveTheLevelsOfTheList) {
    const auto texts = sharedTexts("CH4.par.gz");
    if (texts.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    using Key = std::tuple<int, std::string, int>;
    std::map<Key, std::vector<double>> ground, dyad;
    for (const std::string& text : texts) {
        if (text[2] != '1' || text.find_first_not_of(' ', 67) > 80) {
            continue;
        }
        const auto level = [&](std::size_t state, std::size_t at, double energy) {
            const std::string name = without(text.substr(state, 12), ' ').substr(0, 4);
            if (name != "0000" && name != "0001" && name != "0100") {
                return;
            }
            (name == "0000" ? ground : dyad)[{static_cast<int>(number(text, at + 2, 3)),
                                              without(text.substr(at + 5, 2), ' '),
                                              static_cast<int>(number(text, at + 7, 3))}]
                .push_back(energy);
        };
        level(82, 112, number(text, 45, 10));
        level(67, 97, number(text, 45, 10) + number(text, 3, 12));
    }
    constexpr std::array<const char*, 5> names = {"A1", "A2", "E", "F1", "F2"};
    std::vector<double> below, above;
    for (int J = 1; J <= 16; ++J) {
        for (const TetrahedralLevel& level : methaneGround(J)) {
            if (const auto found =
                    ground.find({J, names[static_cast<std::size_t>(level.species)], level.number});
                found != ground.end()) {
                below.push_back(level.energy_per_cm - median(found->second));
            }
        }
        for (const TetrahedralLevel& level : methaneDyad(J)) {
            if (const auto found =
                    dyad.find({J, names[static_cast<std::size_t>(level.species)], level.number});
                found != dyad.end()) {
                above.push_back(level.energy_per_cm - median(found->second));
            }
        }
    }
    EXPECT_GT(below.size(), 120u);
    EXPECT_GT(above.size(), 500u);
    EXPECT_LT(rms(below), 0.003);
    EXPECT_LT(rms(above), 0.015);
}

// The P branch below 1200 cm-1, which the list has, line by line.
TEST(MethaneLines, HaveThePBranchOfTheList) {
    const auto data = smat::test::sharedMaterial("data/atmosphere");
    if (data.empty()) {
        GTEST_SKIP() << "the shared material is not beside the checkout";
    }
    const LineList list = readLineList(Gas::CH4, data / "lines" / "CH4.par.gz");
    const std::vector<Line> ours = methaneDyadLines(list.lines, 1140.0, 1200.0);
    std::vector<double> moved, stronger, lighter;
    double listed = 0.0, generated = 0.0;
    for (const Line& line : list.lines) {
        if (line.wavenumber_per_cm < 1141.0 || line.wavenumber_per_cm > 1199.0 ||
            line.intensity < (line.isotopologue == 1 ? 2e-23 : 5e-24) || line.isotopologue > 2) {
            continue;
        }
        const Line* best = nullptr;
        for (const Line& candidate : ours) {
            if (candidate.isotopologue == line.isotopologue &&
                std::abs(candidate.lowerEnergy_per_cm - line.lowerEnergy_per_cm) < 0.02 &&
                std::abs(candidate.wavenumber_per_cm - line.wavenumber_per_cm) < 0.5 &&
                (!best || std::abs(candidate.wavenumber_per_cm - line.wavenumber_per_cm) <
                              std::abs(best->wavenumber_per_cm - line.wavenumber_per_cm))) {
                best = &candidate;
            }
        }
        if (line.isotopologue == 2) {
            if (best) {
                lighter.push_back(best->wavenumber_per_cm - line.wavenumber_per_cm);
            }
            continue;
        }
        ASSERT_TRUE(best) << line.wavenumber_per_cm;
        moved.push_back(best->wavenumber_per_cm - line.wavenumber_per_cm);
        stronger.push_back(std::abs(std::log(best->intensity / line.intensity)));
        listed += line.intensity;
        generated += best->intensity;
    }
    ASSERT_GT(moved.size(), 30u);
    EXPECT_LT(rms(moved), 0.03);
    // Levels that nearly coincide are not always told apart by what a line says of them.
    EXPECT_LT(median(stronger), 0.01);
    EXPECT_NEAR(generated / listed, 1.0, 0.02);
    // A band that is only moved: 13CH4.
    if (!lighter.empty()) {
        EXPECT_LT(rms(lighter), 0.3);
    }
}

} // namespace
} // namespace irsg::lbl

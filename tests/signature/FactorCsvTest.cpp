#include "irsg/radiometry/Units.h"
#include "irsg/signature/SpectrumCsv.h"

#include "Support.h"
#include "tests/support/SharedMaterial.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;

/// A spectrum with the components of the report's tables.
UserSpectrum report() {
    UserSpectrum spectrum;
    spectrum.name = "report";
    for (const char* const name : {"BB(T1)", "BB(T2)", "BB(T3)", "CO2(T4)", "H2O"}) {
        spectrum.components.push_back({name, {{4, 5}, {1, 1}, Spectrum::Outside::zero}});
    }
    return spectrum;
}

EntityState at(double time_s, double angle_deg) {
    EntityState state;
    state.time_s = time_s;
    state.aspectAngle_rad = radians(angle_deg);
    return state;
}

TEST(FactorCsv, SetsTheTablesOfTheComponentsItNames) {
    const TemporaryFolder folder;
    ComponentFactors factors = {{"H2O", 0.25, {}, {}}};
    readFactorCsv(writeBytes(folder / "t.csv", ",CO2(T4),H2O\n0,1,0.5\n2,0,0.7\n"),
                  FactorAxis::time_s, false, report(), factors);
    readFactorCsv(writeBytes(folder / "a.csv", ",H2O\n0,1\n180,0\n"), FactorAxis::angle_deg, false,
                  report(), factors);
    ASSERT_EQ(factors.size(), 2U);
    EXPECT_EQ(factors[0].component, "H2O");
    EXPECT_EQ(factors[0].constant, 0.25) << "kept, though the time table stands in for it";
    EXPECT_DOUBLE_EQ(factors[0].at(at(1.0, 90.0)), 0.6 * 0.5);
    EXPECT_EQ(factors[1].component, "CO2(T4)");
    EXPECT_DOUBLE_EQ(factors[1].at(at(1.0, 90.0)), 0.5);
    EXPECT_TRUE(factors[1].angle.empty());
}

TEST(FactorCsv, OfTheReportsTablesHasItsNumbers) {
    const fs::path folder = smat::test::sharedMaterial("data/karma");
    if (!fs::exists(folder / "time_table19.csv") || !fs::exists(folder / "angle_table20.csv")) {
        GTEST_SKIP() << "the report's tables 19 and 20 are not at hand";
    }
    ComponentFactors factors;
    readFactorCsv(folder / "time_table19.csv", FactorAxis::time_s, true, report(), factors);
    readFactorCsv(folder / "angle_table20.csv", FactorAxis::angle_deg, false, report(), factors);
    ASSERT_EQ(factors.size(), 5U);

    // Rows of both tables: seconds and degrees, then BB(T1), BB(T2), BB(T3), CO2(T4), H2O.
    const double time[5][5] = {{0.5, 0.7, 0.1, 0.1, 0.1},
                               {0.6, 0.8, 0.2, 0.2, 0.2},
                               {0.7, 0.9, 0.3, 0.3, 0.3},
                               {0.8, 1.0, 0.4, 0.4, 0.4},
                               {0.9, 1.0, 0.5, 0.5, 0.5}};
    const double angle[5][5] = {{0.3, 0.4, 0.1, 0.7, 1.0},
                                {0.4, 0.5, 0.2, 0.8, 1.0},
                                {0.5, 0.6, 0.3, 0.9, 1.0},
                                {0.6, 0.7, 0.4, 1.0, 1.0},
                                {0.7, 0.8, 0.5, 1.0, 1.0}};
    for (std::size_t component = 0; component < 5; ++component) {
        EXPECT_TRUE(factors[component].time.loop());
        EXPECT_FALSE(factors[component].angle.loop());
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_EQ(factors[component].time.x()[i], static_cast<double>(i));
            EXPECT_EQ(factors[component].time.y()[i], time[i][component]);
            EXPECT_EQ(factors[component].angle.x()[i], 45.0 * static_cast<double>(i));
            EXPECT_EQ(factors[component].angle.y()[i], angle[i][component]);
        }
    }
    EXPECT_NEAR(factors[0].at(at(1.5, 67.5)), 0.65 * 0.45, 1e-15) << "midway on both axes";
    EXPECT_NEAR(factors[0].at(at(5.5, 67.5)), 0.65 * 0.45, 1e-15) << "a period of 4 s later";
    EXPECT_NEAR(factors[3].at(at(0.0, 180.0)), 0.1, 1e-15);
}

struct BadCsv {
    const char* name;
    FactorAxis axis;
    bool loop;
    const char* text;
    const char* position;
    const char* value;
    const char* expected;
};
void PrintTo(const BadCsv& row, std::ostream* out) {
    *out << row.name;
}

class RefusedFactorCsv : public testing::TestWithParam<BadCsv> {};

TEST_P(RefusedFactorCsv, NamesFilePlaceValueAndExpectationAndChangesNothing) {
    const TemporaryFolder folder;
    const BadCsv& row = GetParam();
    const fs::path file = writeBytes(folder / "bad.csv", row.text);
    const ComponentFactors before = {{"H2O", 0.25, {}, {}}};
    ComponentFactors factors = before;
    const auto diagnostics =
        refusalOf([&] { readFactorCsv(file, row.axis, row.loop, report(), factors); });
    EXPECT_TRUE(factors == before);
    bool found = false;
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) {
        EXPECT_EQ(diagnostic.file, file.string());
        all += diagnostic.message() + "\n";
        found |= diagnostic.position == row.position &&
                 diagnostic.value.find(row.value) != std::string::npos &&
                 diagnostic.expected.find(row.expected) != std::string::npos;
    }
    EXPECT_TRUE(found) << all;
}

constexpr FactorAxis time = FactorAxis::time_s;
constexpr FactorAxis angle = FactorAxis::angle_deg;

INSTANTIATE_TEST_SUITE_P(
    FactorCsv, RefusedFactorCsv,
    testing::Values(
        BadCsv{"Empty", time, false, "", "", "0 rows", "at least 1 row"},
        BadCsv{"NoNodes", time, false, ",H2O\n", "", "1 rows", "at least 1 row"},
        BadCsv{"LoopOfOneNode", time, true, ",H2O\n0,1\n", "", "2 rows", "at least 2 rows"},
        BadCsv{"FirstCellUsed", time, false, "s,H2O\n0,1\n", "line 1, column 1", "'s'", "empty"},
        BadCsv{"UnknownComponent", time, false, ",H2O,SO2\n0,1,1\n", "line 1, column 3", "'SO2'",
               "BB(T1), BB(T2), BB(T3), CO2(T4), H2O"},
        BadCsv{"ComponentInOtherLetters", time, false, ",h2o\n0,1\n", "line 1, column 2", "'h2o'",
               "H2O"},
        BadCsv{"ComponentTwice", time, false, ",H2O,H2O\n0,1,1\n", "line 1, column 3", "'H2O'",
               "once"},
        BadCsv{"Nameless", time, false, ",H2O,\n0,1,1\n", "line 1, column 3", "nothing", "name"},
        BadCsv{"TimeDescends", time, false, ",H2O\n1,1\n0,1\n", "line 3, column 1", "'0'",
               "ascending"},
        BadCsv{"TimeTwice", time, false, ",H2O\n1,1\n1,1\n", "line 3, column 1", "'1'",
               "ascending"},
        BadCsv{"TimeOfText", time, false, ",H2O\nnow,1\n", "line 2, column 1", "'now'", "number"},
        BadCsv{"FactorNan", time, false, ",H2O\n0,nan\n", "line 2, column 2", "'nan'", "number"},
        BadCsv{"FactorNegative", time, false, ",H2O\n0,-0.1\n", "line 2, column 2", "'-0.1'",
               "at least 0"},
        BadCsv{"RowTooShort", time, false, ",H2O,CO2(T4)\n0,1\n", "line 2", "2 cells", "3 cells"},
        BadCsv{"AngleNegative", angle, false, ",H2O\n-1,1\n90,1\n", "line 2, column 1", "'-1'",
               "0 to 180"},
        BadCsv{"AngleBeyondHalfATurn", angle, false, ",H2O\n0,1\n360,1\n", "line 3, column 1",
               "'360'", "0 to 180"},
        BadCsv{"AngleInALoop", angle, true, ",H2O\n0,1\n180,1\n", "", "loop", "time alone"}),
    [](const auto& row) { return row.param.name; });

} // namespace
} // namespace irsg

#include "irsg/signature/LookupTable.h"

#include <cmath>
#include <limits>

#include "Support.h"

namespace irsg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(LookupTable, GivesItsNodesExactly) {
    const LookupTable table({-1.0, 0.3, 7.0}, {5.0, -2.0, 0.1});
    EXPECT_EQ(table.at(-1.0), 5.0);
    EXPECT_EQ(table.at(0.3), -2.0);
    EXPECT_EQ(table.at(7.0), 0.1);
}

TEST(LookupTable, IsLinearBetweenNodes) {
    const LookupTable table({0.0, 2.0, 4.0}, {10.0, 20.0, -20.0});
    EXPECT_DOUBLE_EQ(table.at(1.0), 15.0);
    EXPECT_DOUBLE_EQ(table.at(3.0), 0.0);
    EXPECT_DOUBLE_EQ(table.at(3.5), -10.0);
}

TEST(LookupTable, HoldsItsEndsOutsideAndSaysSo) {
    const LookupTable table({1.0, 2.0}, {10.0, 20.0});
    for (const double below : {0.999, 0.0, -1e300, -infinity}) {
        EXPECT_EQ(table.at(below), 10.0) << below;
        EXPECT_TRUE(table.isOutside(below)) << below;
    }
    for (const double above : {2.001, 1e300, infinity}) {
        EXPECT_EQ(table.at(above), 20.0) << above;
        EXPECT_TRUE(table.isOutside(above)) << above;
    }
    EXPECT_FALSE(table.isOutside(1.0));
    EXPECT_FALSE(table.isOutside(1.5));
    EXPECT_FALSE(table.isOutside(2.0));
}

TEST(LookupTable, OfOneNodeIsAConstant) {
    const LookupTable table({5.0}, {3.0});
    EXPECT_EQ(table.at(-100.0), 3.0);
    EXPECT_EQ(table.at(5.0), 3.0);
    EXPECT_EQ(table.at(100.0), 3.0);
}

TEST(LookupTable, LoopRepeatsWithThePeriodLastMinusFirst) {
    // The nodes span 3 to 7: a period of 4, whatever the step is.
    const LookupTable table({3.0, 4.0, 7.0}, {1.0, 2.0, 5.0}, true);
    for (const double time : {3.0, 3.25, 4.0, 5.5, 6.9}) {
        for (const int turns : {-250, -2, -1, 0, 1, 2, 250}) {
            EXPECT_NEAR(table.at(time + 4.0 * turns), table.at(time), 1e-11)
                << time << " and " << turns << " turns";
        }
    }
    EXPECT_DOUBLE_EQ(table.at(7.5), table.at(3.5));
    EXPECT_DOUBLE_EQ(table.at(0.0), 2.0) << "a time before the first node";
    EXPECT_DOUBLE_EQ(table.at(-1.0), 1.0) << "exactly one period before";
    EXPECT_EQ(table.at(7.0), 1.0) << "the last node is the first of the next turn";
    EXPECT_FALSE(table.isOutside(-1e6));
    EXPECT_FALSE(table.isOutside(1e6));
}

TEST(LookupTable, AnswersNotANumberWithTheSame) {
    EXPECT_TRUE(std::isnan(LookupTable({0.0, 1.0}, {0.0, 1.0}).at(nan)));
    EXPECT_TRUE(std::isnan(LookupTable({0.0, 1.0}, {0.0, 1.0}, true).at(nan)));
}

TEST(LookupTable, WithoutNodesHasNoValue) {
    EXPECT_TRUE(LookupTable().empty());
    EXPECT_FALSE(LookupTable().isOutside(0.0));
    EXPECT_THROW(LookupTable().at(0.0), LogicError);
}

struct BadTable {
    const char* name;
    std::vector<double> x;
    std::vector<double> y;
    bool loop;
    const char* position;
    const char* value;
    const char* expected;
};
void PrintTo(const BadTable& row, std::ostream* out) {
    *out << row.name;
}

class RefusedLookupTable : public testing::TestWithParam<BadTable> {};

TEST_P(RefusedLookupTable, NamesTheNodeAndTheValue) {
    const BadTable& row = GetParam();
    const auto diagnostics =
        refusalOf([&] { LookupTable(row.x, row.y, row.loop, "power of the cowl"); });
    ASSERT_EQ(diagnostics.size(), 1U);
    EXPECT_EQ(diagnostics[0].file, "power of the cowl");
    EXPECT_EQ(diagnostics[0].position, row.position);
    EXPECT_EQ(diagnostics[0].value, row.value);
    EXPECT_THAT(diagnostics[0].expected, testing::HasSubstr(row.expected));
}

INSTANTIATE_TEST_SUITE_P(
    Tables, RefusedLookupTable,
    testing::Values(
        BadTable{"Descending", {0, 2, 1}, {1, 1, 1}, false, "node 3", "1 after 2", "ascending"},
        BadTable{"Duplicated", {0, 0}, {1, 1}, false, "node 2", "0 after 0", "ascending"},
        BadTable{"AxisNotANumber", {0, nan}, {1, 1}, false, "node 2", "nan, 1", "finite"},
        BadTable{"FirstAxisNotANumber", {nan}, {1}, false, "node 1", "nan, 1", "finite"},
        BadTable{"ValueNotANumber", {0, 1}, {nan, 1}, false, "node 1", "0, nan", "finite"},
        BadTable{"ValueInfinite", {0, 1}, {1, infinity}, false, "node 2", "1, inf", "finite"},
        BadTable{"AxisInfinite", {-infinity, 1}, {1, 1}, false, "node 1", "-inf, 1", "finite"},
        BadTable{"FewerValues", {0, 1}, {1}, false, "", "2 axis nodes and 1 values", "as many"},
        BadTable{"Empty", {}, {}, false, "", "0 nodes", "at least one"},
        BadTable{"LoopOfOne", {1}, {1}, true, "", "1 nodes", "two nodes in a loop"}),
    [](const auto& row) { return row.param.name; });

} // namespace
} // namespace irsg

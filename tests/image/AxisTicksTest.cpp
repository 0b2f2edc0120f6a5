#include "irsg/image/AxisTicks.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using test::inputErrorOf;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(AxisTicks, StandAtRoundValues) {
    struct Row {
        const char* name;
        DisplayLimits limits;
        std::vector<std::string> labels;
        int exponent;
    };
    const std::vector<Row> rows{
        {"unit", {0, 1}, {"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}, 0},
        {"kelvin", {283.4, 346}, {"290", "300", "310", "320", "330", "340"}, 0},
        {"about zero", {-2, 2}, {"\u22122", "\u22121", "0", "1", "2"}, 0},
        {"fine on a large value",
         {300, 300.003},
         {"300.0000", "300.0005", "300.0010", "300.0015", "300.0020", "300.0025", "300.0030"},
         0},
        {"small", {0, 5e-5}, {"0", "10", "20", "30", "40", "50"}, -6},
        {"large", {0, 3e6}, {"0.0", "0.5", "1.0", "1.5", "2.0", "2.5", "3.0"}, 6},
        {"negative",
         {-40, -10},
         {"\u221240", "\u221235", "\u221230", "\u221225", "\u221220", "\u221215", "\u221210"},
         0},
    };
    for (const auto& row : rows) {
        const AxisTicks ticks = axisTicks(row.limits, 7);
        EXPECT_EQ(ticks.labels, row.labels) << row.name;
        EXPECT_EQ(ticks.exponent, row.exponent) << row.name;
    }
}

TEST(AxisTicks, AreTheRoundestValuesAlongColoursThatDoNotFollowValues) {
    DisplayLimits limits{0.0, 2000.0};
    limits.scale = ColorScale::logarithmic;
    EXPECT_THAT(axisTicks(limits, 13).labels,
                ElementsAre("0", "0.2", "1", "2", "5", "10", "20", "50", "100", "200", "500",
                            "1000", "2000"));
    limits.scale = ColorScale::squareRoot;
    EXPECT_THAT(axisTicks(limits, 5).labels, ElementsAre("0", "200", "500", "1000", "2000"));
    limits.scale = ColorScale::equalized;
    limits.levels = std::make_shared<const std::vector<double>>(
        std::vector<double>{0.0, 287.3, 287.9, 288.6, 2000.0});
    EXPECT_THAT(axisTicks(limits, 5).labels, ElementsAre("0", "250", "290", "2000"));
}

TEST(AxisTicks, LieInsideTheLimitsAndSayTheirValueAtAnyMagnitude) {
    for (int power = -44; power <= 38; ++power) {
        for (const double low : {0.0, 1.0, -3.7, 99.2}) {
            for (const double width : {0.013, 1.0, 7.3}) {
                for (const int most : {2, 5, 9}) {
                    const double unit = std::pow(10.0, power);
                    const DisplayLimits limits{low * unit, (low + width) * unit};
                    const AxisTicks ticks = axisTicks(limits, most);
                    SCOPED_TRACE(testing::Message() << limits.low << " to " << limits.high);
                    ASSERT_EQ(ticks.values.size(), ticks.labels.size());
                    ASSERT_GE(ticks.values.size(), 2U);
                    ASSERT_LE(ticks.values.size(), static_cast<std::size_t>(most));
                    EXPECT_EQ(ticks.exponent % 3, 0);
                    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
                        EXPECT_GE(ticks.values[i], limits.low);
                        EXPECT_LE(ticks.values[i], limits.high);
                        std::string label = ticks.labels[i];
                        if (label.starts_with("\u2212")) {
                            label.replace(0, 3, "-");
                        }
                        EXPECT_NEAR(std::stod(label) * std::pow(10.0, ticks.exponent),
                                    ticks.values[i], 0.02 * width * unit);
                    }
                }
            }
        }
    }
}

TEST(AxisTicks, MarkTheEndsOfLimitsThatAreAsCloseAsNumbersGet) {
    const double next = std::nextafter(300.0, 301.0);
    const AxisTicks ticks = axisTicks({300.0, next}, 5);
    EXPECT_THAT(ticks.values, ElementsAre(300.0, next));
    EXPECT_GE(axisTicks({0.0, std::numeric_limits<double>::denorm_min()}, 5).values.size(), 2U);
    const double huge = std::numeric_limits<double>::max();
    EXPECT_GE(axisTicks({-huge, huge}, 5).values.size(), 2U);
}

TEST(AxisTicks, RefuseLimitsThatAreNone) {
    const double inf = std::numeric_limits<double>::infinity();
    const DisplayLimits rows[] = {{1, 1}, {2, 1}, {0, inf}, {-inf, 0}, {std::nan(""), 1}};
    for (const DisplayLimits& limits : rows) {
        EXPECT_THAT(inputErrorOf([&] { axisTicks(limits, 5); }), HasSubstr("two finite numbers"));
    }
}

TEST(PrettyUnit, SetsExponentsAsSuperscripts) {
    const struct {
        const char *unit, *pretty;
    } rows[] = {
        {"W m-2 sr-1", "W·m⁻²·sr⁻¹"},
        {"W m-2 sr-1 um-1", "W·m⁻²·sr⁻¹·µm⁻¹"},
        {"K", "K"},
        {"", ""},
        {"cm-1", "cm⁻¹"},
        {"m2", "m²"},
        {"deg", "°"},
        {"um", "µm"},
        {"m/s", "m/s"},
        {"12", "12"},
        {"W  m", "W  m"},
        {"m-", "m-"},
        {"10 dB", "10 dB"},
    };
    for (const auto& row : rows) {
        EXPECT_EQ(prettyUnit(row.unit), row.pretty) << row.unit;
    }
    EXPECT_EQ(superscript(-1234567890), "⁻¹²³⁴⁵⁶⁷⁸⁹⁰");
}

} // namespace
} // namespace irsg

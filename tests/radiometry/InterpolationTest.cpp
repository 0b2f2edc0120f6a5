// Brackets on axes of every kind, and what is linear or goes by equal ratios between two nodes.
#include "irsg/core/Interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace irsg;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

/// The bits, but for the sign of zero: NaN is NaN.
void expectSame(double value, double expected, const std::string& what) {
    if (std::isnan(expected)) {
        EXPECT_TRUE(std::isnan(value)) << what << ": " << value;
    } else {
        EXPECT_EQ(value, expected) << what;
    }
}

struct Place {
    std::string name;
    std::vector<double> axis;
    double x;
    Beyond beyond;
    std::size_t below, above;
    double fraction;
};

const std::vector<Place> onAxes = {
    {"between", {1, 2, 4, 8}, 3, Beyond::clamp, 1, 2, 0.5},
    {"first node", {1, 2, 4, 8}, 1, Beyond::clamp, 0, 1, 0},
    {"inner node", {1, 2, 4, 8}, 4, Beyond::clamp, 2, 3, 0},
    {"last node", {1, 2, 4, 8}, 8, Beyond::clamp, 2, 3, 1},
    {"below, clamped", {1, 2, 4, 8}, 0, Beyond::clamp, 0, 1, 0},
    {"above, clamped", {1, 2, 4, 8}, 9, Beyond::clamp, 2, 3, 1},
    {"far below, clamped", {1, 2, 4, 8}, -infinity, Beyond::clamp, 0, 1, 0},
    {"far above, clamped", {1, 2, 4, 8}, infinity, Beyond::clamp, 2, 3, 1},
    {"below, extrapolated", {1, 2, 4, 8}, 0, Beyond::extrapolate, 0, 1, -1},
    {"above, extrapolated", {1, 2, 4, 8}, 12, Beyond::extrapolate, 2, 3, 2},
    {"below, no value", {1, 2, 4, 8}, 0.999, Beyond::notANumber, 0, 1, notANumber},
    {"above, no value", {1, 2, 4, 8}, 8.001, Beyond::notANumber, 0, 1, notANumber},
    {"first node, no value beyond", {1, 2, 4, 8}, 1, Beyond::notANumber, 0, 1, 0},
    {"last node, no value beyond", {1, 2, 4, 8}, 8, Beyond::notANumber, 2, 3, 1},
    {"a hair below, no value", {0, 1}, -smallest, Beyond::notANumber, 0, 1, notANumber},
    {"NaN, clamped", {1, 2, 4, 8}, notANumber, Beyond::clamp, 2, 3, notANumber},
    {"NaN, extrapolated", {1, 2, 4, 8}, notANumber, Beyond::extrapolate, 2, 3, notANumber},
    {"NaN, no value beyond", {1, 2, 4, 8}, notANumber, Beyond::notANumber, 0, 1, notANumber},
    {"descending, between", {8, 4, 2, 1}, 3, Beyond::clamp, 1, 2, 0.5},
    {"descending, first node", {8, 4, 2, 1}, 8, Beyond::clamp, 0, 1, 0},
    {"descending, inner node", {8, 4, 2, 1}, 4, Beyond::clamp, 1, 2, 0},
    {"descending, last node", {8, 4, 2, 1}, 1, Beyond::clamp, 2, 3, 1},
    {"descending, before, clamped", {8, 4, 2, 1}, 9, Beyond::clamp, 0, 1, 0},
    {"descending, behind, clamped", {8, 4, 2, 1}, 0, Beyond::clamp, 2, 3, 1},
    {"descending, before, extrapolated", {8, 4, 2, 1}, 12, Beyond::extrapolate, 0, 1, -1},
    {"descending, behind, extrapolated", {8, 4, 2, 1}, 0, Beyond::extrapolate, 2, 3, 2},
    {"descending, before, no value", {8, 4, 2, 1}, 9, Beyond::notANumber, 0, 1, notANumber},
    {"descending, behind, no value", {8, 4, 2, 1}, 0, Beyond::notANumber, 0, 1, notANumber},
    {"before a step", {0, 1, 1, 3}, 0.75, Beyond::clamp, 0, 1, 0.75},
    {"on a step", {0, 1, 1, 3}, 1, Beyond::clamp, 2, 3, 0},
    {"after a step", {0, 1, 1, 3}, 2, Beyond::clamp, 2, 3, 0.5},
    {"on a step of three", {0, 1, 1, 1, 3}, 1, Beyond::clamp, 3, 4, 0},
    {"before a step at the beginning", {1, 1, 3}, 0, Beyond::clamp, 0, 1, 0},
    {"on a step at the beginning", {1, 1, 3}, 1, Beyond::clamp, 1, 2, 0},
    {"before a step at the end", {0, 1, 1}, 0.5, Beyond::clamp, 0, 1, 0.5},
    {"on a step at the end", {0, 1, 1}, 1, Beyond::clamp, 1, 2, 1},
    {"behind a step at the end", {0, 1, 1}, 2, Beyond::clamp, 1, 2, 1},
    {"before a step, held", {1, 1, 3}, 0, Beyond::extrapolate, 0, 1, 0},
    {"behind a step, held", {0, 1, 1}, 2, Beyond::extrapolate, 1, 2, 1},
    {"NaN at a step", {0, 1, 1}, notANumber, Beyond::clamp, 1, 2, notANumber},
    {"descending, on a step", {3, 1, 1, 0}, 1, Beyond::clamp, 2, 3, 0},
    {"descending, on a step at the end", {3, 1, 1}, 1, Beyond::clamp, 1, 2, 1},
    {"descending, before a step at the beginning", {3, 3, 1}, 4, Beyond::clamp, 0, 1, 0},
    {"nothing but a step, before", {1, 1}, 0, Beyond::clamp, 0, 1, 0},
    {"nothing but a step, on it", {1, 1}, 1, Beyond::clamp, 0, 1, 1},
    {"one node, on it", {2}, 2, Beyond::clamp, 0, 0, 0},
    {"one node, clamped", {2}, 5, Beyond::clamp, 0, 0, 0},
    {"one node, held", {2}, 5, Beyond::extrapolate, 0, 0, 0},
    {"one node, on it, no value beyond", {2}, 2, Beyond::notANumber, 0, 0, 0},
    {"one node, no value", {2}, 5, Beyond::notANumber, 0, 0, notANumber},
    {"one node, NaN", {2}, notANumber, Beyond::clamp, 0, 0, notANumber},
    {"denormal nodes", {0, 4 * smallest}, smallest, Beyond::clamp, 0, 1, 0.25},
    {"neighbouring denormals", {smallest, 2 * smallest}, 2 * smallest, Beyond::clamp, 0, 1, 1},
    {"nodes whose distance overflows", {-largest, largest}, 0, Beyond::clamp, 0, 1, 0.5},
    {"an end of these", {-largest, largest}, largest, Beyond::clamp, 0, 1, 1},
    {"descending, distance overflows",
     {largest, -largest},
     0.5 * largest,
     Beyond::clamp,
     0,
     1,
     0.25},
    {"huge ratio", {1e-300, 1, 1e300}, 1e-300, Beyond::clamp, 0, 1, 0},
    {"huge ratio, between", {1e-300, 1, 1e300}, 1e299, Beyond::clamp, 1, 2, 0.1},
};

TEST(Interpolation, BracketsPlacesOnAxesOfEveryKind) {
    for (const Place& one : onAxes) {
        const Bracket found = bracket(one.axis, one.x, one.beyond);
        EXPECT_EQ(found.below, one.below) << one.name;
        EXPECT_EQ(found.above, one.above) << one.name;
        expectSame(found.fraction, one.fraction, one.name);
        for (std::size_t near = 0; near < one.axis.size() + 3; ++near) {
            const Bracket same = bracketNear(near, one.axis, one.x, one.beyond);
            EXPECT_EQ(same.below, found.below) << one.name << " from " << near;
            EXPECT_EQ(same.above, found.above) << one.name << " from " << near;
            expectSame(same.fraction, found.fraction, one.name);
        }
    }
}

TEST(Interpolation, TakesCoordinatesFromElementsOfAnyRange) {
    struct Knot {
        float place;
        double value;
        double negative() const { return -static_cast<double>(place); }
    };
    const std::array<Knot, 3> knots = {{{1.0F, 10.0}, {2.0F, 20.0}, {4.0F, 30.0}}};
    EXPECT_EQ(bracket(knots, 3.0, Beyond::clamp, &Knot::place).below, 1u);
    EXPECT_EQ(bracket(knots, 3.0, Beyond::clamp, &Knot::place).fraction, 0.5);
    EXPECT_EQ(bracket(knots, -3.0, Beyond::clamp, &Knot::negative).fraction, 0.5) << "descends";
    const auto square = [](const Knot& knot) { return knot.place * knot.place; };
    EXPECT_EQ(bracket(std::span(knots).first(2), 2.5, Beyond::clamp, square).fraction, 0.5);
    constexpr double plain[] = {0.0, 10.0, 30.0};
    EXPECT_EQ(bracket(plain, 20.0).fraction, 0.5);
    EXPECT_EQ(interpolate(plain, std::vector<double>{1.0, 2.0, 4.0}, 20.0), 3.0);
}

/// An axis of random steps, some of which are none, and a value for each node.
struct Table {
    std::vector<double> axis, values;
};
Table randomTable(std::mt19937& random, bool descends) {
    std::uniform_int_distribution<int> count(1, 40);
    std::uniform_real_distribution<double> step(-0.3, 1.0), value(-1.0, 1.0);
    Table table;
    double place = value(random);
    for (int i = count(random); i > 0; --i) {
        table.axis.push_back(place);
        table.values.push_back(value(random));
        place += std::max(step(random), 0.0);
    }
    if (descends) {
        std::ranges::reverse(table.axis);
    }
    return table;
}

TEST(Interpolation, IsExactAtNodesOfWhichTheLastOfEqualOnesCounts) {
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        const Table table = randomTable(random, round % 2 == 1);
        for (std::size_t i = 0; i < table.axis.size(); ++i) {
            const bool isLast = i + 1 == table.axis.size() || table.axis[i + 1] != table.axis[i];
            if (isLast) {
                for (const Beyond beyond :
                     {Beyond::clamp, Beyond::extrapolate, Beyond::notANumber}) {
                    EXPECT_EQ(interpolate(table.axis, table.values, table.axis[i], beyond),
                              table.values[i]);
                }
            }
        }
    }
}

TEST(Interpolation, FindsWhatALookAtEveryNodeFinds) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> along(-0.2, 1.2);
    for (int round = 0; round < 5000; ++round) {
        const Table table = randomTable(random, round % 2 == 1);
        const auto& [axis, values] = table;
        const double x = axis.front() + along(random) * (axis.back() - axis.front());
        const bool descends = axis.front() > axis.back();
        std::size_t below = 0;
        while (below + 2 < axis.size() &&
               (descends ? axis[below + 1] >= x : axis[below + 1] <= x)) {
            ++below;
        }
        const Bracket found = bracket(axis, x);
        EXPECT_EQ(found.below, below);
        EXPECT_EQ(found.above, std::min(below + 1, axis.size() - 1));
        EXPECT_GE(found.fraction, 0.0);
        EXPECT_LE(found.fraction, 1.0);
        const double beyond = interpolate(axis, values, x, Beyond::extrapolate);
        if (found.fraction > 0.0 && found.fraction < 1.0) {
            EXPECT_EQ(interpolate(axis, values, x), beyond);
            EXPECT_EQ(interpolate(axis, values, x, Beyond::notANumber), beyond);
        } else if (found.above > found.below && axis[found.above] != axis[found.below]) {
            const double slope = (values[found.above] - values[found.below]) /
                                 (axis[found.above] - axis[found.below]);
            EXPECT_NEAR(beyond, values[found.below] + slope * (x - axis[found.below]),
                        1e-12 * (1.0 + std::abs(slope)));
        }
    }
}

TEST(Interpolation, RisesWithItsValuesAndStaysBetweenThem) {
    std::mt19937 random(3);
    for (int round = 0; round < 500; ++round) {
        Table table = randomTable(random, false);
        std::ranges::sort(table.values);
        std::uniform_real_distribution<double> along(table.axis.front() - 0.1,
                                                     table.axis.back() + 0.1);
        std::vector<double> places(200);
        std::ranges::generate(places, [&] { return along(random); });
        for (const double node : table.axis) {
            places.insert(places.end(),
                          {node, std::nextafter(node, -infinity), std::nextafter(node, infinity)});
        }
        std::ranges::sort(places);
        double before = table.values.front();
        for (const double x : places) {
            const double value = interpolate(table.axis, table.values, x);
            EXPECT_GE(value, before) << x;
            before = value;
        }
        EXPECT_LE(before, table.values.back());
    }
}

struct Line {
    std::string name;
    double a, b, t, value;
};

TEST(Interpolation, LiesOnTheLineBetweenTwoValues) {
    const std::vector<Line> lines = {
        {"between", 2, 4, 0.25, 2.5},
        {"falling", 4, 2, 0.25, 3.5},
        {"across zero", -1, 3, 0.5, 1},
        {"beyond the end", 2, 4, 2, 6},
        {"before the beginning", 2, 4, -1, 0},
        {"equal ends", 3, 3, 0.7, 3},
        {"the beginning, whatever the end is", 5, notANumber, 0, 5},
        {"the end, whatever the beginning is", infinity, 5, 1, 5},
        {"small end of a large beginning", 1e300, 1e-300, 1, 1e-300},
        {"NaN between", 1, 2, notANumber, notANumber},
        {"NaN between falling", 2, 1, notANumber, notANumber},
        {"NaN between equals", 1, 1, notANumber, notANumber},
        {"NaN across zero", -1, 1, notANumber, notANumber},
        {"to infinity", 1, infinity, 0.5, infinity},
        {"a difference that overflows", -largest, largest, 0.5, 0},
        {"and falls", 0x1p1023, -0x1p1023, 0.25, 0x1p1022},
        {"denormals", 2 * smallest, 6 * smallest, 0.5, 4 * smallest},
    };
    for (const Line& one : lines) {
        expectSame(lerp(one.a, one.b, one.t), one.value, one.name);
    }
    static_assert(lerp(2.0, 4.0, 0.25) == 2.5);

    std::mt19937 random(4);
    std::uniform_real_distribution<double> value(-1.0, 1.0), fraction(0.0, 1.0);
    for (int round = 0; round < 100000; ++round) {
        const double a = value(random), b = value(random), t = fraction(random);
        EXPECT_NEAR(lerp(a, b, t), std::lerp(a, b, t), 1e-16);
        EXPECT_EQ(lerp(a, b, 0.0), a);
        EXPECT_EQ(lerp(a, b, 1.0), b);
        const double nearlyEnd = lerp(a, b, 1.0 - 0x1p-53);
        EXPECT_LE(nearlyEnd, std::max(a, b));
        EXPECT_GE(nearlyEnd, std::min(a, b));
    }
}

TEST(Interpolation, GoesByEqualRatiosBetweenTwoValues) {
    const std::vector<Line> lines = {
        {"between", 1, 100, 0.5, 10},
        {"falling", 100, 1, 0.25, std::pow(10.0, 1.5)},
        {"beyond the end", 1, 10, 2, 100},
        {"before the beginning", 1, 10, -1, 0.1},
        {"the beginning", 3, 7e-300, 0, 3},
        {"the end", 3e300, 7e-300, 1, 7e-300},
        {"equal ends", 3, 3, 0.7, 3},
        {"linear to zero", 2, 0, 0.25, 1.5},
        {"linear from zero", 0, 2, 0.25, 0.5},
        {"linear where an end is negative", -2, 2, 0.5, 0},
        {"NaN", 1, 10, notANumber, notANumber},
        {"no number at an end", 1, notANumber, 0.5, notANumber},
    };
    for (const Line& one : lines) {
        const double found = lerpByRatio(one.a, one.b, one.t);
        if (std::isnan(one.value)) {
            EXPECT_TRUE(std::isnan(found)) << one.name;
        } else {
            EXPECT_NEAR(found, one.value, 1e-15 * std::abs(one.value)) << one.name;
        }
    }
    // Ratios that no number holds.
    EXPECT_NEAR(lerpByRatio(1e-300, 1e300, 0.5), 1.0, 1e-12);
    EXPECT_NEAR(lerpByRatio(1e300, 1e-300, 0.75) / 1e-150, 1.0, 1e-12);
    EXPECT_NEAR(lerpByRatio(smallest, largest, 0.5) / (std::sqrt(smallest) * std::sqrt(largest)),
                1.0, 1e-12);

    std::mt19937 random(5);
    std::uniform_real_distribution<double> exponent(-8.0, 8.0), fraction(-0.5, 1.5);
    for (int round = 0; round < 10000; ++round) {
        const double a = std::pow(10.0, exponent(random)), b = std::pow(10.0, exponent(random));
        const double t = fraction(random), value = lerpByRatio(a, b, t);
        EXPECT_EQ(lerpByRatio(a, b, 0.0), a);
        EXPECT_EQ(lerpByRatio(a, b, 1.0), b);
        EXPECT_NEAR(std::log(value), std::lerp(std::log(a), std::log(b), t), 1e-13);
        EXPECT_NEAR(fractionByRatio(a, b, value), t,
                    1e-13 * (1.0 + 1.0 / std::abs(std::log(b / a))));
    }
}

} // namespace

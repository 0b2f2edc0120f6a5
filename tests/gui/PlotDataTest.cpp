#include "gui/plot/PlotData.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace smat::gui {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

TEST(PlotDataTest, ReadsACurveLinearlyBetweenItsSamples) {
    const Curve curve{"a", {0.0, 2.0, 4.0}, {1.0, 5.0, 3.0}};
    EXPECT_DOUBLE_EQ(*curve.valueAt(0.0), 1.0);
    EXPECT_DOUBLE_EQ(*curve.valueAt(0.5), 2.0);
    EXPECT_DOUBLE_EQ(*curve.valueAt(3.0), 4.0);
    EXPECT_DOUBLE_EQ(*curve.valueAt(4.0), 3.0);
}

TEST(PlotDataTest, HasNoValueOutsideTheSamplesOrBesideAGap) {
    const Curve curve{"a", {0.0, 1.0, 2.0, 3.0}, {1.0, gap, 2.0, 3.0}};
    EXPECT_FALSE(curve.valueAt(-0.1));
    EXPECT_FALSE(curve.valueAt(3.1));
    EXPECT_FALSE(curve.valueAt(0.5));
    EXPECT_FALSE(curve.valueAt(1.5));
    EXPECT_DOUBLE_EQ(*curve.valueAt(2.5), 2.5);
    EXPECT_FALSE((Curve{}).valueAt(0.0));
}

TEST(PlotDataTest, ReadsADescendingAxisToo) {
    const Curve curve{"a", {5.0, 4.0, 3.0}, {1.0, 2.0, 3.0}};
    EXPECT_DOUBLE_EQ(*curve.valueAt(4.5), 1.5);
}

TEST(PlotDataTest, GoesOverTheSeamOfAPeriodicAxis) {
    Curve curve{"a", {}, {}};
    for (int angle = 0; angle < 360; angle += 10) {
        curve.x.push_back(angle);
        curve.y.push_back(angle == 350 ? 10.0 : (angle == 0 ? 20.0 : 0.0));
    }
    EXPECT_DOUBLE_EQ(*curve.valueAt(355.0, 360.0), 15.0);
    EXPECT_DOUBLE_EQ(*curve.valueAt(-5.0, 360.0), 15.0);
    EXPECT_DOUBLE_EQ(*curve.valueAt(725.0, 360.0), 10.0);
}

TEST(PlotDataTest, DoesNotCloseACurveOfHalfATurn) {
    const Curve half{"a", {0.0, 90.0, 180.0}, {1.0, 2.0, 3.0}};
    EXPECT_FALSE(half.valueAt(270.0, 360.0));
}

TEST(PlotDataTest, RangeLeavesOutWhatAnAxisCannotShow) {
    const std::vector<Curve> curves{{"a", {1.0, 2.0, 3.0}, {-1.0, gap, 4.0}}};
    EXPECT_DOUBLE_EQ(rangeOf(curves, &Curve::y, false)->minimum, -1.0);
    EXPECT_DOUBLE_EQ(rangeOf(curves, &Curve::y, true)->minimum, 4.0);
    EXPECT_FALSE(rangeOf({{"a", {1.0}, {gap}}}, &Curve::y, false));
}

TEST(PlotDataTest, WritesOneAbscissaForCurvesThatShareIt) {
    const std::vector<Curve> curves{{"a", {1.0, 2.0}, {3.0, 4.0}},
                                    {"b, c", {1.0, 2.0}, {5.0, gap}}};
    EXPECT_EQ(toCsv(curves, "Range (m)", "I"), "Range (m),I: a,\"I: b, c\"\n1,3,5\n2,4,\n");
}

TEST(PlotDataTest, WritesAnAbscissaForEachCurveWhereTheyDiffer) {
    const std::vector<Curve> curves{{"a", {1.0, 2.0}, {3.0, 4.0}}, {"b", {9.0}, {5.0}}};
    EXPECT_EQ(toCsv(curves, "t", "I"), "t,I: a,t,I: b\n1,3,9,5\n2,4,,\n");
}

TEST(PlotDataTest, WritesTheVisiblePartAlone) {
    const std::vector<Curve> curves{{"a", {1.0, 2.0, 3.0}, {3.0, 4.0, 5.0}}};
    EXPECT_EQ(toCsv(curves, "t", "I", Interval{1.5, 2.5}), "t,I: a\n2,4\n");
}

} // namespace
} // namespace smat::gui

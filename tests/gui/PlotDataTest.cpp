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

/// Three samples, of which the middle one warns of something.
Curve warnedCurve() {
    Curve curve{"a", {0.0, 10.0, 30.0}, {3.0, 4.0, 5.0}};
    curve.warnings = {"", "cut, by the frame", ""};
    return curve;
}

TEST(PlotDataTest, ASampleIsAskedForItsWarningFromAsNearAsIsNearest) {
    Curve curve = warnedCurve();
    EXPECT_EQ(curve.warningAt(4.9), "");
    EXPECT_EQ(curve.warningAt(5.1), "cut, by the frame");
    EXPECT_EQ(curve.warningAt(19.9), "cut, by the frame");
    EXPECT_EQ(curve.warningAt(20.1), "");
    curve.x = {0.0, 350.0, 200.0};
    EXPECT_EQ(curve.warningAt(-11.0, 360.0), "cut, by the frame");
    curve.y[1] = gap;
    EXPECT_EQ(curve.warningAt(-11.0, 360.0), "");
    EXPECT_EQ((Curve{"b", {1.0}, {2.0}}).warningAt(1.0), "");
}

TEST(PlotDataTest, WarningsStandBesideTheirValues) {
    EXPECT_EQ(toCsv({warnedCurve()}, "t", "I"),
              "t,I: a,warning\n0,3,\n10,4,\"cut, by the frame\"\n30,5,\n");
    const Curve other{"b", {0.0, 10.0, 30.0}, {1.0, 1.0, 1.0}};
    EXPECT_EQ(toCsv({warnedCurve(), other}, "t", "I", Interval{5.0, 15.0}),
              "t,I: a,Warning of I: a,I: b\n10,4,\"cut, by the frame\",1\n");
}

TEST(PlotDataTest, ASmoothCurveWarnsAtItsSamplesAlone) {
    Curve curve = warnedCurve();
    curve.isSmooth = true;
    const Curve drawn = curve.drawn();
    ASSERT_GT(drawn.x.size(), 3u);
    for (std::size_t i = 0; i < drawn.x.size(); ++i) {
        EXPECT_EQ(drawn.warnings[i].isEmpty(), drawn.x[i] != 10.0) << drawn.x[i];
    }
}

TEST(PlotDataTest, ANoteStatesTheOneWarningOrHowManyThereAre) {
    EXPECT_EQ(warningNote({warnedCurve(), warnedCurve()}), "hollow points: cut, by the frame");
    Curve other = warnedCurve();
    other.warnings[0] = "too near";
    EXPECT_EQ(warningNote({warnedCurve(), other}), "hollow points: 2 warnings");
    EXPECT_EQ(warningNote({{"a", {1.0}, {2.0}}}), "");
}

} // namespace
} // namespace smat::gui

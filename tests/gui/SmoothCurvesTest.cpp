// Plots whose cases followed their curves: drawn and read as smooth curves, the others straight.
#include <cmath>
#include <limits>

#include <QTest>
#include <QwtPolarCanvas>
#include <gtest/gtest.h>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/data/AkimaInterpolant.h"
#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

/// Round, with steps of 30 degrees and a finer one at its beginning.
Curve ring(bool isSmooth) {
    Curve curve{"ring", {0.0, 1.0}, {100.0, 100.0}};
    for (int angle = 30; angle < 360; angle += 30) {
        curve.x.push_back(angle);
        curve.y.push_back(100.0);
    }
    curve.isSmooth = isSmooth;
    return curve;
}

TEST(SmoothCurve, IsDrawnThroughItsSamplesAndReadAsItIsDrawn) {
    Curve curve{"lobe", {}, {}};
    for (const double x : {0.0, 10.0, 15.0, 20.0, 40.0, 60.0}) {
        curve.x.push_back(x);
        curve.y.push_back(std::cos(irsg::radians(x)));
        curve.error.push_back(0.001 * x);
    }
    EXPECT_EQ(curve.drawn().x, curve.x) << "straight unless it is smooth";
    EXPECT_DOUBLE_EQ(*curve.valueAt(50.0), 0.5 * (curve.y[4] + curve.y[5]));
    curve.isSmooth = true;
    const Curve drawn = curve.drawn();
    drawn.check();
    EXPECT_GT(drawn.x.size(), 30u);
    const AkimaInterpolant through(curve.x, curve.y);
    for (std::size_t i = 0; i < drawn.x.size(); ++i) {
        EXPECT_NEAR(drawn.y[i], through.at(drawn.x[i]), 1e-12);
        EXPECT_NEAR(*curve.valueAt(drawn.x[i]), drawn.y[i], 1e-12);
        EXPECT_NEAR(drawn.error[i], 0.001 * drawn.x[i], 1e-12) << "with its band";
    }
    EXPECT_FALSE(curve.valueAt(61.0));
    EXPECT_TRUE(toCsv({curve}, "x", "y").count('\n') == 7) << "files have the samples alone";
}

TEST(SmoothCurve, KeepsGapsAndLeavesWhatDoesNotAscend) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    Curve curve{"broken", {0, 1, 2, 3, 4, 5, 6}, {0, 1, 4, gap, 16, 25, 36}};
    curve.isSmooth = true;
    const Curve drawn = curve.drawn();
    EXPECT_NEAR(*curve.valueAt(1.5), 2.25, 1e-12);
    EXPECT_NEAR(*curve.valueAt(5.5), 30.25, 1e-12);
    EXPECT_FALSE(curve.valueAt(2.5));
    EXPECT_FALSE(curve.valueAt(3.5));
    for (std::size_t i = 0; i < drawn.x.size(); ++i) {
        if (drawn.x[i] > 2.0 && drawn.x[i] < 4.0) {
            EXPECT_TRUE(std::isnan(drawn.y[i])) << drawn.x[i];
        }
    }
    Curve back{"back", {0, 2, 1}, {0, 2, 5}};
    back.isSmooth = true;
    EXPECT_EQ(back.drawn().x, back.x);
}

TEST(SmoothCurve, ClosesATurnWhateverItsFirstStepIs) {
    const Curve curve = ring(true);
    EXPECT_TRUE(curve.goesRound(360.0));
    EXPECT_NEAR(*curve.valueAt(345.0, 360.0), 100.0, 1e-9);
    const Curve drawn = curve.drawn(360.0);
    EXPECT_GT(drawn.x.back(), 350.0) << "into the seam";
    Curve sector{"sector", {0, 30, 60, 90, 120}, {1, 2, 3, 2, 1}};
    sector.isSmooth = true;
    EXPECT_FALSE(sector.goesRound(360.0));
    EXPECT_EQ(sector.drawn(360.0).x.back(), 120.0);
}

TEST(SmoothCurve, IsRoundOnAPolarPlotWhereAStraightOneIsAPolygon) {
    for (const bool isSmooth : {true, false}) {
        PolarPlot plot(PlotStyle::screen(QPalette()));
        plot.resize(620, 680);
        plot.setData({.title = "",
                      .conditions = {},
                      .radiusTitle = "",
                      .directionNote = "",
                      .clockwise = true,
                      .curves = {ring(isSmooth)}});
        plot.show();
        QTest::qWait(20);
        const auto isDrawnAt = [&](double angle_deg, double radius) {
            return test::showsColorAt(*plot.canvas(), plot.canvasPoint(angle_deg, radius),
                                      PlotStyle::screen(plot.palette()).curve(0));
        };
        EXPECT_TRUE(isDrawnAt(90.0, 100.0));
        for (const double angle_deg : {45.0, 135.0, 345.0}) {
            EXPECT_EQ(isDrawnAt(angle_deg, 100.0), isSmooth) << angle_deg;
            EXPECT_EQ(isDrawnAt(angle_deg, 100.0 * std::cos(irsg::radians(15.0))), !isSmooth)
                << angle_deg;
        }
    }
}

TEST(SmoothCurve, IsWhatAdaptiveResultsHave) {
    ResultTable table;
    table.add("angle", "deg");
    table.add("intensity", "W sr-1");
    for (const double angle : {0.0, 90.0, 180.0, 270.0}) {
        table.addRow({angle, 10.0});
    }
    table.provenance.add("analysis", "polar");
    const auto isSmooth = [&] {
        return polarData({{"a", &table}}, "intensity").curves.front().isSmooth;
    };
    EXPECT_FALSE(isSmooth());
    table.provenance.add("polar.steps", "adaptive");
    EXPECT_TRUE(isSmooth());
}

} // namespace
} // namespace smat::gui

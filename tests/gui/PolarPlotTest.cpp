#include "gui/plot/PolarPlot.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <QTest>
#include <QWheelEvent>
#include <QwtLegendLabel>
#include <QwtPolarCanvas>
#include <gtest/gtest.h>

#include "gui/plot/PlotNavigator.h"
#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

Curve rose(const QString& name, double level, double spikeAt = -1.0) {
    Curve curve{name, {}, {}};
    for (int angle = 0; angle < 360; angle += 5) {
        const double side = std::abs(std::sin(angle * std::numbers::pi / 180.0));
        curve.x.push_back(angle);
        curve.y.push_back(angle == spikeAt ? 2.0 * level : level * (0.3 + 0.6 * side));
    }
    return curve;
}

PolarData camera(std::vector<Curve> curves, bool clockwise = true) {
    return {.title = "Contrast intensity over camera azimuth, view offset 10°",
            .conditions = {},
            .radiusTitle = "Contrast intensity (W·sr⁻¹)",
            .directionNote = "clockwise from the nose, 90° is starboard",
            .clockwise = clockwise,
            .curves = std::move(curves)};
}

class PolarPlotTest : public ::testing::Test {
  protected:
    PolarPlotTest() : plot(PlotStyle::screen(QPalette())) { plot.resize(620, 680); }
    void showIt() {
        plot.show();
        QTest::qWait(20);
    }
    /// Whether the picture holds the first curve's colour near a point of the canvas.
    bool drawnAt(const QPointF& canvasPoint) {
        return test::showsColorAt(*plot.canvas(), canvasPoint,
                                  PlotStyle::screen(plot.palette()).curve(0));
    }
    PolarPlot plot;
};

TEST_F(PolarPlotTest, PutsTheNoseAtTheTopAndStarboardRightWhenClockwise) {
    plot.setData(camera({rose("a", 100.0, 90.0)}));
    showIt();
    const QPointF pole = plot.plotRect().center();
    const QPointF nose = plot.canvasPoint(0.0, 30.0);
    EXPECT_NEAR(nose.x(), pole.x(), 0.01);
    EXPECT_LT(nose.y(), pole.y());
    const QPointF spike = plot.canvasPoint(90.0, 200.0);
    EXPECT_GT(spike.x(), pole.x());
    EXPECT_NEAR(spike.y(), pole.y(), 0.01);

    // The picture itself shows the spike there, and none at the mirrored place.
    EXPECT_TRUE(drawnAt(spike));
    EXPECT_FALSE(drawnAt(2.0 * pole - spike));
    test::keepScreenshot(plot, "plot-polar");
}

TEST_F(PolarPlotTest, PutsNinetyDegreesLeftWhenCounterClockwise) {
    plot.setData(camera({rose("a", 100.0, 90.0)}, false));
    showIt();
    const QPointF pole = plot.plotRect().center();
    const QPointF spike = plot.canvasPoint(90.0, 200.0);
    EXPECT_LT(spike.x(), pole.x());
    EXPECT_TRUE(drawnAt(spike));
    EXPECT_FALSE(drawnAt(2.0 * pole - spike));
}

TEST_F(PolarPlotTest, LegendHasTheColourOfEachCurveFromTheStart) {
    plot.setData(camera({rose("a", 10.0), rose("b", 20.0)}));
    const auto labels = plot.findChildren<QwtLegendLabel*>();
    ASSERT_EQ(labels.size(), 2);
    for (int i = 0; i < 2; ++i) {
        const QImage icon = labels[i]->icon().toImage();
        const QColor middle = icon.pixelColor(icon.width() / 2, icon.height() / 2);
        EXPECT_EQ(middle.name(), PlotStyle::screen(QPalette()).curve(i).name());
    }
}

TEST_F(PolarPlotTest, APointThatWarnsOfSomethingIsHollow) {
    PolarData data = camera({rose("a", 100.0)});
    data.curves[0].warnings.resize(data.curves[0].x.size());
    data.curves[0].warnings[9] = "cut by the frame";
    plot.navigator().setCrosshairVisible(false);
    plot.setData(data);
    showIt();
    const auto colorAt = [&](std::size_t sample) {
        const Curve& curve = plot.data().curves[0];
        const QPointF point = plot.canvasPoint(curve.x[sample], curve.y[sample]);
        return plot.canvas()->grab().toImage().pixelColor(point.toPoint());
    };
    EXPECT_EQ(colorAt(9), plot.look().canvas);
    EXPECT_NE(colorAt(12), plot.look().canvas);
    const QString there = plot.readoutAt(plot.canvasPoint(46.0, 50.0));
    EXPECT_TRUE(there.contains("warning: cut by the frame")) << there.toStdString();
    EXPECT_FALSE(plot.readoutAt(plot.canvasPoint(49.0, 50.0)).contains("warning"));
}

TEST_F(PolarPlotTest, ErrorsLargerThanValuesLeaveZeroInTheMiddle) {
    PolarData data = camera({rose("a", 100.0)});
    data.curves[0].error.assign(data.curves[0].y.size(), 1.0);
    data.curves[0].error[3] = 400.0;
    plot.setData(data);
    showIt();
    const QPointF middle = plot.plotRect().center();
    EXPECT_NEAR(plot.canvasPoint(30.0, 0.0).x(), middle.x(), 0.01);
    EXPECT_NEAR(plot.canvasPoint(30.0, 0.0).y(), middle.y(), 0.01);
    data.curves[0].y[3] = -50.0;
    plot.setData(data);
    EXPECT_GT(middle.y() - plot.canvasPoint(0.0, 0.0).y(), 1.0) << "values below 0 need room";
}

TEST_F(PolarPlotTest, ClosesACurveThatGoesRound) {
    plot.setData(camera({rose("a", 100.0)}));
    showIt();
    const double between = 0.5 * (plot.data().curves[0].y.front() + plot.data().curves[0].y.back());
    EXPECT_TRUE(drawnAt(plot.canvasPoint(357.5, between)));
}

TEST_F(PolarPlotTest, ReadsTheAngleUnderTheCursor) {
    plot.setData(camera({rose("a", 100.0, 90.0)}));
    showIt();
    EXPECT_TRUE(plot.readoutAt(plot.canvasPoint(90.0, 120.0)).startsWith("90.0°"));
    EXPECT_TRUE(plot.readoutAt(plot.canvasPoint(90.0, 120.0)).contains("200"));
    EXPECT_TRUE(plot.readoutAt(plot.canvasPoint(300.0, 60.0)).startsWith("300.0°"));
}

TEST_F(PolarPlotTest, BeginsBelowZeroForNegativeContrast) {
    auto curve = rose("warm ship, cold sea", 100.0);
    auto negative = rose("cold ship, warm sea", -60.0);
    plot.setData(camera({curve, negative}));
    showIt();
    const QPointF pole = plot.plotRect().center();
    const auto distance = [&](double value) {
        return std::abs(plot.canvasPoint(0.0, value).y() - pole.y());
    };
    EXPECT_LT(distance(-50.0), distance(0.0));
    EXPECT_GT(distance(0.0), 10.0);
    test::keepScreenshot(plot, "plot-polar-negative");
}

TEST_F(PolarPlotTest, DecibelRadiusLeavesOutWhatHasNoLogarithmAndSaysSo) {
    auto curve = rose("a", 100.0);
    curve.y[10] = 0.0;
    curve.y[11] = -1.0;
    plot.setData(camera({curve}));
    EXPECT_EQ(plot.samplesLeftOut(), 0);
    plot.setRadiusScale(RadiusScale::decibel);
    EXPECT_EQ(plot.samplesLeftOut(), 2);
    showIt();
    const QPointF pole = plot.plotRect().center();
    const double full = std::abs(plot.canvasPoint(0.0, 90.0).y() - pole.y());
    const double tenth = std::abs(plot.canvasPoint(0.0, 9.0).y() - pole.y());
    EXPECT_NEAR(tenth / full, 30.0 / 40.0, 0.01);
    test::keepScreenshot(plot, "plot-polar-decibel");
}

TEST_F(PolarPlotTest, WheelKeepsThePointUnderTheCursor) {
    plot.setData(camera({rose("a", 100.0)}));
    showIt();
    const QPointF place = plot.canvasPoint(60.0, 70.0);
    for (int i = 0; i < 4; ++i) {
        QWheelEvent event(place, plot.canvas()->mapToGlobal(place), {}, {0, 120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(plot.canvas(), &event);
    }
    const QPointF after = plot.canvasPoint(60.0, 70.0);
    EXPECT_NEAR(after.x(), place.x(), 1.5);
    EXPECT_NEAR(after.y(), place.y(), 1.5);
    EXPECT_LT(plot.zoomFactor(), 0.6);
    QTest::mouseDClick(plot.canvas(), Qt::LeftButton, {}, place.toPoint());
    EXPECT_DOUBLE_EQ(plot.zoomFactor(), 1.0);
}

TEST_F(PolarPlotTest, LivesWithMissingValuesAndWithNone) {
    auto curve = rose("a", 100.0);
    const double there = curve.y[7]; // at 35 degrees, between 30 and 40
    plot.setData(camera({curve}));
    showIt();
    EXPECT_TRUE(drawnAt(plot.canvasPoint(35.0, there)));
    curve.y[7] = std::numeric_limits<double>::quiet_NaN();
    plot.setData(camera({curve}));
    QTest::qWait(20);
    EXPECT_FALSE(drawnAt(plot.canvasPoint(35.0, there)));
    for (const int neighbour : {5, 9}) {
        EXPECT_TRUE(drawnAt(plot.canvasPoint(curve.x[static_cast<std::size_t>(neighbour)],
                                             curve.y[static_cast<std::size_t>(neighbour)])))
            << neighbour;
    }

    // A sample alone is a dot.
    plot.setData(camera({{"one", {10.0}, {5.0}}}));
    QTest::qWait(20);
    EXPECT_TRUE(drawnAt(plot.canvasPoint(10.0, 5.0)));
    EXPECT_FALSE(drawnAt(plot.canvasPoint(30.0, 5.0)));
    // Zeros lie in the pole, and have no decibels.
    plot.setData(camera({{"zero", {0.0, 90.0}, {0.0, 0.0}}}));
    QTest::qWait(20);
    EXPECT_TRUE(std::isfinite(plot.canvasPoint(0.0, 0.0).x()));
    plot.setData(camera({}));
    plot.setRadiusScale(RadiusScale::decibel);
    QTest::qWait(20);
    const QImage empty = plot.canvas()->grab().toImage();
    const QColor color = PlotStyle::screen(plot.palette()).curve(0);
    long colored = 0;
    for (int y = 0; y < empty.height(); ++y) {
        for (int x = 0; x < empty.width(); ++x) {
            colored += empty.pixelColor(x, y) == color;
        }
    }
    EXPECT_EQ(colored, 0);
}

} // namespace
} // namespace smat::gui

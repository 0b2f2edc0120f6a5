#include "gui/plot/CartesianPlot.h"

#include <cmath>
#include <limits>

#include <QTest>
#include <QWheelEvent>
#include <QwtInterval>
#include <QwtPlotCanvas>
#include <QwtScaleWidget>
#include <QwtText>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gui/plot/CartesianItems.h"
#include "gui/plot/PlotLook.h"
#include "gui/plot/PlotNavigator.h"
#include "irsg/core/Errors.h"
#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

PlotData twoCurves() {
    PlotData data{.title = "Contrast intensity over range",
                  .xTitle = "Range (m)",
                  .yTitle = "Contrast intensity (W·sr⁻¹)",
                  .curves = {}};
    Curve cold{"idle", {}, {}};
    Curve hot{"full power", {}, {}};
    for (int i = 0; i <= 40; ++i) {
        const double range = 500.0 + 237.5 * i;
        cold.x.push_back(range);
        cold.y.push_back(900.0 * std::exp(-range / 5000.0));
        hot.x.push_back(range);
        hot.y.push_back(2400.0 * std::exp(-range / 4000.0));
    }
    data.curves = {cold, hot};
    return data;
}

class CartesianPlotTest : public ::testing::Test {
  protected:
    CartesianPlotTest() : plot(PlotStyle::screen(QPalette())) {
        plot.resize(760, 520);
        plot.setData(twoCurves());
        plot.show();
        QTest::qWait(20);
    }
    QPoint at(double x, double y) const {
        return {qRound(plot.transform(QwtPlot::xBottom, x)),
                qRound(plot.transform(QwtPlot::yLeft, y))};
    }
    void wheel(const QPoint& where, int delta) {
        QWheelEvent event(where, plot.canvas()->mapToGlobal(where), {}, {0, delta}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(plot.canvas(), &event);
    }
    CartesianPlot plot;
};

TEST_F(CartesianPlotTest, ALogarithmicAxisEndsWhereNumbersEnd) {
    PlotData data = twoCurves();
    data.curves.resize(1);
    Curve& curve = data.curves.front();
    curve.error.assign(curve.y.size(), 0.0);
    curve.error.back() = curve.y.back() * (1.0 - 1e-16); // comes to nothing but rounding
    plot.setData(data);
    plot.setLogarithmic(QwtPlot::yLeft, true);
    EXPECT_GT(plot.axisInterval(QwtPlot::yLeft).minValue(), 0.01 * curve.y.back());
    curve.error.clear();
    curve.y.back() = 1e-16; // what is left of a 0
    plot.setData(data);
    plot.setLogarithmic(QwtPlot::yLeft, true);
    EXPECT_GT(plot.axisInterval(QwtPlot::yLeft).minValue(), 1e-9);
}

TEST(AxisNumber, IsWrittenAsAPowerOfTenWhereItIsLongOtherwise) {
    EXPECT_EQ(axisNumber(0.0), "0");
    EXPECT_EQ(axisNumber(0.25), "0.25");
    EXPECT_EQ(axisNumber(0.001), "0.001");
    EXPECT_EQ(axisNumber(500000.0), "500000");
    EXPECT_EQ(axisNumber(1e-5), "10⁻⁵");
    EXPECT_EQ(axisNumber(2e-5), "2·10⁻⁵");
    EXPECT_EQ(axisNumber(-1e7), "-10⁷");
    EXPECT_EQ(axisNumber(2.5e12), "2.5·10¹²");
}

TEST_F(CartesianPlotTest, WrapsTheTitleOfAShortAxis) {
    const auto* scale = plot.axisWidget(QwtPlot::yLeft);
    const int wide = scale->width();
    plot.resize(420, 230);
    QTest::qWait(20);
    const double length = scale->title().textSize(scale->title().font()).width();
    ASSERT_GT(length, scale->height()); // it cannot stand there in one line
    EXPECT_GE(scale->width(), wide + plot.fontMetrics().height() - 2);
    // In every direction the title takes no more than the axis has.
    EXPECT_LE(scale->title().heightForWidth(scale->height()), scale->width());
    test::keepScreenshot(plot, "plot-low");
}

TEST_F(CartesianPlotTest, ShowsAllOfItsCurvesAtFirst) {
    const auto view = plot.view();
    EXPECT_DOUBLE_EQ(view.x.minimum, 500.0);
    EXPECT_DOUBLE_EQ(view.x.maximum, 10000.0);
    EXPECT_LT(view.y.minimum, 900.0 * std::exp(-2.0));
    EXPECT_GT(view.y.maximum, 2400.0 * std::exp(-0.125));
    test::keepScreenshot(plot, "plot-cartesian");
}

TEST_F(CartesianPlotTest, WheelZoomsAtTheCursorAndKeepsWhatLiesUnderIt) {
    const QPoint cursor = at(3000.0, 800.0);
    const double before = plot.invTransform(QwtPlot::xBottom, cursor.x());
    wheel(cursor, 240);
    EXPECT_NEAR(plot.invTransform(QwtPlot::xBottom, cursor.x()), before, 1.0);
    EXPECT_NEAR(plot.view().x.maximum - plot.view().x.minimum, 9500.0 * 0.85 * 0.85, 40.0);
}

TEST_F(CartesianPlotTest, DraggedRectangleBecomesTheView) {
    QTest::mousePress(plot.canvas(), Qt::LeftButton, {}, at(2000.0, 1000.0));
    QTest::mouseMove(plot.canvas(), at(4000.0, 500.0));
    QTest::mouseRelease(plot.canvas(), Qt::LeftButton, {}, at(4000.0, 500.0));
    EXPECT_NEAR(plot.view().x.minimum, 2000.0, 20.0);
    EXPECT_NEAR(plot.view().x.maximum, 4000.0, 20.0);
    EXPECT_NEAR(plot.view().y.maximum, 1000.0, 10.0);
    plot.undoZoom();
    EXPECT_DOUBLE_EQ(plot.view().x.maximum, 10000.0);
}

TEST_F(CartesianPlotTest, RightDragPansAndDoubleClickShowsAll) {
    const QPoint start = at(5000.0, 800.0);
    QTest::mousePress(plot.canvas(), Qt::RightButton, {}, start);
    QMouseEvent move(QEvent::MouseMove, QPointF(start - QPoint(80, 0)),
                     QPointF(plot.canvas()->mapToGlobal(start - QPoint(80, 0))), Qt::NoButton,
                     Qt::RightButton, Qt::NoModifier);
    QCoreApplication::sendEvent(plot.canvas(), &move);
    QTest::mouseRelease(plot.canvas(), Qt::RightButton, {}, start - QPoint(80, 0));
    EXPECT_GT(plot.view().x.minimum, 900.0);
    QTest::mouseDClick(plot.canvas(), Qt::LeftButton, {}, start);
    EXPECT_DOUBLE_EQ(plot.view().x.minimum, 500.0);
}

TEST_F(CartesianPlotTest, ReadoutNamesEveryVisibleCurve) {
    const QString both = plot.readoutAt(at(5250.0, 500.0));
    EXPECT_TRUE(both.contains("idle") && both.contains("full power")) << both.toStdString();
    plot.setCurveVisible(0, false);
    const QString one = plot.readoutAt(at(5250.0, 500.0));
    EXPECT_FALSE(one.contains("idle"));
    EXPECT_TRUE(plot.readoutAt(QPointF(-50.0, 0.0)).isEmpty());
}

/// The highest place on the canvas at which the curve's colour is seen near a column.
double topOfCurve(CartesianPlot& plot, double column) {
    const QImage seen = plot.canvas()->grab().toImage().convertToFormat(QImage::Format_RGB32);
    const QColor line = plot.look().curve(0);
    const double ratio = seen.devicePixelRatio();
    const int first = static_cast<int>((column - 1.0) * ratio),
              last = static_cast<int>((column + 2.0) * ratio) - 1;
    for (int y = 0; y < seen.height(); ++y) {
        for (int x = std::max(0, first); x <= std::min(seen.width() - 1, last); ++x) {
            const QColor pixel = seen.pixelColor(x, y);
            if (std::abs(pixel.red() - line.red()) + std::abs(pixel.green() - line.green()) +
                    std::abs(pixel.blue() - line.blue()) <
                60) {
                return y / ratio;
            }
        }
    }
    return -1.0;
}

TEST_F(CartesianPlotTest, ASpikeOfOneSampleIsSeenAtEveryZoom) {
    PlotData data{.title = "", .xTitle = "x", .yTitle = "y", .curves = {Curve{"spike", {}, {}}}};
    for (int i = 0; i < 10000; ++i) {
        data.curves[0].x.push_back(1.0 + i);
        data.curves[0].y.push_back(i == 6180 ? 100.0 : 10.0 + i % 3);
    }
    const double at = 6181.0;
    for (const bool logarithmic : {false, true}) {
        plot.setData(data);
        plot.setLogarithmic(QwtPlot::xBottom, logarithmic);
        for (const double width : {9999.0, 5000.0, 1000.0, 100.0, 10.0, 1.0}) {
            // The spike lies a fifth of the way into the view, but for the whole.
            const double from = width > 9000.0 ? 1.0 : at - 0.2 * width;
            plot.setView({{from, from + width}, {0.0, 120.0}});
            const double column = std::floor(plot.transform(QwtPlot::xBottom, at));
            EXPECT_NEAR(topOfCurve(plot, column), plot.transform(QwtPlot::yLeft, 100.0), 4.0)
                << width << (logarithmic ? " logarithmic" : "");
        }
    }
}

TEST_F(CartesianPlotTest, LogarithmicAxesHoldPositiveValuesOnly) {
    auto data = twoCurves();
    data.curves[0].y[3] = -5.0;
    data.curves[0].y[4] = std::numeric_limits<double>::quiet_NaN();
    plot.setData(data);
    plot.setLogarithmic(QwtPlot::yLeft, true);
    plot.setLogarithmic(QwtPlot::xBottom, true);
    EXPECT_GT(plot.view().y.minimum, 0.0);
    QTest::qWait(20);
    test::keepScreenshot(plot, "plot-cartesian-logarithmic");
}

TEST_F(CartesianPlotTest, ZoomingForEverStopsInsteadOfLosingTheAxis) {
    for (int i = 0; i < 400; ++i) {
        wheel(at(3000.0, 800.0), 120);
    }
    EXPECT_LT(plot.view().x.minimum, plot.view().x.maximum);
    for (int i = 0; i < 4000; ++i) {
        wheel({100, 100}, -120);
    }
    EXPECT_TRUE(std::isfinite(plot.view().x.maximum));
}

TEST_F(CartesianPlotTest, LeavesRoomForDotsWhereXBeginsAndEnds) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    PlotData data;
    data.curves = {{"a way", {1.0, 1.0, 10.0, 10.0, 100.0, 100.0}, {2.0, gap, 3.0, gap, 1.0, gap}}};
    const auto widthOf = [&](double x) { return plot.transform(QwtPlot::xBottom, x); };
    for (const bool logarithmic : {false, true}) {
        data.xLogarithmic = logarithmic;
        plot.setData(data);
        EXPECT_GE(widthOf(1.0), 4.0) << logarithmic;
        EXPECT_LE(widthOf(100.0), plot.canvas()->width() - 4.0) << logarithmic;
    }
    data.curves = {{"a line", {1.0, 10.0, 100.0}, {2.0, 3.0, 1.0}}};
    plot.setData(data);
    EXPECT_EQ(plot.view().x, (Interval{1.0, 100.0}));
}

TEST(SampledCurve, HasADotInTheLegendWhereThereAreDotsAlone) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    const Curve dots{"dots", {1.0, 1.5, 2.0, 2.5}, {1.0, gap, 2.0, gap}},
        line{"line", {1.0, 2.0}, {1.0, 2.0}};
    const auto edgeOf = [](const Curve& curve) {
        SampledCurve item(curve);
        item.setPen(Qt::black, 2.0);
        const QImage icon = item.legendIcon(0, QSizeF(22, 12)).toImage();
        EXPECT_GT(qAlpha(icon.pixel(icon.width() / 2, icon.height() / 2)), 200)
            << curve.name.toStdString();
        return qAlpha(icon.pixel(2, icon.height() / 2));
    };
    EXPECT_EQ(edgeOf(dots), 0);
    EXPECT_GT(edgeOf(line), 200);
}

TEST_F(CartesianPlotTest, APointThatWarnsOfSomethingIsHollow) {
    PlotData data{.title = "", .xTitle = "x", .yTitle = "y", .curves = {}};
    data.curves = {{"a", {0.0, 1.0, 2.0, 3.0}, {1.0, 1.0, 1.0, 2.0}}};
    const auto colorAt = [&](double x, int right) {
        return plot.canvas()->grab().toImage().pixelColor(at(x, 1.0) + QPoint(right, 0));
    };
    plot.navigator().setCrosshairVisible(false);
    plot.setData(data);
    EXPECT_NE(colorAt(1.0, 0), plot.look().canvas) << "the line";
    data.curves[0].warnings = {"", "cut by the frame", "", ""};
    plot.setData(data);
    EXPECT_EQ(colorAt(1.0, 0), plot.look().canvas);
    EXPECT_NE(colorAt(1.0, 4), plot.look().canvas);
    EXPECT_NE(colorAt(2.0, 0), plot.look().canvas);
    EXPECT_THAT(plot.readoutAt(at(1.2, 1.0)).toStdString(),
                testing::HasSubstr("warning: cut by the frame"));
    EXPECT_THAT(plot.readoutAt(at(1.8, 1.0)).toStdString(),
                testing::Not(testing::HasSubstr("warning")));
    plot.setCurveVisible(0, false);
    EXPECT_THAT(plot.readoutAt(at(1.2, 1.0)).toStdString(),
                testing::Not(testing::HasSubstr("warning")));
}

TEST_F(CartesianPlotTest, RefusesACurveWithMissingOrdinates) {
    PlotData data;
    data.curves = {{"a", {1.0, 2.0}, {1.0}}};
    EXPECT_THROW(plot.setData(data), irsg::LogicError);
}

TEST_F(CartesianPlotTest, DrawsNothingButAxesWithoutCurves) {
    plot.setData({});
    EXPECT_LT(plot.view().x.minimum, plot.view().x.maximum);
}

} // namespace
} // namespace smat::gui

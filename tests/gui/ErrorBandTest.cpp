// Bands of errors as plots draw them, compared with what Qt makes of their whole outline.

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <QBuffer>
#include <QFile>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <QwtPolarPlot>
#include <QwtScaleMap>
#include <QwtTransform>
#include <gtest/gtest.h>

#include "gui/plot/CartesianItems.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotExport.h"
#include "gui/plot/PolarItems.h"
#include "gui/plot/PolarPlot.h"
#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

constexpr int side = 400;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

QImage sheet() {
    QImage picture(side, side, QImage::Format_RGB32);
    picture.fill(Qt::white);
    return picture;
}

/// Of the canvas, to the left and up as a plot has them.
QwtScaleMap mapOf(double low, double high, bool upwards, bool logarithmic = false) {
    QwtScaleMap map;
    if (logarithmic) {
        map.setTransformation(new QwtLogTransform);
    }
    map.setScaleInterval(low, high);
    map.setPaintInterval(upwards ? side : 0.0, upwards ? 0.0 : side);
    return map;
}

/// A wave of many points that leaves the plot on all sides.
Curve wave(int count, const std::function<double(double)>& height) {
    Curve curve{"wave", {}, {}, {}};
    for (int i = 0; i < count; ++i) {
        const double x = -10.0 + 120.0 * i / (count - 1);
        curve.x.push_back(x);
        curve.y.push_back(height(x));
        curve.error.push_back(0.12 * height(x) + 3.0 + 2.0 * std::sin(x / 4.0));
    }
    return curve;
}

/// What an item draws with a pen that is not seen, so that its band alone is left.
template <typename Item, typename Draw>
QImage bandAlone(Item& item, const Draw& draw) {
    item.setPen(QPen(Qt::black, 0.0));
    QImage with = sheet(), without = sheet();
    for (const bool band : {true, false}) {
        item.setBandVisible(band);
        QPainter painter(band ? &with : &without);
        painter.setRenderHint(QPainter::Antialiasing);
        draw(painter);
    }
    // Under the line nothing can be told of the band.
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            if (without.pixel(column, row) != qRgb(255, 255, 255)) {
                with.setPixel(column, row, qRgb(1, 2, 3));
            }
        }
    }
    return with;
}

QImage bandOf(const Curve& curve, const QwtScaleMap& x, const QwtScaleMap& y) {
    SampledCurve item(curve);
    return bandAlone(item, [&](QPainter& painter) {
        item.drawSeries(&painter, x, y, QRectF(0, 0, side, side), 0, -1);
    });
}

QImage polygon(const QPolygonF& outline) {
    QImage picture = sheet();
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    QColor fill(Qt::black);
    fill.setAlphaF(0.22F);
    painter.setBrush(fill);
    painter.drawPolygon(outline, Qt::WindingFill);
    return picture;
}

QPolygonF outlineOf(const Curve& curve, const QwtScaleMap& x, const QwtScaleMap& y) {
    QPolygonF upper, lower;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        upper << QPointF(x.transform(curve.x[i]), y.transform(curve.y[i] + curve.error[i]));
        lower << QPointF(x.transform(curve.x[i]), y.transform(curve.y[i] - curve.error[i]));
    }
    std::reverse(lower.begin(), lower.end());
    return upper + lower;
}

/// By how much the pictures differ beside the line: the largest, and the mean of all pixels, of the
/// depth of the band's colour.
std::pair<double, double> difference(const QImage& drawn, const QImage& wanted) {
    constexpr double depth = 255.0 * 0.22;
    double largest = 0.0, sum = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if (drawn.pixel(x, y) == qRgb(1, 2, 3)) {
                continue;
            }
            const double d = std::abs(qGray(drawn.pixel(x, y)) - qGray(wanted.pixel(x, y))) / depth;
            largest = std::max(largest, d);
            sum += d;
        }
    }
    return {largest, sum / side / side};
}

TEST(ErrorBandTest, ABandOfManyPointsIsTheWholePolygon) {
    const auto x = mapOf(0.0, 100.0, false);
    for (const int count : {7, 300, 20000}) {
        for (const auto& height : std::vector<std::function<double(double)>>{
                 [](double at) { return 50.0 + 30.0 * std::sin(at / 9.0); },
                 [](double at) { return at; },
                 [](double at) { return 50.0 + 400.0 * std::sin(at / 3.0); }}) {
            const Curve curve = wave(count, height);
            const auto y = mapOf(0.0, 100.0, true);
            const auto [largest, mean] =
                difference(bandOf(curve, x, y), polygon(outlineOf(curve, x, y)));
            EXPECT_LT(largest, 0.15) << count;
            EXPECT_LT(mean, 2e-3) << count;
        }
    }
}

TEST(ErrorBandTest, ABandOnLogarithmicAxesIsTheWholePolygon) {
    const auto x = mapOf(1.0, 100.0, false, true), y = mapOf(1.0, 1000.0, true, true);
    Curve curve{"decay", {}, {}, {}};
    for (int i = 0; i < 20000; ++i) {
        curve.x.push_back(std::pow(10.0, -0.1 + 2.2 * i / 19999.0));
        curve.y.push_back(2000.0 / curve.x.back());
        curve.error.push_back(0.6 * curve.y.back());
    }
    const auto [largest, mean] = difference(bandOf(curve, x, y), polygon(outlineOf(curve, x, y)));
    EXPECT_LT(largest, 0.15);
    EXPECT_LT(mean, 2e-3);

    // Where the lower end has no logarithm the band goes down to the frame.
    curve.error.assign(curve.x.size(), 1e4);
    const QImage deep = bandOf(curve, x, y);
    EXPECT_NEAR(qGray(deep.pixel(200, side - 1)), 255.0 * 0.78, 2.0);
}

TEST(ErrorBandTest, ARestlessBandEnclosesWhatItsPointsReach) {
    // Five samples a pixel, up and down: the band is as high as their ends.
    Curve curve{"restless", {}, {}, {}};
    for (int i = 0; i <= 2000; ++i) {
        curve.x.push_back(100.0 * i / 2000);
        curve.y.push_back(i % 2 == 0 ? 40.0 : 60.0);
        curve.error.push_back(10.0);
    }
    const QImage drawn = bandOf(curve, mapOf(0.0, 100.0, false), mapOf(0.0, 100.0, true));
    for (const int column : {5, 200, 394}) {
        EXPECT_NEAR(qGray(drawn.pixel(column, 122)), 255.0 * 0.78, 2.0) << column; // below 70
        EXPECT_EQ(qGray(drawn.pixel(column, 118)), 255) << column;
        EXPECT_NEAR(qGray(drawn.pixel(column, 277)), 255.0 * 0.78, 2.0) << column; // above 30
        EXPECT_EQ(qGray(drawn.pixel(column, 282)), 255) << column;
    }
}

TEST(ErrorBandTest, ABandBeginsAndEndsWithItsSamplesAndLeavesGaps) {
    Curve curve{"gaps", {}, {}, {}};
    for (int i = 0; i <= 10000; ++i) {
        const double x = 10.125 + 80.0 * i / 10000;
        curve.x.push_back(x);
        curve.y.push_back(x > 30.0 && x < 40.0 ? nan : 50.0);
        curve.error.push_back(x > 60.0 && x < 62.0 ? nan : 20.0);
    }
    const QImage drawn = bandOf(curve, mapOf(0.0, 100.0, false), mapOf(0.0, 100.0, true));
    constexpr int row = 150; // in the upper half of the band
    const auto inkAt = [&](int column) { return (255 - qGray(drawn.pixel(column, row))) / 56.1; };
    // From 10.125 · 4 = 40.5 to 90.125 · 4 = 360.5.
    EXPECT_EQ(inkAt(39), 0.0);
    EXPECT_NEAR(inkAt(40), 0.5, 0.04);
    EXPECT_NEAR(inkAt(41), 1.0, 0.04);
    EXPECT_NEAR(inkAt(359), 1.0, 0.04);
    EXPECT_NEAR(inkAt(360), 0.5, 0.04);
    EXPECT_EQ(inkAt(361), 0.0);
    for (int column = 122; column < 159; ++column) {
        ASSERT_EQ(inkAt(column), 0.0) << column;
    }
    for (int column = 242; column < 247; ++column) {
        ASSERT_EQ(inkAt(column), 0.0) << column;
    }
    for (const int column : {118, 161, 238, 249}) {
        EXPECT_NEAR(inkAt(column), 1.0, 0.04) << column;
    }
}

TEST(ErrorBandTest, ABandAroundThePoleIsTheWholePolygon) {
    QwtScaleMap azimuth, radial;
    azimuth.setScaleInterval(0.0, 360.0);
    azimuth.setPaintInterval(0.0, 2.0 * std::numbers::pi);
    radial.setScaleInterval(0.0, 100.0);
    const QRectF canvas(0, 0, side, side);
    for (const int count : {24, 20000}) {
        for (const double reach : {190.0, 5000.0}) {
            radial.setPaintInterval(0.0, reach);
            // Enlarged, the pole lies beside the canvas and a piece of the ring in it.
            const QPointF pole = reach < 1000.0 ? QPointF(200.0, 200.0) : QPointF(-2600.0, 900.0);
            std::vector<PolarSample> samples;
            QPolygonF inner, outer;
            for (int i = 0; i <= count; ++i) {
                const double angle = 360.0 * i / count;
                const double radius =
                    60.0 + 25.0 * std::sin(5.0 * angle * std::numbers::pi / 180.0);
                samples.push_back({angle, radius, radius - 12.0, radius + 12.0});
                const double turn = angle * std::numbers::pi / 180.0;
                const QPointF way(std::cos(turn), -std::sin(turn));
                inner << pole + way * (radius - 12.0) * reach / 100.0;
                outer << pole + way * (radius + 12.0) * reach / 100.0;
            }
            GappedPolarCurve item("ring", samples, GappedPolarCurve::Band::error);
            const QImage with = bandAlone(item, [&](QPainter& painter) {
                item.draw(&painter, azimuth, radial, pole, reach, canvas);
            });
            const QPolygonF ring = outer + QPolygonF(inner.rbegin(), inner.rend());
            const auto [largest, mean] = difference(with, polygon(ring));
            EXPECT_LT(largest, 0.2) << count << " " << reach;
            EXPECT_LT(mean, 2e-3) << count << " " << reach;
            EXPECT_NEAR(qGray(with.pixel(side / 2, reach < 1000.0 ? 199 : 0)), 255, 60);
        }
    }
}

TEST(ErrorBandTest, PaperHoldsBandsAsOutlinesWithAllOfTheirPoints) {
    PlotData data{.title = "", .xTitle = "x", .yTitle = "y", .curves = {}};
    PolarData around{
        .title = "", .conditions = {}, .radiusTitle = "", .directionNote = "", .curves = {}};
    Curve curve{"a", {}, {}, {}};
    for (int i = 0; i < 3000; ++i) {
        curve.x.push_back(0.11 * i);
        curve.y.push_back(50.0 + (i % 2));
        curve.error.push_back(5.0);
    }
    data.curves = {curve};
    around.curves = {curve};
    CartesianPlot cartesian(PlotStyle::paper());
    cartesian.setData(data);
    PolarPlot polar(PlotStyle::paper());
    polar.setData(around);
    const auto folder = test::freshFolder("bands");
    const auto written = [&](PlotSurface& plot, const char* name) {
        if (plot.widget() == &cartesian) {
            exportPlot(cartesian, folder / name);
        } else {
            exportPlot(polar, folder / name);
        }
        QFile file(QString::fromStdString((folder / name).string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    for (PlotSurface* plot :
         {static_cast<PlotSurface*>(&cartesian), static_cast<PlotSurface*>(&polar)}) {
        const QByteArray svg = written(*plot, "a.svg");
        EXPECT_FALSE(svg.contains("<image"));
        // The longest path goes along both edges.
        qsizetype most = 0;
        for (qsizetype at = svg.indexOf("<path"); at >= 0; at = svg.indexOf("<path", at + 1)) {
            most = std::max(most, svg.mid(at, svg.indexOf("/>", at) - at).count('L'));
        }
        EXPECT_GE(most, 2 * 3000 - 2);
        EXPECT_FALSE(written(*plot, "a.pdf").contains("/Subtype /Image"));
    }
}

} // namespace
} // namespace smat::gui

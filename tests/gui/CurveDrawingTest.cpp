#include "gui/plot/CurveDrawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QTemporaryFile>
#include <gtest/gtest.h>

namespace smat::gui {
namespace {

/// A line of many points to and fro over the width of a picture, with rare spikes.
QPolygonF restless(int count, double width) {
    QPolygonF line;
    unsigned state = 12345;
    for (int i = 0; i < count; ++i) {
        state = state * 1664525U + 1013904223U;
        const double noise = static_cast<double>(state >> 8U) / (1U << 24U);
        const double spike = i % 1777 == 5 ? 90.0 : 0.0;
        const double x = width * i / (count - 1);
        line << QPointF(x, 100.0 + 40.0 * std::sin(x / 30.0) + 20.0 * noise - spike);
    }
    return line;
}

QPolygonF thinned(const QPolygonF& line, double columnWidth) {
    return chosen(line, pointsOf(line, columnWidth));
}

QPolygonF edgeOf(const QPolygonF& line, double columnWidth, Edge edge) {
    return chosen(line, pointsOfEdge(line, columnWidth, edge));
}

QImage drawn(const QPolygonF& line) {
    QImage picture(400, 220, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Qt::black, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    return picture;
}

/// The same line as plots draw it.
QImage drawnFast(const QPolygonF& line, double columnWidth) {
    QImage picture(400, 220, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setPen(QPen(Qt::black, 2.0));
    drawLine(painter, chosen(line, pointsOf(line, columnWidth)), QRectF(picture.rect()));
    return picture;
}

/// Share of the pixels of two grey pictures that differ by more than 96 of 255, and the mean
/// difference of all.
std::pair<double, double> difference(const QImage& a, const QImage& b) {
    int far = 0;
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const int d = std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
            far += d > 96 ? 1 : 0;
            sum += d;
        }
    }
    return {1.0 * far / a.width() / a.height(), sum / a.width() / a.height()};
}

TEST(CurveDrawingTest, ThinningChangesNothingThatIsSeen) {
    const QPolygonF line = restless(20000, 399.0);
    const QPolygonF thin = thinned(line, 1.0);
    EXPECT_LE(thin.size(), 4 * 400);
    const auto [far, mean] = difference(drawn(line), drawn(thin));
    EXPECT_LT(mean, 1.5);
    EXPECT_LT(far, 5e-3); // the very tips of spikes

    // One of three points alone would lose the spikes.
    QPolygonF careless;
    for (qsizetype i = 0; i < line.size(); i += 12) {
        careless << line[i];
    }
    EXPECT_GT(difference(drawn(line), drawn(careless)).second, 4.0 * mean);
}

TEST(CurveDrawingTest, PixelsAreWhatQtDrawsOfTheWholeLine) {
    // Restless, smooth, steep, far beyond the picture, to and fro.
    QPolygonF smooth, back;
    for (int i = 0; i <= 60; ++i) {
        smooth << QPointF(7.0 * i, 110.0 + 90.0 * std::sin(i / 7.0));
        back << QPointF(200.0 + 150.0 * std::cos(i / 10.0), 110.0 + 90.0 * std::sin(i / 6.0));
    }
    const QPolygonF beyond{
        {-1e7, 30.0}, {150.0, 100.0}, {170.0, 1e9}, {180.0, -1e9}, {900.0, 120.0}};
    for (const QPolygonF& line :
         {restless(20000, 399.0), restless(300, 399.0), smooth, back, beyond}) {
        const auto [far, mean] = difference(drawn(line), drawnFast(line, 1.0));
        EXPECT_LT(mean, 2.5) << line.size();
        EXPECT_LT(far, 1e-2) << line.size();
    }
}

TEST(CurveDrawingTest, LinesStayInTheirAreaAndInTheClip) {
    QImage picture(100, 100, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setPen(QPen(Qt::black, 6.0));
    painter.setClipRegion(QRegion(0, 0, 100, 50));
    drawLine(painter, {{-10.0, 45.0}, {200.0, 55.0}}, QRectF(20.0, 0.0, 30.0, 100.0));
    QRect dark;
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            if (qGray(picture.pixel(x, y)) < 200) {
                dark |= QRect(x, y, 1, 1);
            }
        }
    }
    EXPECT_EQ(dark.left(), 20);
    EXPECT_EQ(dark.right(), 49);
    EXPECT_EQ(dark.bottom(), 49);
    EXPECT_GT(dark.top(), 40);
}

TEST(CurveDrawingTest, ALineCoversAPixelOnceHoweverOftenItPasses) {
    QImage picture(20, 20, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setPen(QPen(QColor(0, 0, 0, 100), 4.0));
    QPolygonF line;
    for (int i = 0; i < 50; ++i) {
        line << QPointF(i % 2 == 0 ? 2.0 : 18.0, 10.0);
    }
    drawLine(painter, line, QRectF(picture.rect()));
    EXPECT_NEAR(qGray(picture.pixel(10, 10)), 155, 2);
}

TEST(CurveDrawingTest, EdgesOfBandsKeepTheirExtremesAndTheirEnds) {
    const QPolygonF line = restless(5000, 100.0);
    const QPolygonF low = edgeOf(line, 1.0, Edge::lowest), high = edgeOf(line, 1.0, Edge::highest);
    const auto byHeight = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
    EXPECT_EQ(*std::min_element(line.begin(), line.end(), byHeight),
              *std::min_element(low.begin(), low.end(), byHeight));
    EXPECT_EQ(*std::max_element(line.begin(), line.end(), byHeight),
              *std::max_element(high.begin(), high.end(), byHeight));
    for (const QPolygonF& edge : {low, high}) {
        EXPECT_LE(edge.size(), 101 + 2);
        EXPECT_EQ(edge.front(), line.front());
        EXPECT_EQ(edge.back(), line.back());
        EXPECT_TRUE(
            std::is_sorted(edge.begin(), edge.end(),
                           [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); }));
    }
    // One point of each column, none of which is beyond the edge.
    std::map<int, double> lowest;
    for (const QPointF& point : line) {
        const auto [at, isNew] = lowest.try_emplace(static_cast<int>(point.x()), point.y());
        at->second = std::min(at->second, point.y());
    }
    for (const QPointF& point : low.mid(1, low.size() - 2)) {
        EXPECT_EQ(point.y(), lowest.at(static_cast<int>(point.x())));
    }
    EXPECT_EQ(edgeOf(line, 0.0, Edge::lowest), line);
}

TEST(CurveDrawingTest, ThinningKeepsEveryExtreme) {
    const QPolygonF line = restless(5000, 100.0);
    const QPolygonF thin = thinned(line, 1.0);
    const auto byHeight = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
    EXPECT_EQ(*std::min_element(line.begin(), line.end(), byHeight),
              *std::min_element(thin.begin(), thin.end(), byHeight));
    EXPECT_EQ(*std::max_element(line.begin(), line.end(), byHeight),
              *std::max_element(thin.begin(), thin.end(), byHeight));
    EXPECT_EQ(thin.front(), line.front());
    EXPECT_EQ(thin.back(), line.back());
}

TEST(CurveDrawingTest, ThinningLeavesFewPointsAlone) {
    const QPolygonF line{{0.0, 1.0}, {10.0, 3.0}, {20.0, 2.0}};
    EXPECT_EQ(thinned(line, 0.5), line);
    // A crowd keeps the points that a long way leads to and from.
    const QPolygonF crowd{{0.0, 5.0},  {10.1, 3.0}, {10.2, 9.0},
                          {10.3, 1.0}, {10.4, 4.0}, {20.0, 5.0}};
    EXPECT_EQ(
        thinned(crowd, 0.5),
        (QPolygonF{{0.0, 5.0}, {10.1, 3.0}, {10.2, 9.0}, {10.3, 1.0}, {10.4, 4.0}, {20.0, 5.0}}));
    EXPECT_EQ(thinned(restless(300, 10.0), 0.0).size(), 300);
}

TEST(CurveDrawingTest, PaperKeepsEveryPoint) {
    QImage picture(10, 10, QImage::Format_RGB32);
    QPainter onScreen(&picture);
    EXPECT_DOUBLE_EQ(finestColumn(onScreen), 1.0);
    onScreen.scale(2.0, 2.0);
    EXPECT_DOUBLE_EQ(finestColumn(onScreen), 0.5);
    QTemporaryFile file;
    ASSERT_TRUE(file.open());
    QPdfWriter pdf(&file);
    QPainter onPaper(&pdf);
    EXPECT_DOUBLE_EQ(finestColumn(onPaper), 0.0);
}

TEST(CurveDrawingTest, ClippingCutsLinesAtTheFrame) {
    const QRectF area(0.0, 0.0, 10.0, 10.0);
    // In, out over the right, back in, and a segment that crosses from outside to outside.
    const auto parts =
        clipped({{2.0, 5.0}, {20.0, 5.0}, {20.0, 8.0}, {5.0, 8.0}, {-5.0, 8.0}}, area);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0], (QPolygonF{{2.0, 5.0}, {10.0, 5.0}}));
    EXPECT_EQ(parts[1], (QPolygonF{{10.0, 8.0}, {5.0, 8.0}, {0.0, 8.0}}));
    const auto crossing = clipped({{-10.0, -10.0}, {20.0, 20.0}}, area);
    ASSERT_EQ(crossing.size(), 1U);
    EXPECT_NEAR(crossing[0].front().x(), 0.0, 1e-12);
    EXPECT_NEAR(crossing[0].back().y(), 10.0, 1e-12);
    EXPECT_TRUE(clipped({{-1.0, -1.0}, {-1.0, 20.0}}, area).empty());
    // Steep lines from far away keep their slope.
    const auto steep = clipped({{4.0, -1e12}, {6.0, 1e12}}, area);
    ASSERT_EQ(steep.size(), 1U);
    EXPECT_NEAR(steep[0].front().x(), 5.0, 1e-6);
}

TEST(CurveDrawingTest, RunsAreWhatLiesBetweenGaps) {
    const std::vector<bool> there = {true, true, false, true, false, false, true, true};
    const auto runs = runsOf(8, [&](int i) { return there[static_cast<std::size_t>(i)]; });
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_EQ(runs[0].last, 1);
    EXPECT_EQ(runs[1].first, 3);
    EXPECT_EQ(runs[1].last, 3);
    EXPECT_EQ(runs[2].last, 7);
}

TEST(CurveDrawingTest, TheVisiblePartReachesOneSampleFurther) {
    const std::vector<double> rising = {0, 1, 2, 3, 4, 5, 6};
    const auto part = visiblePart(rising, {0, 6}, 2.5, 4.5);
    EXPECT_EQ(part.first, 2);
    EXPECT_EQ(part.last, 5);
    const std::vector<double> falling(rising.rbegin(), rising.rend());
    const auto mirrored = visiblePart(falling, {0, 6}, 2.5, 4.5);
    EXPECT_EQ(mirrored.first, 1);
    EXPECT_EQ(mirrored.last, 4);
    const auto back = visiblePart({0, 5, 1, 4}, {0, 3}, 2.0, 3.0);
    EXPECT_EQ(back.first, 0);
    EXPECT_EQ(back.last, 3);
    const auto beyond = visiblePart(rising, {0, 6}, 50.0, 60.0);
    EXPECT_LE(beyond.last - beyond.first, 1);
}

} // namespace
} // namespace smat::gui

#include "gui/plot/AreaRaster.h"

#include <cmath>
#include <numbers>

#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

constexpr int width = 120, height = 90;

QImage sheet() {
    QImage picture(width, height, QImage::Format_RGB32);
    picture.fill(Qt::white);
    return picture;
}

QImage filled(const QPolygonF& outline, const QColor& color = Qt::black,
              const QRect& clip = QRect(0, 0, width, height)) {
    QImage picture = sheet();
    AreaRaster raster(picture, clip);
    for (qsizetype i = 0; i < outline.size(); ++i) {
        raster.add(outline[i], outline[(i + 1) % outline.size()]);
    }
    raster.paint(color, QRegion(clip));
    return picture;
}

QImage filledByQt(const QPolygonF& outline, const QColor& color = Qt::black) {
    QImage picture = sheet();
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(outline, Qt::WindingFill);
    return picture;
}

int largestDifference(const QImage& a, const QImage& b) {
    int largest = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            largest = std::max(largest, std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))));
        }
    }
    return largest;
}

/// Share of a pixel that is black, of 255.
int inkAt(const QImage& picture, int x, int y) {
    return 255 - qGray(picture.pixel(x, y));
}

QPolygonF turned(double angle, double size) {
    QPolygonF result;
    for (const double corner : {0.0, 1.0, 2.0, 3.0}) {
        const double at = angle + corner * std::numbers::pi / 2.0;
        result << QPointF(60.0 + size * std::cos(at), 45.0 + size * std::sin(at));
    }
    return result;
}

TEST(AreaRasterTest, APixelIsCoveredByTheAreaThatLiesInIt) {
    const QImage box = filled({{10.25, 20.5}, {14.5, 20.5}, {14.5, 23.75}, {10.25, 23.75}});
    EXPECT_NEAR(inkAt(box, 10, 20), 255 * 0.75 * 0.5, 1);
    EXPECT_NEAR(inkAt(box, 12, 20), 255 * 0.5, 1);
    EXPECT_EQ(inkAt(box, 12, 21), 255);
    EXPECT_NEAR(inkAt(box, 14, 23), 255 * 0.5 * 0.75, 1);
    for (const QPoint& outside : {QPoint(9, 21), QPoint(15, 21), QPoint(12, 19), QPoint(12, 24)}) {
        EXPECT_EQ(inkAt(box, outside.x(), outside.y()), 0);
    }

    // Flat over eight columns: each has an eighth more of the row.
    const QImage wedge = filled({{10.0, 11.0}, {18.0, 10.0}, {18.0, 11.0}});
    for (int i = 0; i < 8; ++i) {
        EXPECT_NEAR(inkAt(wedge, 10 + i, 10), 255.0 * (i + 0.5) / 8.0, 1) << i;
    }
    // Within a pixel, and less than one in two.
    EXPECT_NEAR(inkAt(filled({{30.25, 30.25}, {30.75, 30.25}, {30.75, 30.75}}), 30, 30), 255 / 8,
                1);
    const QImage slip = filled({{40.5, 40.0}, {41.5, 40.5}, {40.5, 41.0}});
    EXPECT_NEAR(inkAt(slip, 40, 40), 255 * 0.375, 1);
    EXPECT_NEAR(inkAt(slip, 41, 40), 255 * 0.125, 1);
}

TEST(AreaRasterTest, OutlinesAreFilledAsQtFillsThem) {
    for (int i = 0; i < 40; ++i) {
        const QPolygonF outline = turned(0.1 * i, 3.0 + i);
        EXPECT_LE(largestDifference(filled(outline), filledByQt(outline)), 4) << i;
        const QColor glass(40, 90, 200, 56);
        EXPECT_LE(largestDifference(filled(outline, glass), filledByQt(outline, glass)), 2) << i;
    }
}

TEST(AreaRasterTest, WhatLiesBesideTheClipIsCutOff) {
    const QPolygonF large = turned(0.3, 400.0);
    EXPECT_EQ(largestDifference(filled(large), filled({{0, 0}, {120, 0}, {120, 90}, {0, 90}})), 0);
    // Far out over each side, and a sliver that crosses all of the picture.
    for (const QPolygonF& outline :
         {QPolygonF{{-1e7, 30.0}, {70.0, 20.0}, {70.0, 60.0}},
          QPolygonF{{50.0, 30.0}, {1e7, 20.0}, {1e7, 60.0}},
          QPolygonF{{50.0, -1e7}, {90.0, 50.0}, {30.0, 50.0}},
          QPolygonF{{50.0, 1e7}, {90.0, 50.0}, {30.0, 50.0}},
          QPolygonF{{-500.0, -300.0}, {620.0, 388.0}, {620.0, 392.0}, {-500.0, -296.0}}}) {
        const QImage whole = filled(outline);
        const QRect clip(30, 20, 50, 45);
        const QImage part = filled(outline, Qt::black, clip);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                ASSERT_NEAR(inkAt(part, x, y), clip.contains(x, y) ? inkAt(whole, x, y) : 0, 2)
                    << x << " " << y;
            }
        }
    }
    EXPECT_EQ(largestDifference(filled({{200.0, 10.0}, {300.0, 10.0}, {250.0, 80.0}}), sheet()), 0);
    EXPECT_EQ(largestDifference(filled({{-200.0, 10.0}, {-30.0, 10.0}, {-50.0, 80.0}}), sheet()),
              0);
    EXPECT_EQ(largestDifference(filled({{20.0, -50.0}, {80.0, -10.0}, {50.0, 0.0}}), sheet()), 0);
    const QRect beside(500, 500, 20, 20);
    EXPECT_EQ(largestDifference(filled(large, Qt::black, beside), sheet()), 0);
}

TEST(AreaRasterTest, InsideIsWhatIsGoneRound) {
    // Either way round, and twice the same way: once as dark.
    const QPolygonF once = turned(0.2, 30.0);
    const QPolygonF back(once.rbegin(), once.rend());
    const QColor glass(0, 0, 0, 100);
    EXPECT_EQ(filled(once, glass), filled(back, glass));
    const QImage twice = filled(once + once, glass);
    for (const QPoint& inside : {QPoint(60, 45), QPoint(60, 20), QPoint(40, 50), QPoint(80, 50)}) {
        EXPECT_EQ(inkAt(twice, inside.x(), inside.y()), 100);
    }
    // To and fro is a hole.
    const QPolygonF inner = turned(0.2, 12.0);
    const QPolygonF ring = once + QPolygonF{once.front()} + QPolygonF{inner.front()} +
                           QPolygonF(inner.rbegin(), inner.rend()) + QPolygonF{inner.back()} +
                           QPolygonF{inner.front()};
    const QImage holed = filled(ring);
    EXPECT_EQ(inkAt(holed, 60, 45), 0);
    EXPECT_EQ(inkAt(holed, 60, 25), 255);
}

TEST(AreaRasterTest, NothingStaysFromOneAreaToTheNext) {
    QImage picture = sheet();
    AreaRaster raster(picture, picture.rect());
    const auto add = [&](const QPolygonF& outline) {
        for (qsizetype i = 0; i < outline.size(); ++i) {
            raster.add(outline[i], outline[(i + 1) % outline.size()]);
        }
    };
    add(turned(0.4, 40.0));
    raster.paint(Qt::white, QRegion());
    add(turned(0.1, 10.0));
    raster.paint(Qt::black, QRegion(picture.rect()));
    EXPECT_EQ(picture, filled(turned(0.1, 10.0)));
}

TEST(AreaRasterTest, PaintsWithinItsRegion) {
    QImage picture = sheet();
    AreaRaster raster(picture, picture.rect());
    const QPolygonF outline = turned(0.4, 40.0);
    for (qsizetype i = 0; i < outline.size(); ++i) {
        raster.add(outline[i], outline[(i + 1) % outline.size()]);
    }
    const QRegion region = QRegion(50, 30, 30, 30) - QRegion(60, 40, 5, 5);
    raster.paint(Qt::black, region);
    const QImage whole = filled(outline);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            ASSERT_EQ(inkAt(picture, x, y), region.contains(QPoint(x, y)) ? inkAt(whole, x, y) : 0);
        }
    }
}

TEST(AreaRasterTest, RefusesPicturesItCannotFill) {
    QImage grey(10, 10, QImage::Format_Grayscale8);
    EXPECT_THROW(AreaRaster(grey, grey.rect()), irsg::LogicError);
}

} // namespace
} // namespace smat::gui

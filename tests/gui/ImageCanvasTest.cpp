#include "gui/image/ImageCanvas.h"

#include <cmath>
#include <limits>

#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

SharedValues valuesOf(std::vector<float> values) {
    return std::make_shared<const std::vector<float>>(std::move(values));
}

QColor colorOf(const irsg::Rgb& color) {
    return {color.red, color.green, color.blue};
}

/// What a plane looks like when it is drawn over the whole of a small picture.
QImage drawn(const ColoredPlane& plane, int width, int height) {
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    plane.color();
    plane.draw(painter, image.rect(), image.rect(), 1.0);
    return image;
}

TEST(ColoredPlane, GivesEveryPixelTheColourOfTheMap) {
    std::vector<float> values;
    for (int i = 0; i < 4000; ++i) {
        values.push_back(-0.5F + 0.0005F * static_cast<float>(i));
    }
    values[7] = nan;
    values[8] = std::numeric_limits<float>::infinity();
    for (const auto& name : irsg::ColorMap::names()) {
        const auto& map = irsg::ColorMap::named(name);
        ColoredPlane plane;
        plane.setValues(80, 50, valuesOf(values));
        plane.setColors(map, {-0.25, 1.0});
        for (int i = 0; i < 4000; ++i) {
            const QColor is = plane.colorAt(i % 80, i / 80);
            const QColor should = colorOf(map.color(static_cast<double>(values[i]), {-0.25, 1.0}));
            // On the border between two entries either is right.
            EXPECT_LE(std::abs(is.red() - should.red()) + std::abs(is.green() - should.green()) +
                          std::abs(is.blue() - should.blue()),
                      4)
                << name << " " << i;
        }
    }
}

TEST(ColoredPlane, OutOfRangeSaturatesOrIsMarkedAndNaNHasItsOwnColour) {
    const auto& map = irsg::ColorMap::named("white-hot");
    ColoredPlane plane;
    plane.setValues(4, 1, valuesOf({-1.0F, 0.5F, 2.0F, nan}));
    plane.setColors(map, {0.0, 1.0});
    EXPECT_EQ(plane.colorAt(0, 0), colorOf(map.at(0.0)));
    EXPECT_EQ(plane.colorAt(2, 0), colorOf(map.at(1.0)));
    plane.setColors(map, {.low = 0.0, .high = 1.0, .marksOutside = true});
    EXPECT_EQ(plane.colorAt(0, 0), colorOf(map.below()));
    EXPECT_EQ(plane.colorAt(2, 0), colorOf(map.above()));
    EXPECT_EQ(plane.colorAt(3, 0), colorOf(map.notANumber()));
}

TEST(ColoredPlane, IsReducedToMeansAndKeepsEveryMarkInSight) {
    // Columns of black and white are grey from afar.
    std::vector<float> values(512 * 512);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = i % 2 == 0 ? 0.0F : 1.0F;
    }
    ColoredPlane plane;
    plane.setValues(512, 512, valuesOf(values));
    plane.setColors(irsg::ColorMap::named("white-hot"), {0.0, 1.0});
    EXPECT_NEAR(drawn(plane, 64, 64).pixelColor(31, 40).lightness(), 127, 3);

    std::vector<std::uint8_t> marks(values.size());
    marks[333 * 512 + 71] = ColoredPlane::failed;
    plane.setMarks(marks);
    int pink = 0;
    const QImage seen = drawn(plane, 64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            pink += seen.pixelColor(x, y).saturation() > 100 ? 1 : 0;
        }
    }
    EXPECT_GE(pink, 1);
    EXPECT_LE(pink, 9);
}

TEST(ColoredPlane, DrawsOddAndTinySizesAtEveryScale) {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 977}, {977, 1}, {333, 127}}) {
        ColoredPlane plane;
        plane.setValues(
            width, height,
            valuesOf(std::vector<float>(static_cast<std::size_t>(width * height), 1.0F)));
        plane.setColors(irsg::ColorMap::named("white-hot"), {0.0, 1.0});
        for (const int size : {1, 3, 50, 2000}) {
            EXPECT_EQ(drawn(plane, size, size).pixelColor(size / 2, size / 2), QColor(Qt::white))
                << width << " x " << height << " at " << size;
        }
    }
}

class Canvas : public ::testing::Test {
  protected:
    Canvas() {
        std::vector<float> values;
        for (int i = 0; i < 40 * 30; ++i) {
            values.push_back(static_cast<float>(i));
        }
        canvas.resize(400, 300);
        canvas.setPlane(40, 30, valuesOf(values));
        canvas.setColors(irsg::ColorMap::named("white-hot"), {0.0, 1200.0});
        canvas.show();
        canvas.setFocus();
        QTest::qWait(20);
    }
    void wheel(const QPointF& at, int steps) {
        QWheelEvent event(at, canvas.mapToGlobal(at), {}, QPoint(0, 120 * steps), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&canvas, &event);
    }
    ImageCanvas canvas;
};

TEST_F(Canvas, FitsAndZoomsAtTheCursor) {
    EXPECT_DOUBLE_EQ(canvas.zoom(), 10.0);
    const QPointF at(103.0, 57.0);
    const auto before = canvas.pixelAt(at);
    wheel(at, 5);
    EXPECT_GT(canvas.zoom(), 20.0);
    EXPECT_EQ(canvas.pixelAt(at), before);
    QTest::keyClick(&canvas, Qt::Key_F);
    EXPECT_DOUBLE_EQ(canvas.zoom(), 10.0);
    QTest::keyClick(&canvas, Qt::Key_Plus);
    EXPECT_DOUBLE_EQ(canvas.zoom(), 15.0);
    QTest::keyClick(&canvas, Qt::Key_A);
    EXPECT_DOUBLE_EQ(canvas.zoom() * canvas.devicePixelRatioF(), 1.0);
}

TEST_F(Canvas, ArrowsReadPixelsShiftDrawsARectangleControlPans) {
    QSignalSpy read(&canvas, &ImageCanvas::hovered);
    QTest::keyClick(&canvas, Qt::Key_Right);
    ASSERT_EQ(canvas.cursorPixel(), QPoint(20, 15));
    QTest::keyClick(&canvas, Qt::Key_Right);
    QTest::keyClick(&canvas, Qt::Key_Up);
    EXPECT_EQ(canvas.cursorPixel(), QPoint(21, 14));
    EXPECT_EQ(read.count(), 3);
    QTest::keyClick(&canvas, Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyClick(&canvas, Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(canvas.selection(), (irsg::PixelRectangle{21, 14, 2, 2}));
    QTest::keyClick(&canvas, Qt::Key_Escape);
    EXPECT_FALSE(canvas.selection());
    EXPECT_FALSE(canvas.cursorPixel());
    const QPointF centre = canvas.view().centre;
    QTest::keyClick(&canvas, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(canvas.view().centre.x(), centre.x() + 4.0);
}

TEST_F(Canvas, TheCursorStaysInsideAndInSight) {
    canvas.setZoom(60.0);
    for (int i = 0; i < 60; ++i) {
        QTest::keyClick(&canvas, Qt::Key_Left);
    }
    EXPECT_EQ(canvas.cursorPixel()->x(), 0);
    EXPECT_TRUE(canvas.rect().contains(
        canvas.widgetPoint(QPointF(*canvas.cursorPixel()) + QPointF(0.5, 0.5)).toPoint()));
}

TEST_F(Canvas, PrintsTheValuesWhenThereIsRoom) {
    canvas.setColors(irsg::ColorMap::named("white-hot"), {0.0, 1e9});
    const auto inkAround = [&](double zoom) {
        canvas.setView({zoom, QPointF(20.5, 15.5), false});
        const QImage seen = canvas.grab().toImage();
        int bright = 0;
        for (int y = 0; y < seen.height(); ++y) {
            for (int x = 0; x < seen.width(); ++x) {
                bright += seen.pixelColor(x, y).lightness() > 128 ? 1 : 0;
            }
        }
        return bright;
    };
    EXPECT_EQ(inkAround(canvas.printingZoom() - 1.0), 0);
    EXPECT_GT(inkAround(canvas.printingZoom()), 100);
    test::keepScreenshot(canvas, "image-canvas-values");
}

TEST_F(Canvas, WipeAndSecondPlaneShowTheOther) {
    canvas.setSecond(valuesOf(std::vector<float>(1200, 1200.0F)));
    const auto lightness = [&](int x) {
        return test::colorAt(canvas.grab().toImage(), QPointF(x, 5)).lightness();
    };
    EXPECT_LT(lightness(390), 20);
    canvas.setWipe(0.5);
    EXPECT_LT(lightness(150), 20);
    EXPECT_GT(lightness(390), 240);
    canvas.setWipe(std::nullopt);
    canvas.setSecondShown(true);
    EXPECT_GT(lightness(150), 240);
    canvas.setSecondShown(false);
    EXPECT_LT(lightness(150), 20);
}

TEST_F(Canvas, ASelectionIsCutToTheImage) {
    QTest::mousePress(&canvas, Qt::LeftButton, {}, {5, 5});
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, {-300, -300});
    EXPECT_EQ(canvas.selection(), (irsg::PixelRectangle{0, 0, 1, 1}));
    canvas.setSelection(irsg::PixelRectangle{38, 28, 10, 10});
    EXPECT_EQ(canvas.selection(), (irsg::PixelRectangle{38, 28, 2, 2}));
    canvas.setSelection(irsg::PixelRectangle{40, 30, 10, 10});
    EXPECT_FALSE(canvas.selection());
}

TEST(EmptyCanvas, LivesWithEveryKeyAndTheMouse) {
    ImageCanvas canvas;
    canvas.resize(200, 160);
    canvas.show();
    for (int key = Qt::Key_A; key <= Qt::Key_Z; ++key) {
        QTest::keyClick(&canvas, static_cast<Qt::Key>(key));
    }
    for (const auto key : {Qt::Key_Left, Qt::Key_Plus, Qt::Key_Minus, Qt::Key_Escape}) {
        QTest::keyClick(&canvas, key);
    }
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, {50, 50});
    QTest::mouseDClick(&canvas, Qt::LeftButton, {}, {50, 50});
    canvas.grab();
    EXPECT_FALSE(canvas.pixelAt({50.0, 50.0}));
}

} // namespace
} // namespace smat::gui

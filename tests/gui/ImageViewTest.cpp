#include "gui/image/ImageView.h"

#include <limits>

#include <QComboBox>
#include <QLineEdit>
#include <QTest>
#include <gtest/gtest.h>

#include "gui/image/ColorBar.h"
#include "gui/image/ImageCanvas.h"
#include "irsg/image/ApparentTemperature.h"
#include "irsg/radiometry/Planck.h"
#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

/// 8 x 6, dark but for one bright pixel in the top row.
irsg::RadianceImage small() {
    irsg::RadianceImage image(8, 6);
    for (std::size_t i = 0; i < image.pixelCount(); ++i)
        image.primary().values[i] = 1.0F;
    image.primary().values[image.offset(2, 0)] = 5.0F;
    auto& index = image.channel("temperature_index");
    index.values[image.offset(2, 0)] = 7.0F;
    return image;
}

class ImageViewTest : public ::testing::Test {
  protected:
    ImageViewTest() {
        view.resize(760, 560);
        view.setImage(small(), irsg::Band::topHat(3.0, 5.0));
        view.show();
        QTest::qWait(20);
    }
    ImageView view;
};

TEST_F(ImageViewTest, TopRowOfTheImageIsAtTheTop) {
    const QImage seen = view.canvas()->grab().toImage();
    const auto colorAt = [&](int x, int y) {
        return seen.pixelColor(
            (view.canvas()->widgetPoint(QPointF(x + 0.5, y + 0.5)) * seen.devicePixelRatio())
                .toPoint());
    };
    EXPECT_GT(colorAt(2, 0).lightness(), 240);
    EXPECT_LT(colorAt(2, 5).lightness(), 15);
    EXPECT_LT(colorAt(5, 0).lightness(), 15);
    EXPECT_EQ(view.canvas()->pixelAt(view.canvas()->widgetPoint({2.5, 0.5})), QPoint(2, 0));
}

TEST_F(ImageViewTest, ReadsRadianceTemperatureAndIndexOfAPixel) {
    const QString text = view.readoutAt(2, 0);
    EXPECT_TRUE(text.contains("x 2   y 0"));
    EXPECT_TRUE(text.contains("Radiance 5 W·m⁻²·sr⁻¹")) << text.toStdString();
    EXPECT_TRUE(text.contains("Temperature index 7")) << text.toStdString();
    EXPECT_TRUE(text.contains("Apparent temperature")) << text.toStdString();
    EXPECT_NE(view.image().find(irsg::apparentTemperatureChannel), nullptr);
}

TEST_F(ImageViewTest, EditedLimitsLockAndUselessOnesAreTakenBack) {
    auto* high = view.findChild<QLineEdit*>("limitHigh");
    high->setText("2.5");
    emit high->editingFinished();
    EXPECT_EQ(view.colorBar()->limits().high, 2.5);
    EXPECT_EQ(view.colorBar()->mode(), LimitMode::locked);
    for (const auto* useless : {"hot", "-7", "nan", ""}) {
        high->setText(useless);
        emit high->editingFinished();
        EXPECT_EQ(high->text(), "2.5") << useless;
    }
    view.setImage(small());
    EXPECT_EQ(view.colorBar()->limits().high, 2.5);
}

TEST_F(ImageViewTest, ShowsEveryPlaneUnderItsNameAndUnit) {
    auto* planes = view.findChild<QComboBox*>("plane");
    ASSERT_EQ(planes->count(), 3);
    planes->setCurrentIndex(2);
    emit planes->activated(2);
    EXPECT_EQ(view.shownChannel(), irsg::apparentTemperatureChannel);
    view.setColorMap("ironbow");
    test::keepScreenshot(view, "image-view");
}

TEST_F(ImageViewTest, StatisticsFollowADraggedRectangle) {
    EXPECT_TRUE(view.statistics().startsWith("Image 8 × 6"));
    QTest::mousePress(view.canvas(), Qt::LeftButton, {},
                      view.canvas()->widgetPoint({1.2, 0.2}).toPoint());
    QTest::mouseRelease(view.canvas(), Qt::LeftButton, {},
                        view.canvas()->widgetPoint({2.8, 1.8}).toPoint());
    EXPECT_TRUE(view.statistics().startsWith("Rectangle 2 × 2 at (1, 0)"))
        << view.statistics().toStdString();
    EXPECT_TRUE(view.statistics().contains("mean 2"));
    QTest::mouseClick(view.canvas(), Qt::LeftButton, {},
                      view.canvas()->widgetPoint({4.5, 4.5}).toPoint());
    EXPECT_TRUE(view.statistics().startsWith("Image"));
}

TEST_F(ImageViewTest, LivesWithPixelsThatAreNoNumbersAndWithOnePixel) {
    irsg::RadianceImage image(1, 1);
    image.primary().values[0] = std::numeric_limits<float>::quiet_NaN();
    view.setImage(image, irsg::Band::topHat(8.0, 12.0));
    EXPECT_TRUE(view.readoutAt(0, 0).contains("no value"));
    view.setImage(irsg::RadianceImage(1, 977), irsg::Band::topHat(8.0, 12.0));
    view.grab();
}

} // namespace
} // namespace smat::gui

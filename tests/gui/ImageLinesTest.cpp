#include <cmath>

#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>

#include "gui/image/ColorBar.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/HotSpotsPanel.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ProfilePanel.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/widgets/ThemeColors.h"
#include "tests/gui/ImageViewFixture.h"

namespace smat::gui {
namespace {

class ImageLinesTest : public test::ImageViewTest {
  protected:
    /// 40 x 30 pixels of value 100 y + x.
    ImageLinesTest() {
        irsg::RadianceImage image(40, 30);
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) {
                image.primary().values[image.offset(x, y)] = static_cast<float>(100 * y + x);
            }
        }
        view.setImage(std::move(image));
        QTest::qWait(20);
    }
    QPoint at(double x, double y) { return view.canvas()->widgetPoint({x, y}).toPoint(); }
    void drag(const QPoint& from, const QPoint& to) {
        QTest::mousePress(view.canvas(), Qt::LeftButton, {}, from);
        QTest::mouseMove(view.canvas(), to);
        QTest::mouseRelease(view.canvas(), Qt::LeftButton, {}, to);
    }
    const PlotData& plot() { return view.profile()->plot()->cartesian()->data(); }
    void press(int key, Qt::KeyboardModifiers with = Qt::NoModifier) {
        QTest::keyClick(view.canvas(), static_cast<Qt::Key>(key), with);
    }
};

TEST_F(ImageLinesTest, ADraggedLineShowsTheValuesOfItsPixels) {
    EXPECT_FALSE(view.profile()->isVisible());
    press(Qt::Key_P);
    ASSERT_TRUE(view.profile()->isVisible());
    QTest::qWait(20); // the picture has become smaller
    EXPECT_TRUE(plot().curves.empty());
    drag(at(3.5, 4.5), at(23.5, 14.5));
    ASSERT_EQ(plot().curves.size(), 1u);
    const Curve& curve = plot().curves[0];
    ASSERT_EQ(curve.y.size(), 21u);
    EXPECT_EQ(curve.y.front(), 403.0);
    EXPECT_EQ(curve.y.back(), 1423.0);
    EXPECT_DOUBLE_EQ(curve.x.back(), std::hypot(20.0, 10.0));
    EXPECT_EQ(plot().title, "From (3, 4) to (23, 14)");
    EXPECT_FALSE(view.canvas()->selection()) << "no rectangle";
    view.setShownPlane(0);
    EXPECT_EQ(plot().curves.size(), 1u) << "it stays with another plane";

    press(Qt::Key_Escape);
    EXPECT_TRUE(plot().curves.empty());
    press(Qt::Key_P);
    EXPECT_FALSE(view.profile()->isVisible());
    drag(at(3.5, 4.5), at(9.5, 9.5));
    EXPECT_TRUE(view.canvas()->selection().has_value()) << "a rectangle as before";
}

TEST_F(ImageLinesTest, OnALowPageOnePartBelowTheImageMakesWayForAnother) {
    QScrollArea page;
    page.setWidgetResizable(true);
    auto* low = new ImageView;
    page.setWidget(low);
    low->setImage(small());
    page.resize(520, 660);
    page.show();
    QTest::qWait(20);
    const auto isOn = [&](const char* name) {
        return low->findChild<QToolButton*>(name)->isChecked();
    };
    const auto click = [&](const char* name) {
        low->findChild<QToolButton*>(name)->click();
        QTest::qWait(20);
    };
    click("showHistogram");
    EXPECT_TRUE(isOn("showHistogram"));
    click("showProfile");
    EXPECT_TRUE(isOn("showProfile"));
    EXPECT_FALSE(isOn("showHistogram"));
    EXPECT_LE(page.widget()->minimumSizeHint().height(), page.viewport()->height());
    click("showHotSpots");
    EXPECT_TRUE(isOn("showHotSpots"));
    EXPECT_FALSE(isOn("showProfile"));
    // Where there is room all stay.
    page.resize(520, 1400);
    QTest::qWait(20);
    click("showHistogram");
    EXPECT_TRUE(isOn("showHistogram") && isOn("showHotSpots"));
}

TEST_F(ImageLinesTest, AClickedPixelShowsItsRowAndItsColumn) {
    press(Qt::Key_P);
    QTest::qWait(20);
    QTest::mouseClick(view.canvas(), Qt::LeftButton, {}, at(12.5, 7.5));
    ASSERT_EQ(plot().curves.size(), 2u);
    EXPECT_EQ(plot().curves[0].y.size(), 40u);
    EXPECT_EQ(plot().curves[0].y.front(), 700.0);
    EXPECT_EQ(plot().curves[1].y.size(), 30u);
    EXPECT_EQ(plot().curves[1].y.back(), 2912.0);
    EXPECT_TRUE(plot().title.startsWith("Through (12, 7): 712")) << plot().title.toStdString();
}

TEST_F(ImageLinesTest, ArrowsMoveThePointAndDrawTheLine) {
    press(Qt::Key_P);
    press(Qt::Key_Right);
    const auto point = view.canvas()->line();
    ASSERT_TRUE(point && point->p1() == point->p2());
    press(Qt::Key_Right, Qt::ShiftModifier);
    press(Qt::Key_Down, Qt::ShiftModifier);
    ASSERT_TRUE(view.canvas()->line().has_value());
    EXPECT_EQ(view.canvas()->line()->p1(), point->p1());
    EXPECT_EQ(view.canvas()->line()->p2(), point->p1() + QPoint(1, 1));
    EXPECT_EQ(plot().curves[0].y.size(), 2u);
    EXPECT_FALSE(view.canvas()->selection());
}

TEST_F(ImageLinesTest, ALineFromOutsideBeginsAtTheEdge) {
    press(Qt::Key_P);
    QTest::qWait(20);
    drag(at(-5.0, 2.5), at(60.0, 2.5));
    ASSERT_TRUE(view.canvas()->line().has_value());
    EXPECT_EQ(*view.canvas()->line(), QLine(0, 2, 39, 2));
}

TEST_F(ImageLinesTest, IsothermsHaveRoundLevelsOrThoseThatAreTyped) {
    auto* field = view.findChild<QLineEdit*>("isoLevels");
    EXPECT_FALSE(field->isVisible());
    press(Qt::Key_I);
    EXPECT_TRUE(field->isVisible());
    EXPECT_GE(view.canvas()->isoLines().size(), 3u);
    for (const IsoLine& line : view.canvas()->isoLines()) {
        const double level = line.label.toDouble();
        EXPECT_GE(level, view.colorBar()->limits().low);
        EXPECT_LE(level, view.colorBar()->limits().high);
    }
    field->setText("1500; 750,5");
    ASSERT_EQ(view.canvas()->isoLines().size(), 2u);
    EXPECT_EQ(view.canvas()->isoLines()[0].label, "750.5");
    EXPECT_EQ(view.canvas()->isoLines()[1].label, "1500");
    // 100 y + x = 1500 beside the left edge: y is 15 of the middles.
    const QLineF first = view.canvas()->isoLines()[1].parts.front();
    EXPECT_NEAR(std::max(first.y1(), first.y2()), 15.5, 0.02);
    field->setText("750; hot");
    EXPECT_TRUE(view.canvas()->isoLines().empty());
    EXPECT_TRUE(field->styleSheet().contains(colors::wrongField(field->palette()).name()));
    field->clear();
    EXPECT_TRUE(field->styleSheet().isEmpty());
    EXPECT_GE(view.canvas()->isoLines().size(), 3u);
    press(Qt::Key_I);
    EXPECT_TRUE(view.canvas()->isoLines().empty());
}

TEST_F(ImageLinesTest, AutomaticLevelsFollowTheScaleOfTheColours) {
    press(Qt::Key_I);
    view.setColorScale(irsg::ColorScale::logarithmic);
    const irsg::DisplayLimits limits = view.colorBar()->limits();
    ASSERT_GE(view.canvas()->isoLines().size(), 5u);
    for (std::size_t k = 0; k < view.canvas()->isoLines().size(); ++k) {
        const double level = view.canvas()->isoLines()[k].label.toDouble();
        EXPECT_NEAR(limits.position(level), (static_cast<double>(k) + 1.0) / 7.0, 0.07) << level;
    }
}

TEST_F(ImageLinesTest, AnExportedPictureHasTheIsotherms) {
    const QImage plain = view.picture(true);
    press(Qt::Key_I);
    EXPECT_NE(view.picture(true), plain);
    press(Qt::Key_I);
    EXPECT_EQ(view.picture(true), plain);
}

TEST_F(ImageLinesTest, HotSpotsAreListedWithWhatOtherPlanesHaveThere) {
    view.setImage(small());
    EXPECT_FALSE(view.hotSpots()->isVisible());
    press(Qt::Key_G);
    ASSERT_TRUE(view.hotSpots()->isVisible());
    FiguresTable& table = *view.hotSpots()->table();
    ASSERT_EQ(table.rowCount(), 1) << table.allText().toStdString();
    EXPECT_EQ(view.canvas()->spots(), std::vector<QPoint>{QPoint(2, 0)});
    EXPECT_EQ(table.item(0, 1)->text(), "5");
    EXPECT_EQ(table.item(0, 2)->text(), "2");
    EXPECT_EQ(table.item(0, 3)->text(), "0");
    EXPECT_EQ(table.item(0, 4)->text(), "7") << "the temperature index";
    emit table.cellClicked(0, 0);
    EXPECT_EQ(view.canvas()->cursorPixel(), QPoint(2, 0));
    press(Qt::Key_G);
    EXPECT_TRUE(view.canvas()->spots().empty());
    EXPECT_EQ(table.rowCount(), 0);
}

TEST_F(ImageLinesTest, AnImageOfAnotherSizeHasNoLineYet) {
    press(Qt::Key_P);
    drag(at(3.5, 4.5), at(23.5, 14.5));
    press(Qt::Key_I);
    view.setImage(small());
    EXPECT_FALSE(view.canvas()->line());
    EXPECT_TRUE(plot().curves.empty());
    for (const IsoLine& line : view.canvas()->isoLines()) {
        for (const QLineF& part : line.parts) {
            EXPECT_LE(part.x1(), 8.0);
        }
    }
}

} // namespace
} // namespace smat::gui

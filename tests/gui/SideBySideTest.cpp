// Two pages beside each other, and what image pages do together.
#include <QSplitter>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include "gui/analysis/ResultPage.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageView.h"
#include "gui/image/IndexLegend.h"
#include "gui/image/LinkedViews.h"
#include "gui/plot/PolarPlot.h"
#include "gui/workbench/PageTabs.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class SideBySideTest : public test::WindowFixture {
  protected:
    void TearDown() override { LinkedViews::instance().setOn(false); }
    PageTabs& tabs() { return *window->findChild<PageTabs*>("tabs"); }
    QTabWidget& beside() { return *tabs().beside(); }
    /// A page of an image in two colours.
    ImageView* addImage(const char* title, float value, int width = 80) {
        irsg::RadianceImage image(width, 60);
        for (float& one : image.primary().values) {
            one = value;
        }
        auto* view = new ImageView;
        view->setImage(std::move(image));
        tabs().addPage(view, {}, title);
        return view;
    }
    static QPoint middleOf(QTabBar& bar, int tab) { return bar.tabRect(tab).center(); }
};

TEST_F(SideBySideTest, APageGoesBesideTheOthersByTheMenuAndComesBack) {
    QAction& action = *window->findChild<QAction*>("moveAcross");
    EXPECT_FALSE(action.isEnabled()); // the model stays
    ImageView* first = addImage("first", 1.0F);
    ImageView* second = addImage("second", 2.0F);
    EXPECT_FALSE(beside().isVisible());
    action.trigger();
    QTest::qWait(20);
    ASSERT_TRUE(tabs().isBeside(second));
    EXPECT_TRUE(second->isVisible());
    tabs().setCurrentWidget(first);
    EXPECT_TRUE(first->isVisible() && second->isVisible());
    EXPECT_GT(first->width(), 200);
    EXPECT_GT(second->width(), 200);

    // What is exported and closed is the page that was used last.
    QTest::mouseClick(tabs().tabBar(), Qt::LeftButton, {}, middleOf(*tabs().tabBar(), 1));
    EXPECT_EQ(tabs().shownPage(), first);
    QTest::mouseClick(beside().tabBar(), Qt::LeftButton, {}, middleOf(*beside().tabBar(), 0));
    EXPECT_EQ(tabs().shownPage(), second);
    EXPECT_TRUE(action.text().contains("back"));
    action.trigger();
    QTest::qWait(20);
    EXPECT_FALSE(tabs().isBeside(second));
    EXPECT_FALSE(beside().isVisible());
    EXPECT_EQ(tabs().tabText(tabs().indexOf(second)), "second");
}

TEST_F(SideBySideTest, ATabThatIsDraggedToTheRightHalfStandsThere) {
    ImageView* page = addImage("page", 1.0F);
    QTabBar& bar = *tabs().tabBar();
    const auto drag = [](QTabBar& from, int tab, const QPoint& global) {
        QTest::mousePress(&from, Qt::LeftButton, {}, middleOf(from, tab));
        QTest::mouseMove(&from, from.mapFromGlobal(global));
        QTest::mouseRelease(&from, Qt::LeftButton, {}, from.mapFromGlobal(global));
        QTest::qWait(20);
    };
    const QPoint left = tabs().mapToGlobal(QPoint(tabs().width() / 4, tabs().height() / 2));
    const QPoint right = tabs().mapToGlobal(QPoint(3 * tabs().width() / 4, tabs().height() / 2));
    drag(bar, 1, left);
    EXPECT_FALSE(tabs().isBeside(page));
    drag(bar, 0, right);
    EXPECT_EQ(beside().count(), 0); // the model stays
    drag(bar, 1, right);
    ASSERT_TRUE(tabs().isBeside(page));
    drag(*beside().tabBar(), 0, tabs().mapToGlobal(QPoint(40, tabs().height() / 2)));
    EXPECT_FALSE(tabs().isBeside(page));
}

TEST_F(SideBySideTest, ClosingTheLastPageBesideLeavesOneRow) {
    addImage("page", 1.0F);
    trigger("moveAcross");
    ASSERT_EQ(beside().count(), 1);
    emit beside().tabCloseRequested(0);
    EXPECT_EQ(beside().count(), 0);
    EXPECT_FALSE(beside().isVisible());
    // Nor does it take the window along.
    EXPECT_EQ(tabs().count(), 1);
}

TEST_F(SideBySideTest, LinkedImagesShowTheSamePartAndReadTheSamePixel) {
    ImageView* one = addImage("one", 1.0F);
    ImageView* other = addImage("other", 2.0F);
    ImageView* larger = addImage("larger", 3.0F, 90);
    tabs().moveAcross(other);
    tabs().setCurrentWidget(one);
    QTest::qWait(30);
    const auto zoomed = [](const ImageView* view) { return view->canvas()->view(); };
    one->canvas()->centreOn({20, 30}, 12.0);
    EXPECT_NE(zoomed(other).centre, zoomed(one).centre);

    window->findChild<QAction*>("linkImages")->setChecked(true);
    EXPECT_EQ(zoomed(other).zoom, zoomed(one).zoom);
    one->canvas()->centreOn({50, 10}, 20.0);
    EXPECT_EQ(zoomed(other).zoom, 20.0);
    EXPECT_LT((zoomed(other).centre - zoomed(one).centre).manhattanLength(), 1e-9);
    EXPECT_NE(zoomed(larger).zoom, 20.0); // of another size
    other->canvas()->centreOn({40, 20}, 25.0);
    EXPECT_EQ(zoomed(one).zoom, 25.0);
    emit one->canvas()->hovered(QPoint(3, 4));
    EXPECT_EQ(other->canvas()->cursorPixel(), QPoint(3, 4));
    EXPECT_EQ(other->readoutAt(3, 4).contains("Radiance 2"), true);

    window->findChild<QAction*>("linkImages")->setChecked(false);
    one->canvas()->centreOn({50, 10}, 30.0);
    EXPECT_EQ(zoomed(other).zoom, 25.0);
}

TEST(IndexLegend, APlaneOfIndicesHasAColourAndANameForEach) {
    irsg::RadianceImage image(6, 4);
    auto& index = image.channel("temperature_index");
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        index.values[i] = i < 8 ? 2.0F : i < 20 ? 5.0F : std::nanf("");
    }
    image.attributes["temperature_index.2"] = "skin";
    image.attributes["temperature_index.5"] = "exhaust";
    ImageView view;
    view.resize(700, 500);
    view.setImage(std::move(image));
    view.setShownPlane(1);
    view.show();
    QTest::qWait(20);
    ASSERT_TRUE(view.indexLegend()->isVisible());
    const auto& seen = view.indexLegend()->indices();
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[1].words(), "5  exhaust");
    EXPECT_EQ(seen[1].pixels, 12U);
    EXPECT_NE(seen[0].color, seen[1].color);
    const QImage colors = view.canvas()->picture();
    EXPECT_EQ(colors.pixelColor(0, 0), seen[0].color);
    EXPECT_EQ(colors.pixelColor(5, 2), seen[1].color);
    EXPECT_EQ(colors.pixelColor(5, 3), QColor(Qt::black));
    // Picking tells the name.
    view.readPixel(QPoint(5, 2));
    EXPECT_EQ(view.indexLegend()->currentRow(), 1);
    EXPECT_TRUE(view.readoutAt(5, 2).contains("5 exhaust"));
    view.readPixel(QPoint(5, 3));
    EXPECT_EQ(view.indexLegend()->currentRow(), -1);
    EXPECT_GT(view.picture(true).width(), view.picture(false).width());
    view.setShownPlane(0);
    EXPECT_FALSE(view.indexLegend()->isVisible());
}

} // namespace
} // namespace smat::gui

#include <QApplication>
#include <QComboBox>
#include <QMenu>
#include <QToolButton>

#include "gui/image/ColorBar.h"
#include "gui/view/ModelPage.h"
#include "gui/view/ViewOverlay.h"
#include "gui/widgets/Theme.h"
#include "tests/gui/ViewFixture.h"

namespace smat::gui {
namespace {

/// Pictures of every display for a person to look at.
class ViewScreenshotTest : public test::ViewFixture {
  protected:
    ~ViewScreenshotTest() override { applyTheme(*qApp, ThemeMode::light); }
};

TEST_F(ViewScreenshotTest, EveryDisplayInBothThemes) {
    for (const std::string name : {"turboprop4", "ship", "sphere", "heron", "corvette"}) {
        const auto folder = std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name;
        Project shown = loadProject(folder / (name + ".smat"));
        shown.settings.set("render.lightError", "0.02");
        ModelPage page;
        SceneView& seen = *page.view();
        page.resize(1000, 640);
        page.show();
        seen.setScene(loadDisplayScene(shown, shown.settings));
        seen.setProject(shown, shown.settings);
        seen.showWholeModel();
        QTest::qWait(60);
        const auto at = QPointF(seen.width() / 2.0, seen.height() / 2.0);
        const auto hits = seen.facesAt(at);
        const auto ready = [&] { return seen.shownPicture() != nullptr && seen.isUpToDate(); };
        const auto keep = [&](const std::string& what) {
            for (const auto mode : {ThemeMode::light, ThemeMode::dark}) {
                applyTheme(*qApp, mode);
                QTest::qWait(30);
                test::keepScreenshot(page, "view-" + what + "-" + name +
                                               (mode == ThemeMode::dark ? "-dark" : "-light"));
            }
        };
        seen.overlay().setModelAxesVisible(true);
        seen.overlay().setSunVectorVisible(true);
        keep("visible");
        if (!hits.empty()) {
            seen.setHighlighted({hits.front().codes.temperature, {}, {}});
        }
        keep("marked");
        seen.setDisplay(ViewDisplay::infrared);
        ASSERT_TRUE(test::waitUntil(ready));
        QTest::mouseMove(&seen, at.toPoint());
        keep("infrared-marked");
        seen.setHighlighted({});
        seen.overlay().setModelAxesVisible(false);
        seen.overlay().setSunVectorVisible(false);
        seen.infrared().setQuantity(InfraredQuantity::apparentTemperature);
        seen.infrared().setColorMap("white-hot");
        QTest::qWait(60);
        ASSERT_TRUE(test::waitUntil(ready));
        keep("infrared");
        EXPECT_FALSE(seen.shownPicture()->colors.isNull());
    }
}

TEST_F(ViewScreenshotTest, TheStripTheMenuAndTheKeysSayTheSame) {
    ModelPage page;
    page.resize(700, 500);
    const Project shown = sample("ship");
    page.view()->setScene(loadDisplayScene(shown, shown.settings));
    page.view()->setProject(shown, shown.settings);
    page.show();
    QMenu menu;
    page.fillMenu(&menu);
    QTest::qWait(50);
    auto* infrared = page.findChild<QAction*>("infraredDisplay");
    ASSERT_NE(infrared, nullptr);
    EXPECT_FALSE(page.colorBar()->isVisible());
    infrared->trigger();
    EXPECT_EQ(page.view()->display(), ViewDisplay::infrared);
    EXPECT_TRUE(page.colorBar()->isVisible());
    EXPECT_TRUE(page.findChild<QToolButton*>("showInfrared")->isChecked());
    ASSERT_TRUE(test::waitUntil([&] { return page.view()->shownPicture() != nullptr; }));

    page.findChild<QAction*>("apparentTemperature")->trigger();
    EXPECT_EQ(page.findChild<QComboBox*>("viewQuantity")->currentIndex(), 1);
    const auto before = page.view()->infrared().colorMap().name();
    page.findChild<QAction*>("nextColorMap")->trigger();
    EXPECT_NE(page.view()->infrared().colorMap().name(), before);
    EXPECT_EQ(page.findChild<QComboBox*>("viewColorMap")->currentText().toStdString(),
              page.view()->infrared().colorMap().name());
    // The bar has the colours at once, not first with the next picture.
    EXPECT_EQ(page.colorBar()->map().name(), page.view()->infrared().colorMap().name());
    page.findChild<QToolButton*>("showVisible")->click();
    EXPECT_FALSE(infrared->isChecked());
    EXPECT_FALSE(page.colorBar()->isVisible());

    // No two entries share a key.
    QStringList keys;
    for (const QAction* action : page.findChildren<QAction*>()) {
        if (!action->shortcut().isEmpty()) {
            keys << action->shortcut().toString();
        }
    }
    EXPECT_EQ(QSet<QString>(keys.begin(), keys.end()).size(), keys.size());
    EXPECT_EQ(keys.size(), 19);
}

} // namespace
} // namespace smat::gui

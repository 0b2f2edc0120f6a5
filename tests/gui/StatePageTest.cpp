// Two states of a project beside each other.
#include <QAction>
#include <QTest>
#include <QToolButton>

#include "gui/view/ModelPage.h"
#include "gui/view/SceneView.h"
#include "gui/view/StatePage.h"
#include "gui/workbench/PageTabs.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

using test::waitUntil;

class StatePageTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        if (test::lacksGl()) {
            GTEST_SKIP() << "this desktop gives no OpenGL context";
        }
        openSample();
        for (const auto& [key, value] :
             {std::pair("sensor.width", "64"), {"sensor.height", "48"}, {"render.bounces", "0"}}) {
            workbench.set(key, value);
        }
        live = window->findChild<ModelPage*>()->view();
        ASSERT_TRUE(waitUntil([&] { return !live->scene().models.empty(); }, 20.0));
    }
    StatePage* keep() {
        trigger("keepState");
        auto* page = window->findChild<StatePage*>("statePage");
        EXPECT_NE(page, nullptr);
        if (page == nullptr ||
            !waitUntil([&] { return !page->view()->scene().models.empty(); }, 20.0)) {
            return nullptr;
        }
        return page;
    }
    static bool waitForPicture(const SceneView& view) {
        return waitUntil(
            [&] {
                const auto* picture = view.shownPicture();
                return picture != nullptr && !picture->coarse && view.isUpToDate();
            },
            20.0);
    }
    static double sum(const SceneView& view) {
        double sum = 0.0;
        for (const float value : view.shownPicture()->plane().values) {
            sum += static_cast<double>(value);
        }
        return sum;
    }
    SceneView* live = nullptr;
};

TEST_F(StatePageTest, TurningOneViewTurnsTheOther) {
    StatePage* page = keep();
    ASSERT_NE(page, nullptr);
    SceneView& kept = *page->view();
    EXPECT_TRUE(window->findChild<PageTabs*>("tabs")->isBeside(page));
    EXPECT_TRUE(live->isVisible() && kept.isVisible());
    EXPECT_EQ(kept.camera(), live->camera());

    QTest::keyClick(live, Qt::Key_Right); // looks around
    EXPECT_TRUE(live->cameras().isInspecting());
    EXPECT_EQ(kept.cameras(), live->cameras());
    QTest::keyClick(&kept, Qt::Key_PageUp);
    EXPECT_EQ(live->cameras(), kept.cameras());
    // The sensor is that of the project.
    QTest::keyClick(&kept, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(live->cameras(), kept.cameras());
    EXPECT_EQ(workbench.camera(), kept.cameras().sensor());
    workbench.set("camera.azimuth", "77");
    EXPECT_TRUE(waitUntil([&] { return kept.cameras().sensor().azimuth_deg == 77.0; }));

    auto* link = page->findChild<QToolButton*>("linkCameras");
    ASSERT_TRUE(link->isVisible() && link->isChecked());
    link->click();
    const OrbitCamera before = kept.camera();
    QTest::keyClick(live, Qt::Key_Right);
    QTest::keyClick(live, Qt::Key_Up);
    EXPECT_EQ(kept.camera(), before);
    QTest::keyClick(&kept, Qt::Key_PageDown);
    EXPECT_NE(live->camera(), kept.camera());
    link->click();
    EXPECT_EQ(kept.cameras(), live->cameras());
}

TEST_F(StatePageTest, TheKeptStateStaysWhileTheProjectIsEditedAndHasItsColours) {
    trigger("infraredDisplay");
    ASSERT_TRUE(waitForPicture(*live));
    StatePage* page = keep();
    ASSERT_NE(page, nullptr);
    SceneView& kept = *page->view();
    EXPECT_EQ(kept.display(), ViewDisplay::infrared);
    ASSERT_TRUE(waitForPicture(kept));
    ASSERT_TRUE(waitForPicture(*live)); // it is narrower now
    const double liveBefore = sum(*live), keptBefore = sum(kept);
    workbench.database().edit("paint", [](irsg::SignatureDatabase& database) {
        for (auto& [index, temperature] : database.temperatures) {
            temperature.terms.ambientOffset_K += 40.0;
        }
    });
    ASSERT_TRUE(waitUntil([&] { return waitForPicture(*live) && sum(*live) != liveBefore; }, 20.0));
    EXPECT_GT(sum(*live), 1.001 * liveBefore);
    ASSERT_TRUE(waitForPicture(kept));
    EXPECT_NEAR(sum(kept) / keptBefore, 1.0, 1e-9);
    const auto equalLimits = [&] {
        return kept.isUpToDate() && live->isUpToDate() &&
               kept.shownPicture()->limits.low == live->shownPicture()->limits.low &&
               kept.shownPicture()->limits.high == live->shownPicture()->limits.high;
    };
    EXPECT_TRUE(waitUntil(equalLimits));
    live->infrared().setLimits({0.5, 3.0});
    EXPECT_TRUE(
        waitUntil([&] { return equalLimits() && kept.shownPicture()->limits.high == 3.0; }));
    live->infrared().setColorMap("viridis");
    EXPECT_TRUE(waitUntil([&] { return kept.infrared().colorMap().name() == "viridis"; }));
    test::keepScreenshot(*window, "states-beside");
    workbench.database().discard();
}

TEST_F(StatePageTest, AnotherProjectTakesKeptStatesAway) {
    ASSERT_NE(keep(), nullptr);
    workbench.adopt(workbench.editedProject());
    QTest::qWait(30);
    EXPECT_TRUE(window->findChildren<StatePage*>("statePage").isEmpty());
    EXPECT_FALSE(window->findChild<PageTabs*>("tabs")->beside()->isVisible());
}

} // namespace
} // namespace smat::gui

#include <QComboBox>
#include <QLineEdit>
#include <QToolButton>
#include <QWheelEvent>

#include "gui/view/ModelPage.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

/// The two cameras of the view, moved as a person moves them.
class LookingAroundTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        if (IsSkipped()) {
            return;
        }
        openSample();
        view = window->sceneView();
    }
    void wheel(int steps, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const QPointF at = QRectF(view->rect()).center();
        QWheelEvent event(at, view->mapToGlobal(at), {}, QPoint(0, 120 * steps), Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(view, &event);
        QTest::qWait(20);
    }
    void drag(Qt::MouseButton button, const QPoint& by, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint from = view->rect().center();
        QTest::mousePress(view, button, modifiers, from);
        QTest::mouseMove(view, from + by / 2);
        QTest::mouseMove(view, from + by);
        QTest::mouseRelease(view, button, modifiers, from + by);
        QTest::qWait(20);
    }
    bool isUntouched() {
        return !workbench.isModified() && workbench.undoStack().count() == 0 &&
               workbench.camera() == OrbitCamera{60.0, 15.0, 1000.0};
    }
    SceneView* view = nullptr;
};

TEST_F(LookingAroundTest, ChangesNothingInTheProject) {
    ASSERT_TRUE(isUntouched());
    wheel(3);
    EXPECT_TRUE(view->cameras().isInspecting());
    EXPECT_NEAR(view->camera().range_m, 1000.0 * 0.729, 1e-9);
    drag(Qt::LeftButton, {80, 30});
    EXPECT_NE(view->camera().azimuth_deg, 60.0);
    drag(Qt::RightButton, {80, 30});
    EXPECT_NE(view->camera().offset_m, irsg::Vec3{});
    QTest::keyClick(view, Qt::Key_Left);
    QTest::keyClick(view, Qt::Key_PageUp);
    QTest::mouseDClick(view, Qt::LeftButton, {}, view->rect().center());
    EXPECT_EQ(view->camera().offset_m, irsg::Vec3{});
    EXPECT_TRUE(isUntouched());
    EXPECT_FALSE(window->isWindowModified());
}

TEST_F(LookingAroundTest, OneKeyChangesBetweenSensorAndInspection) {
    wheel(3);
    const OrbitCamera around = view->camera();
    auto* key = window->findChild<QAction*>("inspectionCamera");
    EXPECT_EQ(key->shortcut(), QKeySequence(Qt::Key_F7));
    EXPECT_TRUE(key->isChecked());
    key->trigger();
    EXPECT_FALSE(view->cameras().isInspecting());
    EXPECT_EQ(view->camera(), workbench.camera());
    EXPECT_TRUE(window->findChild<QToolButton*>("showSensor")->isChecked());
    key->trigger();
    EXPECT_EQ(view->camera(), around);
    EXPECT_TRUE(window->findChild<QToolButton*>("showInspection")->isChecked());
}

TEST_F(LookingAroundTest, WithControlItIsTheSensorThatMoves) {
    wheel(1, Qt::ControlModifier);
    EXPECT_FALSE(view->cameras().isInspecting());
    EXPECT_EQ(workbench.camera().range_m, 900.0);
    EXPECT_TRUE(workbench.isModified());
    workbench.undoStack().undo();
    EXPECT_EQ(workbench.camera().range_m, 1000.0);
    EXPECT_FALSE(workbench.isModified());
}

TEST_F(LookingAroundTest, PicksAtTenKilometres) {
    workbench.set("camera.range", "10000");
    QTest::qWait(50);
    window->findChild<QAction*>("fitModel")->trigger();
    QTest::qWait(50);
    EXPECT_FALSE(view->facesAt(QRectF(view->rect()).center()).empty());
    EXPECT_EQ(workbench.camera().range_m, 10000.0);
    workbench.undoStack().undo();
}

TEST_F(LookingAroundTest, LooksAtSixSides) {
    const std::tuple<const char*, irsg::Vec3> sides[] = {
        {"lookAtFront", {0, -1, 0}},     {"lookAtRear", {0, 1, 0}}, {"lookAtPort", {1, 0, 0}},
        {"lookAtStarboard", {-1, 0, 0}}, {"lookAtTop", {0, 0, -1}}, {"lookAtBottom", {0, 0, 1}}};
    for (const auto& [name, along] : sides) {
        window->findChild<QAction*>(name)->trigger();
        const irsg::Vec3 forward = view->projection().eye.forward();
        EXPECT_NEAR(irsg::dot(forward, along), 1.0, 1e-9) << name;
    }
    EXPECT_TRUE(isUntouched());
}

TEST_F(LookingAroundTest, TheOtherCameraIsSeenInACornerAndAClickChangesToIt) {
    EXPECT_TRUE(view->insetRect().isNull()); // nobody has looked around yet
    window->findChild<QAction*>("fitModel")->trigger();
    window->findChild<QAction*>("lookAtTop")->trigger();
    QTest::qWait(80);
    const QRectF inset = view->insetRect();
    ASSERT_FALSE(inset.isNull());
    const QImage with = view->grabFramebuffer();
    window->findChild<QAction*>("pictureInPicture")->setChecked(false);
    QTest::qWait(80);
    const QImage without = view->grabFramebuffer();
    const double ratio = view->devicePixelRatioF();
    int inside = 0, outside = 0;
    for (int y = 0; y < with.height(); ++y) {
        for (int x = 0; x < with.width(); ++x) {
            if (with.pixel(x, y) != without.pixel(x, y)) {
                ++(inset.adjusted(-1, -1, 1, 1).contains(QPointF(x, y) / ratio) ? inside : outside);
            }
        }
    }
    EXPECT_GT(inside, 20);
    EXPECT_EQ(outside, 0);
    window->findChild<QAction*>("pictureInPicture")->setChecked(true);
    test::keepScreenshot(*window, "inspection-visible");
    QTest::mouseClick(view, Qt::LeftButton, {}, inset.center().toPoint());
    EXPECT_FALSE(view->cameras().isInspecting());
    EXPECT_TRUE(isUntouched());
    test::keepScreenshot(*window, "sensor-with-inspection");
}

TEST_F(LookingAroundTest, TheInfraredIsSeenFromTheInspectionCameraToo) {
    window->findChild<QAction*>("infraredDisplay")->setChecked(true);
    window->findChild<QAction*>("fitModel")->trigger();
    window->findChild<QAction*>("lookAtPort")->trigger();
    ASSERT_TRUE(test::waitUntil([this] { return view->isUpToDate(); }));
    ASSERT_NE(view->shownPicture(), nullptr);
    EXPECT_NEAR(irsg::dot(view->shownPicture()->eye.forward(), {1, 0, 0}), 1.0, 1e-9);
    QTest::qWait(80);
    test::keepScreenshot(*window, "inspection-infrared");
    EXPECT_TRUE(isUntouched());
}

TEST_F(LookingAroundTest, ABandIsOneChoice) {
    auto* box = window->findChild<QComboBox*>("bandBox");
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(box->currentText(), QString::fromUtf8("3–5 µm  MWIR"));
    const int lwir = box->findData("8-12");
    box->setCurrentIndex(lwir);
    emit box->activated(lwir);
    EXPECT_EQ(workbench.settings().text("sensor.band"), "8-12");
    EXPECT_EQ(workbench.undoStack().count(), 1);
    // One's own, as it is typed.
    box->lineEdit()->selectAll();
    QTest::keyClicks(box->lineEdit(), "3.4-4.1");
    QTest::keyClick(box->lineEdit(), Qt::Key_Return);
    EXPECT_EQ(workbench.settings().text("sensor.band"), "3.4-4.1");
    EXPECT_EQ(box->currentText(), QString::fromUtf8("3.4–4.1 µm"));
    // What is no band is told, and nothing changes.
    box->lineEdit()->selectAll();
    QTest::keyClicks(box->lineEdit(), "5-3");
    QTest::keyClick(box->lineEdit(), Qt::Key_Return);
    EXPECT_EQ(told.size(), 1);
    EXPECT_EQ(workbench.settings().text("sensor.band"), "3.4-4.1");
    workbench.undoStack().undo();
    workbench.undoStack().undo();
    EXPECT_EQ(box->currentText(), QString::fromUtf8("3–5 µm  MWIR"));
}

} // namespace
} // namespace smat::gui

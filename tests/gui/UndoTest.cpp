#include <QLineEdit>
#include <QMenu>

#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class UndoTest : public ::testing::Test {
  protected:
    UndoTest() { workbench.open(test::writeSampleProject(test::freshFolder("undo"))); }
    QString next() { return workbench.undoStack().undoText(); }

    Workbench workbench;
};

TEST_F(UndoTest, StepsAreNamedAfterSettingValueAndUnit) {
    workbench.set("camera.range", "1200");
    EXPECT_EQ(next(), "Set range to 1200 m");
    workbench.set("render.sunDisc", "true");
    EXPECT_EQ(next(), "Switch sun disc on");
    workbench.set("render.ambientReflection", "off");
    EXPECT_EQ(next(), "Set ambient reflection to off");
    workbench.undoStack().undo();
    workbench.undoStack().undo();
    EXPECT_EQ(next(), "Set range to 1200 m");
    EXPECT_FALSE(workbench.settings()[key::renderSunDisc]);
    workbench.undoStack().undo();
    EXPECT_EQ(workbench.settings()[key::cameraRange], 1000.0);
    EXPECT_FALSE(workbench.undoStack().canUndo());
    workbench.undoStack().redo();
    EXPECT_EQ(workbench.settings()[key::cameraRange], 1200.0);
}

TEST_F(UndoTest, TypingOneNumberIsOneStep) {
    for (const auto* text : {"1", "12", "12.", "12.3"}) {
        workbench.set("camera.elevation", text);
    }
    EXPECT_EQ(workbench.undoStack().count(), 1);
    EXPECT_EQ(next(), "Set elevation to 12.3°");
    workbench.closeStep();
    workbench.set("camera.elevation", "12.34");
    EXPECT_EQ(workbench.undoStack().count(), 2);
    workbench.set("camera.azimuth", "1");
    EXPECT_EQ(workbench.undoStack().count(), 3);
}

TEST_F(UndoTest, ADragIsOneStepHoweverLongItTakes) {
    workbench.holdStep();
    for (int i = 0; i < 5; ++i) {
        workbench.setCamera({10.0 + i, i > 2 ? 20.0 : 15.0, 1000.0});
        if (i == 2) {
            QTest::qWait(1700);
        }
    }
    workbench.closeStep();
    EXPECT_EQ(workbench.undoStack().count(), 1);
    EXPECT_EQ(next(), "Move the camera");
    workbench.undoStack().undo();
    EXPECT_EQ(workbench.camera(), (OrbitCamera{60.0, 15.0, 1000.0}));
}

TEST_F(UndoTest, AValueTakenBackWhileTypingLeavesNoStep) {
    workbench.set("camera.azimuth", "61");
    workbench.set("camera.azimuth", "60");
    EXPECT_EQ(workbench.undoStack().count(), 0);
    EXPECT_FALSE(workbench.isModified());
}

TEST_F(UndoTest, EditsOfTheProjectAreUndoneToo) {
    Project changed = workbench.project();
    changed.models.front().fallbackMaterial = 1;
    workbench.edit(changed, "Let material 1 stand in");
    EXPECT_EQ(next(), "Let material 1 stand in");
    EXPECT_TRUE(workbench.isModified());
    workbench.set("camera.azimuth", "5");
    workbench.undoStack().undo();
    EXPECT_TRUE(workbench.project().models.front().fallbackMaterial.has_value());
    workbench.undoStack().undo();
    EXPECT_FALSE(workbench.project().models.front().fallbackMaterial.has_value());
    EXPECT_FALSE(workbench.isModified());
}

TEST_F(UndoTest, StepsFromBeforeASaveElsewhereKeepTheirFiles) {
    const auto model = workbench.project().resolve(workbench.project().models.front().file);
    workbench.set("camera.azimuth", "5");
    const auto folder = test::freshFolder("undo-elsewhere") / "deeper";
    std::filesystem::create_directories(folder);
    workbench.saveAs(folder / "copy.smat");
    EXPECT_FALSE(workbench.isModified());
    workbench.undoStack().undo();
    EXPECT_EQ(workbench.settings()[key::cameraAzimuth], 60.0);
    EXPECT_TRUE(workbench.isModified());
    EXPECT_EQ(workbench.project().displayName(), "copy.smat");
    EXPECT_TRUE(std::filesystem::equivalent(
        workbench.project().resolve(workbench.project().models.front().file), model));
}

TEST_F(UndoTest, AValueThatIsNoneChangesNothing) {
    EXPECT_THROW(workbench.set("camera.range", "-5"), irsg::InputError);
    EXPECT_EQ(workbench.undoStack().count(), 0);
}

using UndoInWindowTest = test::WindowFixture;

TEST_F(UndoInWindowTest, TheEditMenuNamesTheStep) {
    openSample();
    auto* undo = window->findChild<QAction*>("undo");
    EXPECT_FALSE(undo->isEnabled());
    auto* field = window->findChild<QLineEdit*>("camera.range");
    field->selectAll();
    QTest::keyClicks(field, "1200");
    EXPECT_EQ(undo->text(), "&Undo Set range to 1200 m");
    EXPECT_TRUE(window->isWindowModified());
    undo->trigger();
    EXPECT_EQ(field->text(), "1000");
    EXPECT_FALSE(window->isWindowModified());
    window->findChild<QAction*>("redo")->trigger();
    EXPECT_EQ(field->text(), "1200");
}

TEST_F(UndoInWindowTest, MovingTheSensorByTheMouseIsOneStep) {
    openSample();
    auto* view = window->sceneView();
    QTest::mousePress(view, Qt::LeftButton, Qt::ControlModifier, {200, 200});
    for (int i = 1; i < 6; ++i) {
        QTest::mouseMove(view, {200 + 10 * i, 200 + 3 * i});
    }
    QTest::mouseRelease(view, Qt::LeftButton, {}, {250, 215});
    EXPECT_NE(workbench.camera().azimuth_deg, 60.0);
    EXPECT_EQ(workbench.undoStack().count(), 1);
    workbench.undoStack().undo();
    EXPECT_EQ(view->camera().azimuth_deg, 60.0);
}

TEST_F(UndoInWindowTest, APageOfAToolIsATabThatCloses) {
    auto* page = new QWidget;
    bool gone = false;
    QObject::connect(page, &QObject::destroyed, [&] { gone = true; });
    window->addPage(page, {}, "A tool");
    EXPECT_TRUE(page->isVisible());
    EXPECT_FALSE(window->findChild<QAction*>("exportShown")->isEnabled());
    window->findChild<QAction*>("closeResult")->trigger();
    EXPECT_TRUE(gone);
}

} // namespace
} // namespace smat::gui

#include <cmath>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QToolButton>
#include <QUndoStack>

#include "gui/scenario/EditPanel.h"
#include "gui/scenario/PlanView.h"
#include "gui/scenario/TrajectoryView.h"
#include "irsg/image/ExrFile.h"
#include "irsg/sensor/SensorFile.h"
#include "tests/cli/Program.h"
#include "tests/gui/ScenarioFixture.h"

namespace smat::gui {
namespace {

enum Column { t, x, y, z, yaw, pitch, roll, power, mach };

class ScenarioEditingTest : public test::ScenarioFixture {
  protected:
    /// Opens the small scenario with the fields of one of its parts.
    void edits(const char* part) {
        page = openScenario();
        ASSERT_NE(page, nullptr);
        window->activateWindow(); // for the keys of the menus
        auto* panels = page->findChild<QTabWidget*>("scenarioPanels");
        panels->setCurrentIndex(panels->count() - 1);
        choosePart(part);
    }
    void choosePart(const QString& part) {
        auto* parts = page->findChild<QComboBox*>("editedPart");
        const int index = parts->findText(part);
        ASSERT_GE(index, 0) << part.toStdString();
        parts->setCurrentIndex(index);
        emit parts->activated(index);
        QTest::qWait(20);
    }
    TrajectoryView& table() { return *page->findChild<TrajectoryView*>(); }
    QString cell(int row, int column) {
        return table().model()->index(row, column).data().toString();
    }
    QString message() { return page->findChild<QLabel*>("editMessage")->text(); }
    void clickCell(int row, int column) {
        const QModelIndex index = table().model()->index(row, column);
        table().scrollTo(index);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                          table().visualRect(index).center());
    }
    /// As a person types into a cell: the first key opens it, Enter takes it.
    void typeCell(int row, int column, const QString& text, bool isTaken = true) {
        clickCell(row, column);
        QTest::keyClicks(&table(), text.left(1));
        auto* field = table().findChild<QLineEdit*>("trajectoryCell");
        ASSERT_NE(field, nullptr);
        QTest::keyClicks(field, text.mid(1));
        if (isTaken) {
            QTest::keyClick(field, Qt::Key_Return);
            QTest::qWait(20);
        }
    }
    void typeField(const char* name, const QString& text) {
        auto* field = page->findChild<QLineEdit*>(name);
        ASSERT_NE(field, nullptr) << name;
        ASSERT_TRUE(field->isVisible()) << name;
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void pastes(const QString& text) {
        QApplication::clipboard()->setText(text);
        QTest::keyClick(&table(), Qt::Key_V, Qt::ControlModifier);
    }
    std::string fileText(const char* name) { return smat::test::contentOf(folder / name); }

    ScenarioPage* page = nullptr;
};

TEST_F(ScenarioEditingTest, ACellIsEditedUndoneDoneAgainSavedAndReopenedEqual) {
    edits("mover");
    const std::string scenarioBefore = fileText("pass.json");
    const QPointF before = page->findChild<PlanView*>()->pointOf(0, 0);
    typeCell(2, x, "16");
    EXPECT_EQ(cell(2, x), "16");
    EXPECT_TRUE(page->title().endsWith(" *"));
    EXPECT_EQ(workbench.undoStack().undoText(), "Set x at 2 s: mover");
    EXPECT_NE(page->findChild<PlanView*>()->pointOf(0, 0), before);
    test::keepScreenshot(*window, "scenario-edit");
    QTest::keyClick(&table(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(cell(2, x), "6");
    EXPECT_FALSE(page->document().isModified());
    QTest::keyClick(&table(), Qt::Key_Y, Qt::ControlModifier);
    EXPECT_EQ(cell(2, x), "16");
    QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
    EXPECT_FALSE(page->document().isModified()) << told.join('\n').toStdString();
    // Nothing but the cell has changed, and the file of the scenario not at all.
    std::string wanted = flight;
    wanted.replace(wanted.find("\n2,6,"), 5, "\n2,16,");
    EXPECT_EQ(fileText("flight.csv"), wanted);
    EXPECT_EQ(fileText("pass.json"), scenarioBefore);
    QUndoStack stack;
    const ScenarioDocument again(folder / "pass.json", stack);
    EXPECT_EQ(*again.now(), *page->document().now());
}

TEST_F(ScenarioEditingTest, TimesTitleNamesAndPlacesAreEditedAndReopenedEqual) {
    edits("Scenario");
    typeField("scenarioTitle", "A longer pass");
    typeField("scenarioEnd", "3");
    typeField("scenarioStep", "0.5");
    EXPECT_EQ(page->timeLine().times_s().size(), 7U);
    EXPECT_EQ(workbench.undoStack().count(), 3);
    choosePart("buoy");
    typeField("place.y", "112.5");
    typeField("place.yaw", "33.3");
    choosePart("mover");
    typeField("partName", "flyer");
    EXPECT_EQ(message(), "");
    choosePart("mwir (sensor)");
    test::keepScreenshot(*window, "scenario-edit-sensor");
    typeField("place.z", "51");
    choosePart("lwir (sensor)");
    EXPECT_FALSE(page->findChild<QLineEdit*>("place.yaw")->isVisible()); // it looks at the mover
    const Scenario edited = page->document().scenario();
    EXPECT_EQ(edited.title, "A longer pass");
    EXPECT_EQ(edited.entities[1].pose.position_m.y, 112.5);
    EXPECT_EQ(edited.sensors[1].track, "flyer");
    EXPECT_EQ(edited.sensors[0].offset.position_m.z, 51.0);
    EXPECT_EQ(workbench.undoStack().undoText(), "Set z of mwir");
    trigger("saveProject");
    EXPECT_FALSE(page->document().isModified()) << told.join('\n').toStdString();
    QUndoStack stack;
    const ScenarioDocument again(folder / "pass.json", stack);
    EXPECT_EQ(again.scenario(), page->document().scenario());
    EXPECT_EQ(again.scenario().notes, "Kept as it is.");
    EXPECT_EQ(again.scenario().entities[0].trajectory, "flight.csv");
    // Every step goes back, one at a time.
    while (workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    EXPECT_EQ(page->document().scenario().title, "Pass");
    EXPECT_EQ(page->document().scenario().sensors[1].track, "mover");
    EXPECT_EQ(page->document().scenario().entities[1].pose.position_m.y, 110.0);
}

TEST_F(ScenarioEditingTest, NotesAndSettingsAreEditedUndoneSavedAndReopenedEqual) {
    edits("Scenario");
    auto* notes = page->findChild<QPlainTextEdit*>("scenarioText");
    ASSERT_TRUE(notes->isVisible());
    EXPECT_EQ(notes->toPlainText(), "Kept as it is.");
    notes->setFocus();
    notes->selectAll();
    QTest::keyClicks(notes, "Seen at dawn");
    QTest::keyClick(notes, Qt::Key_Tab); // goes on to the next field
    EXPECT_FALSE(notes->hasFocus());
    EXPECT_EQ(page->document().scenario().notes, "Seen at dawn");
    EXPECT_EQ(workbench.undoStack().count(), 1);
    EXPECT_EQ(workbench.undoStack().undoText(), "Change the notes");

    const auto setsField = [&](const char* key, const QString& text) {
        onDialog = [=](QDialog& dialog) {
            EXPECT_NE(dialog.findChild<QWidget*>("render.sunDisc"), nullptr);
            EXPECT_EQ(dialog.findChild<QWidget*>("camera.range"), nullptr);
            auto* field = dialog.findChild<QLineEdit*>(key);
            ASSERT_NE(field, nullptr) << key;
            field->setText(text);
            emit field->textEdited(text);
            dialog.accept();
        };
        page->findChild<QToolButton*>("scenarioSettings")->click();
        ASSERT_TRUE(settles(*page));
    };
    setsField("sensor.fov", "9");
    EXPECT_EQ(page->document().scenario().settings.text("sensor.fov"), "9");
    EXPECT_FALSE(page->document().scenario().settings.isSet("render.sunDisc"))
        << "what was not touched is not set";
    EXPECT_EQ(workbench.undoStack().undoText(), "Change settings of all sensors");
    EXPECT_EQ(page->picture().settings[RealKey{"sensor.fov"}], 9.0);
    choosePart("lwir (sensor)");
    setsField("sensor.fov", "5");
    EXPECT_EQ(page->document().scenario().sensors[1].settings.text("sensor.fov"), "5");
    EXPECT_EQ(page->document().scenario().settings.text("sensor.fov"), "9");
    setsField("sensor.fov", "9"); // what it would have without
    EXPECT_FALSE(page->document().scenario().sensors[1].settings.isSet("sensor.fov"));
    EXPECT_EQ(workbench.undoStack().count(), 4);
    choosePart("buoy");
    EXPECT_FALSE(page->findChild<QToolButton*>("scenarioSettings")->isEnabled());

    trigger("saveProject");
    EXPECT_FALSE(page->document().isModified()) << told.join('\n').toStdString();
    QUndoStack stack;
    EXPECT_EQ(ScenarioDocument(folder / "pass.json", stack).scenario(),
              page->document().scenario());
    while (workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    EXPECT_EQ(page->document().scenario().notes, "Kept as it is.");
    EXPECT_EQ(page->document().scenario().settings.text("sensor.fov"), "12");
}

TEST_F(ScenarioEditingTest, ASensorIsGivenAFileThatReadsItsFrames) {
    edits("lwir (sensor)");
    irsg::SensorDescription sensor =
        irsg::loadSensor(SMAT_SOURCE_DIR "/resources/sensors/cooled-mwir.smatsensor");
    sensor.detector.columns = 40;
    sensor.detector.rows = 30;
    irsg::saveSensor(sensor, folder / "own.smatsensor");
    onDialog = [](QDialog& dialog) {
        auto* file = dialog.findChild<QLineEdit*>("image.sensor");
        auto* quantity = dialog.findChild<QComboBox*>("image.quantity");
        ASSERT_NE(file, nullptr);
        ASSERT_NE(quantity, nullptr);
        file->setText("own.smatsensor");
        emit file->textEdited(file->text());
        const int counts = quantity->findText("counts");
        ASSERT_GE(counts, 0);
        quantity->setCurrentIndex(counts);
        emit quantity->activated(counts);
        dialog.accept();
    };
    page->findChild<QToolButton*>("scenarioSettings")->click();
    ASSERT_TRUE(settles(*page));
    EXPECT_EQ(page->document().scenario().sensors[1].settings.text("image.quantity"), "counts");
    auto* sensors = page->findChild<QComboBox*>("scenarioSensor");
    ASSERT_NE(sensors, nullptr);
    const int lwir = sensors->findText("lwir");
    ASSERT_GE(lwir, 0);
    sensors->setCurrentIndex(lwir);
    emit sensors->activated(lwir);
    ASSERT_TRUE(settles(*page)) << told.join('\n').toStdString();
    ASSERT_NE(page->picture().image, nullptr);
    EXPECT_EQ(page->picture().image->primary().name, "counts");
    EXPECT_EQ(page->picture().image->width(), 40);
}

TEST_F(ScenarioEditingTest, ASensorIsGivenACarrierAndATargetByKeys) {
    edits("mwir (sensor)");
    auto* mount = page->findChild<QComboBox*>("sensorMount");
    auto* track = page->findChild<QComboBox*>("sensorTrack");
    const Scenario before = page->document().scenario();
    const auto sensor = [&]() -> const ScenarioSensor& {
        return page->document().scenario().sensors[0];
    };
    EXPECT_EQ(mount->currentText(), "The ground: stands still");
    test::keepScreenshot(*window, "scenario-mount");
    track->setFocus();
    QTest::keyClick(track, Qt::Key_End); // the buoy
    EXPECT_EQ(sensor().track, "buoy");
    EXPECT_EQ(workbench.undoStack().undoText(), "Change what mwir looks at");
    EXPECT_FALSE(page->findChild<QLineEdit*>("place.yaw")->isVisible());
    // On what it looks at it cannot ride.
    mount->setFocus();
    QTest::keyClick(mount, Qt::Key_End);
    EXPECT_TRUE(message().contains("another entity than its carrier")) << message().toStdString();
    EXPECT_EQ(mount->currentText(), "The ground: stands still");
    EXPECT_EQ(workbench.undoStack().count(), 1);
    // On the mover it sits where it stood when the scenario began: its nose points east.
    QTest::keyClick(mount, Qt::Key_Down);
    EXPECT_EQ(message(), "");
    EXPECT_EQ(sensor().mount, MountKind::entity);
    EXPECT_EQ(sensor().carrier, "mover");
    EXPECT_NEAR(sensor().offset.position_m.x, 100.0, 1e-6);
    EXPECT_NEAR(sensor().offset.position_m.y, 6.0, 1e-6);
    EXPECT_NEAR(sensor().offset.position_m.z, 0.0, 1e-6);
    ASSERT_TRUE(settles(*page));
    mount->setFocus();
    QTest::keyClick(mount, Qt::Key_Home);
    EXPECT_EQ(sensor().mount, MountKind::world);
    EXPECT_EQ(sensor().offset.position_m, before.sensors[0].offset.position_m);
    // Without a target it goes on looking there.
    track->setFocus();
    QTest::keyClick(track, Qt::Key_Home);
    EXPECT_EQ(sensor().track, "");
    const irsg::Vec3 nose = sensor().offset.attitude.rotation() * irsg::Vec3{0, 1, 0};
    const irsg::Vec3 wanted = irsg::normalized(irsg::Vec3{4, 110, 0});
    EXPECT_NEAR(irsg::length(nose - wanted), 0.0, 1e-12);
    EXPECT_EQ(workbench.undoStack().count(), 4);
    trigger("saveProject");
    QUndoStack stack;
    EXPECT_NEAR(
        ScenarioDocument(folder / "pass.json", stack).scenario().sensors[0].offset.attitude.yaw_rad,
        sensor().offset.attitude.yaw_rad, 1e-12);
    while (workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    EXPECT_EQ(page->document().scenario().sensors[0], before.sensors[0]);
}

TEST_F(ScenarioEditingTest, ABlockIsPastedFromASpreadsheetAndCopiedBack) {
    edits("mover");
    clickCell(1, t);
    pastes("1.5\t1\t100\r\n2.5\t9\t101\r\n0.5\t-3\t99\r\n");
    EXPECT_EQ(message(), "");
    ASSERT_EQ(table().model()->rowCount(), 5); // and the row to add to
    // In the order of the times; the rest of a row is that of the row it was pasted on.
    EXPECT_EQ(cell(1, t), "0.5");
    EXPECT_EQ(cell(1, x), "-3");
    EXPECT_EQ(cell(2, t), "1.5");
    EXPECT_EQ(cell(2, power), "0.6");
    EXPECT_EQ(cell(3, y), "101");
    EXPECT_EQ(workbench.undoStack().undoText(), "Paste 3 rows: mover");
    page->findChild<QToolButton*>("copyTable")->click();
    const QString copied = QApplication::clipboard()->text();
    EXPECT_TRUE(copied.startsWith("0\t-6\t100\t50\t270\t0\t0\t0.2\t0.1\n0.5\t-3\t99\t"))
        << copied.toStdString();
    QTest::keyClick(&table(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(table().model()->rowCount(), 4);
    // All of it comes back in place of the rows that are there.
    QApplication::clipboard()->setText(copied);
    page->findChild<QToolButton*>("pasteTable")->click();
    EXPECT_EQ(table().model()->rowCount(), 5);
    EXPECT_EQ(cell(3, y), "101");
    // What does not fit is told, and nothing changes.
    clickCell(0, roll);
    pastes("1\t2\t3\t4\n");
    EXPECT_TRUE(message().contains("4 columns do not fit")) << message().toStdString();
    clickCell(0, t);
    pastes("0.5\n");
    EXPECT_TRUE(message().contains("two rows have the time 0.5 s")) << message().toStdString();
    pastes("0\tx\n");
    EXPECT_TRUE(message().contains("'x' is not a number")) << message().toStdString();
    EXPECT_EQ(table().model()->rowCount(), 5);
}

TEST_F(ScenarioEditingTest, RowsAreAddedInsertedAndRemoved) {
    edits("mover");
    typeCell(3, power, "0.9"); // the row to add to goes on along the last leg
    ASSERT_EQ(table().model()->rowCount(), 5);
    EXPECT_EQ(cell(3, t), "3");
    EXPECT_EQ(cell(3, x), "12");
    clickCell(1, x);
    QTest::keyClick(&table(), Qt::Key_Insert);
    EXPECT_EQ(cell(1, t), "0.5");
    EXPECT_EQ(cell(1, power), "0.4");
    QTest::keyClick(&table(), Qt::Key_Delete);
    EXPECT_EQ(cell(1, t), "1");
    typeCell(0, t, "1.75"); // its place is behind the next one now
    EXPECT_EQ(cell(1, t), "1.75");
    QTest::keyClick(&table(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(&table(), Qt::Key_Delete);
    EXPECT_TRUE(message().contains("at least one row")) << message().toStdString();
    EXPECT_EQ(table().model()->rowCount(), 5);
}

TEST_F(ScenarioEditingTest, WhatCannotBeIsToldInPlaceAndGoesBack) {
    edits("mover");
    const struct {
        Column column;
        const char *text, *told;
    } refused[] = {{pitch, "95", "-90 to 90"},
                   {mach, "31", "0 to 30"},
                   {x, "far", "“far”"},
                   {t, "1", "row 2 has 1 s already"}};
    for (const auto& one : refused) {
        typeCell(0, one.column, one.text, false);
        EXPECT_TRUE(message().contains(one.told)) << message().toStdString();
        QTest::keyClick(table().findChild<QLineEdit*>("trajectoryCell"), Qt::Key_Escape);
        QTest::qWait(20);
    }
    choosePart("buoy");
    typeField("partName", "mover");
    EXPECT_TRUE(message().contains("no other entity")) << message().toStdString();
    choosePart("Scenario");
    typeField("scenarioStep", "0.00000001");
    typeField("scenarioStart", "2.5");
    EXPECT_TRUE(message().contains("not before start_s")) << message().toStdString();
    EXPECT_EQ(page->document().scenario().start_s, 0.0);
    EXPECT_EQ(page->findChild<QLineEdit*>("scenarioStart")->text(), "0");
    choosePart("mover");
    page->findChild<QToolButton*>("removeEntity")->click();
    EXPECT_TRUE(message().contains("lwir looks at it")) << message().toStdString();
    EXPECT_FALSE(page->document().isModified());
    EXPECT_EQ(workbench.undoStack().count(), 0);
}

TEST_F(ScenarioEditingTest, EntitiesAreAddedAndRemoved) {
    edits("buoy");
    chosen = SMAT_SOURCE_DIR "/samples/sphere/sphere.flt";
    page->findChild<QToolButton*>("addEntity")->click();
    ASSERT_TRUE(settles(*page));
    ASSERT_EQ(page->document().scenario().entities.size(), 3U);
    EXPECT_EQ(page->findChild<QComboBox*>("editedPart")->currentText(), "sphere");
    EXPECT_EQ(page->document().scenario().entities[2].pose.position_m.x, 44.0);
    EXPECT_EQ(page->picture().entities.size(), 3U);
    page->findChild<QToolButton*>("removeEntity")->click();
    EXPECT_EQ(page->document().scenario().entities.size(), 2U);
    workbench.undoStack().undo();
    workbench.undoStack().undo();
    EXPECT_FALSE(page->document().isModified());
}

TEST_F(ScenarioEditingTest, SensorsAreAddedNamedAndRemoved) {
    edits("lwir (sensor)");
    const Scenario before = page->document().scenario();
    page->findChild<QToolButton*>("addSensor")->click();
    ASSERT_EQ(page->document().scenario().sensors.size(), 3U);
    ScenarioSensor copy = page->document().scenario().sensors[2];
    EXPECT_EQ(copy.name, "lwir-2");
    copy.name = "lwir";
    EXPECT_EQ(copy, before.sensors[1]);
    EXPECT_EQ(page->findChild<QComboBox*>("editedPart")->currentText(), "lwir-2 (sensor)");
    typeField("partName", "wide");
    EXPECT_EQ(page->findChild<QComboBox*>("scenarioSensor")->count(), 3);
    page->showSensor(2);
    ASSERT_TRUE(settles(*page));
    EXPECT_EQ(page->picture().moment.sensor, 2U);
    auto* remove = page->findChild<QToolButton*>("removeEntity");
    for (int left = 2; left > 0; --left) {
        remove->click();
        ASSERT_EQ(page->document().scenario().sensors.size(), static_cast<std::size_t>(left));
        choosePart(QString::fromStdString(page->document().scenario().sensors[0].name) +
                   " (sensor)");
    }
    remove->click();
    EXPECT_EQ(message(), "A scenario needs at least one sensor");
    while (workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    EXPECT_EQ(page->document().scenario(), before);
}

TEST_F(ScenarioEditingTest, ASensorIsGivenATrajectoryOfItsOwn) {
    edits("lwir (sensor)");
    const auto sensor = [&]() -> const ScenarioSensor& {
        return page->document().scenario().sensors[1];
    };
    write("lwir.csv", "what somebody else keeps here");
    page->findChild<QToolButton*>("newTrajectory")->click();
    EXPECT_EQ(message(), "");
    EXPECT_EQ(sensor().mount, MountKind::trajectory);
    EXPECT_EQ(sensor().trajectory, "lwir-2.csv") << "the other name is taken";
    EXPECT_EQ(sensor().offset, irsg::Pose());
    ASSERT_EQ(table().model()->rowCount(), 3) << "two rows and the empty one";
    EXPECT_EQ(cell(0, t), "0");
    EXPECT_EQ(cell(1, t), "2");
    EXPECT_EQ(cell(1, z), "50");
    typeCell(1, x, "40");
    ASSERT_TRUE(settles(*page));
    page->showSensor(1);
    page->timeLine().setStep(8);
    ASSERT_TRUE(settles(*page));
    // From (40, 0) to the mover at (6, 100), 2 m above it.
    EXPECT_NEAR(page->picture().objects[0]->range_m, std::hypot(34.0, 100.0, 2.0), 1.0);
    trigger("saveProject");
    QUndoStack stack;
    EXPECT_EQ(*ScenarioDocument(folder / "pass.json", stack).now(), *page->document().now());
    EXPECT_EQ(fileText("lwir.csv"), "what somebody else keeps here");
    EXPECT_NE(fileText("lwir-2.csv").find("\n2,40,0,50,"), std::string::npos);
}

TEST_F(ScenarioEditingTest, ASensorThatLooksAlongItsNoseGoesOnLookingThere) {
    edits("mwir (sensor)");
    auto* mount = page->findChild<QComboBox*>("sensorMount");
    mount->setFocus();
    QTest::keyClick(mount, Qt::Key_Down); // on the mover, whose nose points east
    const ScenarioSensor riding = page->document().scenario().sensors[0];
    ASSERT_EQ(riding.mount, MountKind::entity);
    page->findChild<QToolButton*>("newTrajectory")->click();
    const ScenarioSensor& flying = page->document().scenario().sensors[0];
    const TrajectoryTable& rows = *page->document().now()->table(flying.trajectory);
    EXPECT_EQ(rows.rows[0][TrajectoryTable::x], 0.0);
    EXPECT_EQ(rows.rows[0][TrajectoryTable::y], 0.0);
    // The nose of the mover is yaw 270; the sensor looked along it.
    EXPECT_NEAR(std::remainder(rows.rows[0][TrajectoryTable::yaw] - 270.0, 360.0), 0.0, 1e-9);
}

TEST_F(ScenarioEditingTest, AnEntityBeginsToMoveFollowsAFileAndStandsStillAgain) {
    edits("buoy");
    const EditedScenario before = *page->document().now();
    EXPECT_FALSE(page->findChild<QToolButton*>("standStill")->isEnabled());
    page->findChild<QToolButton*>("newTrajectory")->click();
    const auto buoy = [&]() -> const ScenarioEntity& {
        return page->document().scenario().entities[1];
    };
    EXPECT_EQ(buoy().trajectory, "buoy.csv");
    EXPECT_EQ(cell(0, x), "4");
    EXPECT_EQ(cell(1, y), "110");
    EXPECT_FALSE(std::filesystem::exists(folder / "buoy.csv")) << "not before it is saved";
    chosen = QString::fromStdString((folder / "flight.csv").string());
    page->findChild<QToolButton*>("trajectoryFile")->click();
    EXPECT_EQ(buoy().trajectory, "flight.csv");
    EXPECT_EQ(page->document().now()->trajectories.size(), 1U) << "nobody follows the other one";
    EXPECT_EQ(cell(0, x), "-6");
    page->findChild<QToolButton*>("standStill")->click();
    EXPECT_TRUE(buoy().trajectory.empty());
    EXPECT_EQ(buoy().pose.position_m, (irsg::Vec3{-6, 100, 50}));
    EXPECT_EQ(page->document().now()->trajectories.size(), 1U) << "the mover follows it";
    EXPECT_EQ(buoy().power, 0.2);
    write("bad.csv", "t [s],x [m]\n0,1\n");
    chosen = QString::fromStdString((folder / "bad.csv").string());
    page->findChild<QToolButton*>("trajectoryFile")->click();
    EXPECT_TRUE(message().contains("bad.csv")) << message().toStdString();
    EXPECT_TRUE(buoy().trajectory.empty());
    while (workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    EXPECT_EQ(*page->document().now(), before);
}

TEST_F(ScenarioEditingTest, AScenarioIsBegunWithTheModelsAndTheViewOfTheProject) {
    openSample();
    workbench.set("camera.range", "321");
    workbench.set("sensor.band", "8-12");
    workbench.set("state.power", "0.5");
    chosen = QString::fromStdString((folder / "begun.json").string());
    trigger("newScenario");
    page = shownPage();
    ASSERT_NE(page, nullptr) << told.join('\n').toStdString();
    ASSERT_TRUE(settles(*page));
    const Scenario& scenario = page->document().scenario();
    ASSERT_EQ(scenario.entities.size(), 1U);
    EXPECT_EQ(scenario.entities[0].name, "ship");
    EXPECT_EQ(scenario.entities[0].power, 0.5);
    EXPECT_EQ(scenario.entities[0].pose.position_m, (irsg::Vec3{0, 0, 100}));
    EXPECT_EQ(scenario.settings.text("sensor.band"), "8-12");
    EXPECT_FALSE(scenario.settings.isSet("camera.range"));
    ASSERT_EQ(page->picture().entities.size(), 1U);
    EXPECT_NEAR(page->picture().objects[0]->range_m, 321.0, 2e-3);
    EXPECT_FALSE(page->document().isModified());
    // What is open is not written over.
    trigger("newScenario");
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told.front().contains("a scenario that is open")) << told.front().toStdString();
    told.clear();
    // Nor is there one of a model without signatures.
    Project bare = workbench.editedProject();
    bare.models[0].database.clear();
    workbench.edit(bare, "Take the database away");
    trigger("newScenario");
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told.front().contains("no signature database")) << told.front().toStdString();
    told.clear();
}

TEST_F(ScenarioEditingTest, ClosingAsksForWhatIsNotSaved) {
    edits("mover");
    typeCell(0, z, "55");
    auto* tabs = window->findChild<QTabWidget*>("tabs");
    answers = {-1, -1, 0}; // stay, stay, then save
    emit tabs->tabCloseRequested(tabs->currentIndex());
    EXPECT_EQ(shownPage(), page);
    // By the menu of its tab, too.
    QTabBar* bar = tabs->tabBar();
    emit bar->customContextMenuRequested(bar->tabRect(tabs->currentIndex()).center());
    auto* menu = tabs->findChild<QMenu*>("tabMenu");
    ASSERT_NE(menu, nullptr);
    menu->actions().back()->trigger();
    menu->close();
    EXPECT_EQ(shownPage(), page);
    emit tabs->tabCloseRequested(tabs->currentIndex());
    EXPECT_EQ(asked, QStringList({"Unsaved scenario", "Unsaved scenario", "Unsaved scenario"}));
    EXPECT_NE(fileText("flight.csv").find("\n0,-6,100,55,"), std::string::npos);
}

TEST_F(ScenarioEditingTest, WhatIsPlayedAfterAnEditEqualsSmatBatchOfTheSavedFile) {
    edits("mover");
    typeCell(2, x, "3");
    typeCell(2, power, "0.35");
    choosePart("buoy");
    typeField("place.yaw", "12.3");
    trigger("saveProject");
    ASSERT_FALSE(page->document().isModified()) << told.join('\n').toStdString();
    const auto ran = smat::test::smatBatch({"simulate", "pass.json", "--out", "out"}, folder);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    for (const std::size_t sensor : {0U, 1U}) {
        page->showSensor(sensor);
        for (const std::size_t step : {0U, 5U, 8U}) {
            page->timeLine().setStep(step);
            ASSERT_TRUE(settles(*page));
            ASSERT_NE(page->picture().image, nullptr);
            irsg::RadianceImage ofBatch =
                irsg::readExr(folder / "out" / (sensor == 0 ? "mwir" : "lwir") /
                              ("frame_00000" + std::to_string(step) + ".exr"));
            ofBatch.attributes.erase("command");
            irsg::writeExr(*page->picture().image, folder / "window.exr");
            irsg::writeExr(ofBatch, folder / "batch.exr");
            EXPECT_TRUE(fileText("window.exr") == fileText("batch.exr")) << sensor << step;
        }
    }
}

} // namespace
} // namespace smat::gui

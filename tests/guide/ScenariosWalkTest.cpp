#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSlider>
#include <QTableWidget>

#include "gui/plot/CartesianPlot.h"
#include "gui/scenario/PlanView.h"
#include "gui/scenario/ScenarioPage.h"
#include "gui/scenario/TimeLine.h"
#include "gui/scenario/TrajectoryView.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFormat.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

enum Column { time, x, y };

/// A box that flies past a buoy, and two sensors: one of two bands, and one that looks at it.
class ScenariosWalkTest : public test::GuideFixture {
  protected:
    void open() {
        const std::string box = SMAT_SOURCE_DIR "/samples/box/box";
        const auto entity = [&](const std::string& name, const std::string& place) {
            return R"({"name": ")" + name + R"(", "model": ")" + box + R"(.flt", "database": ")" +
                   box + R"(.sigdb", )" + place + "}";
        };
        smat::test::write(folder / "flight.csv",
                          "t [s],x [m],y [m],z [m],yaw [deg],pitch [deg],roll [deg],power,mach\n"
                          "0,-6,100,50,270,0,0,0.2,0.1\n1,0,100,50,270,0,0,0.6,0.1\n"
                          "2,6,100,52,270,0,0,1,0.1\n");
        smat::test::write(folder / "pass.json",
                          R"({"version": 1, "title": "Pass", "dt_s": 0.5, "end_s": 2.5,
 "sensor": {"width": 48, "height": 40, "fov": 12}, "render": {"lightError": 0.02},
 "entities": [)" + entity("mover", R"("trajectory": "flight.csv")") +
                              ", " + entity("buoy", R"("position_m": [4, 110, 50])") + R"(],
 "sensors": [{"name": "two", "position_m": [0, 0, 50], "sensor": {"band": "3-5, 8-12"}},
  {"name": "lwir", "position_m": [0, 0, 50], "track": "mover", "sensor": {"band": "8-12"}}]})");
        chosen = path("pass.json");
        act("openProject");
        shown = page<ScenarioPage>();
        ASSERT_NE(shown, nullptr) << said();
        ASSERT_TRUE(settles());
        window->activateWindow();
    }
    bool settles() {
        return test::waitUntil([this] { return !shown->isBusy(); });
    }
    void press(Qt::Key key) { QTest::keyClick(get<QSlider>("timeSlider", shown), key); }
    QString cell(int row, int column) {
        return get<QTableWidget>("entitiesNow", shown)->item(row, column)->text();
    }
    void choosePart(const QString& part) {
        auto* parts = get<QComboBox>("editedPart", shown);
        ASSERT_GE(parts->findText(part), 0) << part.toStdString();
        choose(parts, parts->findText(part));
        QTest::qWait(20);
    }
    TrajectoryView& table() { return *shown->findChild<TrajectoryView*>(); }
    QString tableCell(int row, int column) {
        return table().model()->index(row, column).data().toString();
    }
    void clickCell(int row, int column) {
        const QModelIndex index = table().model()->index(row, column);
        table().scrollTo(index);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                          table().visualRect(index).center());
    }
    void typeCell(int row, int column, const QString& text) {
        clickCell(row, column);
        QTest::keyClicks(&table(), text.left(1));
        auto* field = get<QLineEdit>("trajectoryCell", &table());
        QTest::keyClicks(field, text.mid(1));
        QTest::keyClick(field, Qt::Key_Return);
        QTest::qWait(20);
    }
    QString message() { return get<QLabel>("editMessage", shown)->text(); }
    void showPanel(const QString& title) {
        auto* panels = get<QTabWidget>("scenarioPanels", shown);
        for (int i = 0; i < panels->count(); ++i) {
            if (panels->tabText(i) == title) {
                panels->setCurrentIndex(i);
                QTest::qWait(20);
                return;
            }
        }
        ADD_FAILURE() << "no panel " << title.toStdString();
    }
    /// The text of the fields' name in the form, as it stands beside it.
    bool says(const QString& words) {
        return std::ranges::any_of(shown->findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->isVisible() && label->text().remove('&') == words;
        });
    }
    ScenarioPage* shown = nullptr;
};

TEST_F(ScenariosWalkTest, SeePlayAndKeepIt) {
    test::GuideWalk walk("scenarios", "");
    walk.step("File → Open… opens it as a page; the sample flyby is one. File → New scenario… "
              "begins one: the models of the project where they stand, one sensor where the camera "
              "is, ten steps of a second.");
    openSample();
    chosen = path("begun.json");
    act("newScenario");
    ASSERT_NE(page<ScenarioPage>(), nullptr) << said();
    const Scenario begun = page<ScenarioPage>()->document().scenario();
    EXPECT_EQ(begun.entities.size(), workbench.project().models.size());
    EXPECT_EQ(begun.sensors.size(), 1U);
    EXPECT_EQ(begun.times_s().size(), 11U);
    chosen = SMAT_SOURCE_DIR "/samples/flyby/flyby.json";
    act("openProject");
    ASSERT_NE(page<ScenarioPage>(), nullptr) << said();
    open();

    walk.step("see another time | drag the line of time, type the seconds, or press Left, Right, "
              "Home, End");
    TimeLine& line = shown->timeLine();
    get<QSlider>("timeSlider", shown)->setValue(3);
    EXPECT_EQ(line.step(), 3U);
    write(get<QLineEdit>("time", shown), "2");
    EXPECT_EQ(line.time_s(), 2.0);
    press(Qt::Key_Left);
    EXPECT_EQ(line.time_s(), 1.5);
    press(Qt::Key_Right);
    press(Qt::Key_End);
    EXPECT_EQ(line.time_s(), 2.5);
    press(Qt::Key_Home);
    EXPECT_EQ(line.step(), 0U);
    walk.step("play it | Space; Real time skips steps if rendering takes longer, Every "
              "step shows each");
    choose(get<QComboBox>("speed", shown), 1);
    EXPECT_EQ(get<QComboBox>("speed", shown)->currentText(), "Every step");
    std::vector<std::size_t> seen;
    QObject::connect(&line, &TimeLine::stepChanged, shown, [&] { seen.push_back(line.step()); });
    press(Qt::Key_Space);
    ASSERT_TRUE(test::waitUntil([&] { return !line.isPlaying(); }));
    EXPECT_EQ(seen, (std::vector<std::size_t>{1, 2, 3, 4, 5}));

    walk.step("see through another sensor | choose it above the picture; a sensor of several bands "
              "has one picture of each");
    press(Qt::Key_Home);
    EXPECT_EQ(get<QComboBox>("scenarioBand", shown)->count(), 2);
    ASSERT_TRUE(settles());
    const auto first = shown->picture().image;
    choose(get<QComboBox>("scenarioBand", shown), 1);
    ASSERT_TRUE(settles());
    EXPECT_NE(shown->picture().image->primary().values, first->primary().values);
    choose(get<QComboBox>("scenarioSensor", shown), 1);
    ASSERT_TRUE(settles());
    EXPECT_EQ(shown->picture().moment.sensor, 1U);
    choose(get<QComboBox>("scenarioSensor", shown), 0);
    ASSERT_TRUE(settles());

    walk.step("the table gives for each entity its range, intensity, contrast intensity, pixels, "
              "power, Mach number and altitude at this time, or that it is not there");
    EXPECT_EQ(cell(0, 0), "mover");
    EXPECT_NEAR(cell(0, 1).toDouble(), 100.2, 0.1);
    for (const int column : {2, 4}) {
        EXPECT_GT(cell(0, column).section(' ', 0, 0).toDouble(), 0.0) << column;
    }
    EXPECT_EQ(cell(0, 5), "0.2");
    EXPECT_EQ(cell(0, 6), "0.1");
    EXPECT_EQ(cell(0, 7), "50");
    press(Qt::Key_End); // after its last row
    ASSERT_TRUE(settles());
    EXPECT_EQ(cell(0, 1), "not there");

    walk.step("Plan: from above, north up, with trajectories, sensors and their fields; wheel "
              "zooms, drag moves, double click shows all");
    showPanel("Plan");
    auto* plan = shown->findChild<PlanView*>();
    const QPointF origin = plan->pointOf(0, 0);
    EXPECT_LT(plan->pointOf(0, 100).y(), origin.y()) << "north up";
    EXPECT_GT(plan->pointOf(100, 0).x(), origin.x());
    wheel(plan, QPointF(plan->rect().center()), 2);
    EXPECT_NE(plan->pointOf(0, 0), origin);
    drag(plan, Qt::LeftButton, QPointF(plan->rect().center()), {30, 20});
    QTest::mouseDClick(plan, Qt::LeftButton, {}, plan->rect().center());
    EXPECT_EQ(plan->pointOf(0, 0), origin);

    walk.step("Write frames…: folder, sensors, formats (OpenEXR, CSV, pictures, TIFF), and the "
              "command that does the same");
    std::string command;
    onDialog = [&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("folder")->setText(path("frames"));
        EXPECT_NE(dialog.findChild<QWidget*>("sensor-two"), nullptr);
        for (const irsg::ImageFormat* format : irsg::imageFormats()) {
            const auto* form = dialog.findChild<QCheckBox*>(
                QString::fromStdString("form" + format->extensionList().front()));
            ASSERT_NE(form, nullptr) << format->name;
            EXPECT_TRUE(form->text().contains(format->shortName)) << form->text().toStdString();
        }
        command = dialog.findChild<QLineEdit*>("commandLine")->text().toStdString();
    };
    get<QToolButton>("runScenario", shown)->click();
    onDialog = nullptr;
    ASSERT_TRUE(settled());
    const auto frame = [this](const char* sensor) {
        std::vector<std::string> files;
        for (const auto& one : std::filesystem::recursive_directory_iterator(folder / "frames")) {
            const std::string name = one.path().filename().string();
            if (one.path().string().find(sensor) != std::string::npos && name.ends_with(".exr") &&
                name.find("000002") != std::string::npos) {
                files.push_back(one.path().string());
            }
        }
        return files;
    };
    ASSERT_FALSE(frame("lwir").empty());
    const auto ofTile = irsg::readExr(frame("lwir").front());
    walk.step("edit it | Edit: choose the scenario, an entity or a sensor, and change its fields "
              "(below)");
    showPanel("Edit");
    for (const char* part : {"Scenario", "mover", "two (sensor)"}) {
        choosePart(part);
    }

    walk.step("Frames has a film strip, in which each frame shows its time, and the sensor's table "
              "as curves over time. Export film… writes the frames");
    showPanel("Frames");
    auto* strip = get<QListWidget>("filmStrip", shown);
    EXPECT_EQ(strip->count(), 12) << "of both bands";
    shown->showSensor(1);
    ASSERT_TRUE(settles());
    ASSERT_EQ(strip->count(), 5) << "of 6 steps: at the last what it looks at is gone";
    EXPECT_EQ(strip->item(3)->text(), "1.5 s");
    strip->setCurrentRow(3);
    ASSERT_TRUE(settles());
    EXPECT_EQ(line.step(), 3U);
    EXPECT_GE(shown->findChild<CartesianPlot*>()->data().curves.front().x.size(), 5U);
    auto* film = get<QToolButton>("exportFilm", shown);
    emit film->menu()->aboutToShow();
    chosen = path("film.png");
    film->menu()->findChild<QAction*>("filmPng")->trigger();
    ASSERT_TRUE(test::waitUntil([&] { return film->isEnabled(); }));
    EXPECT_TRUE(std::filesystem::exists(folder / "film-000004.png")) << said();

    walk.step("The sun's disc is rendered and scaling files beside the models are applied, unless "
              "the settings of the scenario say otherwise");
    EXPECT_EQ(shown->picture().settings.text("render.sunDisc"), "true");
    std::filesystem::rename(folder / "frames", folder / "of-window");
    terminal(command);
    EXPECT_EQ(irsg::readExr(frame("lwir").front()).primary(), ofTile.primary());
    EXPECT_TRUE(told.isEmpty()) << said();
}

TEST_F(ScenariosWalkTest, EditIt) {
    test::GuideWalk walk("scenarios", "Edit");
    test::keepClipboard();
    open();
    showPanel("Edit");
    walk.step("the scenario | Title, Start, End, Step and Notes; Settings… of all sensors");
    choosePart("Scenario");
    write(get<QLineEdit>("scenarioTitle", shown), "A longer pass");
    write(get<QLineEdit>("scenarioStart", shown), "0.5");
    write(get<QLineEdit>("scenarioEnd", shown), "3");
    write(get<QLineEdit>("scenarioStep", shown), "0.25");
    EXPECT_EQ(shown->timeLine().times_s().size(), 11U);
    EXPECT_TRUE(get<QPlainTextEdit>("scenarioText", shown)->isVisible());
    auto* settings = get<QToolButton>("scenarioSettings", shown);
    EXPECT_TRUE(settings->isEnabled());
    const auto setsField = [&](const QString& text) {
        onDialog = [&](QDialog& dialog) {
            auto* field = dialog.findChild<QLineEdit*>("sensor.fov");
            ASSERT_NE(field, nullptr);
            field->setText(text);
            emit field->textEdited(text);
            dialog.accept();
        };
        settings->click();
        onDialog = nullptr;
    };
    setsField("14");
    EXPECT_EQ(shown->document().scenario().settings.text("sensor.fov"), "14");

    walk.step(
        "a sensor | Fixed to: the ground, an entity or its trajectory; Looks at: an entity, or "
        "along its own nose; Settings… of its own");
    choosePart("two (sensor)");
    for (const char* words : {"Fixed to", "Looks at"}) {
        EXPECT_TRUE(says(words)) << words;
    }
    setsField("10");
    const auto two = [this]() -> const ScenarioSensor& {
        return shown->document().scenario().sensors[0];
    };
    EXPECT_EQ(two().settings.text("sensor.fov"), "10");
    auto* mount = get<QComboBox>("sensorMount", shown);
    auto* track = get<QComboBox>("sensorTrack", shown);
    EXPECT_GE(mount->count(), 3);
    track->setFocus();
    QTest::keyClick(track, Qt::Key_End); // the buoy
    EXPECT_EQ(two().track, "buoy");

    walk.step("the motion of either | New trajectory: one of its own, from where it is at the "
              "start, in a file beside the scenario; Trajectory file…: the rows of a file; Stand "
              "still: an entity stays where its trajectory begins");
    get<QToolButton>("newTrajectory", shown)->click();
    EXPECT_EQ(two().mount, MountKind::trajectory);
    EXPECT_EQ(two().trajectory, "two.csv");
    EXPECT_EQ(table().model()->rowCount(), 3) << "with the empty one";
    act("undo");
    choosePart("buoy");
    chosen = path("flight.csv");
    get<QToolButton>("trajectoryFile", shown)->click();
    EXPECT_EQ(shown->document().scenario().entities[1].trajectory, "flight.csv");
    get<QToolButton>("standStill", shown)->click();
    EXPECT_TRUE(shown->document().scenario().entities[1].trajectory.empty());
    act("undo");
    act("undo");

    walk.step("what moves | Name and a table of its trajectory: time, position, attitude and, "
              "where the file has them, power and Mach number; Stays at its ends holds it there");
    choosePart("mover");
    EXPECT_EQ(get<QLineEdit>("partName", shown)->text(), "mover");
    EXPECT_EQ(table().model()->columnCount(), 9);
    get<QCheckBox>("holdEnds", shown)->click();
    get<QSlider>("timeSlider", shown)->setValue(10);
    ASSERT_TRUE(settles());
    EXPECT_NE(cell(0, 1), "not there") << "at 3 s, a second after its last row";
    get<QCheckBox>("holdEnds", shown)->click();
    walk.step("what stands still or rides along | Name, position and attitude; a sensor that looks "
              "at an entity has no attitude of its own");
    choosePart("buoy");
    EXPECT_TRUE(get<QLineEdit>("place.yaw", shown)->isVisible());
    choosePart("lwir (sensor)");
    EXPECT_FALSE(get<QLineEdit>("place.yaw", shown)->isVisible());

    walk.step("Type into a cell, or into the empty row to add one; Insert puts a row between two, "
              "Delete removes the chosen ones.");
    choosePart("mover");
    typeCell(2, x, "16");
    EXPECT_EQ(tableCell(2, x), "16");
    typeCell(3, x, "20");
    ASSERT_EQ(table().model()->rowCount(), 5);
    clickCell(1, x);
    QTest::keyClick(&table(), Qt::Key_Insert);
    EXPECT_EQ(tableCell(1, time), "0.5");
    QTest::keyClick(&table(), Qt::Key_Delete);
    EXPECT_EQ(tableCell(1, time), "1");
    typeCell(0, time, "1.75");
    EXPECT_EQ(tableCell(1, time), "1.75") << "in the order of their times";
    QTest::keyClick(&table(), Qt::Key_Z, Qt::ControlModifier);
    clickCell(0, y);
    QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
    EXPECT_TRUE(QApplication::clipboard()->text().startsWith("100"));
    clickCell(1, time);
    QApplication::clipboard()->setText("1.5\t1\t100\r\n");
    QTest::keyClick(&table(), Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(tableCell(1, time), "1.5");
    get<QToolButton>("copyTable", shown)->click();
    const QString all = QApplication::clipboard()->text();
    EXPECT_EQ(all.count('\n'), 4);
    get<QToolButton>("pasteTable", shown)->click();
    EXPECT_EQ(table().model()->rowCount(), 5);
    clickCell(0, x);
    QTest::keyClicks(&table(), "f");
    QTest::keyClicks(get<QLineEdit>("trajectoryCell", &table()), "ar");
    EXPECT_TRUE(message().contains("“far”")) << message().toStdString();
    QTest::keyClick(get<QLineEdit>("trajectoryCell", &table()), Qt::Key_Escape);
    QTest::qWait(20);
    chosen = SMAT_SOURCE_DIR "/samples/sphere/sphere.flt";
    get<QToolButton>("addEntity", shown)->click();
    ASSERT_TRUE(settles());
    EXPECT_EQ(shown->document().scenario().entities.size(), 3U);
    get<QToolButton>("removeEntity", shown)->click();
    EXPECT_EQ(shown->document().scenario().entities.size(), 2U);
    choosePart("buoy");
    get<QToolButton>("removeEntity", shown)->click();
    EXPECT_TRUE(message().contains("two looks at it")) << message().toStdString();
    choosePart("lwir (sensor)");
    get<QToolButton>("addSensor", shown)->click();
    EXPECT_EQ(shown->document().scenario().sensors.back().name, "lwir-2");
    get<QToolButton>("removeEntity", shown)->click();
    EXPECT_EQ(shown->document().scenario().sensors.size(), 2U);

    walk.step("A sensor that is newly fixed to something else keeps its position at the start; one "
              "that no longer looks at an entity keeps its direction.");
    choosePart("two (sensor)");
    track->setFocus();
    QTest::keyClick(track, Qt::Key_Home);
    EXPECT_EQ(two().track, "");
    const irsg::Vec3 nose = two().offset.attitude.rotation() * irsg::Vec3{0, 1, 0};
    EXPECT_NEAR(irsg::length(nose - irsg::normalized(irsg::Vec3{4, 110, 0})), 0.0, 1e-9);
    mount->setFocus();
    QTest::keyClick(mount, Qt::Key_Home);
    QTest::keyClick(mount, Qt::Key_Down); // the mover, which is at (-3, 100) at the start, 0.5 s
    EXPECT_EQ(two().mount, MountKind::entity);
    EXPECT_NEAR(irsg::length(two().offset.position_m), irsg::length(irsg::Vec3{3, -100, 0}), 1.0);
    setsField("14"); // what would hold without it
    EXPECT_FALSE(two().settings.isSet("sensor.fov"));

    walk.step(
        "Every edit is a step of Undo and Redo and shows at once in picture, plan and line of "
        "time. Save writes the scenario and the trajectories");
    const int steps = workbench.undoStack().index();
    EXPECT_GT(steps, 8);
    act("undo");
    act("redo");
    EXPECT_EQ(workbench.undoStack().index(), steps);
    chosen = path("other.json");
    act("saveProjectAs");
    EXPECT_TRUE(std::filesystem::exists(folder / "other.json")) << said();
    act("saveProject");
    EXPECT_FALSE(shown->document().isModified());

    walk.step("Pictures and frames equal those of smat-batch simulate, to the last bit, once the "
              "edits are saved");
    terminal("smat-batch simulate other.json --out out");
    shown->showSensor(1);
    shown->timeLine().setStep(2);
    ASSERT_TRUE(settles());
    EXPECT_EQ(irsg::readExr(folder / "out/lwir/frame_000002.exr").primary(),
              shown->picture().image->primary());
    EXPECT_TRUE(told.isEmpty()) << said();
}

} // namespace
} // namespace smat::gui

#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "gui/project/ProjectFiles.h"
#include "gui/project/SceneTreeDock.h"
#include "gui/view/PlaceHandles.h"
#include "irsg/radiometry/Units.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

class SceneWalkTest : public test::GuideFixture {
  protected:
    void addModel(const char* name) {
        for (const char* ending : {".flt", ".sigdb"}) {
            std::filesystem::copy_file(std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name /
                                           (std::string(name) + ending),
                                       folder / (std::string(name) + ending),
                                       std::filesystem::copy_options::overwrite_existing);
        }
        const std::size_t before = workbench.project().models.size();
        chosen = path((std::string(name) + ".flt").c_str());
        act("addModel");
        ASSERT_TRUE(test::waitUntil([&] {
            return workbench.project().models.size() == before + 1 && !window->isLoadingModel();
        })) << said();
        ASSERT_TRUE(test::waitUntil([this] { return !window->tree().isLoading(); }));
    }
    QTreeWidgetItem* itemOf(const QString& text) {
        for (QTreeWidgetItemIterator it(get<QTreeWidget>("sceneTree")); *it; ++it) {
            if ((*it)->text(0) == text) {
                return *it;
            }
        }
        return nullptr;
    }
    QLineEdit* field(const char* name) { return get<QLineEdit>(QString("model.") + name); }
    const ProjectModel& model(std::size_t number) { return workbench.project().models.at(number); }
    double asked(const char* column) {
        return workbench.results().back().data->table.find(column)->values.front();
    }
};

TEST_F(SceneWalkTest, AddChooseAndPlace) {
    test::GuideWalk walk("scene", "");
    openSample();
    walk.step("The first is the target: it stands at the origin, the camera turns around it, and "
              "the settings Altitude, Yaw, Pitch and Roll place it.");
    addModel("box");
    addModel("sphere");
    EXPECT_EQ(window->sceneView()->scene().models.size(), 3U);
    EXPECT_EQ(window->sceneView()->scene().models[0].pose.position_m, irsg::Vec3(0, 0, 100));
    workbench.set("target.altitude", "120");
    EXPECT_EQ(window->sceneView()->scene().models[0].pose.position_m, irsg::Vec3(0, 0, 120));
    runAnalysis("range");
    for (const char* column : {"box.intensity", "sphere.intensity"}) {
        EXPECT_NE(workbench.results().back().data->table.find(column), nullptr) << column;
    }
}

TEST_F(SceneWalkTest, AddChooseRemove) {
    test::GuideWalk walk("scene", "Add, choose, remove");
    openSample();
    walk.step("(Ctrl+Shift+L), or the menu of the tree's right button, asks for a file. The model "
              "stands clear of the others, as high as the target, with the signature database that "
              "lies beside its file.");
    EXPECT_EQ(get<QAction>("addModel")->shortcut(), QKeySequence("Ctrl+Shift+L"));
    EXPECT_TRUE(get<QTreeWidget>("sceneTree")->contextMenuPolicy() != Qt::NoContextMenu);
    addModel("box");
    EXPECT_GT(irsg::length(model(1).pose.position_m - irsg::Vec3{0, 0, 100}), 30.0);
    EXPECT_EQ(model(1).pose.position_m.z, 100.0);
    EXPECT_EQ(model(1).database, folder / "box.sigdb");
    addModel("sphere");

    walk.step("One model is the chosen one: its name is bold in the scene tree");
    get<QTreeWidget>("sceneTree")->setCurrentItem(itemOf("box"));
    EXPECT_EQ(workbench.chosenModel(), 1U);
    EXPECT_TRUE(itemOf("box")->font(0).bold());
    EXPECT_EQ(get<QComboBox>("chosenModel")->currentText(), "box");
    EXPECT_TRUE(get<QLabel>("databaseTitle")->text().contains("box.sigdb"));
    EXPECT_EQ(window->sceneView()->handles().name, "box");
    choose(get<QComboBox>("chosenModel"), 2);
    EXPECT_EQ(workbench.chosenModel(), 2U);
    workbench.set("camera.range", "300");
    workbench.set("camera.elevation", "35");
    workbench.set("sensor.fov", "40");
    act("placeHandles");
    QTest::qWait(50);
    const auto& box = window->sceneView()->scene().models.at(1);
    const QPoint at =
        window->sceneView()->projection().toWindow(box.pose.toWorld(box.centre_m)).toPoint();
    QTest::mouseClick(window->sceneView(), Qt::LeftButton, {}, at);
    EXPECT_EQ(workbench.chosenModel(), 1U);

    walk.step("Edit → Rename the chosen model (or F2 in the tree) gives it another name, which "
              "results use. Edit → Remove the chosen model from the scene takes it out, Edit → "
              "Make the chosen model the target lets the camera turn around it");
    auto* tree = get<QTreeWidget>("sceneTree");
    act("renameModel");
    QLineEdit* editor = nullptr;
    ASSERT_TRUE(test::waitUntil([&] {
        editor = tree->viewport()->findChild<QLineEdit*>();
        return editor != nullptr && editor->text() == "box";
    }));
    editor->selectAll();
    QTest::keyClicks(editor, "crate");
    QTest::keyClick(editor, Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([&] { return model(1).name == "crate"; }));
    runAnalysis("range");
    EXPECT_NE(workbench.results().back().data->table.find("crate.intensity"), nullptr);
    const Project before = workbench.editedProject();
    act("removeModel");
    EXPECT_EQ(workbench.project().models.size(), 2U);
    ASSERT_TRUE(waitForModel());
    act("undo");
    ASSERT_TRUE(waitForModel());
    EXPECT_EQ(workbench.editedProject(), before);
    workbench.chooseModel(1);
    const auto apart = [&](std::size_t a, std::size_t b) {
        EXPECT_TRUE(waitForModel());
        const auto& models = window->sceneView()->scene().models;
        return irsg::length(models.at(a).pose.position_m - models.at(b).pose.position_m);
    };
    const double between = apart(0, 1);
    act("makeTarget");
    EXPECT_EQ(model(0).shownName(), "crate");
    EXPECT_NEAR(apart(0, 1), between, 1e-6) << "nothing moves";
    act("undo");
    EXPECT_EQ(workbench.editedProject(), before);
    EXPECT_TRUE(told.isEmpty()) << said();
}

TEST_F(SceneWalkTest, Place) {
    test::GuideWalk walk("scene", "Place");
    openSample();
    addModel("box");
    const auto pose = [this] { return model(1).pose; };
    walk.step("East, North | where its origin stands from that of the target, m");
    write(field("east"), "320.5");
    write(field("north"), "-40");
    EXPECT_EQ(pose().position_m.x, 320.5);
    EXPECT_EQ(pose().position_m.y, -40.0);
    walk.step("Altitude | above the ground, m; it sets the ambient atmosphere of the model");
    write(field("altitude"), "250");
    EXPECT_EQ(pose().position_m.z, 250.0);
    walk.step("Heading | where the nose points, clockwise from north");
    write(field("heading"), "90");
    const irsg::Vec3 nose = pose().attitude.rotation() * irsg::Vec3{0, 1, 0};
    EXPECT_NEAR(nose.x, 1.0, 1e-9) << "east";
    walk.step("Pitch, Roll | nose up, starboard down");
    write(field("pitch"), "10");
    EXPECT_GT((pose().attitude.rotation() * irsg::Vec3{0, 1, 0}).z, 0.1);
    write(field("pitch"), "0");
    write(field("roll"), "20");
    EXPECT_LT((pose().attitude.rotation() * irsg::Vec3{1, 0, 0}).z, -0.1);

    walk.step("In the view the chosen model has handles while View → Handles to place a model "
              "(Ctrl+Shift+H) is on, which is the default with several models");
    SceneView* view = window->sceneView();
    EXPECT_TRUE(get<QAction>("placeHandles")->isChecked());
    EXPECT_EQ(get<QAction>("placeHandles")->shortcut(), QKeySequence("Ctrl+Shift+H"));
    workbench.set("camera.range", "1500");
    workbench.set("camera.elevation", "35");
    workbench.set("sensor.fov", "40");
    QTest::qWait(50);
    const PlaceHandles handles = view->handles();
    const QPolygonF line = handles.line(PlaceHandle::east, view->projection());
    ASSERT_EQ(line.size(), 2);
    const QPointF tip = line[0] + 0.9 * (line[1] - line[0]);
    QTest::mouseMove(view, tip.toPoint());
    QTest::qWait(20);
    const int steps = workbench.undoStack().index();
    const double east = pose().position_m.x;
    drag(view, Qt::LeftButton, tip.toPoint(), (line[1] - line[0]) * 0.5);
    EXPECT_GT(pose().position_m.x, east);
    EXPECT_EQ(workbench.undoStack().index(), steps + 1) << "a drag is one step";
    act("undo");
    EXPECT_EQ(pose().position_m.x, east);
    const Project whole = workbench.editedProject();
    drag(view, Qt::LeftButton, {30, 300}, {50, 20});
    EXPECT_EQ(workbench.editedProject(), whole) << "beside them one looks around";
    workbench.chooseModel(0);
    QTest::qWait(20);
    EXPECT_TRUE(view->handles().line(PlaceHandle::east, view->projection()).isEmpty());
    EXPECT_FALSE(view->handles().line(PlaceHandle::altitude, view->projection()).isEmpty());
    EXPECT_FALSE(view->handles().line(PlaceHandle::heading, view->projection()).isEmpty());
}

TEST_F(SceneWalkTest, StateDatabaseAndWhatComesOut) {
    {
        test::GuideWalk walk("scene", "Its own state");
        openSample();
        addModel("sphere");
        walk.step("Engine power and Mach number of a model beside the target are empty at first");
        for (const char* name : {"power", "mach"}) {
            EXPECT_TRUE(field(name)->text().isEmpty()) << name;
        }
        write(field("power"), "0.25");
        write(field("timeOffset"), "3");
        EXPECT_EQ(model(1).own.power, 0.25);
        EXPECT_EQ(model(1).own.mach, std::nullopt) << "as the target";
        EXPECT_EQ(model(1).own.timeOffset_s, 3.0);
    }
    {
        test::GuideWalk walk("scene", "Its own database");
        walk.step("The panel Database shows the database of the chosen model");
        const auto title = [this] { return get<QLabel>("databaseTitle")->text(); };
        EXPECT_EQ(title(), "sphere.sigdb of sphere");
        const auto warm = [this](double by_K) {
            session().edit("Warm it", [by_K](irsg::SignatureDatabase& database) {
                database.temperatures.begin()->second.terms.base_K += by_K;
            });
        };
        runAnalysis("range");
        const double before = asked("intensity");
        warm(30.0);
        workbench.chooseModel(0);
        EXPECT_TRUE(title().startsWith("ship.sigdb"));
        EXPECT_EQ(workbench.editedDatabases().size(), 1U) << "open, though another one is shown";
        runAnalysis("range");
        EXPECT_GT(asked("intensity"), before) << "edits of all count";
        workbench.chooseModel(1);
        act("saveDatabase");
        EXPECT_TRUE(workbench.editedDatabases().empty());
        warm(1.0);
        accept = false;
        int questions = 0;
        onDialog = [&](QDialog&) { ++questions; };
        EXPECT_FALSE(window->files().settle());
        EXPECT_EQ(questions, 1);
        accept = true;
        onDialog = nullptr;
        session().discard();
    }
    test::GuideWalk walk("scene", "What comes out");
    walk.step("Sums are over all objects. With several, tables have columns for each as well");
    const ResultTable& table = workbench.results().back().data->table;
    for (const char* column : {"sphere.contrast_intensity", "sphere.range"}) {
        EXPECT_NE(table.find(column), nullptr) << column;
    }
    // In vacuum, where the ship stands not before it: what both give is the sum.
    EXPECT_NEAR(asked("ship.intensity") + asked("sphere.intensity"), asked("intensity"),
                1e-6 * asked("intensity"));

    for (const auto& [from, to] : {std::pair{"ship/ship.flt", "ship.flt"},
                                   {"ship/ship.sigdb", "ship.sigdb"},
                                   {"box/box.flt", "boat.flt"},
                                   {"box/box.sigdb", "boat.sigdb"}}) {
        std::filesystem::copy_file(std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / from,
                                   folder / to, std::filesystem::copy_options::overwrite_existing);
    }
    walk.note("In a terminal:");
    const char* lines[] = {
        "smat-batch project new fleet.smat ship.flt --altitude 0",
        "smat-batch project add fleet.smat boat.flt --name escort --east 300 --heading 90 --power "
        "0.4",
        "smat-batch range fleet.smat --set models.escort.power=0.9 --out range.csv",
        "smat-batch project info fleet.smat"};
    std::string out;
    for (const char* line : lines) {
        walk.step(line);
        const std::string quicker = std::string(line).find(" range ") == std::string::npos
                                        ? ""
                                        : " --points 3 --bounces 0 --width 32 --height 24";
        out = terminal(line + quicker).out;
    }
    EXPECT_NE(out.find("escort"), std::string::npos) << out;
    const ResultTable fleet = ResultTable::load(folder / "range.csv");
    EXPECT_NE(fleet.find("escort.contrast_intensity"), nullptr);
    EXPECT_NE(fleet.find("escort.range"), nullptr);
    walk.note("How a project file stores it: format.");
    EXPECT_TRUE(told.isEmpty()) << said();
}

} // namespace
} // namespace smat::gui

// A scene of three models made in the window: added, placed by numbers and by handles, each with a
// state and a database of its own; every act a step; saved, opened again, equal; and of each model
// what it gives alone, in the window and by smat-batch.
#include <cmath>
#include <sstream>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>

#include "gui/ManipulatorsDock.h"
#include "gui/database/DatabaseDock.h"
#include "gui/project/ProjectFiles.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/project/ModelFields.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/project/SceneModels.h"
#include "tests/cli/Program.h"
#include "tests/gui/SeveralModelsFixture.h"

namespace smat::gui {
namespace {

class SeveralModelsTest : public test::SeveralModelsFixture {};

TEST_F(SeveralModelsTest, ComeAndGoAsSteps) {
    openSample();
    ASSERT_TRUE(waitForTree());
    EXPECT_FALSE(window->findChild<QComboBox*>("chosenModel")->isVisible());
    EXPECT_FALSE(view()->hasHandles());
    EXPECT_FALSE(window->findChild<QAction*>("removeModel")->isEnabled());
    addModel(copyOf("box/box.flt", "box/box.sigdb"));
    EXPECT_EQ(next(), "Add model box");
    EXPECT_EQ(workbench.chosenModel(), 1U);
    EXPECT_TRUE(view()->hasHandles());
    EXPECT_EQ(model(1).database, folder / "box.sigdb");
    EXPECT_GT(model(1).pose.position_m.x, 30.0) << "beside the ship";
    EXPECT_EQ(model(1).pose.position_m.z, 100.0) << "as high as the ship";
    EXPECT_EQ(view()->scene().models.size(), 2U);
    ASSERT_NE(itemOf("box"), nullptr);
    addModel(sampleFile("box/box.flt"));
    EXPECT_EQ(model(2).shownName(), "box-2");
    const Project three = workbench.editedProject();

    // The tree says which one is meant, and so do the list and the view.
    window->findChild<QTreeWidget*>("sceneTree")->setCurrentItem(itemOf("box"));
    EXPECT_EQ(workbench.chosenModel(), 1U);
    EXPECT_EQ(window->findChild<QComboBox*>("chosenModel")->currentText(), "box");
    EXPECT_EQ(view()->handles().name, "box");
    EXPECT_TRUE(itemOf("box")->font(0).bold());
    auto* list = window->findChild<QComboBox*>("chosenModel");
    list->setCurrentIndex(0);
    emit list->activated(0);
    EXPECT_EQ(workbench.chosenModel(), 0U);
    EXPECT_FALSE(field("east")->isVisible());

    workbench.chooseModel(1);
    trigger("removeModel");
    EXPECT_EQ(next(), "Remove model box");
    EXPECT_EQ(workbench.project().models.size(), 2U);
    trigger("undo");
    EXPECT_EQ(workbench.editedProject(), three);
    workbench.chooseModel(2);
    trigger("makeTarget");
    EXPECT_EQ(next(), "Make box-2 the target");
    EXPECT_EQ(model(0).shownName(), "box-2");
    EXPECT_EQ(workbench.chosenModel(), 0U);
    trigger("undo");
    EXPECT_EQ(workbench.editedProject(), three);
    workbench.chooseModel(0);
    trigger("removeModel"); // the target: the next takes its place
    EXPECT_EQ(model(0).shownName(), "box");
    trigger("undo");
    EXPECT_EQ(workbench.editedProject(), three);
    trigger("undo");
    trigger("undo");
    EXPECT_EQ(workbench.project().models.size(), 1U);
    ASSERT_TRUE(waitForModel());
    EXPECT_FALSE(view()->hasHandles()) << "one model is as it always was";
    trigger("redo");
    trigger("redo");
    EXPECT_EQ(workbench.editedProject(), three);
    ASSERT_TRUE(waitForModel());

    // A file that is no model changes nothing.
    smat::test::write(folder / "broken.flt", "nothing");
    chosen = QString::fromStdString((folder / "broken.flt").string());
    trigger("addModel");
    ASSERT_TRUE(test::waitUntil([&] { return !told.isEmpty(); }));
    EXPECT_EQ(workbench.editedProject(), three);
}

TEST_F(SeveralModelsTest, AreRenamedInTheTree) {
    openThree();
    workbench.chooseModel(1);
    trigger("renameModel");
    QLineEdit* editor = nullptr;
    ASSERT_TRUE(test::waitUntil(
        [&] {
            editor =
                window->findChild<QTreeWidget*>("sceneTree")->viewport()->findChild<QLineEdit*>();
            return editor != nullptr && editor->text() == "box";
        },
        10.0));
    editor->selectAll();
    QTest::keyClicks(editor, "crate");
    QTest::keyClick(editor, Qt::Key_Return);
    ASSERT_TRUE(test::waitUntil([&] { return model(1).name == "crate"; }));
    EXPECT_EQ(next(), "Rename box to crate");
    EXPECT_NE(itemOf("crate"), nullptr);
    trigger("undo");
    EXPECT_EQ(model(1).shownName(), "box");
    EXPECT_NE(itemOf("box"), nullptr);
}

TEST_F(SeveralModelsTest, EachHasItsDatabaseInTheEditor) {
    openThree();
    auto& session = workbench.database();
    const auto rename = [&](const char* name) {
        session.edit(QString("Call it ") + name, [&](irsg::SignatureDatabase& database) {
            database.materials.begin()->second.name = name;
        });
    };
    const auto title = [&] { return window->findChild<QLabel*>("databaseTitle")->text(); };
    workbench.chooseModel(1);
    EXPECT_EQ(title(), "box.sigdb of box");
    rename("tin");
    EXPECT_EQ(title(), "box.sigdb * of box");
    workbench.chooseModel(2);
    EXPECT_EQ(title(), "sphere.sigdb of sphere");
    rename("lead");
    workbench.chooseModel(0);
    EXPECT_EQ(title(), "ship.sigdb of ship");
    // Edits of both take part in view and analyses, whichever is shown.
    const auto edited = workbench.editedDatabases();
    ASSERT_EQ(edited.size(), 2U);
    EXPECT_EQ(edited.at(folder / "box.sigdb")->materials.begin()->second.name, "tin");
    EXPECT_EQ(edited.at(folder / "sphere.sigdb")->materials.begin()->second.name, "lead");
    EXPECT_EQ(view()->scene().models[1].signature->materials.begin()->second.name, "tin");
    ASSERT_TRUE(waitForTree());
    EXPECT_EQ(window->tree().index()[1].materials.begin()->second.name, "tin");
    EXPECT_TRUE(std::filesystem::exists(folder / "box.sigdb.recovery")) << "kept for a crash";

    // A step of one that is not shown brings it to sight.
    EXPECT_EQ(next(), "Call it lead");
    trigger("undo");
    EXPECT_EQ(workbench.chosenModel(), 2U);
    EXPECT_NE(session.value().materials.begin()->second.name, "lead");
    EXPECT_EQ(next(), "Call it tin");
    trigger("undo");
    EXPECT_EQ(workbench.chosenModel(), 1U);
    EXPECT_TRUE(workbench.editedDatabases().empty());
    trigger("redo");
    trigger("redo");
    EXPECT_EQ(workbench.chosenModel(), 2U);
    EXPECT_EQ(session.value().materials.begin()->second.name, "lead");

    // What is saved is that of the model that is shown; its steps outlive another one's sight.
    trigger("saveDatabase");
    EXPECT_EQ(
        irsg::loadSignatureFile(folder / "sphere.sigdb").database.materials.begin()->second.name,
        "lead");
    EXPECT_NE(irsg::loadSignatureFile(folder / "box.sigdb").database.materials.begin()->second.name,
              "tin");
    workbench.chooseModel(1);
    trigger("undo");
    EXPECT_EQ(workbench.chosenModel(), 2U);
    EXPECT_NE(session.value().materials.begin()->second.name, "lead");
    // Who leaves is asked about each of them.
    QStringList questions;
    onDialog = [&](QDialog& dialog) {
        for (const auto* label : dialog.findChildren<QLabel*>()) {
            if (label->text().contains(".sigdb")) {
                questions << label->text();
            }
        }
    };
    accept = false;
    EXPECT_FALSE(window->files().settle());
    ASSERT_EQ(questions.size(), 1) << "cancelled at the first";
    EXPECT_TRUE(questions[0].contains("sphere.sigdb"));
    session.discard();
    EXPECT_FALSE(window->files().settle());
    EXPECT_TRUE(questions.back().contains("box.sigdb"));
    session.discard();
}

TEST_F(SeveralModelsTest, AreSavedAndOpenedAgainAndEqualTheirRunsAlone) {
    openThree();
    // Far enough to be points, so that where an object lies among the pixels does not count.
    for (const auto& [key, text] :
         std::initializer_list<std::pair<const char*, const char*>>{{"sensor.fov", "40"},
                                                                    {"sensor.width", "32"},
                                                                    {"sensor.height", "32"},
                                                                    {"camera.range", "300000"},
                                                                    {"camera.azimuth", "50"},
                                                                    {"camera.elevation", "10"},
                                                                    {"render.antialiasing", "4"},
                                                                    {"time.to", "10"},
                                                                    {"time.step", "10"},
                                                                    {"state.power", "0.6"},
                                                                    {"target.yaw", "-20"},
                                                                    {"target.altitude", "0"}}) {
        workbench.set(key, text);
    }
    Project placed = workbench.project();
    for (ProjectModel& one : placed.models) {
        one.referencePoint_m = irsg::Vec3{0, 0, 0};
    }
    workbench.edit(placed, "Reference points");
    workbench.chooseModel(1);
    for (const auto& [name, text] :
         std::initializer_list<std::pair<const char*, const char*>>{{"east", "9000"},
                                                                    {"north", "-4000"},
                                                                    {"altitude", "2500"},
                                                                    {"heading", "75"},
                                                                    {"pitch", "10"},
                                                                    {"roll", "-20"},
                                                                    {"power", "0.25"},
                                                                    {"timeOffset", "12"}}) {
        type(name, text);
    }
    workbench.chooseModel(2);
    for (const auto& [name, text] : std::initializer_list<std::pair<const char*, const char*>>{
             {"east", "-7000"}, {"north", "6000"}, {"altitude", "8000"}, {"mach", "0.9"}}) {
        type(name, text);
    }
    const Project edited = workbench.editedProject();
    workbench.saveAs(folder / "three.smat");
    ASSERT_TRUE(opens(folder / "three.smat"));
    Project opened = workbench.editedProject(), wanted = edited;
    for (Project* one : {&opened, &wanted}) {
        for (ProjectModel& each : one->models) {
            each.file = one->resolve(each.file);
            each.database = one->resolve(each.database);
        }
        one->file.clear();
    }
    EXPECT_EQ(projectToJson(opened, folder / "x.smat"), projectToJson(wanted, folder / "x.smat"));
    EXPECT_EQ(opened.models, wanted.models);

    // By window and by command line the same bytes.
    runAnalysis("time");
    const AnalysisData all = *workbench.results().back().data;
    saveResult(all, folder / "time.csv");
    std::istringstream words(all.commandLine);
    std::vector<std::string> arguments;
    for (std::string word; words >> word;) {
        arguments.push_back(word);
    }
    arguments.erase(arguments.begin());
    std::filesystem::create_directories(folder / "batch");
    const auto ran = smat::test::smatBatch(arguments, folder / "batch");
    EXPECT_EQ(ran.exitCode, 0) << all.commandLine << "\n" << ran.err;
    EXPECT_EQ(smat::test::contentOf(folder / "time.csv"),
              smat::test::contentOf(folder / "batch/time.csv"));

    const Project three = workbench.editedProject();
    const irsg::Pose ship = targetPoseOf(three.settings);
    const irsg::Vec3 camera = irsg::Viewpoint::about(ship.position_m, ship.attitude.yaw_rad,
                                                     irsg::radians(50), irsg::radians(10), 300000)
                                  .position_m;
    for (std::size_t i = 0; i < 3; ++i) {
        const irsg::Pose pose = poseOf(three, three.settings, i);
        const irsg::Vec3 way = camera - pose.position_m;
        const double range_m = irsg::length(way);
        Project alone = three;
        makeTarget(alone, i);
        alone.models.resize(1);
        AnalysisData data = AnalysisData::of(alone, AnalysisKind::time);
        data.settings.set("camera.range", range_m);
        data.settings.set("camera.azimuth",
                          irsg::degrees(std::atan2(way.x, way.y) + pose.attitude.yaw_rad));
        data.settings.set("camera.elevation", irsg::degrees(std::asin(way.z / range_m)));
        data.settings.set("time.from", three.models[i].own.timeOffset_s);
        data.settings.set("time.to", three.models[i].own.timeOffset_s + 10.0);
        data = runDirectly(data);
        for (const std::string key : {"intensity", "contrast_intensity", "irradiance"}) {
            const ResultColumn* mine = all.table.find(three.models[i].shownName() + "." + key);
            const ResultColumn* own = data.table.find(key);
            ASSERT_TRUE(mine != nullptr && own != nullptr) << key;
            ASSERT_EQ(mine->values.size(), 2U);
            EXPECT_NE(own->values[0], 0.0);
            // Irradiance is that of pixels, whose tilt goes with their place in the frame.
            const double bound = key == "irradiance" ? 2e-3 : 1e-6;
            for (std::size_t at = 0; at < 2; ++at) {
                EXPECT_NEAR(mine->values[at], own->values[at], bound * std::abs(own->values[at]))
                    << three.models[i].shownName() << key;
            }
        }
    }
}

TEST_F(SeveralModelsTest, AreAllInTheInfraredView) {
    openThree();
    workbench.set("camera.range", "400");
    workbench.set("camera.elevation", "20");
    workbench.set("sensor.fov", "30");
    trigger("infraredDisplay");
    ASSERT_TRUE(waitForPicture());
    const auto brightest = [&](std::size_t number) {
        const auto& plane = view()->shownPicture()->plane();
        const auto& image = *view()->shownPicture()->image;
        const auto& shown = view()->scene().models.at(number);
        const QPointF at = view()->projection().toWindow(shown.pose.toWorld(shown.centre_m)) *
                           (static_cast<double>(image.width()) / view()->width());
        float most = 0.0F;
        for (int y = -4; y <= 4; ++y) {
            for (int x = -4; x <= 4; ++x) {
                most = std::max(most, plane.values[image.offset(static_cast<int>(at.x()) + x,
                                                                static_cast<int>(at.y()) + y)]);
            }
        }
        return most;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GT(brightest(i), 0.1F) << model(i).shownName();
    }
    test::keepScreenshot(*window, "scene-infrared");
    // One that is moved is seen where it is now.
    workbench.chooseModel(2);
    const float here = brightest(2);
    const auto revision = view()->shownPicture()->revision;
    type("altitude", "130");
    ASSERT_TRUE(test::waitUntil([&] {
        const auto* picture = view()->shownPicture();
        return picture != nullptr && picture->revision != revision && !picture->coarse &&
               view()->isUpToDate();
    }));
    EXPECT_NEAR(brightest(2), here, 0.05F * here);
}

} // namespace
} // namespace smat::gui

#include <QCheckBox>
#include <QDockWidget>
#include <QPlainTextEdit>
#include <QStatusBar>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QUndoView>

#include "gui/project/SceneTreeDock.h"
#include "gui/start/GuidePage.h"
#include "gui/tools/SelfTestDialog.h"
#include "gui/view/ModelPage.h"
#include "irsg/image/ExrFile.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/settings/SettingInfo.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

class WindowWalkTest : public test::GuideFixture {
  protected:
    SceneView& view() { return *window->sceneView(); }
    bool isUntouched() { return !workbench.isModified() && workbench.undoStack().count() == 0; }
    QPointF middle() { return QPointF(view().rect().center()); }
    bool waitForPicture() {
        return test::waitUntil(
            [this] {
                const auto* picture = view().shownPicture();
                return picture != nullptr && !picture->coarse && view().isUpToDate();
            },
            20.0);
    }
    QTreeWidgetItem* itemOf(const QString& text) {
        for (QTreeWidgetItemIterator it(get<QTreeWidget>("sceneTree")); *it; ++it) {
            if ((*it)->text(0) == text) {
                return *it;
            }
        }
        return nullptr;
    }
    int docksInSight() {
        int count = 0;
        for (const auto* one : window->findChildren<QDockWidget*>()) {
            count += one->isHidden() ? 0 : 1;
        }
        return count;
    }
};

TEST_F(WindowWalkTest, StartPageAndDocks) {
    test::GuideWalk walk("window", "");
    walk.step("While nothing is open, the start page offers samples, recent files and a start with "
              "a model of your own. A click on a sample and one on Infrared show the first "
              "infrared picture. The samples are under File → Samples, too, this guide under Help "
              "→ User guide (Shift+F1). Samples are never overwritten");
    get<QToolButton>("sample-sphere")->click();
    ASSERT_TRUE(waitForModel());
    get<QToolButton>("showInfrared")->click();
    EXPECT_TRUE(waitForPicture()) << "two actions";
    chosen = path("own.smat");
    workbench.set("camera.azimuth", "7");
    const auto sample = std::filesystem::path(SMAT_SOURCE_DIR) / "samples/sphere/sphere.smat";
    const std::string before = smat::test::contentOf(sample);
    trigger("saveProject"); // asks for another place
    EXPECT_EQ(smat::test::contentOf(sample), before);
    EXPECT_TRUE(std::filesystem::exists(folder / "own.smat")) << said();
    EXPECT_EQ(get<QAction>("openGuide")->shortcut(), QKeySequence("Shift+F1"));
    act("openGuide");
    ASSERT_NE(window->findChild<GuidePage*>(), nullptr);
    EXPECT_TRUE(window->findChild<GuidePage*>()->toPlainText().contains("Your first signature"));

    walk.step("Docks around it can be moved, floated and hidden (View menu); F6 hides them all and "
              "shows them again.");
    const int docks = docksInSight();
    EXPECT_GE(docks, 3);
    EXPECT_EQ(get<QAction>("collapseDocks")->shortcut(), QKeySequence(Qt::Key_F6));
    act("collapseDocks");
    EXPECT_EQ(docksInSight(), 0);
    act("collapseDocks");
    EXPECT_EQ(docksInSight(), docks);
    for (const auto* one : window->findChildren<QDockWidget*>()) {
        EXPECT_TRUE(one->features().testFlag(QDockWidget::DockWidgetMovable) &&
                    one->features().testFlag(QDockWidget::DockWidgetFloatable) &&
                    one->features().testFlag(QDockWidget::DockWidgetClosable))
            << one->objectName().toStdString();
    }
}

TEST_F(WindowWalkTest, Messages) {
    test::GuideWalk walk("window", "Messages");
    walk.step("The status line shows the newest warning or remark, and the panel Messages (View "
              "menu, or the number at the right of the status line) keeps all of the session");
    openSample();
    workbench.set("sensor.fov", "1");
    runAnalysis("range");
    auto* list = get<QTreeWidget>("messages");
    ASSERT_GE(list->topLevelItemCount(), 1);
    QTreeWidgetItem* last = list->topLevelItem(list->topLevelItemCount() - 1);
    EXPECT_TRUE(window->statusBar()->currentMessage().contains(last->text(2)));
    EXPECT_FALSE(get<QDockWidget>("messagesDock")->isVisible());
    get<QToolButton>("messageCount")->click();
    EXPECT_TRUE(get<QDockWidget>("messagesDock")->isVisible());
    tabs()->setCurrentIndex(0);
    list->setFocus();
    list->setCurrentItem(last);
    QTest::keyClick(list, Qt::Key_Return);
    EXPECT_NE(window->currentPage(), nullptr);
    get<QToolButton>("clearMessages")->click();
    EXPECT_EQ(list->topLevelItemCount(), 0);

    walk.step("The panel History lists the steps that Undo takes back, by their names. A click on "
              "one goes to the state behind it, back or forth.");
    workbench.set("camera.azimuth", "11");
    workbench.set("sensor.band", "8-12");
    get<QDockWidget>("historyDock")->toggleViewAction()->trigger();
    EXPECT_TRUE(get<QDockWidget>("historyDock")->isVisible());
    auto* history = get<QUndoView>("undoHistory");
    const int steps = workbench.undoStack().count();
    EXPECT_EQ(history->model()->rowCount(), steps + 1);
    EXPECT_EQ(history->model()->index(0, 0).data().toString(), "As it was opened");
    const auto click = [&](int row) {
        QTest::mouseClick(history->viewport(), Qt::LeftButton, {},
                          history->visualRect(history->model()->index(row, 0)).center());
    };
    click(0);
    EXPECT_EQ(workbench.undoStack().index(), 0);
    EXPECT_NE(workbench.settings().text("sensor.band"), "8-12");
    click(steps);
    EXPECT_EQ(workbench.settings().text("sensor.band"), "8-12");
}

TEST_F(WindowWalkTest, TheView) {
    test::GuideWalk walk("window", "The view");
    openSample();
    const OrbitCamera sensor = workbench.camera();
    walk.step("look around | drag with the left button; arrows, with Shift in steps of a degree");
    drag(&view(), Qt::LeftButton, middle(), {80, 30});
    EXPECT_NE(view().camera().azimuth_deg, sensor.azimuth_deg);
    view().setFocus();
    const double azimuth_deg = view().camera().azimuth_deg;
    QTest::keyClick(&view(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_NEAR(std::abs(std::remainder(view().camera().azimuth_deg - azimuth_deg, 360.0)), 1.0,
                1e-9);
    QTest::keyClick(&view(), Qt::Key_Left);
    EXPECT_GT(std::abs(std::remainder(view().camera().azimuth_deg - azimuth_deg, 360.0)), 1.5);
    walk.step("shift | drag with the right button, or with Shift");
    drag(&view(), Qt::RightButton, middle(), {40, 10});
    const irsg::Vec3 shifted = view().camera().offset_m;
    EXPECT_NE(shifted, irsg::Vec3{});
    drag(&view(), Qt::LeftButton, middle(), {40, 10}, Qt::ShiftModifier);
    EXPECT_NE(view().camera().offset_m, shifted);
    walk.step("come nearer | wheel, Page up and Page down");
    const double range_m = view().camera().range_m;
    wheel(&view(), middle(), 2);
    EXPECT_LT(view().camera().range_m, range_m);
    const double near_m = view().camera().range_m;
    QTest::keyClick(&view(), Qt::Key_PageDown);
    EXPECT_GT(view().camera().range_m, near_m);
    QTest::keyClick(&view(), Qt::Key_PageUp);
    EXPECT_NEAR(view().camera().range_m, near_m, 1e-6);
    walk.step(
        "see all of the model, or of several | double click, Home, View → Fit the scene in the "
        "view (Alt+0)");
    QTest::mouseDClick(&view(), Qt::LeftButton, {}, middle().toPoint());
    EXPECT_EQ(view().camera().offset_m, irsg::Vec3{});
    const double fitted_m = view().camera().range_m;
    for (const bool byKey : {true, false}) {
        wheel(&view(), middle(), 3);
        byKey ? QTest::keyClick(&view(), Qt::Key_Home) : act("fitModel");
        EXPECT_NEAR(view().camera().range_m, fitted_m, 1e-6 * fitted_m);
    }
    walk.step("see the chosen one of several | View → Fit the chosen model in the view (Alt+9)");
    EXPECT_EQ(get<QAction>("fitChosenModel")->shortcut(), QKeySequence("Alt+9"));
    EXPECT_FALSE(get<QAction>("fitChosenModel")->isEnabled()) << "there is one";
    ASSERT_TRUE(isUntouched()) << "the inspection camera changes nothing";
    walk.step("have the sensor see all | View → Show the whole model: the target; View → Show the "
              "whole scene: every model, the target still in the middle");
    act("showWholeModel");
    EXPECT_NE(workbench.camera().range_m, sensor.range_m);
    act("undo");
    walk.step("see one side of it | View → Look at: front, rear, both sides, top, bottom (Alt+1 to "
              "Alt+6)");
    const std::tuple<const char*, irsg::Vec3> sides[] = {
        {"lookAtFront", {0, -1, 0}},     {"lookAtRear", {0, 1, 0}}, {"lookAtPort", {1, 0, 0}},
        {"lookAtStarboard", {-1, 0, 0}}, {"lookAtTop", {0, 0, -1}}, {"lookAtBottom", {0, 0, 1}}};
    for (const auto& [name, along] : sides) {
        act(name);
        EXPECT_NEAR(irsg::dot(view().projection().eye.forward(), along), 1.0, 1e-9) << name;
    }
    walk.step("move the sensor | the same with Ctrl held down: a step that can be undone");
    wheel(&view(), middle(), 1, Qt::ControlModifier);
    EXPECT_NEAR(workbench.camera().range_m, 0.9 * sensor.range_m, 1e-9);
    act("undo");
    EXPECT_EQ(workbench.camera(), sensor);
    walk.step(
        "go to the sensor and back | Sensor and Inspect above the view (F7), or a click on the "
        "small picture");
    get<QToolButton>("showInspection")->click();
    EXPECT_TRUE(view().cameras().isInspecting());
    act("inspectionCamera");
    EXPECT_FALSE(view().cameras().isInspecting());
    EXPECT_EQ(get<QAction>("inspectionCamera")->shortcut(), QKeySequence(Qt::Key_F7));
    act("inspectionCamera");
    QTest::qWait(80);
    ASSERT_FALSE(view().insetRect().isNull());
    QTest::mouseClick(&view(), Qt::LeftButton, {}, view().insetRect().center().toPoint());
    EXPECT_FALSE(view().cameras().isInspecting());
    walk.step(
        "select a face | click: its temperature and material are shown, and selected in the tree "
        "and in the database");
    act("lookAtPort");
    act("fitModel");
    QTest::qWait(30);
    const auto hits = view().facesAt(middle());
    ASSERT_FALSE(hits.empty());
    QTest::mouseClick(&view(), Qt::LeftButton, {}, middle().toPoint());
    dock().tabs()->setCurrentIndex(0);
    EXPECT_EQ(dock().current()->index, hits.front().codes.material);
    ASSERT_NE(get<QTreeWidget>("sceneTree")->currentItem(), nullptr);
    walk.step("read a value | hover: radiance or temperature and the indices of the face");
    act("infraredDisplay");
    ASSERT_TRUE(waitForPicture());
    const QString read = view().readoutAt(middle());
    EXPECT_TRUE(read.contains("W·m⁻²·sr⁻¹")) << read.toStdString();
    choose(get<QComboBox>("viewQuantity"), 1);
    ASSERT_TRUE(waitForPicture());
    EXPECT_TRUE(view().readoutAt(middle()).contains(" K"))
        << view().readoutAt(middle()).toStdString();
    choose(get<QComboBox>("viewQuantity"), 0);

    walk.step("There are two cameras. The sensor is the one of the project");
    EXPECT_TRUE(isUntouched() || workbench.undoStack().index() == 0);
    get<QAction>("pictureInPicture")->setChecked(false);
    QTest::qWait(50);
    EXPECT_TRUE(view().insetRect().isNull());
    get<QAction>("pictureInPicture")->setChecked(true);
    walk.step("The band of the sensor stands above the view: MWIR, LWIR and those that the project "
              "names are in its list, and any other can be typed, such as 3.4-4.1.");
    auto* band = get<QComboBox>("bandBox");
    choose(band, band->findData("8-12"));
    EXPECT_EQ(workbench.settings().text("sensor.band"), "8-12");
    write(band->lineEdit(), "3.4-4.1");
    EXPECT_EQ(workbench.settings().text("sensor.band"), "3.4-4.1");
    walk.step("View → Infrared display changes between visible colours and apparent radiance or "
              "temperature");
    get<QAction>("infraredDisplay")->setChecked(false);
    int changes = 0;
    for (const char* name : {"viewAxes", "modelAxes", "sunVector", "zoomFrusta", "wireframe"}) {
        auto* toggle = window->findChild<QAction*>(name);
        if (toggle == nullptr) {
            ADD_FAILURE() << name;
            continue;
        }
        EXPECT_FALSE(toggle->shortcut().isEmpty()) << name;
        QTest::qWait(60);
        const QImage one = view().grab().toImage();
        toggle->trigger();
        changes += test::waitUntil([&] { return view().grab().toImage() != one; }, 2.0) ? 1 : 0;
        toggle->trigger();
    }
    EXPECT_GE(changes, 4) << "frusta are those of a picture with an antialiasing";
    act("showShortcuts");
    act("findCommand");
    walk.step("The infrared display begins in the colour scale and limits of the project's first "
              "image analysis in the same band, where the project sets none itself.");
    view().infrared().setQuantity(InfraredQuantity::radiance);
    EXPECT_EQ(view().infrared().colorRule().mode, LimitMode::target); // there is no such analysis
    Project withImage = workbench.project();
    withImage.analyses.push_back({"image", AnalysisKind::image});
    withImage.analyses.back().settings.set("display.minimum", "0.25");
    withImage.analyses.back().settings.set("display.maximum", "4");
    view().setProject(withImage, workbench.settings());
    EXPECT_EQ(view().infrared().colorRule().mode, LimitMode::locked);
    EXPECT_EQ(view().infrared().lockedLimits().high, 4.0);
    view().setProject(workbench.project(), workbench.settings());
    EXPECT_EQ(view().infrared().colorRule().mode, LimitMode::target);
    walk.step(
        "File → Export… writes the view as a picture, in the infrared with its colour bar, and "
        "the infrared values as EXR or CSV.");
    get<QAction>("infraredDisplay")->setChecked(true);
    ASSERT_TRUE(waitForPicture());
    for (const char* name : {"view.png", "view.exr", "view.csv"}) {
        chosen = path(name);
        act("exportShown");
        EXPECT_GT(std::filesystem::file_size(folder / name), 500U) << name << said();
    }
    EXPECT_EQ(irsg::readExr(folder / "view.exr").primary().values,
              view().shownPicture()->image->primary().values);
    walk.step("A large model is read in the background while the window stays responsive; the "
              "status bar shows the file and the time.");
    // A sound model of many equal triangles, more than is read within a moment.
    constexpr std::uint32_t facets = 90'000;
    std::string stl(80, ' ');
    stl.append(reinterpret_cast<const char*>(&facets), sizeof facets);
    const float corners[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::string facet(reinterpret_cast<const char*>(corners), sizeof corners);
    facet.resize(50, '\0');
    for (std::uint32_t i = 0; i < facets; ++i) {
        stl += facet;
    }
    smat::test::write(folder / "large.stl", stl);
    answer = 1;
    EXPECT_TRUE(window->open(folder / "large.stl"));
    EXPECT_EQ(workbench.project().displayName(), "ship.smat") << "while it is being read";
    openSample(); // another one takes its place
    QTest::qWait(300);
    ASSERT_TRUE(waitForModel());
    EXPECT_EQ(workbench.project().displayName(), "ship.smat");
    walk.note("Without OpenGL the view shows a message; everything else works.");
    EXPECT_TRUE(told.isEmpty()) << said();
}

TEST_F(WindowWalkTest, SceneCameraAndModel) {
    test::GuideWalk walk("window", "Scene, camera and model");
    openSample();
    ASSERT_TRUE(test::waitUntil([this] { return !window->tree().isLoading(); }));
    walk.step("The tree shows the project: its models with the temperature and material indices of "
              "their faces and the number of faces of each, the sensor, the atmosphere, the sun "
              "and the analyses.");
    auto* tree = get<QTreeWidget>("sceneTree");
    QTreeWidgetItem* entry = nullptr;
    int withFaces = 0;
    for (QTreeWidgetItemIterator it(tree); *it; ++it) {
        if ((*it)->childCount() == 0 && (*it)->text(1).toInt() > 0) {
            ++withFaces;
            entry = *it;
        }
    }
    ASSERT_GT(withFaces, 4);
    tree->setCurrentItem(entry);
    QTest::qWait(30);
    EXPECT_FALSE(view().highlighted().empty());
    walk.note("Of several models one is the chosen one: a scene of several models.");
    walk.step(
        "Camera and model has sliders for coarse and fields for exact values: azimuth (0° looks "
        "at the nose, 90° sees the starboard side), elevation, range; yaw (counter-clockwise "
        "from above), pitch (nose up), roll (starboard down).");
    const auto type = [this](const char* key, const char* text) {
        auto* field = window->findChild<QLineEdit*>(key);
        ASSERT_NE(field, nullptr) << key;
        write(field, text);
    };
    for (const auto& [azimuth, from] : {std::pair{"0", irsg::Vec3{0, 1, 0}}, {"90", {1, 0, 0}}}) {
        type("camera.azimuth", azimuth);
        type("camera.elevation", "0");
        QTest::qWait(20);
        EXPECT_NEAR(irsg::dot(view().projection().eye.forward(), from), -1.0, 1e-6) << azimuth;
    }
    const auto turned = [this](const irsg::Vec3& axis) {
        return view().scene().models.front().pose.attitude.rotation() * axis;
    };
    type("target.yaw", "90");
    EXPECT_NEAR(turned({0, 1, 0}).x, -1.0, 1e-9) << "counter-clockwise: the nose to the west";
    type("target.yaw", "0");
    type("target.pitch", "10");
    EXPECT_GT(turned({0, 1, 0}).z, 0.1);
    type("target.pitch", "0");
    type("target.roll", "10");
    EXPECT_LT(turned({1, 0, 0}).z, -0.1);
}

TEST_F(WindowWalkTest, Projects) {
    test::GuideWalk walk("window", "Projects");
    openSample();
    walk.step("The title has an asterisk while something is not saved, and closing asks.");
    EXPECT_FALSE(window->isWindowModified());
    workbench.set("camera.azimuth", "33");
    EXPECT_TRUE(window->isWindowModified());
    answer = -1;
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked.size(), 1);
    trigger("saveProject");
    const std::string saved = smat::test::contentOf(folder / "ship.smat");
    EXPECT_NE(saved.find("33"), std::string::npos) << "text, made to be read";
    EXPECT_EQ(saved.find("\"display.colorMap\""), std::string::npos);
    onDialog = [this](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("model")->setText(SMAT_SOURCE_DIR "/samples/box/box.flt");
        if (auto* title = dialog.findChild<QLineEdit*>("title")) {
            title->setText("A box");
        }
    };
    act("newProject");
    ASSERT_TRUE(waitForModel());
    EXPECT_EQ(workbench.project().title, "A box") << said();
    walk.step(
        "File → Project properties… (Alt+Return) has title and notes, and for each model its "
        "name, the direction of its nose and the entries that stand in for codes without one.");
    EXPECT_EQ(get<QAction>("projectProperties")->shortcut(), QKeySequence("Alt+Return"));
    onDialog = [](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("title")->setText("Another box");
        EXPECT_NE(dialog.findChild<QWidget*>("notes"), nullptr);
        EXPECT_NE(dialog.findChild<QWidget*>("name.0"), nullptr);
    };
    act("projectProperties");
    EXPECT_EQ(workbench.project().title, "Another box");
    walk.step(
        "File → Import or convert a model… turns models of all formats into OSG files in "
        "metres, with y to the nose and z up, and reports what was preserved and what the file "
        "leaves open.");
    QString report;
    onDialog = [&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("input")->setText(SMAT_SOURCE_DIR "/samples/box/box.flt");
        dialog.findChild<QLineEdit*>("output")->setText(path("box.osgb"));
        dialog.findChild<QCheckBox*>("openIt")->setChecked(false);
        dialog.findChild<QPushButton*>("convert")->click();
        EXPECT_TRUE(
            test::waitUntil([&] { return std::filesystem::exists(folder / "box.osgb"); }, 20.0));
        QTest::qWait(100);
        const auto* words = dialog.findChild<QWidget*>("report");
        report = words->property("plainText").toString() + words->property("text").toString();
    };
    act("convertModel");
    onDialog = nullptr;
    EXPECT_FALSE(report.isEmpty());
    answer = 1;
}

TEST_F(WindowWalkTest, SettingsAndHelp) {
    test::GuideWalk walk("window", "Settings");
    openSample();
    walk.step("One window has all settings of the project: Analysis → Analysis settings… (F8) "
              "opens it at band and calculation, Tools → Options… (F9) at the antialiasing. Type "
              "any word of a setting into Search, field of view or --layers, and only settings "
              "that contain it remain.");
    QStringList pages;
    onDialog = [&](QDialog& dialog) {
        pages << dialog.findChild<QListWidget*>("pageList")->currentItem()->text();
        for (const auto& [words, key] :
             {std::pair{"field of view", "sensor.fov"}, {"--layers", "render.layers"}}) {
            auto* search = dialog.findChild<QLineEdit*>("settingsSearch");
            search->selectAll();
            QTest::keyClicks(search, words);
            QTest::qWait(20);
            int left = 0;
            bool isThere = false;
            for (const SettingInfo& info : settingTable()) {
                const auto* field = dialog.findChild<QWidget*>(QString::fromStdString(info.key));
                left += field != nullptr && field->isVisible() ? 1 : 0;
                isThere |= info.key == key && field != nullptr && field->isVisible();
            }
            EXPECT_TRUE(isThere) << key;
            EXPECT_LT(left, 8) << words;
            search->clear();
        }
    };
    act("analysisSettings");
    act("options");
    ASSERT_EQ(pages.size(), 2);
    EXPECT_EQ(pages[1], "Antialiasing");
    EXPECT_NE(pages[0], pages[1]);
    walk.step(
        "Every field shows its unit, its range and what it means; Show expert settings shows the "
        "rest. OK or Apply is one step of undo. All of it is also in the project file and in "
        "every command as --set key=value");
    onDialog = [](QDialog& dialog) {
        auto* experts = dialog.findChild<QCheckBox*>("showExperts");
        int before = 0, after = 0;
        const auto count = [&] {
            int fields = 0;
            for (const SettingInfo& info : settingTable()) {
                const auto* field = dialog.findChild<QWidget*>(QString::fromStdString(info.key));
                fields += field != nullptr && !field->isHidden() ? 1 : 0;
            }
            return fields;
        };
        before = count();
        experts->click();
        after = count();
        EXPECT_GT(std::max(before, after), std::min(before, after));
        dialog.findChild<QCheckBox*>("render.sunDisc")->click();
        dialog.accept();
    };
    const int steps = workbench.undoStack().index();
    act("options");
    onDialog = nullptr;
    EXPECT_EQ(workbench.undoStack().index(), steps + 1);
    trigger("saveProject");
    EXPECT_NE(smat::test::contentOf(folder / "ship.smat").find("sunDisc"), std::string::npos);
    terminal("smat-batch image ship.smat --set render.sunDisc=false --set sensor.width=16 --set "
             "sensor.height=16 --out x.exr");
    walk.step("Edit → Preferences… (Ctrl+,) holds settings of the user, not of the project: theme, "
              "colour map of new projects, recovery copies, units of display.");
    EXPECT_EQ(get<QAction>("preferences")->shortcut(), QKeySequence("Ctrl+,"));
    accept = false;
    bool isSeen = false;
    onDialog = [&](QDialog& dialog) {
        for (const char* name : {"theme", "colorMap", "recoveryDelay", "spectralUnit"}) {
            EXPECT_NE(dialog.findChild<QWidget*>(name), nullptr) << name;
        }
        isSeen = true;
    };
    act("preferences");
    EXPECT_TRUE(isSeen);
    walk.step("Help → Keys and mouse (F1) lists every key; Help → About SMAT the versions and the "
              "renderers in use. Help → Self-test… compares the results of this machine and its "
              "OpenGL driver with closed forms and published numbers. Start runs it");
    QString words;
    onDialog = [&](QDialog& dialog) {
        for (const auto* label : dialog.findChildren<QLabel*>()) {
            words += label->text() + "\n";
        }
        for (const auto* list : dialog.findChildren<QTreeWidget*>()) {
            for (QTreeWidgetItemIterator it(const_cast<QTreeWidget*>(list)); *it; ++it) {
                words += (*it)->text(0) + (*it)->text(1) + "\n";
            }
        }
    };
    for (const char* name : {"showShortcuts", "showAbout"}) {
        words.clear();
        act(name);
        EXPECT_FALSE(words.isEmpty()) << name;
    }
    EXPECT_TRUE(words.contains("OpenGL")) << words.toStdString();
    onDialog = [&](QDialog& dialog) {
        auto& self = dynamic_cast<SelfTestDialog&>(dialog);
        dialog.findChild<QCheckBox*>("selfTestHard")->setChecked(false);
        auto* table = dialog.findChild<QTreeWidget*>("selfTestTable");
        dialog.findChild<QPushButton*>("selfTestStart")->click();
        ASSERT_TRUE(test::waitUntil([&] { return table->topLevelItemCount() >= 3; }, 60.0));
        dialog.findChild<QPushButton*>("selfTestStart")->click(); // Stop
        ASSERT_TRUE(test::waitUntil([&] { return !self.isRunning(); }, 60.0));
        EXPECT_FALSE(table->topLevelItem(0)->toolTip(0).isEmpty());
        EXPECT_GE(table->columnCount(), 5);
        EXPECT_NE(dialog.findChild<QPushButton*>("selfTestCopy"), nullptr);
    };
    act("selfTest");
    onDialog = nullptr;
    accept = true;
}

} // namespace
} // namespace smat::gui

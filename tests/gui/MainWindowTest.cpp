#include "gui/MainWindow.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QProcess>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include "gui/HelpDialogs.h"
#include "gui/analysis/AnalysisGeneratorDialog.h"
#include "gui/analysis/ResultPage.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageView.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PolarPlot.h"
#include "gui/project/ProjectFiles.h"
#include "gui/view/SceneView.h"
#include "gui/widgets/Theme.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/image/ExrFile.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/data/Provenance.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/ResultTables.h"
#include "tests/gui/SampleProject.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

using MainWindowTest = test::WindowFixture;

TEST_F(MainWindowTest, OpensAProjectAndShowsItsModel) {
    openSample();
    ASSERT_NE(window->sceneView(), nullptr);
    EXPECT_TRUE(window->windowTitle().startsWith("ship.smat"));
    EXPECT_EQ(window->sceneView()->camera().azimuth_deg, 60.0);
    window->sceneView()->showWholeModel();
    QTest::qWait(100);
    const QImage picture = window->sceneView()->grabFramebuffer();
    EXPECT_NE(picture.pixelColor(picture.width() / 2, picture.height() / 2),
              picture.pixelColor(3, picture.height() / 2));
    test::keepScreenshot(*window, "window-model");
}

TEST_F(MainWindowTest, ImageFromTheWindowEqualsTheGeneratorsOwn) {
    openSample();
    onDialog = [](QDialog& dialog) { test::keepScreenshot(dialog, "dialog-image"); };
    runAnalysis("image");
    ASSERT_EQ(workbench.results().size(), 1U);
    const AnalysisData& shown = *workbench.results().front().data;
    const AnalysisData direct = runDirectly(shown);
    EXPECT_EQ(shown.image.primary().values, direct.image.primary().values);
    EXPECT_EQ(shown.table.columns(), direct.table.columns());
    ASSERT_NE(window->currentPage(), nullptr);
    EXPECT_EQ(window->currentPage()->imageView()->image().primary().values,
              shown.image.primary().values);
    test::keepScreenshot(*window, "window-image");
}

TEST_F(MainWindowTest, PolarPlotFromTheWindowEqualsTheGeneratorsOwn) {
    openSample();
    onDialog = [](QDialog& dialog) { test::keepScreenshot(dialog, "dialog-polar"); };
    runAnalysis("polar");
    ASSERT_EQ(workbench.results().size(), 1U);
    const AnalysisData& shown = *workbench.results().front().data;
    EXPECT_EQ(shown.table.columns(), runDirectly(shown).table.columns());
    ASSERT_NE(window->currentPage()->polarPlot(), nullptr);
    EXPECT_EQ(window->currentPage()->polarPlot()->data().curves.at(0).y,
              shown.table.find("contrast_intensity")->values);
    test::keepScreenshot(*window, "window-polar");
}

TEST_F(MainWindowTest, RunsTheOtherThreeAnalysesIntoCartesianPlots) {
    openSample();
    for (const auto* word : {"spectrum", "range", "time"}) {
        runAnalysis(word);
        ASSERT_NE(window->currentPage(), nullptr) << word;
        ASSERT_NE(window->currentPage()->cartesianPlot(), nullptr) << word;
        test::keepScreenshot(*window, std::string("window-") + word);
    }
    EXPECT_EQ(workbench.results().size(), 3U);
}

TEST_F(MainWindowTest, OverlaysTwoRunsOfOneKind) {
    openSample();
    runAnalysis("polar");
    workbench.set("sensor.band", "8-12");
    runAnalysis("polar");
    auto* list = window->findChild<QListWidget*>("resultList");
    list->selectAll();
    window->findChild<QToolButton*>("overlayResults")->click();
    EXPECT_EQ(window->currentPage()->polarPlot()->data().curves.size(), 2U);
    test::keepScreenshot(*window, "window-overlay");
}

TEST_F(MainWindowTest, DialogRefusesAValueOutOfRangeAndShowsTheCommand) {
    openSample();
    accept = false;
    workbench.set("camera.azimuth", "33");
    bool seen = false;
    onDialog = [&](QDialog& dialog) {
        auto& form = dynamic_cast<AnalysisGeneratorDialog&>(dialog);
        EXPECT_TRUE(form.isAcceptable());
        auto* command = form.findChild<QLineEdit*>("commandLine");
        EXPECT_TRUE(command->text().contains("smat-batch polar")) << command->text().toStdString();
        auto* steps = form.findChild<QComboBox*>("polar.step");
        EXPECT_TRUE(steps->toolTip().contains("Angle between two cases"));
        QLineEdit* step = steps->lineEdit();
        step->selectAll();
        QTest::keyClicks(step, "-4");
        EXPECT_FALSE(form.isAcceptable());
        test::keepScreenshot(dialog, "dialog-refuses");
        step->selectAll();
        QTest::keyClicks(step, "45");
        EXPECT_TRUE(command->text().contains("--step=45")) << command->text().toStdString();
        EXPECT_TRUE(command->text().contains("--azimuth=33")) << command->text().toStdString();
        EXPECT_TRUE(form.isAcceptable());
        EXPECT_EQ(form.data().settings[OptionalRealKey{"polar.step"}], 45.0);
        seen = true;
    };
    window->findChild<QAction*>("new-polar")->trigger();
    EXPECT_TRUE(seen);
    EXPECT_FALSE(workbench.isRunning());
}

TEST_F(MainWindowTest, CancelKeepsWhatIsDone) {
    openSample();
    workbench.set("polar.step", "0.05");
    window->findChild<QAction*>("new-polar")->trigger();
    int done = 0;
    QObject::connect(&workbench, &Workbench::jobProgressed,
                     [&](const Progress& p) { done = static_cast<int>(p.done); });
    ASSERT_TRUE(test::waitUntil([&] { return done >= 3; }));
    test::keepScreenshot(*window, "window-running");
    window->findChild<QToolButton*>("cancelJob")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !workbench.isRunning(); }));
    ASSERT_EQ(workbench.results().size(), 1U);
    const auto& data = *workbench.results().front().data;
    EXPECT_EQ(data.state, AnalysisState::partial);
    EXPECT_GE(data.table.rowCount(), 3U);
    EXPECT_LT(data.table.rowCount(), 7200U);
}

TEST_F(MainWindowTest, ClosesCleanlyWhileAnAnalysisRuns) {
    openSample();
    workbench.set("polar.step", "0.05");
    window->findChild<QAction*>("new-polar")->trigger();
    QTest::qWait(50);
    EXPECT_TRUE(workbench.isRunning());
    answers = {-1}; // stay
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked, QStringList{"Quit during a run"});
    EXPECT_TRUE(workbench.isRunning());
    answers = {0, 1}; // quit, and discard the changed step
    EXPECT_TRUE(window->close());
    window.reset();
}

TEST_F(MainWindowTest, TellsAboutAMissingFileAndLosesNothing) {
    openSample();
    chosen = QString::fromStdString((folder / "missing.smat").string());
    window->findChild<QAction*>("openProject")->trigger();
    EXPECT_EQ(told.size(), 1);
    EXPECT_TRUE(told.value(0).contains("missing.smat"));
    EXPECT_EQ(workbench.project().displayName(), "ship.smat");
    EXPECT_TRUE(window->windowTitle().startsWith("ship.smat"));
}

TEST_F(MainWindowTest, SavesWhatIsShown) {
    openSample();
    runAnalysis("image");
    for (const auto* name : {"a.exr", "a.csv", "a.png"}) {
        chosen = QString::fromStdString((folder / name).string());
        window->findChild<QAction*>("exportShown")->trigger();
        EXPECT_GT(std::filesystem::file_size(folder / name), 200U) << name;
    }
    runAnalysis("range");
    for (const auto* name : {"r.csv", "r.json", "r.svg", "r.png", "r.pdf"}) {
        chosen = QString::fromStdString((folder / name).string());
        window->findChild<QAction*>("exportShown")->trigger();
        EXPECT_GT(std::filesystem::file_size(folder / name), 200U) << name;
    }
    EXPECT_TRUE(told.isEmpty());
}

TEST_F(MainWindowTest, TurningTheViewWithControlMovesTheSensorOfTheProject) {
    openSample();
    ASSERT_NE(window->sceneView(), nullptr);
    QTest::keyClick(window->sceneView(), Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(workbench.camera().azimuth_deg, 70.0);
    auto* field = window->findChild<QLineEdit*>("camera.azimuth");
    EXPECT_EQ(field->text(), "70");
    field->selectAll();
    QTest::keyClicks(field, "12.345");
    EXPECT_EQ(window->sceneView()->camera().azimuth_deg, 12.345);
}

TEST_F(MainWindowTest, ViewTogglesChangeThePicture) {
    openSample();
    window->sceneView()->showWholeModel();
    QTest::qWait(50);
    const QImage solid = window->sceneView()->grabFramebuffer();
    window->findChild<QAction*>("wireframe")->trigger();
    const QImage wire = window->sceneView()->grabFramebuffer();
    EXPECT_NE(solid, wire);
    test::keepScreenshot(*window, "window-wireframe");
    window->findChild<QAction*>("wireframe")->trigger();
    EXPECT_EQ(window->sceneView()->grabFramebuffer(), solid);
}

TEST_F(MainWindowTest, OffersTheAnalysesOfAProjectInADarkThemeToo) {
    applyTheme(*qApp, ThemeMode::dark);
    window.reset();
    makeWindow();
    ASSERT_TRUE(
        opens(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/turboprop4/turboprop4.smat"));
    QTest::qWait(100);
    test::keepScreenshot(*window, "window-dark-model");
    auto* menu = window->findChild<QMenu*>("projectAnalyses");
    const auto run = [&](const QString& name) {
        for (auto* action : menu->actions()) {
            if (action->text().startsWith(name)) {
                action->trigger();
            }
        }
        EXPECT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }));
        QTest::qWait(50);
        test::keepScreenshot(*window, "window-dark-" + name.toStdString());
    };
    run("mwir-image");
    run("polar");
    applyTheme(*qApp, ThemeMode::light);
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_EQ(workbench.results().size(), 2U);
}

/// Runs one test again in a process without a display, and without an EGL driver where asked to.
void runsWithoutDisplay(const char* filter, bool egl) {
    QProcess process;
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.remove("DISPLAY");
    environment.remove("WAYLAND_DISPLAY");
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    if (!egl) {
        environment.insert("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null");
    }
    environment.insert("SMAT_TEST_RUNS_AGAIN", "1");
    process.setProcessEnvironment(environment);
    process.start(QCoreApplication::applicationFilePath(),
                  {QStringLiteral("--gtest_filter=") + filter});
    ASSERT_TRUE(process.waitForFinished(120000));
    const QByteArray said = process.readAllStandardOutput();
    EXPECT_EQ(process.exitCode(), 0) << said.toStdString();
    EXPECT_TRUE(said.contains("[  PASSED  ] 1 test")) << said.toStdString();
}

TEST(MainWindowWithoutGlTest, RunsAnalysesAllTheSame) {
    if (!qEnvironmentVariableIsSet("SMAT_TEST_RUNS_AGAIN")) {
        runsWithoutDisplay("MainWindowWithoutGlTest.*", true);
        return;
    }
    Workbench workbench;
    Dialogs dialogs;
    dialogs.tell = [](QWidget*, const QString&, const QStringList& s) {
        FAIL() << s.join('\n').toStdString();
    };
    dialogs.run = [](QDialog&) { return true; };
    MainWindow window(workbench, dialogs);
    window.show();
    EXPECT_EQ(window.sceneView(), nullptr);
    EXPECT_NE(window.findChild<QLabel*>("noGlNotice"), nullptr);
    EXPECT_EQ(window.findChild<QAction*>("wireframe"), nullptr);
    ASSERT_TRUE(window.open(test::writeSampleProject(test::freshFolder("no-gl"))));
    window.findChild<QAction*>("new-image")->trigger();
    ASSERT_TRUE(test::waitUntil([&] { return !workbench.isRunning(); }));
    ASSERT_NE(window.currentPage(), nullptr);
    QTest::qWait(50);
    test::keepScreenshot(window, "window-without-gl");
}

TEST(MainWindowWithoutAnyGlTest, AnImageGivesOneSentenceAndTheRestGoesOn) {
    if (!qEnvironmentVariableIsSet("SMAT_TEST_RUNS_AGAIN")) {
        runsWithoutDisplay("MainWindowWithoutAnyGlTest.*", false);
        return;
    }
    Workbench workbench;
    QStringList titles, told;
    QString chosen;
    Dialogs dialogs;
    dialogs.openFile = [&](QWidget*, const QString&, const QStringList&) { return chosen; };
    dialogs.tell = [&](QWidget*, const QString& title, const QStringList& sentences) {
        titles << title;
        told += sentences;
    };
    dialogs.run = [](QDialog&) { return true; };
    MainWindow window(workbench, dialogs);
    window.resize(1200, 800);
    window.show();
    const auto folder = test::freshFolder("no-gl-at-all");
    const auto file = test::writeSampleProject(folder);
    ASSERT_TRUE(window.open(file));
    for (const char* action : {"new-image", "new-polar"}) {
        titles.clear();
        told.clear();
        window.findChild<QAction*>(action)->trigger();
        ASSERT_TRUE(test::waitUntil([&] { return !workbench.isRunning(); }));
        EXPECT_EQ(titles, QStringList{"The analysis cannot be run"});
        ASSERT_EQ(told.size(), 1) << told.join('\n').toStdString();
        EXPECT_TRUE(told.front().contains("OpenGL") && told.front().contains("not available"))
            << told.front().toStdString();
        EXPECT_TRUE(workbench.results().empty());
    }
    told.clear();

    // The project is as it was, and is edited and saved.
    ASSERT_TRUE(workbench.hasProject());
    EXPECT_FALSE(workbench.isModified());
    workbench.set("camera.range", "1234");
    EXPECT_TRUE(window.files().save());
    EXPECT_EQ(loadProject(file).settings.text("camera.range"), "1234");

    irsg::RadianceImage image(8, 6);
    image.primary().values.assign(48, 1.0F);
    irsg::writeExr(image, folder / "a.exr");
    image.primary().values[5] = 3.0F;
    irsg::writeExr(image, folder / "b.exr");
    auto* compared = window.compareImages({QString::fromStdString((folder / "a.exr").string()),
                                           QString::fromStdString((folder / "b.exr").string())});
    ASSERT_TRUE(test::waitUntil([&] { return compared->comparison().has_value(); }, 20.0));
    EXPECT_DOUBLE_EQ(compared->comparison()->largest.error, -2.0);

    AnalysisData polar;
    polar.kind = AnalysisKind::polar;
    polar.table = test::polarTable();
    saveResult(polar, folder / "polar.csv");
    chosen = QString::fromStdString((folder / "polar.csv").string());
    window.findChild<QAction*>("openResultAction")->trigger();
    ASSERT_NE(window.currentPage(), nullptr);
    QTest::qWait(50);
    EXPECT_NE(window.currentPage()->findChild<PolarPlot*>(), nullptr);
    test::keepScreenshot(window, "window-without-any-gl");
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(MainWindowTest, HelpNamesKeysAndRenderers) {
    QStringList names;
    QString text;
    onDialog = [&](QDialog& dialog) {
        names << dialog.objectName();
        text.clear();
        for (const auto* label : dialog.findChildren<QLabel*>()) {
            text += label->text() + '\n';
        }
        test::keepScreenshot(dialog, dialog.objectName().toStdString());
    };
    trigger("showAbout");
    EXPECT_TRUE(text.contains("not used yet")) << text.toStdString();
    openSample();
    const auto shown = std::exchange(onDialog, {});
    runAnalysis("image");
    onDialog = shown;

    trigger("showAbout");
    const std::string& renderer = workbench.results().front().data->renderer;
    ASSERT_FALSE(renderer.empty());
    for (const QString& part :
         {QString::fromStdString(irsg::programVersion()), QString(qVersion()),
          QString("OpenSceneGraph"), QString::fromStdString(renderer).toHtmlEscaped()}) {
        EXPECT_TRUE(text.contains(part)) << part.toStdString() << "\n" << text.toStdString();
    }
    EXPECT_FALSE(text.contains("not used yet")) << text.toStdString();

    // Each action with a key is in the list with both.
    trigger("showShortcuts");
    for (const char* name : {"saveProject", "undo", "showShortcuts", "exportShown"}) {
        const auto* action = window->findChild<QAction*>(name);
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        ASSERT_FALSE(keys.isEmpty()) << name;
        EXPECT_TRUE(text.contains(keys.toHtmlEscaped())) << name << "\n" << text.toStdString();
    }
    EXPECT_TRUE(text.contains("Zoom at the cursor"));
    EXPECT_EQ(names, (QStringList{"aboutDialog", "aboutDialog", "shortcutsDialog"}));
}

} // namespace
} // namespace smat::gui

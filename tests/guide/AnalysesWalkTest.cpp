#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QStatusBar>
#include <QTabBar>
#include <QTreeWidget>

#include "gui/analysis/CostAccuracyPanel.h"
#include "gui/analysis/FloatingPages.h"
#include "gui/analysis/JobBar.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageView.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/PolarPlot.h"
#include "gui/tools/CostAccuracyPage.h"
#include "gui/tools/DetectionPage.h"
#include "gui/tools/PlanePane.h"
#include "gui/tools/SensorPage.h"
#include "gui/tools/StageCard.h"
#include "irsg/image/ExrFile.h"
#include "smatcore/analysis/CostAccuracyStudy.h"
#include "tests/gui/ResultList.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

class AnalysesWalkTest : public test::GuideFixture {
  protected:
    const ResultTable& table() { return workbench.results().back().data->table; }
    QListWidget* list() { return get<QListWidget>("resultList"); }
};

TEST_F(AnalysesWalkTest, AnalysesOfEachKind) {
    test::GuideWalk walk("analyses", "");
    // While nothing is open.
    auto* polar = get<QAction>("new-polar");
    EXPECT_FALSE(polar->isEnabled());
    EXPECT_TRUE(polar->toolTip().contains("Open a project")) << polar->toolTip().toStdString();
    openSample();
    struct Kind {
        const char *row, *word, *key;
    };
    const Kind kinds[] = {
        {"Image (Ctrl+1) | radiance, apparent temperature or irradiance of every pixel; on request "
         "the truth behind each (indices, range, each term)",
         "image", "Ctrl+1"},
        {"Spectrum (Ctrl+2) | intensity over wavenumber and wavelength", "spectrum", "Ctrl+2"},
        {"Polar (Ctrl+3) | intensity over aspect: the camera in azimuth or elevation, or the model "
         "in "
         "yaw",
         "polar", "Ctrl+3"},
        {"Time (Ctrl+4) | intensity over time: temperatures and plumes that change", "time",
         "Ctrl+4"},
        {"Range (Ctrl+5) | intensity over range, through the atmosphere", "range", "Ctrl+5"},
        {"Condition (Ctrl+6) | intensity over engine power, Mach number or altitude; the camera "
         "climbs with the target",
         "condition", "Ctrl+6"},
        {"Table (Ctrl+7) | intensity over all chosen directions, ranges and states, for other "
         "programs",
         "table", "Ctrl+7"}};
    std::string command;
    onDialog = [&](QDialog& dialog) {
        if (auto* line = dialog.findChild<QLineEdit*>("commandLine")) {
            command = line->text().toStdString();
        }
    };
    workbench.set("image.truthLayers", "true");
    workbench.set("condition.points", "3");
    workbench.set("table.azimuthStep", "120");
    workbench.set("table.elevationStep", "90");
    workbench.set("table.ranges", "1000,2000");
    for (const Kind& kind : kinds) {
        walk.step(kind.row);
        EXPECT_EQ(get<QAction>(QString("new-") + kind.word)->shortcut(), QKeySequence(kind.key));
        runAnalysis(kind.word);
        EXPECT_NE(command.find(std::string("smat-batch ") + kind.word), std::string::npos)
            << command;
    }
    onDialog = nullptr;
    const auto& results = workbench.results();
    ASSERT_EQ(results.size(), 7U);
    const irsg::RadianceImage& image = results[0].data->image;
    for (const char* plane : {"temperature_index", "range"}) {
        EXPECT_NE(image.find(plane), nullptr) << plane;
    }
    EXPECT_GT(image.channels.size(), 6U) << "each term";
    const ResultTable& spectrum = results[1].data->table;
    EXPECT_NE(spectrum.find("wavenumber"), nullptr);
    EXPECT_NE(spectrum.find("wavelength"), nullptr);
    ASSERT_TRUE(results[5].data->table.find("mach") && results[6].data->table.find("range"));
    EXPECT_EQ(results[5].data->table.rowCount(), 3U);
    EXPECT_EQ(results[6].data->table.find("range")->values.back(), 2000.0);
    for (const auto& [over, to] : {std::pair{"power", "1"}, {"altitude", "3000"}}) {
        workbench.set("condition.over", over);
        workbench.set("condition.to", to);
        runAnalysis("condition");
        EXPECT_NE(table().find(over), nullptr) << over;
    }
    walk.step("Contrast intensity is the intensity of the object minus that of the background it "
              "hides, in W/sr; irradiance is that at the sensor.");
    const ResultTable& range = results[4].data->table;
    EXPECT_EQ(range.find("contrast_intensity")->unit, "W sr-1");
    ASSERT_NE(range.find("irradiance"), nullptr);
    EXPECT_LT(range.find("irradiance")->values.back(), range.find("irradiance")->values.front())
        << "that at the sensor falls with the range";
    walk.step("An image is shown as described in images, the others as plots");
    for (int i = 0; i < 6; ++i) {
        selectResults({i});
        act("showResultAction");
        ASSERT_NE(window->currentPage(), nullptr) << i;
        EXPECT_EQ(window->currentPage()->imageView() != nullptr, i == 0);
        EXPECT_EQ(window->currentPage()->polarPlot() != nullptr, i == 2);
        EXPECT_EQ(window->currentPage()->cartesianPlot() != nullptr, i != 0 && i != 2);
    }

    walk.step("While nothing is open, or the model has no signature database, the analyses are "
              "grey, and their tooltips give the reason.");
    EXPECT_TRUE(polar->isEnabled());
    walk.step("The dialog begins with the project's settings; changes apply to this analysis "
              "alone. The last line is the command that computes the same numbers in a terminal.");
    onDialog = [&](QDialog& dialog) {
        auto* step = dialog.findChild<QComboBox*>("polar.step")->lineEdit();
        EXPECT_EQ(step->text(), "30");
        step->selectAll();
        QTest::keyClicks(step, "90");
        command = dialog.findChild<QLineEdit*>("commandLine")->text().toStdString();
    };
    runAnalysis("polar");
    onDialog = nullptr;
    EXPECT_EQ(table().rowCount(), 4U);
    EXPECT_EQ(workbench.settings().text("polar.step"), "30");
    terminal("smat-batch project info ship.smat");
    // The project as it is on disk has not the settings that were made since.
    trigger("saveProject");
    terminal(workbench.results().back().data->commandLine + " --out batch.csv");
    EXPECT_EQ(ResultTable::load(folder / "batch.csv").columns(), table().columns());
    act("keepAnalysis");
    ASSERT_EQ(workbench.project().analyses.size(), 1U);
    auto* own = get<QMenu>("projectAnalyses");
    emit own->aboutToShow();
    EXPECT_GE(own->actions().size(), 1);

    walk.step("A run never blocks the window. The status bar shows its progress, the stage of the "
              "case under way with its share (inter-reflection: pairs, 43 %) and the remaining "
              "time, whichever dock is in front; Cancel (Esc) stops it and keeps the finished "
              "cases, marked as partial. Further jobs wait in line");
    const auto start = [&](const char* name, const char* step) {
        AnalysisData data =
            AnalysisData::of(workbench.project(), AnalysisKind::polar, workbench.settings());
        data.name = name;
        data.settings.set("polar.step", step);
        return workbench.start(data);
    };
    std::size_t done = 0;
    QObject::connect(&workbench, &Workbench::jobProgressed, window.get(),
                     [&](const Progress& progress) { done = progress.done; });
    get<QDockWidget>("databaseDock")->raise();
    const auto before = workbench.results().size();
    start("first", "0.05");
    start("second", "90");
    start("third", "90");
    ASSERT_TRUE(test::waitUntil([&] { return done >= 2; }, 60.0));
    QTest::qWait(150);
    auto* bar = window->findChild<JobBar*>();
    EXPECT_TRUE(bar->isVisible());
    EXPECT_EQ(get<QLabel>("jobTitle", bar)->text(), "first");
    EXPECT_TRUE(get<QLabel>("jobDetail", bar)->text().contains("of 7200"));
    EXPECT_NE(get<QLabel>("jobStage", bar), nullptr);
    EXPECT_TRUE(get<QLabel>("jobTimes", bar)->text().contains("left"));
    EXPECT_EQ(get<QToolButton>("waitingJobs", bar)->text(), "2 waiting");
    auto* menu = get<QMenu>("waitingMenu", bar);
    emit menu->aboutToShow();
    menu->actions().at(1)->trigger(); // the third leaves the line
    EXPECT_EQ(get<QToolButton>("waitingJobs", bar)->text(), "1 waiting");
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
    QTest::keyClick(window.get(), Qt::Key_Escape);
    ASSERT_TRUE(settled());
    ASSERT_EQ(workbench.results().size(), before + 2);
    EXPECT_TRUE(workbench.results()[before].title.contains("first (partial)"))
        << workbench.results()[before].title.toStdString();
    EXPECT_GT(workbench.results()[before].data->table.rowCount(), 1U);
    EXPECT_TRUE(told.isEmpty()) << said();
}

TEST_F(AnalysesWalkTest, HowSureANumberIs) {
    test::GuideWalk walk("analyses", "How accurate a number is");
    openSample();
    const auto ask = [&](const char* key, const QString& value) {
        onDialog = [=](QDialog& dialog) {
            auto* field = dialog.findChild<QWidget*>(key);
            ASSERT_NE(field, nullptr) << key;
            if (auto* box = qobject_cast<QComboBox*>(field); box != nullptr && !box->isEditable()) {
                box->setCurrentText(value);
                emit box->activated(box->currentIndex());
                return;
            }
            auto* line = qobject_cast<QComboBox*>(field) != nullptr
                             ? qobject_cast<QComboBox*>(field)->lineEdit()
                             : qobject_cast<QLineEdit*>(field);
            ASSERT_NE(line, nullptr) << key;
            line->selectAll();
            QTest::keyClicks(line, value);
        };
    };
    walk.step("Errors of results on the page Rendering gives intensities, contrast and irradiance "
              "their error, as a sum or by its causes. The plot shows it as a band, and the "
              "crosshair as 12.5 ± 0.3.");
    workbench.set("render.errors", "causes");
    runAnalysis("range");
    EXPECT_NE(table().find("error_contrast_intensity") != nullptr ||
                  table().find("contrast_intensity_error") != nullptr,
              false);
    const CartesianPlot* plot = window->currentPage()->cartesianPlot();
    EXPECT_FALSE(plot->data().curves.front().error.empty());
    EXPECT_TRUE(plot->readoutAt(QPointF(plot->sheet()->rect().center())).contains("±"));
    workbench.set("render.errors", "off");

    walk.step("Target error beside it works the other way: the program chooses sample tiles, "
              "spectral resolution, background and the terms that matter, so that errors stay "
              "below it, and the result's details list the choices");
    workbench.set("render.targetError", "10%");
    runAnalysis("range");
    bool isSaid = false;
    for (const auto& [key, value] : table().provenance.entries) {
        isSaid |= value.find("target error 10 %") != std::string::npos;
    }
    for (const auto& warning : workbench.results().back().data->warnings) {
        isSaid |= warning.find("target error 10 %") != std::string::npos;
    }
    EXPECT_TRUE(isSaid);
    workbench.set("render.targetError", "none");

    walk.step(
        "Polar and range plots put their cases where the curve bends, unless Step or Points is "
        "a number");
    workbench.set("polar.steps", "adaptive");
    runAnalysis("polar");
    EXPECT_TRUE(window->currentPage()->polarPlot()->data().curves.front().isSmooth);
    EXPECT_NE(table().rowCount(), 12U);
    EXPECT_EQ(Settings().text("polar.steps"), "auto") << "adaptive where the step is no number";
    EXPECT_EQ(Settings().text("range.steps"), "auto");
    workbench.set("polar.steps", "auto");
    ask("polar.step", "30");
    runAnalysis("polar");
    onDialog = nullptr;
    EXPECT_EQ(table().rowCount(), 12U);
    EXPECT_FALSE(window->currentPage()->polarPlot()->data().curves.front().isSmooth);
}

TEST_F(AnalysesWalkTest, TimeAgainstError) {
    test::GuideWalk walk("analyses", "Time against error");
    openSample();
    workbench.set("render.bounces", "0");
    walk.step("Tools → Time against error calculates the view of the project in many "
              "configurations, or in all of them, and plots time and true error of each.");
    act("frontier");
    auto* tool = page<CostAccuracyPage>();
    ASSERT_NE(tool, nullptr);
    get<QSpinBox>("repeats", tool)->setValue(1);
    choose(get<QComboBox>("ways", tool), 0);
    write(get<QLineEdit>("targetError", tool), "20");
    get<QPushButton>("run", tool)->click();
    ASSERT_TRUE(test::waitUntil([&] { return workbench.results().size() == 1; }, 120.0));
    ASSERT_TRUE(settled());
    const ResultTable& ways = tool->panel().table();
    ASSERT_GT(ways.rowCount(), 3U);
    // The front: none is both quicker and less wrong than one on it.
    const auto& front = tool->panel().plot().cartesian()->data().curves.at(0);
    EXPECT_TRUE(std::ranges::is_sorted(front.x));
    EXPECT_TRUE(std::ranges::is_sorted(front.y, std::greater<>()));
    get<QCheckBox>("frontierAll", tool)->setChecked(true);
    auto* rows = get<QTreeWidget>("frontierWays", tool);
    rows->setCurrentItem(rows->topLevelItem(rows->topLevelItemCount() - 1));
    const Settings before = workbench.settings();
    get<QPushButton>("useWay", tool)->click();
    EXPECT_NE(workbench.settings(), before);
    act("undo");
    EXPECT_EQ(workbench.settings(), before);
    EXPECT_TRUE(told.isEmpty()) << said();
}

TEST_F(AnalysesWalkTest, DetectionRange) {
    test::GuideWalk walk("analyses", "Detection range");
    openSample();
    workbench.set("render.bounces", "0");
    walk.step("Tools → Detection range… draws how far a sensor sees the target over the aspects of "
              "the project's polar plot.");
    act("detectionRange");
    auto* tool = page<DetectionPage>();
    ASSERT_NE(tool, nullptr);
    walk.step("Choose one of the six sensors that come with the program, or a file, and what "
              "seeing means: the light of the target stands out of the noise, or its shape is "
              "resolved well enough for a task.");
    auto* sensors = get<QComboBox>("sensorFile", tool);
    ASSERT_EQ(sensors->count(), 7);
    choose(sensors, 2);
    write(get<QDoubleSpinBox>("aspectStep", tool)->findChild<QLineEdit*>(), "90");
    write(get<QDoubleSpinBox>("backgroundTemperature", tool)->findChild<QLineEdit*>(), "290");
    choose(get<QComboBox>("criterion", tool), 1);
    get<QPushButton>("run", tool)->click();
    ASSERT_TRUE(test::waitUntil([&] { return workbench.results().size() == 1; }, 120.0));
    ASSERT_TRUE(settled());
    walk.step("The plot has the range, and on request what was found there; the notes below say "
              "where the method does not hold.");
    auto* quantity = get<QComboBox>("quantity", tool);
    EXPECT_EQ(quantity->currentData().toString(), "detection_range");
    choose(quantity, quantity->findData("cycles"));
    const PolarData& shown = tool->plot().polar()->data();
    ASSERT_EQ(shown.curves.size(), 1u);
    ASSERT_EQ(shown.curves.front().y.size(), 4u);
    EXPECT_NEAR(shown.curves.front().y.front(), 0.75, 1e-3);
    EXPECT_FALSE(get<QLabel>("summary", tool)->text().isEmpty());
    walk.step("A point has a Threshold by a ratio or a rate of false alarms, a probability, and "
              "Clutter of the background; a shape may have hot parts Left out. Sensitivity of the "
              "range adds what it depends on most.");
    EXPECT_TRUE(get<QWidget>("leftOut", tool)->isVisibleTo(tool));
    choose(get<QComboBox>("criterion", tool), 0);
    choose(get<QComboBox>("thresholdBy", tool), 1);
    choose(get<QComboBox>("clutterBy", tool), 1);
    get<QCheckBox>("sensitivity", tool)->setChecked(true);
    EXPECT_TRUE(get<QLineEdit>("command", tool)->text().contains("--clutter 0.1 --sensitivity"));
    walk.step(
        "The list below the criterion chooses a table and ball over azimuth and elevation in "
        "place of the rose, curves against wind, hour, band or paint, or the probability over "
        "range.");
    auto* tableOf = get<QComboBox>("tableOf", tool);
    choose(tableOf, 1);
    EXPECT_TRUE(get<QLineEdit>("command", tool)->text().contains("--cases directions"));
    choose(tableOf, tableOf->count() - 1);
    get<QLineEdit>("ranges", tool)->setText("1000, 5000");
    EXPECT_TRUE(get<QLineEdit>("command", tool)->text().contains("--ranges 1000,5000"));
    EXPECT_TRUE(told.isEmpty()) << said();
}

TEST_F(AnalysesWalkTest, SensorChain) {
    test::GuideWalk walk("analyses", "Sensor chain");
    walk.step("Tools → Sensor chain… shows what each stage of a sensor does.");
    act("sensorChain");
    auto* tool = page<SensorPage>();
    ASSERT_NE(tool, nullptr);
    walk.step("Choose a sensor, and what it looks at: a test pattern, or an image among the "
              "results.");
    choose(get<QComboBox>("sensorFile", tool), 1);
    EXPECT_EQ(get<QComboBox>("stageScene", tool)->count(), 1) << "no image yet";
    ASSERT_TRUE(test::waitUntil([&] { return tool->pictures().has_value(); }, 60.0));
    walk.step("A click on Optics, Detector, Motion, Electronics or Chain plots its transfer "
              "functions, with the picture before and behind it.");
    get<StageCard>("stageOptics", tool)->click();
    EXPECT_EQ(tool->plot().cartesian()->data().curves.front().name, "diffraction");
    EXPECT_FALSE(get<PlanePane>("behind", tool)->plane().isEmpty());
    EXPECT_TRUE(told.isEmpty()) << said();
}

/// Of a box, whose sides tell themselves by their temperatures.
TEST_F(AnalysesWalkTest, DirectionsOfPolarPlots) {
    test::GuideWalk walk("analyses", "Directions of polar plots");
    openCopy("box", {{"render.bounces", "0"},
                     {"polar.step", "90"},
                     {"camera.elevation", "0"},
                     {"camera.range", "1000"},
                     {"target.altitude", "2000"}});
    // What each side gives, seen straight on.
    const auto seen = [&](const char* azimuth, const char* elevation) {
        AnalysisData data =
            AnalysisData::of(workbench.project(), AnalysisKind::range, workbench.settings());
        data.settings.set("camera.azimuth", azimuth);
        data.settings.set("camera.elevation", elevation);
        data.settings.set("range.from", "1000");
        data.settings.set("range.to", "1001");
        data.settings.set("range.points", "2");
        return runDirectly(data).table.find("intensity")->values.front();
    };
    const double nose = seen("0", "0"), starboard = seen("90", "0"), tail = seen("180", "0"),
                 port = seen("270", "0"), belly = seen("0", "-90"), top = seen("0", "90");
    const auto goes = [&](const char* sweep, const std::vector<double>& wanted) {
        workbench.set("polar.type", sweep);
        runAnalysis("polar");
        const auto& is = table().find("intensity")->values;
        ASSERT_EQ(is.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(is[i], wanted[i], 0.01 * std::abs(wanted[i])) << sweep << 90 * i;
        }
    };
    walk.step("camera azimuth | in front of the nose | clockwise, seen from above the model; view "
              "offset is the elevation");
    goes("camera-azimuth", {nose, starboard, tail, port});
    EXPECT_TRUE(window->currentPage()->polarPlot()->data().clockwise);
    walk.step("camera elevation | in front of the nose | the camera moves down first, below the "
              "belly, then behind");
    goes("camera-elevation", {nose, belly, tail, top});
    walk.step("model yaw | the nose points at the camera, pitch and roll 0 | the model turns "
              "counter-clockwise, seen from above");
    goes("model-yaw", {nose, starboard, tail, port});

    walk.step("The direction is written on each plot. From and To cut a sector out of the turn; "
              "Last view offset adds curves at several elevations.");
    EXPECT_FALSE(window->currentPage()->polarPlot()->data().directionNote.isEmpty());
    workbench.set("polar.type", "camera-azimuth");
    bool isGrey = false;
    onDialog = [&](QDialog& dialog) {
        const auto* said = dialog.findChild<QLabel*>("ignored");
        EXPECT_NE(said, nullptr);
        EXPECT_TRUE(said->text().contains("levation")) << said->text().toStdString();
        const auto* field = dialog.findChild<QWidget*>("camera.elevation");
        isGrey = field->toolTip() == "Not used by this analysis" &&
                 field->palette().color(QPalette::Text) != dialog.palette().color(QPalette::Text);
    };
    workbench.set("polar.from", "0");
    workbench.set("polar.to", "90");
    workbench.set("polar.offset", "0");
    workbench.set("polar.offsetTo", "30");
    workbench.set("polar.offsetStep", "15");
    runAnalysis("polar");
    onDialog = nullptr;
    EXPECT_TRUE(isGrey);
    EXPECT_EQ(window->currentPage()->polarPlot()->data().curves.size(), 3U);
    EXPECT_EQ(window->currentPage()->polarPlot()->data().curves.front().x.back(), 90.0);
}

TEST_F(AnalysesWalkTest, Results) {
    test::GuideWalk walk("analyses", "Results");
    openSample();
    runAnalysis("range");
    workbench.set("sensor.band", "8-12");
    runAnalysis("range");
    runAnalysis("image");
    runAnalysis("image");
    walk.step("see it again | double click, Show");
    tabs()->setCurrentIndex(0);
    selectResults({0});
    emit list()->itemActivated(list()->item(0));
    EXPECT_EQ(window->currentPage()->resultIds(), QList<int>{workbench.results()[0].id});
    walk.step("overlay several | select them, Overlay");
    selectResults({0, 1});
    act("overlayResultsAction");
    EXPECT_EQ(window->currentPage()->cartesianPlot()->data().curves.size(), 2U);
    walk.step("subtract two | select them, Difference: A − B, or in per cent, on the points both "
              "have");
    act("subtractResultsAction");
    const auto& difference = workbench.results().back().data->table;
    EXPECT_DOUBLE_EQ(difference.find("difference_contrast_intensity")->values[2],
                     workbench.results()[0].data->table.find("contrast_intensity")->values[2] -
                         workbench.results()[1].data->table.find("contrast_intensity")->values[2]);
    bool isInPerCent = false;
    for (const auto& column : difference.columns()) {
        isInPerCent |= column.unit == "%" || column.key.find("relative") != std::string::npos;
    }
    EXPECT_TRUE(isInPerCent);
    walk.step("compare two images | select them, Difference");
    selectResults({2, 3});
    act("subtractResultsAction");
    EXPECT_NE(page<ComparisonWindow>(), nullptr);
    walk.step("run it once more | Run again, Edit and run again…");
    selectResults({0});
    act("rerunResultAction");
    ASSERT_TRUE(settled());
    EXPECT_EQ(table(), workbench.results()[0].data->table);
    onDialog = [](QDialog& dialog) {
        auto* points = dialog.findChild<QComboBox*>("range.points")->lineEdit();
        points->selectAll();
        QTest::keyClicks(points, "3");
    };
    selectResults({0});
    act("editResultAction");
    onDialog = nullptr;
    ASSERT_TRUE(settled());
    EXPECT_EQ(table().rowCount(), 3U);
    walk.step(
        "know how it was made | Show command line…: the command, all inputs, and how long each "
        "stage of the run took");
    onDialog = [](QDialog& dialog) {
        EXPECT_TRUE(dialog.findChild<QPlainTextEdit*>("commandLine")
                        ->toPlainText()
                        .startsWith("smat-batch range"));
        auto* inputs = dialog.findChild<QTreeWidget*>("provenance");
        EXPECT_GT(inputs->topLevelItemCount(), 8);
        EXPECT_FALSE(inputs->findItems("Time: ", Qt::MatchStartsWith).isEmpty());
    };
    act("showCommandLineAction");
    walk.step("give it a name, or notes | Rename, Notes…");
    selectResults({0});
    list()->setFocus();
    act("renameResultAction");
    ASSERT_NO_FATAL_FAILURE(test::typeNewName(*list(), "cold morning"));
    EXPECT_EQ(workbench.results()[0].title, "cold morning");
    onDialog = [](QDialog& dialog) {
        QTest::keyClicks(dialog.findChild<QPlainTextEdit*>("notes"), "paint of 2011");
    };
    act("annotateResultAction");
    onDialog = nullptr;
    walk.step("save it | File → Save project (Ctrl+S): all results of the list are stored with the "
              "project");
    const auto count = workbench.results().size();
    EXPECT_EQ(get<QDockWidget>("resultsDock")->windowTitle(), QString("Results (%1*)").arg(count));
    trigger("saveProject");
    EXPECT_EQ(get<QDockWidget>("resultsDock")->windowTitle(), "Results");
    walk.step("export it | Save result…; Open saved result… makes it a result again");
    selectResults({0});
    for (const char* name : {"r.csv", "r.json"}) {
        chosen = path(name);
        act("saveResultAction");
        act("openResultAction");
        EXPECT_EQ(table(), workbench.results()[0].data->table) << name;
        EXPECT_FALSE(table().provenance.entries.empty()) << name;
        selectResults({0});
    }
    walk.step(
        "see it beside another | double click its tab, or Open in its own window in the menu of "
        "the tab");
    auto* shown = window->currentPage();
    QTest::mouseDClick(tabs()->tabBar(), Qt::LeftButton, {},
                       tabs()->tabBar()->tabRect(tabs()->indexOf(shown)).center());
    QTest::qWait(30);
    EXPECT_TRUE(tabs()->findChild<FloatingPages*>()->isDetached(shown));

    walk.step("Files are EXR (32-bit float), CSV or JSON, each with all inputs as provenance.");
    selectResults({2});
    chosen = path("i.exr");
    act("saveResultAction");
    const auto exr = irsg::readExr(folder / "i.exr");
    EXPECT_EQ(exr.primary().values, workbench.results()[2].data->image.primary().values);
    EXPECT_TRUE(exr.attributes.contains("command"));

    walk.step("are stored in a folder beside the project, ship.results beside ship.smat, and are "
              "available again when it is opened");
    trigger("saveProject");
    EXPECT_TRUE(std::filesystem::is_directory(folder / "ship.results"));
    const auto all = workbench.results().size();
    const auto reopen = [&] {
        workbench.undoStack().clear();
        ASSERT_TRUE(opens(folder / "ship.smat"));
        ASSERT_TRUE(test::waitUntil([&] { return !workbench.resultStore().isReading(); }));
        QTest::qWait(30);
    };
    reopen();
    ASSERT_EQ(workbench.results().size(), all);
    EXPECT_EQ(workbench.results()[0].title, "cold morning");
    EXPECT_EQ(workbench.results()[0].notes, "paint of 2011");
    selectResults({0, 1});
    act("overlayResultsAction");
    EXPECT_EQ(window->currentPage()->cartesianPlot()->data().curves.size(), 2U);
    selectResults({0});
    act("rerunResultAction");
    ASSERT_TRUE(settled());
    EXPECT_EQ(table().columns(), workbench.results()[0].data->table.columns());
    answer = -1;
    asked.clear();
    EXPECT_FALSE(window->close()) << "closing asks";
    EXPECT_EQ(asked.size(), 1);
    workbench.removeResult(workbench.results()[1].id);
    EXPECT_TRUE(std::filesystem::exists(folder / "ship.results/002-range.result"));
    trigger("saveProject");
    EXPECT_FALSE(std::filesystem::exists(folder / "ship.results/002-range.result"));
    EXPECT_TRUE(told.isEmpty()) << said();
    std::filesystem::remove_all(folder / "ship.results");
    reopen();
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told.front().contains("ship.results")) << said();
    told.clear();
    runAnalysis("range");
    answer = 1;
}

} // namespace
} // namespace smat::gui

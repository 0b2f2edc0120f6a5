#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolButton>

#include "gui/analysis/JobBar.h"
#include "gui/analysis/ResultPage.h"
#include "gui/plot/CartesianPlot.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/GatedSource.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

/// Results that outlive the window they came from.
class ResultCacheTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        if (!IsSkipped()) {
            openSample();
        }
    }
    QListWidget* list() const { return window->findChild<QListWidget*>("resultList"); }
    std::filesystem::path results() const { return folder / "ship.results"; }
    /// The project in a fresh window, as after a start of the program.
    void reopen() {
        workbench.undoStack().clear();
        ASSERT_TRUE(opens(folder / "ship.smat"));
        ASSERT_TRUE(waitForResults());
    }
    bool waitForResults() {
        return test::waitUntil([this] { return !workbench.resultStore().isReading(); });
    }
    void save() {
        trigger("saveProject");
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    }
};

TEST_F(ResultCacheTest, ComeBackWithTheProject) {
    runAnalysis("range");
    runAnalysis("image");
    workbench.resultStore().rename(1, "cold morning");
    list()->clearSelection();
    list()->item(0)->setSelected(true);
    onDialog = [](QDialog& dialog) {
        if (auto* text = dialog.findChild<QPlainTextEdit*>("notes")) {
            QTest::keyClicks(text, "paint of 2011");
        }
    };
    window->findChild<QAction*>("annotateResultAction")->trigger();
    onDialog = {};
    EXPECT_EQ(window->findChild<QDockWidget*>("resultsDock")->windowTitle(), "Results (2*)");
    EXPECT_TRUE(window->isWindowModified());
    save();
    EXPECT_FALSE(window->isWindowModified());
    EXPECT_EQ(workbench.resultStore().unsavedCount(), 0);
    EXPECT_EQ(loadProject(folder / "ship.smat").results, "ship.results");

    const ResultEntry range = workbench.results()[0], image = workbench.results()[1];
    reopen();
    EXPECT_TRUE(asked.isEmpty()) << asked.join('\n').toStdString();
    ASSERT_EQ(workbench.results().size(), 2U);
    const ResultEntry& again = workbench.results()[0];
    EXPECT_EQ(again.id, 1);
    EXPECT_EQ(again.title, "cold morning");
    EXPECT_EQ(again.notes, "paint of 2011");
    EXPECT_EQ(again.data->table, range.data->table);
    EXPECT_EQ(again.madeAt.toSecsSinceEpoch(), range.madeAt.toSecsSinceEpoch());
    EXPECT_EQ(workbench.results()[1].data->image.channels, image.data->image.channels);
    // They are in the list, and nobody asked for their pages.
    EXPECT_EQ(list()->count(), 2);
    EXPECT_EQ(window->findChild<QTabWidget*>("tabs")->count(), 1);
    EXPECT_TRUE(list()->item(0)->toolTip().contains("paint of 2011"));

    // Run again, overlaid, and numbered behind the last.
    list()->clearSelection();
    list()->item(0)->setSelected(true);
    window->findChild<QAction*>("rerunResultAction")->trigger();
    ASSERT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }));
    QTest::qWait(30);
    ASSERT_EQ(workbench.results().size(), 3U);
    EXPECT_EQ(workbench.results()[2].id, 3);
    EXPECT_EQ(workbench.results()[2].data->table.columns(), range.data->table.columns());
    list()->clearSelection();
    list()->item(0)->setSelected(true);
    list()->item(2)->setSelected(true);
    window->findChild<QAction*>("overlayResultsAction")->trigger();
    ASSERT_NE(window->currentPage(), nullptr);
    EXPECT_EQ(window->currentPage()->cartesianPlot()->data().curves.size(), 2U);
    test::keepScreenshot(*window, "results-reopened");
    answer = 1;
}

TEST_F(ResultCacheTest, QuittingAsksAndSavesDiscardsOrStays) {
    runAnalysis("range");
    answer = -1;
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked, QStringList{"Unsaved changes"});
    EXPECT_FALSE(std::filesystem::exists(results()));
    answer = 0;
    EXPECT_TRUE(window->close());
    EXPECT_TRUE(std::filesystem::exists(results() / "001-range.result"));
    // Nothing is unsaved any more.
    asked.clear();
    EXPECT_TRUE(window->close());
    EXPECT_TRUE(asked.isEmpty());
}

TEST_F(ResultCacheTest, AnotherProjectHasItsOwn) {
    runAnalysis("range");
    const auto other = folder / "other";
    std::filesystem::create_directory(other);
    const auto second = test::writeSampleProject(other);
    answer = -1;
    EXPECT_FALSE(window->open(second));
    EXPECT_EQ(workbench.results().size(), 1U);
    answer = 1;
    ASSERT_TRUE(opens(second));
    EXPECT_TRUE(workbench.results().empty());
    EXPECT_EQ(window->findChild<QTabWidget*>("tabs")->count(), 1);
    EXPECT_FALSE(std::filesystem::exists(results()));
}

TEST_F(ResultCacheTest, AFolderThatWasMovedIsSaidAndNothingElseBreaks) {
    runAnalysis("range");
    save();
    // While the project is open: written again when it is saved.
    std::filesystem::remove_all(results());
    workbench.set("camera.azimuth", "5");
    trigger("saveProject");
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told.front().contains("1  Range")) << told.front().toStdString();
    EXPECT_TRUE(std::filesystem::exists(results() / "001-range.result"));
    told.clear();
    // While it is not.
    std::filesystem::remove_all(results());
    reopen();
    QTest::qWait(20);
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told.front().contains("ship.results")) << told.front().toStdString();
    EXPECT_TRUE(workbench.results().empty());
    EXPECT_TRUE(workbench.hasProject());
}

TEST_F(ResultCacheTest, OnesThatAreRemovedGoWhenTheProjectIsSaved) {
    runAnalysis("range");
    save();
    workbench.removeResult(1);
    EXPECT_EQ(workbench.resultStore().unsavedCount(), 1);
    EXPECT_TRUE(std::filesystem::exists(results() / "001-range.result"));
    save();
    EXPECT_FALSE(std::filesystem::exists(results() / "001-range.result"));
    EXPECT_EQ(loadProject(folder / "ship.smat").results, "");
}

TEST_F(ResultCacheTest, GoAlongToAnotherName) {
    runAnalysis("range");
    save();
    chosen = QString::fromStdString((folder / "boat.smat").string());
    trigger("saveProjectAs");
    EXPECT_TRUE(std::filesystem::exists(folder / "boat.results" / "001-range.result"));
    EXPECT_TRUE(std::filesystem::exists(results() / "001-range.result"));
    EXPECT_EQ(loadProject(folder / "boat.smat").results, "boat.results");
    EXPECT_EQ(workbench.resultStore().unsavedCount(), 0);
}

/// The line of jobs, in a window whose drawings a test lets through.
class JobLineTest : public test::WindowFixture {
  protected:
    ~JobLineTest() override { gate.drawings(1 << 30); }
    test::Gate gate;
    Workbench bench{[this] { return test::gatedDoor(gate); }};
};

TEST_F(JobLineTest, SeveralWaitAndAreSeenWhicheverDockIsInFront) {
    MainWindow shown(bench, people);
    shown.resize(1280, 800);
    shown.show();
    ASSERT_TRUE(shown.open(test::writeSampleProject(folder)));
    shown.findChild<QDockWidget*>("databaseDock")->raise();
    const auto start = [&](const char* name) {
        AnalysisData data =
            AnalysisData::of(bench.project(), AnalysisKind::polar, bench.settings());
        data.name = name;
        return bench.start(data);
    };
    gate.drawings(1);
    start("first");
    start("second");
    const int third = start("third");
    start("fourth");
    ASSERT_TRUE(test::waitUntil([this] { return gate.begun == 2; }));
    QTest::qWait(60); // states that follow each other at once are not all told
    gate.drawings(1);
    ASSERT_TRUE(test::waitUntil([this] { return gate.begun == 3; }));
    QTest::qWait(150);
    auto* bar = shown.findChild<JobBar*>();
    EXPECT_TRUE(bar->isVisible());
    EXPECT_EQ(bar->findChild<QLabel*>("jobTitle")->text(), "first");
    EXPECT_EQ(bar->findChild<QLabel*>("jobDetail")->text(), "2 of 12");
    // In which the renderer is at a stage of its own.
    EXPECT_EQ(bar->findChild<QLabel*>("jobStage")->text(), "gate: waiting, 25 %");
    EXPECT_TRUE(bar->findChild<QLabel*>("jobTimes")->text().contains("left"));
    auto* line = bar->findChild<QToolButton*>("waitingJobs");
    EXPECT_EQ(line->text(), "3 waiting");
    EXPECT_LE(bar->geometry().right(), shown.statusBar()->width());
    test::keepScreenshot(shown, "jobs-waiting");

    // One leaves the line by its menu.
    auto* menu = bar->findChild<QMenu*>("waitingMenu");
    emit menu->aboutToShow();
    ASSERT_EQ(menu->actions().size(), 3);
    EXPECT_EQ(menu->actions().at(1)->text(), "third");
    menu->actions().at(1)->trigger();
    EXPECT_FALSE(bench.jobs().holds(third));
    EXPECT_EQ(line->text(), "2 waiting");

    // A cancel is of the one that runs; the next begins.
    bar->findChild<QToolButton*>("cancelJob")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !bench.results().empty(); }));
    gate.drawings(1 << 30);
    ASSERT_TRUE(test::waitUntil([this] { return !bench.isRunning(); }));
    ASSERT_EQ(bench.results().size(), 3U);
    EXPECT_EQ(bench.results()[0].title, "1  first (partial)");
    EXPECT_EQ(bench.results()[1].title, "2  second");
    EXPECT_EQ(bench.results()[2].title, "3  fourth");
    EXPECT_FALSE(bar->isVisible());
}

} // namespace
} // namespace smat::gui

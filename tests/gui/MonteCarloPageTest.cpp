#include "gui/tools/MonteCarloPage.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include "gui/analysis/MonteCarloPlots.h"
#include "gui/analysis/RankingBars.h"
#include "gui/plot/CartesianPlot.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/support/TextFile.h"
#include "tests/gui/SmallDisk.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

using namespace test;

/// Holds drawings until it is opened.
struct Gate {
    std::atomic<bool> open = false;
    std::atomic<int> waiting = 0; ///< drawings that came to it
};

/// The renderer, whose drawings take as long as a gate is closed.
RenderDoor waitingDoor(Gate& gate) {
    RenderDoor door = openRenderDoor();
    door.begin = [&gate, begin = door.begin](const irsg::Scene& scene, const irsg::SensorView& view,
                                             const irsg::Outputs& outputs) {
        if (outputs.hasReports() && !outputs.hasImage()) {
            if (!gate.open) {
                ++gate.waiting;
            }
            while (!gate.open) {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
        }
        return begin(scene, view, outputs);
    };
    return door;
}

/// A project of the sample aircraft with scaling files, in a folder of its own.
class MonteCarloPageTest : public ::testing::Test {
  protected:
    void SetUp() override {
        const std::filesystem::path samples = std::filesystem::path(SMAT_SOURCE_DIR) / "samples";
        Project project;
        project.title = "Turboprop";
        project.models = {
            {.file = folder / "turboprop4.flt", .database = folder / "turboprop4.sigdb"}};
        for (const char* name : {"turboprop4.flt", "turboprop4.sigdb"}) {
            std::filesystem::copy(samples / "turboprop4" / name, folder / name);
        }
        for (const auto kind : {irsg::ScalingKind::temperature, irsg::ScalingKind::emissivity}) {
            std::filesystem::copy(
                irsg::scalingFile(samples / "turboprop4" / "turboprop4.flt", kind),
                irsg::scalingFile(folder / "turboprop4.flt", kind));
        }
        project.settings.set("sensor.fov", "4");
        project.settings.set("state.power", "0.7");
        project.settings.set("polar.step", "30");
        project.settings.set("render.antialiasing", "3");
        project.settings.set("render.lightError", "0.1");
        project.analyses = {{.name = "turn", .kind = AnalysisKind::polar},
                            {.name = "picture", .kind = AnalysisKind::image}};
        file = folder / "turboprop4.smat";
        saveProject(project, file);
    }
    /// Runs and cancels while the first drawing waits for the gate.
    void cancelWhileDrawing(Gate& gate) {
        gate_ = &gate;
        makePage();
        get<QSpinBox>("samples")->setValue(2048);
        get<QCheckBox>("ranks")->setChecked(false);
        get<QPushButton>("run")->click();
        EXPECT_TRUE(waitUntil([&] { return gate.waiting > 0; }));
        get<QPushButton>("cancel")->click();
        // The drawing has not ended, and the page is free again.
        EXPECT_TRUE(waitUntil([this] { return !page->isRunning(); }));
    }
    void makePage() {
        workbench.open(file);
        QObject::connect(&workbench, &Workbench::jobFailed,
                         [this](const QStringList& sentences, bool) { told += sentences; });
        Dialogs dialogs;
        dialogs.tell = [this](QWidget*, const QString&, const QStringList& sentences) {
            told += sentences;
        };
        page = std::make_unique<MonteCarloPage>(workbench, dialogs);
        page->resize(1280, 860);
        page->show();
        QTest::qWait(30);
    }
    template <typename Widget>
    Widget* get(const char* name) {
        auto* found = page->findChild<Widget*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    void runToTheEnd() {
        get<QPushButton>("run")->click();
        ASSERT_TRUE(page->isRunning());
        ASSERT_TRUE(waitUntil([this] { return !page->isRunning(); }, 120.0));
        QTest::qWait(30);
    }

    std::filesystem::path folder = freshFolder("montecarlo");
    std::filesystem::path file;
    Gate* gate_ = nullptr;
    Workbench workbench{
        [this] { return gate_ != nullptr ? waitingDoor(*gate_) : openRenderDoor(); }};
    QStringList told;
    std::unique_ptr<MonteCarloPage> page;
};

} // namespace

TEST_F(MonteCarloPageTest, AFullDiskLeavesOlderFilesWhole) {
    const SmallDisk disk("montecarlo-disk");
    if (!disk.isThere()) {
        GTEST_SKIP() << "a small disk can be mounted by root alone";
    }
    makePage();
    get<QSpinBox>("samples")->setValue(16);
    get<QCheckBox>("ranks")->setChecked(false);
    runToTheEnd();
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    const QStringList filters = page->exportFilters();
    ASSERT_EQ(filters.size(), 7);
    for (const QString& filter : filters) {
        const std::string name = "bands" + filter.section('*', -1).chopped(1).toStdString();
        SCOPED_TRACE(name);
        writeTextFile(disk / name, "older");
        disk.fill();
        EXPECT_THROW(page->exportTo(disk / name), irsg::InputError);
        EXPECT_EQ(readTextFile(disk / name), "older");
        disk.empty();
        page->exportTo(disk / name);
        EXPECT_GT(readTextFile(disk / name).size(), 500U);
        for (const auto& entry : std::filesystem::directory_iterator(disk.place())) {
            EXPECT_FALSE(entry.path().string().ends_with(".part"));
            std::filesystem::remove(entry);
        }
    }
}

TEST_F(MonteCarloPageTest, ShowsBandsHistogramAndRankingOfTheSampleAircraft) {
    makePage();
    EXPECT_EQ(get<QComboBox>("analysis")->itemText(0), "turn (polar)");
    EXPECT_EQ(get<QComboBox>("analysis")->findText("picture (image)"), -1);
    EXPECT_EQ(get<QTreeWidget>("scales")->topLevelItemCount(), 15);
    EXPECT_TRUE(get<QTreeWidget>("scales")->topLevelItem(0)->text(0).contains(" ("))
        << get<QTreeWidget>("scales")->topLevelItem(0)->text(0).toStdString();
    EXPECT_FALSE(get<QPushButton>("writeScalingFiles")->isVisible());
    get<QSpinBox>("samples")->setValue(512);
    get<QSpinBox>("pairs")->setValue(256);
    get<QSpinBox>("subpixelShifts")->setValue(2);
    runToTheEnd();
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    const MonteCarloData& data = page->plots().data();
    EXPECT_EQ(data.realisations(), 512u);
    EXPECT_EQ(data.abscissae.size(), 12u);
    // Nominal, mean and five percentiles; four scales are fixed or have no effect.
    EXPECT_EQ(page->plots().bands()->data().curves.size(), 7u);
    EXPECT_EQ(get<RankingBars>("rankingBars")->bars().size(), 11u);
    EXPECT_TRUE(get<QLabel>("summary")->text().contains("Draws: 512"));
    get<QSlider>("histogramPlace")->setValue(3);
    EXPECT_EQ(get<QLabel>("histogramPlaceText")->text(), "90°");

    applyTheme(*qApp, ThemeMode::light);
    QTest::qWait(50);
    keepScreenshot(*page, "montecarlo-light");
    applyTheme(*qApp, ThemeMode::dark);
    QTest::qWait(50);
    keepScreenshot(*page, "montecarlo-dark");
    applyTheme(*qApp, ThemeMode::light);
    EXPECT_EQ(page->plots().bands()->data().curves.size(), 7u);

    for (const char* name : {"mc.csv", "mc-ranking.csv", "mc.json", "mc.draws.csv", "mc.draws.json",
                             "mc.svg", "mc.pdf", "mc.png"}) {
        if (std::string(name) != "mc-ranking.csv") {
            page->exportTo(folder / name);
        }
        EXPECT_GT(std::filesystem::file_size(folder / name), 100u) << name;
    }
}

TEST_F(MonteCarloPageTest, SaysTheCommandThatDoesTheSame) {
    makePage();
    get<QSpinBox>("samples")->setValue(2048);
    get<QSpinBox>("seed")->setValue(7);
    get<QCheckBox>("stops")->setChecked(true);
    get<QComboBox>("sequence")->setCurrentIndex(1);
    const QString command = get<QLineEdit>("command")->text();
    for (const char* part :
         {"smat-batch montecarlo /", "--analysis turn", "--samples 2048 --seed 7",
          "--sequence plain", "--standard-error 0.001", "--ranking"}) {
        EXPECT_TRUE(command.contains(part)) << part << " in " << command.toStdString();
    }
    // What was changed in the window, and an analysis that has no name in the file.
    workbench.set("state.mach", "0.4");
    get<QComboBox>("analysis")->setCurrentIndex(get<QComboBox>("analysis")->count() - 1);
    const QString changed = get<QLineEdit>("command")->text();
    for (const char* part : {"--kind ", "--set state.mach=0.4"}) {
        EXPECT_TRUE(changed.contains(part)) << part << " in " << changed.toStdString();
    }
}

TEST_F(MonteCarloPageTest, CountsEditsOfTheDatabaseThatAreNotSaved) {
    makePage();
    get<QSpinBox>("samples")->setValue(64);
    get<QSpinBox>("subpixelShifts")->setValue(1);
    get<QCheckBox>("ranks")->setChecked(false);
    EXPECT_FALSE(get<QLabel>("unsavedNote")->isVisible());
    runToTheEnd();
    const MonteCarloData saved = page->plots().data();
    EXPECT_EQ(saved.analysis.table.provenance.value("database"), "turboprop4.sigdb");

    // The pipes 100 K hotter, in memory alone.
    workbench.database().edit("heat", [](irsg::SignatureDatabase& database) {
        database.temperatures.at(5).terms.base_K += 100.0;
    });
    EXPECT_TRUE(get<QLabel>("unsavedNote")->isVisible());
    EXPECT_TRUE(get<QLabel>("unsavedNote")->text().contains("turboprop4.sigdb"))
        << get<QLabel>("unsavedNote")->text().toStdString();
    runToTheEnd();
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    const MonteCarloData edited = page->plots().data();
    EXPECT_EQ(edited.analysis.table.provenance.value("database"),
              "turboprop4.sigdb, with edits that are not saved");
    const std::size_t behind = edited.nearest(180.0);
    EXPECT_GT(edited.nominal[behind], 1.05 * saved.nominal[behind]);

    // Saved, it is the same numbers and no note; without the edit it is what it was.
    workbench.database().save();
    EXPECT_FALSE(get<QLabel>("unsavedNote")->isVisible());
    runToTheEnd();
    EXPECT_EQ(page->plots().data().values, edited.values);
    workbench.undoStack().undo();
    runToTheEnd();
    EXPECT_EQ(page->plots().data().values, saved.values);
    workbench.database().discard();
}

TEST_F(MonteCarloPageTest, RefusesFieldsThatSayNothingUsable) {
    makePage();
    EXPECT_TRUE(get<QPushButton>("run")->isEnabled());
    for (const char* wrong : {"5, x", "50, 5", "5, 500"}) {
        get<QLineEdit>("percentiles")->setText(wrong);
        EXPECT_FALSE(get<QPushButton>("run")->isEnabled()) << wrong;
        EXPECT_TRUE(get<QLabel>("problem")->isVisible()) << wrong;
    }
    get<QLineEdit>("percentiles")->setText("10, 90");
    EXPECT_TRUE(get<QPushButton>("run")->isEnabled());
    EXPECT_FALSE(get<QLabel>("problem")->isVisible());
}

TEST_F(MonteCarloPageTest, WritesTheScalingFilesWhereThereAreNone) {
    for (const auto kind : {irsg::ScalingKind::temperature, irsg::ScalingKind::emissivity}) {
        std::filesystem::remove(irsg::scalingFile(folder / "turboprop4.flt", kind));
    }
    makePage();
    EXPECT_FALSE(get<QPushButton>("run")->isEnabled());
    EXPECT_TRUE(get<QPushButton>("writeScalingFiles")->isVisible());
    get<QPushButton>("writeScalingFiles")->click();
    EXPECT_TRUE(irsg::hasScalingFiles(folder / "turboprop4.flt"));
    EXPECT_GE(get<QTreeWidget>("scales")->topLevelItemCount(), 14);
    // All of them are 1 still: the run says so.
    runToTheEnd();
    EXPECT_TRUE(told.join(' ').contains("no scale that varies")) << told.join('\n').toStdString();
    keepScreenshot(*page, "montecarlo-empty");
}

TEST_F(MonteCarloPageTest, TakesTheNumbersThatARunTakes) {
    makePage();
    MonteCarloOptions options;
    for (const bool isMost : {false, true}) {
        const auto end = [&](const char* name) {
            const auto* box = get<QSpinBox>(name);
            return isMost ? box->maximum() : box->minimum();
        };
        options.samples = static_cast<std::size_t>(end("samples"));
        options.subpixelShifts = end("subpixelShifts");
        options.rankingPairs = static_cast<std::size_t>(end("pairs"));
        EXPECT_NO_THROW(options.check());
    }
    ++options.samples;
    EXPECT_THROW(options.check(), irsg::InputError) << "one more than the form takes";
}

TEST_F(MonteCarloPageTest, KeepsTheDrawsOfARunThatIsCancelled) {
    makePage();
    get<QSpinBox>("samples")->setValue(2'000'000);
    get<QSpinBox>("subpixelShifts")->setValue(1);
    get<QPushButton>("run")->click();
    EXPECT_FALSE(get<QPushButton>("run")->isEnabled());
    QTest::qWait(300);
    QElapsedTimer clock;
    clock.start();
    get<QPushButton>("cancel")->click();
    EXPECT_FALSE(get<QPushButton>("cancel")->isEnabled());
    ASSERT_TRUE(waitUntil([this] { return !page->isRunning(); }, 60.0));
    ASSERT_TRUE(waitUntil([this] { return page->plots().data().realisations() > 0; }, 60.0));
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_GE(page->plots().data().realisations(), 256u);
    EXPECT_EQ(page->plots().data().analysis.state, AnalysisState::partial);
    EXPECT_TRUE(get<QPushButton>("run")->isEnabled());
}

TEST_F(MonteCarloPageTest, AnswersACancelWhileADrawingTakesItsTime) {
    Gate gate;
    cancelWhileDrawing(gate);
    EXPECT_EQ(gate.waiting, 1);
    EXPECT_TRUE(get<QPushButton>("run")->isEnabled());
    EXPECT_FALSE(get<QPushButton>("cancel")->isEnabled());
    // What was drawn comes when it has ended.
    EXPECT_EQ(page->plots().data().realisations(), 0u);
    gate.open = true;
    ASSERT_TRUE(waitUntil([this] { return page->plots().data().realisations() > 0; }, 60.0));
    EXPECT_EQ(page->plots().data().analysis.state, AnalysisState::partial);
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(MonteCarloPageTest, RunsAgainWhileACancelledRunEndsByItself) {
    Gate gate;
    cancelWhileDrawing(gate);
    get<QSpinBox>("samples")->setValue(300);
    get<QPushButton>("run")->click();
    EXPECT_TRUE(page->isRunning());
    gate.open = true;
    ASSERT_TRUE(waitUntil([this] { return !page->isRunning(); }, 60.0));
    // The second run alone is heard of.
    EXPECT_EQ(page->plots().data().realisations(), 300u);
    EXPECT_EQ(page->plots().data().analysis.state, AnalysisState::complete);
}

TEST_F(MonteCarloPageTest, ARunIsAResultAndGoesOnWithoutItsPage) {
    makePage();
    get<QSpinBox>("samples")->setValue(300);
    get<QSpinBox>("subpixelShifts")->setValue(1);
    get<QCheckBox>("ranks")->setChecked(false);
    runToTheEnd();
    ASSERT_EQ(workbench.results().size(), 1U);
    ASSERT_NE(workbench.results().front().monteCarlo, nullptr);
    EXPECT_EQ(workbench.results().front().title, "1  Monte Carlo: turn");
    EXPECT_EQ(workbench.results().front().kind(), AnalysisKind::monteCarlo);
    EXPECT_EQ(workbench.results().front().monteCarlo->values, page->plots().data().values);
    get<QPushButton>("run")->click();
    page.reset();
    ASSERT_TRUE(waitUntil([this] { return !workbench.isRunning(); }, 60.0));
    ASSERT_EQ(workbench.results().size(), 2U);
    EXPECT_EQ(workbench.results()[1].monteCarlo->values, workbench.results()[0].monteCarlo->values);
}

TEST_F(MonteCarloPageTest, WaitsInLineBehindAnAnalysis) {
    Gate gate;
    gate_ = &gate;
    makePage();
    get<QSpinBox>("samples")->setValue(300);
    get<QCheckBox>("ranks")->setChecked(false);
    workbench.start(AnalysisData::of(workbench.project(), "turn"));
    ASSERT_TRUE(waitUntil([&] { return gate.waiting > 0; }));
    get<QPushButton>("run")->click();
    EXPECT_TRUE(page->isRunning());
    EXPECT_EQ(workbench.jobs().waiting().size(), 1U);
    // Taken out of the line, it never ran.
    get<QPushButton>("cancel")->click();
    EXPECT_FALSE(page->isRunning());
    EXPECT_TRUE(workbench.jobs().waiting().empty());
    EXPECT_TRUE(get<QPushButton>("run")->isEnabled());
    get<QPushButton>("run")->click();
    gate.open = true;
    ASSERT_TRUE(waitUntil([this] { return !page->isRunning(); }, 60.0));
    EXPECT_EQ(page->plots().data().realisations(), 300u);
    EXPECT_EQ(workbench.results().size(), 2U);
}

class MonteCarloMenu : public WindowFixture {};

TEST_F(MonteCarloMenu, OpensThePageAsATab) {
    openSample();
    auto* action = window->findChild<QAction*>("monteCarlo");
    ASSERT_NE(action, nullptr);
    action->trigger();
    QTest::qWait(30);
    EXPECT_NE(window->findChild<MonteCarloPage*>(), nullptr);
}

} // namespace smat::gui

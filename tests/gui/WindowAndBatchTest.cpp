#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <thread>
#include <utility>

#include <QLabel>
#include <QListWidget>
#include <QPixmapCache>
#include <QSemaphore>
#include <QTest>
#include <QThreadPool>
#include <nlohmann/json.hpp>

#include "gui/image/ComparisonWindow.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/cli/Program.h"
#include "tests/gui/GatedSource.h"
#include "tests/gui/ProcessCounts.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/HeldByContext.h"

namespace smat::gui {
namespace {

/// "smat-batch polar ship.smat --out polar.csv" without its first word.
std::vector<std::string> argumentsOf(const std::string& command) {
    std::istringstream words(command);
    std::vector<std::string> list;
    for (std::string word; words >> word;) {
        list.push_back(word);
    }
    list.erase(list.begin());
    return list;
}

class WindowAndBatchTest : public test::WindowFixture {
  protected:
    /// Runs an analysis of the project as it is now, and the command that its result names, and
    /// gives what both wrote.
    std::pair<std::string, std::string> byWindowAndByBatch(AnalysisKind kind) {
        const std::filesystem::path fromBatch = folder / "batch";
        std::filesystem::create_directories(fromBatch);
        runAnalysis(name(kind).c_str());
        const AnalysisData& data = *workbench.results().back().data;
        EXPECT_EQ(data.kind, kind);
        const std::string file = name(kind) + (kind == AnalysisKind::image ? ".exr" : ".csv");
        saveResult(data, folder / file);
        const auto ran = smat::test::smatBatch(argumentsOf(data.commandLine), fromBatch);
        EXPECT_EQ(ran.exitCode, 0) << data.commandLine << "\n" << ran.err;
        command = data.commandLine;
        return {smat::test::contentOf(folder / file), smat::test::contentOf(fromBatch / file)};
    }
    std::string command;
};

TEST_F(WindowAndBatchTest, EveryAnalysisEqualsItsCommandLineByteForByte) {
    openSample();
    // What the window changed of the project is in the command.
    workbench.set("camera.azimuth", "33.25");
    workbench.set("sensor.band", "8-12");
    workbench.set("render.background", "1.5");
    for (const AnalysisKind kind : allAnalysisKinds()) {
        const auto [ofTile, ofBatch] = byWindowAndByBatch(kind);
        EXPECT_GT(ofBatch.size(), 200U) << name(kind);
        EXPECT_TRUE(ofTile == ofBatch) << name(kind) << ": " << command;
    }
    // Another view gives other bytes.
    const std::string before = smat::test::contentOf(folder / "polar.csv");
    workbench.set("polar.offset", "5");
    runAnalysis("polar");
    saveResult(*workbench.results().back().data, folder / "polar.csv");
    EXPECT_FALSE(smat::test::contentOf(folder / "polar.csv") == before);
}

TEST_F(WindowAndBatchTest, TheCommandOfAComparisonGivesItsNumbers) {
    openSample();
    runAnalysis("image");
    workbench.set("camera.azimuth", "35");
    runAnalysis("image");
    const std::vector<int> ids{workbench.results()[0].id, workbench.results()[1].id};
    EXPECT_EQ(window->compareResults(ids[0], ids[1])->commandLine(), "");
    auto* list = window->findChild<QListWidget*>("resultList");
    for (const int row : {0, 1}) {
        list->clearSelection();
        list->setCurrentRow(row);
        chosen = QString::fromStdString((folder / (row == 0 ? "a.exr" : "b.exr")).string());
        trigger("saveResultAction");
    }
    auto* page = window->compareResults(ids[0], ids[1]);
    ASSERT_TRUE(test::waitUntil([&] { return page->comparison().has_value(); }));
    const auto ran =
        smat::test::smatBatch(argumentsOf(page->commandLine().toStdString() + " --json"), folder);
    ASSERT_EQ(ran.err, "") << page->commandLine().toStdString();
    const auto told = nlohmann::json::parse(ran.out)["comparisons"][0];
    EXPECT_NE(page->comparison()->meanError, 0.0);
    EXPECT_DOUBLE_EQ(told["mean_error"].get<double>(), page->comparison()->meanError);
}

TEST_F(WindowAndBatchTest, EveryWayToComputeEqualsItsCommandLineByteForByte) {
    struct Row {
        AnalysisKind kind;
        std::vector<std::pair<const char*, std::string>> set;
    };
    openSample();
    const std::string air =
        SMAT_SOURCE_DIR "/resources/atmospheres/midlatitude-summer-rural-23km.xml";
    const std::vector<Row> rows = {
        {AnalysisKind::image, {}},
        {AnalysisKind::image, {{"environment.atmospheres", air}}},
        {AnalysisKind::image, {{"environment.atmospheres", air}, {"sensor.mode", "ck"}}},
        {AnalysisKind::image, {{"image.truthLayers", "true"}}},
        {AnalysisKind::image, {{"scaling.use", "true"}, {"scaling.seed", "7"}}},
        {AnalysisKind::image, {{"image.quantity", "apparent-temperature"}}},
        {AnalysisKind::polar, {}},
        {AnalysisKind::polar, {{"polar.type", "camera-elevation"}, {"target.altitude", "2000"}}},
        {AnalysisKind::polar, {{"polar.type", "model-yaw"}}},
        {AnalysisKind::polar, {{"scaling.use", "true"}, {"scaling.seed", "7"}}}};
    const Settings asOpened = workbench.settings();
    std::vector<std::string> seen;
    for (const Row& row : rows) {
        std::string words = name(row.kind);
        Settings settings = asOpened;
        for (const auto& [key, text] : row.set) {
            settings.set(key, text);
            words += std::string(" ").append(key).append("=").append(text);
        }
        workbench.set(settings);
        const auto [ofTile, ofBatch] = byWindowAndByBatch(row.kind);
        EXPECT_GT(ofBatch.size(), 200U) << words;
        EXPECT_TRUE(ofTile == ofBatch) << words << ": " << command;
        // Each way has bytes of its own: none of these settings was lost on the way.
        EXPECT_EQ(std::ranges::count(seen, ofTile), 0) << words;
        seen.push_back(ofTile);
    }
}

TEST(ProcessCountsTest, CountThreadsButThoseOfPools) {
    // What the first wait and the first pool of a process open for good is open before.
    const auto fill = [](QThreadPool& pool, QSemaphore& leave) {
        pool.setMaxThreadCount(3);
        for (int i = 0; i < 3; ++i) {
            pool.start([&leave] { leave.acquire(); });
        }
        EXPECT_TRUE(test::waitUntil([&] { return pool.activeThreadCount() == 3; }));
    };
    QSemaphore leave;
    {
        QThreadPool first;
        fill(first, leave);
        leave.release(3);
    }
    // A thread that has ended is in the lists a moment longer, without its name: what counts is
    // what stays the same.
    smat::test::ProcessCounts before = smat::test::processCounts();
    for (int same = 0; same < 10;) {
        QTest::qWait(20);
        const smat::test::ProcessCounts now = smat::test::processCounts();
        same = now.threads == before.threads && now.files == before.files ? same + 1 : 0;
        before = now;
    }
    QThreadPool pool;
    fill(pool, leave);
    // A thread begins before it has its name, and has its name before it opens its file.
    const auto holds = [&before](int threads, int files) {
        const smat::test::ProcessCounts now = smat::test::processCounts();
        return now.threads == before.threads + threads && now.files == before.files + files;
    };
    EXPECT_TRUE(test::waitUntil([&] { return holds(0, 0); })) << smat::test::openFiles();
    std::jthread ours([&] { leave.acquire(); });
    std::ifstream file("/proc/self/status");
    EXPECT_TRUE(test::waitUntil([&] { return holds(1, 1); })) << smat::test::openFiles();
    leave.release(4);
}

TEST_F(WindowAndBatchTest, ManyAnalysesLeaveNothingBehind) {
    std::filesystem::copy(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/box", folder / "box");
    ASSERT_TRUE(opens(folder / "box" / "box.smat")) << told.join('\n').toStdString();
    Settings tiny = workbench.settings();
    for (const auto& [key, text] :
         {std::pair("sensor.width", "24"), std::pair("sensor.height", "20"),
          std::pair("render.antialiasing", "0"), std::pair("polar.step", "90"),
          std::pair("range.points", "3"), std::pair("time.step", "5"),
          std::pair("spectrum.resolution", "200"), std::pair("condition.points", "3"),
          std::pair("table.azimuthStep", "90"), std::pair("table.elevationStep", "90")}) {
        tiny.set(key, text);
    }
    workbench.set(tiny);
    workbench.save(); // else a recovery copy is made on the way, with a lock of its own
    const auto runOne = [&](int number) {
        const AnalysisKind kind = allAnalysisKinds()[number % allAnalysisKinds().size()];
        // One plane that each image keeps is more than is allowed below.
        Settings settings = tiny;
        if (kind == AnalysisKind::image) {
            settings.set("sensor.width", "960");
            settings.set("sensor.height", "640");
        }
        workbench.start(AnalysisData::of(workbench.project(), kind, settings));
        ASSERT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }));
        ASSERT_EQ(workbench.results().size(), 1U);
        workbench.removeResult(workbench.results().front().id);
    };
    // What is loaded once stays: a renderer, a model, a database.
    const int kinds = static_cast<int>(allAnalysisKinds().size());
    for (int number = 0; number < 3 * kinds; ++number) {
        runOne(number);
    }
    QTest::qWait(50);
    const smat::test::ProcessCounts before = smat::test::processCounts();
    const auto memory_kB = [] {
        QPixmapCache::clear(); // up to 10 MB of drawn buttons
        return smat::test::allocated_kB();
    };
    const irsg::test::HeldByContext heldBefore = irsg::test::heldByContext();
    EXPECT_GT(heldBefore.textures, 0);
    EXPECT_GT(heldBefore.buffers, 0);
    EXPECT_GT(heldBefore.framebuffers, 0);
    EXPECT_GT(heldBefore.vertexArrays, 0);
    // What caches and pools hold varies from moment to moment by megabytes; the least that is held
    // in a while does not, and a leak raises it.
    std::array<double, 6> held_kB{};
    // SMAT_ANALYSES: how many to run at least.
    const char* wanted = std::getenv("SMAT_ANALYSES");
    const int each =
        wanted == nullptr
            ? kinds
            : std::max(kinds, 1 + std::atoi(wanted) / static_cast<int>(held_kB.size()));
    for (double& held : held_kB) {
        for (int number = 0; number < each; ++number) {
            ASSERT_NO_FATAL_FAILURE(runOne(number));
        }
        // A thread that still lets go of its work holds megabytes.
        ASSERT_TRUE(test::waitUntil([this] { return !workbench.jobs().isWorking(); }));
        QTest::qWait(200);
        held = memory_kB();
    }
    EXPECT_TRUE(test::waitUntil([&before] {
        const smat::test::ProcessCounts after = smat::test::processCounts();
        return after.threads <= before.threads && after.files <= before.files;
    })) << smat::test::openFiles();
    const irsg::test::HeldByContext heldAfter = irsg::test::heldByContext();
    EXPECT_LE(heldAfter.textures, heldBefore.textures);
    EXPECT_LE(heldAfter.buffers, heldBefore.buffers);
    EXPECT_LE(heldAfter.framebuffers, heldBefore.framebuffers);
    EXPECT_LE(heldAfter.vertexArrays, heldBefore.vertexArrays);
    // What is taken once, at whatever moment, raises one third over the one before; a leak raises
    // both.
    const auto leastOfThird_kB = [&held_kB](int third) {
        return std::min(held_kB.at(2 * third), held_kB.at(2 * third + 1));
    };
    const double growth_kB =
        std::min(leastOfThird_kB(1) - leastOfThird_kB(0), leastOfThird_kB(2) - leastOfThird_kB(1));
    EXPECT_LT(growth_kB, 2'000.0) << testing::PrintToString(held_kB); // of two rounds of all kinds
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(WindowAndBatchTest, ClosesWhileAnAnalysisAndALeftDrawingRun) {
    test::Gate gate;
    gate.drawings(0);
    {
        Workbench bench([&gate] { return test::gatedDoor(gate); });
        auto shown = std::make_unique<MainWindow>(bench, people);
        shown->show();
        ASSERT_TRUE(shown->open(test::writeSampleProject(folder)));
        const auto start = [&] {
            bench.start(AnalysisData::of(bench.project(), AnalysisKind::polar, bench.settings()));
        };
        start();
        ASSERT_TRUE(test::waitUntil([&] { return gate.begun == 1; }));
        bench.cancel();
        ASSERT_TRUE(test::waitUntil([&] { return !bench.isRunning(); }));
        start();
        ASSERT_TRUE(test::waitUntil([&] { return gate.begun == 2; }));
        // Two renderers are in the middle of a drawing: the one that was left and its successor.
        EXPECT_EQ(gate.renderers, 2);
        EXPECT_TRUE(bench.isRunning());
        const auto* times = shown->findChild<QLabel*>("jobTimes");
        EXPECT_TRUE(times->isVisible() && times->text().contains(" elapsed"))
            << times->text().toStdString();
        answer = 0; // quit
        EXPECT_TRUE(shown->close());
        shown.reset();
        EXPECT_EQ(gate.begun, 2);
        EXPECT_EQ(gate.renderers, 2);
        gate.drawings(1 << 30);
    }
    EXPECT_EQ(gate.renderers, 0);
}

TEST_F(WindowAndBatchTest, ClosesWhileTheRealRendererDraws) {
    openSample();
    workbench.set("sensor.width", "1500");
    workbench.set("sensor.height", "1500");
    workbench.set("render.antialiasing", "2");
    workbench.save();
    workbench.start(
        AnalysisData::of(workbench.project(), AnalysisKind::image, workbench.settings()));
    QTest::qWait(30);
    EXPECT_TRUE(workbench.isRunning());
    answer = 0; // quit
    EXPECT_TRUE(window->close());
    window.reset();
}

} // namespace
} // namespace smat::gui

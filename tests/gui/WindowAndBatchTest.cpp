#include <fstream>
#include <thread>

#include <malloc.h>

#include <QListWidget>
#include <QPixmapCache>
#include <QSemaphore>
#include <QTest>
#include <QThreadPool>
#include <nlohmann/json.hpp>

#include "gui/image/ComparisonWindow.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/cli/Program.h"
#include "tests/gui/ProcessCounts.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

/// "smat-batch polar ship.smat --out polar.csv" without its first word.
std::vector<std::string> argumentsOf(const std::string& command) {
    std::istringstream words(command);
    std::vector<std::string> list;
    for (std::string word; words >> word;)
        list.push_back(word);
    list.erase(list.begin());
    return list;
}

/// What this process has of the memory of the machine.
long residentMemory_kB() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == "VmRSS:") {
            long value = 0;
            status >> value;
            return value;
        }
    }
    return -1;
}

class WindowAndBatchTest : public test::WindowFixture {};

TEST_F(WindowAndBatchTest, EveryAnalysisEqualsItsCommandLineByteForByte) {
    openSample();
    // What the window changed of the project is in the command.
    workbench.set("camera.azimuth", "33.25");
    workbench.set("sensor.band", "8-12");
    workbench.set("render.background", "1.5");
    const std::filesystem::path fromBatch = folder / "batch";
    std::filesystem::create_directories(fromBatch);
    for (const AnalysisKind kind : allAnalysisKinds) {
        runAnalysis(name(kind).c_str());
        const AnalysisData& data = *workbench.results().back().data;
        ASSERT_EQ(data.kind, kind);
        const std::string file = name(kind) + (kind == AnalysisKind::image ? ".exr" : ".csv");
        saveResult(data, folder / file);
        const auto ran = smat::test::smatBatch(argumentsOf(data.commandLine), fromBatch);
        ASSERT_EQ(ran.exitCode, 0) << data.commandLine << "\n" << ran.err;
        const std::string ofWindow = smat::test::contentOf(folder / file);
        const std::string ofBatch = smat::test::contentOf(fromBatch / file);
        EXPECT_GT(ofBatch.size(), 200U) << name(kind);
        EXPECT_TRUE(ofWindow == ofBatch) << name(kind) << ": " << data.commandLine;
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

TEST(ProcessCountsTest, CountThreadsButThoseOfPools) {
    const smat::test::ProcessCounts before = smat::test::processCounts();
    QThreadPool pool;
    pool.setMaxThreadCount(3);
    QSemaphore leave;
    for (int i = 0; i < 3; ++i)
        pool.start([&leave] { leave.acquire(); });
    EXPECT_TRUE(test::waitUntil([&] { return pool.activeThreadCount() == 3; }));
    QTest::qWait(20); // a thread begins before it has its name
    EXPECT_EQ(smat::test::processCounts().threads, before.threads);
    EXPECT_EQ(smat::test::processCounts().files, before.files);
    std::jthread ours([&] { leave.acquire(); });
    EXPECT_EQ(smat::test::processCounts().threads, before.threads + 1);
    leave.release(4);
}

TEST_F(WindowAndBatchTest, TwoHundredAnalysesLeaveNothingBehind) {
    std::filesystem::copy(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/box", folder / "box");
    ASSERT_TRUE(opens(folder / "box" / "box.smat")) << told.join('\n').toStdString();
    Settings tiny = workbench.settings();
    for (const auto& [key, text] :
         {std::pair("sensor.width", "24"), std::pair("sensor.height", "20"),
          std::pair("render.antialiasing", "0"), std::pair("polar.step", "90"),
          std::pair("range.points", "3"), std::pair("time.step", "5"),
          std::pair("spectrum.resolution", "200")})
        tiny.set(key, text);
    workbench.set(tiny);
    workbench.save(); // else a recovery copy is made on the way, with a lock of its own
    const auto runOne = [&](int number) {
        const AnalysisKind kind = allAnalysisKinds[number % 5];
        workbench.start(AnalysisData::of(workbench.project(), kind, workbench.settings()));
        ASSERT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }));
        ASSERT_EQ(workbench.results().size(), 1U);
        workbench.removeResult(workbench.results().front().id);
    };
    // What is loaded once stays: a renderer, a model, a database.
    for (int number = 0; number < 40; ++number)
        runOne(number);
    QTest::qWait(50);
    const smat::test::ProcessCounts before = smat::test::processCounts();
    // Not counted is what Qt keeps of drawn buttons (up to 10 MB) and what the C library keeps of
    // memory that was given back: together some 30 MB after 200 analyses.
    const auto memory_kB = [] {
        QPixmapCache::clear();
        malloc_trim(0);
        return residentMemory_kB();
    };
    const long before_kB = memory_kB();
    for (int number = 0; number < 200; ++number)
        runOne(number);
    QTest::qWait(50);
    const smat::test::ProcessCounts after = smat::test::processCounts();
    EXPECT_LE(after.threads, before.threads);
    EXPECT_LE(after.files, before.files);
    // The address sanitizer keeps what was given back, and finds leaks by itself.
#ifdef __SANITIZE_ADDRESS__
    constexpr long most_kB = 128L * 1024;
#else
    constexpr long most_kB = 12L * 1024;
#endif
    EXPECT_LT(memory_kB() - before_kB, most_kB);
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(WindowAndBatchTest, ClosesWhileAnAnalysisAndALeftDrawingRun) {
    openSample();
    workbench.set("sensor.width", "1500");
    workbench.set("sensor.height", "1500");
    workbench.set("render.antialiasing", "2");
    workbench.start(
        AnalysisData::of(workbench.project(), AnalysisKind::image, workbench.settings()));
    QTest::qWait(60);
    workbench.cancel();
    ASSERT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }));
    workbench.start(
        AnalysisData::of(workbench.project(), AnalysisKind::image, workbench.settings()));
    QTest::qWait(30);
    window->close();
    window.reset();
}

} // namespace
} // namespace smat::gui

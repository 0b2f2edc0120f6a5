#include <csignal>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/cli/Scenarios.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string sphere = sample("sphere/sphere.smat");

/// A command that is long enough to be stopped.
struct Stopped {
    const char* name;
    Words words;           ///< with the output that is looked at last
    const char* stopAfter; ///< on standard error
    const char* partial;   ///< where its part goes beside a whole result
};

void PrintTo(const Stopped& row, std::ostream* out) {
    *out << row.name;
}

class StoppedRun : public testing::TestWithParam<Stopped> {};

TEST_P(StoppedRun, LeavesTheWholeResultOfBefore) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TemporaryFolder folder;
        const fs::path result = folder / GetParam().words.back();
        write(result, "# state: complete\nwhatever was there\n");
        const Ran ran = smatBatch(GetParam().words, folder.path(), GetParam().stopAfter, signal);
        EXPECT_EQ(ran.exitCode, 1) << ran.err;
        EXPECT_THAT(ran.err, HasSubstr("stopped"));
        EXPECT_EQ(contentOf(result), "# state: complete\nwhatever was there\n");
        // Stopped before its first case it has nothing to keep.
        if (const fs::path partial = folder / GetParam().partial; fs::exists(partial)) {
            EXPECT_EQ(ResultTable::load(partial).provenance.value("state"), "partial");
        }
    }
}

TEST_P(StoppedRun, ReplacesThePartOfOneThatWasStoppedBefore) {
    const TemporaryFolder folder;
    const fs::path result = folder / GetParam().words.back();
    write(result, "# program: smat\n# state: partial\nx\n1\n");
    const Ran ran = smatBatch(GetParam().words, folder.path(), GetParam().stopAfter, SIGTERM);
    EXPECT_EQ(ran.exitCode, 1) << ran.err;
    EXPECT_FALSE(fs::exists(folder / GetParam().partial));
    EXPECT_THAT(contentOf(result), HasSubstr("state: partial"));
}

const std::vector<std::string> longSweep = {"--from", "0",   "--to",     "100000",
                                            "--step", "0.2", "--verbose"};

Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

INSTANTIATE_TEST_SUITE_P(
    All, StoppedRun,
    testing::Values(Stopped{"OfASweep", with(with({"time", sphere}, longSweep), {"--out", "t.csv"}),
                            "cases", "t.partial.csv"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(StoppedSimulation, LeavesFramesAndTablesOfBeforeAndTheNextWholeOneReplacesThem) {
    const TemporaryFolder folder;
    const std::string box = entity("box", "box", R"("position_m": [0, 3000, 100])");
    write(folder / "s.json", scenarioOf(box, south, R"("dt_s": 1, "end_s": 2)"));
    ASSERT_EQ(simulated(folder).exitCode, 0);
    const fs::path frame = folder / "out/south/frame_000000.exr";
    const std::string ofFrame = contentOf(frame), table = contentOf(folder / "out/south.csv"),
                      settings = contentOf(folder / "out/south.xml");
    ASSERT_FALSE(ofFrame.empty());

    // Another scene, for a long time.
    const std::string nearer = entity("box", "box", R"("position_m": [0, 2000, 100])");
    write(folder / "s.json", scenarioOf(nearer, south, R"("dt_s": 0.001, "end_s": 900)"));
    for (const int signal : {SIGINT, SIGTERM}) {
        const Ran ran = smatBatch({"simulate", "s.json", "--out", "out", "--verbose"},
                                  folder.path(), "frames of 1 sensor", signal);
        EXPECT_EQ(ran.exitCode, 1) << ran.err;
        EXPECT_EQ(contentOf(frame), ofFrame);
        EXPECT_EQ(contentOf(folder / "out/south.csv"), table);
        EXPECT_EQ(contentOf(folder / "out/south.xml"), settings);
        const ResultTable partial = ResultTable::load(folder / "out/south.partial.csv");
        EXPECT_EQ(partial.provenance.value("state"), "partial");
        std::size_t frames = 0;
        for (const auto& entry : fs::directory_iterator(folder / "out/south.partial")) {
            EXPECT_TRUE(entry.is_regular_file());
            ++frames;
        }
        EXPECT_EQ(partial.rowCount(), frames);
    }
    write(folder / "s.json", scenarioOf(nearer, south, R"("dt_s": 1, "end_s": 2)"));
    ASSERT_EQ(simulated(folder).exitCode, 0);
    EXPECT_NE(contentOf(frame), ofFrame);
    EXPECT_NE(contentOf(folder / "out/south.csv"), table);
    EXPECT_FALSE(fs::exists(folder / "out/south.partial"));
    EXPECT_FALSE(fs::exists(folder / "out/south.partial.csv"));
    EXPECT_FALSE(fs::exists(folder / "out/south.partial.xml"));
}

TEST(StoppedSweep, LeavesNoCasesOfBeforeOnceAResultIsWhole) {
    const TemporaryFolder folder;
    write(folder / "t.csv.cases", "cases of an earlier run\n");
    write(folder / "t.csv.cases.old", "and of one before\n");
    write(folder / "t.partial.csv", "# state: partial\nx\n1\n");
    const Ran ran = smatBatch({"time", sphere, "--from", "0", "--to", "1", "--step", "0.5", "--out",
                               "t.csv", "--width", "16", "--height", "16"},
                              folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    for (const char* name : {"t.csv.cases", "t.csv.cases.old", "t.partial.csv"}) {
        EXPECT_FALSE(fs::exists(folder / name)) << name;
    }
    EXPECT_EQ(ResultTable::load(folder / "t.csv").provenance.value("state"), "complete");
}

TEST(StoppedImage, EndsWithZeroExactlyWhereItIsWhole) {
    // Whenever the signal comes, the exit code says whether there is an image.
    for (const char* after : {"loading model", "loading signature database", "image"}) {
        const TemporaryFolder folder;
        const Ran ran = smatBatch(
            {"image", sphere, "--width", "256", "--height", "256", "--verbose", "--out", "a.exr"},
            folder.path(), after, SIGTERM);
        if (ran.exitCode == 128 + SIGTERM) {
            continue; // before it was caught
        }
        EXPECT_EQ(ran.exitCode, fs::exists(folder / "a.exr") ? 0 : 1) << after << ran.err;
    }
}

} // namespace
} // namespace smat::test

#include <csignal>
#include <map>
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
    Words words;
    const char* result;    ///< the output that is looked at
    const char* stopAfter; ///< on standard error
    const char* partial;   ///< where its part goes beside a whole result
};

void PrintTo(const Stopped& row, std::ostream* out) {
    *out << row.name;
}

class StoppedRun : public testing::TestWithParam<Stopped> {
  protected:
    StoppedRun() {
        copyScaledBox(folder_.path());
        write(folder_ / "p.smat", R"({"version": 1,
  "models": [{"file": "box.flt", "database": "box.sigdb"}],
  "sensor": {"width": 96, "height": 64}, "render": {"bounces": 0}})");
        write(folder_ / "s.json", scenarioOf(ownBox, south, R"("dt_s": 0.01, "end_s": 900)"));
        write(folder_ / "few.json", scenarioOf(ownBox, south, R"("dt_s": 1, "end_s": 2)"));
    }
    Ran stopped(int signal) const {
        return smatBatch(GetParam().words, folder_.path(), GetParam().stopAfter, signal);
    }
    TemporaryFolder folder_;
};

TEST_P(StoppedRun, LeavesTheWholeResultOfBefore) {
    const fs::path result = folder_ / GetParam().result;
    for (const int signal : {SIGINT, SIGTERM}) {
        write(result, "# state: complete\nwhatever was there\n");
        const Ran ran = stopped(signal);
        EXPECT_EQ(ran.exitCode, 1) << ran.err;
        EXPECT_THAT(ran.err, HasSubstr("stopped"));
        EXPECT_EQ(contentOf(result), "# state: complete\nwhatever was there\n");
        // Stopped before its first case it has nothing to keep.
        if (const fs::path partial = folder_ / GetParam().partial; fs::exists(partial)) {
            EXPECT_EQ(ResultTable::load(partial).provenance.value("state"), "partial");
        }
    }
}

TEST_P(StoppedRun, ReplacesThePartOfOneThatWasStoppedBefore) {
    const fs::path result = folder_ / GetParam().result;
    const std::string before = "# program: smat\n# state: partial\nx\n1\n";
    write(result, before);
    const Ran ran = stopped(SIGTERM);
    EXPECT_EQ(ran.exitCode, 1) << ran.err;
    EXPECT_FALSE(fs::exists(folder_ / GetParam().partial));
    if (contentOf(result) != before) { // see above
        EXPECT_EQ(ResultTable::load(result).provenance.value("state"), "partial");
    }
}

Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

/// Rows of each command whose results are tables.
std::vector<Stopped> stoppedRuns() {
    const std::string sensor =
        std::string(SMAT_SOURCE_DIR) + "/resources/sensors/cooled-mwir.smatsensor";
    const Words sweep = {"time",   sphere,   "--from", "0",         "--to",
                         "100000", "--step", "0.2",    "--verbose", "--out"};
    const Words table = {
        "table",     sphere, "--set", "table.azimuthStep=0.5", "--set", "table.elevationStep=5",
        "--verbose", "--out"};
    const Words detection = {"detection", "p.smat", "--sensor",  sensor,
                             "--step",    "0.01",   "--verbose", "--out"};
    const Words monteCarlo = {"montecarlo", "p.smat", "--subpixel-shifts", "1", "--verbose"};
    const Words draws =
        with(monteCarlo, {"--set", "polar.step=120", "--samples", "10000000", "--out"});
    const Words cases = with(monteCarlo, {"--set", "polar.step=0.02", "--samples", "256", "--out"});
    const Words steps = {"montecarlo", "s.json", "--verbose", "--samples", "256", "--out", "m.csv"};
    const Words drawsOfSteps = {"montecarlo", "few.json", "--verbose", "--samples",
                                "8000000",    "--out",    "m.csv"};
    return {
        {"OfASweep", with(sweep, {"t.csv"}), "t.csv", "cases", "t.partial.csv"},
        {"OfASweepAsJson", with(sweep, {"t.json"}), "t.json", "cases", "t.partial.json"},
        {"OfATable", with(table, {"t.csv"}), "t.csv", "cases", "t.partial.csv"},
        {"OfDetection", with(detection, {"d.csv"}), "d.csv", "loading signature", "d.partial.csv"},
        {"OfDetectionAsJson", with(detection, {"d.json"}), "d.json", "loading signature",
         "d.partial.json"},
        {"OfDetectionOverRanges", with(detection, {"d.csv", "--ranges", "1000,2000"}), "d.csv",
         "loading signature", "d.partial.csv"},
        {"OfMonteCarlo", with(cases, {"m.csv"}), "m.csv", "drawing the cases", "m.partial.csv"},
        {"OfMonteCarloAsJson", with(cases, {"m.json"}), "m.json", "drawing the cases",
         "m.partial.json"},
        {"OfDrawsOfMonteCarlo", with(draws, {"m.csv"}), "m.csv", "drawing scales", "m.partial.csv"},
        {"OfRawDrawsOfMonteCarlo", with(cases, {"m.csv", "--draws", "d.csv"}), "d.csv",
         "drawing the cases", "d.partial.csv"},
        {"OfMonteCarloInParts", with(cases, {"m.csv", "--resume"}), "m.csv", "case by case",
         "m.partial.csv"},
        {"OfMonteCarloOfAScenario", steps, "m-south-box.csv", "drawing the steps",
         "m-south-box.partial.csv"},
        {"OfDrawsOfAScenario", drawsOfSteps, "m-south-box.csv", "drawing scales",
         "m-south-box.partial.csv"}};
}

INSTANTIATE_TEST_SUITE_P(All, StoppedRun, testing::ValuesIn(stoppedRuns()),
                         [](const auto& info) { return std::string(info.param.name); });

/// Commands that write all they have at their end, which is soon.
TEST(EndedTool, LeavesTheResultOfBeforeOrItsOwn) {
    const std::vector<Words> tools = {
        {"gas", "--layer", "T_K=700,p_atm=1,length_m=0.5,CO2=0.033", "--out", "r.csv"},
        {"plume", "--jet", "D_m=0.3,T_K=800,velocity_m_s=200,fuel_air=0.02", "--band", "4.4-4.6",
         "--bound", "0.5", "--out", "r.obj"}};
    for (const Words& tool : tools) {
        const TemporaryFolder whole;
        ASSERT_EQ(smatBatch(tool, whole.path()).exitCode, 0);
        for (const char* delay_s : {"0.01", "0.05", "0.2", "1"}) {
            const TemporaryFolder folder;
            std::map<std::string, std::string> before;
            for (const auto& entry : fs::directory_iterator(whole.path())) {
                const std::string name = entry.path().filename().string();
                write(folder / name, before[name] = "what was there in " + name);
            }
            Words words = {"timeout", "--preserve-status", "--signal=TERM", delay_s, SMAT_BATCH};
            words.insert(words.end(), tool.begin(), tool.end());
            const Ran ran = runProgram(words, folder.path());
            EXPECT_TRUE(ran.exitCode == 0 || ran.exitCode == 128 + SIGTERM) << ran.err;
            for (const auto& [name, content] : before) {
                EXPECT_EQ(contentOf(folder / name) == content, ran.exitCode != 0)
                    << tool.front() << " after " << delay_s << " s: " << name;
            }
        }
    }
}

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

// Runs in parts: what they give together is what one run gives, byte for byte but for the command.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class SmatBatchParted : public testing::Test {
  protected:
    void ran(std::vector<std::string> words, const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
        const Ran one = smatBatch(words, folder.path());
        ASSERT_EQ(one.exitCode, 0) << one.err;
    }
    void refused(std::vector<std::string> words, const std::vector<std::string>& more,
                 const std::string& why) {
        words.insert(words.end(), more.begin(), more.end());
        const Ran one = smatBatch(words, folder.path());
        EXPECT_EQ(one.exitCode, 2);
        EXPECT_THAT(one.err, HasSubstr(why));
    }
    std::string result(const std::string& file) const { return withoutCommand(folder / file); }
    /// Cuts a file off somewhere in its last line but one, as a kill does.
    void cutOff(const std::string& file) {
        const std::string text = contentOf(folder / file);
        write(folder / file, text.substr(0, text.rfind('\n', text.size() - 2) - 7));
    }

    const TemporaryFolder folder;
};

TEST_F(SmatBatchParted, HaveTheErrorsOfOneRun) {
    const std::string aircraft = sample("turboprop4/turboprop4.smat");
    const std::vector<std::vector<std::string>> sweeps = {
        {"polar", aircraft, "--step", "90", "--steps", "fixed"},
        {"range", aircraft, "--from", "1000", "--to", "4000", "--points", "4", "--steps", "fixed"},
        {"polar", aircraft, "--step", "120", "--steps", "fixed", "--mode", "ck"}};
    for (std::vector<std::string> sweep : sweeps) {
        SCOPED_TRACE(sweep.front());
        sweep.insert(sweep.end(), {"--errors", "causes", "--light-error", "0.1", "--width", "64",
                                   "--height", "64"});
        ran(sweep, {"--out", "one.csv"});
        ran(sweep, {"--shard", "1/2", "--out", "all.csv"});
        ran(sweep, {"--shard", "2/2", "--out", "all.csv"});
        ran({"merge", "all.csv.part2of2", "all.csv.part1of2", "--out", "all.csv"}, {});
        EXPECT_EQ(result("all.csv"), result("one.csv"));
        const ResultTable table = ResultTable::load(folder / "one.csv");
        const ResultColumn* air = table.find("error_air_contrast_intensity");
        ASSERT_NE(air, nullptr);
        EXPECT_GT(air->values.back(), 0.0);
    }
}

TEST_F(SmatBatchParted, OfMonteCarloJoinToOneRunAndGoOn) {
    const std::vector<std::string> run = {"montecarlo",
                                          sample("turboprop4/turboprop4.smat"),
                                          "--analysis",
                                          "range",
                                          "--set",
                                          "range.points=5",
                                          "--atmosphere",
                                          "none",
                                          "--band",
                                          "3-5,8-12",
                                          "--width",
                                          "64",
                                          "--height",
                                          "64",
                                          "--samples",
                                          "64",
                                          "--subpixel-shifts",
                                          "2",
                                          "--light-error",
                                          "0.1",
                                          "--errors",
                                          "sum"};
    ran(run, {"--out", "one.csv"});
    EXPECT_NE(ResultTable::load(folder / "one.csv").find("error_nominal@3-5um"), nullptr);
    for (const std::string part : {"1", "2"}) {
        ran(run, {"--shard", part + "/2", "--out", "all.csv"});
    }
    refused({"merge", "all.csv.part1of2", "--out", "all.csv"}, {}, "2/2");
    cutOff("all.csv.part1of2");
    refused({"merge", "all.csv.part1of2", "all.csv.part2of2", "--out", "all.csv"}, {}, "1/2");
    ran(run, {"--shard", "1/2", "--resume", "--out", "all.csv"});
    ran({"merge", "all.csv.part1of2", "all.csv.part2of2", "--out", "all.csv"}, {});
    EXPECT_EQ(result("all.csv"), result("one.csv"));
    ran(run, {"--resume", "--out", "whole.csv"});
    EXPECT_EQ(result("whole.csv"), result("one.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder / "whole.csv.cases"));

    refused(run, {"--shard", "1/2", "--out", "a.json"}, "a .csv of a run in parts");
    refused(run, {"--shard", "1/2", "--out", "a.csv", "--draws", "d.csv"}, "no raw draws");
    refused(run, {"--shard", "1/2", "--out", "a.csv", "--ranking"}, "none in parts");
    refused(run, {"--resume", "--out", "a.csv", "--standard-error", "0.01"}, "in parts");
    refused({"merge", "all.csv.part1of2", "all.csv.part2of2", "--out", "all.json"}, {}, ".csv");
    refused({"montecarlo", sample("turboprop4/turboprop4.smat"), "--kind", "spectrum"},
            {"--shard", "1/2", "--out", "a.csv"}, "one view, which has no parts");
}

TEST_F(SmatBatchParted, OfAScenarioGiveItsFramesAndTables) {
    const std::string box = sample("box/box").string(), ball = sample("sphere/sphere").string();
    write(folder / "path.csv", "t,x,y,z,yaw,pitch,roll\n0,-4,200,100,0,0,0\n3,4,200,100,0,0,0\n");
    write(folder / "s.json", R"({"version": 1,
        "render": {"sun": "off", "fluxes": "off", "background": "none", "bounces": 0, "errors": "sum"},
        "sensor": {"width": 48, "height": 32, "fov": 4},
        "entities": [
            {"name": "ball", "model": ")" +
                                 ball + R"(.flt", "database": ")" + ball +
                                 R"(.sigdb", "trajectory": "path.csv"},
            {"name": "box", "model": ")" +
                                 box + R"(.flt", "database": ")" + box +
                                 R"(.sigdb", "position_m": [0, 100, 100]}],
        "sensors": [
            {"name": "one", "position_m": [0, 0, 100], "sensor": {"band": "3-5,8-12"}},
            {"name": "two", "position_m": [0, 0, 101], "track": "ball"}],
        "dt_s": 1, "end_s": 6})");
    const std::vector<std::string> run = {"simulate", "s.json"};
    ran(run, {"--out", "whole"});
    for (const std::string part : {"1", "2"}) {
        ran(run, {"--out", "parts", "--shard", part + "/2"});
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "parts/one.csv"));
    cutOff("parts/two.csv.part2of2");
    ran(run, {"--out", "parts", "--shard", "2/2", "--resume"});
    for (const std::string sensor : {"one", "two"}) {
        const std::string table = "parts/" + sensor + ".csv";
        ran({"merge", table + ".part1of2", table + ".part2of2", "--out", table}, {});
        EXPECT_EQ(result(table), result("whole/" + sensor + ".csv"));
        for (const auto& frame : std::filesystem::directory_iterator(folder / "whole" / sensor)) {
            EXPECT_TRUE(
                std::filesystem::exists(folder / "parts" / sensor / frame.path().filename()))
                << frame.path();
        }
    }
    // What the second sensor tracks ends before the scenario does.
    EXPECT_THAT(result("parts/two.csv"), HasSubstr("# warning: no frame at 3 of the steps"));
    const ResultTable table = ResultTable::load(folder / "parts/one.csv");
    const ResultColumn* error = table.find("error_box.contrast_intensity@3-5um");
    ASSERT_NE(error, nullptr);
    EXPECT_GT(error->values.front(), 0.0);
    EXPECT_LT(error->values.front(), 0.05 * table.find("box.contrast_intensity@3-5um")->values[0]);

    ran(run, {"--out", "whole", "--resume"});
    EXPECT_EQ(result("whole/two.csv"), result("parts/two.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder / "whole/two.csv.cases"));
    refused(run, {"--out", "parts", "--shard", "1/2", "--film", "f.png"}, "for a film");
}

} // namespace
} // namespace smat::test

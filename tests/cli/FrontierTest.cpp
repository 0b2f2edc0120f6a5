#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/data/ResultTable.h"
#include "tests/cli/PlainScene.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

TEST(SmatBatchCostAccuracy, TellsTimeAgainstErrorAndWhatIsChosen) {
    const TemporaryFolder folder;
    const Ran ran =
        smatBatch(with({"cost-accuracy", sample("sphere/sphere.smat"), "--atmosphere", "none",
                        "--background", "none", "--width", "32", "--height", "32", "--repeats", "1",
                        "--target-error", "0.5%", "--out", folder / "f.csv"},
                       plain));
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("the quickest of 6 configurations that meet it"));
    const ResultTable table = ResultTable::load(folder / "f.csv");
    EXPECT_EQ(table.provenance.value("analysis"), "cost-accuracy");
    ASSERT_EQ(table.rowCount(), 6u) << "modes 0 to 5 of a sphere that has nothing else";
    const auto& chosen = table.find("chosen")->values;
    const auto at = static_cast<std::size_t>(std::ranges::find(chosen, 1.0) - chosen.begin());
    ASSERT_LT(at, chosen.size());
    EXPECT_LE(table.find("true_error")->values[at], 0.5);
}

TEST(SmatBatchCostAccuracy, TellsBeforeHowManyConfigurationsThereAreAndTakesTheLikelyOnes) {
    const TemporaryFolder folder;
    const std::vector<std::string> view = {"cost-accuracy", sample("sphere/sphere.smat"),
                                           "--atmosphere",  "none",
                                           "--background",  "none",
                                           "--bounces",     "0",
                                           "--shadows",     "off",
                                           "--width",       "32",
                                           "--height",      "32",
                                           "--repeats",     "1"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), view.begin(), view.end());
        return smatBatch(more);
    };
    EXPECT_THAT(with({"--dry-run"}).out, HasSubstr("12 configurations: about "));
    EXPECT_THAT(with({"--dry-run", "--configurations", "likely"}).out,
                HasSubstr("12 configurations, 7 of which are measured first"));
    const Ran ran = with({"--configurations", "likely", "--out", folder / "f.csv"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "f.csv");
    EXPECT_GE(table.rowCount(), 7u);
    EXPECT_LE(table.rowCount(), 12u);
    EXPECT_EQ(with({"--configurations", "some", "--out", folder / "f.csv"}).exitCode, 2);
}

TEST(SmatBatchCostAccuracy, RefusesTimesThatAreNone) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"cost-accuracy", sample("sphere/sphere.smat"), "--repeats", "0",
                               "--out", folder / "f.csv"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("--repeats"));
}

} // namespace
} // namespace smat::test

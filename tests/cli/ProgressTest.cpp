// The line of progress on a terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SmatBatchOnATerminal, NamesTheStageOfACaseThatTakesLong) {
    // With an own terminal by script(1), whose output goes where a stop is waited for.
    const TemporaryFolder folder;
    const std::string command = std::string(SMAT_BATCH) + " polar " +
                                sample("heron/heron.smat").string() +
                                " --set render.lightError=0.0005 --set environment.terrain= "
                                "--out polar.csv";
    const Ran ran = runProgram({"sh", "-c", "exec script -qec '" + command + "' /dev/null 1>&2"},
                               folder.path(), "inter-reflection: view factors", SIGINT);
    EXPECT_THAT(ran.err, HasSubstr("0/"));
    EXPECT_THAT(ran.err, HasSubstr("inter-reflection: view factors, round 1, "));
}

TEST(SmatBatchOnATerminal, IsAsSilentElsewhereAsItWas) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch(
        {"polar", sample("box/box.smat"), "--step", "180", "--out", folder / "polar.csv"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.err, Not(HasSubstr("inter-reflection")));
    EXPECT_THAT(ran.err, Not(HasSubstr("\r")));
}

} // namespace
} // namespace smat::test

// smat-batch-mpi: a sweep drawn by four ranks, undisturbed, ended on the way, and by ranks that
// were told different things.
#include <cstdlib>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/jobs/CaseTeam.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

using Words = std::vector<std::string>;

Words operator+(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

#ifdef SMAT_BATCH_MPI
constexpr const char* program = SMAT_BATCH_MPI;
#else
constexpr const char* program = "";
#endif

class SmatBatchMpi : public testing::Test {
  protected:
    void SetUp() override {
        if (std::string(program).empty()) {
            GTEST_SKIP() << "built without MPI";
        }
        // Whoever runs the tests may be root, in a container of few cores.
        setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
        setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
        setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 1);
        setenv("OMPI_MCA_btl", "self,vader,tcp", 1);
        // The libraries of MPI keep what they have allocated, some of it after they are unloaded.
        setenv("ASAN_OPTIONS", "detect_leaks=0:intercept_tls_get_addr=0", 1);
    }
    Ran ranks(const char* count, const Words& arguments, const Words& before = {}) {
        return runProgram(before + Words{"mpirun", "-n", count, program} + arguments,
                          folder.path());
    }
    Words sweep(const char* out, const char* range = "1200") const {
        return {"polar",     sample("box/box.smat"),
                "--step",    "5",
                "--band",    "3-5,8-12",
                "--range",   range,
                "--width",   "48",
                "--height",  "48",
                "--threads", "1",
                "--out",     folder / out};
    }
    std::string result(const char* file) const { return withoutCommand(folder / file); }

    const TemporaryFolder folder;
};

TEST_F(SmatBatchMpi, FourRanksGiveTheBytesOfOneRun) {
    ASSERT_EQ(smatBatch(sweep("one.csv")).exitCode, 0);
    const Ran ran = ranks("4", sweep("four.csv"));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(result("four.csv"), result("one.csv"));
    EXPECT_THAT(ran.out, HasSubstr("four.csv"));
    EXPECT_EQ(ran.out.find("-> "), ran.out.rfind("-> ")) << "one of them tells\n" << ran.out;
    EXPECT_FALSE(std::filesystem::exists(folder / "four.csv.cases"));
}

TEST_F(SmatBatchMpi, RanksShareTheCasesOfMonteCarlo) {
    const Words run = {"montecarlo",
                       sample("turboprop4/turboprop4.smat"),
                       "--kind",
                       "polar",
                       "--set",
                       "polar.step=45",
                       "--set",
                       "polar.steps=fixed",
                       "--width",
                       "48",
                       "--height",
                       "48",
                       "--samples",
                       "64",
                       "--subpixel-shifts",
                       "1",
                       "--light-error",
                       "0.1",
                       "--threads",
                       "1"};
    ASSERT_EQ(smatBatch(run + Words{"--out", folder / "one.csv"}).exitCode, 0);
    const Ran ran = ranks("3", run + Words{"--out", folder / "three.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(result("three.csv"), result("one.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder / "three.csv.cases"));
    EXPECT_NE(
        ranks("2", {"montecarlo", sample("flyby/flyby.json"), "--out", folder / "a.csv"}).exitCode,
        0);
}

TEST_F(SmatBatchMpi, RanksShareTheFramesOfAScenario) {
    const Words run = {"simulate",      sample("flyby/flyby.json"),
                       "--to",          "1.5",
                       "--light-error", "0.1",
                       "--threads",     "1",
                       "--width",       "64",
                       "--height",      "48",
                       "--light-error", "0.05"};
    const Ran one = smatBatch(run + Words{"--out", folder / "one"});
    ASSERT_EQ(one.exitCode, 0) << one.err;
    const Ran ran = ranks("3", run + Words{"--out", folder / "three"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(ran.err.find("rank 1"), std::string::npos) << ran.err;
    int frames = 0, tables = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder / "one")) {
        const auto name = std::filesystem::relative(file.path(), folder / "one");
        const std::filesystem::path other = folder / "three" / name;
        ASSERT_TRUE(std::filesystem::exists(other)) << name;
        frames += name.extension() == ".exr" ? 1 : 0;
        if (name.extension() == ".csv") {
            ++tables;
            EXPECT_EQ(result(("three" / name).c_str()), result(("one" / name).c_str()));
        }
    }
    EXPECT_GE(frames, 4);
    EXPECT_GE(tables, 1);
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder / "three")) {
        EXPECT_NE(file.path().extension(), ".cases") << file.path();
    }
    const Ran film = ranks("2", run + Words{"--out", folder / "four", "--film", folder / "f.png"});
    EXPECT_NE(film.exitCode, 0);
    EXPECT_THAT(film.err, HasSubstr("no film where several processes draw"));
}

TEST_F(SmatBatchMpi, WhatWasEndedGoesOnWithAnotherNumberOfRanks) {
    ASSERT_EQ(smatBatch(sweep("one.csv")).exitCode, 0);
    // Ended wherever it is by then: what follows holds of any place.
    for (const char* seconds : {"0.8", "1.6"}) {
        const Ran ended =
            ranks("2", sweep("parts.csv") + Words{"--resume"}, {"timeout", "-s", "TERM", seconds});
        EXPECT_TRUE(ended.exitCode == 124 || ended.exitCode == 0) << ended.exitCode << ended.err;
    }
    const Ran ran = ranks("3", sweep("parts.csv") + Words{"--resume"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(result("parts.csv"), result("one.csv"));
}

TEST_F(SmatBatchMpi, RanksOfAnotherSweepAreRefusedByWhatDiffers) {
    const Ran ran = runProgram(Words{"mpirun", "-n", "1", program} + sweep("a.csv") +
                                   Words{":", "-n", "1", program} + sweep("a.csv", "1300"),
                               folder.path());
    EXPECT_NE(ran.exitCode, 0);
    EXPECT_THAT(ran.err, HasSubstr("rank 1"));
    EXPECT_THAT(ran.err, HasSubstr("camera.range"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
}

TEST_F(SmatBatchMpi, RefusesWhatIsNoSweep) {
    EXPECT_NE(ranks("2", {"image", sample("box/box.smat"), "--out", folder / "a.exr"}).exitCode, 0);
    const Ran part = ranks("2", sweep("a.csv") + Words{"--shard", "1/2"});
    EXPECT_NE(part.exitCode, 0);
    EXPECT_THAT(part.err, HasSubstr("take their parts by themselves"));
    const Ran adaptive = ranks("2", sweep("a.csv") + Words{"--steps", "adaptive"});
    EXPECT_NE(adaptive.exitCode, 0);
    EXPECT_THAT(adaptive.err, HasSubstr("several processes: polar.steps: found adaptive"));
    const Ran missing = ranks("2", {"polar", "gone.smat", "--out", folder / "a.csv"});
    EXPECT_NE(missing.exitCode, 0);
    EXPECT_THAT(missing.err, HasSubstr("gone.smat"));
}

TEST(CaseDispenser, HandsOutEachCaseOnceInAscendingRunsThatShrink) {
    for (const std::size_t takers : {1U, 3U, 64U}) {
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < 500; ++i) {
            if (i % 7 != 3) {
                open.push_back(i);
            }
        }
        CaseDispenser dispenser(open, takers);
        std::vector<std::size_t> given;
        std::size_t last = open.size();
        for (;;) {
            const auto run = dispenser.next();
            if (run.empty()) {
                break;
            }
            EXPECT_LE(run.size(), last);
            last = run.size();
            given.insert(given.end(), run.begin(), run.end());
        }
        EXPECT_EQ(given, open);
        EXPECT_EQ(last, 1U);
        EXPECT_THAT(dispenser.next(), IsEmpty());
    }
    EXPECT_THAT(CaseDispenser({}, 4).next(), IsEmpty());
}

} // namespace
} // namespace smat::test

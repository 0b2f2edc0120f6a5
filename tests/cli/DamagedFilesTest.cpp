#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/Program.h"
#include "tests/support/SharedMaterial.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(SmatBatchDamagedFiles, AreRefusedByName) {
    const std::filesystem::path damaged = sharedMaterial("data/damaged");
    if (damaged.empty())
        GTEST_SKIP() << "the shared folder data/damaged is absent";
    const TemporaryFolder folder;
    std::filesystem::copy_file(sample("box/box.sigdb"), folder / "box.sigdb");
    int tried = 0;
    for (const auto& entry : std::filesystem::directory_iterator(damaged)) {
        const std::string file = entry.path().string(), kind = entry.path().extension().string();
        const bool isModel = entry.path().filename().string().starts_with("model-");
        std::vector<std::string> words;
        int expected = 2;
        if (isModel) {
            words = {"model", "info", file};
        } else if (kind == ".dat") {
            words = {"atmosphere", "info", file};
            // One of its numbers was changed into another that a transmittance may have: what
            // was found in it was found by a sanitizer, and nothing in it can be refused.
            expected = entry.path().filename() == "atmosphere2.dat" ? 0 : 2;
        } else if (kind == ".csv") {
            words = {"db", "import", file, "box.sigdb"};
        } else if (kind == ".smat") {
            words = {"image", file, "--out", "o.exr"};
        } else if (kind == ".json") {
            words = {"simulate", file, "--out", "out", "--dry-run"};
        } else if (kind == ".exr") {
            words = {"compare", file, file};
        } else {
            continue;
        }
        ++tried;
        const Ran ran = smatBatch(words, folder.path());
        EXPECT_EQ(ran.exitCode, expected) << file << ": " << ran.err;
        if (expected == 2) {
            EXPECT_THAT(ran.err, StartsWith("error: " + file));
            EXPECT_THAT(ran.err, HasSubstr("expected"));
        }
        if (memoryIsTold()) {
            // The clock on the wall is the machine's.
            EXPECT_LT(ran.processor_s, 2.0) << file;
            EXPECT_LT(ran.peak_MB, 500.0) << file;
        }
    }
    EXPECT_GE(tried, 20) << damaged;
}

} // namespace
} // namespace smat::test

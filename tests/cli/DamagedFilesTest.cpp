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
    int tried = 0;
    for (const auto& entry : std::filesystem::directory_iterator(damaged)) {
        const std::string file = entry.path().string(), kind = entry.path().extension().string();
        std::vector<std::string> words;
        if (kind == ".smat") {
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
        EXPECT_EQ(ran.exitCode, 2) << file << ": " << ran.err;
        EXPECT_THAT(ran.err, StartsWith("error: " + file));
        EXPECT_THAT(ran.err, HasSubstr("expected"));
    }
    EXPECT_GT(tried, 0) << damaged;
}

} // namespace
} // namespace smat::test

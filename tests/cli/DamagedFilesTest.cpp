#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/core/FileReading.h"
#include "tests/cli/Program.h"
#include "tests/support/Sanitized.h"
#include "tests/support/SharedMaterial.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/WithoutProgram.h"

namespace smat::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(SmatBatchDamagedFiles, AreRefusedByName) {
    const std::filesystem::path damaged = sharedMaterial("data/damaged");
    if (damaged.empty()) {
        GTEST_SKIP() << "the shared folder data/damaged is absent";
    }
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
            // What a sanitizer found was our reader's; the file is sound (the test below).
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
            // Bytes at random may be taken as Latin-1 with a warning before.
            EXPECT_THAT(ran.err,
                        AnyOf(StartsWith("error: " + file), StartsWith("warning: " + file)));
            EXPECT_THAT(ran.err, HasSubstr("error: " + file));
            EXPECT_THAT(ran.err, HasSubstr("expected"));
        }
        if (!isSanitized()) {
            // The clock on the wall is the machine's.
            EXPECT_LT(ran.processor_s, 2.0) << file;
            EXPECT_LT(ran.peak_MB, 500.0) << file;
        }
    }
    EXPECT_GE(tried, 20) << damaged;
}

/// It lies among the damaged files because a sanitizer found an offset to a null pointer while it
/// was read. Each of its numbers is the one that the import of a published run gives.
TEST(SmatBatchDamagedFiles, HoldATableOfOnePathThatIsSound) {
    const std::filesystem::path among = sharedMaterial("data/damaged/atmosphere2.dat");
    const std::filesystem::path run = sharedMaterial("data/atmosphere/modtran/pyradi/tape7-01");
    if (among.empty() || run.empty()) {
        GTEST_SKIP() << "the shared files atmosphere2.dat and tape7-01 are absent";
    }
    const TemporaryFolder folder;
    const Ran ran =
        smatBatch({"atmosphere", "import", run.string(), "--out", "a.smatatm"}, folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(nlohmann::json::parse(withoutProgram(irsg::readFile(folder / "a.smatatm"))),
              nlohmann::json::parse(irsg::readFile(among)));
}

} // namespace
} // namespace smat::test

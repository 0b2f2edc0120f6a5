#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

TEST(SmatBatchMtfWithoutScattering, NamesTheMissingPart) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"mtf", "info", "fog.mtf"},
          {"mtf", "build", "--out", "a.mtf"},
          {"image", sample("chessboard/chessboard.smat").string(), "--out", "a.exr",
           "--scattering"}}) {
        const Ran ran = smatBatch(words, folder.path());
        EXPECT_EQ(ran.exitCode, 2) << words.front();
        EXPECT_THAT(ran.err, HasSubstr("irsg/scattering"));
    }
}

} // namespace
} // namespace smat::test

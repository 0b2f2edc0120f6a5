#include "irsg/signature/Lint.h"
#include "irsg/signature/SignatureFile.h"

#include "Support.h"
#include "tests/support/WithoutProgram.h"

namespace irsg {
namespace {

TEST(FormatPage, ShowsADatabaseInTheFormOfAnExport) {
    const std::filesystem::path page =
        std::filesystem::path(SMAT_SOURCE_DIR) / "docs" / "formats-sigdb.md";
    const std::string text = readBytes(page);
    const std::string fence = "```json\n";
    const std::size_t from = text.find(fence) + fence.size();
    ASSERT_NE(text.find(fence), std::string::npos);
    const std::string example = text.substr(from, text.find("```", from) - from);
    const SignatureDatabase database = signatureFromJson(example, page.string());
    // The page need not be rewritten for each version.
    EXPECT_EQ(smat::test::withoutProgram(signatureToJson(database)),
              smat::test::withoutProgram(example));
    EXPECT_TRUE(lint(database).empty());
}

} // namespace
} // namespace irsg

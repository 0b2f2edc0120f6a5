#include "irsg/signature/Lint.h"
#include "irsg/signature/SignatureFile.h"

#include "Support.h"

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
    EXPECT_EQ(signatureToJson(database), example);
    EXPECT_TRUE(lint(database).empty());
}

} // namespace
} // namespace irsg

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/geometry/model/Model.h"
#include "tests/support/FormatFeatures.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/WalkedReaders.h"

namespace irsg::test {
namespace {

using smat::test::TemporaryFolder;
using smat::test::writtenFile;
using testing::Contains;
using testing::HasSubstr;

const std::filesystem::path page =
    std::filesystem::path(SMAT_SOURCE_DIR) / "docs/formats-model-features.md";

/// What was read of a file.
struct Read {
    std::string refusal;
    std::vector<std::string> remarks;
    double area_m2 = 0.0, diagonal_m = 0.0;
};

Read readOf(const FormatFeature& feature) {
    const TemporaryFolder folder;
    for (const auto& [name, bytes] : feature.beside) {
        writtenFile(folder / name, bytes);
    }
    Read read;
    try {
        const auto model = Model::load(writtenFile(folder / feature.name, feature.bytes));
        read.remarks = model->remarks();
        for (const Mesh::Part& part : model->mesh()->parts) {
            read.area_m2 += part.area_m2;
        }
        read.diagonal_m = model->bounds().diagonal_m();
    } catch (const InputError& error) {
        read.refusal = error.what();
    }
    return read;
}

/// The row of a table, of what was read.
std::string rowOf(const FormatFeature& feature, const Read& read) {
    const std::string quotedText = feature.says.empty() ? "" : ": `" + feature.says + "`";
    const bool isRemarked =
        !feature.says.empty() && std::ranges::any_of(read.remarks, [&](const std::string& remark) {
            return remark.find(feature.says) != remark.npos;
        });
    const std::string happens = !read.refusal.empty() ? "refused" + quotedText
                                : isRemarked          ? "remarked" + quotedText
                                : feature.outcome == Outcome::looksOnly
                                    ? "without effect on surfaces"
                                    : "followed";
    return "| " + feature.feature + " | " + happens + " |\n";
}

TEST(WalkedReaders, FeaturesAreAsManyAsThePageHas) {
    smat::test::expectWalked("features of a specification without an answer", allFeatures().size());
}

TEST(FormatFeatures, AreFollowedRemarkedOrRefusedAsThePageSays) {
    std::string tables, format;
    for (const FormatFeature& feature : allFeatures()) {
        SCOPED_TRACE(feature.format + ", " + feature.feature);
        const Read read = readOf(feature);
        if (feature.outcome == Outcome::refused) {
            EXPECT_THAT(read.refusal, HasSubstr(feature.says));
            EXPECT_NE(read.refusal, "");
        } else {
            EXPECT_EQ(read.refusal, "");
            EXPECT_NEAR(read.area_m2, feature.area_m2, 1e-5);
            EXPECT_NEAR(read.diagonal_m, feature.diagonal_m, 1e-5);
        }
        if (feature.outcome == Outcome::remarked) {
            EXPECT_THAT(read.remarks, Contains(HasSubstr(feature.says)));
            EXPECT_NE(feature.says, "");
        }
        if (feature.format != format) {
            format = feature.format;
            tables += "\n## " + format + "\n\n| feature | what happens |\n|---|---|\n";
        }
        tables += rowOf(feature, read);
    }
    const std::string text = readFile(page);
    const std::size_t begin = text.find("\n## ");
    ASSERT_NE(begin, text.npos);
    if (std::getenv("SMAT_WRITE_TABLES") != nullptr) {
        std::ofstream(page, std::ios::binary) << text.substr(0, begin) << tables;
    }
    EXPECT_EQ(text.substr(begin), tables) << "SMAT_WRITE_TABLES=1 writes them";
}

} // namespace
} // namespace irsg::test

#include <fstream>
#include <ostream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Utf8.h"
#include "irsg/signature/SignatureFile.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A triangle whose name is Tuer with an u umlaut, in Latin-1.
struct Latin1 {
    const char *extension, *text;
};

void PrintTo(const Latin1& row, std::ostream* out) {
    *out << row.extension;
}

class Latin1Name : public testing::TestWithParam<Latin1> {};

TEST_P(Latin1Name, IsReadAsSuchByEveryCommand) {
    const TemporaryFolder folder;
    const std::string model = std::string("m.") + GetParam().extension;
    write(folder / model, GetParam().text);
    const Ran info = smatBatch({"model", "info", model, "--json"}, folder.path());
    EXPECT_EQ(info.exitCode, 0) << info.err;
    const Ran codes = smatBatch({"model", "codes", model, "--json"}, folder.path());
    ASSERT_EQ(codes.exitCode, 0) << codes.err;
    EXPECT_TRUE(irsg::isUtf8(codes.out));
    EXPECT_THAT(codes.out, HasSubstr("T\xc3\xbcr"));
    const Ran suggested =
        smatBatch({"model", "codes", model, "--suggest", "--database", "m.sigdb"}, folder.path());
    EXPECT_EQ(suggested.exitCode, 0) << suggested.err;
    EXPECT_NO_THROW(irsg::loadSignatureFile(folder / "m.sigdb"));
    EXPECT_TRUE(irsg::isUtf8(contentOf(folder / (model + ".codes.json"))));
    const Ran ran = smatBatch({"polar", model, "--database", "m.sigdb", "--step", "180", "--width",
                               "16", "--height", "16", "--bounces", "0", "--out", "r.csv"},
                              folder.path());
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
}

INSTANTIATE_TEST_SUITE_P(
    All, Latin1Name,
    testing::Values(Latin1{"obj", "o T\xfcr\ng T\xfcr\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl T\xfcr\n"
                                  "f 1 2 3\n"},
                    Latin1{"stl", "solid T\xfcr\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                  "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n"},
                    Latin1{"ac", "AC3Db\nMATERIAL \"T\xfcr\" rgb 1 1 1  amb 0 0 0  emis 0 0 0  "
                                 "spec 0 0 0  shi 0  trans 0\nOBJECT world\nkids 1\nOBJECT poly\n"
                                 "name \"T\xfcr\"\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\nnumsurf 1\n"
                                 "SURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids 0\n"}),
    [](const auto& info) { return std::string(info.param.extension); });

TEST(Latin1Names, InADatabaseAreRefusedInWordsAndShownToWhoeverRepairsThem) {
    const TemporaryFolder folder;
    fs::copy(sample("box/box.sigdb"), folder / "a.sigdb");
    fs::permissions(folder / "a.sigdb", fs::perms::owner_write, fs::perm_options::add);
    {
        SQLite::Database file((folder / "a.sigdb").string(), SQLite::OPEN_READWRITE);
        ASSERT_GT(file.exec("UPDATE material SET name = CAST(x'54fc72' AS TEXT)"), 0);
    }
    for (const char* command : {"info", "lint", "export"}) {
        Ran ran = smatBatch({"db", command, "a.sigdb"}, folder.path());
        EXPECT_NE(ran.exitCode, 3) << command << ran.err;
    }
    // As the window opens it.
    const irsg::LoadedSignature loaded = irsg::loadSignatureFile(
        folder / "a.sigdb", irsg::OutsideChanges::accept, irsg::LintErrors::accept);
    EXPECT_FALSE(loaded.changedOutside.empty());
    EXPECT_TRUE(irsg::isUtf8(irsg::draftToJson(loaded.database)));
}

} // namespace
} // namespace smat::test

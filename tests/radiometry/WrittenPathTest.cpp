#include "irsg/core/WrittenPath.h"

#include <fstream>
#include <ostream>

#include <gtest/gtest.h>

#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using smat::test::TemporaryFolder;

struct Name {
    const char *written, *found, *remark;
};

void PrintTo(const Name& row, std::ostream* out) {
    *out << row.written;
}

class WrittenName : public testing::TestWithParam<Name> {
  protected:
    WrittenName() {
        fs::create_directories(folder_ / "Sub/deep");
        for (const char* name : {"part.flt", "Sub/box.flt", "Sub/deep/Wood.PNG", "two.txt",
                                 "TWO.txt", "with\\slash.txt"}) {
            std::ofstream(folder_ / name) << name;
        }
    }
    TemporaryFolder folder_;
};

TEST_P(WrittenName, MeansAFile) {
    const WrittenPath found = findWritten(folder_.path(), GetParam().written);
    const fs::path expected = *GetParam().found == '\0' ? fs::path() : folder_ / GetParam().found;
    EXPECT_EQ(found.file.lexically_normal(), expected.lexically_normal());
    EXPECT_EQ(found.remark, GetParam().remark);
    // Through the whole path, too.
    if (*GetParam().found != '\0') {
        EXPECT_EQ(findWritten({}, (folder_ / GetParam().written).string()).file.lexically_normal(),
                  expected.lexically_normal());
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, WrittenName,
    testing::Values(
        Name{"part.flt", "part.flt", ""}, Name{"./part.flt", "part.flt", ""},
        Name{"with\\slash.txt", "with\\slash.txt", ""},
        Name{"Sub\\box.flt", "Sub/box.flt", "the name Sub\\box.flt is read as Sub/box.flt"},
        Name{".\\Sub\\deep\\..\\box.flt", "Sub/box.flt",
             "the name .\\Sub\\deep\\..\\box.flt is read as Sub/box.flt"},
        Name{"PART.FLT", "part.flt", "the name PART.FLT is read as part.flt"},
        Name{"sub/DEEP/wood.png", "Sub/deep/Wood.PNG",
             "the name sub/DEEP/wood.png is read as Sub/deep/Wood.PNG"},
        Name{"SUB\\box.FLT", "Sub/box.flt", "the name SUB\\box.FLT is read as Sub/box.flt"},
        Name{"Two.txt", "", ""}, Name{"two.txt", "two.txt", ""}, Name{"lost.flt", "", ""},
        Name{"Sub\\lost.flt", "", ""}, Name{"part.flt/x", "", ""}, Name{"", "", ""}));

TEST(WrittenPath, OfAnotherMachineIsLookedForByItsNameAlone) {
    const TemporaryFolder folder;
    std::ofstream(folder / "wood.png") << "x";
    for (const char* written : {"C:\\textures\\wood.png", "/home/other/wood.png",
                                "..\\..\\lost\\wood.png", "D:/lost/WOOD.png"}) {
        EXPECT_EQ(findWrittenOrBeside(folder.path(), written).file, folder / "wood.png") << written;
    }
    EXPECT_TRUE(findWrittenOrBeside(folder.path(), "C:\\textures\\lost.png").file.empty());
    EXPECT_EQ(writtenFileName("C:\\textures\\wood.png"), "wood.png");
    EXPECT_TRUE(isSameName("Wood.PNG", "wood.png"));
    EXPECT_FALSE(isSameName("wood.png", "wood.pn"));
}

} // namespace
} // namespace irsg

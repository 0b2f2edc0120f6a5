#include "irsg/image/FileBytes.h"

#include <fstream>

#include <gmock/gmock.h>

#include "tests/image/ImageFixtures.h"

namespace irsg {
namespace {

using test::inputErrorOf;
using testing::HasSubstr;

TEST(FileBytes, ComeBackAsTheyWereWritten) {
    const test::TemporaryFolder folder;
    const std::string bytes("a\0b\r\n\xff", 6);
    writeFileBytes(folder / "x", bytes);
    EXPECT_EQ(readFileBytes(folder / "x"), bytes);
    writeFileBytes(folder / "x", "");
    EXPECT_EQ(readFileBytes(folder / "x"), "");
}

TEST(FileBytes, LeaveNothingBesideTheFile) {
    const test::TemporaryFolder folder;
    writeFileBytes(folder / "x", "1");
    writeFileBytes(folder / "x", "2");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(FileBytes, KeepTheOldFileWhereTheNewOneCannotBeWritten) {
    const test::TemporaryFolder folder;
    writeFileBytes(folder / "x", "precious");
    std::filesystem::create_directory(folder / "x.part");
    EXPECT_THAT(inputErrorOf([&] { writeFileBytes(folder / "x", "new"); }),
                HasSubstr("cannot be written"));
    EXPECT_EQ(readFileBytes(folder / "x"), "precious");
}

TEST(FileBytes, GoThroughASymbolicLinkThatStaysOne) {
    const test::TemporaryFolder folder;
    writeFileBytes(folder / "real", "old");
    std::filesystem::create_symlink(folder / "real", folder / "link");
    writeFileBytes(folder / "link", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(readFileBytes(folder / "real"), "new");
}

TEST(FileBytes, NameTheFileAndTheReason) {
    const test::TemporaryFolder folder;
    writeFileBytes(folder / "file", "x");
    const struct {
        const char* name;
        std::filesystem::path path;
        const char* reason;
    } rows[] = {
        {"missing folder", folder / "none/x", "No such file or directory"},
        {"a file as folder", folder / "file/x", "Not a directory"},
        {"a folder itself", folder.path(), ""},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const std::string written = inputErrorOf([&] { writeFileBytes(row.path, "x"); });
        EXPECT_THAT(written, HasSubstr(row.path.string()));
        EXPECT_THAT(written, HasSubstr(row.reason));
        const std::string read = inputErrorOf([&] { readFileBytes(row.path); });
        EXPECT_THAT(read, HasSubstr(row.path.string()));
        EXPECT_THAT(read, HasSubstr(row.reason));
    }
}

} // namespace
} // namespace irsg

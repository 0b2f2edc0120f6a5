#include "irsg/core/FileReading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "irsg/core/FileReplacement.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

using smat::test::refusalOf;
using smat::test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

TEST(FileReading, GivesTheWholeOrTheBeginning) {
    const TemporaryFolder folder;
    std::string bytes(10000, 'x');
    bytes.replace(0, 6, std::string("a\0b\r\n\xff", 6));
    writeFileDurably(folder / "a", bytes);
    EXPECT_EQ(readFile(folder / "a"), bytes);
    EXPECT_LT(readFile(folder / "a").capacity(), bytes.size() + 8192) << "in memory once";
    EXPECT_EQ(readFileBeginning(folder / "a", 3), bytes.substr(0, 3));
    EXPECT_EQ(readFileBeginning(folder / "a", 100000), bytes);
    writeFileDurably(folder / "a", "");
    EXPECT_EQ(readFile(folder / "a"), "");
    EXPECT_EQ(readFile("/proc/self/statm").empty(), false) << "of no size that is known before";
}

TEST(FileReading, GivesPiecesOfAFileInTheirOrder) {
    const TemporaryFolder folder;
    std::string bytes;
    for (int i = 0; i < 3'000'000; ++i) {
        bytes += static_cast<char>(i * 7 % 253);
    }
    const auto inPieces = [](const std::filesystem::path& file) {
        std::string all;
        readFileInPieces(file, [&](std::string_view piece) {
            EXPECT_LE(piece.size(), std::size_t{1} << 20);
            all += piece;
        });
        return all;
    };
    for (const std::size_t size : {0, 1, 1 << 20, (1 << 20) + 1, 3'000'000}) {
        writeFileDurably(folder / "a", bytes.substr(0, size));
        EXPECT_EQ(inPieces(folder / "a"), bytes.substr(0, size));
    }
    EXPECT_FALSE(inPieces("/proc/self/statm").empty()) << "of no size that is known before";
}

TEST(FileReading, RefusesWhatHasNoEndOrIsNoFile) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    const struct {
        std::filesystem::path file;
        const char* value;
    } rows[] = {{"/dev/zero", "no file"},
                {folder / "pipe", "no file"},
                {folder.path(), "a folder"},
                {folder / "none", "no such file"}};
    for (const auto& row : rows) {
        EXPECT_THAT(refusalOf([&] { readFile(row.file); }),
                    AllOf(HasSubstr(row.file.string()), HasSubstr(row.value)));
        EXPECT_THAT(refusalOf([&] { readFileBeginning(row.file, 4); }), HasSubstr(row.value));
        EXPECT_THAT(refusalOf([&] { readFileInPieces(row.file, [](std::string_view) {}); }),
                    HasSubstr(row.value));
    }
    writeFileDurably(folder / "a", std::string(3 << 20, 'x'));
    EXPECT_EQ(readFile(folder / "a", 3 << 20).size(), std::size_t{3} << 20);
    EXPECT_THAT(refusalOf([&] { readFile(folder / "a", (3 << 20) - 1); }),
                AllOf(HasSubstr("3145728 bytes"), HasSubstr("at most 2 MiB")));
    EXPECT_THAT(refusalOf([&] {
                    readFileInPieces(
                        folder / "a", [](auto) {}, (3 << 20) - 1);
                }),
                AllOf(HasSubstr("3145728 bytes"), HasSubstr("at most 2 MiB")));
}

/// For a process of its own: protection stays to the end.
void protectAndWrite() {
    const TemporaryFolder folder;
    for (const char* name : {"read", "changed", "noted", "other"}) {
        writeFileDurably(folder / name, "1");
    }
    protectInputs();
    readFile(folder / "read");
    readFile(folder / "changed");
    allowChange(folder / "changed");
    noteInput(folder / "noted");
    std::filesystem::create_hard_link(folder / "read", folder / "link");
    std::filesystem::create_symlink(folder / "read", folder / "arrow");
    for (const char* name : {"read", "noted", "link", "arrow"}) {
        EXPECT_THAT(refusalOf([&] { writeFileDurably(folder / name, "2"); }),
                    AllOf(HasSubstr(name), HasSubstr("an input as output")));
    }
    EXPECT_EQ(readFile(folder / "read"), "1");
    writeFileDurably(folder / "changed", "2");
    writeFileDurably(folder / "other", "2");
    writeFileDurably(folder / "new", "2");
}

TEST(FileReading, KeepsInputsFromBeingWrittenOver) {
    EXPECT_EXIT(
        {
            protectAndWrite();
            _exit(testing::Test::HasFailure() ? 1 : 0);
        },
        testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace irsg

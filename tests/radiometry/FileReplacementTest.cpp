#include "irsg/core/FileReplacement.h"

#include <fstream>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "irsg/core/FileReading.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using smat::test::refusalOf;
using smat::test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

TEST(FileReplacement, IsRefusedBeforehandAsItWouldBeRefused) {
    const TemporaryFolder folder;
    writeFileDurably(folder / "file", "x");
    fs::create_directory(folder / "folder");
    writeFileDurably(folder / "protected", "x");
    fs::permissions(folder / "protected", fs::perms::owner_read);
    fs::create_symlink("file", folder / "link");
    const std::set<std::string> before = namesIn(folder.path());
    for (const char* name : {"nowhere/new", "file/new", "folder", "protected"}) {
        const std::string foreseen = refusalOf([&] { checkWritable(folder / name); });
        EXPECT_EQ(foreseen, refusalOf([&] { writeFileDurably(folder / name, "y"); })) << name;
        EXPECT_NE(foreseen, "nothing was refused") << name;
    }
    for (const char* name : {"new", "file", "link", "/dev/null"}) {
        EXPECT_NO_THROW(checkWritable(folder / name)) << name;
    }
    EXPECT_EQ(namesIn(folder.path()), before);
    EXPECT_EQ(readFile(folder / "file"), "x");
}

TEST(FileReplacement, LeavesTheFileAndNothingBesideIt) {
    const TemporaryFolder folder;
    for (const char* content : {"1", "2"}) {
        writeFileDurably(folder / "x", content);
        EXPECT_EQ(readFile(folder / "x"), content);
        EXPECT_THAT(namesIn(folder.path()), ElementsAre("x"));
    }
    {
        FileReplacement given(folder / "x");
        given.write("3");
        EXPECT_EQ(readFile(folder / "x"), "2");
    }
    EXPECT_EQ(readFile(folder / "x"), "2") << "nothing was committed";
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("x"));
}

TEST(FileReplacement, LeavesFilesOfOthersAlone) {
    const TemporaryFolder folder;
    const auto names = {"x.part", ".x.part", "x.part1", ".x.smat-0.partly", ".y.smat-0.part"};
    for (const char* name : names) {
        writeFileDurably(folder / name, "mine");
    }
    writeFileDurably(folder / "x", "1");
    for (const char* name : names) {
        EXPECT_EQ(readFile(folder / name), "mine") << name;
    }
}

TEST(FileReplacement, RemovesWhatAKilledProgramLeft) {
    const TemporaryFolder folder;
    std::ofstream(folder / ".x.smat-0.part") << "half";
    writeFileDurably(folder / "x", "1");
    EXPECT_EQ(readFile(folder / "x"), "1");
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("x"));
}

TEST(FileReplacement, AWriterLeavesAloneWhatAnotherWritesNow) {
    const TemporaryFolder folder;
    FileReplacement first(folder / "x"), second(folder / "x");
    first.write("first");
    second.write("second");
    EXPECT_THAT(namesIn(folder.path()), ElementsAre(".x.smat-0.part", ".x.smat-1.part"));
    second.commit();
    EXPECT_EQ(readFile(folder / "x"), "second");
    first.commit();
    EXPECT_EQ(readFile(folder / "x"), "first");
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("x"));
}

TEST(FileReplacement, WhatCannotBeALeftOverIsPassedBy) {
    const TemporaryFolder folder;
    writeFileDurably(folder / "others", "mine");
    fs::create_symlink(folder / "others", folder / ".x.smat-0.part");
    fs::create_directory(folder / ".x.smat-1.part");
    ASSERT_EQ(mkfifo((folder / ".x.smat-2.part").c_str(), 0600), 0);
    writeFileDurably(folder / "x", "1");
    EXPECT_EQ(readFile(folder / "x"), "1");
    EXPECT_EQ(readFile(folder / "others"), "mine");
    EXPECT_THAT(namesIn(folder.path()),
                testing::IsSupersetOf({".x.smat-0.part", ".x.smat-1.part"}));
}

TEST(FileReplacement, KeepsPermissionsAndLinks) {
    const TemporaryFolder folder;
    writeFileDurably(folder / "real", "old");
    fs::permissions(folder / "real", fs::perms(0640));
    fs::create_symlink(folder / "real", folder / "link");
    writeFileDurably(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(readFile(folder / "real"), "new");
    EXPECT_EQ(fs::status(folder / "real").permissions(), fs::perms(0640));
    if (geteuid() == 0) {
        ASSERT_EQ(chown((folder / "real").c_str(), 12, 34), 0);
        writeFileDurably(folder / "real", "newer");
        struct stat status {};
        ASSERT_EQ(stat((folder / "real").c_str(), &status), 0);
        EXPECT_EQ(status.st_uid, 12u);
        EXPECT_EQ(status.st_gid, 34u);
    }
    const mode_t before = umask(027);
    writeFileDurably(folder / "other", "1");
    umask(before);
    EXPECT_EQ(fs::status(folder / "other").permissions(), fs::perms(0640));
}

TEST(FileReplacement, RefusesWithTheFileAndTheReason) {
    const TemporaryFolder folder;
    writeFileDurably(folder / "file", "x");
    writeFileDurably(folder / "protected", "x");
    fs::permissions(folder / "protected", fs::perms(0444));
    const struct {
        const char* name;
        fs::path path;
        const char* reason;
    } rows[] = {{"a folder that is missing", folder / "none/x", "a folder that does not exist"},
                {"a file as folder", folder / "file/x", "a folder that does not exist"},
                {"a folder itself", folder.path(), "a folder"},
                {"a protected file", folder / "protected", "write-protected"},
                {"a full device", "/dev/full", "a full disk"}};
    for (const auto& row : rows) {
        EXPECT_THAT(refusalOf([&] { writeFileDurably(row.path, "x"); }),
                    AllOf(HasSubstr(row.path.string()), HasSubstr(row.reason)))
            << row.name;
    }
    writeFileDurably("/dev/null", "x");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    FileReplacement again(folder / "file");
    again.write("y");
    EXPECT_THAT(refusalOf([&] { again.commit(FileReplacement::Existing::refuse); }),
                HasSubstr("exists already"));
    EXPECT_EQ(readFile(folder / "file"), "x");
}

TEST(FileReplacement, ManyWritersOfOneFileLeaveOneOfTheirs) {
    const TemporaryFolder folder;
    std::vector<std::thread> writers;
    for (int i = 0; i < 8; ++i) {
        writers.emplace_back([&, i] {
            for (int round = 0; round < 20; ++round) {
                writeFileDurably(folder / "x", std::string(5000, static_cast<char>('a' + i)));
            }
        });
    }
    for (std::thread& writer : writers) {
        writer.join();
    }
    const std::string content = readFile(folder / "x");
    ASSERT_EQ(content.size(), 5000u);
    EXPECT_EQ(content, std::string(5000, content[0]));
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("x"));
}

} // namespace
} // namespace irsg

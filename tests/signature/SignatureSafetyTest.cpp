#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <random>
#include <set>

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include "irsg/core/FileReplacement.h"
#include "irsg/signature/SignatureFile.h"

#include "Support.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/// The same with more notes than fit in the pages that the small one frees.
SignatureDatabase largerDatabase() {
    SignatureDatabase database = completeDatabase();
    database.title = "larger";
    database.notes = std::string(20000, 'n');
    for (int index = 100; index < 140; ++index) {
        database.materials[index] = database.materials[3];
    }
    return database;
}

/// Runs `work` again and again in a process of its own and kills it after a while. A process that
/// ends by itself was refused something.
void killWhile(const std::function<void(int)>& work, int delay_us) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        try {
            for (int round = 0;; ++round) {
                work(round);
            }
        } catch (...) {
            _exit(1);
        }
    }
    usleep(static_cast<useconds_t>(delay_us));
    ASSERT_EQ(kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the saves were refused";
}

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

/// The same without the hidden left-over of a writer that was killed.
std::set<std::string> wholeNamesIn(const fs::path& folder) {
    std::set<std::string> names = namesIn(folder);
    std::erase_if(names, [](const std::string& name) {
        return name.starts_with(".") && name.ends_with(".smat-0.part");
    });
    return names;
}

/// Moments after the start of a process, us: some before its first save is done, most in the middle
/// of one, whatever this machine takes for a save.
class Moments {
  public:
    explicit Moments(const std::function<void()>& save) {
        const auto begin = std::chrono::steady_clock::now();
        save();
        const std::chrono::duration<double, std::micro> taken =
            std::chrono::steady_clock::now() - begin;
        longest_us_ = std::clamp(static_cast<int>(4.0 * taken.count()), 2000, 40000);
    }
    int next() { return std::uniform_int_distribution<int>(0, longest_us_)(random_); }

  private:
    std::mt19937 random_{20110301};
    int longest_us_ = 0;
};

TEST(SignatureSafety, FourHundredKillsOfASaveLeaveTheOldOrTheNewState) {
    const TemporaryFolder folder;
    const fs::path file = folder / "killed.sigdb";
    const SignatureDatabase states[] = {completeDatabase(), largerDatabase()};
    Moments moments([&] { saveSignatureFile(states[0], file); });
    std::array<int, 2> seen = {0, 0};
    for (int i = 0; i < 400; ++i) {
        killWhile([&](int round) { saveSignatureFile(states[(round + i + 1) % 2], file); },
                  moments.next());
        ASSERT_THAT(wholeNamesIn(folder.path()), ElementsAre("killed.sigdb"));
        const SignatureDatabase found = loadSignatureFile(file).database;
        ASSERT_TRUE(found == states[0] || found == states[1]) << i;
        ++seen[found == states[1]];
    }
    EXPECT_GT(seen[0], 0);
    EXPECT_GT(seen[1], 0);
    saveSignatureFile(states[0], file);
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("killed.sigdb")) << "nothing is left over";
}

TEST(SignatureSafety, AHundredKillsOfAFirstSaveLeaveNoFileOrAWholeOne) {
    const TemporaryFolder folder;
    const SignatureDatabase database = completeDatabase();
    Moments moments([&] { createSignatureFile(database, folder / "first.sigdb"); });
    int whole = 0;
    for (int i = 0; i < 100; ++i) {
        const fs::path inner = folder / std::to_string(i);
        fs::create_directory(inner);
        killWhile(
            [&](int round) {
                createSignatureFile(database, inner / (std::to_string(round) + ".sigdb"));
            },
            moments.next());
        for (const std::string& name : wholeNamesIn(inner)) {
            ASSERT_TRUE(loadSignatureFile(inner / name).database == database) << name;
            ++whole;
        }
    }
    EXPECT_GT(whole, 0);
}

TEST(SignatureSafety, AHundredKillsOfAnExportLeaveTheOldOrTheNewText) {
    const TemporaryFolder folder;
    const fs::path file = folder / "export.json";
    const std::string texts[] = {signatureToJson(completeDatabase()),
                                 signatureToJson(largerDatabase())};
    Moments moments([&] { writeFileDurably(file, texts[0]); });
    for (int i = 0; i < 100; ++i) {
        killWhile([&](int round) { writeFileDurably(file, texts[(round + i + 1) % 2]); },
                  moments.next());
        const std::string found = readBytes(file);
        ASSERT_TRUE(found == texts[0] || found == texts[1]) << i;
    }
    writeFileDurably(file, texts[0]);
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("export.json")) << "nothing is left over";
}

/// A limit on the size of files stands for a disk that is full: as a write that fails in the
/// middle.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        signal(SIGXFSZ, SIG_DFL);
    }

  private:
    rlimit before_{};
};

TEST(SignatureSafety, AWriteThatFailsInTheMiddleLeavesTheOldState) {
    const TemporaryFolder folder;
    const fs::path file = folder / "limited.sigdb";
    saveSignatureFile(completeDatabase(), file);
    const std::string before = readBytes(file);
    const SignatureDatabase larger = largerDatabase();
    for (const rlim_t limit : {0UL, 600UL, 5000UL, 60000UL}) {
        std::vector<Diagnostic> diagnostics;
        {
            const FileSizeLimit limited(limit);
            diagnostics = refusalOf([&] { saveSignatureFile(larger, file); });
            EXPECT_FALSE(
                refusalOf([&] { createSignatureFile(larger, folder / "new.sigdb"); }).empty());
            EXPECT_FALSE(refusalOf([&] {
                             writeFileDurably(folder / "text", std::string(70000, 'x'));
                         }).empty());
        }
        ASSERT_EQ(diagnostics.size(), 1U) << limit;
        EXPECT_EQ(diagnostics[0].file, file.string());
        EXPECT_THAT(diagnostics[0].expected, HasSubstr("the old file is unchanged"));
        EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase()) << limit;
        EXPECT_EQ(readBytes(file), before) << limit;
        EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1)
            << "nothing is left behind";
    }
}

/// What `work` is refused with, in a process of its own that gets another user or another disk by
/// `prepare`; "skip" where that cannot be had.
std::string refusalElsewhere(const std::function<bool()>& prepare,
                             const std::function<std::string()>& work) {
    int ends[2];
    if (pipe(ends) != 0) {
        return "no pipe";
    }
    const pid_t child = fork();
    if (child == 0) {
        const std::string said = prepare() ? work() : "skip";
        _exit(write(ends[1], said.data(), said.size()) < 0 ? 1 : 0);
    }
    close(ends[1]);
    std::string said;
    char piece[512];
    for (ssize_t count = 0; (count = read(ends[0], piece, sizeof piece)) > 0;) {
        said.append(piece, static_cast<std::size_t>(count));
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? said : "ended by a signal";
}

std::string refusalText(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was refused";
}

TEST(SignatureSafety, AFullDiskIsNamedAndLeavesTheOldState) {
    const TemporaryFolder folder;
    const std::string disk = folder.path().string();
    const auto mountSmallDisk = [&] {
        // In a name space of its own, so that the disk is gone with the process.
        return unshare(CLONE_NEWNS) == 0 &&
               mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
               mount("small", disk.c_str(), "tmpfs", 0, "size=131072") == 0;
    };
    const std::string said = refusalElsewhere(mountSmallDisk, [&] {
        const fs::path file = folder / "full.sigdb";
        SignatureDatabase huge = largerDatabase();
        huge.notes = std::string(200000, 'n');
        saveSignatureFile(completeDatabase(), file);
        std::string text = refusalText([&] { saveSignatureFile(huge, file); });
        text += "\n" + refusalText([&] { createSignatureFile(huge, folder / "new.sigdb"); });
        text += "\n" +
                refusalText([&] { writeFileDurably(folder / "a.json", std::string(200000, 'x')); });
        text += loadSignatureFile(file).database == completeDatabase() ? "\nkept" : "\nlost";
        text += fs::exists(folder / "new.sigdb") || fs::exists(folder / "a.json") ? "\nrests" : "";
        return text;
    });
    if (said == "skip") {
        GTEST_SKIP() << "no small disk can be mounted by this user";
    }
    EXPECT_THAT(said, HasSubstr("full.sigdb: found a full disk, expected room"));
    EXPECT_THAT(said, HasSubstr("new.sigdb: found a full disk, expected room"));
    EXPECT_THAT(said, HasSubstr("a.json: found a full disk, expected room"));
    EXPECT_THAT(said, HasSubstr("kept"));
    EXPECT_THAT(said, testing::Not(HasSubstr("rests")));
}

bool becomeNobody() {
    constexpr uid_t nobody = 65534;
    return geteuid() != 0 || setuid(nobody) == 0;
}

TEST(SignatureSafety, AFolderThatIsReadOnlyIsNamedAndItsFilesStillOpen) {
    const TemporaryFolder folder;
    const fs::path file = folder / "here.sigdb";
    saveSignatureFile(completeDatabase(), file);
    fs::permissions(file, fs::perms(0666));
    fs::permissions(folder.path(), fs::perms(0555));
    const std::string said = refusalElsewhere(becomeNobody, [&] {
        std::string text = refusalText([&] { saveSignatureFile(largerDatabase(), file); });
        text += "\n" + refusalText([&] { createSignatureFile({}, folder / "new.sigdb"); });
        text += "\n" + refusalText([&] { writeFileDurably(folder / "a.json", "x"); });
        return text + (loadSignatureFile(file).database == completeDatabase() ? "\nopened" : "");
    });
    fs::permissions(folder.path(), fs::perms(0755));
    EXPECT_THAT(said, HasSubstr("here.sigdb: found a place that cannot be written"));
    EXPECT_THAT(said, HasSubstr("new.sigdb: found a place that cannot be written"));
    EXPECT_THAT(said, HasSubstr("a.json: found a place that cannot be written"));
    EXPECT_THAT(said, HasSubstr("opened"));
    EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
}

TEST(SignatureSafety, AFileThatIsReadOnlyForThisUserIsNamed) {
    const TemporaryFolder folder;
    const fs::path file = folder / "theirs.sigdb";
    saveSignatureFile(completeDatabase(), file);
    fs::permissions(file, fs::perms(0644));
    fs::permissions(folder.path(), fs::perms(0777));
    if (geteuid() != 0) {
        GTEST_SKIP() << "the file is this user's own";
    }
    const std::string said = refusalElsewhere(
        becomeNobody, [&] { return refusalText([&] { saveSignatureFile({}, file); }); });
    EXPECT_THAT(said, HasSubstr("theirs.sigdb: found a file or folder that cannot be written"));
    EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
}

TEST(SignatureSafety, WhatAnotherWindowSavedIsNotSavedOver) {
    const TemporaryFolder folder;
    const fs::path file = folder / "shared.sigdb";
    saveSignatureFile(completeDatabase(), file);
    const SignatureDatabase opened = loadSignatureFile(file).database;
    SignatureDatabase mine = opened;
    mine.title = "mine";
    SignatureDatabase theirs = opened;
    theirs.materials[0].notes = "theirs";

    saveSignatureFile(theirs, file, opened);
    const auto diagnostics = refusalOf([&] { saveSignatureFile(mine, file, opened); });
    ASSERT_EQ(diagnostics.size(), 1U);
    EXPECT_EQ(diagnostics[0].value, "another content than was opened here");
    EXPECT_THAT(diagnostics[0].expected, HasSubstr("save under another name"));
    EXPECT_TRUE(loadSignatureFile(file).database == theirs);

    // Having looked at theirs, one may.
    saveSignatureFile(mine, file, theirs);
    EXPECT_TRUE(loadSignatureFile(file).database == mine);
    // A file that is gone is made again.
    fs::remove(file);
    saveSignatureFile(theirs, file, mine);
    EXPECT_TRUE(loadSignatureFile(file).database == theirs);
}

TEST(SignatureSafety, WhatOthersKeepInTheFileStaysAndWhoHadTheOldOneOpenCannotWrite) {
    const TemporaryFolder folder;
    const fs::path file = folder / "open.sigdb";
    saveSignatureFile(completeDatabase(), file);
    SQLite::Database tool(file.string(), SQLite::OPEN_READWRITE);
    // A log beside the file, as some tools prefer, comes into it.
    tool.exec("PRAGMA journal_mode = WAL; CREATE TABLE theirs (x); INSERT INTO theirs VALUES (7)");
    EXPECT_THAT(refusalOf([&] { saveSignatureFile(largerDatabase(), file); })[0].value,
                HasSubstr("another program has locked"));
    tool.exec("PRAGMA journal_mode = DELETE");
    saveSignatureFile(largerDatabase(), file);
    EXPECT_TRUE(loadSignatureFile(file).database == largerDatabase());
    EXPECT_THROW(tool.exec("INSERT INTO theirs VALUES (8)"), SQLite::Exception);
    SQLite::Database again(file.string(), SQLite::OPEN_READONLY);
    EXPECT_EQ(again.execAndGet("SELECT sum(x) FROM theirs").getInt(), 7);
    EXPECT_THAT(namesIn(folder.path()), ElementsAre("open.sigdb"));
}

TEST(SignatureSafety, ANewFileIsNeverPutInThePlaceOfAnother) {
    const TemporaryFolder folder;
    const fs::path file = folder / "taken.sigdb";
    saveSignatureFile(completeDatabase(), file);
    EXPECT_EQ(refusalOf([&] { createSignatureFile({}, file); })[0].value,
              "a file that exists already");
    EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
}

TEST(SignatureSafety, TwoProcessesThatSaveAtOnceLeaveOneOfTheirStates) {
    const TemporaryFolder folder;
    const fs::path file = folder / "both.sigdb";
    const SignatureDatabase states[] = {completeDatabase(), largerDatabase()};
    saveSignatureFile(states[0], file);
    const auto saveOften = [&](int which) {
        const pid_t child = fork();
        if (child == 0) {
            int refused = 0;
            for (int i = 0; i < 20; ++i) {
                try {
                    saveSignatureFile(states[which], file);
                } catch (const InputError&) {
                    ++refused;
                }
            }
            _exit(refused);
        }
        return child;
    };
    const pid_t children[] = {saveOften(0), saveOften(1)};
    // Whoever reads meanwhile sees one of the two, or is told that the file is locked.
    for (int i = 0; i < 20; ++i) {
        try {
            const SignatureDatabase found = loadSignatureFile(file).database;
            EXPECT_TRUE(found == states[0] || found == states[1]);
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("locked"));
        }
    }
    for (const pid_t child : children) {
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_TRUE(WIFEXITED(status));
        EXPECT_LT(WEXITSTATUS(status), 20) << "one of its saves at least came through";
    }
    const SignatureDatabase found = loadSignatureFile(file).database;
    EXPECT_TRUE(found == states[0] || found == states[1]);
}

TEST(SignatureSafety, AReplacementKeepsRightsAndFollowsLinks) {
    const TemporaryFolder folder;
    const fs::path file = folder / "real.json";
    writeFileDurably(file, "old");
    fs::permissions(file, fs::perms(0640));
    fs::create_symlink(file, folder / "link.json");
    writeFileDurably(folder / "link.json", "new");
    EXPECT_EQ(readBytes(file), "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link.json"));
    EXPECT_EQ(fs::status(file).permissions(), fs::perms(0640));
}

} // namespace
} // namespace irsg

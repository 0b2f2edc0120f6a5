#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "irsg/core/FileReading.h"
#include "tests/core/Writers.h"
#include "tests/support/EveryCall.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/WalkedReaders.h"

namespace smat::test {

void PrintTo(const Writer& writer, std::ostream* out) {
    *out << writer.name;
}

namespace {

namespace fs = std::filesystem;

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

/// ".NAME.smat-0.part"
bool isNameOfLeftOver(const std::string& name) {
    return name.starts_with(".") && name.ends_with(".smat-0.part");
}

class EveryWriter : public testing::TestWithParam<Writer> {
  protected:
    void SetUp() override {
        if (!callsCanBeWatched()) {
            GTEST_SKIP() << "one process cannot watch the calls of another here";
        }
        // Some thousand files are brought to the disk: to one in memory, where there is one.
        if (access("/dev/shm", W_OK) == 0) {
            setenv("TMPDIR", "/dev/shm", 1);
        }
        const TemporaryFolder folder;
        const fs::path file = folder / GetParam().file;
        for (const bool second : {false, true}) {
            GetParam().write(file, second);
            (second ? new_ : old_) = GetParam().content(file);
            if (!second) {
                oldBytes_ = irsg::readFile(file);
            }
        }
        if (GetParam().replaces) {
            ASSERT_NE(old_, new_);
        }
    }

    void TearDown() override {
        if (before_.empty()) {
            unsetenv("TMPDIR");
        } else {
            setenv("TMPDIR", before_.c_str(), 1);
        }
    }

    /// Old or new, whole, and nothing beside it but the hidden left-over of a writer that was
    /// killed, which the next one removes. Where nothing was, nothing else may be left.
    Ended meets(const Mishap& mishap, bool stands) {
        const Writer& writer = GetParam();
        const TemporaryFolder folder;
        const fs::path file = folder / writer.file;
        if (stands) {
            writtenFile(file, oldBytes_);
        }
        Ended ended = doWatched([&] { writer.write(file, true); }, mishap);
        const std::string where = std::string(mishap.kind == Mishap::fails ? "failed" : "killed") +
                                  " at call " + std::to_string(mishap.call) + ", number " +
                                  ended.name + (stands ? " over a file" : " where nothing was");
        if (mishap.kind == Mishap::fails) {
            EXPECT_TRUE(ended.exitCode == 0 || ended.exitCode == 2) << where << ended.exitCode;
        }
        const bool isThere = fs::exists(file);
        EXPECT_TRUE(isThere || !stands) << where;
        if (isThere) {
            const std::string content = contentOf(file);
            EXPECT_TRUE(content == new_ || (stands && content == old_)) << where;
            if (ended.exitCode == 0) {
                EXPECT_EQ(content, new_) << where;
            }
        }
        std::set<std::string> names = namesBesideCompanions(folder.path());
        const bool isLeftOver =
            std::erase_if(names, [](const auto& name) { return isNameOfLeftOver(name); }) > 0;
        EXPECT_EQ(names, isThere ? std::set<std::string>{writer.file} : std::set<std::string>())
            << where;
        if (isLeftOver) {
            EXPECT_EQ(ended.exitCode, -1) << where << ", not killed, and left something over";
            writer.write(file, true);
            EXPECT_EQ(contentOf(file), new_) << where;
            EXPECT_EQ(namesBesideCompanions(folder.path()), std::set<std::string>{writer.file})
                << where;
        }
        leftOver_ = leftOver_ || isLeftOver;
        return ended;
    }

    std::set<std::string> namesBesideCompanions(const fs::path& folder) const {
        std::set<std::string> names = namesIn(folder);
        for (const std::string& companion : GetParam().companions) {
            names.erase(companion);
        }
        return names;
    }

    void meetsEveryMishap(bool onlyWriting) {
        const Writer& writer = GetParam();
        for (const bool stands : {false, true}) {
            if (stands && !writer.replaces) {
                continue;
            }
            const Ended whole = meets({Mishap::none, 0, 0, onlyWriting}, stands);
            ASSERT_EQ(whole.exitCode, 0);
            ASSERT_GT(whole.calls, 5);
            ASSERT_LT(whole.calls, onlyWriting ? 60 : 3000);
            for (long call = 1; call <= whole.calls && !HasFailure(); ++call) {
                Mishap mishap{Mishap::killed, call, 0, onlyWriting};
                meets(mishap, stands);
                mishap.kind = Mishap::fails;
                mishap.error = call % 2 == 0 ? ENOSPC : EIO;
                meets(mishap, stands);
            }
        }
        EXPECT_TRUE(leftOver_) << "no kill met a file on its way";
    }

    /// Equal bytes are looked into once.
    const std::string& contentOf(const fs::path& file) {
        const std::string bytes = irsg::readFile(file);
        if (!known_.contains(bytes)) {
            known_[bytes] = GetParam().content(file);
        }
        return known_[bytes];
    }

    const std::string before_ = std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "";
    std::string old_, new_, oldBytes_;
    std::map<std::string, std::string> known_; ///< content by bytes
    bool leftOver_ = false;                    ///< by any of those that were killed
};

class AWayOfWriting : public EveryWriter {};

TEST_P(AWayOfWriting, LeavesTheOldFileOrTheNewOneWhateverHappensAtAnyCall) {
    meetsEveryMishap(false);
}

INSTANTIATE_TEST_SUITE_P(All, AWayOfWriting, testing::ValuesIn(waysOfWriting()),
                         [](const auto& writer) { return std::string(writer.param.name); });

TEST(WalkedReaders, WritersAreAsManyAsThePageHas) {
    expectWalked("a kill or a failing call while a file is written",
                 waysOfWriting().size() + otherWriters().size());
}

class AnotherWriter : public EveryWriter {};

/// What is before it opens its first file for writing changes nothing on the disk.
TEST_P(AnotherWriter, LeavesTheOldFileOrTheNewOneWhateverHappensOnceItWrites) {
    meetsEveryMishap(true);
}

INSTANTIATE_TEST_SUITE_P(All, AnotherWriter, testing::ValuesIn(otherWriters()),
                         [](const auto& writer) { return std::string(writer.param.name); });

} // namespace
} // namespace smat::test

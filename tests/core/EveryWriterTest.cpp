#include <cerrno>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/Writers.h"
#include "tests/support/EveryCall.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {

void PrintTo(const Writer& writer, std::ostream* out) {
    *out << writer.name;
}

namespace {

namespace fs = std::filesystem;

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

class EveryWriter : public testing::TestWithParam<Writer> {
  protected:
    void SetUp() override {
        if (!callsCanBeWatched())
            GTEST_SKIP() << "one process cannot watch the calls of another here";
        const TemporaryFolder folder;
        const fs::path file = folder / GetParam().file;
        for (const bool second : {false, true}) {
            GetParam().write(file, second);
            (second ? new_ : old_) = GetParam().content(file);
        }
        if (GetParam().replaces) {
            ASSERT_NE(old_, new_);
        }
    }

    /// Old or new, whole, and nothing beside it; where nothing was, nothing may be left.
    void meets(const Mishap& mishap, bool stands) {
        const Writer& writer = GetParam();
        const TemporaryFolder folder;
        const fs::path file = folder / writer.file;
        // By another process: this one remembers the folders that it has cleared.
        if (stands)
            doElsewhere([&] { writer.write(file, false); });
        const Ended ended = doWatched([&] { writer.write(file, true); }, mishap);
        const std::string where = std::string(mishap.kind == Mishap::killed ? "killed" : "failed") +
                                  " at call " + std::to_string(mishap.call) + ", number " +
                                  ended.name + (stands ? " over a file" : " where nothing was");
        if (mishap.kind == Mishap::fails) {
            EXPECT_TRUE(ended.exitCode == 0 || ended.exitCode == 2) << where << ended.exitCode;
        }
        const bool isThere = fs::exists(file);
        EXPECT_TRUE(isThere || !stands) << where;
        if (isThere) {
            const std::string content = writer.content(file);
            EXPECT_TRUE(content == new_ || (stands && content == old_)) << where;
            if (ended.exitCode == 0) {
                EXPECT_EQ(content, new_) << where;
            }
        }
        if (mishap.kind == Mishap::killed) {
            // Whoever writes next clears away what a killed program could not.
            EXPECT_EQ(doElsewhere([&] { writer.write(file, true); }), 0) << where;
        }
        std::set<std::string> names = namesIn(folder.path());
        for (const std::string& companion : writer.companions)
            names.erase(companion);
        EXPECT_EQ(names,
                  fs::exists(file) ? std::set<std::string>{writer.file} : std::set<std::string>())
            << where;
    }

    void meetsEveryMishap(bool onlyWriting) {
        const Writer& writer = GetParam();
        for (const bool stands : {false, true}) {
            if (stands && !writer.replaces)
                continue;
            const TemporaryFolder folder;
            if (stands)
                writer.write(folder / writer.file, false);
            const Ended whole = doWatched([&] { writer.write(folder / writer.file, true); },
                                          {Mishap::none, 0, 0, onlyWriting});
            ASSERT_EQ(whole.exitCode, 0);
            ASSERT_GT(whole.calls, 5);
            ASSERT_LT(whole.calls, onlyWriting ? 60 : 3000);
            for (long call = 1; call <= whole.calls; ++call) {
                meets({Mishap::killed, call, 0, onlyWriting}, stands);
                meets({Mishap::fails, call, call % 2 == 0 ? ENOSPC : EIO, onlyWriting}, stands);
                if (HasFailure())
                    return;
            }
        }
    }

    std::string old_, new_;
};

class AWayOfWriting : public EveryWriter {};

TEST_P(AWayOfWriting, LeavesTheOldFileOrTheNewOneWhateverHappensAtAnyCall) {
    meetsEveryMishap(false);
}

INSTANTIATE_TEST_SUITE_P(All, AWayOfWriting, testing::ValuesIn(waysOfWriting()),
                         [](const auto& writer) { return std::string(writer.param.name); });

class AnotherWriter : public EveryWriter {};

/// What is before it opens its first file for writing changes nothing on the disk.
TEST_P(AnotherWriter, LeavesTheOldFileOrTheNewOneWhateverHappensOnceItWrites) {
    meetsEveryMishap(true);
}

INSTANTIATE_TEST_SUITE_P(All, AnotherWriter, testing::ValuesIn(otherWriters()),
                         [](const auto& writer) { return std::string(writer.param.name); });

} // namespace
} // namespace smat::test

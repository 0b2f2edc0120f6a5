#include <fstream>

#include <gtest/gtest.h>

#include "irsg/atmosphere/ck/CkStore.h"
#include "irsg/core/FileReading.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using smat::test::TemporaryFolder;

std::size_t filesIn(const fs::path& folder) {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        count += entry.is_regular_file();
    }
    return count;
}

fs::path onlyFile(const fs::path& folder) {
    return fs::directory_iterator(folder)->path();
}

TEST(CkStore, GivesBackWhatWasKeptUnderTheSameKey) {
    const TemporaryFolder folder;
    const CkStore store(folder.path() / "not" / "there");
    const std::string key = CkKey().add(0.1).add("air").text();
    EXPECT_FALSE(store.find(key));
    store.keep(key, "points\n1 2");
    EXPECT_EQ(store.find(key), "points\n1 2");
    EXPECT_EQ(CkStore(folder.path() / "not" / "there").find(key), "points\n1 2");
    EXPECT_FALSE(store.find(CkKey().add(0.1 + 1e-17 + 1e-16).add("air").text()));
    store.keep(key, "other");
    EXPECT_EQ(store.find(key), "other");
}

TEST(CkStore, KeysTellNumbersAndTextsApart) {
    EXPECT_NE(CkKey().add("1").add("2").text(), CkKey().add("1 2").text());
    EXPECT_NE(CkKey().add(0.1).text(), CkKey().add(0.1 * (1.0 + 1e-15)).text());
}

TEST(CkStore, WhatIsDamagedIsNotThere) {
    const TemporaryFolder folder;
    const CkStore store(folder.path());
    store.keep("key", "points");
    const fs::path file = onlyFile(folder.path());
    for (const std::string text :
         {"", "wideband", "wideband terms 1\n", "wideband terms 1\n4:kex terms"}) {
        std::ofstream(file) << text;
        EXPECT_FALSE(store.find("key")) << text;
    }
    store.keep("key", "points");
    ASSERT_EQ(store.find("key"), "points");
    const std::string whole = readFile(file);
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string bad = whole;
        bad[at] = static_cast<char>(bad[at] ^ 1);
        std::ofstream(file) << bad;
        EXPECT_FALSE(store.find("key")) << bad;
        std::ofstream(file) << whole.substr(0, at);
        EXPECT_FALSE(store.find("key")) << "cut to " << at;
    }
}

TEST(CkStore, ForgetsWhatWasNotUsedForTheLongestTime) {
    const TemporaryFolder folder;
    const CkStore store(folder.path(), 4000);
    const auto now = fs::file_time_type::clock::now();
    for (int i = 0; i < 8; ++i) {
        store.keep("key " + std::to_string(i), std::string(900, 'x'));
        for (const auto& entry : fs::directory_iterator(folder.path())) {
            if (entry.last_write_time() > now - std::chrono::seconds(1)) {
                fs::last_write_time(entry, now - std::chrono::hours(20 - i));
            }
        }
        (void)store.find("key 0"); // used again and again
    }
    EXPECT_LE(filesIn(folder.path()), 4u);
    EXPECT_TRUE(store.find("key 0"));
    EXPECT_FALSE(store.find("key 2"));
    EXPECT_TRUE(store.find("key 7"));
}

TEST(CkStore, AFolderThatCannotBeWrittenIsNoFault) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "file") << "no folder";
    const CkStore store(folder.path() / "file" / "below");
    EXPECT_NO_THROW(store.keep("key", "points"));
    EXPECT_FALSE(store.find("key"));
}

} // namespace
} // namespace irsg

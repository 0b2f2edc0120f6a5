#include <fstream>
#include <initializer_list>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/CacheStore.h"
#include "irsg/core/FileReading.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using smat::test::TemporaryFolder;

const CacheStore::Kind points{"points", 1 << 20};

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

TEST(CacheStore, GivesBackWhatWasKeptUnderTheSameKey) {
    const TemporaryFolder folder;
    const CacheStore store(folder.path() / "not" / "there", points);
    const std::string key = CacheKey().add(0.1).add("air").text();
    EXPECT_FALSE(store.find(key));
    store.keep(key, "points\n1 2");
    EXPECT_EQ(store.find(key), "points\n1 2");
    EXPECT_EQ(CacheStore(folder.path() / "not" / "there", points).find(key), "points\n1 2");
    EXPECT_FALSE(store.find(CacheKey().add(0.1 + 1e-17 + 1e-16).add("air").text()));
    store.keep(key, "other");
    EXPECT_EQ(store.find(key), "other");
}

TEST(CacheStore, KeysTellNumbersAndTextsApart) {
    EXPECT_NE(CacheKey().add("1").add("2").text(), CacheKey().add("1 2").text());
    EXPECT_NE(CacheKey().add(0.1).text(), CacheKey().add(0.1 * (1.0 + 1e-15)).text());
}

TEST(CacheStore, WhatIsDamagedIsNotThere) {
    const TemporaryFolder folder;
    const CacheStore store(folder.path(), points);
    store.keep("key", "points");
    const fs::path file = onlyFile(folder.path());
    for (const std::string text : {"", "smat", "smat cache 3\n", "smat cache 3\n4:kex cache"}) {
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

TEST(CacheStore, ForgetsWhatWasNotUsedForTheLongestTime) {
    const TemporaryFolder folder;
    const CacheStore store(folder.path(), {"points", 4000});
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
    store.keep("key 8", std::string(1001, 'x')); // takes more than a quarter of the room
    EXPECT_FALSE(store.find("key 8"));
    EXPECT_TRUE(store.find("key 0"));
}

TEST(ContentDigests, TellContentsApart) {
    const auto digestOf = [](std::initializer_list<std::string> pieces) {
        ContentDigest digest;
        for (const std::string& piece : pieces) {
            digest.add(std::as_bytes(std::span(piece)));
        }
        return digest.text();
    };
    std::set<std::string> digests;
    for (const std::string& text :
         std::vector<std::string>{"", std::string(1, '\0'), std::string(2, '\0'), "a", "b"}) {
        EXPECT_TRUE(digests.insert(digestOf({text})).second) << text;
    }
    std::string bytes(64, 'x');
    EXPECT_TRUE(digests.insert(digestOf({bytes})).second);
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string other = bytes;
            other[at] = static_cast<char>(other[at] ^ (1 << bit));
            EXPECT_TRUE(digests.insert(digestOf({other})).second) << at << " " << bit;
        }
    }
    EXPECT_EQ(digestOf({"one", "two"}), digestOf({"one", "two"}));
}

TEST(CacheStore, AFolderThatCannotBeWrittenIsNoFault) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "file") << "no folder";
    const CacheStore store(folder.path() / "file" / "below", points);
    EXPECT_NO_THROW(store.keep("key", "points"));
    EXPECT_FALSE(store.find("key"));
}

} // namespace
} // namespace irsg

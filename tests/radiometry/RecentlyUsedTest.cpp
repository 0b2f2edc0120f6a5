#include "irsg/core/RecentlyUsed.h"

#include <string>

#include <gtest/gtest.h>

using namespace irsg;

namespace {

const auto is = [](int number) { return [number](int known) { return known == number; }; };

} // namespace

TEST(RecentlyUsed, WhatWasNotAskedForLongestGoes) {
    RecentlyUsed<int> kept(3);
    for (const int number : {1, 2, 3}) {
        kept.add(number);
    }
    ASSERT_NE(kept.find(is(1)), nullptr);
    kept.add(4);
    EXPECT_EQ(kept.find(is(2)), nullptr);
    for (const int number : {1, 3, 4}) {
        EXPECT_NE(kept.find(is(number)), nullptr) << number;
    }
    EXPECT_EQ(kept.size(), 3U);
}

TEST(RecentlyUsed, MakesWhatIsNotThereOnce) {
    RecentlyUsed<std::string> kept(2);
    int made = 0;
    const auto of = [&](const std::string& word) -> std::string& {
        return kept.of([&](const std::string& known) { return known == word; },
                       [&] {
                           ++made;
                           return word;
                       });
    };
    const std::string* const first = &of("a");
    of("b");
    EXPECT_EQ(&of("a"), first); // values stay where they are
    EXPECT_EQ(made, 2);
    of("c"); // in place of b
    of("a");
    EXPECT_EQ(made, 3);
    of("b");
    EXPECT_EQ(made, 4);
}

TEST(RecentlyUsed, LetsGoFromTheLatestOn) {
    RecentlyUsed<int> kept(9);
    for (int number = 1; number <= 5; ++number) {
        kept.add(number);
    }
    int seen = 0;
    kept.letGo([&](int) { return ++seen > 2; });
    EXPECT_EQ(kept.size(), 2U);
    EXPECT_NE(kept.find(is(5)), nullptr);
    EXPECT_NE(kept.find(is(4)), nullptr);
    kept.clear();
    EXPECT_EQ(kept.size(), 0U);
}

#include "irsg/core/StageReport.h"

#include <algorithm>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/ParallelFor.h"
#include "smatcore/support/CurrentStage.h"
#include "smatcore/support/Progress.h"

namespace irsg {
namespace {

using testing::ElementsAre;

/// What a listener was told, in order: "pairs 50 %".
struct Told {
    std::vector<std::string> all;
    StageListener listener{[this](std::string_view stage, std::optional<double> share) {
        all.push_back(std::string(stage) +
                      (share ? " " + std::to_string(static_cast<int>(100.0 * *share)) + " %" : ""));
    }};
};

TEST(StageReport, StagesBeginAndEndWithinEachOther) {
    Told told;
    {
        const StageScope outer("outer");
        const StageScope inner("inner");
    }
    EXPECT_THAT(told.all, ElementsAre("outer", "inner", "outer", ""));
}

TEST(StageReport, PiecesOfAPartAreToldByThePercent) {
    Told told;
    {
        const StageScope stage("inter-reflection");
        StageCount count("pairs", 4);
        count.add();
        count.add(2);
        count.add(5); // more than there are
    }
    EXPECT_THAT(told.all,
                ElementsAre("inter-reflection", "inter-reflection: pairs 0 %",
                            "inter-reflection: pairs 25 %", "inter-reflection: pairs 75 %",
                            "inter-reflection: pairs 100 %", "inter-reflection", ""));
    told.all.clear();
    {
        StageCount many("many", 100'000);
        for (int i = 0; i < 100'000; ++i) {
            many.add();
        }
    }
    EXPECT_EQ(told.all.size(), 102u);
    told.all.clear();
    StageCount none("nothing", 0);
    EXPECT_THAT(told.all, ElementsAre("nothing 0 %"));
}

TEST(StageReport, PiecesOfOtherThreadsCountAndSharesRise) {
    Told told;
    std::vector<double> shares;
    const StageListener listener([&](std::string_view, std::optional<double> share) {
        shares.push_back(share.value_or(-1.0)); // one at a time
    });
    {
        StageCount count("pieces", 10'000);
        parallelFor(10'000, [&](std::size_t) { count.add(); });
    }
    EXPECT_TRUE(told.all.empty()); // the latest listener is told
    ASSERT_GE(shares.size(), 3u);
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), -1.0);
    shares.pop_back();
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    // None of them by a thread of the caller.
    {
        StageCount count("pieces", 4);
        std::thread([&] { count.add(3); }).join();
        EXPECT_EQ(shares.back(), 0.75);
    }
}

TEST(StageReport, WithoutAListenerNothingHappens) {
    const StageScope stage("stage");
    StageCount count("part", 10);
    count.add();
    std::thread other([] {
        const StageListener listener(
            [](std::string_view, std::optional<double>) { FAIL() << "told of another thread"; });
        std::thread([] { const StageScope elsewhere("elsewhere"); }).join();
    });
    other.join();
}

TEST(CurrentStage, IsReadByOtherThreadsAndEmptyInTheEnd) {
    smat::CurrentStage stage;
    const auto read = [&] {
        std::string text;
        std::thread([&] { text = stage.text(); }).join();
        return text;
    };
    {
        const smat::CurrentStage::Listening listening(stage);
        EXPECT_EQ(read(), "");
        const StageScope scope("inter-reflection");
        EXPECT_EQ(read(), "inter-reflection");
        StageCount count("pairs", 3);
        count.add();
        EXPECT_EQ(read(), "inter-reflection: pairs, 33 %");
    }
    EXPECT_EQ(read(), "");
}

TEST(Progress, IsALineForPeople) {
    smat::Progress progress{0, 72, 3.04, "polar: azimuth 0 deg"};
    EXPECT_EQ(progress.text(), "polar: azimuth 0 deg  0/72  0 %  3.0 s");
    EXPECT_EQ(progress.text("inter-reflection: pairs, 43 %"),
              "polar: azimuth 0 deg  0/72  0 %  3.0 s  inter-reflection: pairs, 43 %");
    progress.done = 18;
    progress.elapsed_s = 5.0;
    EXPECT_EQ(progress.text(), "polar: azimuth 0 deg  18/72  25 %  5.0 s, 15 s left");
}

} // namespace
} // namespace irsg

#include "smatcore/support/StageTimer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace smat {
namespace {

double sumOf(const StageTimer& timer) {
    double sum = 0.0;
    for (const StageTimer::Stage& stage : timer.stages()) {
        sum += stage.seconds;
    }
    return sum;
}

/// Work that takes some time, whatever the machine.
double busy() {
    double x = 1.0;
    for (int i = 1; i < 200000; ++i) {
        x += 1.0 / (x + i);
    }
    return x;
}

TEST(StageTimer, StagesAndOtherAddUpToTheWallTime) {
    StageTimer timer;
    volatile double kept = busy();
    {
        const StageTimer::Scope scope(&timer, "outer");
        kept = busy();
        const StageTimer::Scope inner(&timer, "inner");
        kept = busy();
    }
    kept = busy();
    EXPECT_GT(kept, 0.0);
    const double before_s = timer.wall_s();
    const double sum_s = sumOf(timer);
    EXPECT_GE(sum_s, before_s - 1e-9);
    EXPECT_LE(sum_s, timer.wall_s() + 1e-9);
    const auto stages = timer.stages();
    ASSERT_EQ(stages.size(), 3u);
    EXPECT_EQ(stages[0].name, "outer");
    EXPECT_EQ(stages[1].name, "inner");
    EXPECT_EQ(stages[2].name, "other");
    for (const StageTimer::Stage& stage : stages) {
        EXPECT_GT(stage.seconds, 0.0) << stage.name;
    }
}

TEST(StageTimer, ASplitKeepsTheSum) {
    StageTimer timer;
    {
        const StageTimer::Scope scope(&timer, "analyse");
        volatile double kept = busy();
        EXPECT_GT(kept, 0.0);
    }
    const double before = timer.stages()[0].seconds;
    timer.split("analyse", {{"draw", before / 4, 3}, {"read", 1e9, 1}});
    const auto stages = timer.stages();
    EXPECT_EQ(stages[1].name, "analyse: draw");
    EXPECT_EQ(stages[1].calls, 3);
    EXPECT_DOUBLE_EQ(stages[0].seconds + stages[1].seconds + stages[2].seconds, before);
    EXPECT_GE(stages[0].seconds, 0.0);
}

TEST(StageTimer, HoldsWhatWasOverBefore) {
    StageTimer timer;
    timer.addBefore("start", 0.25);
    EXPECT_EQ(timer.stages()[0].name, "start");
    EXPECT_EQ(timer.stages()[0].seconds, 0.25);
    EXPECT_GE(timer.wall_s(), 0.25);
    EXPECT_NEAR(sumOf(timer), timer.wall_s(), 0.01);
}

TEST(StageTimer, CountsCallsAndNeedsNoTimer) {
    StageTimer timer;
    for (int i = 0; i < 3; ++i) {
        const StageTimer::Scope scope(&timer, "draw");
        const StageTimer::Scope none(nullptr, "nothing");
    }
    EXPECT_EQ(timer.stages()[0].calls, 3);
    EXPECT_THAT(timer.toText(), testing::HasSubstr("draw"));
    EXPECT_THAT(timer.toText(), testing::HasSubstr("other"));
}

} // namespace
} // namespace smat

#include "gui/widgets/LatestTask.h"

#include <cstdlib>

#include <unistd.h>

#include <QApplication>
#include <QTest>
#include <gtest/gtest.h>

#include "tests/gui/SampleProject.h"

namespace smat::gui {
namespace {

TEST(LatestTaskTest, OnlyTheLastAnswerCounts) {
    LatestTask task;
    std::vector<int> heard;
    for (int i = 0; i < 5; ++i) {
        task.run<int>([i] { return i; }, [&](int answer) { heard.push_back(answer); });
    }
    EXPECT_TRUE(task.isBusy());
    ASSERT_TRUE(test::waitUntil([&] { return !task.isBusy(); }));
    EXPECT_EQ(heard, std::vector{4});
    task.run<int>([] { return 5; }, [&](int answer) { heard.push_back(answer); });
    task.cancel();
    backgroundPool().waitForDone();
    QTest::qWait(10);
    EXPECT_EQ(heard.size(), 1U);
}

TEST(LatestTaskTest, AnAnswerMayEndItsOwnTask) {
    auto task = std::make_unique<LatestTask>();
    task->run<int>([] { return 1; }, [&](int) { task.reset(); });
    EXPECT_TRUE(test::waitUntil([&] { return task == nullptr; }));
}

/// The program ends while an answer waits for a turn of the event loop that never comes: once it
/// waited for ever for its own queue.
TEST(LatestTaskTest, AnAnswerThatNobodyFetchesDoesNotHoldUpTheEnd) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            alarm(60); // a program that hangs is ended by a signal
            auto task = std::make_unique<LatestTask>();
            task->run<int>([] { return 1; }, [](int) {});
            backgroundPool().waitForDone();
            task.reset();
            delete QApplication::instance();
            std::_Exit(0);
        },
        ::testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace smat::gui

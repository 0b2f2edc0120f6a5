#include "irsg/core/TaskThread.h"

#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

using namespace irsg;

TEST(TaskThread, DoesWhatItIsGivenInOrderOnOneThread) {
    std::vector<int> done;
    std::vector<std::thread::id> threads;
    {
        TaskThread thread;
        for (int i = 0; i < 100; ++i) {
            thread.post([&, i] {
                done.push_back(i);
                threads.push_back(std::this_thread::get_id());
            });
        }
    } // does what it was given first
    ASSERT_EQ(done.size(), 100u);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
        EXPECT_EQ(threads[static_cast<std::size_t>(i)], threads.front());
    }
    EXPECT_NE(threads.front(), std::this_thread::get_id());
}

TEST(TaskThread, ThrowsWhatATaskThrewToWhoWaitsForIt) {
    TaskThread thread;
    auto fails = thread.post([] { throw std::runtime_error("no"); });
    auto works = thread.post([] {});
    EXPECT_THROW(fails.get(), std::runtime_error);
    EXPECT_NO_THROW(works.get());
}

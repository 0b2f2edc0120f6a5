#include "irsg/core/ParallelFor.h"

#include <array>
#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

using namespace irsg;

namespace {

/// Puts the number of threads back.
struct Threads {
    explicit Threads(unsigned count) { setMostThreads(count); }
    ~Threads() { setMostThreads(0); }
};

} // namespace

TEST(ParallelFor, DoesEveryPieceOnceWhateverTheNumberOfThreads) {
    for (const unsigned threads : {1U, 2U, 5U}) {
        const Threads limited(threads);
        for (const std::size_t count : {0U, 1U, 2U, 7U, 16U, 17U, 1000U}) {
            std::vector<std::atomic<int>> done(count);
            parallelFor(count, [&](std::size_t i) { ++done[i]; });
            parallelForSmall(count, [&](std::uint32_t i) { ++done[i]; });
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_EQ(done[i], 2) << i << " of " << count << " on " << threads;
            }
        }
    }
}

TEST(ParallelFor, DoesEveryPieceOfManySmallCallsOnceThoughThreadsComeLate) {
    const Threads limited(5);
    for (int call = 0; call < 20'000; ++call) {
        std::array<std::atomic<int>, 3> done{};
        parallelFor(done.size(), [&](std::size_t i) { ++done[i]; });
        for (const std::atomic<int>& one : done) {
            ASSERT_EQ(one, 1) << "call " << call;
        }
    }
}

TEST(ParallelFor, WorksWithinItself) {
    const Threads limited(3);
    std::vector<int> sums(8);
    parallelFor(sums.size(), [&](std::size_t i) {
        std::vector<int> parts(10);
        parallelFor(parts.size(), [&](std::size_t k) { parts[k] = static_cast<int>(i * k); });
        sums[i] = std::accumulate(parts.begin(), parts.end(), 0);
    });
    for (std::size_t i = 0; i < sums.size(); ++i) {
        EXPECT_EQ(sums[i], static_cast<int>(45 * i));
    }
}

TEST(ParallelFor, ThrowsWhatTheFirstPieceThrewAndGoesOnAfterwards) {
    const Threads limited(4);
    for (int again = 0; again < 20; ++again) {
        try {
            parallelFor(100, [](std::size_t i) {
                if (i >= 3) {
                    throw std::runtime_error(std::to_string(i));
                }
            });
            FAIL() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "3");
        }
    }
}

TEST(ParallelFor, DividesASizeWithoutGaps) {
    for (const std::size_t size : {0U, 1U, 5U, 16U, 1001U}) {
        EXPECT_EQ(beginOfPart(0, 16, size), 0U);
        EXPECT_EQ(beginOfPart(16, 16, size), size);
        for (std::size_t part = 0; part < 16; ++part) {
            EXPECT_LE(beginOfPart(part, 16, size), beginOfPart(part + 1, 16, size));
        }
    }
}

TEST(ParallelFor, KeepsToOneThreadWhereItIsAsked) {
    const Threads limited(4);
    std::vector<std::thread::id> threads(100);
    {
        const OnThisThread alone;
        parallelFor(threads.size(),
                    [&](std::size_t i) { threads[i] = std::this_thread::get_id(); });
    }
    for (const std::thread::id& thread : threads) {
        EXPECT_EQ(thread, std::this_thread::get_id());
    }
}

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/radiance/exchange/ReceiverSums.h"

namespace irsg {
namespace {

using Known = std::map<std::uint32_t, ReceiverSums::Weights>;

Known knownOf(const ReceiverSums& sums) {
    Known known;
    for (const ReceiverSums::Entry& entry : sums.entries()) {
        known[entry.receiver] = entry.weights;
    }
    return known;
}

/// Receivers as views meet them: neighbours again and again, and now and then others far away.
std::vector<std::uint32_t> someReceivers(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> all;
    std::uint32_t at = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto drawn = static_cast<std::uint32_t>(random());
        at = i % 40 == 0 ? drawn % 200'000 : at + drawn % 3;
        all.push_back(at);
    }
    all.push_back(0);
    all.push_back(0xfffffffeu);
    return all;
}

TEST(ReceiverSums, HaveWhatWasAddedToEachInTheOrderOfReceivers) {
    ReceiverSumsMaker maker;
    EXPECT_TRUE(maker.isEmpty());
    EXPECT_EQ(maker.addFront(), 0u);
    Known wanted;
    double weight = 0.125;
    for (const std::uint32_t receiver : someReceivers(1)) {
        for (Known::mapped_type* sums : {maker.of(receiver), &wanted[receiver]}) {
            (*sums)[0] += weight;
            (*sums)[1] += 0.5 * weight;
        }
        weight += 0.25;
    }
    EXPECT_FALSE(maker.isEmpty());
    const ReceiverSums sums = maker.sumsOf(0);
    EXPECT_EQ(knownOf(sums), wanted);
    EXPECT_EQ(sums.entries().size(), wanted.size());
    EXPECT_TRUE(std::ranges::is_sorted(sums.entries(), {}, &ReceiverSums::Entry::receiver));
}

TEST(ReceiverSums, KeepWhatIsSeenBehindEachFrontApartWheneverItComes) {
    ReceiverSumsMaker maker;
    std::vector<Known> wanted;
    std::mt19937 random(4);
    for (const std::uint32_t receiver : someReceivers(5)) {
        if (wanted.size() < 11 && random() % 200 == 0) {
            EXPECT_EQ(maker.addFront(), wanted.size());
            wanted.emplace_back();
        }
        if (wanted.empty()) {
            continue;
        }
        const std::size_t front = random() % wanted.size();
        const auto weight = static_cast<double>(random() % 100 + 1);
        maker.of(receiver)[front][0] += weight;
        maker.of(receiver)[front][1] -= weight;
        wanted[front][receiver][0] += weight;
        wanted[front][receiver][1] -= weight;
    }
    ASSERT_EQ(wanted.size(), 11u);
    for (std::size_t front = 0; front < wanted.size(); ++front) {
        EXPECT_EQ(knownOf(maker.sumsOf(front)), wanted[front]) << front;
    }
}

TEST(ReceiverSums, AddOthersTimesAScaleWhereverTheyLie) {
    ReceiverSumsMaker one, other;
    one.addFront();
    other.addFront();
    Known wanted;
    for (const std::uint32_t receiver : someReceivers(2)) {
        (*one.of(receiver))[0] += 1.0;
        wanted[receiver][0] += 1.0;
    }
    for (const std::uint32_t receiver : someReceivers(3)) {
        (*other.of(receiver))[1] += 3.0;
        wanted[receiver][1] -= 1.5;
    }
    const ReceiverSums added = other.sumsOf(0);
    ReceiverSums sums = one.sumsOf(0);
    sums.addScaled(added, -0.5);
    EXPECT_EQ(knownOf(sums), wanted);

    ReceiverSums fromNothing;
    fromNothing.addScaled(added, 1.0);
    EXPECT_EQ(knownOf(fromNothing), knownOf(added));
    fromNothing.addScaled({}, 7.0);
    EXPECT_EQ(knownOf(fromNothing), knownOf(added));
}

TEST(ReceiverSums, AreSortedWhateverOrderTheyComeIn) {
    const ReceiverSums sums({{7, {1.0, 2.0}}, {2, {3.0, 4.0}}, {5, {5.0, 6.0}}});
    ASSERT_EQ(sums.entries().size(), 3u);
    EXPECT_EQ(sums.entries().front().receiver, 2u);
    EXPECT_EQ(sums.entries().back().weights[1], 2.0);
}

} // namespace
} // namespace irsg

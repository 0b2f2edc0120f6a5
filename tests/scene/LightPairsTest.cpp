#include "irsg/radiance/exchange/LightPairs.h"
#include "irsg/radiance/exchange/GatheredSums.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace irsg {
namespace {

/// Parts in no order, many of them of the same pair.
std::vector<LightPart> manyParts(std::uint32_t receivers, std::size_t count) {
    std::mt19937 random(7);
    std::vector<LightPart> parts;
    for (std::size_t i = 0; i < count; ++i) {
        const auto receiver = static_cast<std::uint32_t>(random() % receivers);
        const auto sender = static_cast<std::uint32_t>(random() % receivers);
        parts.push_back({receiver, sender, static_cast<float>(random() % 1000) / 1000.0f});
    }
    return parts;
}

using Factors = std::map<std::pair<std::uint32_t, std::uint32_t>, float>;

/// Of equal pairs the sums, in the order in which they come.
Factors sumsOf(const std::vector<LightPart>& parts) {
    Factors sums;
    for (const LightPart& part : parts) {
        sums[{part.receiver, part.sender}] += part.factor;
    }
    return sums;
}

// Numbers of one, two and three digits, so that the sorted list ends in either of two places.
constexpr std::uint32_t receiverCounts[] = {2, 200, 300, 70'000};

TEST(LightPairs, PartsOfAPairAreAddedInTheirOrderWhateverTheOrderOfPairs) {
    for (const std::uint32_t receivers : receiverCounts) {
        std::vector<LightPart> parts = manyParts(receivers, 5000);
        const Factors expected = sumsOf(parts);
        mergeParts(parts);
        ASSERT_EQ(parts.size(), expected.size()) << receivers;
        std::size_t i = 0;
        for (const auto& [pair, factor] : expected) {
            EXPECT_EQ(parts[i].receiver, pair.first) << receivers;
            EXPECT_EQ(parts[i].sender, pair.second) << receivers;
            EXPECT_EQ(parts[i].factor, factor) << receivers;
            ++i;
        }
    }
}

TEST(LightPairs, ListsOfReceiversHaveSendersInAscendingOrder) {
    for (const std::uint32_t receivers : receiverCounts) {
        const std::vector<LightPart> parts = manyParts(receivers, 5000);
        const LightPairs pairs(receivers, {parts});
        const Factors expected = sumsOf(parts);
        EXPECT_EQ(pairs.size(), expected.size()) << receivers;
        auto next = expected.begin();
        for (std::uint32_t r = 0; r < receivers; ++r) {
            const auto [first, last] = pairs.of(r);
            for (const LightPair* pair = first; pair != last; ++pair, ++next) {
                ASSERT_NE(next, expected.end());
                EXPECT_EQ(std::pair(r, pair->sender), next->first);
                EXPECT_EQ(pair->factor, next->second);
            }
        }
    }
}

TEST(LightPairs, WhatArrivesIsTheSumOverSendersInEachOfAnyNumberOfColumns) {
    constexpr std::uint32_t receivers = 40;
    const LightPairs pairs(receivers, {manyParts(receivers, 600)});
    for (std::size_t width = 0; width <= 39; ++width) {
        std::vector<float> sent(receivers * width);
        for (std::size_t i = 0; i < sent.size(); ++i) {
            sent[i] = 1.0f / static_cast<float>(1 + i % 17);
        }
        for (std::uint32_t r = 0; r < receivers; ++r) {
            constexpr float untouched = -1.0f;
            std::vector<float> arrives(width + 1, untouched), expected(width + 1);
            expected.back() = untouched;
            const auto [first, last] = pairs.of(r);
            for (const LightPair* pair = first; pair != last; ++pair) {
                for (std::size_t c = 0; c < width; ++c) {
                    expected[c] += pair->factor * sent[pair->sender * width + c];
                }
            }
            pairs.gather(r, sent, width, width, arrives.data());
            EXPECT_EQ(arrives, expected) << "receiver " << r << " of " << width << " columns";
        }
    }
}

TEST(GatheredSums, AreMadeInTheOrderOfWhatIsGatheredWhateverIsMadeBesideThem) {
    for (const std::size_t kinds : {1u, 3u, 4u, 9u}) {
        constexpr std::size_t count = 37;
        std::vector<std::vector<double>> integrals(kinds, std::vector<double>(2 + count));
        std::vector<std::vector<float>> receivers(GatheredSums::together,
                                                  std::vector<float>(count));
        receivers[2].clear(); // gathers nothing
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < kinds; ++k) {
                integrals[k][2 + i] = 1.0 / static_cast<double>(1 + (7 * i + k) % 23);
            }
            for (std::size_t r = 0; r < receivers.size(); ++r) {
                if (!receivers[r].empty()) {
                    receivers[r][i] = 1.0f / static_cast<float>(1 + (5 * i + r) % 19);
                }
            }
        }
        const GatheredSums others({integrals.begin(), integrals.end()}, 2);
        std::vector<double> sums(kinds * receivers.size(), 0.5), expected = sums;
        for (std::size_t r = 0; r < receivers.size(); ++r) {
            for (std::size_t k = 0; k < kinds; ++k) {
                for (std::size_t i = 0; i < receivers[r].size(); ++i) {
                    expected[r * kinds + k] +=
                        static_cast<double>(receivers[r][i]) * integrals[k][2 + i];
                }
            }
        }
        others.add({receivers[0], receivers[1], receivers[2], receivers[3]}, sums);
        EXPECT_EQ(sums, expected) << kinds;
    }
}

} // namespace
} // namespace irsg

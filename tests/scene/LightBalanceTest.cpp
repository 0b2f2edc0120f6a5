// What receivers learn from each other's rays.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "irsg/radiance/exchange/LightBalance.h"
#include "irsg/signature/random/Philox.h"

using namespace irsg;

namespace {

LightPairs pairsOf(std::size_t receivers, const std::vector<LightPart>& parts) {
    return LightPairs(receivers, {parts});
}

double factor(const LightPairs& pairs, std::uint32_t receiver, std::uint32_t sender) {
    const auto [first, last] = pairs.of(receiver);
    for (const LightPair* pair = first; pair != last; ++pair) {
        if (pair->sender == sender) {
            return static_cast<double>(pair->factor);
        }
    }
    return 0.0;
}

} // namespace

TEST(LightBalance, HitsOfBothEndsCountForBoth) {
    // A wing of 1 m2 whose rays meet a nozzle of 0.01 m2 twice in a hundred, the nozzle's 90 times:
    // 92 hits of 10,100 rays per m2. Sums lie between, nearer to what is more certain.
    const std::vector<ReceiverRays> receivers{{1.0, 100.0}, {0.01, 100.0}};
    const LightPairs both =
        balanced(pairsOf(2, {{0, 1, 0.02f}, {1, 0, 0.9f}}), pairsOf(2, {}), receivers);
    const double exchanged_m2 = 92.0 / 10'100.0;
    EXPECT_NEAR(factor(both, 0, 1), exchanged_m2, 0.02 * exchanged_m2);
    EXPECT_NEAR(factor(both, 1, 0), exchanged_m2 / 0.01, 0.02 * exchanged_m2 / 0.01);
    // Of a receiver that has sent no rays all is known by the others'.
    const LightPairs dark =
        balanced(pairsOf(2, {{1, 0, 0.9f}}), pairsOf(2, {}), {{1.0, 0.0}, {0.01, 100.0}});
    EXPECT_NEAR(factor(dark, 0, 1), 0.009, 1e-6);
    EXPECT_NEAR(factor(dark, 1, 0), 0.9, 1e-6);
}

TEST(LightBalance, NothingIsMadeOfNothing) {
    EXPECT_EQ(balanced(pairsOf(0, {}), pairsOf(0, {}), {}).receivers(), 0u);
    const LightPairs dark = balanced(pairsOf(2, {}), pairsOf(2, {}), {{1.0, 64.0}, {0.0, 0.0}});
    EXPECT_EQ(dark.receivers(), 2u);
    EXPECT_EQ(dark.size(), 0u);
}

TEST(LightBalance, WhoSeesOneThingAloneOneWayGetsNothingOfOthersWhateverTheyMeet) {
    const std::vector<ReceiverRays> receivers{{1.0, 64.0}, {2.0, 64.0}, {3.0, 64.0}};
    const LightPairs pairs =
        balanced(pairsOf(3, {{1, 0, 0.5f}}), pairsOf(3, {{0, 2, 1.0f}}), receivers);
    EXPECT_EQ(factor(pairs, 0, 1), 0.0);
    EXPECT_EQ(factor(pairs, 0, 2), 1.0);
    EXPECT_TRUE(std::isfinite(factor(pairs, 1, 0)));
}

TEST(LightBalance, WhatIsSeenOneWayStaysAsItIs) {
    const std::vector<ReceiverRays> receivers{{1.0, 64.0}, {2.0, 64.0}, {3.0, 64.0}};
    const LightPairs alone =
        balanced(pairsOf(3, {}), pairsOf(3, {{0, 1, 0.25f}, {0, 2, 0.5f}}), receivers);
    EXPECT_EQ(factor(alone, 0, 1), 0.25);
    EXPECT_EQ(factor(alone, 0, 2), 0.5);
    EXPECT_TRUE(alone.isEmpty(1));
    EXPECT_TRUE(alone.isEmpty(2));
    // And fills a part of the hemisphere that nothing else can have.
    const LightPairs mixed =
        balanced(pairsOf(3, {{0, 2, 0.4f}, {2, 0, 0.3f}}), pairsOf(3, {{0, 1, 0.6f}}), receivers);
    EXPECT_FLOAT_EQ(static_cast<float>(factor(mixed, 0, 1)), 0.6f);
    EXPECT_LE(mixed.sumOf(0), 1.0 + 1e-6);
}

TEST(LightBalance, AClosedRoomStaysClosedAndLightGoesEitherWay) {
    // Forty walls of areas between 0.01 and 1 m2 that see each other as their areas say, by some
    // hundred rays each.
    constexpr std::uint32_t walls = 40;
    std::vector<ReceiverRays> receivers;
    double area_m2 = 0.0;
    for (std::uint32_t i = 0; i < walls; ++i) {
        receivers.push_back({0.01 * std::pow(100.0, i / (walls - 1.0)), 256.0});
        area_m2 += receivers.back().area_m2;
    }
    std::uint64_t draw = 0;
    std::vector<LightPart> parts;
    for (std::uint32_t i = 0; i < walls; ++i) {
        for (int ray = 0; ray < 256; ++ray) {
            double left_m2 = unitOf(7, {}, draw++) * area_m2;
            std::uint32_t met = 0;
            while (met + 1 < walls && left_m2 > receivers[met].area_m2) {
                left_m2 -= receivers[met++].area_m2;
            }
            parts.push_back({i, met, 1.0f / 256.0f});
        }
    }
    const LightPairs rays = pairsOf(walls, parts);
    const LightPairs both = balanced(rays, pairsOf(walls, {}), receivers);
    double before = 0.0, after = 0.0;
    for (std::uint32_t i = 0; i < walls; ++i) {
        EXPECT_NEAR(both.sumOf(i), 1.0, 1e-5) << i;
        for (std::uint32_t j = 0; j < walls; ++j) {
            const double exact = receivers[j].area_m2 / area_m2;
            if (receivers[i].area_m2 > 20.0 * receivers[j].area_m2) {
                before += std::pow(factor(rays, i, j) / exact - 1.0, 2.0);
                after += std::pow(factor(both, i, j) / exact - 1.0, 2.0);
            }
            const double there = receivers[i].area_m2 * factor(both, i, j);
            const double back = receivers[j].area_m2 * factor(both, j, i);
            EXPECT_NEAR(there, back, 1e-3 * there + 1e-9) << i << " " << j;
        }
    }
    // What large walls get of small ones: a root of 20 times as many hits tell.
    EXPECT_LT(std::sqrt(after / before), 0.3);
    EXPECT_GT(before, 0.0);
}

TEST(LightBalance, HitsThatContradictEachOtherDoNotRunAway) {
    // What the second sees of the first, the first's own rays say is seen one way: no scales of
    // both ends agree, and a third that was met once must not pay for it.
    const std::vector<ReceiverRays> receivers{{1.0, 256.0}, {1.0, 256.0}, {0.1, 256.0}};
    const LightPairs pairs = balanced(pairsOf(3, {{1, 0, 0.996f}, {1, 2, 0.004f}}),
                                      pairsOf(3, {{0, 1, 1.0f}}), receivers);
    EXPECT_LT(factor(pairs, 2, 1), 1.0);
    for (std::uint32_t r = 0; r < 3; ++r) {
        EXPECT_LE(pairs.sumOf(r), 1.0 + 1e-6) << r;
    }
}

TEST(LightBalance, WhoSendsAloneIsBalancedAlone) {
    const std::vector<ReceiverRays> receivers{{1.0, 64.0}, {2.0, 64.0}, {3.0, 64.0}};
    const std::vector<std::uint32_t> itself{0, 1, 2};
    const std::vector<LightPart> parts{{0, 1, 0.5f}, {1, 0, 0.2f}, {1, 2, 0.3f}, {2, 0, 0.1f}};
    const LightPairs alone = balanced(pairsOf(3, parts), pairsOf(3, {}), receivers);
    const LightBalance both =
        balancedOfSenders(pairsOf(3, parts), pairsOf(3, {}), receivers, itself, 3);
    EXPECT_EQ(both.pairs, both.between);
    for (std::uint32_t r = 0; r < 3; ++r) {
        for (std::uint32_t s = 0; s < 3; ++s) {
            EXPECT_EQ(factor(*both.pairs, r, s), factor(alone, r, s));
        }
    }
}

TEST(LightBalance, ReceiversOfASenderKeepWhatTellsThemApart) {
    // Two halves of a floor send as one; a wall of their size is met by 80 of 200 rays of the first
    // and by 20 of the second's.
    const std::vector<ReceiverRays> receivers{{0.5, 200.0}, {0.5, 200.0}, {1.0, 400.0}};
    const std::vector<std::uint32_t> senderOf{0, 0, 1};
    const LightBalance both =
        balancedOfSenders(pairsOf(3, {{0, 1, 0.4f}, {1, 1, 0.1f}, {2, 0, 0.25f}}), pairsOf(3, {}),
                          receivers, senderOf, 2);
    EXPECT_NEAR(factor(*both.between, 0, 1), 0.25, 1e-6);
    EXPECT_NEAR(factor(*both.between, 1, 0), 0.25, 1e-6);
    EXPECT_NEAR(factor(*both.pairs, 0, 1), 0.4, 0.02);
    EXPECT_NEAR(factor(*both.pairs, 1, 1), 0.1, 0.02);
    EXPECT_NEAR(factor(*both.pairs, 2, 0), 0.25, 1e-6);
}

TEST(LightBalance, AClosedRoomStaysClosedForEachReceiver) {
    // Six walls of four receivers each, which see the walls by 64 rays at random.
    constexpr std::uint32_t walls = 6, parts = 4, all = walls * parts, rays = 64;
    std::vector<ReceiverRays> receivers;
    std::vector<std::uint32_t> senderOf;
    std::vector<LightPart> met;
    std::uint64_t draw = 0;
    for (std::uint32_t r = 0; r < all; ++r) {
        receivers.push_back({0.1 * (1 + r % 3), rays});
        senderOf.push_back(r / parts);
        for (std::uint32_t i = 0; i < rays; ++i) {
            met.push_back(
                {r, static_cast<std::uint32_t>(unitOf(5, {}, draw++) * walls), 1.0f / rays});
        }
    }
    const LightBalance both =
        balancedOfSenders(pairsOf(all, met), pairsOf(all, {}), receivers, senderOf, walls);
    for (std::uint32_t r = 0; r < all; ++r) {
        EXPECT_NEAR(both.pairs->sumOf(r), 1.0, 1e-6) << r;
    }
    for (std::uint32_t s = 0; s < walls; ++s) {
        EXPECT_NEAR(both.between->sumOf(s), 1.0, 1e-5) << s;
    }
}

#include "irsg/signature/random/Philox.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace irsg {

TEST(Philox, GivesThePublishedNumbers) {
    // The known answers that Salmon and others publish with the algorithm (Random123, kat_vectors).
    using Words = std::array<std::uint32_t, 4>;
    constexpr std::uint32_t ones = 0xFFFFFFFF;
    EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
              (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    EXPECT_EQ(philox4x32({ones, ones, ones, ones}, {ones, ones}),
              (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    EXPECT_EQ(
        philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
        (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, MakesUnitNumbersThatMeetNeitherEnd) {
    EXPECT_GT(unitFromBits(0), 0.0);
    EXPECT_LT(unitFromBits(~std::uint64_t{0}), 1.0);
    EXPECT_EQ(unitFromBits(std::uint64_t{1} << 63), 0.5 + 0x1p-53);
}

TEST(Philox, TellsSequencesApartByEachPartOfTheirName) {
    // Neighbouring names, seeds and draws: uncorrelated, each uniform.
    constexpr int count = 20000;
    const auto correlation = [](auto a, auto b) {
        double sum = 0.0;
        for (std::uint64_t i = 0; i < count; ++i) {
            sum += (a(i) - 0.5) * (b(i) - 0.5);
        }
        return 12.0 * sum / count;
    };
    const StreamName base{0, 0, 1};
    const auto reference = [&](std::uint64_t i) { return unitOf(1, base, i); };
    EXPECT_NEAR(correlation(reference, reference), 1.0, 0.03);
    const double limit = 4.0 / std::sqrt(double(count));
    const auto other = [&](std::uint64_t seed, StreamName name, std::uint64_t shift) {
        return correlation(reference,
                           [=](std::uint64_t i) { return unitOf(seed, name, i + shift); });
    };
    EXPECT_LT(std::abs(other(2, base, 0)), limit);
    EXPECT_LT(std::abs(other(std::uint64_t{1} << 32 | 1, base, 0)), limit);
    EXPECT_LT(std::abs(other(1, {1, 0, 1}, 0)), limit);
    EXPECT_LT(std::abs(other(1, {0, 1, 1}, 0)), limit);
    EXPECT_LT(std::abs(other(1, {0, 1u << 16, 1}, 0)), limit);
    EXPECT_LT(std::abs(other(1, {0, 0, 2}, 0)), limit);
    EXPECT_LT(std::abs(other(1, base, 1)), limit);
    EXPECT_LT(std::abs(other(1, base, std::uint64_t{1} << 32)), limit);
}

} // namespace irsg

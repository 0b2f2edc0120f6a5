#pragma once

#include <array>
#include <cstdint>

namespace irsg {

/// Philox4x32-10, a counter-based generator (Salmon, Moraes, Dror and Shaw, "Parallel random
/// numbers: as easy as 1, 2, 3", SC11): four random words for each counter and key, without a
/// state.
constexpr std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t a = std::uint64_t{0xD2511F53} * counter[0];
        const std::uint64_t b = std::uint64_t{0xCD9E8D57} * counter[2];
        counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0],
                   static_cast<std::uint32_t>(b),
                   static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1],
                   static_cast<std::uint32_t>(a)};
        key[0] += 0x9E3779B9;
        key[1] += 0xBB67AE85;
    }
    return counter;
}

/// A number in (0, 1): the middle of one of 2^52 equal cells, so that neither end is ever met.
constexpr double unitFromBits(std::uint64_t bits) {
    return (static_cast<double>(static_cast<std::int64_t>(bits >> 12)) + 0.5) * 0x1p-52;
}

/// Names one sequence of random numbers. Sequences of different names are independent, and none
/// depends on which others are in use.
struct StreamName {
    std::uint32_t purpose = 0; ///< what the numbers are for, see Scalings.h
    std::uint32_t owner = 0;   ///< whose: the number of an entity
    std::int32_t index = 0;    ///< index of a signature database
};

/// Number `draw` of the sequence of that name, in (0, 1).
double unitOf(std::uint64_t seed, const StreamName& name, std::uint64_t draw);

} // namespace irsg

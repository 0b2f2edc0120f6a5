#include "irsg/signature/random/Philox.h"

namespace irsg {

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
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

double unitFromBits(std::uint64_t bits) {
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

double unitOf(std::uint64_t seed, const StreamName& name, std::uint64_t draw) {
    // 40 bits of the draw, 8 of the purpose and 16 of the owner fill the counter beside the index.
    const std::array<std::uint32_t, 4> counter{
        static_cast<std::uint32_t>(draw),
        static_cast<std::uint32_t>(draw >> 32 & 0xFF) | name.purpose << 8 | name.owner << 16,
        static_cast<std::uint32_t>(name.index), name.owner >> 16};
    const auto words = philox4x32(
        counter, {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
    return unitFromBits(std::uint64_t{words[0]} << 32 | words[1]);
}

} // namespace irsg

#include "irsg/signature/random/Philox.h"

namespace irsg {

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

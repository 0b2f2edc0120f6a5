#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

namespace irsg {

/// Little-endian numbers at a place of a file.
inline void putDouble(std::string& bytes, std::size_t at, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < 8; ++i) {
        bytes[at + i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
    }
}
inline void putInt(std::string& bytes, std::size_t at, std::int32_t value) {
    for (std::size_t i = 0; i < 4; ++i) {
        bytes[at + i] = static_cast<char>(
            static_cast<unsigned char>(static_cast<std::uint32_t>(value) >> (8 * i)));
    }
}

} // namespace irsg

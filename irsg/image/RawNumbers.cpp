#include "irsg/image/RawNumbers.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include <Imath/half.h>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

template <typename Number>
float valueAs(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return static_cast<float>(number);
}

float halfValue(const char* bytes) {
    std::uint16_t bits = 0;
    std::memcpy(&bits, bytes, sizeof bits);
    half number;
    number.setBits(bits);
    return number;
}

} // namespace

float rawValue(const char* at, const RawNumber& type) {
    if (!type.isKnown())
        throw LogicError("a number of " + std::to_string(type.size_B) + " bytes is not known");
    char bytes[8];
    std::memcpy(bytes, at, type.size_B);
    if (type.isBigEndian != (std::endian::native == std::endian::big))
        std::reverse(bytes, bytes + type.size_B);
    const std::size_t size = type.size_B;
    if (type.kind == RawNumber::Kind::real)
        return size == 2   ? halfValue(bytes)
               : size == 4 ? valueAs<float>(bytes)
                           : valueAs<double>(bytes);
    if (type.kind == RawNumber::Kind::natural)
        return size == 1   ? valueAs<std::uint8_t>(bytes)
               : size == 2 ? valueAs<std::uint16_t>(bytes)
               : size == 4 ? valueAs<std::uint32_t>(bytes)
                           : valueAs<std::uint64_t>(bytes);
    return size == 1   ? valueAs<std::int8_t>(bytes)
           : size == 2 ? valueAs<std::int16_t>(bytes)
           : size == 4 ? valueAs<std::int32_t>(bytes)
                       : valueAs<std::int64_t>(bytes);
}

} // namespace irsg

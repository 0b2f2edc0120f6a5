#pragma once

#include <cstddef>

namespace irsg {

/// How a file stores one number.
struct RawNumber {
    enum class Kind { integer, natural, real };
    Kind kind = Kind::real;
    std::size_t size_B = 4; ///< 1, 2, 4 or 8; of reals 2, 4 or 8
    bool isBigEndian = false;

    bool isKnown() const {
        const bool isPower = size_B == 1 || size_B == 2 || size_B == 4 || size_B == 8;
        return isPower && (kind != Kind::real || size_B > 1);
    }
};

/// The number at an address, as float; LogicError for a type that is not known.
float rawValue(const char* at, const RawNumber& type);

} // namespace irsg

#pragma once

#include <bit>
#include <cstdint>

namespace irsg {

/// exp(x) - 1 without branches or tables, so that compilers turn loops over it into vectors. Digits
/// of small arguments are kept: relative error below 1e-15 for -600 <= x <= 600, beyond which x is
/// held. Cody and Waite's reduction, exp(x) = 2^k exp(r) with |r| <= ln 2 / 2, and the series of
/// exp(r) - 1 to the 13th power.
inline double vectorExpm1(double x) {
    constexpr double log2e = 1.4426950408889634074;
    constexpr double ln2High = 6.93147180369123816490e-01;
    constexpr double ln2Low = 1.90821492927058770002e-10;
    constexpr double toInteger = 6755399441055744.0; // 1.5 2^52: adding it rounds to an integer
    x = x < -600.0 ? -600.0 : x;
    x = x > 600.0 ? 600.0 : x;
    const double shifted = x * log2e + toInteger;
    const double k = shifted - toInteger;
    const double r = (x - k * ln2High) - k * ln2Low;

    double series = 1.0 / 6227020800.0;
    series = series * r + 1.0 / 479001600.0;
    series = series * r + 1.0 / 39916800.0;
    series = series * r + 1.0 / 3628800.0;
    series = series * r + 1.0 / 362880.0;
    series = series * r + 1.0 / 40320.0;
    series = series * r + 1.0 / 5040.0;
    series = series * r + 1.0 / 720.0;
    series = series * r + 1.0 / 120.0;
    series = series * r + 1.0 / 24.0;
    series = series * r + 1.0 / 6.0;
    series = series * r + 0.5;
    series = r + r * r * series;

    const auto bits = (std::bit_cast<std::uint64_t>(shifted) + 1023u) << 52;
    const double power = std::bit_cast<double>(bits);
    return power * series + (power - 1.0);
}

/// 1 - exp(-x) for x >= 0, the part that a medium of optical depth x takes.
inline double vectorAbsorbed(double x) {
    return -vectorExpm1(-x);
}

} // namespace irsg

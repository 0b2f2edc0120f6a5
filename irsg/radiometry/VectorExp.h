#pragma once

#include <bit>
#include <cstdint>

namespace irsg {

/// exp(x) = power * (1 + series) in double precision, without branches or tables, so that compilers
/// turn loops over it into vectors: Cody and Waite's reduction, exp(x) = 2^k exp(r) with
/// |r| <= ln 2 / 2, and the series of exp(r) - 1 to the 13th power. Beyond -600 <= x <= 600 x is
/// held.
struct VectorExpParts {
    double power, series;

    explicit VectorExpParts(double x) {
        constexpr double log2e = 1.4426950408889634074;
        constexpr double ln2High = 6.93147180369123816490e-01;
        constexpr double ln2Low = 1.90821492927058770002e-10;
        constexpr double toInteger = 6755399441055744.0; // 1.5 2^52: adding it rounds to an integer
        x = x < -600.0 ? -600.0 : x;
        x = x > 600.0 ? 600.0 : x;
        const double shifted = x * log2e + toInteger;
        const double k = shifted - toInteger;
        const double r = (x - k * ln2High) - k * ln2Low;

        series = 1.0 / 6227020800.0;
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
        power = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + 1023u) << 52);
    }
};

/// exp(x), relative error below 1e-15.
inline double vectorExp(double x) {
    const VectorExpParts parts(x);
    return parts.power * parts.series + parts.power;
}

/// exp(x) - 1, digits of small arguments are kept: relative error below 1e-15.
inline double vectorExpm1(double x) {
    const VectorExpParts parts(x);
    return parts.power * parts.series + (parts.power - 1.0);
}

/// 1 - exp(-x) for x >= 0, the part that a medium of optical depth x takes.
inline double vectorAbsorbed(double x) {
    return -vectorExpm1(-x);
}

/// exp(x) of single precision, likewise without branches: relative error below 2e-7 for
/// -87 <= x <= 88, beyond which x is held.
inline float vectorExp(float x) {
    constexpr float log2e = 1.44269504f;
    constexpr float ln2High = 6.93145752e-01f;
    constexpr float ln2Low = 1.42860677e-06f;
    constexpr float toInteger = 12582912.0f; // 1.5 2^23
    x = x < -87.0f ? -87.0f : x;
    x = x > 88.0f ? 88.0f : x;
    const float shifted = x * log2e + toInteger;
    const float k = shifted - toInteger;
    const float r = (x - k * ln2High) - k * ln2Low;

    float series = 1.0f / 5040.0f;
    series = series * r + 1.0f / 720.0f;
    series = series * r + 1.0f / 120.0f;
    series = series * r + 1.0f / 24.0f;
    series = series * r + 1.0f / 6.0f;
    series = series * r + 0.5f;
    series = series * r + 1.0f;
    series = series * r + 1.0f;
    const auto bits = (std::bit_cast<std::uint32_t>(shifted) + 127u) << 23;
    return std::bit_cast<float>(bits) * series;
}

} // namespace irsg

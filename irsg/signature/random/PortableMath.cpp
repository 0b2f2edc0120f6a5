#include "irsg/signature/random/PortableMath.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace irsg::portable {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// ln 2 and pi / 2 in two parts; the first has zeros at its end, so that small multiples are exact.
constexpr double ln2High = 0x1.62e42fefa3800p-1;
constexpr double ln2Low = 0x1.ef35793c76730p-45;
constexpr double halfPiHigh = 0x1.921fb54400000p+0;
constexpr double halfPiLow = 0x1.0b4611a626331p-34;
constexpr double halfLn2Pi = 0x1.d67f1c864beb5p-1;

/// sum of c[i] x^i.
template <std::size_t n>
double polynomial(const std::array<double, n>& c, double x) {
    double sum = c[n - 1];
    for (std::size_t i = n - 1; i-- > 0;)
        sum = sum * x + c[i];
    return sum;
}

/// 1 / (first + i step)! with alternating signs where asked for.
template <std::size_t n>
constexpr std::array<double, n> inverseFactorials(int first, int step, bool alternating) {
    std::array<double, n> c{};
    for (std::size_t i = 0; i < n; ++i) {
        double factorial = 1.0;
        for (int k = 2; k <= first + static_cast<int>(i) * step; ++k)
            factorial *= k;
        c[i] = (alternating && i % 2 == 1 ? -1.0 : 1.0) / factorial;
    }
    return c;
}

/// 1 / (2 i + 1).
template <std::size_t n>
constexpr std::array<double, n> oddReciprocals() {
    std::array<double, n> c{};
    for (std::size_t i = 0; i < n; ++i)
        c[i] = 1.0 / static_cast<double>(2 * i + 1);
    return c;
}

/// An angle as r + q pi / 2 with |r| <= pi / 4.
struct Reduced {
    double r;
    int quadrant;
};

Reduced reduced(double x) {
    const double q = std::floor(x / (halfPiHigh + halfPiLow) + 0.5);
    const double r = (x - q * halfPiHigh) - q * halfPiLow;
    return {r, static_cast<int>(q - 4.0 * std::floor(q / 4.0))};
}

double sinOfSmall(double r) {
    static constexpr auto c = inverseFactorials<10>(1, 2, true);
    return r * polynomial(c, r * r);
}

double cosOfSmall(double r) {
    static constexpr auto c = inverseFactorials<10>(0, 2, true);
    return polynomial(c, r * r);
}

} // namespace

double exp(double x) {
    if (std::isnan(x))
        return nan;
    if (x > 709.8)
        return infinity;
    if (x < -745.2)
        return 0.0;
    static constexpr auto c = inverseFactorials<15>(0, 1, false);
    const double k = std::floor(x / (ln2High + ln2Low) + 0.5);
    const double r = (x - k * ln2High) - k * ln2Low;
    const double mantissa = polynomial(c, r);
    if (k > -1000.0 && k < 1000.0) // the power of two itself, from its exponent
        return mantissa *
               std::bit_cast<double>(static_cast<std::uint64_t>(1023 + static_cast<int>(k)) << 52);
    return std::ldexp(mantissa, static_cast<int>(k));
}

double log(double x) {
    if (std::isnan(x) || x < 0.0)
        return nan;
    if (x == 0.0)
        return -infinity;
    if (std::isinf(x))
        return infinity;

    // x = m 2^k with m from sqrt(1/2) to sqrt(2); ln m = 2 artanh((m - 1) / (m + 1)).
    int k = 0;
    double m = std::frexp(x, &k);
    if (m < 0.70710678118654752) {
        m *= 2.0;
        --k;
    }
    const double s = (m - 1.0) / (m + 1.0);
    const double s2 = s * s;
    static constexpr auto c = oddReciprocals<13>();
    double sum = 0.0;
    for (std::size_t n = 12; n >= 1; --n)
        sum = (sum + c[n]) * s2;
    return k * ln2High + (2.0 * s + (2.0 * s * sum + k * ln2Low));
}

double log1p(double x) {
    // Kahan: the rounding of 1 + x drops out of the quotient.
    const double u = 1.0 + x;
    if (u == 1.0)
        return x;
    if (std::isinf(u))
        return u;
    return log(u) * x / (u - 1.0);
}

double expm1(double x) {
    if (x > 1.0 || x < -1.0)
        return exp(x) - 1.0;
    const double u = exp(x);
    if (u == 1.0)
        return x;
    return (u - 1.0) * x / log(u);
}

double sin(double x) {
    const auto [r, quadrant] = reduced(x);
    switch (quadrant) {
    case 0:
        return sinOfSmall(r);
    case 1:
        return cosOfSmall(r);
    case 2:
        return -sinOfSmall(r);
    default:
        return -cosOfSmall(r);
    }
}

double cos(double x) {
    const auto [r, quadrant] = reduced(x);
    switch (quadrant) {
    case 0:
        return cosOfSmall(r);
    case 1:
        return -sinOfSmall(r);
    case 2:
        return -cosOfSmall(r);
    default:
        return sinOfSmall(r);
    }
}

double atan(double x) {
    constexpr double halfPi = halfPiHigh + halfPiLow;
    if (x < 0.0)
        return -atan(-x);
    if (x > 1.0)
        return halfPi - atan(1.0 / x);

    // atan x = 2 atan(x / (1 + sqrt(1 + x^2))), twice, leaves at most pi / 16.
    const double half = x / (1.0 + std::sqrt(1.0 + x * x));
    const double y = half / (1.0 + std::sqrt(1.0 + half * half));
    const double y2 = y * y;
    static constexpr auto c = oddReciprocals<13>();
    double sum = 0.0;
    for (std::size_t n = 12; n >= 1; --n)
        sum = (c[n] - sum) * y2;
    return 4.0 * (y - y * sum);
}

double logGamma(double x) {
    if (!(x > 0.0))
        return infinity;
    double product = 1.0;
    while (x < 15.0) {
        product *= x;
        x += 1.0;
    }
    static constexpr std::array<double, 7> c{1.0 / 12,   -1.0 / 360,      1.0 / 1260, -1.0 / 1680,
                                             1.0 / 1188, -691.0 / 360360, 1.0 / 156};
    const double series = polynomial(c, 1.0 / (x * x)) / x;
    return (x - 0.5) * log(x) - x + halfLn2Pi + series - log(product);
}

double log1mExp(double t) {
    if (t >= 0.0)
        return -infinity;
    return t > -0.6931471805599453 ? log(-expm1(t)) : log1p(-exp(t));
}

} // namespace irsg::portable

#include "irsg/signature/random/LogTails.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "irsg/signature/random/PortableMath.h"

namespace irsg {

namespace {

constexpr double precision = 1e-16;
/// Shapes are at most 1e4, for which the fractions need a few hundred terms.
constexpr int mostTerms = 20000;
/// Stands in for a denominator that is 0 (Lentz).
constexpr double tiny = 1e-300;

double nonZero(double x) {
    return std::abs(x) < tiny ? tiny : x;
}

/// Continued fraction b0 + a1 / (b1 + a2 / (b2 + ...)) by the modified method of Lentz; `terms`
/// gives a_n and b_n.
template <typename Terms>
double continuedFraction(double b0, Terms terms) {
    double f = nonZero(b0);
    double c = f;
    double d = 0.0;
    for (int n = 1; n < mostTerms; ++n) {
        const auto [a, b] = terms(n);
        d = 1.0 / nonZero(b + a * d);
        c = nonZero(b + a / c);
        const double factor = c * d;
        f *= factor;
        if (std::abs(factor - 1.0) < precision)
            break;
    }
    return f;
}

struct Term {
    double a, b;
};

/// ln of x^a y^b / (a B(a, b)) times the continued fraction of I_x(a, b), for x below its mean.
double logBetaLower(double a, double b, double x, double y) {
    const double fraction = continuedFraction(1.0, [&](int n) {
        const int m = n / 2;
        const double k = a + n - 1.0; // a + 2 m, or a + 2 m - 1
        const double numerator = n % 2 == 0 ? m * (b - m) * x / (k * (k + 1.0))
                                            : -(a + m) * (a + b + m) * x / (k * (k + 1.0));
        return Term{numerator, 1.0};
    });
    const double logBeta =
        portable::logGamma(a) + portable::logGamma(b) - portable::logGamma(a + b);
    return a * portable::log(x) + b * portable::log(y) - logBeta - portable::log(a * fraction);
}

} // namespace

LogTails tailsFromLower(double logLower) {
    const double lower = std::min(logLower, 0.0);
    return {lower, portable::log1mExp(lower)};
}

LogTails tailsFromUpper(double logUpper) {
    const double upper = std::min(logUpper, 0.0);
    return {portable::log1mExp(upper), upper};
}

LogTails gammaTails(double a, double x) {
    if (!(x > 0.0))
        return {-portable::infinity, 0.0};
    if (std::isinf(x))
        return {0.0, -portable::infinity};
    const double prefix = a * portable::log(x) - x - portable::logGamma(a);
    if (x < a + 1.0) {
        double term = 1.0 / a;
        double sum = term;
        for (int n = 1; n < mostTerms && term > precision * sum; ++n) {
            term *= x / (a + n);
            sum += term;
        }
        return tailsFromLower(prefix + portable::log(sum));
    }
    const double fraction = continuedFraction(x + 1.0 - a, [&](int n) {
        return Term{n * (a - n), x + 2.0 * n + 1.0 - a};
    });
    return tailsFromUpper(prefix - portable::log(fraction));
}

LogTails betaTails(double a, double b, double x, double y) {
    if (!(x > 0.0))
        return {-portable::infinity, 0.0};
    if (!(y > 0.0))
        return {0.0, -portable::infinity};
    return x < (a + 1.0) / (a + b + 2.0) ? tailsFromLower(logBetaLower(a, b, x, y))
                                         : tailsFromUpper(logBetaLower(b, a, y, x));
}

LogTails normalTails(double z) {
    // P(|Z| > z) = Q(1/2, z^2 / 2), half of it on either side.
    const double outside = gammaTails(0.5, 0.5 * z * z).upper - std::numbers::ln2;
    const LogTails tails = tailsFromUpper(outside);
    return z >= 0.0 ? tails : LogTails{tails.upper, tails.lower};
}

} // namespace irsg

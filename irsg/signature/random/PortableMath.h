#pragma once

#include <limits>

/// Elementary functions made of sums, products, quotients, square roots and exact scalings by
/// powers of two alone. IEEE 754 fixes the result of each of these to the bit, so random numbers
/// that are computed with them are equal on every machine and from every compiler, which no C
/// library promises of its exp. Accurate to a few units in the last place (2e-15 relative).
namespace irsg::portable {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

double exp(double x);   ///< 0 below -745.2, infinity above 709.8
double log(double x);   ///< natural; -infinity for 0, NaN below
double log1p(double x); ///< ln(1 + x), also for x near 0
double expm1(double x); ///< e^x - 1, also for x near 0
double sin(double x);   ///< |x| up to 1e5
double cos(double x);   ///< the same
double atan(double x);
/// ln Gamma(x) for x > 0 (Stirling's series from 15 on, the recurrence below).
double logGamma(double x);
/// ln(1 - e^t) for t <= 0.
double log1mExp(double t);

} // namespace irsg::portable

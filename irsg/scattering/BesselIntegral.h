#pragma once

namespace irsg {

/// Integral of the Bessel function J0 from 0 to x >= 0, to 1e-11 (absolute). Up to 64 from a table
/// with its exact derivatives J0 and -J1, then by the asymptotic series
/// 1 + sum (2k - 1)!! J_{k+1}(x) / x^k, which follows from d(t^m J_m)/dt = t^m J_{m-1}
/// (Abramowitz and Stegun 9.1.30).
double integralOfJ0(double x);

/// J0(x) less the mean of J0 from 0 to x: what integration by parts leaves of a straight piece
/// under a Hankel transform. Without cancellation for small x.
double besselOverMean(double x);

} // namespace irsg

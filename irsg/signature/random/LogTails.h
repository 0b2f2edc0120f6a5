#pragma once

namespace irsg {

/// Both tails of a probability distribution at one place, as natural logarithms: exact where the
/// probability itself is 0 in double precision (the normal distribution from 38 sigma on).
struct LogTails {
    double lower = 0.0; ///< ln P(X <= x)
    double upper = 0.0; ///< ln P(X > x)
};

/// The tails from the logarithm of one of them.
LogTails tailsFromLower(double logLower);
LogTails tailsFromUpper(double logUpper);

/// Regularised incomplete gamma functions ln P(a, x) and ln Q(a, x), a > 0: the distribution of a
/// gamma variable of shape a and scale 1. Series below a + 1, continued fraction above (Abramowitz
/// and Stegun 6.5.29 and 6.5.31), each the smaller tail or near it, so that both keep their digits.
LogTails gammaTails(double a, double x);

/// Regularised incomplete beta function ln I_x(a, b) and its complement, for x + y = 1 given both
/// so that neither end loses digits (continued fraction of Abramowitz and Stegun 26.5.8).
LogTails betaTails(double a, double b, double x, double y);

/// Of the standard normal distribution.
LogTails normalTails(double z);

} // namespace irsg

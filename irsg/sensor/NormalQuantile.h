#pragma once

#include <span>

namespace irsg {

/// The standard normal number below which a number lies with this probability, in (0, 1): AS 241 of
/// M. J. Wichura, Applied Statistics 37, 477 (1988), routine PPND16, right to about 1e-16. It is
/// made of what IEEE 754 fixes to the bit, so that noise is equal on every machine.
double normalQuantile(double probability);
/// Replaces probabilities by their quantiles, the same to the bit.
void normalQuantiles(std::span<double> probabilities);

} // namespace irsg

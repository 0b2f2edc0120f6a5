#pragma once

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Spectrum.h"

/// Planck's law and its band integral once more, in long double, by other means than the library's:
/// the truth the tests compare with.
namespace irsg::reference {

inline constexpr long double c1 = 2.0L * 6.62607015e-34L * 299792458.0L * 299792458.0L * 1e24L;
inline constexpr long double c2 = 6.62607015e-34L * 299792458.0L / 1.380649e-23L * 1e6L;

/// exp(x) - 1 by its series where the difference would lose digits.
inline long double exponentialLessOne(long double x) {
    if (x > 0.5L)
        return std::exp(x) - 1.0L;
    long double term = x;
    long double sum = x;
    for (int n = 2; n < 40; ++n) {
        term *= x / n;
        sum += term;
    }
    return sum;
}

/// W m-2 sr-1 um-1.
inline long double planck(long double wavelength_um, long double temperature_K) {
    const long double x = c2 / (wavelength_um * temperature_K);
    const long double squared = wavelength_um * wavelength_um;
    return c1 / (squared * squared * wavelength_um) / exponentialLessOne(x);
}

/// Integral of L_bb over a range by Simpson's rule on a fine even grid in ln lambda. What lies more
/// than 100 exponents above the smallest is less than 1e-40 of the integral and left out.
inline long double bandRadiance(const irsg::SpectralRange& range, long double temperature_K,
                                int intervals = 20000) {
    const long double visible_um =
        c2 / temperature_K / (c2 / (range.max_um * temperature_K) + 100.0L);
    const long double low = std::log(std::max<long double>(range.min_um, visible_um));
    const long double high = std::log(static_cast<long double>(range.max_um));
    const long double step = (high - low) / intervals;
    long double sum = 0.0L;
    for (int i = 0; i <= intervals; ++i) {
        const long double wavelength_um = std::exp(low + step * i);
        const int weight = i == 0 || i == intervals ? 1 : (i % 2 == 1 ? 4 : 2);
        sum += weight * wavelength_um * planck(wavelength_um, temperature_K);
    }
    return sum * step / 3.0L;
}

} // namespace irsg::reference

#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "irsg/core/Interpolation.h"

namespace irsg {

/// Piecewise cubic interpolation through (x, y) that is monotone where the data are (Fritsch and
/// Butland 1984, SIAM J. Sci. Stat. Comput. 5, 300), linear for two nodes, exact at the nodes and
/// for data on a line; in the first and last interval beyond the ends it continues as a line.
/// `y` gives the value at an index. x ascends strictly and has at least two nodes.
template <typename Values>
double monotoneCubic(std::span<const double> x, const Values& y, double at) {
    const std::size_t n = x.size();
    const auto [i, above, t] = bracket(x, at, Beyond::extrapolate);
    const auto step = [&](std::size_t k) { return x[k + 1] - x[k]; };
    const auto rise = [&](std::size_t k) { return (y(k + 1) - y(k)) / step(k); };
    if (n == 2 || at < x.front() || at > x.back())
        return y(i) + rise(i) * (at - x[i]);
    const auto end = [](double h0, double h1, double d0, double d1) {
        const double slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
        if (slope * d0 <= 0.0)
            return 0.0;
        return d0 * d1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(d0) ? 3.0 * d0 : slope;
    };
    const auto slope = [&](std::size_t k) {
        if (k == 0)
            return end(step(0), step(1), rise(0), rise(1));
        if (k == n - 1)
            return end(step(n - 2), step(n - 3), rise(n - 2), rise(n - 3));
        const double before = rise(k - 1);
        const double after = rise(k);
        if (before * after <= 0.0)
            return 0.0;
        const double w0 = 2.0 * step(k) + step(k - 1);
        const double w1 = step(k) + 2.0 * step(k - 1);
        return (w0 + w1) / (w0 / before + w1 / after);
    };
    const double h = step(i);
    const double s = 1.0 - t;
    return y(i) * s * s * (1.0 + 2.0 * t) + y(above) * t * t * (1.0 + 2.0 * s) +
           h * t * s * (slope(i) * s - slope(above) * t);
}

} // namespace irsg

#include "irsg/sensor/DetectionRange.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// The root of f between a and b, where it has unlike signs (R. P. Brent, Algorithms for
/// Minimization without Derivatives, chapter 4).
template <typename Function>
double rootBetween(double a, double fa, double b, double fb, double tolerance, const Function& f) {
    double c = a, fc = fa, step = b - a, last = step;
    for (int i = 0; i < 200 && fb != 0.0; ++i) {
        if ((fb > 0.0) == (fc > 0.0)) {
            c = a, fc = fa;
            step = last = b - a;
        }
        if (std::abs(fc) < std::abs(fb)) {
            a = b, b = c, c = a;
            fa = fb, fb = fc, fc = fa;
        }
        const double middle = 0.5 * (c - b);
        if (std::abs(middle) <= tolerance)
            break;
        if (std::abs(last) >= tolerance && std::abs(fa) > std::abs(fb)) {
            const double s = fb / fa;
            double p = 2.0 * middle * s, q = 1.0 - s; // a secant
            if (a != c) {                             // a parabola through three points
                const double r = fb / fc;
                q = fa / fc;
                p = s * (2.0 * middle * q * (q - r) - (b - a) * (r - 1.0));
                q = (q - 1.0) * (r - 1.0) * (s - 1.0);
            }
            (p > 0.0 ? q : p) *= -1.0;
            const double most =
                std::min(3.0 * middle * q - std::abs(tolerance * q), std::abs(last * q));
            last = 2.0 * p < most ? std::exchange(step, p / q) : (step = middle);
        } else {
            last = step = middle;
        }
        a = b, fa = fb;
        b += std::abs(step) > tolerance ? step : std::copysign(tolerance, middle);
        fb = f(b);
    }
    return b;
}

} // namespace

DetectionRange detectionRange(const std::function<double(double)>& ratio, double threshold,
                              const RangeLimits& limits) {
    if (!(limits.nearest_m > 0.0 && limits.farthest_m > limits.nearest_m &&
          std::isfinite(limits.farthest_m)))
        throw InputError({"", "limits of the range",
                          numberText(limits.nearest_m) + " to " + numberText(limits.farthest_m),
                          "two ascending ranges above 0 m"});
    if (!(threshold > 0.0 && std::isfinite(threshold)))
        throw InputError({"", "threshold", numberText(threshold), "a number above 0"});
    // ln(SNR / threshold) over ln(range); a contrast of zero is far below.
    const auto excess = [&](double logRange) {
        constexpr double least = -700.0;
        const double value = ratio(std::exp(logRange)) / threshold;
        return value > 0.0 ? std::max(least, std::log(value)) : least;
    };
    const double from = std::log(limits.nearest_m), to = std::log(limits.farthest_m);
    const int looks =
        std::max(2, 1 + static_cast<int>(std::ceil((to - from) / std::log(10.0) *
                                                   std::max(1, limits.looksPerDecade))));
    std::vector<double> places, values;
    for (int i = 0; i < looks; ++i) {
        places.push_back(std::lerp(from, to, static_cast<double>(i) / (looks - 1)));
        values.push_back(excess(places.back()));
    }
    DetectionRange found;
    std::size_t last = places.size();
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        if ((values[i] >= 0.0) != (values[i + 1] >= 0.0)) {
            ++found.crossings;
            if (values[i] >= 0.0)
                last = i;
        }
    if (values.back() >= 0.0) {
        found.found = DetectionRange::Found::beyond;
        found.range_m = limits.farthest_m;
        return found;
    }
    if (last == places.size())
        return found;
    const double root = rootBetween(places[last], values[last], places[last + 1], values[last + 1],
                                    limits.tolerance, excess);
    found.found = DetectionRange::Found::atRange;
    found.range_m = std::exp(root);
    const double width = 1e-3;
    found.slope = (excess(root + width) - excess(root - width)) / (2.0 * width);
    return found;
}

} // namespace irsg

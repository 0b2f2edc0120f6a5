#include "irsg/sensor/DetectionRange.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include <boost/math/tools/toms748_solve.hpp>

#include "irsg/core/Errors.h"

namespace irsg {

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
    const auto isNarrow = [&](double a, double b) { return b - a <= limits.tolerance; };
    std::uintmax_t most = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(
        excess, places[last], places[last + 1], values[last], values[last + 1], isNarrow, most);
    const double root = std::midpoint(low, high);
    found.found = DetectionRange::Found::atRange;
    found.range_m = std::exp(root);
    const double width = 1e-3;
    found.slope = (excess(root + width) - excess(root - width)) / (2.0 * width);
    return found;
}

} // namespace irsg

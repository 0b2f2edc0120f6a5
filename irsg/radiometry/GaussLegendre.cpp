#include "irsg/radiometry/GaussLegendre.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include <boost/math/special_functions/legendre.hpp>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

constexpr int mostPoints = 32;

GaussRule computeRule(int points) {
    // Only the zeros of one half are given; the others mirror them.
    std::vector<long double> zeros = boost::math::legendre_p_zeros<long double>(points);
    for (std::size_t i = 0, half = zeros.size(); i < half; ++i)
        if (zeros[i] > 0.0L)
            zeros.push_back(-zeros[i]);
    std::ranges::sort(zeros);
    GaussRule rule;
    for (const long double x : zeros) {
        const long double slope = boost::math::legendre_p_prime(points, x);
        rule.nodes.push_back(static_cast<double>(0.5L * (1.0L + x)));
        rule.weights.push_back(static_cast<double>(1.0L / ((1.0L - x * x) * slope * slope)));
    }
    return rule;
}

} // namespace

const GaussRule& gaussLegendre(int points) {
    static const std::vector<GaussRule> rules = [] {
        std::vector<GaussRule> all;
        for (int n = 1; n <= mostPoints; ++n)
            all.push_back(computeRule(n));
        return all;
    }();
    if (points < 1 || points > mostPoints)
        throw LogicError("no Gauss-Legendre rule of " + std::to_string(points) + " points");
    return rules[static_cast<std::size_t>(points - 1)];
}

} // namespace irsg

#include "irsg/radiometry/GaussLegendre.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "irsg/radiometry/Errors.h"

namespace irsg {

namespace {

constexpr int mostPoints = 32;

GaussRule computeRule(int points) {
    GaussRule rule;
    for (int i = 0; i < points; ++i) {
        // Newton's method from the asymptotic root; P and P' by the three-term recurrence.
        long double x = -std::cos(std::numbers::pi_v<long double> *
                                  (static_cast<long double>(i) + 0.75L) / (points + 0.5L));
        long double slope = 1.0L;
        for (int iteration = 0; iteration < 12; ++iteration) {
            long double previous = 1.0L;
            long double current = x;
            for (int n = 2; n <= points; ++n) {
                const long double next = ((2 * n - 1) * x * current - (n - 1) * previous) / n;
                previous = current;
                current = next;
            }
            slope = points * (x * current - previous) / (x * x - 1.0L);
            x -= current / slope;
        }
        rule.nodes.push_back(static_cast<double>(0.5L * (1.0L + x)));
        rule.weights.push_back(static_cast<double>(1.0L / ((1.0L - x * x) * slope * slope)));
    }
    return rule;
}

} // namespace

const GaussRule& gaussLegendre(int points) {
    static const std::vector<GaussRule> rules = [] {
        std::vector<GaussRule> all;
        for (int n = 1; n <= mostPoints; ++n) {
            all.push_back(computeRule(n));
        }
        return all;
    }();
    if (points < 1 || points > mostPoints) {
        throw LogicError("no Gauss-Legendre rule of " + std::to_string(points) + " points");
    }
    return rules[static_cast<std::size_t>(points - 1)];
}

} // namespace irsg

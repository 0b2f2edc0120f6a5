#include "irsg/scattering/BesselIntegral.h"

#include <cmath>
#include <vector>

#include "irsg/radiometry/GaussLegendre.h"

namespace irsg {

namespace {

constexpr double tableEnd = 64.0;
constexpr int nodesPerUnit = 16;
constexpr double step = 1.0 / nodesPerUnit;

/// Value and first two derivatives at the nodes.
struct Node {
    double value, slope, bend;
};

std::vector<Node> makeTable() {
    const GaussRule& rule = gaussLegendre(8);
    std::vector<Node> table;
    double sum = 0.0;
    for (int i = 0; i <= static_cast<int>(tableEnd) * nodesPerUnit; ++i) {
        const double x = step * i;
        table.push_back({sum, ::j0(x), -::j1(x)});
        for (std::size_t k = 0; k < rule.nodes.size(); ++k)
            sum += step * rule.weights[k] * ::j0(x + step * rule.nodes[k]);
    }
    return table;
}

/// Quintic through value, slope and bend of two nodes; t from 0 to 1 between them.
double between(const Node& a, const Node& b, double t) {
    const double t2 = t * t, t3 = t2 * t;
    const double rise = b.value - a.value;
    const double s0 = a.slope * step, s1 = b.slope * step;
    const double c0 = 0.5 * a.bend * step * step, c1 = 0.5 * b.bend * step * step;
    return a.value + s0 * t + c0 * t2 +
           t3 * ((10.0 * rise - 6.0 * s0 - 4.0 * s1 - 3.0 * c0 + c1) +
                 t * (-15.0 * rise + 8.0 * s0 + 7.0 * s1 + 3.0 * c0 - 2.0 * c1) +
                 t2 * (6.0 * rise - 3.0 * s0 - 3.0 * s1 - c0 + c1));
}

double farAway(double x) {
    double below = ::j0(x), here = ::j1(x), weight = 1.0, sum = 1.0;
    for (int k = 0; k < 14; ++k) {
        sum += weight * here;
        weight *= (2.0 * k + 1.0) / x;
        const double above = 2.0 * (k + 1.0) / x * here - below;
        below = here;
        here = above;
    }
    return sum;
}

} // namespace

double integralOfJ0(double x) {
    static const std::vector<Node> table = makeTable();
    if (x >= tableEnd)
        return farAway(x);
    const double place = x * nodesPerUnit;
    const auto i = static_cast<std::size_t>(place);
    return between(table[i], table[i + 1], place - static_cast<double>(i));
}

double besselOverMean(double x) {
    if (x >= 2.0)
        return ::j0(x) - integralOfJ0(x) / x;
    // Term by term: the series of J0 with the weights 1 - 1 / (2k + 1).
    const double quarter = 0.25 * x * x;
    double term = 1.0, sum = 0.0;
    for (int k = 1; k < 14; ++k) {
        term *= -quarter / (static_cast<double>(k) * k);
        sum += term * (2.0 * k) / (2.0 * k + 1.0);
    }
    return sum;
}

} // namespace irsg

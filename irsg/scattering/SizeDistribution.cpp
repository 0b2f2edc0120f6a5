#include "irsg/scattering/SizeDistribution.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/GaussLegendre.h"

namespace irsg {

namespace {

/// Part of the largest contribution to the shadow below which radii are left out.
constexpr double negligible = 1e-9;
constexpr int panels = 24, nodesOfPanel = 8;

/// ln of the number of droplets in d ln r, up to a constant; `u` = ln(r / radius).
double logNumber(const SizeDistribution& distribution, double u) {
    if (distribution.kind == SizeDistribution::Kind::gamma)
        return (distribution.width + 1.0) * u - distribution.width * std::exp(u);
    const double s = std::log(distribution.width);
    return -0.5 * u * u / (s * s);
}

/// Where the shadow of droplets falls below `negligible` of its largest, from `peak` on.
double edge(const SizeDistribution& distribution, double peak, double step) {
    const auto shadow = [&](double u) { return logNumber(distribution, u) + 2.0 * u; };
    const double floor = shadow(peak) + std::log(negligible);
    double u = peak;
    while (shadow(u) > floor)
        u += step;
    return u;
}

void check(const SizeDistribution& distribution) {
    if (!(distribution.radius_um >= 1e-3 && distribution.radius_um <= 1e4))
        throw InputError({"", "droplet radius", numberText(distribution.radius_um) + " um",
                          "0.001 to 10000 um"});
    if (distribution.kind == SizeDistribution::Kind::gamma &&
        !(distribution.width > 0.0 && distribution.width <= 1000.0))
        throw InputError({"", "width of the gamma distribution", numberText(distribution.width),
                          "above 0, at most 1000"});
    if (distribution.kind == SizeDistribution::Kind::logNormal &&
        !(distribution.width >= 1.01 && distribution.width <= 10.0))
        throw InputError(
            {"", "geometric standard deviation", numberText(distribution.width), "1.01 to 10"});
}

} // namespace

std::string SizeDistribution::description() const {
    switch (kind) {
    case Kind::gamma:
        return "gamma, mode " + numberText(radius_um) + " um, width " + numberText(width);
    case Kind::logNormal:
        return "log-normal, median " + numberText(radius_um) +
               " um, geometric standard deviation " + numberText(width);
    default:
        return "one radius, " + numberText(radius_um) + " um";
    }
}

SizeDistribution::Nodes SizeDistribution::nodes() const {
    check(*this);
    if (kind == Kind::single)
        return {{radius_um}, {1.0}};
    const double s = std::log(width);
    const double peak = kind == Kind::gamma ? std::log((width + 3.0) / width) : 2.0 * s * s;
    const double low = edge(*this, peak, -0.01), high = edge(*this, peak, 0.01);
    const GaussRule& rule = gaussLegendre(nodesOfPanel);
    Nodes nodes;
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel)
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            const double u = low + (high - low) * (panel + rule.nodes[k]) / panels;
            nodes.radii_um.push_back(radius_um * std::exp(u));
            nodes.numbers.push_back(rule.weights[k] *
                                    std::exp(logNumber(*this, u) - logNumber(*this, peak)));
            sum += nodes.numbers.back();
        }
    for (double& number : nodes.numbers)
        number /= sum;
    return nodes;
}

double SizeDistribution::meanDiameter_um() const {
    const Nodes all = nodes();
    double square = 0.0;
    for (std::size_t i = 0; i < all.radii_um.size(); ++i)
        square += all.numbers[i] * all.radii_um[i] * all.radii_um[i];
    return 2.0 * std::sqrt(square);
}

} // namespace irsg

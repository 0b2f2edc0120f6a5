#include "irsg/signature/random/StableDistribution.h"

#include <algorithm>
#include <cmath>

#include "irsg/signature/random/PortableMath.h"

namespace irsg {

namespace {

constexpr double pi = 3.14159265358979324;
constexpr double halfPi = 0.5 * pi;

/// The rule covers |t| <= reach; beyond it nodes lie within 1e-30 of an end of the interval.
constexpr double reach = 3.8;
constexpr double coarsestStep = 0.25;
constexpr int levelCount = 7;

} // namespace

StableDistribution::StableDistribution(double alpha, double beta)
    : alpha_(alpha), right_(sideOf(alpha, beta)), left_(sideOf(alpha, -beta)) {}

StableDistribution::Side StableDistribution::sideOf(double alpha, double beta) {
    Side side;
    if (alpha == 1.0)
        return side;
    const double tangent = portable::sin(halfPi * alpha) / portable::cos(halfPi * alpha);
    const double theta0 = alpha == 2.0 ? 0.0 : portable::atan(beta * tangent) / alpha;
    const double length = halfPi + theta0;
    side.mass = length / pi;
    if (!(length > 1e-12))
        return side; // nothing on this side

    // Distances from both ends, phi from -theta0 and psi from pi / 2, keep their digits near them.
    const double constant = portable::log(portable::cos(alpha * theta0)) / (alpha - 1.0);
    const double power = alpha / (alpha - 1.0);
    const auto snapped = [](double angle) { return std::abs(angle) < 1e-12 ? 0.0 : angle; };
    const double gap = snapped(pi - length), alphaGap = snapped(pi - alpha * length);
    const auto nodeAt = [&](double t, double step) {
        const double s = halfPi * 0.5 * (portable::exp(t) - portable::exp(-t));
        const double nearer = portable::exp(-2.0 * std::abs(s));
        const double small = length * nearer / (1.0 + nearer);
        const double phi = t < 0.0 ? small : length - small;
        const double psi = t < 0.0 ? length - small : small;
        const double slope = halfPi * 0.5 * (portable::exp(t) + portable::exp(-t));
        const double weight =
            step * slope * length * 2.0 * nearer / ((1.0 + nearer) * (1.0 + nearer));
        // With theta = pi / 2 - psi, cos(alpha theta0 + (alpha - 1) theta) = sin(alpha phi + psi).
        // Near either end the arguments are written as pi less what is small there.
        const double sinPsi = psi < halfPi ? portable::sin(psi) : portable::sin(gap + phi);
        const double sine =
            t < 0.0 ? portable::sin(alpha * phi) : portable::sin(alphaGap + alpha * psi);
        const double cosine = t < 0.0 ? portable::sin(gap + (1.0 - alpha) * phi)
                                      : portable::sin(alphaGap + (alpha - 1.0) * psi);
        if (!(sine > 0.0 && cosine > 0.0 && sinPsi > 0.0))
            return Node{0.0, 0.0};
        const double logSinPsi = portable::log(sinPsi);
        return Node{constant + power * (logSinPsi - portable::log(sine)) + portable::log(cosine) -
                        logSinPsi,
                    weight / pi};
    };
    side.leastLogV = portable::infinity;
    double step = coarsestStep;
    for (int level = 0; level < levelCount; ++level, step /= 2.0) {
        std::vector<Node>& nodes = side.levels.emplace_back();
        const int last = static_cast<int>(reach / step);
        for (int i = -last; i <= last; ++i)
            if (level == 0 || i % 2 != 0)
                if (const Node node = nodeAt(i * step, step); node.weight > 0.0) {
                    nodes.push_back(node);
                    side.leastLogV = std::min(side.leastLogV, node.logV);
                }
    }
    return side;
}

LogTails StableDistribution::tailsOf(const Side& side, double z) const {
    const double x = alpha_ / (alpha_ - 1.0) * portable::log(z);

    // alpha > 1: P(Z > z) = I; alpha < 1: P(0 < Z <= z) = I, with I = sum of w exp(-e^h). The
    // largest term is taken out, so that the logarithm survives where the sum would be 0.
    const double least = portable::exp(x + side.leastLogV);
    if (std::isinf(least))
        return alpha_ > 1.0 ? tailsFromUpper(-portable::infinity)
                            : tailsFromLower(portable::log(1.0 - side.mass));
    double integral = 0.0, complement = 0.0;
    for (const auto& level : side.levels) {
        double more = 0.0, moreComplement = 0.0;
        for (const Node& node : level) {
            const double e = portable::exp(x + node.logV);
            more += node.weight * portable::exp(least - e);
            if (alpha_ < 1.0)
                moreComplement -= node.weight * portable::expm1(-e);
        }
        const bool isFirst = &level == &side.levels.front();
        const double previous = integral, previousComplement = complement;
        integral = (isFirst ? 0.0 : 0.5 * previous) + more;
        complement = (isFirst ? 0.0 : 0.5 * previousComplement) + moreComplement;
        if (!isFirst && std::abs(integral - previous) <= 1e-8 * integral &&
            std::abs(complement - previousComplement) <= 1e-8 * complement)
            break;
    }
    const double logIntegral = portable::log(integral) - least;
    if (alpha_ > 1.0)
        return tailsFromUpper(logIntegral);

    // Below 1 the upper tail is the integral of 1 - exp(-e^h); the lower adds what is left of 0.
    const double leftOfZero = 1.0 - side.mass;
    const double lower =
        leftOfZero < 1e-12 ? logIntegral : portable::log(leftOfZero + portable::exp(logIntegral));
    return {std::min(lower, 0.0), std::min(portable::log(complement), 0.0)};
}

LogTails StableDistribution::tails(double z) const {
    if (alpha_ == 1.0) {
        // Cauchy: the tail beyond |z| is atan(1 / |z|) / pi.
        const double beyond = std::abs(z) > 1.0 ? portable::atan(1.0 / std::abs(z))
                                                : halfPi - portable::atan(std::abs(z));
        const LogTails tails = tailsFromUpper(portable::log(beyond / pi));
        return z >= 0.0 ? tails : LogTails{tails.upper, tails.lower};
    }
    if (z == 0.0)
        return tailsFromUpper(portable::log(right_.mass));
    const Side& side = z > 0.0 ? right_ : left_;
    const bool nothingThere = side.levels.empty();
    const LogTails tails =
        nothingThere ? LogTails{0.0, -portable::infinity} : tailsOf(side, std::abs(z));
    return z > 0.0 ? tails : LogTails{tails.upper, tails.lower};
}

} // namespace irsg

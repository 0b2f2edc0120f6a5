#include "irsg/signature/TruncatedDistribution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "irsg/signature/random/PortableMath.h"

namespace irsg {

namespace {

using Kind = DistributionKind;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double ln2 = 0.69314718055994531;
constexpr int bracketCount = 64;

/// The tails of t >= 0 on the right of a symmetric distribution, as those of z.
LogTails mirrored(const LogTails& right, double z) {
    return z >= 0.0 ? right : LogTails{right.upper, right.lower};
}

/// z with tail e^-x: the exponential distribution.
LogTails exponentialTails(double x) {
    return x > 0.0 ? tailsFromUpper(-x) : LogTails{-infinity, 0.0};
}

LogTails studentTails(double degrees, double z) {
    // P(|T| > t) = I(nu / (nu + t^2); nu / 2, 1 / 2).
    const double square = z * z;
    const double whole = degrees + square;
    const double outside =
        std::isinf(square) ? -infinity
                           : betaTails(0.5 * degrees, 0.5, degrees / whole, square / whole).lower;
    return mirrored(tailsFromUpper(outside - ln2), z);
}

LogTails poissonTails(double mean, double k) {
    if (k < 0.0)
        return {-infinity, 0.0};
    const LogTails gamma = gammaTails(std::floor(k) + 1.0, mean);
    return {gamma.upper, gamma.lower};
}

} // namespace

Distribution::Truncated::Truncated(DistributionKind kind, double min, double max,
                                   const std::vector<double>& p)
    : kind_(kind) {
    switch (kind) {
    case Kind::uniform:
        origin_ = min;
        scale_ = max - min;
        break;
    case Kind::logNormal:
        a_ = p[1];
        scale_ = p[0];
        break;
    case Kind::pareto:
        scale_ = p[0];
        a_ = p[1];
        break;
    case Kind::poisson:
        a_ = p[0];
        break;
    default:
        origin_ = p[0];
        scale_ = p[1];
        a_ = p.size() > 2 ? p[2] : 0.0;
        b_ = p.size() > 3 ? p[3] : 0.0;
    }
    if (kind == Kind::stable)
        stable_.emplace(a_, b_);

    if (kind == Kind::poisson) {
        first_ = std::ceil(std::max(min, 0.0));
        last_ = std::floor(max);
        if (first_ > last_)
            throw InputError(
                {"", "",
                 "no whole number of at least 0 from " + numberText(min) + " to " + numberText(max),
                 "one that a Poisson distribution can take"});
        atFirst_ = tails(first_ - 1.0);
    } else {
        first_ = (min - origin_) / scale_;
        last_ = (max - origin_) / scale_;
        atFirst_ = tails(first_);
    }
    atLast_ = tails(last_);
    mass_ = atFirst_.lower < -ln2 ? portable::exp(atLast_.lower) - portable::exp(atFirst_.lower)
                                  : portable::exp(atFirst_.upper) - portable::exp(atLast_.upper);
    if (!(atLast_.lower > atFirst_.lower) && !(atFirst_.upper > atLast_.upper))
        throw InputError({"", "",
                          "no probability from " + numberText(min) + " to " + numberText(max),
                          "min and max where the distribution has values"});

    if (kind != Kind::poisson && !closedForm({true, -1.0})) {
        std::vector<Knot> knots{{first_, atFirst_}};
        for (int i = 1; i < bracketCount; ++i) {
            const Knot& below = knots.back();
            const double z =
                solved(targetOf(double(i) / bracketCount), below.z, below.tails, last_, atLast_);
            knots.push_back({z, tails(z)});
        }
        knots.push_back({last_, atLast_});
        knots_ = std::move(knots);
    }
}

LogTails Distribution::Truncated::tails(double z) const {
    switch (kind_) {
    case Kind::uniform:
        return z <= 0.0   ? LogTails{-infinity, 0.0}
               : z >= 1.0 ? LogTails{0.0, -infinity}
                          : LogTails{portable::log(z), portable::log1p(-z)};
    case Kind::normal:
        return normalTails(z);
    case Kind::exponential:
        return exponentialTails(z);
    case Kind::laplace:
        return mirrored(tailsFromUpper(-std::abs(z) - ln2), z);
    case Kind::cauchy: {
        static const StableDistribution cauchy(1.0, 0.0);
        return cauchy.tails(z);
    }
    case Kind::rayleigh:
        return z > 0.0 ? exponentialTails(0.5 * z * z) : LogTails{-infinity, 0.0};
    case Kind::logNormal:
        return z > 0.0 ? normalTails(portable::log(z) / a_) : LogTails{-infinity, 0.0};
    case Kind::stable:
        return stable_->tails(z);
    case Kind::gamma:
        return gammaTails(a_, z);
    case Kind::chiSquared:
        return gammaTails(0.5 * a_, 0.5 * z);
    case Kind::fisherF: {
        const double whole = a_ * z + b_;
        return z > 0.0 ? betaTails(0.5 * a_, 0.5 * b_, a_ * z / whole, b_ / whole)
                       : LogTails{-infinity, 0.0};
    }
    case Kind::studentT:
        return studentTails(a_, z);
    case Kind::beta:
        return betaTails(a_, b_, z, 1.0 - z);
    case Kind::pareto:
        return z > 1.0 ? exponentialTails(a_ * portable::log(z)) : LogTails{-infinity, 0.0};
    case Kind::poisson:
        return poissonTails(a_, z);
    }
    throw LogicError("unknown distribution");
}

Distribution::Truncated::Target Distribution::Truncated::targetOf(double u) const {
    // ln of the mixture (1 - u) e^first + u e^last of a tail that lies on one side of the median.
    const auto mixed = [&](double first, double last) {
        const double large = std::max(first, last);
        return large + portable::log((1.0 - u) * portable::exp(first - large) +
                                     u * portable::exp(last - large));
    };
    if (atLast_.lower <= -ln2)
        return {false, mixed(atFirst_.lower, atLast_.lower)};
    if (atFirst_.upper <= -ln2)
        return {true, mixed(atFirst_.upper, atLast_.upper)};
    const double lower = portable::exp(atFirst_.lower) + u * mass_;
    if (lower <= 0.5)
        return {false, portable::log(lower)};
    return {true, portable::log(portable::exp(atLast_.upper) + (1.0 - u) * mass_)};
}

std::optional<double> Distribution::Truncated::closedForm(const Target& target) const {
    const auto exponential = [&] {
        return -(target.isUpper ? target.log : portable::log1mExp(target.log));
    };
    switch (kind_) {
    case Kind::uniform:
        return target.isUpper ? -portable::expm1(target.log) : portable::exp(target.log);
    case Kind::exponential:
        return exponential();
    case Kind::laplace: {
        const double beyond = std::min(target.log + ln2, 0.0);
        return target.isUpper ? -beyond : beyond;
    }
    case Kind::rayleigh:
        return std::sqrt(2.0 * exponential());
    case Kind::pareto:
        return portable::exp(exponential() / a_);
    default:
        return std::nullopt;
    }
}

double Distribution::Truncated::solved(const Target& target, double z1, const LogTails& tails1,
                                       double z2, const LogTails& tails2) const {
    // Chandrupatla 1997: inverse quadratic interpolation where it is safe, else bisection. Both
    // tails are made to rise with z.
    const auto error = [&](const LogTails& at) {
        return target.isUpper ? target.log - at.upper : at.lower - target.log;
    };
    constexpr double absolute = 1e-300; // where an end of the range is 0, its digits count
    double f1 = error(tails1), f2 = error(tails2);
    if (f1 >= 0.0)
        return z1;
    if (f2 <= 0.0)
        return z2;
    double z3 = z1, f3 = f1, t = 0.5;
    for (int step = 0; step < 1200; ++step) {
        const double z = z1 + t * (z2 - z1);
        const double f = error(tails(z));
        if ((f > 0.0) == (f1 > 0.0)) {
            z3 = z1;
            f3 = f1;
        } else {
            z3 = z2;
            f3 = f2;
            z2 = z1;
            f2 = f1;
        }
        z1 = z;
        f1 = f;
        const double best = std::abs(f1) < std::abs(f2) ? z1 : z2;
        const double tolerance = 0x1p-51 * std::abs(best) + absolute;
        const double least = tolerance / std::abs(z2 - z1);
        if (f == 0.0 || least > 0.5)
            return best;
        const double xi = (z1 - z2) / (z3 - z2);
        const double phi = (f1 - f2) / (f3 - f2);
        t = 0.5;
        if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi)
            t = f1 / (f2 - f1) * f3 / (f2 - f3) +
                (z3 - z1) / (z2 - z1) * f1 / (f3 - f1) * f2 / (f3 - f2);
        t = std::clamp(std::isnan(t) ? 0.5 : t, least, 1.0 - least);
    }
    return std::abs(f1) < std::abs(f2) ? z1 : z2;
}

double Distribution::Truncated::wholeNumberAt(double u) const {
    // The least number whose tail has reached the target, by halving.
    const Target target = targetOf(u);
    const auto isReached = [&](double k) {
        const LogTails at = tails(k);
        return target.isUpper ? at.upper <= target.log : at.lower >= target.log;
    };
    double below = first_ - 1.0, reached = last_;
    while (reached - below > 1.0) {
        const double middle = std::floor(0.5 * (below + reached));
        (isReached(middle) ? reached : below) = middle;
    }
    return reached;
}

double Distribution::Truncated::at(double u) const {
    if (kind_ == Kind::poisson)
        return wholeNumberAt(u);
    const Target target = targetOf(u);
    if (const auto z = closedForm(target))
        return origin_ + scale_ * std::clamp(*z, first_, last_);
    const auto i = std::min(static_cast<std::size_t>(u * bracketCount),
                            static_cast<std::size_t>(bracketCount - 1));
    const Knot& below = knots_[i];
    const Knot& above = knots_[i + 1];
    return origin_ + scale_ * solved(target, below.z, below.tails, above.z, above.tails);
}

double Distribution::Truncated::probabilityBetween(const LogTails& at) const {
    // (F(x) - F(min)) / (F(max) - F(min)), from the tail on whose side of the median [min, max] is.
    if (atLast_.lower <= -ln2) {
        const double all = -portable::expm1(atFirst_.lower - atLast_.lower);
        return portable::exp(at.lower - atLast_.lower) *
               -portable::expm1(atFirst_.lower - at.lower) / all;
    }
    if (atFirst_.upper <= -ln2)
        return portable::expm1(at.upper - atFirst_.upper) /
               portable::expm1(atLast_.upper - atFirst_.upper);
    return at.lower <= -ln2
               ? (portable::exp(at.lower) - portable::exp(atFirst_.lower)) / mass_
               : 1.0 - (portable::exp(at.upper) - portable::exp(atLast_.upper)) / mass_;
}

double Distribution::Truncated::probabilityUpTo(double x) const {
    const LogTails at = tails((x - origin_) / scale_);
    if (std::isinf(at.lower))
        return 0.0;
    return probabilityBetween(at);
}

} // namespace irsg

#include "irsg/signature/TruncatedDistribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "irsg/signature/random/PortableMath.h"

namespace irsg {

namespace {

constexpr int bracketCount = 64;

} // namespace

Distribution::Truncated::Truncated(DistributionKind kind, double min, double max,
                                   const std::vector<double>& p)
    : law_(lawOf(kind)), form_(law_.standard(min, max, p)), tails_(law_.tails(form_)) {
    if (law_.isDiscrete) {
        first_ = std::ceil(std::max(min, 0.0));
        last_ = std::floor(max);
        if (first_ > last_)
            throw InputError(
                {"", "",
                 "no whole number of at least 0 from " + numberText(min) + " to " + numberText(max),
                 "one that a " + std::string(law_.info.name) + " distribution can take"});
        atFirst_ = tails(first_ - 1.0);
    } else {
        first_ = (min - form_.origin) / form_.scale;
        last_ = (max - form_.origin) / form_.scale;
        atFirst_ = tails(first_);
    }
    atLast_ = tails(last_);
    mass_ = atFirst_.lower < -std::numbers::ln2
                ? portable::exp(atLast_.lower) - portable::exp(atFirst_.lower)
                : portable::exp(atFirst_.upper) - portable::exp(atLast_.upper);
    if (!(atLast_.lower > atFirst_.lower) && !(atFirst_.upper > atLast_.upper))
        throw InputError({"", "",
                          "no probability from " + numberText(min) + " to " + numberText(max),
                          "min and max where the distribution has values"});

    if (!law_.isDiscrete && law_.closedForm == nullptr) {
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

TailTarget Distribution::Truncated::targetOf(double u) const {
    // ln of the mixture (1 - u) e^first + u e^last of a tail that lies on one side of the median.
    const auto mixed = [&](double first, double last) {
        const double large = std::max(first, last);
        return large + portable::log((1.0 - u) * portable::exp(first - large) +
                                     u * portable::exp(last - large));
    };
    if (atLast_.lower <= -std::numbers::ln2)
        return {false, mixed(atFirst_.lower, atLast_.lower)};
    if (atFirst_.upper <= -std::numbers::ln2)
        return {true, mixed(atFirst_.upper, atLast_.upper)};
    const double lower = portable::exp(atFirst_.lower) + u * mass_;
    if (lower <= 0.5)
        return {false, portable::log(lower)};
    return {true, portable::log(portable::exp(atLast_.upper) + (1.0 - u) * mass_)};
}

double Distribution::Truncated::solved(const TailTarget& target, double z1, const LogTails& tails1,
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
    const TailTarget target = targetOf(u);
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
    if (law_.isDiscrete)
        return wholeNumberAt(u);
    const TailTarget target = targetOf(u);
    if (law_.closedForm != nullptr)
        return form_.origin +
               form_.scale * std::clamp(law_.closedForm(form_, target), first_, last_);
    const auto i = std::min(static_cast<std::size_t>(u * bracketCount),
                            static_cast<std::size_t>(bracketCount - 1));
    const Knot& below = knots_[i];
    const Knot& above = knots_[i + 1];
    return form_.origin + form_.scale * solved(target, below.z, below.tails, above.z, above.tails);
}

double Distribution::Truncated::probabilityBetween(const LogTails& at) const {
    // (F(x) - F(min)) / (F(max) - F(min)), from the tail on whose side of the median [min, max] is.
    if (atLast_.lower <= -std::numbers::ln2) {
        const double all = -portable::expm1(atFirst_.lower - atLast_.lower);
        return portable::exp(at.lower - atLast_.lower) *
               -portable::expm1(atFirst_.lower - at.lower) / all;
    }
    if (atFirst_.upper <= -std::numbers::ln2)
        return portable::expm1(at.upper - atFirst_.upper) /
               portable::expm1(atLast_.upper - atFirst_.upper);
    return at.lower <= -std::numbers::ln2
               ? (portable::exp(at.lower) - portable::exp(atFirst_.lower)) / mass_
               : 1.0 - (portable::exp(at.upper) - portable::exp(atLast_.upper)) / mass_;
}

double Distribution::Truncated::probabilityUpTo(double x) const {
    const LogTails at = tails((x - form_.origin) / form_.scale);
    if (std::isinf(at.lower))
        return 0.0;
    return probabilityBetween(at);
}

} // namespace irsg

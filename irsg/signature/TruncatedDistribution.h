#pragma once

#include <functional>
#include <vector>

#include "irsg/signature/DistributionLaw.h"

namespace irsg {

/// The distribution function of a truncated distribution and its inverse. x = origin + scale z,
/// where z has the standard distribution of the kind.
class Distribution::Truncated {
  public:
    /// Numbers that Distribution has checked. Throws InputError where the distribution has no
    /// probability in [min, max], and for a discrete one without a whole number there.
    Truncated(DistributionKind kind, double min, double max, const std::vector<double>& parameters);

    double at(double u) const;
    double probabilityUpTo(double x) const;

  private:
    LogTails tails(double z) const { return tails_(z); }
    TailTarget targetOf(double u) const;
    double solved(const TailTarget& target, double z1, const LogTails& tails1, double z2,
                  const LogTails& tails2) const;
    double wholeNumberAt(double u) const;
    double probabilityBetween(const LogTails& at) const;

    const DistributionLaw& law_;
    StandardForm form_;
    std::function<LogTails(double)> tails_;
    double first_, last_;       ///< z of the ends; of a discrete distribution, its whole numbers
    LogTails atFirst_, atLast_; ///< at the ends; of a discrete distribution, below the first number
    double mass_ = 0.0;         ///< probability of [min, max], where it is no far tail

    /// Values at u = i / n: every search begins in a narrow bracket.
    struct Knot {
        double z;
        LogTails tails;
    };
    std::vector<Knot> knots_;
};

} // namespace irsg

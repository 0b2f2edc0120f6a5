#pragma once

#include <optional>
#include <vector>

#include "irsg/signature/Distribution.h"
#include "irsg/signature/random/LogTails.h"
#include "irsg/signature/random/StableDistribution.h"

namespace irsg {

/// The distribution function of a truncated distribution and its inverse. x = origin + scale z,
/// where z has the standard distribution of the kind.
class Distribution::Truncated {
  public:
    /// Numbers that Distribution has checked. Throws InputError where the distribution has no
    /// probability in [min, max], and for a Poisson distribution without a whole number there.
    Truncated(DistributionKind kind, double min, double max, const std::vector<double>& parameters);

    double at(double u) const;
    double probabilityUpTo(double x) const;

  private:
    /// The tail in which a probability is kept, and its logarithm.
    struct Target {
        bool isUpper;
        double log;
    };
    LogTails tails(double z) const;
    Target targetOf(double u) const;
    /// z of a tail, in closed form where the kind has one.
    std::optional<double> closedForm(const Target& target) const;
    double solved(const Target& target, double z1, const LogTails& tails1, double z2,
                  const LogTails& tails2) const;
    double wholeNumberAt(double u) const;
    double probabilityBetween(const LogTails& at) const;

    DistributionKind kind_;
    double origin_ = 0.0, scale_ = 1.0, a_ = 0.0, b_ = 0.0;
    std::optional<StableDistribution> stable_;
    double first_, last_;       ///< z of the ends; of a Poisson distribution, its whole numbers
    LogTails atFirst_, atLast_; ///< at the ends; of a Poisson distribution, below the first number
    double mass_ = 0.0;         ///< probability of [min, max], where it is no far tail

    /// Values at u = i / n: every search begins in a narrow bracket.
    struct Knot {
        double z;
        LogTails tails;
    };
    std::vector<Knot> knots_;
};

} // namespace irsg

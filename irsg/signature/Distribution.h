#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg {

/// The distributions of scaling files, by the number they have there: 0 to 14 are those
/// of the report (table 24), the others our own, which its programs refuse.
enum class DistributionKind {
    uniform = 0,
    normal,
    exponential,
    laplace,
    cauchy,
    rayleigh,
    logNormal,
    stable,
    gamma,
    chiSquared,
    fisherF,
    studentT,
    beta,
    pareto,
    poisson,
    triangular,
    trapezoidal
};
inline constexpr int distributionKindCount = static_cast<int>(DistributionKind::trapezoidal) + 1;

/// What a distribution is called and what its numbers mean.
struct DistributionInfo {
    DistributionKind kind;
    std::string_view name;                    ///< "log-normal"
    std::vector<std::string_view> parameters; ///< "median", "sigma of ln x"
    /// What the parameters are where a file gives min and max alone.
    std::string_view defaults;
};
const DistributionInfo& info(DistributionKind kind);
/// Of all kinds, by number.
const std::vector<DistributionInfo>& distributionTable();

/// A random variable that never leaves [min, max]: one of the kinds, truncated there.
/// With min = max it has that value always.
///
/// A number u of (0, 1) becomes the value whose truncated distribution function is u. That function
/// is computed from the nearer tail and as a logarithm, so that [40 sigma, 41 sigma] of a normal
/// distribution is as exact as its middle, and inverted by Chandrupatla's method (1997) inside a
/// bracket; every value takes about the same time, wherever [min, max] lies. All arithmetic is that
/// of PortableMath.h: equal numbers on every machine.
class Distribution {
  public:
    /// The value 1 always.
    Distribution();
    /// With the parameters of DistributionInfo::defaults, which follow from min and max.
    Distribution(DistributionKind kind, double min, double max);
    /// Throws InputError (without file and position) naming each number that cannot be.
    Distribution(DistributionKind kind, double min, double max, std::vector<double> parameters);
    ~Distribution();
    Distribution(const Distribution& other);
    Distribution& operator=(const Distribution& other);
    Distribution(Distribution&&) noexcept;
    Distribution& operator=(Distribution&&) noexcept;

    DistributionKind kind() const { return kind_; }
    double minimum() const { return min_; }
    double maximum() const { return max_; }
    const std::vector<double>& parameters() const { return parameters_; }
    bool isFixed() const { return min_ == max_; }
    /// True where the parameters are those that follow from min and max.
    bool hasDefaultParameters() const;

    /// The value at probability `u` of (0, 1), in [min, max]; rises with u.
    double at(double u) const;
    /// Probability of a value of at most `x`; 0 below min, 1 from max on.
    double probabilityUpTo(double x) const;

    /// Same kind, ends and parameters.
    bool operator==(const Distribution& other) const;

  private:
    class Truncated;

    DistributionKind kind_;
    double min_, max_;
    std::vector<double> parameters_;
    std::shared_ptr<const Truncated> truncated_; ///< null for a fixed value
};

} // namespace irsg

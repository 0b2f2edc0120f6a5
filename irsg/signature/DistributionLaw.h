#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "irsg/signature/Distribution.h"
#include "irsg/signature/random/LogTails.h"

namespace irsg {

/// What is wrong with the numbers of a distribution.
class ParameterCheck {
  public:
    void require(bool holds, std::string_view what, double value, std::string_view expected) {
        if (!holds)
            diagnostics_.push_back(
                {"", "", std::string(what) + " " + numberText(value), std::string(expected)});
    }
    /// Throws InputError with all that did not hold.
    void throwOnDiagnostics() {
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
    }

  private:
    std::vector<Diagnostic> diagnostics_;
};

/// A probability, as the logarithm of the tail that keeps its digits.
struct TailTarget {
    bool isUpper;
    double log;
};

/// x = origin + scale z, where z has a standard distribution with at most two shapes.
struct StandardForm {
    double origin = 0.0, scale = 1.0, a = 0.0, b = 0.0;
};

/// All that is known of one kind of distribution. A new kind is its name in DistributionKind and
/// its record in DistributionLaws.cpp.
struct DistributionLaw {
    DistributionInfo info;
    /// The parameters that DistributionInfo::defaults says.
    std::vector<double> (*defaults)(double min, double max);
    /// What min and max must be, beside min < max, for those to exist. Null: nothing.
    void (*checkEnds)(ParameterCheck& check, double min, double max) = nullptr;
    /// Of as many finite numbers as info.parameters has. Null: any will do.
    void (*check)(ParameterCheck& check, const std::vector<double>& p) = nullptr;
    StandardForm (*standard)(double min, double max, const std::vector<double>& p);
    /// Both tails at z, as a function of z.
    std::function<LogTails(double z)> (*tails)(const StandardForm& form);
    /// z of a tail in closed form; null where the kind has none.
    double (*closedForm)(const StandardForm& form, const TailTarget& target) = nullptr;
    bool isDiscrete = false; ///< whole numbers from 0 on
};

/// Throws LogicError for a number that is no kind.
const DistributionLaw& lawOf(DistributionKind kind);

} // namespace irsg

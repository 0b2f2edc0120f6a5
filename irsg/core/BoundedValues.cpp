#include "irsg/core/BoundedValues.h"

#include <algorithm>

#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"

namespace irsg {

std::optional<double> BoundedValues::take(double value, const std::string& place) {
    const double bound = std::clamp(value, least_, most_);
    if (bound == value)
        return value;
    // A sum that should be on the tolerance may miss it in its last bits.
    constexpr double rounding = 1e-9;
    const double beyond = value > most_ ? value - most_ : least_ - value;
    if (!(beyond <= tolerance_ * (1.0 + rounding)))
        return std::nullopt;
    if (count_++ == 0)
        first_ = place + ": " + numberText(value);
    return bound;
}

void BoundedValues::remark(const std::string& file) const {
    if (count_ == 0)
        return;
    const std::string range = numberText(least_) + " to " + numberText(most_);
    remarkOn(file, std::to_string(count_) + (count_ == 1 ? " value" : " values") + " outside of " +
                       range + " (" + first_ + (count_ > 1 ? ", ..." : "") +
                       ") taken as the bound; up to " + numberText(tolerance_) + " is tolerated");
}

} // namespace irsg

#include "irsg/atmosphere/import/Interpolation.h"

#include "irsg/core/Errors.h"

namespace irsg {

std::optional<Bracket> bracketOf(std::span<const double> axis, double value, double tolerance) {
    if (axis.empty() || value < axis.front() - tolerance || value > axis.back() + tolerance)
        return std::nullopt;
    const Bracket at = bracket(axis, value);
    if (at.fraction == 0.0)
        return Bracket{at.below, at.below, 0.0};
    if (at.fraction == 1.0)
        return Bracket{at.above, at.above, 0.0};
    return at;
}

std::string metresText(double length_m) {
    const double rounded = std::round(1e3 * length_m) / 1e3;
    return std::abs(rounded) < 1e15 && rounded == std::trunc(rounded)
               ? std::to_string(static_cast<long long>(rounded))
               : numberText(rounded);
}

} // namespace irsg

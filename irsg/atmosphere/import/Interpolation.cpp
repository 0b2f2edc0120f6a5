#include "irsg/atmosphere/import/Interpolation.h"

#include "irsg/core/Errors.h"

namespace irsg {

std::optional<Bracket> bracketOf(std::span<const double> axis, double value, double tolerance) {
    if (axis.empty() || value < axis.front() - tolerance || value > axis.back() + tolerance)
        return std::nullopt;
    if (value <= axis.front())
        return Bracket{0, 0, 0.0};
    if (value >= axis.back())
        return Bracket{axis.size() - 1, axis.size() - 1, 0.0};
    const std::size_t upper =
        static_cast<std::size_t>(std::ranges::upper_bound(axis, value) - axis.begin());
    const double weight = (value - axis[upper - 1]) / (axis[upper] - axis[upper - 1]);
    return weight > 0.0 ? Bracket{upper - 1, upper, weight} : Bracket{upper - 1, upper - 1, 0.0};
}

std::string metresText(double length_m) {
    const double rounded = std::round(1e3 * length_m) / 1e3;
    return std::abs(rounded) < 1e15 && rounded == std::trunc(rounded)
               ? std::to_string(static_cast<long long>(rounded))
               : numberText(rounded);
}

} // namespace irsg

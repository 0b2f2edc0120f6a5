#include "irsg/atmosphere/engine/CrossSectionGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"

namespace irsg {

namespace {

/// Lagrange's weights of `count` neighbouring nodes of an ascending or descending axis, clamped to
/// it.
template <std::size_t count>
    requires(count == 3 || count == 4)
std::size_t lagrange(const std::vector<double>& axis, double x,
                     std::array<double, count>& weights) {
    x = std::clamp(x, std::min(axis.front(), axis.back()), std::max(axis.front(), axis.back()));
    const Bracket at = bracket(axis, x);
    // Nodes before the one below: two on either side, or one on either side of the nearest.
    const std::size_t before =
        count == 3 ? (at.fraction < 0.5 ? 1 : 0) : (at.fraction > 0.0 ? 1 : 2);
    const std::size_t start = std::min(at.below - std::min(before, at.below), axis.size() - count);
    for (std::size_t i = 0; i < count; ++i) {
        weights[i] = 1.0;
        for (std::size_t j = 0; j < count; ++j)
            if (j != i)
                weights[i] *= (x - axis[start + j]) / (axis[start + i] - axis[start + j]);
    }
    return start;
}

} // namespace

std::size_t CrossSectionGrid::points(Gas gas) const {
    return (pressures_hPa.size() + (gas == Gas::H2O ? moistPressures : 0)) * temperatures_K.size();
}

GridStencil CrossSectionGrid::stencil(Gas gas, const AtmosphericState& air) const {
    std::vector<double> lnPressures(pressures_hPa.size());
    std::ranges::transform(pressures_hPa, lnPressures.begin(),
                           [](double p) { return std::log(p); });
    std::vector<double> inverse_per_K(temperatures_K.size());
    std::ranges::transform(temperatures_K, inverse_per_K.begin(), [](double T) { return 1.0 / T; });
    std::array<double, 4> alongPressure{};
    std::array<double, 3> alongTemperature{};
    const std::size_t row = lagrange(lnPressures, std::log(air.pressure_hPa), alongPressure);
    const std::size_t column = lagrange(inverse_per_K, 1.0 / air.temperature_K, alongTemperature);

    // Above the pressures that have a moist set there is too little water to broaden its own lines.
    double moist = 0.0;
    if (gas == Gas::H2O && row + 4 <= moistPressures)
        moist = air.fraction(Gas::H2O) / moistFraction;
    GridStencil stencil;
    auto add = [&](std::size_t point, double weight) {
        stencil.points[stencil.count] = static_cast<std::uint32_t>(point);
        stencil.weights[stencil.count++] = static_cast<float>(weight);
    };
    for (std::size_t i = 0; i < alongPressure.size(); ++i)
        for (std::size_t j = 0; j < alongTemperature.size(); ++j) {
            const double weight = alongPressure[i] * alongTemperature[j];
            const std::size_t point = (row + i) * temperatures_K.size() + column + j;
            add(point, weight * (1.0 - moist));
            if (moist > 0.0)
                add(point + pressures_hPa.size() * temperatures_K.size(), weight * moist);
        }
    return stencil;
}

void CrossSectionGrid::check() const {
    if (pressures_hPa.size() < 4 || temperatures_K.size() < 3 ||
        moistPressures > pressures_hPa.size() || (moistPressures > 0 && moistPressures < 4))
        throw LogicError("the grid of a gas table is too small to interpolate in");
    if (!std::ranges::is_sorted(pressures_hPa, std::greater<>()) ||
        !std::ranges::is_sorted(temperatures_K))
        throw LogicError("the grid of a gas table is not in order");
}

} // namespace irsg

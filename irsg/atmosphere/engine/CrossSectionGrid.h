#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"

namespace irsg {

/// Grid points around a state of the air and their weights, which sum to 1.
struct GridStencil {
    static constexpr std::size_t most = 24;
    std::array<std::uint32_t, most> points{};
    std::array<float, most> weights{};
    std::size_t count = 0;
};

/// Pressures and temperatures at which cross sections are tabulated. Their logarithm is
/// interpolated by Lagrange's polynomials, cubic in ln p and quadratic in 1/T, in which Boltzmann
/// factors are straight lines; water has a second, self-broadened set and is interpolated linearly
/// in its fraction between the two.
struct CrossSectionGrid {
    std::vector<double> pressures_hPa;  ///< descending, at least 4
    std::vector<double> temperatures_K; ///< ascending, at least 3
    double moistFraction = 0.04;        ///< mole fraction of water of the second set
    std::size_t moistPressures =
        0; ///< how many of the first pressures have that set: 0 or at least 4

    /// Number of values of a gas: temperature running fastest, the dry set before the moist one.
    std::size_t points(Gas gas) const;
    /// Air beyond the grid is clamped to it.
    GridStencil stencil(Gas gas, const AtmosphericState& air) const;
    /// LogicError where an axis is too short or out of order.
    void check() const;
};

} // namespace irsg

#pragma once

#include <vector>

namespace irsg {

/// Nodes and weights of Gauss-Legendre quadrature on 0 to 1: n points integrate polynomials of
/// degree 2 n - 1 exactly.
struct GaussRule {
    std::vector<double> nodes;
    std::vector<double> weights; ///< their sum is 1
};

/// The rule of 1 to 32 points, computed once from the zeros of the Legendre polynomial (Abramowitz
/// and Stegun 25.4.30), to a unit in the last place. Any other number is a LogicError.
const GaussRule& gaussLegendre(int points);

} // namespace irsg

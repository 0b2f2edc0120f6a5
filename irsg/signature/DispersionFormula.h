#pragma once

#include <span>

namespace irsg {

/// The dispersion formulas of the refractiveindex.info database, which counts them from 1:
/// Sellmeier (two forms), polynomial, its own, Cauchy, gases, Herzberger, Retro and Exotic
/// (Polyanskiy 2024, Sci. Data 11, 94, and the database's "Dispersion formulas").
inline constexpr int dispersionFormulas = 9;

/// How many coefficients formula 1 to 9 may have; fewer are completed by zeros.
std::size_t mostCoefficients(int formula);

/// The refractive index at a wavelength in um; NaN where the formula has none (its n^2 is negative,
/// a pole). `formula` is from 1 to 9, with at most mostCoefficients() coefficients, one at least.
double dispersionIndex(int formula, std::span<const double> coefficients, double wavelength_um);

} // namespace irsg

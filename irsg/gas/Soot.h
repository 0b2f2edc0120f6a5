#pragma once

#include <complex>

namespace irsg {

/// Complex refractive index n + ik of flame soot at 0.4 to 30 um; beyond, that of the end. H. Chang
/// and T. T. Charalampopoulos 1990 (Proc. R. Soc. Lond. A 430, 577), polynomials in ln lambda.
std::complex<double> sootRefractiveIndex(double wavelength_um);

/// Absorption coefficient, m-1, of soot of a volume fraction (1e-6 = 1 ppmv) with an index n + ik
/// whose particles are small against the wavelength (Rayleigh limit, scattering left out):
/// kappa = 36 pi n k f / (lambda ((n^2 - k^2 + 2)^2 + 4 n^2 k^2)).
double sootAbsorption_per_m(double wavelength_um, double volumeFraction,
                            std::complex<double> refractiveIndex);
/// The same with sootRefractiveIndex.
double sootAbsorption_per_m(double wavelength_um, double volumeFraction);

} // namespace irsg

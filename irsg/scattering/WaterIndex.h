#pragma once

#include <complex>

namespace irsg {

/// Refractive index n + i k of liquid water at 25 C, 0.4 to 14 um, linear between the rows of
/// table I of G. M. Hale and M. R. Querry 1973, Optical constants of water in the 200-nm to 200-um
/// wavelength region, Appl. Opt. 12, 555; ln k is what is linear of k. InputError outside.
std::complex<double> waterIndex(double wavelength_um);

} // namespace irsg

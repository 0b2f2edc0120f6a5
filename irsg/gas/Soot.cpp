#include "irsg/gas/Soot.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Units.h"

namespace irsg {

std::complex<double> sootRefractiveIndex(double wavelength_um) {
    const double x = std::log(std::clamp(wavelength_um, 0.4, 30.0));
    return {1.811 + x * (0.1263 + x * (0.0270 + x * 0.0417)),
            0.5821 + x * (0.1213 + x * (0.2309 - x * 0.0100))};
}

double sootAbsorption_per_m(double wavelength_um, double volumeFraction,
                            std::complex<double> refractiveIndex) {
    const double n = refractiveIndex.real(), k = refractiveIndex.imag();
    const double real = n * n - k * k + 2.0, imaginary = 2.0 * n * k;
    const double wavelength_m = wavelength_um * 1e-6;
    return 36.0 * pi * n * k * volumeFraction /
           (wavelength_m * (real * real + imaginary * imaginary));
}

double sootAbsorption_per_m(double wavelength_um, double volumeFraction) {
    return sootAbsorption_per_m(wavelength_um, volumeFraction, sootRefractiveIndex(wavelength_um));
}

} // namespace irsg

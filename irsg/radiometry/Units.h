#pragma once

#include <numbers>

namespace irsg {

/// Small conversions at the borders of the program. Inside, lengths are m, angles rad, wavelengths
/// um and temperatures K.
inline constexpr double pi = std::numbers::pi;

constexpr double radians(double degrees) {
    return degrees * (pi / 180.0);
}
constexpr double degrees(double radians) {
    return radians * (180.0 / pi);
}

constexpr double kelvinFromCelsius(double celsius) {
    return celsius + 273.15;
}
constexpr double celsiusFromKelvin(double kelvin) {
    return kelvin - 273.15;
}

/// lambda [um] = 1e4 / nu [cm-1], and back.
constexpr double wavelengthFromWavenumber_um(double wavenumber_per_cm) {
    return 1e4 / wavenumber_per_cm;
}
constexpr double wavenumberFromWavelength_per_cm(double wavelength_um) {
    return 1e4 / wavelength_um;
}

/// A density per cm-1 becomes one per um by the Jacobian |d nu / d lambda| = nu^2 / 1e4.
constexpr double perMicrometreFromPerWavenumber(double density_per_per_cm,
                                                double wavenumber_per_cm) {
    return density_per_per_cm * wavenumber_per_cm * wavenumber_per_cm * 1e-4;
}
constexpr double perWavenumberFromPerMicrometre(double density_per_um, double wavelength_um) {
    return density_per_um * wavelength_um * wavelength_um * 1e-4;
}

} // namespace irsg

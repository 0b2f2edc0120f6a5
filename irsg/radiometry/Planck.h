#pragma once

#include <optional>
#include <span>

namespace irsg {

class Band;

/// Exact SI constants (2019 redefinition).
inline constexpr double planckConstant_J_s = 6.62607015e-34;
inline constexpr double speedOfLight_m_s = 299792458.0;
inline constexpr double boltzmannConstant_J_K = 1.380649e-23;
/// 2 h c^2 in W m-2 sr-1 um^4, and c2 = h c / k in um K, both rounded once.
inline constexpr double firstRadiationConstant_W_um4_m2_sr =
    static_cast<double>(2.0L * 6.62607015e-34L * 299792458.0L * 299792458.0L * 1e24L);
inline constexpr double secondRadiationConstant_um_K =
    static_cast<double>(6.62607015e-34L * 299792458.0L / 1.380649e-23L * 1e6L);

/// Spectral radiance of a black body, W m-2 sr-1 um-1 (Planck's law, per unit wavelength):
/// L = 2 h c^2 / lambda^5 / (exp(h c / lambda k T) - 1).
/// Relative error below 1e-12 for h c / lambda k T from 1e-12 to 1e5 wherever the result exceeds
/// 1e-290, else 0; never NaN. T <= 0 gives 0. The trap: exp(x) - 1 loses all digits for small x, so
/// expm1; pbrt and Mitsuba differ by 1e9 in the unit of what they call blackbody, this one is per
/// um.
double planckRadiance_W_m2_sr_um(double wavelength_um, double temperature_K);
/// The same at many wavelengths, to the last bit, but in vectors, in a quarter of the time.
/// LogicError unless there is one radiance for each wavelength.
void planckRadiances_W_m2_sr_um(std::span<const double> wavelengths_um, double temperature_K,
                                std::span<double> radiances_W_m2_sr_um);

/// Derivative of the above with respect to temperature, W m-2 sr-1 um-1 K-1.
double planckDerivative_W_m2_sr_um_K(double wavelength_um, double temperature_K);

/// Brightness temperature, K, of a spectral radiance; no value for radiance <= 0 or not finite.
std::optional<double> brightnessTemperature_K(double wavelength_um, double radiance_W_m2_sr_um);

/// Band radiance of a black body, W m-2 sr-1: integral of L_bb(lambda, T) R(lambda) over the band,
/// by direct quadrature to 1e-9 relative.
double bandRadiance_W_m2_sr(const Band& band, double temperature_K);

/// Apparent temperature, K: the temperature of the black body whose band radiance is `radiance`,
/// solved to 1e-9 relative between 1 K and 1e6 K. No value for radiance <= 0, not finite, or
/// outside what black bodies of that range give.
std::optional<double> apparentTemperature_K(const Band& band, double radiance_W_m2_sr);

} // namespace irsg

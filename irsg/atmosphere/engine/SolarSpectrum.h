#pragma once

namespace irsg {

/// Extraterrestrial solar irradiance at 1 astronomical unit (Kurucz 1992), the mean over
/// [lower_per_cm, upper_per_cm] in W m-2 per cm-1, lower_per_cm < upper_per_cm, 200 to 50000 cm-1
/// (0 outside the table). Exact integrals of the shipped table whatever the limits.
double solarIrradiance_W_m2_per_cm(double lower_per_cm, double upper_per_cm);

} // namespace irsg

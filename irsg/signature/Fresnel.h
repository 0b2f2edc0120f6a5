#pragma once

#include <cstddef>

namespace irsg {

/// Reflectivity of the flat face of a body of refractive index n and extinction k (n + i k) in air,
/// mean over both polarisations, at a cosine of incidence from 0 to 1: Fresnel's equations. `n` is
/// positive, `k` at least 0.
double fresnelReflectivity(double n, double k, double cosine);
/// The same at normal incidence.
double normalReflectivity(double n, double k);

/// Fresnel's reflectivity over angle in three shapes that know no wavelength,
///   F(c) = F0 (1 - p) + F90 p + a q, p = (1 - c)^5 (Schlick 1994), q = c (1 - c)^6 (Lazanyi and
/// Szirmay-Kalos 2005), with a of least squares over the cosine c, F0 exact and F90 = 1.
struct FresnelShapes {
    static double schlick(double cosine);
    static double dip(double cosine);
    /// Added to the dip, times F0, and taken off what F0 sends beside it, so that amounts of all
    /// bodies, and what emissivity takes off them, are positive.
    static constexpr double raisedDip = 8.0;
    /// The three that amounts F0, F90 and raisedDip F0 + a belong to: 1 - p - raisedDip q, p and q;
    /// without the dip 1 - p, p and 0.
    static double part(std::size_t k, double cosine, bool hasDip);
    /// a, negative for metals.
    static double dipOf(double n, double k);
    /// Means over the hemisphere, with the cosine as weight: 1/21 and 1/126.
    static constexpr double meanSchlick = 1.0 / 21.0;
    static constexpr double meanDip = 1.0 / 126.0;
};

} // namespace irsg

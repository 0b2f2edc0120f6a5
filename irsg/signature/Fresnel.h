#pragma once

#include <array>
#include <cstddef>

namespace irsg {

/// Reflectivity of the flat face of a body of refractive index n and extinction k (n + i k) in air,
/// mean over both polarisations, at a cosine of incidence from 0 to 1: Fresnel's equations. `n` is
/// positive, `k` at least 0.
double fresnelReflectivity(double n, double k, double cosine);
/// The same at normal incidence.
double normalReflectivity(double n, double k);

/// Fresnel's reflectivity over angle in shapes that know no wavelength: cubic B-splines in
/// (1 - c)^3 of the cosine c, which add up to 1. Their amounts are control values of the curve: the
/// first is the reflectivity at normal incidence, the last that along the surface, 1; those between
/// follow from least squares of the relative difference. All are positive. Up to 80 degrees the
/// curve is within 0.8 % of Fresnel's for dielectrics and metals (SurfaceModelTest).
class FresnelShapes {
  public:
    static constexpr std::size_t count = 6;
    using Values = std::array<double, count>;
    static Values at(double cosine);
    static Values amountsOf(double n, double k);
    /// Means over the hemisphere, with the cosine as weight.
    static const Values& means();

    /// The shape of materials of which the reflectivity at normal incidence alone is known,
    /// (1 - c)^5 (Schlick 1994), whose mean over the hemisphere is 1/21.
    static double schlick(double cosine);
    static constexpr double meanSchlick = 1.0 / 21.0;
};

} // namespace irsg

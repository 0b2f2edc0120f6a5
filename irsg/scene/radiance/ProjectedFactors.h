#pragma once

#include <compare>
#include <map>
#include <utility>
#include <vector>

#include "irsg/scene/model/Model.h"

namespace irsg {

/// What a sample of a surface is, radiometrically: the codes that fix its spectra and the
/// transparent materials in front of it, because the integral of a product of transmissivities does
/// not factor.
struct FactorKey {
    int entity = 0;
    IrCodes codes;
    /// (entity, material) of transparent surfaces in front, sorted, repeated as often as they
    /// occur.
    std::vector<std::pair<int, int>> inFront;

    auto operator<=>(const FactorKey&) const = default;
};

/// Sums over samples of solid angle times factor, sr.
struct FactorSums {
    double coverage_sr = 0.0; ///< solid angle alone
    double thermal_sr = 0.0;  ///< times |cos theta_view|^N
    double up_sr = 0.0;       ///< times the weight of the lower hemisphere
    double down_sr = 0.0;     ///< times the weight of the upper hemisphere
    double sun_sr = 0.0;      ///< times cos theta_sun where the seen side is lit
    /// The same with cos(off-axis) inside, for the irradiance on the detector plane.
    double coverageCos_sr = 0.0, thermalCos_sr = 0.0, upCos_sr = 0.0, downCos_sr = 0.0,
           sunCos_sr = 0.0;
    double pixels = 0.0; ///< coverage as a number of pixels
    /// Coverage times the in-band radiance of a background that varies over the frame, without and
    /// with cos(off-axis); 0 where the background is uniform.
    double background_W_m2 = 0.0, backgroundCos_W_m2 = 0.0;
};

/// Geometry once, physics many times: given this table, another band, wavelength, temperature, time
/// or scaling is a dot product, without drawing.
struct ProjectedFactors {
    std::map<FactorKey, FactorSums> sums;
    int layersLeftOver = 0;
};

} // namespace irsg

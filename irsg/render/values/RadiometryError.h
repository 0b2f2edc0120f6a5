#pragma once

#include <cmath>

namespace irsg {

/// The error of a number by its causes, each in the unit of the number and at two standard
/// deviations: the truth lies within it 19 times out of 20 (docs/errors.md). Causes do not know of
/// each other, so that their squares add.
struct ErrorParts {
    double sampling = 0.0;   ///< samples of pixels, windows and distances
    double air = 0.0;        ///< spectral grid or quadrature points, and slices of range
    double background = 0.0; ///< lines of sight of the background
    double exchange = 0.0;   ///< nodes and rays of inter-reflection

    double sum() const { return std::hypot(withoutExchange(), exchange); }
    double withoutExchange() const { return std::hypot(sampling, air, background); }
    ErrorParts times(double factor) const {
        return {factor * sampling, factor * air, factor * background, factor * exchange};
    }
};

/// Of the sums over an object.
struct RadiometryErrors {
    ErrorParts intensity_W_sr, contrastIntensity_W_sr, irradiance_W_m2;
};

} // namespace irsg

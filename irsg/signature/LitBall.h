#pragma once

#include <vector>

#include "irsg/radiometry/Spectrum.h"
#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// A ball of a material outdoors, to be looked at: in-band radiance of a square picture, row by row
/// from the top, W m-2 sr-1, NaN beside the ball. It has 300 K, the sun (5778 K, 70 % of it through
/// the air) stands behind the left shoulder of who looks, 45 deg high; above is a clear sky, a
/// black body of 230 K at the zenith and 285 K at the horizon, below ground of 295 K. Reflected
/// once, by the model that scenes use; transparent materials show the horizon behind them.
struct LitBall {
    int size_px = 0;
    std::vector<double> radiance_W_m2_sr;

    double at(int row, int column) const {
        return radiance_W_m2_sr[static_cast<std::size_t>(row * size_px + column)];
    }
    static constexpr double temperature_K = 300.0;
};

/// `size_px` at least 1. Throws InputError where the material's model cannot be made.
LitBall litBall(const Material& material, const SpectralRange& band, int size_px);

/// Mean over the band of reflectance at a cosine to the normal.
double bandReflectance(const Material& material, double cosine, const SpectralRange& band);

} // namespace irsg

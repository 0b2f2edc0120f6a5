#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "irsg/atmosphere/engine/Particles.h"

/// What the tests of aerosols share.
namespace irsg::aerosoltest {

inline double dry(double) {
    return 0.0;
}

/// Levels of 0, 1 and 2 km of three LOWTRAN atmospheres: at the ground as LOWTRAN prints it, above
/// over water by Magnus' formula from its temperatures and water.
inline HumidityProfile humidityOf(const std::string& atmosphere) {
    std::array<double, 3> levels = {0.4589, 0.4907, 0.5200};
    if (atmosphere == "tropical") {
        levels = {0.7563, 0.7298, 0.7469};
    }
    if (atmosphere == "mlw") {
        levels = {0.7713, 0.7047, 0.6540};
    }
    return [levels](double altitude_m) {
        return levels.at(static_cast<std::size_t>(altitude_m / 1000.0));
    };
}

inline ParticleSettings settings(AerosolModel model, double visibility_m = 0.0) {
    ParticleSettings result;
    result.aerosol = model;
    result.visibility_m = visibility_m;
    return result;
}

inline double extinction550At(const std::vector<ParticleLayer>& layers, double altitude_m) {
    double sum = 0.0;
    for (const ParticleLayer& layer : layers) {
        sum += layer.extinction550At(altitude_m);
    }
    return sum;
}

/// Extinction and absorption at one wavelength, m-1.
inline ParticleOptics at(const std::vector<ParticleLayer>& layers, double altitude_m,
                         double wavelength_um) {
    ParticleOptics sum{0.0, 0.0, 0.0};
    for (const ParticleLayer& layer : layers) {
        const ParticleOptics optics = layer.opticsAt(wavelength_um);
        sum.extinction += layer.extinction550At(altitude_m) * optics.extinction;
        sum.absorption += layer.extinction550At(altitude_m) * optics.absorption;
    }
    return sum;
}

/// Vertical optical depth between two altitudes, in steps of 10 m.
inline ParticleOptics depth(const std::vector<ParticleLayer>& layers, double from_m, double to_m,
                            double wavelength_um) {
    ParticleOptics sum{0.0, 0.0, 0.0};
    const double step_m = 10.0;
    for (double z = from_m + 0.5 * step_m; z < to_m; z += step_m) {
        const ParticleOptics here = at(layers, z, wavelength_um);
        sum.extinction += step_m * here.extinction;
        sum.absorption += step_m * here.absorption;
    }
    return sum;
}

} // namespace irsg::aerosoltest

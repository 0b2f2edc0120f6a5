#pragma once

#include <cstddef>
#include <vector>

namespace irsg {

/// Layers of many independent columns of air, solved side by side: values run over the columns
/// fastest, layers and levels count from the ground up (layer i lies between levels i and i + 1).
struct TwoStreamLayers {
    std::size_t layers = 0;
    std::size_t columns = 0;
    std::vector<double> opticalDepth;  ///< [layer][column], >= 0, after delta scaling
    std::vector<double> albedo;        ///< of single scattering, 0 to 1, after delta scaling
    std::vector<double> asymmetry;     ///< after delta scaling: g / (1 + g), at most 0.5
    std::vector<double> surfaceAlbedo; ///< [column], 0 to 1

    TwoStreamLayers() = default;
    TwoStreamLayers(std::size_t layerCount, std::size_t columnCount);
};

/// Fluxes through a horizontal plane at the levels, [level][column]; the beam is not in them.
struct TwoStreamFluxes {
    std::vector<double> up;
    std::vector<double> down;
};

/// Emission of the air, the ground and of what lies above the air.
struct ThermalSource {
    std::vector<double> planck;        ///< [level][column], radiance of a black body at the level
    std::vector<double> surfacePlanck; ///< [column], of the ground, which emits 1 - albedo of it
    std::vector<double> topPlanck;     ///< [column], from above; empty: 0, space
};

/// The sun, attenuated along its own path, delta scaled as the layers are.
struct SolarBeam {
    std::vector<double> irradiance; ///< [level][column], normal to the beam
    std::vector<double> slant;      ///< [layer][column], path over vertical optical depth, >= 1
    double sinElevation = 1.0;      ///< 0 to 1, for scattering angles and the flux on the ground
};

/// Two-stream fluxes in the equations of Toon et al. 1989 (J. Geophys. Res. 94, 16287; the general
/// form is Meador and Weaver 1980, J. Atmos. Sci. 37, 630):
/// dF+/dt = g1 F+ - g2 F- - Q+, dF-/dt = g2 F+ - g1 F- + Q-, with
/// g1 = D (1 - w (1 + g) / 2), g2 = D w (1 - g) / 2.
/// Each layer is solved exactly, for thermal emission that is linear in optical depth or for a
/// beam, and layers are joined by adding. The forms used here lose no digits for w to 0 or 1,
/// optical depths of 0 to 1e6, and where the beam falls off as the diffuse light does (k mu0 = 1).
///
/// Thermal: diffusivity D = 1.66 (Elsasser), so that pure absorption transmits exp(-1.66 t). An
/// isothermal enclosure holds F+ = F- = pi B exactly.
TwoStreamFluxes thermalFluxes(const TwoStreamLayers& layers, const ThermalSource& source);

/// Solar: the quadrature scheme, D = sqrt(3), Q+ = w (1 - sqrt(3) g mu0) / 2 E and
/// Q- = w (1 + sqrt(3) g mu0) / 2 E. Single scattering albedos are clamped to 1 - 1e-12.
TwoStreamFluxes solarFluxes(const TwoStreamLayers& layers, const SolarBeam& beam);

} // namespace irsg

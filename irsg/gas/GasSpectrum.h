#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "irsg/gas/GasLayer.h"
#include "irsg/gas/GasOptics.h"
#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// What is asked of layers of gas.
struct GasRequest {
    std::vector<GasLayer> layers; ///< in order from the sensor
    SpectralRange band;           ///< um, within 1 to 200
    double step_per_cm = 5.0;     ///< 1 to 100
    GasSource source = GasSource::automatic;
    /// Of a black body behind the layers, 1 to 3000 K; none: nothing radiates there.
    std::optional<double> background_K = {};
};

/// What is wrong with a request: "layer 2" with the key of gasLayerDiagnostics, "layers", "band",
/// "step", "background".
std::vector<Diagnostic> gasRequestDiagnostics(const GasRequest& request);

/// What emits in layers: the gases, then soot.
inline constexpr std::size_t gasEmitterCount = hotGasCount + 1;
/// "CO2", ..., "soot".
std::string gasEmitterName(std::size_t emitter);

/// Spectrum of layers of gas at the sensor side of the first one.
struct GasSpectrum {
    /// A mean over `step` around a whole multiple of it, cut at the ends of the band.
    struct Cell {
        double wavenumber_per_cm = 0.0; ///< the middle: the multiple, where it is not cut
        double lower_per_cm = 0.0, upper_per_cm = 0.0;
        double radiance_W_m2_sr_um = 0.0; ///< of layers and background
        double transmittance = 1.0;
        double error_W_m2_sr_um = 0.0; ///< stated, of the radiance
        /// Radiance less that of the same layers without the emitter: below 0 where it hides more
        /// than it emits.
        std::array<double, gasEmitterCount> added_W_m2_sr_um{};
    };
    std::vector<Cell> cells; ///< ascending wavenumbers
    GasAnswers answers;      ///< who answered, for every gas that is there

    /// Integrals over the band, W m-2 sr-1.
    double bandRadiance_W_m2_sr() const;
    double bandAdded_W_m2_sr(std::size_t emitter) const;
    /// Stated error of the band radiance.
    double bandError_W_m2_sr() const;
    /// Mean over wavelength.
    double bandTransmittance() const;
};

/// Emission of each layer through those before it: L = sum over i of B(T_i) (tau_(i-1) - tau_i),
/// with tau_i the transmittance of the first i layers together (NASA SP-3080; NIST TN 1402), whose
/// lines are summed by Curtis and Godson; gases and soot multiply. No sum of layers absorbs less
/// than a part of them. Scattering is left out.
///
/// Throws InputError with every diagnostic of layers and request, and for tables that are missing.
GasSpectrum gasSpectrum(const GasRequest& request);

} // namespace irsg

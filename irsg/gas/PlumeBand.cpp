#include "irsg/gas/PlumeBand.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

PlumeBand::PlumeBand(const SpectralRange& band) {
    constexpr double finest_per_cm = 5.0, coarsest_per_cm = 20.0, about = 30.0;
    const double lower = wavenumberFromWavelength_per_cm(band.max_um);
    const double upper = wavenumberFromWavelength_per_cm(band.min_um);
    const double step_per_cm = std::clamp((upper - lower) / about, finest_per_cm, coarsest_per_cm);
    const auto cells = static_cast<int>(std::ceil((upper - lower) / step_per_cm));
    for (int i = 0; i < cells; ++i) {
        const double from = lower + (upper - lower) * i / cells,
                     to = lower + (upper - lower) * (i + 1) / cells;
        wavenumbers_per_cm.push_back(0.5 * (from + to));
        widths_um.push_back(wavelengthFromWavenumber_um(from) - wavelengthFromWavenumber_um(to));
    }
}

BandSenders::BandSenders(const std::vector<GasLayer>& gases, const PlumeBand& band)
    : columns_(gases, band.wavenumbers_per_cm) {
    for (std::size_t i = 0; i < band.wavenumbers_per_cm.size(); ++i)
        for (const GasLayer& gas : gases)
            radiances_.push_back(
                band.widths_um[i] *
                planckRadiance_W_m2_sr_um(wavelengthFromWavenumber_um(band.wavenumbers_per_cm[i]),
                                          gas.temperature_K));
}

} // namespace irsg

#pragma once

#include <vector>

#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// Cells of a band in which zones and the plume that they stand for are summed alike: about 30, at
/// most as fine as the tables of gases.
struct PlumeBand {
    explicit PlumeBand(const SpectralRange& band);

    std::vector<double> wavenumbers_per_cm; ///< of their middles
    std::vector<double> widths_um;
};

} // namespace irsg

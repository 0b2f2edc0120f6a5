#pragma once

#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"
#include "irsg/gas/GasSpectrum.h"

namespace irsg {

/// How lines of the gas and lines of the air before it coincide in one cell.
struct LineCorrelation {
    /// Mean of (transmittance of the air times radiance of the gas) over the product of both means;
    /// 1 where nothing is known.
    double radiance = 1.0;
    double transmittance = 1.0; ///< the same of both transmittances
};

/// For each cell of a spectrum of `request`, line by line at wavenumbers 0.2 cm-1 apart, of both
/// the layers and `length_m` of uniform air before them: CO2, H2O and CO from 830 to 1300 and 1900
/// to 4200 cm-1, 1 elsewhere. Pressures of 100 to 1100 hPa and temperatures of 250 to 2000 K are
/// followed, beyond them the ends are taken. Other gases of the air and its continuum have no
/// structure in common with the gas. Throws InputError where the table of samples is missing.
std::vector<LineCorrelation> lineCorrelations(const GasRequest& request,
                                              const std::vector<GasSpectrum::Cell>& cells,
                                              const AtmosphericState& air, double length_m);

} // namespace irsg

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "irsg/atmosphere/engine/AtmosphericState.h"
#include "irsg/gas/GasColumn.h"
#include "irsg/gas/GasSpectrum.h"

namespace irsg {

/// How lines of the gas and lines of the air before it coincide in one cell.
struct LineCorrelation {
    /// Mean of (transmittance of the air times radiance of the gas) over the product of both means;
    /// 1 where nothing is known.
    double radiance = 1.0;
    double transmittance = 1.0; ///< the same of both transmittances
};

/// Lines of sight through several uniform gases line by line, as lineCorrelations() has it, with no
/// air before them: what does not depend on lengths is computed once.
class GasColumnsLineByLine {
  public:
    /// Cells as wide as `widths_per_cm` about ascending `wavenumbers_per_cm`; lengths in `gases` do
    /// not count. Throws InputError where the table of samples is missing.
    GasColumnsLineByLine(const std::vector<GasLayer>& gases,
                         const std::vector<double>& wavenumbers_per_cm,
                         const std::vector<double>& widths_per_cm);

    /// By sample.
    struct Column {
        std::vector<double> radiance, transmittance;
    };
    /// Of a line of sight whose stretches stand in order from the sensor, and whose first ones do
    /// not emit. `background_K`: of a black body behind it; 0 for none.
    Column of(std::span<const GasStretch> column, std::size_t first = 0,
              double background_K = 0.0) const;
    /// Transmittance of uniform air, by sample.
    std::vector<double> transmittance(const AtmosphericState& air, double length_m) const;
    /// By cell, of a column behind air of these transmittances.
    std::vector<LineCorrelation> correlations(const Column& column,
                                              const std::vector<double>& air) const;

  private:
    struct Cell {
        std::size_t first = 0, count = 0; ///< samples; few are none
    };
    std::vector<std::uint32_t> nodes_;            ///< of the table, by sample
    std::vector<double> wavelengths_um_;          ///< of samples
    std::vector<std::vector<double>> absorption_; ///< by gas and sample, m-1
    std::vector<std::vector<double>> planck_;     ///< likewise, W m-2 sr-1 um-1
    std::vector<Cell> cells_;
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

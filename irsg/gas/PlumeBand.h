#pragma once

#include <span>
#include <vector>

#include "irsg/gas/GasColumn.h"
#include "irsg/radiometry/Spectrum.h"

namespace irsg {

/// Cells of a band in which zones and the plume that they stand for are summed alike: about 30, at
/// most as fine as the tables of gases.
struct PlumeBand {
    explicit PlumeBand(const SpectralRange& band);

    std::vector<double> wavenumbers_per_cm; ///< of their middles
    std::vector<double> widths_um;
};

/// What uniform gases send over a band, by lines of sight through them.
class BandSenders {
  public:
    BandSenders(const std::vector<GasLayer>& gases, const PlumeBand& band);
    double radiance_W_m2_sr(std::span<const GasStretch> column) const {
        return columns_.weighted(column, radiances_);
    }

  private:
    GasColumns columns_;
    std::vector<double> radiances_; ///< by wavenumber and gas
};

} // namespace irsg

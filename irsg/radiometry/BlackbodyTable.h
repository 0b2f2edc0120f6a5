#pragma once

#include <vector>

#include "irsg/radiometry/Band.h"

namespace irsg {

/// In-band radiance of black bodies on the report's grid, 200 to 2200 K in steps of 12.5 K (161
/// nodes, report section 5), interpolated as ln L against 1/T: at most 0.07 % wrong at mid nodes in
/// 3-5, 8-12 and 1.9-2.9 um, where linear interpolation in T is up to 30 % wrong. Outside the grid
/// the band is integrated directly; nothing is ever clamped.
class BlackbodyTable {
  public:
    static constexpr double minimum_K = 200.0;
    static constexpr double maximum_K = 2200.0;
    static constexpr double step_K = 12.5;
    static constexpr int nodes = 161;

    explicit BlackbodyTable(Band band);

    const Band& band() const { return band_; }
    /// W m-2 sr-1.
    double radiance_W_m2_sr(double temperature_K) const;
    /// The report's own straight line between nodes, kept to show its error. Outside: integrated.
    double radianceLinearInTemperature_W_m2_sr(double temperature_K) const;

  private:
    Band band_;
    std::vector<double> radiance_W_m2_sr_;
    std::vector<double> logRadiance_;
};

} // namespace irsg

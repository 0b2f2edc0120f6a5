#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace irsg {

/// Directions in which the air's radiance is asked for what lobes reflect of it: rows of elevation,
/// one close to either side of the horizon, and where air answers by azimuth, columns of the angle
/// from the sun's azimuth, 0 to pi. Radiance is linear between columns, and between rows in
/// ln(1 + x / 0.02) above the horizon and ln(1 + sqrt(x / 0.02)) below, x the angle from it in rad.
class SpecularEnvironmentGrid {
  public:
    SpecularEnvironmentGrid() = default; ///< none
    SpecularEnvironmentGrid(double horizon_rad, bool byAzimuth);

    struct Direction {
        double elevation_rad = 0.0, fromSun_rad = 0.0;
    };
    const std::vector<Direction>& places() const { return places_; }
    bool empty() const { return places_.empty(); }
    bool isByAzimuth() const { return columns_ > 1; }
    /// The places about a direction and their weights, which add up to 1.
    std::array<std::pair<std::size_t, double>, 4> about(double elevation_rad,
                                                        double fromSun_rad) const;
    /// What it depends on.
    std::array<double, 2> key() const { return {horizon_rad_, static_cast<double>(columns_)}; }

  private:
    double horizon_rad_ = 0.0;
    std::size_t columns_ = 0;
    std::vector<double> sky_, ground_; // coordinates of rows, from the horizon on
    std::vector<Direction> places_;    // row by row: sky, then ground
};

} // namespace irsg

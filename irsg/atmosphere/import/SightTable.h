#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/atmosphere/import/Interpolation.h"
#include "irsg/atmosphere/path/AtmosphericQuery.h"

namespace irsg {

/// Spectra over (altitude, elevation): the background along a line of sight, the direct sun.
///
/// Each altitude has elevations of its own; between them spectra are interpolated linearly in
/// elevation, then linearly in altitude. Exact at the nodes. Altitudes are clamped to the table
/// within 10 m, elevations within 0.01 deg.
class SightTable {
  public:
    static constexpr double altitudeTolerance_m = 10.0;
    static constexpr double elevationTolerance_rad = 1.75e-4;

    /// LogicError for a node that is there twice or has another length.
    void add(double altitude_m, double elevation_rad, std::vector<double> values);
    bool holds(double altitude_m, double elevation_rad) const;
    bool isEmpty() const { return rows_.empty(); }

    /// Values at spectral indices first to last - 1. Throws InputError that names `owner`, `what`
    /// ("line of sight") and the table's span for a direction outside the table.
    std::vector<double> at(double altitude_m, double elevation_rad, std::size_t first,
                           std::size_t last, const std::string& owner, const char* what) const;

    /// How far the nearest node is; the table is not empty.
    RunDistance nearest(double altitude_m, double elevation_rad) const;

    /// The lines of sight that are known, and those half way between neighbours in elevation.
    std::vector<LineOfSight> sights() const;

    /// "altitude 0 to 2000 m, elevation -5 to 90 deg (12 directions)".
    std::string span() const;
    /// Leave-one-out errors over elevation and altitude, relative to the largest value of the
    /// spectrum, of the axes that have more than one node.
    std::vector<InterpolationError> errors(const std::string& quantity) const;

  private:
    struct Row {
        double altitude_m = 0.0;
        std::vector<double> elevations_rad; ///< ascending
        std::vector<std::vector<double>> values;
    };

    bool blend(double altitude_m, double elevation_rad, const Row* withoutRow, std::size_t first,
               std::size_t last, std::vector<double>& out) const;

    std::vector<Row> rows_; ///< ascending
};

} // namespace irsg

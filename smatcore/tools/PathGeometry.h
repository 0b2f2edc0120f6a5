#pragma once

#include <optional>

#include "irsg/atmosphere/path/AtmosphericQuery.h"

namespace smat {

/// What a user says of a line of sight, as far as it was said.
struct PathGeometryInput {
    std::optional<double> sensorAltitude_m = {};
    std::optional<double> losElevation_deg = {}; ///< at the sensor, up positive
    double losAzimuth_deg = 0.0;                 ///< east of north
    std::optional<double> targetAltitude_m = {};
    std::optional<double> range_m = {};
    bool toSpace = false; ///< in place of target altitude and range
};

/// What that fixes; each part is there where the input determines it.
struct PathGeometry {
    std::optional<irsg::AtmosphericPath> path = {};
    std::optional<irsg::LineOfSight> sight = {};
    std::optional<double> targetAltitude_m = {};
};

/// Where a path to space ends: the top of the model atmospheres.
inline constexpr double spaceAltitude_m = 100e3;

/// Solves the triangle of earth's centre, sensor and target (radius 6371.23 km, straight lines):
/// r_t^2 = r_s^2 + R^2 + 2 r_s R sin(elevation), from sensor altitude and range with elevation or
/// target altitude. With both, the target altitude makes the path and the elevation the line of
/// sight; they must agree to R^2 / (2 R_earth), by which a flat scene differs, and 0.1 m and a
/// thousandth of the range. A path to space ends at `spaceAltitude_m`.
///
/// Throws InputError with every diagnostic: altitudes below ground, angles and distances out of
/// range, contradictions, a range too short for the altitudes, a line of sight that meets the
/// ground before its end.
PathGeometry solveGeometry(const PathGeometryInput& input);

} // namespace smat

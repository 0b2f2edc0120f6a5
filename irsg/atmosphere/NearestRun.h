#pragma once

#include <string>
#include <vector>

#include "irsg/atmosphere/path/AtmosphericQuery.h"

namespace irsg {

/// How far a query is from the nearest run of the family that answers it: the larger of the two
/// differences of altitude, that of range, that of elevation.
struct RunDistance {
    double altitude_m = 0.0;
    double range_m = 0.0;
    double elevation_deg = 0.0;

    /// One number to compare by: metres, of which 100 count as much as a degree.
    double sum() const { return altitude_m + range_m + 100.0 * elevation_deg; }
};

/// Air that is known at some runs and interpolated between them.
class RunFamily {
  public:
    virtual ~RunFamily() = default;
    /// How far a query that it answers is from the nearest run, as nearestRunText; empty where
    /// the answer is known without a run.
    virtual std::string nearestRun(const AtmosphericQuery& query) const = 0;
};

/// What follows the name of the atmosphere: " (nearest run at most 0 m in altitude, 250 m in range
/// away)".
std::string nearestRunText(const RunDistance& distance);
/// A line without that.
std::string withoutNearestRun(std::string line);

/// Adds who answered ("transmittance: family.smatatm (nearest run ...)") where it is new. Of lines
/// that differ in the distance alone one remains, which has the larger distances: a sweep tells
/// how far its farthest cases are.
void addProvider(std::vector<std::string>& lines, std::string line);
void addProvider(std::vector<std::string>& lines, const std::vector<std::string>& more);

} // namespace irsg

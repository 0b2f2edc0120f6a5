#pragma once

#include <string>

#include "irsg/atmosphere/Environment.h"
#include "smatcore/data/ResultTable.h"

namespace smat {

/// Altitudes min, min + step, ... up to max, m.
struct TemperatureProfileRequest {
    double min_m = 0.0;
    double max_m = 30e3;
    double step_m = 100.0;
    std::string commandLine = {}; ///< goes into the provenance where it is not empty
};

/// The most altitudes a temperature profile has.
inline constexpr int maximumProfileRows = 1'000'000;

/// Air temperature over altitude (F47): columns `altitude [m]` and `temperature [K]`, as the first
/// atmosphere that has one answers. The environment's default ambient temperature is no property of
/// the air and is not used.
///
/// Throws InputError naming every diagnostic: altitudes below ground or not finite, a largest
/// altitude below the least, a step of 0 or less, too many rows, air without a temperature.
ResultTable temperatureProfile(const irsg::Environment& environment,
                               const TemperatureProfileRequest& request);

} // namespace smat

#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "smatcore/analysis/DetectionRequest.h"

namespace smat {

/// What a caller gave of a detection, beside what its request says.
struct GivenOptions {
    /// How the caller names an option: "--false-alarms", "false_alarms".
    std::function<std::string(const std::string& option)> nameOf;
    /// Values by option of the command without its dashes ("false-alarms"), or by key of a setting
    /// ("sensor.band").
    std::map<std::string, std::string> values = {};

    bool has(const std::string& option) const { return values.contains(option); }
};

/// The keys of settings of the cases that do nothing for a detection, in whose place are the sensor
/// and the search.
std::vector<std::string> idleSettings(const DetectionRequest& request);

/// Throws InputError with a diagnostic for each option that was given and does nothing beside the
/// others, for each that is missing, and for ranges, clutter and limits that cannot be.
void checkDetection(const DetectionRequest& request, const GivenOptions& given);

} // namespace smat

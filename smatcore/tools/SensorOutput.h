#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "irsg/sensor/ResolvableTemperature.h"
#include "irsg/sensor/SensorDescription.h"
#include "irsg/sensor/TargetingTask.h"
#include "smatcore/data/ResultTable.h"

namespace smat {

/// What is asked of the numbers of a sensor.
struct SensorNumbersRequest {
    double background_K = 300.0;          ///< > 0
    double temperatureDifference_K = 0.0; ///< of an area, for its signal to noise ratio; 0: none
    double pointIrradiance_W_m2 = 0.0;    ///< of a point, the same
};

/// The numbers of a sensor as `smat-batch sensor info --json` prints them, with each convention in
/// words. Throws InputError.
nlohmann::ordered_json sensorNumbersJson(const irsg::SensorDescription& sensor,
                                         const SensorNumbersRequest& request);
/// The same for people.
std::string sensorNumbersText(const nlohmann::ordered_json& numbers);

/// The transfer function of a sensor at frequencies >= 0: `frequency [cycles rad-1]`, a column for
/// each component, and `system`, their product. Throws InputError for a frequency that is none.
ResultTable sensorTransferTable(const irsg::SensorDescription& sensor,
                                const std::vector<double>& frequencies_per_rad, bool isVertical,
                                double source_K);

/// The minimum resolvable temperature difference before a background, at frequencies >= 0:
/// `frequency [cycles rad-1]`, `mrtd_horizontal`, `mrtd_vertical` and `mrtd` (of both directions,
/// at the geometric mean of their frequencies) in K, NaN where bars are not resolved. Throws
/// InputError.
ResultTable resolvableTemperatureTable(const irsg::SensorDescription& sensor,
                                       const std::vector<double>& frequencies_per_rad,
                                       double background_K, const irsg::Observer& observer);

/// Nominal static ranges as STANAG 4347 defines them (irsg::nominalRange_m), a row for each task
/// (irsg::nominalTasks) and extinction: `line_pairs`, `extinction [km-1]`, `range [m]`. Throws
/// InputError.
ResultTable nominalRangeTable(const irsg::SensorDescription& sensor,
                              const std::vector<double>& extinctions_per_km,
                              const irsg::NominalTarget& target, double background_K,
                              const irsg::Observer& observer);

} // namespace smat

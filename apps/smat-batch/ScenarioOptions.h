#pragma once

#include "apps/smat-batch/SettingOptions.h"
#include "smatcore/simulate/Scenario.h"

namespace smat::batch {

/// What was given for all sensors of a scenario. Throws InputError for settings that are none of a
/// scenario (isScenarioSetting).
Settings scenarioOverrides(const SettingOptions& options);

/// Reads a scenario; warns on standard error of former names of settings in it. Throws InputError.
Scenario openScenario(const std::string& file);

} // namespace smat::batch

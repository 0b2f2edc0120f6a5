#pragma once

#include "apps/smat-batch/SettingOptions.h"

namespace smat::batch {

/// What was given for all sensors of a scenario. Throws InputError for settings that are none of a
/// scenario (isScenarioSetting).
Settings scenarioOverrides(const SettingOptions& options);

} // namespace smat::batch

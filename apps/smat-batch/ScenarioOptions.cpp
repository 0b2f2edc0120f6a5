#include "apps/smat-batch/ScenarioOptions.h"

#include "irsg/core/Errors.h"
#include "smatcore/simulate/Scenario.h"

namespace smat::batch {

Settings scenarioOverrides(const SettingOptions& options) {
    const Settings given = options.values();
    std::vector<irsg::Diagnostic> diagnostics;
    for (const auto& [key, text] : given.values()) {
        if (!isScenarioSetting(settingInfo(key))) {
            diagnostics.push_back({.file = "--set",
                                   .position = key,
                                   .value = text,
                                   .expected = "a setting of sensor, scaling, environment, render, "
                                               "display or image: the scenario says the rest"});
        }
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return given;
}

} // namespace smat::batch

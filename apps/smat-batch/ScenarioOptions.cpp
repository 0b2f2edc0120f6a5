#include "apps/smat-batch/ScenarioOptions.h"

#include "apps/smat-batch/Output.h"
#include "irsg/core/Errors.h"
#include "smatcore/simulate/ScenarioFile.h"

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

Scenario openScenario(const std::string& file) {
    std::vector<std::string> remarks;
    Scenario scenario = loadScenario(file, &remarks);
    for (const std::string& remark : remarks)
        warn(file + ": " + remark);
    return scenario;
}

} // namespace smat::batch

#include <cmath>

#include <fmt/format.h>

#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace key {
constexpr RealKey timeFrom{"time.from"};
constexpr RealKey timeTo{"time.to"};
constexpr RealKey timeStep{"time.step"};
} // namespace key

namespace {

std::vector<SettingInfo> timeSettings() {
    using namespace rows;
    return {
        number(key::timeFrom, "--from", "From", "s", -1e9, 1e9, "0", "First time."),
        number(key::timeTo, "--to", "To", "s", -1e9, 1e9, "10",
               "Where the times end: the last case is the last step at or before it."),
        number(key::timeStep, "--step", "Step", "s", 1e-6, 1e9, "0.1", "Time between two cases."),
    };
}

void planTime(AnalysisPlan& plan, const Project&, const Settings& settings,
              std::vector<irsg::Diagnostic>& diagnostics) {
    const double from_s = settings[key::timeFrom];
    const double to_s = settings[key::timeTo];
    const double step_s = settings[key::timeStep];
    plan.coordinate = irsg::Quantity::time;
    if (to_s <= from_s) {
        diagnostics.push_back({.file = "",
                               .position = key::timeTo,
                               .value = settings.text(key::timeTo),
                               .expected = "a number above time.from, which is " +
                                           settings.text(key::timeFrom) + " s"});
        return;
    }
    const double count = std::floor((to_s - from_s) / step_s + 1e-9) + 1.0;
    if (count > mostCases) {
        diagnostics.push_back(
            {.file = "",
             .position = key::timeStep,
             .value = settings.text(key::timeStep),
             .expected = fmt::format("at most {:.0f} cases, not {:.0f}", mostCases, count)});
        return;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        AnalysisCase one = startingCase(settings);
        one.time_s = stepped(from_s, i, step_s);
        one.coordinate = one.time_s;
        plan.cases.push_back(one);
    }
}

std::vector<std::string> ignoredByTime(const Settings&) {
    return {key::stateTime};
}

} // namespace

extern constinit const AnalysisDefinition timeAnalysis{.name = "time",
                                                       .title = "Time plot",
                                                       .help = "Intensity over time",
                                                       .icon = "time",
                                                       .settings = timeSettings,
                                                       .plan = planTime,
                                                       .ignored = ignoredByTime};

} // namespace smat

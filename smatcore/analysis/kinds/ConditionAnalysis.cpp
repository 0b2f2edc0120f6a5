#include <optional>

#include "irsg/core/Interpolation.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace key {
constexpr TextKey conditionOver{"condition.over"};
constexpr RealKey conditionFrom{"condition.from"};
constexpr RealKey conditionTo{"condition.to"};
constexpr IntegerKey conditionPoints{"condition.points"};
} // namespace key

namespace {

std::vector<SettingInfo> conditionSettings() {
    using namespace rows;
    return {
        choice(key::conditionOver, "--over", "Over", {"power", "mach", "altitude"}, "mach",
               "What changes from case to case: engine power, Mach number, or the altitude of the "
               "target in m. The camera keeps its range, azimuth and elevation about the target, "
               "and all else stays as the settings say."),
        number(key::conditionFrom, "--from", "From", "", 0, 1e6, "0",
               "First value, in the unit of what changes."),
        number(key::conditionTo, "--to", "To", "", 0, 1e6, "1", "Last value."),
        integer(key::conditionPoints, "--points", "Points", "", 2, 100000, "21",
                "Number of values, both ends included."),
        flag(key::conditionLog, "--log", "Logarithmic", false,
             "Spaces the values by equal ratios."),
    };
}

/// What a condition changes: the setting that it stands in for, and its place in a case.
struct SweptCondition {
    irsg::Quantity quantity;
    RealKey setting;
    std::optional<double> AnalysisCase::*value;
};
SweptCondition conditionNamed(const std::string& name) {
    if (name == "power")
        return {irsg::Quantity::power, key::statePower, &AnalysisCase::power};
    if (name == "mach")
        return {irsg::Quantity::mach, key::stateMach, &AnalysisCase::mach};
    return {irsg::Quantity::altitude, key::targetAltitude, &AnalysisCase::altitude_m};
}

void planCondition(AnalysisPlan& plan, const Project&, const Settings& settings,
                   std::vector<irsg::Diagnostic>& diagnostics) {
    const SweptCondition condition = conditionNamed(settings.text(key::conditionOver));
    const double from = settings[key::conditionFrom], to = settings[key::conditionTo];
    const int points = settings[key::conditionPoints];
    const bool isLogarithmic = settings[key::conditionLog];
    plan.coordinate = condition.quantity;
    const SettingInfo& limits = settingInfo(condition.setting);
    for (const RealKey end : {key::conditionFrom, key::conditionTo}) {
        if (!canonicalText(limits, settings.text(end))) {
            diagnostics.push_back(
                {.file = "",
                 .position = end,
                 .value = settings.text(end),
                 .expected = limits.expected() + ", as " + limits.key + " wants it"});
        }
    }
    if (to <= from) {
        diagnostics.push_back({.file = "",
                               .position = key::conditionTo,
                               .value = settings.text(key::conditionTo),
                               .expected = "a number above " + std::string(key::conditionFrom) +
                                           ", which is " + settings.text(key::conditionFrom)});
    }
    if (isLogarithmic && from <= 0.0) {
        diagnostics.push_back({.file = "",
                               .position = key::conditionFrom,
                               .value = settings.text(key::conditionFrom),
                               .expected = "a number above 0, because " +
                                           std::string(key::conditionLog) + " is true"});
    }
    if (!diagnostics.empty())
        return;
    const double step = (to - from) / (points - 1);
    for (int i = 0; i < points; ++i) {
        AnalysisCase one = startingCase(settings);
        one.coordinate = i == points - 1 ? to
                         : isLogarithmic ? irsg::lerpByRatio(from, to, i / (points - 1.0))
                                         : stepped(from, static_cast<std::size_t>(i), step);
        one.*condition.value = one.coordinate;
        plan.cases.push_back(one);
    }
}

std::vector<std::string> ignoredByCondition(const Settings& settings) {
    return {conditionNamed(settings.text(key::conditionOver)).setting};
}

} // namespace

extern constinit const AnalysisDefinition conditionAnalysis{
    .name = "condition",
    .title = "Flight condition",
    .help = "Intensity over engine power, Mach number or altitude",
    .icon = "condition",
    .settings = conditionSettings,
    .plan = planCondition,
    .ignored = ignoredByCondition};

} // namespace smat

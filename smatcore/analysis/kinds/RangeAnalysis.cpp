#include <cmath>

#include "irsg/core/Interpolation.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace key {
constexpr RealKey rangeFrom{"range.from"};
constexpr RealKey rangeTo{"range.to"};
constexpr OptionalRealKey rangePoints{"range.points"};
constexpr TextKey rangeSteps{"range.steps"};
} // namespace key

namespace {

std::vector<SettingInfo> rangeSettings() {
    using namespace rows;
    return {
        number(key::rangeFrom, "--from", "From", "m", 0, 1e8, "500", "First range."),
        number(key::rangeTo, "--to", "To", "m", 0, 1e8, "10000", "Last range."),
        choiceOrNumber(key::rangePoints, "--points", "Points", "", {"auto"}, 2, 100000, "auto",
                       "Number of ranges, both ends included, of adaptive steps the first ones. "
                       "auto: 50 of adaptive steps, 100 of fixed ones."),
        flag(key::rangeLog, "--log", "Logarithmic", false, "Spaces the ranges by equal ratios."),
        stepsOfPlot(key::rangeSteps, key::rangePoints, "down to 1/1024 of the mean step"),
    };
}

void planRange(AnalysisPlan& plan, const Project&, const Settings& settings,
               std::vector<irsg::Diagnostic>& diagnostics) {
    const double from_m = settings[key::rangeFrom];
    const double to_m = settings[key::rangeTo];
    const bool isRefined = isAdaptivePlot(AnalysisKind::range, settings);
    const double points = settings[key::rangePoints].value_or(isRefined ? 50.0 : 100.0);
    const bool logarithmic = settings[key::rangeLog];
    plan.coordinate = irsg::Quantity::range;
    plan.isAlongRange = true;
    if (to_m <= from_m) {
        diagnostics.push_back({.file = "",
                               .position = key::rangeTo,
                               .value = settings.text(key::rangeTo),
                               .expected = "a number above range.from, which is " +
                                           settings.text(key::rangeFrom) + " m"});
    }
    if (logarithmic && from_m <= 0.0) {
        diagnostics.push_back({.file = "",
                               .position = key::rangeFrom,
                               .value = settings.text(key::rangeFrom),
                               .expected = "a number above 0 m, because range.log is true"});
    }
    if (points != std::floor(points)) {
        diagnostics.push_back({.file = "",
                               .position = key::rangePoints,
                               .value = settings.text(key::rangePoints),
                               .expected = "auto, or a whole number"});
    }
    if (!diagnostics.empty())
        return;
    const double intervals = points - 1.0;
    RefinedAxis axis{irsg::Quantity::range, {}, false, (to_m - from_m) / intervals / 1024.0};
    for (int i = 0; i < static_cast<int>(points); ++i) {
        const double share = i / intervals;
        axis.places.push_back(share == 1.0  ? to_m
                              : logarithmic ? irsg::lerpByRatio(from_m, to_m, share)
                                            : from_m + (to_m - from_m) * share);
    }
    const auto casesAt = [settings](const std::vector<RefinedAxis>& axes) {
        std::vector<AnalysisCase> cases;
        for (const double range_m : axes.front().places) {
            AnalysisCase& one = cases.emplace_back(startingCase(settings));
            one.coordinate = one.range_m = range_m;
        }
        return cases;
    };
    plan.cases = casesAt({axis});
    if (isRefined) {
        plan.refined = {axis};
        plan.casesAt = casesAt;
    }
}

std::vector<std::string> ignoredByRange(const Settings&) {
    return {key::cameraRange};
}

} // namespace

extern constinit const AnalysisDefinition rangeAnalysis{
    .name = "range",
    .title = "Range plot",
    .help = "Contrast intensity and irradiance over range",
    .icon = "range",
    .step = key::rangePoints.name,
    .settings = rangeSettings,
    .plan = planRange,
    .ignored = ignoredByRange};

} // namespace smat

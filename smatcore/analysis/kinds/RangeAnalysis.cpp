#include <cmath>

#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace key {
constexpr RealKey rangeFrom{"range.from"};
constexpr RealKey rangeTo{"range.to"};
constexpr IntegerKey rangePoints{"range.points"};
constexpr BooleanKey rangeLog{"range.log"};
} // namespace key

namespace {

std::vector<SettingInfo> settings() {
    using namespace rows;
    return {
        number(key::rangeFrom, "--from", "From", "m", 0, 1e8, "500", "First range."),
        number(key::rangeTo, "--to", "To", "m", 0, 1e8, "10000", "Last range."),
        integer(key::rangePoints, "--points", "Points", "", 2, 100000, "100",
                "Number of ranges, both ends included."),
        flag(key::rangeLog, "--log", "Logarithmic", false, "Spaces the ranges by equal ratios."),
    };
}

void plan(AnalysisPlan& plan, const Project&, const Settings& settings,
          std::vector<irsg::Diagnostic>& diagnostics) {
    const double from_m = settings[key::rangeFrom];
    const double to_m = settings[key::rangeTo];
    const int points = settings[key::rangePoints];
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
    if (!diagnostics.empty())
        return;
    for (int i = 0; i < points; ++i) {
        const double share = static_cast<double>(i) / (points - 1);
        AnalysisCase one = standingCase(settings);
        one.range_m = logarithmic ? from_m * std::pow(to_m / from_m, share)
                                  : from_m + (to_m - from_m) * share;
        if (i == points - 1)
            one.range_m = to_m;
        one.coordinate = one.range_m;
        plan.cases.push_back(one);
    }
}

std::vector<std::string> ignored(const Settings&) {
    return {key::cameraRange};
}

} // namespace

extern constinit const AnalysisDefinition rangeAnalysis{
    .name = "range",
    .title = "Range plot",
    .help = "Contrast intensity and irradiance over range",
    .icon = "range",
    .settings = settings,
    .plan = plan,
    .ignored = ignored};

} // namespace smat

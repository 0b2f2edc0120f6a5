#include <cmath>

#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/kinds/AnalysisDefinition.h"
#include "smatcore/settings/SettingRows.h"

namespace smat {

namespace {

std::vector<SettingInfo> settings() {
    using namespace rows;
    return {
        number("range.from", "--from", "From", "m", 0, 1e8, "500", "First range."),
        number("range.to", "--to", "To", "m", 0, 1e8, "10000", "Last range."),
        integer("range.points", "--points", "Points", "", 2, 100000, "20",
                "Number of ranges, both ends included."),
        text("range.log", "--log", "Logarithmic", "", SettingKind::boolean, "false",
             "Spaces the ranges by equal ratios."),
    };
}

void plan(AnalysisPlan& plan, const Project&, const Settings& settings,
          std::vector<irsg::Diagnostic>& diagnostics) {
    const double from_m = settings.real("range.from");
    const double to_m = settings.real("range.to");
    const int points = settings.integer("range.points");
    const bool logarithmic = settings.boolean("range.log");
    plan.coordinate = irsg::Quantity::range;
    if (to_m <= from_m) {
        diagnostics.push_back({.file = "",
                               .position = "range.to",
                               .value = settings.text("range.to"),
                               .expected = "a number above range.from, which is " +
                                           settings.text("range.from") + " m"});
    }
    if (logarithmic && from_m <= 0.0) {
        diagnostics.push_back({.file = "",
                               .position = "range.from",
                               .value = settings.text("range.from"),
                               .expected = "a number above 0 m, because range.log is true"});
    }
    if (!diagnostics.empty()) {
        return;
    }
    for (int i = 0; i < points; ++i) {
        const double share = static_cast<double>(i) / (points - 1);
        AnalysisCase one = standingCase(settings);
        one.range_m = logarithmic ? from_m * std::pow(to_m / from_m, share)
                                  : from_m + (to_m - from_m) * share;
        if (i == points - 1) {
            one.range_m = to_m;
        }
        one.coordinate = one.range_m;
        plan.cases.push_back(one);
    }
}

} // namespace

extern constinit const AnalysisDefinition rangeAnalysis{
    .name = "range",
    .title = "Range plot",
    .help = "Contrast intensity and irradiance over range",
    .settings = settings,
    .isAlongRange = true,
    .plan = plan};

} // namespace smat

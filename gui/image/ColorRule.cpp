#include "gui/image/ColorRule.h"

#include <algorithm>
#include <cmath>

#include "irsg/image/ImageStatistics.h"

namespace smat::gui {
namespace {

irsg::DisplayLimits endsOf(const ColorRule& rule, const std::vector<float>& values) {
    if (rule.mode == LimitMode::target)
        return irsg::limitsFor(rule.scale, values);
    if (rule.mode == LimitMode::percentile)
        return irsg::percentileLimits(values, rule.percentiles.first, rule.percentiles.second);
    return irsg::percentileLimits(values);
}

} // namespace

irsg::DisplayLimits limitsBy(const ColorRule& rule,
                             const std::vector<const std::vector<float>*>& planes,
                             const std::optional<irsg::DisplayLimits>& known) {
    irsg::DisplayLimits limits;
    if (known)
        limits = *known;
    std::vector<std::span<const float>> shown;
    for (const auto* values : planes) {
        const irsg::DisplayLimits one = known ? limits : endsOf(rule, *values);
        limits.low = shown.empty() ? one.low : std::min(limits.low, one.low);
        limits.high = shown.empty() ? one.high : std::max(limits.high, one.high);
        shown.emplace_back(*values);
    }
    limits.marksOutside = rule.marksOutside;
    return limits.with(rule.scale, shown);
}

FoundLimits findLimits(const ColorRule& rule, const std::vector<SharedValues>& planes,
                       const std::optional<irsg::DisplayLimits>& known) {
    std::vector<const std::vector<float>*> values;
    for (const SharedValues& plane : planes)
        values.push_back(plane.get());
    FoundLimits found{limitsBy(rule, values, known), {}};
    for (const auto* plane : values) {
        const OutOfRange one = countOutOfRange(*plane, found.limits);
        found.outside.below += one.below;
        found.outside.above += one.above;
        found.outside.nan += one.nan;
    }
    return found;
}

OutOfRange countOutOfRange(const std::vector<float>& values, const irsg::DisplayLimits& limits) {
    OutOfRange count;
    for (const float value : values) {
        count.below += static_cast<double>(value) < limits.low ? 1 : 0;
        count.above += static_cast<double>(value) > limits.high ? 1 : 0;
        count.nan += std::isnan(value) ? 1 : 0;
    }
    return count;
}

} // namespace smat::gui

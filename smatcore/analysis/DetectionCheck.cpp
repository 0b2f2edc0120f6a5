#include "smatcore/analysis/DetectionCheck.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/settings/AnalysisSections.h"
#include "smatcore/settings/SettingInfo.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

class Check {
  public:
    explicit Check(const GivenOptions& given) : given_(given) {}

    /// Options that do nothing when this is so.
    void idle(std::initializer_list<std::string> options, bool isSo, const std::string& because) {
        for (const std::string& option : options)
            if (isSo && given_.has(option))
                refuse(option, given_.values.at(option), because);
    }
    void require(bool holds, const std::string& option, const std::string& value,
                 const std::string& expected) {
        if (!holds)
            refuse(option, value, expected);
    }
    void end() {
        if (!diagnostics_.empty())
            throw irsg::InputError(std::move(diagnostics_));
    }

  private:
    void refuse(const std::string& option, const std::string& value, const std::string& expected) {
        diagnostics_.push_back({given_.nameOf(option), "", value, expected});
    }

    const GivenOptions& given_;
    std::vector<irsg::Diagnostic> diagnostics_;
};

void checkCriterion(const DetectionRequest& request, const GivenOptions& given, Check& check) {
    const bool isPoint = request.criterion == RangeCriterion::point;
    const std::string none = "nothing: the criterion " +
                             criterionWords()[static_cast<std::size_t>(request.criterion)] +
                             " has none";
    check.idle({"task", "cycles"}, isPoint, none);
    check.idle({"leave-out"}, isPoint, "nothing: the criterion point counts the whole light");
    check.idle({"snr", "false-alarms", "clutter", "point"}, !isPoint, none);
    check.idle({"scene-contrast", "display-pixel", "display-luminance"},
               request.criterion != RangeCriterion::targeting, none);
    check.idle({"task"}, !isPoint && given.has("cycles"),
               "nothing beside " + given.nameOf("cycles") + ", which is in its place");
    check.idle({"false-alarms"}, isPoint && given.has("snr"),
               "nothing beside " + given.nameOf("snr") + ", the threshold that follows from it");
    check.require(request.clutter_K >= 0.0 && std::isfinite(request.clutter_K), "clutter",
                  irsg::numberText(request.clutter_K), "a number of K above 0, or auto");
}

void checkComparison(const DetectionRequest& request, const GivenOptions& given, Check& check) {
    const std::string against = given.nameOf("against");
    check.idle({"values", "paint", "sun-of"}, !request.comparison, "nothing without " + against);
    if (!request.comparison)
        return;
    check.idle({"ranges", "sensitivity"}, true, "nothing beside " + against);
    check.require(given.has("values"), "values", "nothing", "values of " + against);
    const bool isPaint = request.comparison->against == RangeAgainst::paint;
    check.idle({"paint"}, !isPaint, "nothing: only " + against + " paint has one");
    check.require(!isPaint || given.has("paint"), "paint", "nothing",
                  "the material of the target that is replaced");
    check.idle({"sun-of"}, request.comparison->against != RangeAgainst::hour,
               "nothing: only " + against + " hour moves the sun");
}

void checkRanges(const DetectionRequest& request, const GivenOptions& given, Check& check) {
    const std::string ranges = given.nameOf("ranges");
    const bool isSought = request.ranges_m.empty();
    check.idle({"sensitivity", "nearest", "farthest", "looks", "probability"}, !isSought,
               "nothing beside " + ranges + ": no range is sought");
    check.idle({"draws"}, isSought && request.draws > 0,
               "nothing without " + ranges + ", of whose probability it is the mean");
    const auto wrong = std::ranges::find_if(request.ranges_m, [](double range_m) {
        return !(range_m > 0.0 && std::isfinite(range_m));
    });
    check.require(wrong == request.ranges_m.end(), "ranges",
                  wrong == request.ranges_m.end() ? "" : irsg::numberText(*wrong),
                  "ranges above 0 m");
    const irsg::RangeLimits& limits = request.limits;
    check.require(limits.farthest_m > limits.nearest_m, "farthest",
                  irsg::numberText(limits.farthest_m),
                  "a range beyond the nearest, " + irsg::numberText(limits.nearest_m) + " m");
}

} // namespace

std::vector<std::string> idleSettings(const DetectionRequest& request) {
    std::vector<std::string> keys = {key::sensorBand, key::sensorResponse, key::renderErrors,
                                     key::renderParts, key::renderTargetError};
    const std::string steps = key::stepsOf(name(kindOf(request.cases)));
    if (findSetting(steps) != nullptr)
        keys.push_back(steps);
    if (!request.measuresClutter)
        keys.push_back(key::cameraRange);
    return keys;
}

void checkDetection(const DetectionRequest& request, const GivenOptions& given) {
    Check check(given);
    checkCriterion(request, given, check);
    checkComparison(request, given, check);
    checkRanges(request, given, check);
    for (const std::string& setting : idleSettings(request))
        check.idle({setting}, true,
                   "nothing: band, ranges, steps and errors of a detection are those of its sensor "
                   "and its search");
    check.end();
}

} // namespace smat

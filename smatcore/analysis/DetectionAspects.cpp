#include "smatcore/analysis/DetectionAspects.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"

namespace smat {

namespace {

using Found = irsg::DetectionRange::Found;

/// Where the target of the first aspect is sampled, in nearest ranges at which it may be.
constexpr double usual = 64.0;
/// Of the target's reach over ranges: half a per mille of the contrast at most.
constexpr double nearnessThatMatters = 2.5e-4;
constexpr int mostSamplings = 4;

} // namespace

DetectionAspects::DetectionAspects(AnalysisData& data, const DetectionRequest& request,
                                   const RenderDoor& door, const SceneFactory& scenes)
    : data_(data), request_(request), shared_(data, request, door, scenes), sight_(request) {
    if (request.measuresClutter)
        clutter_.emplace(door, request.sensor);
}

void DetectionAspects::each(const std::vector<SceneDescription>& drawn, DetectionProgress& progress,
                            const std::function<void(const Case&)>& use,
                            const std::string& prefix) {
    const RunControl& control = progress.control;
    for (std::size_t i = 0; i < shared_.plan.cases.size(); ++i)
        for (std::size_t draw = 0; draw < drawn.size(); ++draw) {
            if (control.stop.stop_requested())
                return;
            const AnalysisCase& one = shared_.plan.cases[i];
            const std::string place = prefix + shared_.plan.place(one);
            if (control.progress)
                control.progress(
                    {progress.done, progress.total, progress.elapsed_s(), "detection: " + place});
            warnings_.beginCase(place);
            TargetAspect aspect(shared_, drawn[draw], sight_, one, data_, warnings_);
            ClutterOfAspect clutter;
            if (clutter_)
                std::tie(clutter.deviation_K, clutter.error_K) = aspect.takeClutter(*clutter_);
            use({i, draw, one, aspect, clutter});
            ++progress.done;
        }
}

void DetectionAspects::tellWarnings() {
    irsg::appendUnique(data_.warnings, warnings_.sentences());
}

double AspectRange::outcome() const {
    if (found.found == Found::nowhere)
        return -1.0;
    return found.found == Found::beyond || isRefusedBeyond ? 1.0 : 0.0;
}

bool AspectRange::isHiddenBeyond() const {
    return found.found == Found::atRange && found.slope == 0.0 && !isRefusedBeyond;
}

std::string AspectRange::warning() const {
    std::string text;
    for (const auto& [isSo, words] :
         {std::pair(isHiddenBeyond(), "hidden at longer ranges, at which its contrast is 0"),
          {found.found == Found::nowhere, "below the threshold at every range"},
          {isRefusedBeyond, "above the threshold at the farthest range that the scene answers for"},
          {found.found == Found::beyond, "above the threshold at the farthest range"},
          {isResolved, "an image larger than a pixel: the range is overstated"},
          {look.isFull, "a background that fills the pixels"}})
        if (isSo)
            text += (text.empty() ? "" : "; ") + std::string(words);
    return text;
}

std::optional<double> RangeSearch::ratio(TargetAspect& aspect, double range_m) {
    try {
        const TargetLook look = aspect.at(range_m, false);
        return std::copysign(sight_.reached(look), look.contrast_W_m2);
    } catch (const irsg::InputError& error) {
        refused_.emplace(range_m, error.what());
        return std::nullopt;
    }
}

bool RangeSearch::isSampledOnceAt(TargetAspect& aspect, double range_m) {
    try {
        return aspect.at(range_m, false).alongRangeReach_m > 0.0;
    } catch (const irsg::InputError&) {
        return true; // which the search will tell
    }
}

AspectRange RangeSearch::sampled(TargetAspect& aspect) {
    irsg::RangeLimits limits = request_.limits;
    limits.costlyBelow_m = std::min(aspect.drawnBelow_m(), limits.farthest_m);
    const double plain_m = std::max(limits.nearest_m, limits.costlyBelow_m);
    AspectRange one;
    double from_m = std::clamp(latest_m_.value_or(usual * plain_m), plain_m, limits.farthest_m);
    aspect.sampleFrom(from_m);
    if (!isSampledOnce_)
        isSampledOnce_ = isSampledOnceAt(aspect, from_m);
    // Every range has a rendering of its own otherwise: those beyond the range come first.
    if (!*isSampledOnce_)
        limits.costlyBelow_m = limits.farthest_m;
    for (int i = 0; i < mostSamplings; ++i) {
        aspect.sampleFrom(from_m);
        one.sampledFrom_m = from_m;
        bool isAllRefused = true;
        one.found = irsg::detectionRange(
            [&](double range_m) {
                const std::optional<double> value = ratio(aspect, range_m);
                isAllRefused = isAllRefused && !value;
                return value.value_or(0.0);
            },
            wanted_, limits);
        if (isAllRefused) // throws what no range changes
            (void)aspect.at(request_.limits.nearest_m, false);
        const double there_m = std::max(one.found.around.front().range_m, plain_m);
        const double reach_m = aspect.alongRangeReach_m(one.found);
        if (one.found.found == Found::atRange)
            isSampledOnce_ = reach_m > 0.0;
        if (reach_m * std::abs(1.0 / there_m - 1.0 / from_m) <= nearnessThatMatters)
            break;
        from_m = there_m;
    }
    one.look = aspect.between(one.found);
    if (one.found.found == Found::atRange)
        latest_m_ = one.found.range_m;
    return one;
}

AspectRange RangeSearch::find(TargetAspect& aspect) {
    refused_.clear();
    AspectRange one = sampled(aspect);
    const irsg::DetectionRange& found = one.found;
    const TargetLook& look = one.look;
    constexpr double justBeyond = 1.001;
    const auto refusedBeyond = refused_.upper_bound(found.range_m);
    one.isRefusedBeyond = found.found == Found::atRange && found.slope == 0.0 &&
                          refusedBeyond != refused_.end() &&
                          refusedBeyond->first < justBeyond * found.range_m;
    if (one.isRefusedBeyond) {
        one.error_m = std::numeric_limits<double>::quiet_NaN();
    } else if (found.found == Found::atRange) {
        one.error_m = std::max(request_.limits.tolerance, found.relativeError) * found.range_m;
        if (found.slope != 0.0)
            one.error_m =
                std::hypot(one.error_m, sight_.relativeError(look) * found.range_m / found.slope);
    }
    one.extent = std::sqrt(std::max(0.0, look.solidAngle_sr)) / request_.sensor.pixelAngle_rad();
    one.isResolved = !sight_.isOfCycles() && found.found != Found::nowhere && one.extent > 1.0;
    ++done_;
    never_ += found.found == Found::nowhere;
    beyond_ += found.found == Found::beyond;
    hidden_ += one.isHiddenBeyond();
    refusedBeyond_ += one.isRefusedBeyond;
    full_ += look.isFull;
    // Behind a range at which it fades or is hidden nobody looks for it.
    const auto least = refused_.begin();
    if (least != refused_.end() && least->first < leastRefused_.range_m &&
        (found.found != Found::atRange || least->first < justBeyond * found.range_m))
        leastRefused_ = {least->first, least->second};
    resolved_ += one.isResolved;
    return one;
}

void RangeSearch::tell(std::vector<std::string>& warnings) const {
    for (const auto& [count, what] :
         {std::pair(never_, "are below the threshold at every range: their range is 0"),
          {beyond_, "are above the threshold at the farthest range, which is given for them"},
          {refusedBeyond_, "end where the scene refuses longer ranges, at which they may be above "
                           "the threshold: the error of their range has no bound"},
          {hidden_,
           "end where the target is hidden: terrain or the horizon stands before all of it "
           "at longer ranges"},
          {resolved_, "have an image larger than a pixel at that range: the ratio of a point, "
                      "which collects the whole target in one pixel, overstates it"},
          {full_, "have a background that fills the pixels: their noise is that of a larger "
                  "well"}})
        if (count > 0)
            warnings.push_back(fmt::format("{} of {} aspects {}", count, done_, what));
    if (!leastRefused_.why.empty())
        warnings.push_back(fmt::format("nothing is seen over {} m or more: {}",
                                       irsg::roundedText(leastRefused_.range_m, 3),
                                       leastRefused_.why));
}

} // namespace smat

#include "smatcore/analysis/AdaptiveSweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/data/ColumnName.h"

namespace smat {

namespace {

constexpr double ofLargest = 0.1; ///< of a curve, below which bends count as parts of that

constexpr std::array<std::string_view, 4> followed = {"intensity", "contrast_intensity",
                                                      "irradiance", "source_intensity"};

} // namespace

AdaptiveSweep::AdaptiveSweep(const AnalysisPlan& plan, const ResultTable& columns)
    : plan_(plan), axes_(plan.refined), coordinates_(plan.columns.size()) {
    const std::vector<ResultColumn>& all = columns.columns();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const ColumnName name = ColumnName::of(all[i].key);
        if (!name.prefix.empty() || !name.object.empty() ||
            std::ranges::find(followed, name.series()) == followed.end())
            continue;
        Curve curve{i, i};
        ColumnName error = name;
        error.prefix = "error_";
        for (std::size_t k = 0; k < all.size(); ++k)
            if (all[k].key == error.key())
                curve.error = k;
        curves_.push_back(curve);
    }
    first_ = plan.cases.size();
    setOrder(plan.cases);
}

AdaptiveSweep::Place AdaptiveSweep::placeOf(const AnalysisCase& one) const {
    Place place;
    for (const irsg::Quantity quantity : plan_.columns)
        place.push_back(one.value(quantity));
    return place;
}

void AdaptiveSweep::setOrder(const std::vector<AnalysisCase>& all) {
    order_.clear();
    known_.clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Place place = placeOf(all[i]);
        order_[place] = i;
        if (rows_.contains(place))
            known_.push_back(i);
    }
}

std::size_t AdaptiveSweep::add(const std::vector<double>& row) {
    const Place place(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(coordinates_));
    const auto found = order_.find(place);
    if (found == order_.end())
        throw irsg::LogicError("a row of an adaptive sweep is of none of its cases");
    rows_[place] = row;
    const auto at = std::ranges::lower_bound(known_, found->second);
    const auto index = static_cast<std::size_t>(at - known_.begin());
    known_.insert(at, found->second);
    return index;
}

double AdaptiveSweep::bendOf(const std::vector<const std::vector<double>*>& curve,
                             std::size_t column, std::size_t interval, std::size_t axis) const {
    const std::vector<double>& places = axes_[axis].places;
    const bool isTurn = axes_[axis].isTurn;
    const auto count = static_cast<std::ptrdiff_t>(places.size());
    const auto wrapped = [&](std::ptrdiff_t i) {
        return static_cast<std::size_t>((i + count) % count);
    };
    const auto place = [&](std::ptrdiff_t i) {
        return places[wrapped(i)] + (i < 0 ? -360.0 : i >= count ? 360.0 : 0.0);
    };
    const auto value = [&](std::ptrdiff_t i) { return (*curve[wrapped(i)])[column]; };
    const auto isInside = [&](std::ptrdiff_t i) { return isTurn || (i > 0 && i + 1 < count); };
    const auto slope = [&](std::ptrdiff_t i) { // from i to i + 1
        return (value(i + 1) - value(i)) / (place(i + 1) - place(i));
    };
    const auto turn = [&](std::ptrdiff_t i) { // of the slope at i
        return isInside(i) ? slope(i) - slope(i - 1) : 0.0;
    };
    const auto second = [&](std::ptrdiff_t i) {
        return isInside(i) ? 2.0 * turn(i) / (place(i + 1) - place(i - 1)) : 0.0;
    };
    const auto i = static_cast<std::ptrdiff_t>(interval);
    const double step = place(i + 1) - place(i);
    const double own = std::max(std::abs(second(i)), std::abs(second(i + 1)));
    const double smooth = step * step / 8.0 * own;
    if (own == 0.0 || !isInside(i - 1) || !isInside(i + 2))
        return smooth;
    // What bends otherwise than beside is a kink, which may lie between the cases.
    const double beside = 0.5 * (second(i - 1) + second(i + 2));
    const double other = std::max(std::abs(second(i) - beside), std::abs(second(i + 1) - beside));
    const double kink = step / 4.0 * (std::abs(turn(i)) + std::abs(turn(i + 1)));
    return smooth + std::min(1.0, other / own) * std::max(kink - smooth, 0.0);
}

/// Intervals of an axis that bend too much at any place of the others.
std::vector<AdaptiveSweep::Bent> AdaptiveSweep::bent(std::size_t axis) {
    const RefinedAxis& own = axes_[axis];
    const std::size_t intervals = own.places.size() - (own.isTurn ? 0 : 1);
    // By place on the axis, the cases at all places of the others in one order.
    std::vector<std::vector<const std::vector<double>*>> rows;
    for (const double place : own.places) {
        std::vector<RefinedAxis> at = axes_;
        at[axis].places = {place};
        auto& list = rows.emplace_back();
        for (const AnalysisCase& one : plan_.casesAt(at))
            list.push_back(&rows_.at(placeOf(one)));
    }
    std::vector<Bent> worst(intervals);
    std::size_t steps = 0;
    std::vector<bool> isStep(intervals, false);
    for (std::size_t j = 0; j < rows.front().size(); ++j) {
        std::vector<const std::vector<double>*> line;
        for (const auto& list : rows)
            line.push_back(list.at(j));
        for (const Curve& curve : curves_) {
            double largest = 0.0;
            for (const auto* row : line)
                largest = std::max(largest, std::abs((*row)[curve.column]));
            for (std::size_t i = 0; i < intervals && largest > 0.0; ++i) {
                const std::size_t k = (i + 1) % line.size();
                const auto bothOf = [&](std::size_t column) {
                    return std::max(std::abs((*line[i])[column]), std::abs((*line[k])[column]));
                };
                const double bend = bendOf(line, curve.column, i, axis);
                const double scale = std::max(bothOf(curve.column), ofLargest * largest);
                const double noise = curve.error == curve.column ? 0.0 : bothOf(curve.error);
                const double end = k == 0 ? own.places[0] + 360.0 : own.places[k];
                const bool isLeast = end - own.places[i] < 1.999 * own.leastStep;
                const double allowed = std::max(plan_.largestBend * scale, noise);
                if (!(bend > allowed)) {
                    bend_ = std::max(bend_, bend / scale);
                } else if (isLeast) {
                    isStep[i] = true;
                } else {
                    worst[i].part = std::max(worst[i].part, bend / scale);
                    worst[i].excess = std::max(worst[i].excess, bend / allowed);
                }
            }
        }
    }
    std::vector<Bent> found;
    for (std::size_t i = 0; i < intervals; ++i) {
        steps += isStep[i] ? 1 : 0;
        worst[i].interval = i;
        if (worst[i].excess > 0.0)
            found.push_back(worst[i]);
    }
    steps_ += steps;
    return found;
}

/// Where there is room for few, those are taken that stay the worst ones when others are halved,
/// which makes bends a quarter of what they were.
void AdaptiveSweep::chooseWorst(std::vector<Bent>& found) const {
    const std::size_t eachPlace = rows_.size() / axes_.front().places.size();
    const std::size_t room =
        *plan_.mostRefined > rows_.size() ? (*plan_.mostRefined - rows_.size()) / eachPlace : 0;
    std::ranges::stable_sort(found, std::greater<>(), &Bent::excess);
    const double least = found.empty() ? 0.0 : 0.25 * found.front().excess;
    std::erase_if(found, [&](const Bent& one) { return one.excess < least; });
    found.resize(std::min(found.size(), room));
}

std::vector<AnalysisCase> AdaptiveSweep::next() {
    bend_ = 0.0;
    steps_ = 0;
    std::vector<RefinedAxis> finer = axes_;
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
        const RefinedAxis& own = axes_[axis];
        if (own.places.size() < 3)
            continue; // no curve
        std::vector<Bent> found = bent(axis);
        if (plan_.mostRefined) {
            const std::vector<Bent> all = found;
            chooseWorst(found);
            isFull_ = found.empty() && !all.empty();
            for (const Bent& left : isFull_ ? all : std::vector<Bent>())
                bend_ = std::max(bend_, left.part);
        }
        for (const auto& [i, part, excess] : found) {
            const double end =
                i + 1 == own.places.size() ? own.places[0] + 360.0 : own.places[i + 1];
            finer[axis].places.push_back(0.5 * (own.places[i] + end));
        }
        std::ranges::sort(finer[axis].places);
    }
    const std::vector<AnalysisCase> all = plan_.casesAt(finer);
    if (all.size() == rows_.size())
        return {};
    if (static_cast<double>(all.size()) > mostCases) {
        hasTooMany_ = true;
        return {};
    }
    axes_ = std::move(finer);
    setOrder(all);
    std::vector<AnalysisCase> more;
    for (const AnalysisCase& one : all)
        if (!rows_.contains(placeOf(one)))
            more.push_back(one);
    return more;
}

std::string AdaptiveSweep::sentence() const {
    std::string text = fmt::format(
        "adaptive steps: {} + {} cases, straight lines between which are within {} % of the curves",
        first_, rows_.size() - first_,
        bend_ < 1e-5 ? std::string("0") : irsg::roundedText(100.0 * bend_, 2));
    if (steps_ > 0)
        text += fmt::format(", but for {} interval{} of the least step, over which they jump",
                            steps_, steps_ == 1 ? "" : "s");
    if (isFull_)
        text += fmt::format("; {} are all, unless steps are asked to be adaptive", rows_.size());
    if (hasTooMany_)
        text += fmt::format("; no more, as there would be over {:.0f} cases", mostCases);
    return text;
}

} // namespace smat

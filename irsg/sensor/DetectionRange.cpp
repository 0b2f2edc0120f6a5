#include "irsg/sensor/DetectionRange.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <boost/math/tools/toms748_solve.hpp>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// How often an interval between two looks is halved at most.
constexpr int mostHalvings = 30;
/// ln(SNR / threshold) where there is no contrast: far below.
constexpr double unseen = -700.0;

struct Point {
    double x, y;
    bool isNegative = false; ///< the ratio
};

/// The part of one of these points in the polynomial through them at x (Lagrange).
double weightOf(std::span<const Point> points, const Point& one, double x) {
    double weight = 1.0;
    for (const Point& other : points)
        if (&other != &one)
            weight *= (x - other.x) / (one.x - other.x);
    return weight;
}

double polynomial(std::span<const Point> points, double x) {
    double sum = 0.0;
    for (const Point& one : points)
        sum += one.y * weightOf(points, one, x);
    return sum;
}

/// Where it is 0 between two of the points, whose values have different signs.
double rootBetween(std::span<const Point> points, const Point& a, const Point& b) {
    if (a.y == 0.0)
        return a.x;
    if (b.y == 0.0)
        return b.x;
    std::uintmax_t most = 100;
    const auto isNarrow = [](double low, double high) { return high - low <= 1e-14; };
    const auto [low, high] = boost::math::tools::toms748_solve(
        [&](double x) { return polynomial(points, x); }, a.x, b.x, a.y, b.y, isNarrow, most);
    return std::midpoint(low, high);
}

/// ln(SNR / threshold) over ln(range), at places of one grid.
class Excess {
  public:
    Excess(const std::function<double(double)>& ratio, double threshold, const RangeLimits& limits)
        : ratio_(ratio),
          threshold_(threshold),
          from_(std::log(limits.nearest_m)),
          to_(std::log(limits.farthest_m)),
          looks_(std::max<std::uint64_t>(
              1, static_cast<std::uint64_t>(std::ceil((to_ - from_) / std::log(10.0) *
                                                      std::max(1, limits.looksPerDecade))))),
          coarseStep_(static_cast<std::uint64_t>(std::max(1, limits.looksPerDecade / 4))) {}

    /// Intervals between the looks.
    std::uint64_t looks() const { return looks_; }
    std::uint64_t end() const { return looks_ << mostHalvings; }
    /// Of looks, four times per decade.
    std::uint64_t coarseStep() const { return coarseStep_; }

    double rangeAt(std::uint64_t place) const { return std::exp(logRangeAt(place)); }

    Point at(std::uint64_t place) {
        const double x = logRangeAt(place);
        const auto [known, isNew] = known_.try_emplace(place);
        if (isNew) {
            const double signedValue = ratio_(std::exp(x)) / threshold_;
            const double value = std::abs(signedValue);
            known->second = {x, value > 0.0 ? std::max(unseen, std::log(value)) : unseen,
                             signedValue < 0.0};
        }
        return known->second;
    }
    /// At one of the looks.
    Point atLook(std::uint64_t look) { return at(look << mostHalvings); }
    /// The first look that is not nearer than a range.
    std::uint64_t lookFrom(double range_m) const {
        const double place = (std::log(std::max(range_m, std::exp(from_))) - from_) / (to_ - from_);
        return std::min(looks_, static_cast<std::uint64_t>(
                                    std::ceil(place * static_cast<double>(looks_) - 1e-9)));
    }

  private:
    double logRangeAt(std::uint64_t place) const {
        return std::lerp(from_, to_, static_cast<double>(place) / static_cast<double>(end()));
    }

    const std::function<double(double)>& ratio_;
    double threshold_, from_, to_;
    std::uint64_t looks_, coarseStep_;
    std::unordered_map<std::uint64_t, Point> known_;
};

/// The places about an interval, from the one before it to the one behind it.
struct Neighbours {
    std::vector<Point> points;
    std::size_t low = 0; ///< where the interval begins

    const Point& from() const { return points[low]; }
    const Point& to() const { return points[low + 1]; }
    double width() const { return to().x - from().x; }
    double root() const { return rootBetween(points, from(), to()); }
    /// A step, through which no polynomial goes.
    bool isStep() const {
        return std::ranges::any_of(points, [](const Point& one) { return one.y <= unseen; });
    }
    /// By how much the roots of polynomials of one degree less differ from that.
    double error() const {
        const std::span<const Point> all = points;
        const auto differs = [&](std::span<const Point> fewer) {
            return std::abs(rootBetween(fewer, from(), to()) - root());
        };
        if (isStep() || all.size() < 3)
            return width();
        if (all.size() == 3) // at an end of the grid
            return differs(all.subspan(low, 2));
        return std::max(differs(all.first(3)), differs(all.last(3)));
    }
};

Neighbours neighboursOf(Excess& excess, std::uint64_t left, std::uint64_t step) {
    Neighbours made;
    if (left >= step) {
        made.points.push_back(excess.at(left - step));
        made.low = 1;
    }
    made.points.push_back(excess.at(left));
    made.points.push_back(excess.at(left + step));
    if (left + 2 * step <= excess.end())
        made.points.push_back(excess.at(left + 2 * step));
    return made;
}

/// Sets what is known of the root between place `left` and the next look.
void findRoot(Excess& excess, std::uint64_t left, double tolerance, DetectionRange& found) {
    // Halving an interval of a smooth ratio leaves an eighth of the error, at a kink a half. Where
    // the ratio scatters from place to place it leaves as much as it was: the wider interval, which
    // the scatter changes less, stays.
    constexpr double leastGain = 0.7;
    constexpr int mostInVain = 2;
    std::uint64_t step = std::uint64_t{1} << mostHalvings;
    Neighbours near = neighboursOf(excess, left, step);
    double error = near.error(), inVainError = 0.0;
    for (int inVain = 0; step > 1 && error > tolerance && inVain < mostInVain;) {
        step /= 2;
        if (excess.at(left + step).y >= 0.0)
            left += step;
        const Neighbours halved = neighboursOf(excess, left, step);
        const double errorOfHalved = halved.error();
        if (halved.isStep() || errorOfHalved < leastGain * error) {
            near = halved;
            error = errorOfHalved;
            inVain = 0;
            inVainError = 0.0;
        } else {
            ++inVain;
            inVainError = std::max(inVainError, errorOfHalved);
        }
    }
    found.relativeError = std::max(error, inVainError);
    if (near.isStep()) { // the last range at which it is seen
        found.range_m = std::exp(near.from().x);
        found.around = {{found.range_m, 1.0}};
        return;
    }
    const double root = near.root(), width = 1e-3 * near.width();
    found.range_m = std::exp(root);
    found.slope = (polynomial(near.points, root + width) - polynomial(near.points, root - width)) /
                  (2.0 * width);
    for (const Point& point : near.points)
        found.around.push_back({std::exp(point.x), weightOf(near.points, point, root)});
}

/// By how much the line through two places misses the third one.
double bend(const Point& first, const Point& second, const Point& third) {
    return std::abs(second.y - third.y +
                    (third.x - second.x) * (second.y - first.y) / (second.x - first.x));
}

/// Whether the ratio may cross the threshold between place i and the next one: how far it is from
/// the threshold at both, beside how much it bends about them.
bool mayCross(std::span<const Point> places, std::size_t i) {
    const Point &from = places[i], &to = places[i + 1];
    if ((from.y >= 0.0) != (to.y >= 0.0) || (from.y <= unseen) != (to.y <= unseen))
        return true;
    if (from.y <= unseen)
        return false;
    if (from.isNegative != to.isNegative) // through zero it dips without end
        return true;
    double bends = 0.0;
    if (i > 0)
        bends = bend(places[i - 1], from, to);
    if (i + 2 < places.size())
        bends = std::max(bends, bend(places[i + 2], to, from));
    return std::min(std::abs(from.y), std::abs(to.y)) < bends;
}

/// The looks from one to another, ascending, that tell where the ratio crosses the threshold.
std::vector<std::uint64_t> looksWorthwhile(Excess& excess, std::uint64_t from, std::uint64_t to) {
    const std::uint64_t coarse = excess.coarseStep();
    std::vector<std::uint64_t> looks;
    for (std::uint64_t look = from; look < to; look += coarse)
        looks.push_back(look);
    looks.push_back(to);
    for (bool isEnough = false; !isEnough;) {
        std::vector<Point> places;
        places.reserve(looks.size());
        for (const std::uint64_t look : looks)
            places.push_back(excess.atLook(look));
        std::vector<std::uint64_t> finer;
        for (std::size_t i = 0; i < looks.size(); ++i) {
            finer.push_back(looks[i]);
            if (i + 1 < looks.size() && looks[i + 1] - looks[i] > 1 && mayCross(places, i))
                finer.push_back(std::midpoint(looks[i], looks[i + 1]));
        }
        isEnough = finer.size() == looks.size();
        looks = std::move(finer);
    }
    return looks;
}

} // namespace

DetectionRange detectionRange(const std::function<double(double)>& ratio, double threshold,
                              const RangeLimits& limits) {
    if (!(limits.nearest_m > 0.0 && limits.farthest_m > limits.nearest_m &&
          std::isfinite(limits.farthest_m)))
        throw InputError({"", "limits of the range",
                          numberText(limits.nearest_m) + " to " + numberText(limits.farthest_m),
                          "two ascending ranges above 0 m"});
    if (!(threshold > 0.0 && std::isfinite(threshold)))
        throw InputError({"", "threshold", numberText(threshold), "a number above 0"});
    Excess excess(ratio, threshold, limits);
    DetectionRange found;
    std::optional<std::uint64_t> last;
    bool isSeenAtEnd = false;
    const auto lookBetween = [&](std::uint64_t from, std::uint64_t to) {
        const std::vector<std::uint64_t> looks = looksWorthwhile(excess, from, to);
        for (std::size_t i = 0; i < looks.size(); ++i) {
            const bool here = excess.atLook(looks[i]).y >= 0.0;
            if (i > 0 && here != isSeenAtEnd) {
                ++found.crossings;
                if (isSeenAtEnd)
                    last = looks[i - 1];
            }
            isSeenAtEnd = here;
        }
    };
    const std::uint64_t first = excess.lookFrom(limits.costlyBelow_m);
    lookBetween(first, excess.looks());
    if (first > 0 && !last && !isSeenAtEnd) {
        std::uint64_t from = first;
        do
            from -= std::min(from, excess.coarseStep());
        while (from > 0 && excess.atLook(from).y < 0.0);
        lookBetween(from, first);
    }
    if (isSeenAtEnd) {
        found.found = DetectionRange::Found::beyond;
        found.range_m = limits.farthest_m;
        found.around = {{excess.rangeAt(excess.end()), 1.0}};
    } else if (last) {
        found.found = DetectionRange::Found::atRange;
        findRoot(excess, *last << mostHalvings, limits.tolerance, found);
    } else {
        found.around = {{excess.rangeAt(0), 1.0}};
    }
    return found;
}

} // namespace irsg

#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <ranges>

namespace irsg {

/// What a place before the first node of an axis or after the last one is taken for.
enum class Beyond {
    clamp,       ///< the end of the axis: the value there is held
    extrapolate, ///< itself: the line through the first or last two nodes goes on
    notANumber   ///< no place: the value is NaN
};

/// Where a place lies between two neighbouring nodes of an axis, by their indices. The fraction is
/// 0 at `below` and 1 at `above`; what is linear between the nodes is lerp(y[below], y[above],
/// fraction).
struct Bracket {
    std::size_t below = 0;
    std::size_t above = 0; ///< below + 1; below where the axis has one node
    double fraction = 0.0; ///< 0 to 1; outside that where `Beyond` extrapolates, or NaN
};

/// The value at a fraction t of the way from a to b: exactly a at t = 0 and exactly b at t = 1,
/// whatever the other end is (NaN and infinity included), monotone in t and without overflow for
/// finite a and b and t from 0 to 1. Beyond that the line goes on. NaN where t is NaN.
constexpr double lerp(double a, double b, double t) {
    if (t == 0.0)
        return a;
    if (t == 1.0)
        return b;
    const bool crossesZero = a < b ? a <= 0.0 && b >= 0.0 : b <= 0.0 && a >= 0.0;
    if (crossesZero) // the difference may overflow
        return t * b + (1.0 - t) * a;
    const double value = a + t * (b - a);
    // Rounding may carry it past b.
    const bool isAtMost = (t < 1.0) == (a < b);
    return isAtMost ? (value > b ? b : value) : (value < b ? b : value);
}

/// The value at a fraction t of the way from a to b by equal ratios, a (b / a)^t, which is linear
/// in the logarithm: exactly a at t = 0 and exactly b at t = 1. Where an end is not positive, it
/// is linear.
inline double lerpByRatio(double a, double b, double t) {
    if (!(a > 0.0 && b > 0.0) || t == 0.0 || t == 1.0)
        return lerp(a, b, t);
    const double ratio = b / a;
    if (std::isnormal(ratio))
        return a * std::pow(ratio, t);
    return std::exp(lerp(std::log(a), std::log(b), t)); // the ratio overflows or underflows
}

/// The fraction at which lerpByRatio from a to b has a value: ln(value / a) / ln(b / a). All three
/// are positive, a and b differ.
inline double fractionByRatio(double a, double b, double value) {
    return std::log(value / a) / std::log(b / a);
}

namespace bracketing {

/// The node from `low` on, which the place is not before or which is the first, after which comes
/// one that it is before, or `high`.
template <typename IsBefore>
std::size_t narrow(std::size_t low, std::size_t high, IsBefore isBefore) {
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        (isBefore(middle) ? high : low) = middle;
    }
    return low;
}

/// The last of `count` >= 2 nodes that the place is not before, or the first; never the last node
/// of all, since an interval begins with it. It is sought in steps that grow from `near` on.
template <typename IsBefore>
std::size_t narrowNear(std::size_t count, std::size_t near, IsBefore isBefore) {
    std::size_t low = std::min(near, count - 2), high = low + 1;
    for (std::size_t step = 1; low > 0 && isBefore(low); step *= 2) {
        high = low;
        low -= std::min(step, low);
    }
    for (std::size_t step = 1; high < count - 1 && !isBefore(high); step *= 2) {
        low = high;
        high += std::min(step, count - 1 - high);
    }
    return narrow(low, high, isBefore);
}

template <typename Axis, typename Projection, typename Search>
Bracket find(const Axis& axis, double x, Beyond beyond, const Projection& projection,
             const Search& search) {
    const auto count = static_cast<std::size_t>(std::ranges::size(axis));
    assert(count > 0);
    const auto begin = std::ranges::begin(axis);
    const auto node = [&](std::size_t i) {
        return static_cast<double>(std::invoke(
            projection, begin[static_cast<std::iter_difference_t<decltype(begin)>>(i)]));
    };
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const double first = node(0), last = node(count - 1);
    if (beyond == Beyond::notANumber && !(x >= std::min(first, last) && x <= std::max(first, last)))
        return {0, count > 1 ? std::size_t{1} : std::size_t{0}, none};
    if (count == 1)
        return {0, 0, std::isnan(x) ? x : 0.0};

    const bool descends = first > last;
    const std::size_t below = descends ? search(count, [&](std::size_t i) { return x > node(i); })
                                       : search(count, [&](std::size_t i) { return x < node(i); });
    const double from = node(below), to = node(below + 1), width = to - from;
    double fraction = 0.0;
    if (width == 0.0) // the end of the axis is a node twice
        fraction = std::isnan(x) ? x : (descends ? x > from : x < from) ? 0.0 : 1.0;
    else if (std::isfinite(width))
        fraction = (x - from) / width;
    else
        fraction = (0.5 * x - 0.5 * from) / (0.5 * to - 0.5 * from);
    if (beyond == Beyond::clamp)
        fraction = std::clamp(fraction, 0.0, 1.0); // NaN stays
    return {below, below + 1, fraction};
}

} // namespace bracketing

/// The nodes of an axis that a place x lies between.
///
/// `axis` is a range of at least one node with random access, finite, in ascending or descending
/// order; `projection` gives the coordinate of an element (identity, a member, a function). A node
/// that is there more than once is a step: before it counts its first element, from it on its last.
/// At a node the fraction is 0, at the last one 1. A single node is a constant, for which nothing
/// is extrapolated. Where x is NaN, so is the fraction, and the indices are in range.
template <std::ranges::random_access_range Axis, typename Projection = std::identity>
Bracket bracket(const Axis& axis, double x, Beyond beyond = Beyond::clamp,
                Projection projection = {}) {
    return bracketing::find(axis, x, beyond, projection, [](std::size_t count, auto isBefore) {
        return bracketing::narrow(0, count - 1, isBefore);
    });
}

/// The same, found from the interval that begins at `near` (any index): quick for places in order,
/// each from `below` of the one before.
template <std::ranges::random_access_range Axis, typename Projection = std::identity>
Bracket bracketNear(std::size_t near, const Axis& axis, double x, Beyond beyond = Beyond::clamp,
                    Projection projection = {}) {
    return bracketing::find(axis, x, beyond, projection, [near](std::size_t count, auto isBefore) {
        return bracketing::narrowNear(count, near, isBefore);
    });
}

/// The value at x of what is linear between nodes: `values` has one for each node of the axis.
template <std::ranges::random_access_range Axis, std::ranges::random_access_range Values>
double interpolate(const Axis& axis, const Values& values, double x,
                   Beyond beyond = Beyond::clamp) {
    const Bracket at = bracket(axis, x, beyond);
    return lerp(values[at.below], values[at.above], at.fraction);
}

} // namespace irsg

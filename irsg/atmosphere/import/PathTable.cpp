#include "irsg/atmosphere/import/PathTable.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/MonotoneCubic.h"

namespace irsg {

namespace {

constexpr double unknownDepth = 40.0;
/// Weight of a path of 1 m that is otherwise fully transparent, so that what little it radiates
/// has an equivalent source.
constexpr double transparentWeight_per_m = 1e-10;
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// 1 - tau, and a little for the length of the path.
double emissivity(double depth, double range_m) {
    return -std::expm1(-depth) + transparentWeight_per_m * range_m;
}

/// Depth at a range below the first node x[1]: a R / sqrt(1 + b R) through the first two nodes.
double belowFirst(const std::vector<double>& x, const std::vector<double>& y, double range_m) {
    const double part = range_m / x[1];
    if (x.size() < 3 || !(y[1] > 0.0) || !(y[2] > 0.0))
        return y[1] * part;
    const double meanRatio = (y[1] / x[1]) / (y[2] / x[2]);
    const double q = meanRatio * meanRatio;
    if (q >= x[2] / x[1])
        return y[1] * std::sqrt(part);
    const double b = std::max(0.0, q - 1.0) / (x[2] - q * x[1]);
    return y[1] * part * std::sqrt((1.0 + b * x[1]) / (1.0 + b * range_m));
}

std::string lengths(double lower, double upper) {
    return lower == upper ? metresText(lower) + " m"
                          : metresText(lower) + " to " + metresText(upper) + " m";
}

/// Ascending values of one coordinate of pairs, each once.
template <typename Pairs, typename Member>
std::vector<double> axisOf(const Pairs& pairs, Member member, const auto* without) {
    std::vector<double> axis;
    for (const auto& pair : pairs)
        if (&pair != without)
            axis.push_back(pair.*member);
    std::ranges::sort(axis);
    const auto rest = std::ranges::unique(axis);
    axis.erase(rest.begin(), rest.end());
    return axis;
}

/// Between altitudes the logarithm of a depth is linear, as densities fall. Depths below 1e-4 of
/// the largest count as that: what a file rounded to a transmittance of 1 is not known better.
double betweenDepths(const std::vector<std::pair<double, double>>& depthsWithWeights) {
    constexpr double least = 1e-4;
    double largest = 0.0;
    for (const auto& [depth, weight] : depthsWithWeights)
        largest = std::max(largest, depth);
    if (depthsWithWeights.size() == 1 || !(largest > 0.0))
        return largest;
    double logarithm = 0.0;
    for (const auto& [depth, weight] : depthsWithWeights)
        logarithm += weight * std::log(std::max(depth, least * largest));
    return std::exp(logarithm);
}

} // namespace

void PathTable::add(const AtmosphericPath& path, std::vector<double> depth,
                    std::vector<double> radiance) {
    if (!(path.range_m > 0.0) || holds(path) ||
        (!nodes_.empty() && (depth.size() != nodes_.front().depth.size() ||
                             radiance.empty() != nodes_.front().source.empty())) ||
        (!radiance.empty() && radiance.size() != depth.size())) {
        throw LogicError("a path does not fit its table");
    }
    nodes_.push_back({path, std::move(depth), std::move(radiance)});
    place(nodes_.size() - 1);
}

bool PathTable::holds(const AtmosphericPath& path) const {
    return std::ranges::any_of(nodes_, [&](const Node& node) {
        return std::abs(node.path.sensorAltitude_m - path.sensorAltitude_m) < 0.1 &&
               std::abs(node.path.targetAltitude_m - path.targetAltitude_m) < 0.1 &&
               std::abs(node.path.range_m - path.range_m) < 0.01 + 1e-7 * path.range_m;
    });
}

void PathTable::place(std::size_t index) {
    Node& node = nodes_[index];
    auto found = std::ranges::find_if(pairs_, [&](const Pair& one) {
        return std::abs(one.sensor_m - node.path.sensorAltitude_m) < 0.1 &&
               std::abs(one.target_m - node.path.targetAltitude_m) < 0.1;
    });
    if (found == pairs_.end()) {
        pairs_.push_back({node.path.sensorAltitude_m, node.path.targetAltitude_m, {0.0}, {}});
        found = pairs_.end() - 1;
    }
    const auto after = std::ranges::upper_bound(found->ranges_m, node.path.range_m);
    // A range of 0 has no node.
    const auto place = after - found->ranges_m.begin() - 1;
    found->nodes.insert(found->nodes.begin() + place, index);
    found->ranges_m.insert(after, node.path.range_m);

    // What is opaque continues the node before it; radiance becomes a source.
    for (std::size_t i = 0; i < node.depth.size(); ++i)
        if (!node.source.empty() && std::isinf(node.depth[i]))
            node.source[i] /= emissivity(unknownDepth, node.path.range_m);
        else if (!node.source.empty())
            node.source[i] /= emissivity(node.depth[i], node.path.range_m);
}

const PathTable::Pair* PathTable::pair(double sensor_m, double target_m) const {
    const auto found = std::ranges::find_if(pairs_, [&](const Pair& one) {
        return one.sensor_m == sensor_m && one.target_m == target_m;
    });
    return found == pairs_.end() ? nullptr : &*found;
}

std::vector<PathTable::Corner> PathTable::corners(double sensor_m, double target_m,
                                                  const Pair* without) const {
    // Horizontal paths need nothing but horizontal ones.
    if (std::abs(sensor_m - target_m) <= altitudeTolerance_m) {
        std::vector<double> heights;
        for (const Pair& one : pairs_)
            if (&one != without && one.sensor_m == one.target_m)
                heights.push_back(one.sensor_m);
        std::ranges::sort(heights);
        if (const auto place =
                bracketOf(heights, 0.5 * (sensor_m + target_m), altitudeTolerance_m)) {
            std::vector<Corner> ends = {
                {pair(heights[place->below], heights[place->below]), 1.0 - place->fraction}};
            if (place->fraction > 0.0)
                ends.push_back(
                    {pair(heights[place->above], heights[place->above]), place->fraction});
            return ends;
        }
    }
    return between(sensor_m, target_m, without);
}

std::vector<PathTable::Corner> PathTable::between(double sensor_m, double target_m,
                                                  const Pair* without) const {
    const std::vector<double> sensors = axisOf(pairs_, &Pair::sensor_m, without);
    const std::vector<double> targets = axisOf(pairs_, &Pair::target_m, without);
    const auto s = bracketOf(sensors, sensor_m, altitudeTolerance_m);
    const auto t = bracketOf(targets, target_m, altitudeTolerance_m);
    if (!s || !t)
        return {};
    std::vector<Corner> found;
    for (const auto& [i, ws] : {std::pair{s->below, 1.0 - s->fraction}, {s->above, s->fraction}}) {
        for (const auto& [j, wt] :
             {std::pair{t->below, 1.0 - t->fraction}, {t->above, t->fraction}}) {
            if (ws * wt > 0.0) {
                const Pair* const one = pair(sensors[i], targets[j]);
                if (!one || one == without)
                    return {};
                found.push_back({one, ws * wt});
            }
        }
    }
    return found;
}

bool PathTable::reaches(const std::vector<Corner>& corners, double range_m) const {
    return !corners.empty() && std::ranges::all_of(corners, [&](const Corner& corner) {
        return range_m <= corner.pair->ranges_m.back() * (1.0 + 1e-4) + 1.0;
    });
}

double PathTable::depthAt(const Pair& pair, double range_m, std::size_t index, std::size_t without,
                          Curve& curve) const {
    auto& [x, y] = curve;
    x.assign(1, 0.0);
    y.assign(1, 0.0);
    for (std::size_t k = 0; k < pair.nodes.size(); ++k) {
        if (pair.nodes[k] == without)
            continue;
        const double range = pair.ranges_m[k + 1];
        const double depth = nodes_[pair.nodes[k]].depth[index];
        y.push_back(std::isinf(depth)
                        ? std::max(unknownDepth, x.size() > 1 ? y.back() * range / x.back() : 0.0)
                        : depth);
        x.push_back(range);
    }
    if (range_m < x[1])
        return belowFirst(x, y, range_m);
    return std::max(0.0,
                    monotoneCubic(
                        std::span<const double>(x), [&](std::size_t k) { return y[k]; }, range_m));
}

double PathTable::sourceAt(const Pair& pair, double range_m, std::size_t index, std::size_t without,
                           Curve& curve) const {
    auto& [x, y] = curve;
    x.clear();
    y.clear();
    for (std::size_t k = 0; k < pair.nodes.size(); ++k) {
        if (pair.nodes[k] != without) {
            x.push_back(pair.ranges_m[k + 1]);
            y.push_back(nodes_[pair.nodes[k]].source[index]);
        }
    }
    if (x.size() == 1 || range_m <= x.front())
        return y.front();
    return std::max(0.0,
                    monotoneCubic(
                        std::span<const double>(x), [&](std::size_t k) { return y[k]; }, range_m));
}

PathTable::Answer PathTable::blend(const std::vector<Corner>& corners, double range_m,
                                   std::size_t first, std::size_t last) const {
    Answer answer;
    Curve curve;
    answer.depth.assign(last - first, 0.0);
    const bool radiates = !nodes_.front().source.empty();
    std::vector<double> source(radiates ? last - first : 0, 0.0);
    std::vector<std::pair<double, double>> depths; // of a corner, and its weight
    for (std::size_t i = first; i < last; ++i) {
        depths.clear();
        for (const Corner& corner : corners) {
            depths.emplace_back(depthAt(*corner.pair, range_m, i, none, curve), corner.weight);
            if (radiates) {
                source[i - first] +=
                    corner.weight * sourceAt(*corner.pair, range_m, i, none, curve);
            }
        }
        answer.depth[i - first] = betweenDepths(depths);
    }
    for (std::size_t i = 0; i < source.size(); ++i)
        answer.radiance.push_back(source[i] * emissivity(answer.depth[i], range_m));
    return answer;
}

PathTable::Answer PathTable::at(const AtmosphericPath& path, std::size_t first, std::size_t last,
                                const std::string& owner) const {
    const std::vector<Corner> ends = corners(path.sensorAltitude_m, path.targetAltitude_m, nullptr);
    if (!reaches(ends, path.range_m)) {
        throw InputError({owner, "path",
                          "sensor at " + metresText(path.sensorAltitude_m) + " m, target at " +
                              metresText(path.targetAltitude_m) + " m, range " +
                              metresText(path.range_m) + " m",
                          "a path between those of its runs: " + span()});
    }
    return blend(ends, path.range_m, first, last);
}

RunDistance PathTable::nearest(const AtmosphericPath& path) const {
    std::vector<RunDistance> all;
    for (const Node& node : nodes_)
        all.push_back(
            {.altitude_m = std::max(std::abs(node.path.sensorAltitude_m - path.sensorAltitude_m),
                                    std::abs(node.path.targetAltitude_m - path.targetAltitude_m)),
             .range_m = std::abs(node.path.range_m - path.range_m)});
    return *std::ranges::min_element(all, {}, &RunDistance::sum);
}

std::vector<AtmosphericPath> PathTable::longest() const {
    std::vector<AtmosphericPath> paths;
    for (const Pair& one : pairs_)
        paths.push_back({one.sensor_m, one.target_m, one.ranges_m.back()});
    return paths;
}

std::string PathTable::span() const {
    if (nodes_.empty())
        return "no path";
    const auto [lowSensor, highSensor] = std::ranges::minmax(pairs_, {}, &Pair::sensor_m);
    const auto [lowTarget, highTarget] = std::ranges::minmax(pairs_, {}, &Pair::target_m);
    const auto [shortest, longest] =
        std::ranges::minmax(pairs_, {}, [](const Pair& one) { return one.ranges_m.back(); });
    return "sensor " + lengths(lowSensor.sensor_m, highSensor.sensor_m) + ", target " +
           lengths(lowTarget.target_m, highTarget.target_m) + ", range up to " +
           lengths(shortest.ranges_m.back(), longest.ranges_m.back()) + " (" +
           std::to_string(nodes_.size()) + (nodes_.size() == 1 ? " path)" : " paths)");
}

void PathTable::compare(const Answer& guess, const Node& node, ErrorSum& depth,
                        ErrorSum& radiance) const {
    double largest = 0.0;
    std::vector<double> truth;
    for (std::size_t i = 0; i < node.source.size(); ++i) {
        const double opaque = std::isinf(node.depth[i]) ? unknownDepth : node.depth[i];
        truth.push_back(node.source[i] * emissivity(opaque, node.path.range_m));
        largest = std::max(largest, truth.back());
    }
    for (std::size_t i = 0; i < node.depth.size(); ++i) {
        depth.add(std::exp(-guess.depth[i]) - std::exp(-node.depth[i]));
        if (largest > 0.0)
            radiance.add((guess.radiance[i] - truth[i]) / largest);
    }
    depth.endNode();
    radiance.endNode();
}

std::vector<InterpolationError> PathTable::errors(const std::string& quantity) const {
    std::vector<InterpolationError> results;
    if (nodes_.empty())
        return results;
    const bool radiates = !nodes_.front().source.empty();
    const auto keep = [&](const ErrorSum& depth, const ErrorSum& radiance, const char* axis) {
        results.push_back(depth.result(quantity, axis));
        if (radiates)
            results.push_back(radiance.result("path radiance", axis));
    };

    // Range: every node but the longest of its pair.
    ErrorSum depth;
    ErrorSum radiance;
    for (const Pair& one : pairs_) {
        for (std::size_t k = 0; k + 1 < one.nodes.size(); ++k) {
            const Node& node = nodes_[one.nodes[k]];
            Answer guess;
            Curve curve;
            for (std::size_t i = 0; i < node.depth.size(); ++i) {
                guess.depth.push_back(depthAt(one, node.path.range_m, i, one.nodes[k], curve));
                if (radiates) {
                    guess.radiance.push_back(
                        sourceAt(one, node.path.range_m, i, one.nodes[k], curve) *
                        emissivity(guess.depth.back(), node.path.range_m));
                }
            }
            compare(guess, node, depth, radiance);
        }
    }
    keep(depth, radiance, "range");

    // Altitudes: every pair that lies between others of the same other altitude.
    const auto leaveOut = [&](const char* axis, auto isOnLine, auto heightOf, auto pairAt) {
        ErrorSum depthSum;
        ErrorSum radianceSum;
        bool varies = false;
        for (const Pair& one : pairs_) {
            std::vector<double> heights;
            for (const Pair& other : pairs_)
                if (&other != &one && isOnLine(one, other))
                    heights.push_back(heightOf(other));
            std::ranges::sort(heights);
            varies = varies || !heights.empty();
            const auto place = bracketOf(heights, heightOf(one), 0.0);
            if (!place || place->fraction == 0.0)
                continue;
            const std::vector<Corner> ends = {
                {pairAt(one, heights[place->below]), 1.0 - place->fraction},
                {pairAt(one, heights[place->above]), place->fraction}};
            for (const std::size_t k : one.nodes) {
                if (reaches(ends, nodes_[k].path.range_m)) {
                    compare(blend(ends, nodes_[k].path.range_m, 0, nodes_[k].depth.size()),
                            nodes_[k], depthSum, radianceSum);
                }
            }
        }
        if (varies)
            keep(depthSum, radianceSum, axis);
    };
    leaveOut(
        "altitude of horizontal paths",
        [](const Pair& a, const Pair& b) {
            return a.sensor_m == a.target_m && b.sensor_m == b.target_m;
        },
        [](const Pair& one) { return one.sensor_m; },
        [&](const Pair&, double height) { return pair(height, height); });
    leaveOut(
        "sensor altitude", [](const Pair& a, const Pair& b) { return a.target_m == b.target_m; },
        [](const Pair& one) { return one.sensor_m; },
        [&](const Pair& one, double height) { return pair(height, one.target_m); });
    leaveOut(
        "target altitude", [](const Pair& a, const Pair& b) { return a.sensor_m == b.sensor_m; },
        [](const Pair& one) { return one.target_m; },
        [&](const Pair& one, double height) { return pair(one.sensor_m, height); });
    return results;
}

} // namespace irsg

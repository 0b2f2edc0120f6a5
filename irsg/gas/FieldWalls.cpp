#include "irsg/gas/FieldWalls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

/// Numbers of the planes of a field between which something lies.
struct PlaneRange {
    std::size_t first = std::numeric_limits<std::size_t>::max(), last = 0;
};

/// How fast the root of a temperature above the coldest changes along each axis, between planes.
class Changes {
  public:
    Changes(const PlumeField& field, double coldest_K) : field_(field) {
        const auto& axes_m = field.axes_m();
        std::size_t number = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            changes_[axis].assign(axes_m[axis].size() - 1, 0.0);
        std::vector<float> roots;
        roots.reserve(field.nodes().size());
        for (const PlumeField::Node& node : field.nodes())
            roots.push_back(node.isGas
                                ? static_cast<float>(std::sqrt(std::max(
                                      0.0, static_cast<double>(node.temperature_K) - coldest_K)))
                                : 0.0F);
        const std::array<std::size_t, 3> next{axes_m[1].size() * axes_m[2].size(), axes_m[2].size(),
                                              1};
        for (std::size_t x = 0; x < axes_m[0].size(); ++x)
            for (std::size_t y = 0; y < axes_m[1].size(); ++y)
                for (std::size_t z = 0; z < axes_m[2].size(); ++z, ++number) {
                    const std::array<std::size_t, 3> at{x, y, z};
                    const bool isIn =
                        field.nodes()[number].isGas &&
                        static_cast<double>(field.nodes()[number].temperature_K) >= coldest_K;
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        if (isIn) {
                            ranges_[axis].first = std::min(ranges_[axis].first, at[axis]);
                            ranges_[axis].last = std::max(ranges_[axis].last, at[axis]);
                        }
                        if (at[axis] + 1 == axes_m[axis].size())
                            continue;
                        const auto change = static_cast<double>(
                            std::abs(roots[number + next[axis]] - roots[number]));
                        double& most = changes_[axis][at[axis]];
                        most = std::max(most, change);
                    }
                }
    }

    /// Planes about places in order, among them those of the field where they are as close, which
    /// hold its extremes.
    std::vector<double> planesNear(std::size_t axis, const std::vector<double>& places_m) const {
        const std::vector<double>& planes_m = field_.axes_m()[axis];
        std::vector<double> near_m;
        const auto add = [&](double plane_m) {
            if (near_m.empty() || plane_m > near_m.back())
                near_m.push_back(plane_m);
        };
        for (std::size_t i = 0; i < places_m.size();) {
            const Bracket at = bracket(planes_m, places_m[i]);
            const double from_m = planes_m[at.below], to_m = planes_m[at.above];
            std::size_t count = 0;
            for (; i < places_m.size() && bracket(planes_m, places_m[i]).below == at.below; ++i)
                ++count;
            if (count == 1)
                add(at.fraction < 0.5 ? from_m : to_m);
            for (std::size_t k = 0; count > 1 && k <= count; ++k)
                add(std::lerp(from_m, to_m, static_cast<double>(k) / static_cast<double>(count)));
        }
        return near_m;
    }
    /// From a plane before the first to a plane behind the last one where there is gas.
    std::array<double, 2> rangeOf_m(std::size_t axis) const {
        const std::vector<double>& planes_m = field_.axes_m()[axis];
        const PlaneRange& range = ranges_[axis];
        return {planes_m[range.first > 0 ? range.first - 1 : 0],
                planes_m[std::min(range.last + 1, planes_m.size() - 1)]};
    }
    /// In all, by the most of each pair of planes.
    double all(std::size_t axis) const {
        double sum = 0.0;
        for (const double change : changes_[axis])
            sum += change;
        return sum;
    }
    /// Of so many cells of the range: the root of the change per length, since a wall that bends
    /// needs less.
    std::vector<double> density(std::size_t axis, std::size_t cells) const {
        const std::vector<double>& planes_m = field_.axes_m()[axis];
        const auto [from_m, to_m] = rangeOf_m(axis);
        std::vector<double> density;
        for (std::size_t i = 0; i < cells; ++i) {
            const double at_m = std::lerp(
                from_m, to_m, (static_cast<double>(i) + 0.5) / static_cast<double>(cells));
            const std::size_t below = bracket(planes_m, at_m).below;
            density.push_back(
                std::sqrt(changes_[axis][below] / (planes_m[below + 1] - planes_m[below])));
        }
        return density;
    }

  private:
    const PlumeField& field_;
    std::array<std::vector<double>, 3> changes_;
    std::array<PlaneRange, 3> ranges_;
};

/// Planes where the temperature changes, and how many.
PlumeField::Axes axesOf(const Changes& changes, std::size_t nodes) {
    constexpr std::size_t cells = 512;
    constexpr double even = 0.15, unlike = 1.6;
    std::array<double, 3> all{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        all[axis] = std::max(changes.all(axis), 1e-9);
    const double mean = std::cbrt(all[0] * all[1] * all[2]);
    std::array<double, 3> shares{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        shares[axis] = std::clamp(all[axis] / mean, 1.0 / unlike, unlike);
    const double each = std::cbrt(static_cast<double>(nodes) / (shares[0] * shares[1] * shares[2]));
    PlumeField::Axes axes_m;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto count =
            std::max<std::size_t>(3, static_cast<std::size_t>(std::lround(each * shares[axis])));
        const auto [from_m, to_m] = changes.rangeOf_m(axis);
        axes_m[axis] = changes.planesNear(
            axis, planesByDensity(from_m, to_m, changes.density(axis, cells), even, count));
    }
    return axes_m;
}

/// Corners of the tetrahedra of a cell, by bits 1, 2, 4 for the far ends of its three axes; in
/// every second cell with bit 1 turned over.
constexpr std::array<std::array<std::size_t, 4>, 5> tetrahedra = {
    {{0, 1, 2, 4}, {3, 1, 2, 7}, {5, 1, 4, 7}, {6, 2, 4, 7}, {1, 2, 4, 7}}};

} // namespace

FieldWalls::FieldWalls(const PlumeField& field, double coldest_K, std::size_t nodes) {
    if (nodes < 8)
        throw LogicError("walls of a field with fewer nodes than a cell has");
    const Changes changes(field, coldest_K);
    axes_m_ = axesOf(changes, nodes);
    double lowest_K = std::numeric_limits<double>::infinity(), hottest_K = -lowest_K;
    for (const PlumeField::Node& node : field.nodes())
        if (node.isGas) {
            lowest_K = std::min(lowest_K, static_cast<double>(node.temperature_K));
            hottest_K = std::max(hottest_K, static_cast<double>(node.temperature_K));
        }
    const double span_K = hottest_K - lowest_K + 1.0;
    nothing_K_ = lowest_K - 0.5 * span_K;
    const double outside_K = lowest_K - span_K;
    // Surfaces end in a thin layer, each at its own depth.
    constexpr double thin = 1e-3; // of the largest extent
    double largest_m = 0.0;
    for (const std::vector<double>& planes_m : axes_m_)
        largest_m = std::max(largest_m, planes_m.back() - planes_m.front());
    for (std::vector<double>& planes_m : axes_m_) {
        planes_m.insert(planes_m.begin(), planes_m.front() - thin * largest_m);
        planes_m.push_back(planes_m.back() + thin * largest_m);
    }
    const std::array<std::size_t, 3> last{axes_m_[0].size() - 1, axes_m_[1].size() - 1,
                                          axes_m_[2].size() - 1};
    nodes_K_.assign((last[0] + 1) * (last[1] + 1) * (last[2] + 1), outside_K);
    parallelFor(last[0] + 1, [&](std::size_t x) {
        for (std::size_t y = 1; y < last[1] && x > 0 && x < last[0]; ++y)
            for (std::size_t z = 1; z < last[2]; ++z) {
                const GasVector place_m{axes_m_[0][x], axes_m_[1][y], axes_m_[2][z]};
                if (field.isGasAt(place_m))
                    nodes_K_[numberOf(x, y, z)] = field.at(place_m).temperature_K;
            }
    });
    compareVolumes(field, coldest_K, hottest_K);
}

void FieldWalls::compareVolumes(const PlumeField& field, double coldest_K, double hottest_K) {
    constexpr std::size_t steps = 4000;
    if (!(hottest_K > coldest_K))
        return;
    for (std::size_t i = 0; i <= steps; ++i) { // closer where it is cold, by squares
        const double root = 1.0 - static_cast<double>(i) / steps;
        levels_K_.push_back(std::lerp(coldest_K, hottest_K, root * root));
    }
    fieldFrom_m3_.assign(steps + 1, 0.0);
    ownFrom_m3_.assign(steps + 1, 0.0);
    const auto add = [&](std::vector<double>& volumes_m3, double temperature_K, double volume_m3) {
        if (temperature_K < coldest_K)
            return;
        const double part =
            std::min(1.0, std::sqrt((temperature_K - coldest_K) / (hottest_K - coldest_K)));
        volumes_m3[static_cast<std::size_t>(std::ceil((1.0 - part) * steps))] += volume_m3;
    };
    field.forEachBox([&](const PlumeField::Box& box) {
        add(fieldFrom_m3_, box.gas.temperature_K, box.volume_m3);
        add(ownFrom_m3_, temperature_K(box.middle_m), box.volume_m3);
    });
    std::partial_sum(fieldFrom_m3_.begin(), fieldFrom_m3_.end(), fieldFrom_m3_.begin());
    std::partial_sum(ownFrom_m3_.begin(), ownFrom_m3_.end(), ownFrom_m3_.begin());
}

double FieldWalls::levelFor(double from_K) const {
    if (levels_K_.empty() || from_K <= levels_K_.back())
        return from_K > 0.0 ? from_K : nothing_K_;
    const double volume_m3 = interpolate(levels_K_, fieldFrom_m3_, from_K);
    return interpolate(ownFrom_m3_, levels_K_, volume_m3);
}

GasVector FieldWalls::placeOf(std::size_t node) const {
    const std::size_t z = node % axes_m_[2].size(), row = node / axes_m_[2].size();
    return {axes_m_[0][row / axes_m_[1].size()], axes_m_[1][row % axes_m_[1].size()],
            axes_m_[2][z]};
}

FieldWalls::Surface FieldWalls::surfaceFrom(double from_K) const {
    const double level_K = levelFor(from_K);
    Surface surface;
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    const auto vertexOn = [&](std::size_t one, std::size_t other) {
        const std::size_t lower = std::min(one, other), upper = std::max(one, other);
        const auto [found, isNew] = known.try_emplace(std::uint64_t{lower} << 32 | upper,
                                                      static_cast<std::uint32_t>(known.size()));
        if (isNew) {
            // Away from the nodes, so that no two vertices of different edges come together.
            constexpr double clear = 0.01;
            const double part =
                std::lerp(clear, 1.0 - clear,
                          (level_K - nodes_K_[lower]) / (nodes_K_[upper] - nodes_K_[lower]));
            const GasVector from = placeOf(lower);
            surface.vertices_m.push_back(sumOf(from, differenceOf(placeOf(upper), from), part));
        }
        return found->second;
    };
    const auto addTriangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                 const GasVector& out) {
        const auto& at = surface.vertices_m;
        if (dotOf(crossOf(differenceOf(at[b], at[a]), differenceOf(at[c], at[a])), out) < 0.0)
            std::swap(b, c);
        surface.triangles.push_back({a, b, c});
    };
    const auto addTetrahedron = [&](const std::array<std::size_t, 4>& corners) {
        std::array<std::size_t, 4> ordered{}; // inside first
        std::size_t inside = 0, outside = 4;
        for (const std::size_t corner : corners)
            (nodes_K_[corner] >= level_K ? ordered[inside++] : ordered[--outside]) = corner;
        if (inside == 0 || inside == 4)
            return;
        GasVector out{};
        for (std::size_t i = 0; i < 4; ++i)
            out = sumOf(out, placeOf(ordered[i]),
                        i < inside ? -1.0 / static_cast<double>(inside)
                                   : 1.0 / static_cast<double>(4 - inside));
        const auto on = [&](std::size_t i, std::size_t j) {
            return vertexOn(ordered[i], ordered[j]);
        };
        if (inside == 1) {
            addTriangle(on(0, 1), on(0, 2), on(0, 3), out);
        } else if (inside == 3) {
            addTriangle(on(0, 3), on(1, 3), on(2, 3), out);
        } else {
            const std::uint32_t a = on(0, 2), b = on(0, 3), c = on(1, 3), d = on(1, 2);
            addTriangle(a, b, c, out);
            addTriangle(a, c, d, out);
        }
    };
    for (std::size_t x = 0; x + 1 < axes_m_[0].size(); ++x)
        for (std::size_t y = 0; y + 1 < axes_m_[1].size(); ++y)
            for (std::size_t z = 0; z + 1 < axes_m_[2].size(); ++z) {
                std::array<std::size_t, 8> cell{};
                bool isIn = false, isOut = false;
                const std::size_t turned = (x + y + z) % 2;
                for (std::size_t corner = 0; corner < 8; ++corner) {
                    const std::size_t own = corner ^ turned;
                    cell[corner] = numberOf(x + (own & 1), y + (own >> 1 & 1), z + (own >> 2 & 1));
                    (nodes_K_[cell[corner]] >= level_K ? isIn : isOut) = true;
                }
                for (const auto& of : tetrahedra)
                    if (isIn && isOut)
                        addTetrahedron({cell[of[0]], cell[of[1]], cell[of[2]], cell[of[3]]});
            }
    return surface;
}

double FieldWalls::temperature_K(const GasVector& place_m) const {
    std::array<std::size_t, 3> below{};
    GasVector part{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Bracket found = bracket(axes_m_[axis], place_m[axis]);
        below[axis] = found.below;
        part[axis] = found.fraction;
    }
    const std::size_t turned = (below[0] + below[1] + below[2]) % 2;
    if (turned == 1)
        part[0] = 1.0 - part[0];
    const auto at_K = [&](std::size_t corner) {
        const std::size_t own = corner ^ turned;
        return nodes_K_[numberOf(below[0] + (own & 1), below[1] + (own >> 1 & 1),
                                 below[2] + (own >> 2 & 1))];
    };
    // In the tetrahedron about a corner by the distances from it along its edges, else in the
    // middle one.
    for (const std::size_t corner : {0, 3, 5, 6}) {
        double left = 1.0, sum_K = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double away = (corner >> axis & 1) != 0 ? 1.0 - part[axis] : part[axis];
            left -= away;
            sum_K += away * at_K(corner ^ (std::size_t{1} << axis));
        }
        if (left >= 0.0)
            return sum_K + left * at_K(corner);
    }
    const double far = 0.5 * (part[0] + part[1] + part[2] - 1.0);
    return (part[0] - far) * at_K(1) + (part[1] - far) * at_K(2) + (part[2] - far) * at_K(4) +
           far * at_K(7);
}

} // namespace irsg

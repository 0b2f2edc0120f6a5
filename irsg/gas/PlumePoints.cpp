#include "irsg/gas/PlumePoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/gas/GasMean.h"
#include "irsg/gas/NearestPoints.h"
#include "irsg/gas/PlumeColumns.h"

namespace irsg {

namespace {

using Axes = PlumeField::Axes;

constexpr std::size_t neighbours = 16, mostNodes = 300000;

bool areEqual(const PlumeField::Node& a, const PlumeField::Node& b) {
    return a.temperature_K == b.temperature_K && a.pressure_atm == b.pressure_atm &&
           a.moleFraction == b.moleFraction && a.oxygenFraction == b.oxygenFraction &&
           a.soot_ppmv == b.soot_ppmv;
}

/// By x, then y, then z, each place once.
void sortPoints(std::vector<PlumePoint>& points, const std::string& name) {
    std::ranges::sort(points, [](const PlumePoint& a, const PlumePoint& b) {
        return std::pair(a.place_m, a.line) < std::pair(b.place_m, b.line);
    });
    std::vector<Diagnostic> diagnostics;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PlumePoint &one = points[i - 1], &next = points[i];
        if (one.place_m == next.place_m && !areEqual(one.gas, next.gas))
            diagnostics.push_back(
                {name, "line " + std::to_string(next.line),
                 "x = " + numberText(next.place_m[0]) + ", y = " + numberText(next.place_m[1]) +
                     ", z = " + numberText(next.place_m[2]) + " again, as in line " +
                     std::to_string(one.line) + ", with another gas",
                 "one gas at each place"});
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    const auto [first, last] =
        std::ranges::unique(points, {}, [](const PlumePoint& point) { return point.place_m; });
    points.erase(first, last);
}

/// Their coordinates along each axis, each once.
Axes coordinatesOf(const std::vector<PlumePoint>& points) {
    Axes axes_m;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const PlumePoint& point : points)
            axes_m[axis].push_back(point.place_m[axis]);
        std::ranges::sort(axes_m[axis]);
        const auto [first, last] = std::ranges::unique(axes_m[axis]);
        axes_m[axis].erase(first, last);
    }
    return axes_m;
}

/// Nodes of a field between points.
class PointField {
  public:
    explicit PointField(const std::vector<PlumePoint>& points)
        : points_(points), near_([&] {
              std::vector<GasVector> places_m;
              places_m.reserve(points.size());
              for (const PlumePoint& point : points)
                  places_m.push_back(point.place_m);
              return places_m;
          }()) {}

    /// Planes follow the distances of points that absorb.
    Axes axesFor(const Axes& coordinates_m) const {
        constexpr std::size_t cells = 256, looks = 20000;
        constexpr double even = 0.2;
        std::array<std::vector<double>, 3> density;
        std::array<double, 3> wanted{};
        const std::size_t step = std::max<std::size_t>(points_.size() / looks, 1);
        std::array<std::vector<double>, 3> weights;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            density[axis].assign(cells, 0.0);
            weights[axis].assign(cells, 0.0);
        }
        double most = 0.0;
        for (const PlumePoint& point : points_)
            most = std::max(most, thinAbsorption(point.gas.gas()));
        for (std::size_t i = 0; i < points_.size(); i += step) {
            const double absorbs = thinAbsorption(points_[i].gas.gas());
            constexpr double counts = 1e-2; // of the most
            if (absorbs < counts * most)
                continue;
            std::array<NearestPoints::Found, around + 1> found{};
            const std::size_t count = near_.nearest(points_[i].place_m, found);
            const double apart_m = std::sqrt(found[count - 1].distance2_m2);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double from_m = coordinates_m[axis].front();
                const double part =
                    (points_[i].place_m[axis] - from_m) / (coordinates_m[axis].back() - from_m);
                const auto cell = std::min(static_cast<std::size_t>(part * cells), cells - 1);
                density[axis][cell] += absorbs / apart_m;
                weights[axis][cell] += absorbs;
            }
        }
        double all = 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double extent_m = coordinates_m[axis].back() - coordinates_m[axis].front();
            for (std::size_t i = 0; i < cells; ++i)
                if (weights[axis][i] > 0.0) {
                    density[axis][i] /= weights[axis][i];
                    wanted[axis] += density[axis][i] * extent_m / cells;
                }
            wanted[axis] = std::max(wanted[axis] / (1.0 - even), 1.0);
            all *= wanted[axis];
        }
        const double larger = std::cbrt(static_cast<double>(mostNodes) / all);
        Axes axes_m;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            constexpr double finer = 1.5, fewest = 12.0, many = 400.0;
            const double count = std::clamp(wanted[axis] * std::min(finer, larger), fewest, many);
            axes_m[axis] = planesByDensity(coordinates_m[axis].front(), coordinates_m[axis].back(),
                                           density[axis], even, static_cast<std::size_t>(count));
        }
        return axes_m;
    }

    PlumeField::Node nodeAt(const GasVector& place_m) const {
        std::array<NearestPoints::Found, neighbours> found{};
        const std::size_t count = near_.nearest(place_m, found);
        const std::span<const NearestPoints::Found> all(found.data(), count);
        const PlumeField::Node& nearest = points_[all.front().number].gas;
        if (isOutside(all)) {
            PlumeField::Node node = nearest;
            node.isGas = false;
            return node;
        }
        if (all.front().distance2_m2 == 0.0)
            return nearest;
        GasMean mean;
        const std::vector<double> weights = weightsOf(all, place_m);
        for (std::size_t i = 0; i < count; ++i)
            mean.add(points_[all[i].number].gas.gas(), weights[i]);
        return within(mean.mean(), all);
    }

  private:
    static constexpr std::size_t around = 6; ///< neighbours of a node of a cubic grid

    /// Whether a place is farther from the nearest point than one and a quarter of the distance to
    /// that point's own sixth neighbour.
    bool isOutside(std::span<const NearestPoints::Found> all) const {
        constexpr double farther = 1.25;
        const GasVector& nearest_m = points_[all.front().number].place_m;
        std::vector<double> distances2_m2;
        for (const NearestPoints::Found& one : all.subspan(1)) {
            const GasVector away_m = differenceOf(points_[one.number].place_m, nearest_m);
            distances2_m2.push_back(dotOf(away_m, away_m));
        }
        const auto sixth = distances2_m2.begin() +
                           static_cast<std::ptrdiff_t>(std::min(around, distances2_m2.size()) - 1);
        std::ranges::nth_element(distances2_m2, sixth);
        return all.front().distance2_m2 > farther * farther * *sixth;
    }

    /// Of the values at the nearest points, for the value at a place of the linear function that
    /// fits them best by inverse squares of their distances. Points nearly in a plane or on a line
    /// say nothing across it.
    std::vector<double> weightsOf(std::span<const NearestPoints::Found> all,
                                  const GasVector& place_m) const {
        const double reach_m = std::sqrt(all.back().distance2_m2) * 1.001;
        std::vector<double> weights;
        std::vector<GasVector> from_m; // in parts of the reach
        double sum = 0.0;
        GasVector first{};
        std::array<std::array<double, 3>, 3> second{};
        for (const NearestPoints::Found& one : all) {
            const double distance_m = std::sqrt(one.distance2_m2);
            const double falls = (reach_m - distance_m) / distance_m;
            weights.push_back(falls * falls);
            GasVector& away = from_m.emplace_back();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                away[axis] = (points_[one.number].place_m[axis] - place_m[axis]) / reach_m;
                first[axis] += weights.back() * away[axis];
            }
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    second[i][k] += weights.back() * away[i] * away[k];
            sum += weights.back();
        }
        constexpr double flat = 1e-4;
        const double ridge = flat * (second[0][0] + second[1][1] + second[2][2]);
        for (std::size_t i = 0; i < 3; ++i)
            second[i][i] += ridge;
        const GasVector slope = solved(second, first);
        for (std::size_t i = 0; i < weights.size(); ++i)
            weights[i] *= 1.0 - dotOf(slope, from_m[i]);
        double left = 0.0;
        for (const double weight : weights)
            left += weight;
        if (!(left > 1e-6 * sum)) // as for points on one side of the place
            weights.assign(weights.size(), 1.0);
        return weights;
    }

    /// The x of a positive definite a x = b, by Cramer's rule.
    static GasVector solved(const std::array<std::array<double, 3>, 3>& a, const GasVector& b) {
        const auto minor = [&](std::size_t i, std::size_t k) {
            const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3,
                              k2 = (k + 2) % 3;
            return a[i1][k1] * a[i2][k2] - a[i1][k2] * a[i2][k1];
        };
        const double determinant =
            a[0][0] * minor(0, 0) + a[0][1] * minor(0, 1) + a[0][2] * minor(0, 2);
        GasVector x{};
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 3; ++i)
                x[k] += minor(i, k) * b[i] / determinant;
        return x;
    }

    /// Not beyond the values at the nearest points.
    PlumeField::Node within(GasLayer gas, std::span<const NearestPoints::Found> all) const {
        for (const PlumeColumn& column : plumeGasColumns()) {
            double least = std::numeric_limits<double>::infinity(), most = -least;
            for (const NearestPoints::Found& one : all) {
                GasLayer own = points_[one.number].gas.gas();
                least = std::min(least, column.of(own));
                most = std::max(most, column.of(own));
            }
            column.of(gas) = std::clamp(column.of(gas), least, most);
        }
        return PlumeField::Node::of(gas);
    }

    const std::vector<PlumePoint>& points_;
    NearestPoints near_;
};

} // namespace

bool arePlumePoints(const CsvTable& csv) {
    return hasPlumePlace(csv, "y") || hasPlumePlace(csv, "z");
}

PlumeField readPlumePoints(const CsvTable& csv) {
    std::vector<PlumePoint> points;
    points.reserve(csv.rows().size());
    readPlumeRows(
        csv, {"x", "y", "z"},
        [&](const PlumeRow& row) {
            points.push_back({row.place_m, PlumeField::Node::of(row.gas), row.line});
        },
        [&](const PlumeRow& row) {
            constexpr double farthest_m = 1e6;
            std::vector<Diagnostic> wrong;
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (std::abs(row.place_m[axis]) > farthest_m)
                    wrong.push_back(csv.diagnostic(row.line,
                                                   std::string(1, "xyz"[axis]) + " = " +
                                                       numberText(row.place_m[axis]),
                                                   "a place within 1e6 m of the nozzle"));
            return wrong;
        });
    return fieldOfPoints(std::move(points), csv.file());
}

PlumeField fieldOfPoints(std::vector<PlumePoint> points, const std::string& name) {
    constexpr std::size_t fewest = 8;
    constexpr double thinnest_m = 1e-3;
    sortPoints(points, name);
    Axes axes_m = coordinatesOf(points);
    std::vector<Diagnostic> diagnostics;
    if (points.size() < fewest)
        diagnostics.push_back({name, "", std::to_string(points.size()) + " points", "8 at least"});
    for (std::size_t axis = 0; axis < 3 && diagnostics.empty(); ++axis)
        if (axes_m[axis].back() - axes_m[axis].front() < thinnest_m)
            diagnostics.push_back({name, "",
                                   std::string("all points at ") + "xyz"[axis] + " = " +
                                       numberText(axes_m[axis].front()) + " m",
                                   "points in three dimensions; those of a plume about an axis "
                                   "have x and r"});
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
    std::vector<PlumeField::Node> nodes;
    if (axes_m[0].size() * axes_m[1].size() * axes_m[2].size() == points.size()) {
        nodes.reserve(points.size());
        for (const PlumePoint& point : points)
            nodes.push_back(point.gas);
        return PlumeField::ofNodes(std::move(axes_m), std::move(nodes));
    }
    const PointField between(points);
    axes_m = between.axesFor(axes_m);
    const std::size_t rows = axes_m[1].size() * axes_m[2].size();
    nodes.resize(axes_m[0].size() * rows);
    parallelFor(axes_m[0].size(), [&](std::size_t x) {
        for (std::size_t y = 0; y < axes_m[1].size(); ++y)
            for (std::size_t z = 0; z < axes_m[2].size(); ++z)
                nodes[x * rows + y * axes_m[2].size() + z] =
                    between.nodeAt({axes_m[0][x], axes_m[1][y], axes_m[2][z]});
    });
    return PlumeField::ofNodes(std::move(axes_m), std::move(nodes));
}

} // namespace irsg

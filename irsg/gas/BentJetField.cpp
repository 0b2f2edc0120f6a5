#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "irsg/core/ParallelFor.h"
#include "irsg/gas/BentJet.h"

namespace irsg {

namespace {

/// What a field wants to know of a section.
struct Disc {
    double along_m = 0.0;
    GasVector place_m, along;
    double reach_m = 0.0; ///< where a hundredth of what is on the axis is left
    double half_m = 0.0;  ///< where half of it is left
};

/// How far from the axis the temperature above the air's is such a part of that on the axis.
double radiusOf_m(const PlumeTable& table, double along_m, double part) {
    const double air_K = table.node(table.x_m().size() - 1, table.r_m().size() - 1).temperature_K;
    const double axis_K = table.at(along_m, 0.0).temperature_K - air_K;
    double least_m = 0.0, most_m = table.r_m().back();
    for (int i = 0; i < 40; ++i) {
        const double middle_m = 0.5 * (least_m + most_m);
        (table.at(along_m, middle_m).temperature_K - air_K > part * axis_K ? least_m : most_m) =
            middle_m;
    }
    return most_m;
}

std::vector<Disc> discsOf(const BentJet::Flow& flow) {
    constexpr int count = 300;
    std::vector<Disc> discs;
    for (int i = 0; i <= count; ++i) { // by squares, as the nodes of its table
        const double part = static_cast<double>(i) / count;
        const BentJet::Section at = flow.axisAt(flow.sections.back().along_m * part * part);
        discs.push_back({at.along_m, at.place_m, at.along, radiusOf_m(flow.table, at.along_m, 0.01),
                         radiusOf_m(flow.table, at.along_m, 0.5)});
    }
    return discs;
}

/// Planes across an axis as close as the sections that they meet want.
struct Planes {
    double from_m = 0.0, to_m = 0.0;
    std::vector<double> density; ///< of equal cells of the range, per m
    double wanted = 0.0;         ///< how many that makes
};

Planes planesOf(const std::vector<Disc>& discs, std::size_t axis) {
    constexpr std::size_t cells = 1024;
    constexpr double ofHalf = 0.2, ofDiameter = 0.05; // widths of cells across and along the jet
    constexpr double ofDistance = 0.05;
    Planes planes;
    const auto tilted = [&](const Disc& disc) { // how much of a disc lies along the axis
        return std::sqrt(std::max(0.0, 1.0 - disc.along[axis] * disc.along[axis]));
    };
    planes.from_m = planes.to_m = discs.front().place_m[axis];
    for (const Disc& disc : discs) {
        const double half_m = disc.reach_m * tilted(disc);
        planes.from_m = std::min(planes.from_m, disc.place_m[axis] - half_m);
        planes.to_m = std::max(planes.to_m, disc.place_m[axis] + half_m);
    }
    planes.density.assign(cells, 0.0);
    const double cell_m = (planes.to_m - planes.from_m) / cells;
    const double diameter_m = 2.0 * discs.front().reach_m;
    const auto cellOf = [&](double at_m) {
        return std::min(static_cast<std::size_t>(std::max(0.0, (at_m - planes.from_m) / cell_m)),
                        cells - 1);
    };
    for (std::size_t i = 0; i < discs.size(); ++i) {
        const Disc& disc = discs[i];
        const Disc& next = discs[std::min(i + 1, discs.size() - 1)];
        const double across = tilted(disc);
        const double wanted_per_m =
            across / std::max(ofHalf * disc.half_m, ofDiameter * diameter_m) +
            std::abs(disc.along[axis]) / std::max(ofDistance * disc.along_m, 0.2 * diameter_m);
        const double first_m =
            std::min(disc.place_m[axis], next.place_m[axis]) - across * disc.reach_m;
        const double last_m =
            std::max(disc.place_m[axis], next.place_m[axis]) + across * disc.reach_m;
        for (std::size_t k = cellOf(first_m); k <= cellOf(last_m); ++k)
            planes.density[k] = std::max(planes.density[k], wanted_per_m);
    }
    for (const double per_m : planes.density)
        planes.wanted += per_m * cell_m;
    return planes;
}

/// The state at a place: of the section that goes through it.
PlumeField::Node nodeAt(const std::vector<Disc>& discs, const PlumeTable& table,
                        const GasVector& place_m) {
    const auto before = [&](const Disc& disc) { // how far the place is behind a section
        return dotOf(differenceOf(place_m, disc.place_m), disc.along);
    };
    PlumeField::Node hottest =
        PlumeField::Node::of(table.node(table.x_m().size() - 1, table.r_m().size() - 1));
    hottest.isGas = false;
    double here = before(discs.front());
    constexpr double rounding = -1e-9; // of the diameter
    if (here < 0.0 && here > rounding * discs.front().reach_m)
        here = 0.0;
    for (std::size_t i = 0; i + 1 < discs.size(); ++i) {
        const double next = before(discs[i + 1]);
        if (here >= 0.0 && next < 0.0) {
            const double part = here / (here - next);
            const GasVector axis_m =
                sumOf(discs[i].place_m, differenceOf(discs[i + 1].place_m, discs[i].place_m), part);
            const PlumeField::Node own = PlumeField::Node::of(
                table.at(std::lerp(discs[i].along_m, discs[i + 1].along_m, part),
                         lengthOf(differenceOf(place_m, axis_m))));
            if (!hottest.isGas || own.temperature_K > hottest.temperature_K)
                hottest = own;
        }
        here = next;
    }
    return hottest;
}

} // namespace

PlumeField bentJetField(const BentJet::Flow& flow, std::size_t nodes) {
    constexpr double even = 0.1;
    const std::vector<Disc> discs = discsOf(flow);
    std::array<Planes, 3> planes;
    double all = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        planes[axis] = planesOf(discs, axis);
        all *= planes[axis].wanted;
    }
    const double finer = std::cbrt(static_cast<double>(nodes) / all);
    PlumeField::Axes axes_m;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Planes& of = planes[axis];
        const auto count = std::max<std::size_t>(8, static_cast<std::size_t>(of.wanted * finer));
        axes_m[axis] = planesByDensity(of.from_m, of.to_m, of.density, even, count);
    }
    const std::size_t row = axes_m[2].size();
    std::vector<PlumeField::Node> filled(axes_m[0].size() * axes_m[1].size() * row);
    parallelFor(axes_m[0].size() * axes_m[1].size(), [&](std::size_t i) {
        for (std::size_t z = 0; z < row; ++z)
            filled[i * row + z] = nodeAt(
                discs, flow.table,
                {axes_m[0][i / axes_m[1].size()], axes_m[1][i % axes_m[1].size()], axes_m[2][z]});
    });
    return PlumeField::ofNodes(std::move(axes_m), std::move(filled));
}

} // namespace irsg

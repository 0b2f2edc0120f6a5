#include <algorithm>
#include <cmath>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/gas/GasByTemperature.h"
#include "irsg/gas/GasColumn.h"
#include "irsg/gas/PlumeTable.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// All of a table in rings of a quarter of its cells.
std::vector<PlumePart> ringsOf(const PlumeTable& table) {
    constexpr int perCell = 4;
    std::vector<PlumePart> rings;
    const auto finer = [](const std::vector<double>& nodes, auto visit) {
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
            for (int k = 0; k < perCell; ++k)
                visit(std::lerp(nodes[i], nodes[i + 1], (k + 0.5) / perCell),
                      (nodes[i + 1] - nodes[i]) / perCell);
    };
    finer(table.x_m(), [&](double x_m, double length_m) {
        finer(table.r_m(), [&](double r_m, double width_m) {
            const GasLayer gas = table.at(x_m, r_m);
            rings.push_back({gas, thinAbsorption(gas) * r_m * width_m * length_m});
        });
    });
    return rings;
}

/// How far from the axis the gas at x, a part of the way from a node to the next, is as hot; 0
/// where it is not even there.
double reach_m(const PlumeTable& table, std::size_t x, double from_K, double part = 0.0) {
    const std::vector<double>& r_m = table.r_m();
    const std::size_t next = std::min(x + 1, table.x_m().size() - 1);
    const auto at_K = [&](std::size_t r) {
        return std::lerp(table.node(x, r).temperature_K, table.node(next, r).temperature_K, part);
    };
    for (std::size_t r = r_m.size(); r-- > 0;) {
        const double here_K = at_K(r);
        if (here_K < from_K)
            continue;
        if (r + 1 == r_m.size())
            return r_m[r];
        const double next_K = at_K(r + 1);
        return std::lerp(r_m[r], r_m[r + 1], (here_K - from_K) / (here_K - next_K));
    }
    return 0.0;
}

std::vector<std::vector<std::array<double, 2>>> outlinesOf(const PlumeTable& table, double from_K) {
    std::vector<std::vector<std::array<double, 2>>> outlines;
    const std::vector<double>& x_m = table.x_m();
    bool isIn = false;
    const auto axis_K = [&](std::size_t i) { return table.node(i, 0).temperature_K; };
    // Between nodes i - 1 and i a zone ends round: with steps that shrink towards the axis.
    const auto addTip = [&](std::size_t i, bool isBegin) {
        constexpr int steps = 4;
        const double tip = (from_K - axis_K(i - 1)) / (axis_K(i) - axis_K(i - 1));
        for (int k = 0; k < steps; ++k) {
            const double left = std::pow((isBegin ? k : steps - 1 - k) / double(steps), 2.0);
            const double part = std::lerp(tip, isBegin ? 1.0 : 0.0, left);
            outlines.back().push_back({std::lerp(x_m[i - 1], x_m[i], part),
                                       left > 0.0 ? reach_m(table, i - 1, from_K, part) : 0.0});
        }
    };
    // And bends, where it does, between two nodes.
    const auto addBends = [&](std::size_t i, double from, double fromR_m, double to, double toR_m,
                              const auto& again) -> void {
        constexpr double straight = 0.001, narrowest = 0.1;
        const double middle = 0.5 * (from + to), r_m = reach_m(table, i, from_K, middle);
        if (to - from < narrowest || std::abs(r_m - 0.5 * (fromR_m + toR_m)) < straight * r_m)
            return;
        again(i, from, fromR_m, middle, r_m, again);
        outlines.back().push_back({std::lerp(x_m[i], x_m[i + 1], middle), r_m});
        again(i, middle, r_m, to, toR_m, again);
    };
    double before_m = 0.0;
    for (std::size_t i = 0; i < x_m.size(); ++i) {
        const double r_m = reach_m(table, i, from_K);
        if (r_m > 0.0) {
            if (isIn)
                addBends(i - 1, 0.0, before_m, 1.0, r_m, addBends);
            if (!isIn) {
                outlines.emplace_back();
                if (i > 0)
                    addTip(i, true);
            }
            outlines.back().push_back({x_m[i], r_m});
        } else if (isIn) {
            addTip(i, false);
        }
        isIn = r_m > 0.0;
        before_m = r_m;
    }
    std::erase_if(outlines, [](const auto& outline) { return outline.size() < 2; });
    return outlines;
}

void checkFallsOutwards(const PlumeTable& table) {
    for (std::size_t x = 0; x < table.x_m().size(); ++x)
        for (std::size_t r = 1; r < table.r_m().size(); ++r)
            if (table.node(x, r).temperature_K > table.node(x, r - 1).temperature_K + 1e-6)
                throw InputError({"plume",
                                  "x = " + numberText(table.x_m()[x]) +
                                      " m, r = " + numberText(table.r_m()[r]) + " m",
                                  numberText(table.node(x, r).temperature_K) + " K",
                                  "a temperature that does not rise away from the axis"});
}

} // namespace

std::vector<PlumeZone> plumeZones(const PlumeTable& table, std::size_t count) {
    checkFallsOutwards(table);
    std::vector<PlumeZone> zones; // hottest first
    for (const PlumeRun& run : GasByTemperature(ringsOf(table)).parted(count))
        zones.push_back({run.gas, run.from_K, outlinesOf(table, run.from_K)});
    std::erase_if(zones, [](const PlumeZone& zone) { return zone.outlines_m.empty(); });
    std::ranges::reverse(zones);
    return zones;
}

PlumeIntensities::PlumeIntensities(const PlumeTable& table, const SpectralRange& band, int fineness)
    : band_(band) {
    const int along = 72 * fineness, across = 24 * fineness, deep = 120 * fineness;
    for (const auto& [name, angle_deg] :
         {std::pair("side", 90.0), std::pair("quarter", 45.0), std::pair("tail", 10.0)}) {
        // Zones end at walls, which takes more lines, and are found with fewer steps.
        View& view = views_.emplace_back(
            View{name, sightsOf(table, angle_deg, 2 * along, 2 * across, deep / 2), 0.0});
        const std::vector<Sight> sights = sightsOf(table, angle_deg, along, across, deep);
        std::vector<double> sent(sights.size());
        parallelFor(sights.size(), [&](std::size_t i) {
            const Sight& sight = sights[i];
            std::vector<GasLayer> gases;
            std::vector<GasStretch> column;
            for (std::size_t k = 0; k + 1 < sight.edges_m.size(); ++k) {
                const auto [x_m, r_m] =
                    sight.line.at(0.5 * (sight.edges_m[k] + sight.edges_m[k + 1]));
                column.push_back({gases.size(), sight.edges_m[k] - sight.edges_m[k + 1]});
                gases.push_back(table.at(x_m, r_m));
            }
            if (!column.empty())
                sent[i] = sight.area_m2 * BandSenders(gases, band_).radiance_W_m2_sr(column);
        });
        for (const double of : sent)
            view.intensity_W_sr += of;
    }
}

std::vector<PlumeIntensities::Sight> PlumeIntensities::sightsOf(const PlumeTable& table,
                                                                double angle_deg, int along,
                                                                int across, int deep) {
    const double length_m = table.x_m().back() - table.x_m().front();
    const double radius_m = table.r_m().back();
    const double cosine = std::cos(radians(angle_deg)), sine = std::sin(radians(angle_deg));
    // Lines of sight go along (-cosine, -sine, 0) and stand about the middle of the nozzle in the
    // plane across.
    const double before_m = radius_m * cosine, behind_m = length_m * sine + before_m;
    const int before = static_cast<int>(
        std::ceil(along * std::cbrt(before_m) / (std::cbrt(before_m) + std::cbrt(behind_m))));
    std::vector<Sight> sights;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < across; ++j) {
            // By cubes: what is hot lies near the nozzle and about the axis, and the rule of
            // midpoints wants steps that do not begin with a jump. Shifted from row to row, so that
            // walls of zones lie nowhere among them.
            constexpr double golden = 0.61803398874989485;
            const int steps = i < before ? before : along - before;
            const double end_m = i < before ? before_m : -behind_m;
            const double from = ((i < before ? i : i - before) + 0.5) / steps;
            const double part = (j + std::fmod(0.5 + golden * i, 1.0)) / across;
            Sight sight{{table.x_m().front(), end_m * from * from * from,
                         radius_m * part * part * part, cosine, sine},
                        {},
                        std::abs(end_m) * 3.0 * from * from / steps * 2.0 * radius_m * 3.0 * part *
                            part / across};
            takeSteps(sight, length_m, radius_m, deep);
            if (!sight.edges_m.empty())
                sights.push_back(std::move(sight));
        }
    return sights;
}

std::array<double, 2> PlumeIntensities::Line::at(double s_m) const {
    return {first_m + s_m * cosine - u_m * sine, std::hypot(s_m * sine + u_m * cosine, v_m)};
}

/// Steps through the table, as squares about the place nearest to the axis.
void PlumeIntensities::takeSteps(Sight& sight, double length_m, double radius_m, int steps) {
    const Line& line = sight.line;
    const double half_m = std::sqrt(std::max(radius_m * radius_m - line.v_m * line.v_m, 0.0));
    double last_m = (half_m - line.u_m * line.cosine) / line.sine;
    double first_m = (-half_m - line.u_m * line.cosine) / line.sine;
    constexpr double across = 1e-12; // cosine of a line of sight that does not go along the axis
    const double begin_m = line.u_m * line.sine, end_m = length_m + line.u_m * line.sine;
    if (line.cosine > across) {
        first_m = std::max(first_m, begin_m / line.cosine);
        last_m = std::min(last_m, end_m / line.cosine);
    } else if (begin_m > 0.0 || end_m < 0.0) {
        return;
    }
    if (!(last_m > first_m))
        return;
    const double nearest_m = std::clamp(-line.u_m * line.cosine / line.sine, first_m, last_m);
    const int before =
        static_cast<int>(std::lround(steps * (last_m - nearest_m) / (last_m - first_m)));
    for (int k = 0; k <= steps; ++k) {
        const double part = k < before   ? static_cast<double>(before - k) / before
                            : k > before ? static_cast<double>(k - before) / (steps - before)
                                         : 0.0;
        const double end = k < before ? last_m : first_m;
        sight.edges_m.push_back(std::lerp(nearest_m, end, part * part));
    }
    sight.edges_m.front() = last_m;
    sight.edges_m.back() = first_m;
}

std::vector<PlumeZonesError> PlumeIntensities::errorsOf(const std::vector<PlumeZone>& zones) const {
    const auto isIn = [](const PlumeZone& zone, double x_m, double r_m) {
        return std::ranges::any_of(zone.outlines_m, [&](const auto& outline) {
            if (x_m < outline.front()[0] || x_m > outline.back()[0])
                return false;
            const auto above = std::ranges::lower_bound(
                outline.begin() + 1, outline.end() - 1, x_m, {},
                [](const std::array<double, 2>& place) { return place[0]; });
            const auto& [x1, r1] = *above;
            const auto& [x0, r0] = *(above - 1);
            return r_m < (x1 > x0 ? std::lerp(r0, r1, (x_m - x0) / (x1 - x0)) : r1);
        });
    };
    const std::size_t none = zones.size();
    const auto innermost = [&](const Line& line, double s_m) {
        const auto [x_m, r_m] = line.at(s_m);
        for (std::size_t z = zones.size(); z-- > 0;)
            if (isIn(zones[z], x_m, r_m))
                return z;
        return none;
    };
    std::vector<GasLayer> gases;
    for (const PlumeZone& zone : zones)
        gases.push_back(zone.gas);
    const BandSenders senders(gases, band_);
    std::vector<PlumeZonesError> errors;
    for (const View& view : views_) {
        std::vector<double> sent(view.sights.size());
        parallelFor(view.sights.size(), [&](std::size_t i) {
            const Sight& sight = view.sights[i];
            std::vector<GasStretch> column;
            const auto add = [&](std::size_t zone, double length_m) {
                if (zone == none)
                    return;
                if (!column.empty() && column.back().gas == zone)
                    column.back().length_m += length_m;
                else
                    column.push_back({zone, length_m});
            };
            double at_m = sight.edges_m.front();
            std::size_t here = innermost(sight.line, at_m);
            for (std::size_t k = 1; k < sight.edges_m.size(); ++k) {
                const double next_m = sight.edges_m[k];
                const std::size_t next = innermost(sight.line, next_m);
                while (here != next) { // to where it ends, in all zones between
                    constexpr int halvings = 12;
                    double before_m = at_m, wall_m = next_m;
                    for (int h = 0; h < halvings; ++h) {
                        const double middle_m = 0.5 * (before_m + wall_m);
                        (innermost(sight.line, middle_m) == here ? before_m : wall_m) = middle_m;
                    }
                    add(here, at_m - wall_m);
                    at_m = wall_m;
                    here = innermost(sight.line, wall_m);
                }
                add(here, at_m - next_m);
                at_m = next_m;
            }
            sent[i] = sight.area_m2 * senders.radiance_W_m2_sr(column);
        });
        PlumeZonesError& error = errors.emplace_back();
        error.view = view.name;
        error.table_W_sr = view.intensity_W_sr;
        for (const double of : sent)
            error.zones_W_sr += of;
    }
    return errors;
}

} // namespace irsg

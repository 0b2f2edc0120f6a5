#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/gas/GasColumn.h"
#include "irsg/gas/PlumeTable.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// What the gas at a place absorbs about 4.4 um, thin: only ratios count.
double absorptionOf(const GasLayer& gas) {
    constexpr double sootAsGas = 0.02; // a ppmv absorbs as so much of CO2
    const double fractions = gas.fraction(HotGas::CO2) + 0.3 * gas.fraction(HotGas::H2O) +
                             gas.fraction(HotGas::CO) + gas.fraction(HotGas::CH4) +
                             sootAsGas * gas.soot_ppmv;
    return fractions * gas.pressure_atm / gas.temperature_K;
}

/// A small ring of the plume.
struct Ring {
    GasLayer gas;
    double counts = 0.0; ///< of all rings 1: half by emission, half by absorption
};

/// All of a table in rings of a quarter of its cells, hottest first.
std::vector<Ring> ringsOf(const PlumeTable& table) {
    constexpr int perCell = 4;
    std::vector<Ring> rings;
    std::vector<double> absorbs, emits;
    const auto finer = [](const std::vector<double>& nodes, auto visit) {
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
            for (int k = 0; k < perCell; ++k)
                visit(std::lerp(nodes[i], nodes[i + 1], (k + 0.5) / perCell),
                      (nodes[i + 1] - nodes[i]) / perCell);
    };
    finer(table.x_m(), [&](double x_m, double length_m) {
        finer(table.r_m(), [&](double r_m, double width_m) {
            constexpr double at_um = 4.4;
            Ring ring{table.at(x_m, r_m), 0.0};
            absorbs.push_back(absorptionOf(ring.gas) * r_m * width_m * length_m);
            emits.push_back(absorbs.back() *
                            planckRadiance_W_m2_sr_um(at_um, ring.gas.temperature_K));
            rings.push_back(ring);
        });
    });
    const double allAbsorbs = std::accumulate(absorbs.begin(), absorbs.end(), 0.0);
    const double allEmits = std::accumulate(emits.begin(), emits.end(), 0.0);
    if (!(allEmits > 0.0))
        throw InputError({"plume", "", "no CO2, H2O, CO, CH4 or soot", "a gas that emits"});
    for (std::size_t i = 0; i < rings.size(); ++i)
        rings[i].counts = 0.5 * (absorbs[i] / allAbsorbs + emits[i] / allEmits);
    std::ranges::sort(rings, std::greater(), [](const Ring& r) { return r.gas.temperature_K; });
    return rings;
}

/// Of rings that follow one another, weighted with what they count.
GasLayer meanOf(std::span<const Ring> rings) {
    GasLayer mean;
    mean.temperature_K = mean.pressure_atm = 0.0;
    double all = 0.0;
    for (const Ring& ring : rings) {
        const GasLayer& gas = ring.gas;
        all += ring.counts;
        mean.temperature_K += ring.counts * gas.temperature_K;
        mean.pressure_atm += ring.counts * gas.pressure_atm;
        for (std::size_t g = 0; g < hotGasCount; ++g)
            mean.moleFraction[g] += ring.counts * gas.moleFraction[g];
        mean.oxygenFraction += ring.counts * gas.oxygenFraction;
        mean.soot_ppmv += ring.counts * gas.soot_ppmv;
    }
    for (double* value :
         {&mean.temperature_K, &mean.pressure_atm, &mean.oxygenFraction, &mean.soot_ppmv})
        *value /= all;
    for (double& fraction : mean.moleFraction)
        fraction /= all;
    return mean;
}

/// Ends of runs of rings, hottest first, at most `count` of them, in which temperatures differ
/// least (W. D. Fisher 1958, J. Am. Stat. Assoc. 53, 789): as their roots above the coldest, for
/// which zones of jets leave the least errors from all sides, rings counting as they
/// do. Rings of one temperature stay together.
std::vector<std::size_t> parted(const std::vector<Ring>& rings, std::size_t count) {
    constexpr double steps = 400.0;
    const double coldest_K = rings.back().gas.temperature_K;
    const auto rootOf = [&](const Ring& ring) {
        return std::sqrt(ring.gas.temperature_K - coldest_K);
    };
    const double highest = rootOf(rings.front()), lowest = rootOf(rings.back());
    struct Sums {
        std::size_t end = 0; ///< ring
        double weight = 0.0, first = 0.0, second = 0.0;
    };
    std::vector<Sums> sums(1); // of all rings before the end of each step
    double step = -1.0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const double root = rootOf(rings[i]);
        const double own =
            highest > lowest ? std::floor(steps * (highest - root) / (highest - lowest)) : 0.0;
        if (std::exchange(step, own) != own)
            sums.push_back(sums.back());
        Sums& all = sums.back();
        all.end = i + 1;
        all.weight += rings[i].counts;
        all.first += rings[i].counts * root;
        all.second += rings[i].counts * root * root;
    }
    const auto costOf = [&](std::size_t from, std::size_t to) {
        const double weight = sums[to].weight - sums[from].weight;
        const double first = sums[to].first - sums[from].first;
        return weight > 0.0 ? sums[to].second - sums[from].second - first * first / weight : 0.0;
    };
    const std::size_t all = sums.size() - 1, most = std::min(count, all);
    // Of the steps before each one in so many runs: the least cost, and where the last begins.
    std::vector<std::vector<std::pair<double, std::size_t>>> best(most + 1);
    best[0].assign(all + 1, {std::numeric_limits<double>::infinity(), 0});
    best[0][0].first = 0.0;
    for (std::size_t runs = 1; runs <= most; ++runs) {
        best[runs].assign(all + 1, best[0][1]);
        for (std::size_t to = runs; to <= all; ++to)
            for (std::size_t from = runs - 1; from < to; ++from) {
                const double cost = best[runs - 1][from].first + costOf(from, to);
                if (cost < best[runs][to].first)
                    best[runs][to] = {cost, from};
            }
    }
    std::vector<std::size_t> ends;
    for (std::size_t runs = most, to = all; runs > 0; to = best[runs--][to].second)
        ends.push_back(sums[to].end);
    std::ranges::reverse(ends);
    return ends;
}

/// How far from the axis the gas of a node x is as hot; 0 where it is not even there.
double reach_m(const PlumeTable& table, std::size_t x, double from_K) {
    const std::vector<double>& r_m = table.r_m();
    for (std::size_t r = r_m.size(); r-- > 0;) {
        const double here_K = table.node(x, r).temperature_K;
        if (here_K < from_K)
            continue;
        if (r + 1 == r_m.size())
            return r_m[r];
        const double next_K = table.node(x, r + 1).temperature_K;
        return std::lerp(r_m[r], r_m[r + 1], (here_K - from_K) / (here_K - next_K));
    }
    return 0.0;
}

std::vector<std::vector<std::array<double, 2>>> outlinesOf(const PlumeTable& table, double from_K) {
    std::vector<std::vector<std::array<double, 2>>> outlines;
    const std::vector<double>& x_m = table.x_m();
    bool isIn = false;
    const auto axis_K = [&](std::size_t i) { return table.node(i, 0).temperature_K; };
    const auto tip = [&](std::size_t i) -> std::array<double, 2> { // between nodes i - 1 and i
        const double part = (from_K - axis_K(i - 1)) / (axis_K(i) - axis_K(i - 1));
        return {std::lerp(x_m[i - 1], x_m[i], part), 0.0};
    };
    for (std::size_t i = 0; i < x_m.size(); ++i) {
        const double r_m = reach_m(table, i, from_K);
        if (r_m > 0.0) {
            if (!isIn) {
                outlines.emplace_back();
                if (i > 0)
                    outlines.back().push_back(tip(i));
            }
            outlines.back().push_back({x_m[i], r_m});
        } else if (isIn) {
            outlines.back().push_back(tip(i));
        }
        isIn = r_m > 0.0;
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
    std::vector<Ring> rings = ringsOf(table);
    // What is colder than all that counts would be spread over much air.
    constexpr double countsNot = 1e-3;
    double rest = 0.0;
    while (rings.size() > 1 && rest + rings.back().counts < countsNot) {
        rest += rings.back().counts;
        rings.pop_back();
    }
    std::vector<PlumeZone> zones; // hottest first
    std::size_t first = 0;
    for (const std::size_t next : parted(rings, count)) {
        const bool isAll = next == rings.size() && rest == 0.0;
        const double from_K = isAll ? 0.0 : rings[next - 1].gas.temperature_K;
        zones.push_back({meanOf(std::span(rings).subspan(first, next - first)), from_K,
                         outlinesOf(table, from_K)});
        first = next;
    }
    std::erase_if(zones, [](const PlumeZone& zone) { return zone.outlines_m.empty(); });
    std::ranges::reverse(zones);
    return zones;
}

PlumeIntensities::PlumeIntensities(const PlumeTable& table, const SpectralRange& band, int fineness)
    : band_(band) {
    // Zones and table are summed at the same places, at most as fine as the tables of gases.
    constexpr double finest_per_cm = 5.0, coarsest_per_cm = 20.0, about = 30.0;
    const double lower = wavenumberFromWavelength_per_cm(band.max_um);
    const double upper = wavenumberFromWavelength_per_cm(band.min_um);
    const double step_per_cm = std::clamp((upper - lower) / about, finest_per_cm, coarsest_per_cm);
    const auto cells = static_cast<int>(std::ceil((upper - lower) / step_per_cm));
    for (int i = 0; i < cells; ++i) {
        const double from = lower + (upper - lower) * i / cells,
                     to = lower + (upper - lower) * (i + 1) / cells;
        wavenumbers_per_cm_.push_back(0.5 * (from + to));
        widths_um_.push_back(wavelengthFromWavenumber_um(from) - wavelengthFromWavenumber_um(to));
    }
    const int along = 72 * fineness, across = 24 * fineness, steps = 120 * fineness;
    const double length_m = table.x_m().back() - table.x_m().front();
    const double middle_m = 0.5 * (table.x_m().back() + table.x_m().front());
    const double radius_m = table.r_m().back();
    for (const auto& [name, angle_deg] :
         {std::pair("side", 90.0), std::pair("quarter", 45.0), std::pair("tail", 10.0)}) {
        View& view = views_.emplace_back();
        view.name = name;
        const double cosine = std::cos(radians(angle_deg)), sine = std::sin(radians(angle_deg));
        // Lines of sight go along (-cosine, -sine, 0) and stand about the middle in the plane
        // across.
        const double half_m = 0.5 * length_m * sine + radius_m * cosine;
        const double deep_m = 0.5 * length_m * cosine + radius_m * sine;
        for (int i = 0; i < along; ++i)
            for (int j = 0; j < across; ++j) {
                // By squares: what is hot lies near the nozzle and about the axis.
                const double from = (i + 0.5) / along, part = (j + 0.5) / across;
                const double u_m = half_m * (1.0 - 2.0 * from * from), v_m = radius_m * part * part;
                Sight sight;
                sight.area_m2 = 4.0 * half_m * from / along * 2.0 * radius_m * 2.0 * part / across;
                // Likewise along it, about the place nearest to the axis.
                const double nearest_m = -u_m * cosine / sine;
                const double reach_m = deep_m + std::abs(nearest_m);
                for (int k = 0; k < steps; ++k) {
                    const double step = 1.0 - 2.0 * (k + 0.5) / steps;
                    const double s_m = nearest_m + reach_m * step * std::abs(step);
                    const double x_m = middle_m + s_m * cosine - u_m * sine;
                    const double y_m = s_m * sine + u_m * cosine;
                    const double r_m = std::hypot(y_m, v_m);
                    if (x_m < table.x_m().front() || x_m > table.x_m().back() || r_m > radius_m)
                        continue;
                    sight.places_m.push_back({x_m, r_m});
                    sight.lengths_m.push_back(reach_m * 2.0 * std::abs(step) * 2.0 / steps);
                }
                if (!sight.places_m.empty())
                    view.sights.push_back(std::move(sight));
            }
        std::vector<double> sent(view.sights.size());
        parallelFor(view.sights.size(), [&](std::size_t i) {
            std::vector<GasLayer> gases;
            std::vector<std::size_t> places;
            for (const auto& [x_m, r_m] : view.sights[i].places_m) {
                places.push_back(gases.size());
                gases.push_back(table.at(x_m, r_m));
            }
            sent[i] = view.sights[i].area_m2 * radiance(gases, places, view.sights[i].lengths_m);
        });
        for (const double of : sent)
            view.intensity_W_sr += of;
    }
}

double PlumeIntensities::radiance(const std::vector<GasLayer>& gases,
                                  const std::vector<std::size_t>& gasOfPlaces,
                                  const std::vector<double>& lengths_m) const {
    std::vector<GasStretch> column;
    for (std::size_t i = 0; i < gasOfPlaces.size(); ++i)
        if (!column.empty() && column.back().gas == gasOfPlaces[i])
            column.back().length_m += lengths_m[i];
        else
            column.push_back({gasOfPlaces[i], lengths_m[i]});
    if (column.empty())
        return 0.0;
    const auto shares = GasColumns(gases, wavenumbers_per_cm_).shares(column);
    double sum = 0.0;
    for (std::size_t g = 0; g < gases.size(); ++g)
        for (std::size_t i = 0; i < wavenumbers_per_cm_.size(); ++i)
            if (shares[g][i] > 0.0)
                sum +=
                    widths_um_[i] * shares[g][i] *
                    planckRadiance_W_m2_sr_um(wavelengthFromWavenumber_um(wavenumbers_per_cm_[i]),
                                              gases[g].temperature_K);
    return sum;
}

std::vector<PlumeZonesError> PlumeIntensities::errorsOf(const std::vector<PlumeZone>& zones) const {
    const auto isIn = [](const PlumeZone& zone, double x_m, double r_m) {
        return std::ranges::any_of(zone.outlines_m, [&](const auto& outline) {
            if (x_m < outline.front()[0] || x_m > outline.back()[0])
                return false;
            const auto above = std::ranges::find_if(
                outline.begin() + 1, outline.end() - 1,
                [&](const std::array<double, 2>& place) { return place[0] >= x_m; });
            const auto& [x1, r1] = *above;
            const auto& [x0, r0] = *(above - 1);
            return r_m < (x1 > x0 ? std::lerp(r0, r1, (x_m - x0) / (x1 - x0)) : r1);
        });
    };
    std::vector<GasLayer> gases;
    for (const PlumeZone& zone : zones)
        gases.push_back(zone.gas);
    std::vector<PlumeZonesError> errors;
    for (const View& view : views_) {
        std::vector<double> sent(view.sights.size());
        parallelFor(view.sights.size(), [&](std::size_t i) {
            std::vector<std::size_t> places;
            std::vector<double> lengths_m;
            for (std::size_t k = 0; k < view.sights[i].places_m.size(); ++k) {
                const auto& [x_m, r_m] = view.sights[i].places_m[k];
                for (std::size_t z = zones.size(); z-- > 0;) // the innermost
                    if (isIn(zones[z], x_m, r_m)) {
                        places.push_back(z);
                        lengths_m.push_back(view.sights[i].lengths_m[k]);
                        break;
                    }
            }
            sent[i] = view.sights[i].area_m2 * radiance(gases, places, lengths_m);
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

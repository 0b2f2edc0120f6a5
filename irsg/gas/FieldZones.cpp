#include "irsg/gas/FieldZones.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/gas/GasColumn.h"
#include "irsg/gas/GasMean.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Two unit vectors across a direction and each other.
std::array<GasVector, 2> acrossOf(const GasVector& direction) {
    const GasVector other = std::abs(direction[2]) < 0.9 ? GasVector{0, 0, 1} : GasVector{1, 0, 0};
    const GasVector one = unitOf(crossOf(direction, other));
    return {one, crossOf(direction, one)};
}

/// Distances along a line at which it goes through planes of a grid, and between its first and last
/// ones of each axis; those nearest the sensor, the largest ones, first.
std::vector<double> crossings_m(const PlumeField::Axes& axes_m, const GasVector& through_m,
                                const GasVector& towards) {
    constexpr double parallel = 1e-9;
    double first_m = -1e300, last_m = 1e300;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double from_m = axes_m[axis].front() - through_m[axis];
        const double to_m = axes_m[axis].back() - through_m[axis];
        if (std::abs(towards[axis]) < parallel) {
            if (from_m > 0.0 || to_m < 0.0)
                return {};
            continue;
        }
        const double one_m = from_m / towards[axis], other_m = to_m / towards[axis];
        first_m = std::max(first_m, std::min(one_m, other_m));
        last_m = std::min(last_m, std::max(one_m, other_m));
    }
    if (!(last_m > first_m))
        return {};
    std::vector<double> all_m{first_m, last_m};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < axes_m[axis].size() && std::abs(towards[axis]) >= parallel;
             ++i) {
            const double at_m = (axes_m[axis][i] - through_m[axis]) / towards[axis];
            if (at_m > first_m && at_m < last_m)
                all_m.push_back(at_m);
        }
    std::ranges::sort(all_m, std::greater());
    return all_m;
}

/// Of a density at single places, that about them.
std::vector<double> smooth(const std::vector<double>& density) {
    constexpr std::size_t reach = 8; // of hundreds of cells
    std::vector<double> smoothed(density.size(), 0.0);
    for (std::size_t i = 0; i < density.size(); ++i)
        for (std::size_t k = i < reach ? 0 : i - reach; k < std::min(i + reach, density.size());
             ++k)
            smoothed[k] += density[i];
    return smoothed;
}

/// The plane across a view, and where the gas of a field lies in it.
class AcrossView {
  public:
    AcrossView(const PlumeField::Axes& axes_m, const GasVector& towards)
        : directions_(acrossOf(towards)) {
        for (std::size_t corner = 0; corner < 8; ++corner) {
            GasVector place_m{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                place_m[axis] =
                    (corner >> axis & 1) != 0 ? axes_m[axis].back() : axes_m[axis].front();
            for (std::size_t i = 0; i < 2; ++i) {
                const double at_m = dotOf(place_m, directions_[i]);
                first_m_[i] = corner == 0 ? at_m : std::min(first_m_[i], at_m);
                last_m_[i] = corner == 0 ? at_m : std::max(last_m_[i], at_m);
            }
        }
        for (std::vector<double>& density : densities_)
            density.assign(cells, 0.0);
    }
    void add(const GasVector& place_m, double absorbs) {
        for (std::size_t i = 0; i < 2; ++i) {
            const double part =
                (dotOf(place_m, directions_[i]) - first_m_[i]) / (last_m_[i] - first_m_[i]);
            densities_[i][std::min(static_cast<std::size_t>(std::max(part, 0.0) * cells),
                                   cells - 1)] += absorbs;
        }
    }
    /// Between so many lines of sight, which lie closer where more of the gas is.
    std::vector<double> edges_m(std::size_t direction, std::size_t lines) const {
        constexpr double even = 0.5;
        return planesByDensity(first_m_[direction], last_m_[direction],
                               smooth(densities_[direction]), even, lines + 1);
    }
    GasVector placeOf(double u_m, double v_m) const {
        return sumOf(sumOf({}, directions_[0], u_m), directions_[1], v_m);
    }

  private:
    static constexpr std::size_t cells = 512;

    std::array<GasVector, 2> directions_;
    std::array<double, 2> first_m_{}, last_m_{};
    std::array<std::vector<double>, 2> densities_;
};

/// States of gas in cells so small that those of one count as one.
class States {
  public:
    States(const PlumeField& field, int cells) : cells_(cells) {
        for (const PlumeField::Node& node : field.nodes()) {
            const std::array<double, count> values = valuesOf(node.gas());
            for (std::size_t i = 0; i < count; ++i) {
                least_[i] = std::min(least_[i], values[i]);
                most_[i] = std::max(most_[i], values[i]);
            }
        }
    }
    std::uint64_t cellOf(const GasLayer& gas) const {
        const std::array<double, count> values = valuesOf(gas);
        std::uint64_t cell = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double part =
                most_[i] > least_[i] ? (values[i] - least_[i]) / (most_[i] - least_[i]) : 0.0;
            cell = cell << 8 | static_cast<std::uint64_t>(std::clamp(part, 0.0, 1.0) * cells_);
        }
        return cell;
    }

  private:
    static constexpr std::size_t count = hotGasCount + 3;
    static std::array<double, count> valuesOf(const GasLayer& gas) {
        std::array<double, count> values{gas.temperature_K, gas.pressure_atm, gas.soot_ppmv};
        std::ranges::copy(gas.moleFraction, values.begin() + 3);
        return values;
    }

    int cells_;
    std::array<double, count> least_ = [] {
        std::array<double, count> all{};
        all.fill(1e300);
        return all;
    }();
    std::array<double, count> most_{};
};

/// Rounding may carry the mean of gases at a limit past it.
GasLayer withinLimits(GasLayer gas) {
    using Limits = GasLayerLimits;
    gas.temperature_K = std::clamp(gas.temperature_K, Limits::coldest_K, Limits::hottest_K);
    gas.pressure_atm = std::clamp(gas.pressure_atm, Limits::thinnest_atm, Limits::densest_atm);
    return gas;
}

/// A stretch of a line of sight through a field.
struct FieldStretch {
    PlumeField::Node gas;
    float length_m = 0.0F;
};

} // namespace

std::vector<FieldZone> fieldZones(const GasByTemperature& gas, std::size_t count) {
    // Gas of one temperature is not all on one side of a surface of just that temperature.
    constexpr double below = 1e-4;
    const double span_K = gas.hottest_K() - gas.coldest_K();
    std::vector<FieldZone> zones;
    for (const PlumeRun& run : gas.parted(count))
        zones.push_back({withinLimits(run.gas), std::max(0.0, run.from_K - below * span_K)});
    std::ranges::reverse(zones);
    return zones;
}

std::vector<PlumeView> plumeViews() {
    const auto at = [](const char* name, double fromAxis_deg, double up_deg) {
        const double sine = std::sin(radians(fromAxis_deg));
        return PlumeView{name,
                         {std::cos(radians(fromAxis_deg)), sine * std::cos(radians(up_deg)),
                          sine * std::sin(radians(up_deg))}};
    };
    return {at("side", 90.0, 0.0), at("quarter", 45.0, 0.0), at("tail", 10.0, 45.0),
            at("above", 90.0, 90.0), at("high quarter", 45.0, 90.0)};
}

FieldIntensities::FieldIntensities(const PlumeField& field, FieldWalls walls, const PlumeBand& band,
                                   const std::vector<PlumeView>& views, int fineness)
    : walls_(std::move(walls)), band_(band) {
    constexpr double golden = 0.61803398874989485;
    const auto lines = static_cast<std::size_t>(64 * fineness);
    std::vector<AcrossView> acrosses;
    for (const PlumeView& view : views)
        acrosses.emplace_back(field.axes_m(), view.towards);
    field.forEachBox([&](const PlumeField::Box& box) {
        for (AcrossView& across : acrosses)
            across.add(box.middle_m, thinAbsorption(box.gas) * box.volume_m3);
    });
    for (std::size_t number = 0; number < views.size(); ++number) {
        const AcrossView& across = acrosses[number];
        const std::vector<double> u_m = across.edges_m(0, lines), v_m = across.edges_m(1, lines);
        // Shifted from row to row, so that walls of zones lie nowhere among them.
        const auto shift = [&](std::size_t row) {
            return std::fmod(0.5 + golden * static_cast<double>(row), 1.0);
        };
        View& seen = views_.emplace_back(View{views[number], {}, 0.0});
        for (std::size_t i = 0; i < lines; ++i)
            for (std::size_t k = 0; k < lines; ++k)
                seen.sights.push_back({across.placeOf(std::lerp(u_m[i], u_m[i + 1], shift(k)),
                                                      std::lerp(v_m[k], v_m[k + 1], shift(i))),
                                       (u_m[i + 1] - u_m[i]) * (v_m[k + 1] - v_m[k]),
                                       {}});
        sumField(field, seen);
        lookAtWalls(seen);
    }
}

void FieldIntensities::sumField(const PlumeField& field, View& view) const {
    std::vector<std::vector<FieldStretch>> stretches(view.sights.size());
    parallelFor(view.sights.size(), [&](std::size_t i) {
        const Sight& sight = view.sights[i];
        const std::vector<double> ends_m =
            crossings_m(field.axes_m(), sight.through_m, view.of.towards);
        const auto gasAt = [&](double at_m) {
            return field.at(sumOf(sight.through_m, view.of.towards, at_m));
        };
        const auto rootAt = [&](double at_m) { return field.rootOf(gasAt(at_m).temperature_K); };
        double next = ends_m.empty() ? 0.0 : rootAt(ends_m.front());
        for (std::size_t k = 0; k + 1 < ends_m.size(); ++k) {
            constexpr double finest = 0.04, most = 4.0;
            const double before = std::exchange(next, rootAt(ends_m[k + 1]));
            const double steps = std::min(most, 1.0 + std::floor(std::abs(next - before) / finest));
            for (double step = 0.5; step < steps; ++step) {
                const GasLayer gas = gasAt(std::lerp(ends_m[k], ends_m[k + 1], step / steps));
                if (thinAbsorption(gas) > 0.0)
                    stretches[i].push_back(
                        {PlumeField::Node::of(gas),
                         static_cast<float>((ends_m[k] - ends_m[k + 1]) / steps)});
            }
        }
    });
    // As few states as the memory of their spectra wants.
    constexpr std::size_t mostStates = 4000;
    std::vector<GasLayer> gases;
    std::vector<std::vector<GasStretch>> columns;
    for (int cells = 200; cells > 1; cells /= 2) {
        const States states(field, cells);
        struct Mean {
            std::size_t number = 0;
            GasMean gas;
        };
        std::map<std::uint64_t, Mean> means;
        columns.assign(stretches.size(), {});
        for (std::size_t i = 0; i < stretches.size() && means.size() <= mostStates; ++i)
            for (const FieldStretch& stretch : stretches[i]) {
                const GasLayer gas = stretch.gas.gas();
                const auto [found, isNew] = means.try_emplace(states.cellOf(gas));
                Mean& mean = found->second;
                if (isNew)
                    mean.number = means.size() - 1;
                const auto length_m = static_cast<double>(stretch.length_m);
                mean.gas.add(gas, thinAbsorption(gas) * length_m);
                if (!columns[i].empty() && columns[i].back().gas == mean.number)
                    columns[i].back().length_m += length_m;
                else
                    columns[i].push_back({mean.number, length_m});
            }
        if (means.size() > mostStates)
            continue;
        gases.resize(means.size());
        for (const auto& [cell, mean] : means)
            gases[mean.number] = withinLimits(mean.gas.mean());
        break;
    }
    const BandSenders senders(gases, band_);
    std::vector<double> sent(columns.size());
    parallelFor(columns.size(), [&](std::size_t i) {
        sent[i] = view.sights[i].area_m2 * senders.radiance_W_m2_sr(columns[i]);
    });
    for (const double of : sent)
        view.intensity_W_sr += of;
}

void FieldIntensities::lookAtWalls(View& view) const {
    parallelFor(view.sights.size(), [&](std::size_t i) {
        Sight& sight = view.sights[i];
        const std::vector<double> ends_m =
            crossings_m(walls_.axes_m(), sight.through_m, view.of.towards);
        const auto look = [&](double at_m) {
            const double at_K = walls_.temperature_K(sumOf(sight.through_m, view.of.towards, at_m));
            return Sight::Look{static_cast<float>(at_m), static_cast<float>(at_K)};
        };
        // Between planes a line meets up to four tetrahedra.
        constexpr int perCell = 2;
        for (std::size_t k = 0; k + 1 < ends_m.size(); ++k)
            for (int step = 0; step < perCell; ++step)
                sight.looks.push_back(
                    look(std::lerp(ends_m[k], ends_m[k + 1], static_cast<double>(step) / perCell)));
        if (!ends_m.empty())
            sight.looks.push_back(look(ends_m.back()));
    });
}

std::vector<PlumeZonesError> FieldIntensities::errorsOf(const std::vector<FieldZone>& zones) const {
    std::vector<GasLayer> gases;
    std::vector<double> levels_K;
    for (const FieldZone& zone : zones) {
        gases.push_back(zone.gas);
        levels_K.push_back(walls_.levelFor(zone.from_K));
    }
    const BandSenders senders(gases, band_);
    // How many zones a place of some temperature is in.
    const auto within = [&](double at_K) {
        return static_cast<std::size_t>(std::ranges::upper_bound(levels_K, at_K) -
                                        levels_K.begin());
    };
    const auto columnOf = [&](const Sight& sight) {
        std::vector<GasStretch> column;
        const auto add = [&](std::size_t zonesAbout, double length_m) {
            if (zonesAbout == 0)
                return;
            if (!column.empty() && column.back().gas == zonesAbout - 1)
                column.back().length_m += length_m;
            else
                column.push_back({zonesAbout - 1, length_m});
        };
        for (std::size_t k = 0; k + 1 < sight.looks.size(); ++k) {
            const auto [first_m, first_K] = sight.looks[k];
            const auto [last_m, last_K] = sight.looks[k + 1];
            const double to_K = static_cast<double>(last_K), from_K = static_cast<double>(first_K);
            const double to_m = static_cast<double>(last_m), from_m = static_cast<double>(first_m);
            const std::size_t last = within(to_K);
            double at_m = from_m;
            for (std::size_t here = within(from_K); here != last;) {
                const bool isInwards = here < last;
                const double level_K = levels_K[isInwards ? here : here - 1];
                const double wall_m = std::lerp(from_m, to_m, (level_K - from_K) / (to_K - from_K));
                add(here, at_m - wall_m);
                at_m = wall_m;
                here = isInwards ? here + 1 : here - 1;
            }
            add(last, at_m - to_m);
        }
        return column;
    };
    std::vector<PlumeZonesError> errors;
    for (const View& view : views_) {
        std::vector<double> sent(view.sights.size());
        parallelFor(view.sights.size(), [&](std::size_t i) {
            const Sight& sight = view.sights[i];
            sent[i] = sight.area_m2 * senders.radiance_W_m2_sr(columnOf(sight));
        });
        PlumeZonesError& error = errors.emplace_back();
        error.view = view.of.name;
        error.table_W_sr = view.intensity_W_sr;
        for (const double of : sent)
            error.zones_W_sr += of;
    }
    return errors;
}

} // namespace irsg

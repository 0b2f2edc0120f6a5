#include "tools/samples/GasPlume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <string>

#include "irsg/core/Errors.h"
#include "tools/samples/Patch.h"

namespace smat {

namespace {

using Outline = std::vector<std::array<double, 2>>;

/// The points of an outline without which it would be off by more than a tolerance (D. H. Douglas
/// and T. K. Peucker 1973, Cartographica 10, 112).
void keep(const Outline& outline, std::size_t first, std::size_t last, double off_m,
          Outline& kept) {
    std::size_t farthest = first;
    double largest_m = 0.0;
    const auto& [x0, r0] = outline[first];
    const auto& [x1, r1] = outline[last];
    for (std::size_t i = first + 1; i < last; ++i) {
        const double straight_m = std::lerp(r0, r1, (outline[i][0] - x0) / (x1 - x0));
        const double here_m = std::abs(outline[i][1] - straight_m);
        if (here_m > largest_m) {
            largest_m = here_m;
            farthest = i;
        }
    }
    if (largest_m > off_m) {
        keep(outline, first, farthest, off_m, kept);
        keep(outline, farthest, last, off_m, kept);
    } else {
        kept.push_back(outline[last]);
    }
}

} // namespace

std::vector<irsg::PlumeZone> gasPlume(const irsg::RoundJet& jet, std::size_t zones) {
    return irsg::plumeZones(jet.table(), zones);
}

void addGasPlume(ModelWriter& writer, const std::vector<irsg::PlumeZone>& zones,
                 const irsg::IrCodes& first, const Look& look, const PlumePlace& place) {
    constexpr int around = 24;
    constexpr double off = 0.001; // of the widest place
    constexpr double apart_m = 5e-4;
    // A polygon as large as the circle.
    const double wider =
        std::sqrt(2.0 * std::numbers::pi / (around * std::sin(2.0 * std::numbers::pi / around)));
    for (std::size_t z = 0; z < zones.size(); ++z) {
        const int number = static_cast<int>(z);
        const FlightSurface surface{"gas" + std::to_string(z + 1),
                                    {first.temperature + number, first.material + number},
                                    false,
                                    look};
        for (const Outline& outline : zones[z].outlines_m) {
            const double widest_m =
                std::ranges::max(outline, {}, [](const auto& at) { return at[1]; })[1];
            Outline kept{outline.front()};
            keep(outline, 0, outline.size() - 1, off * widest_m, kept);
            // Ends of zones do not lie in one plane.
            const double inset_m = static_cast<double>(z) * apart_m;
            if (kept.front()[1] > 0.0)
                kept.front()[0] += inset_m;
            if (kept.back()[1] > 0.0)
                kept.back()[0] -= inset_m;
            // From the axis to the axis.
            if (kept.front()[1] > 0.0)
                kept.insert(kept.begin(), {kept.front()[0], 0.0});
            if (kept.back()[1] > 0.0)
                kept.push_back({kept.back()[0], 0.0});
            const auto at = [&](double u) -> std::array<double, 2> {
                const auto i = std::min(static_cast<std::size_t>(u), kept.size() - 2);
                const double part = u - static_cast<double>(i);
                return {std::lerp(kept[i][0], kept[i + 1][0], part),
                        std::lerp(kept[i][1], kept[i + 1][1], part)};
            };
            addPatch(
                writer,
                [&](double u, double angle) {
                    const auto [x_m, r_m] = at(u);
                    return place(x_m, wider * r_m, angle);
                },
                edges(0.0, static_cast<double>(kept.size() - 1), 1.0),
                edges(0.0, 2.0 * std::numbers::pi, 2.0 * std::numbers::pi / around), surface);
        }
    }
}

void writePlumeZones(const std::vector<irsg::PlumeZone>& zones, const irsg::IrCodes& first,
                     const std::filesystem::path& file) {
    std::ofstream out(file);
    out << "temperature index,material index,T [K],p [atm],CO2,H2O,O2\n";
    for (std::size_t z = 0; z < zones.size(); ++z) {
        const irsg::GasLayer& gas = zones[z].gas;
        const auto write = [&](double value, int decimals) {
            out << ',' << std::fixed << std::setprecision(decimals) << value;
        };
        out << first.temperature + static_cast<int>(z) << ','
            << first.material + static_cast<int>(z);
        write(gas.temperature_K, 1);
        write(gas.pressure_atm, 3);
        write(gas.fraction(irsg::HotGas::CO2), 5);
        write(gas.fraction(irsg::HotGas::H2O), 5);
        write(gas.oxygenFraction, 4);
        out << '\n';
    }
    if (!out.flush())
        throw irsg::InputError({file.string(), "", "a place that takes no more", "room"});
}

} // namespace smat

#include "tools/atmosphere-tables/lines/TrainingPaths.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace irsg::lbl {

namespace {

constexpr std::array edges_km = {0.0,  0.5,  1.0,  2.0,  3.0,  4.5,  6.0,  8.0, 10.0,
                                 12.5, 15.0, 19.0, 24.0, 30.0, 40.0, 55.0, 90.0};
constexpr std::size_t layerCount = edges_km.size() - 1;
/// From here up air is clear enough, and the horizon far enough, for level paths of 250 km. In cold
/// thin air the wings between narrow lines make such a path's radiance.
constexpr double longSight_km = 8.0;

std::size_t edgeIndex(double altitude_km) {
    return static_cast<std::size_t>(std::ranges::find(edges_km, altitude_km) - edges_km.begin());
}

/// The air half-way through a layer's mass, which is below its middle.
AtmosphericState meanAir(const Profile& profile, double lower_m, double upper_m) {
    const double below = profile.at(lower_m).pressure_hPa;
    const double above = profile.at(upper_m).pressure_hPa;
    const double middle = 0.5 * (below + above);
    const double part = std::log(below / middle) / std::log(below / above);
    return profile.at(lower_m + part * (upper_m - lower_m));
}

} // namespace

TrainingPaths trainingPaths(const std::vector<Profile>& atmospheres) {
    TrainingPaths all;
    for (const Profile& profile : atmospheres) {
        const std::size_t ground = all.layers.size();
        for (std::size_t i = 0; i < layerCount; ++i) {
            const double lower_m = 1e3 * edges_km[i], upper_m = 1e3 * edges_km[i + 1];
            all.layers.push_back({meanAir(profile, lower_m, upper_m), upper_m - lower_m});
        }
        for (const double altitude_km : {0.0, 2.0, 4.5, 8.0, 10.0, 12.5, 24.0}) {
            const std::size_t layer = ground + edgeIndex(altitude_km);
            for (const double length_m : {10.0, 100.0, 1e3, 4e3, 15e3, 80e3, 250e3}) {
                if (length_m > 100e3 && altitude_km < longSight_km)
                    continue;
                all.paths.push_back({layer, layer + 1, length_m / all.layers[layer].thickness_m});
            }
        }
        auto slant = [&](double from_km, double to_km, double factor) {
            all.paths.push_back({ground + edgeIndex(from_km), ground + edgeIndex(to_km), factor});
        };
        for (const double factor : {1.0, 2.0, 5.0})
            for (const double top_km : {0.5, 3.0, 6.0, 10.0, 90.0})
                slant(0.0, top_km, factor);
        for (const double factor : {1.0, 3.0, 12.0})
            for (const double bottom_km : {3.0, 6.0, 10.0, 15.0, 24.0})
                slant(bottom_km, 90.0, factor);
        for (const double factor : {1.0, 4.0}) {
            slant(3.0, 10.0, factor);
            slant(6.0, 15.0, factor);
            slant(10.0, 30.0, factor);
        }
        for (const double altitude_km : {0.0, 6.0, 12.5, 24.0})
            all.sorting.push_back(ground + edgeIndex(altitude_km));
    }
    return all;
}

} // namespace irsg::lbl

#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/RayPath.h"

/// Tracers to try, and what holds for every path.
namespace irsg::raypathtest {

inline constexpr double earth_m = 6371.23e3;

inline std::vector<double> gridOf(const Profile& profile) {
    std::vector<double> grid;
    for (const AtmosphericState& level : profile.levels()) {
        grid.push_back(level.altitude_m);
    }
    return grid;
}

inline RayTracer tracerOf(ModelAtmosphere model = ModelAtmosphere::usStandard1976,
                          double radius_m = earth_m) {
    const Profile profile = Profile::model(model);
    return RayTracer(profile, gridOf(profile), radius_m);
}

/// Air so thin that rays are straight lines.
inline RayTracer emptyAtmosphere(std::vector<double> grid = {0.0, 1000.0, 2500.0, 5000.0, 20000.0,
                                                             100000.0}) {
    const Profile thin(
        {AtmosphericState{0.0, 1e-9, 300.0, {}}, AtmosphericState{100000.0, 1e-10, 300.0, {}}});
    return RayTracer(thin, std::move(grid));
}

inline double sumOf(const RayPath& path) {
    double sum = 0.0;
    for (const RaySegment& segment : path.segments) {
        sum += segment.length_m;
    }
    return sum;
}

/// What holds for every path: pieces inside their layers, joined end to end, none empty.
inline void expectSound(const RayTracer& tracer, const RayPath& path) {
    const auto& grid = tracer.gridAltitudes_m();
    EXPECT_DOUBLE_EQ(sumOf(path), path.length_m);
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        const RaySegment& each = path.segments[i];
        const double low = grid[static_cast<std::size_t>(each.layer)];
        const double high = grid[static_cast<std::size_t>(each.layer) + 1];
        EXPECT_GT(each.length_m, 0.0);
        EXPECT_GE(std::min(each.startAltitude_m, each.endAltitude_m), low - 1e-7);
        EXPECT_LE(std::max(each.startAltitude_m, each.endAltitude_m), high + 1e-7);
        const double mean = low + each.meanFraction * (high - low);
        EXPECT_GE(mean, std::min(each.startAltitude_m, each.endAltitude_m) - 1e-6);
        EXPECT_LE(mean, std::max(each.startAltitude_m, each.endAltitude_m) + 1e-6);
        EXPECT_GE(each.sinElevation * (each.endAltitude_m - each.startAltitude_m), 0.0);
        EXPECT_GE(each.length_m * (1.0 + 1e-9) + 1e-9,
                  std::abs(each.endAltitude_m - each.startAltitude_m));
        const double joint_m = i > 0 ? path.segments[i - 1].endAltitude_m : each.startAltitude_m;
        EXPECT_NEAR(each.startAltitude_m, joint_m, 1e-6);
    }
}

/// Mean altitude along a path from its segments.
inline double meanAltitude_m(const RayTracer& tracer, const RayPath& path) {
    double sum = 0.0;
    for (const RaySegment& each : path.segments) {
        const double low = tracer.gridAltitudes_m()[static_cast<std::size_t>(each.layer)];
        const double high = tracer.gridAltitudes_m()[static_cast<std::size_t>(each.layer) + 1];
        sum += each.length_m * (low + each.meanFraction * (high - low));
    }
    return sum / path.length_m;
}

/// Distance to a sphere of altitude z along a straight line that starts at z0.
inline double straight_m(double z0, double elevation, double z) {
    const double r0 = earth_m + z0;
    const double s = r0 * std::sin(elevation);
    return std::sqrt(s * s + (z - z0) * (2.0 * earth_m + z + z0)) - s;
}

} // namespace irsg::raypathtest

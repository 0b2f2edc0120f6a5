#include "smatcore/tools/PathGeometry.h"

#include <cmath>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace smat {
namespace {

constexpr double earthRadius_m = 6371.23e3;

TEST(PathGeometry, FindsTheTargetAtTheEndOfTheLineOfSight) {
    const PathGeometry found =
        solveGeometry({.sensorAltitude_m = 3000.0, .losElevation_deg = 90.0, .range_m = 500.0});
    EXPECT_NEAR(found.path->targetAltitude_m, 3500.0, 1e-9);
    EXPECT_NEAR(found.targetAltitude_m.value(), 3500.0, 1e-9);
    EXPECT_NEAR(found.sight->elevation_rad, irsg::pi / 2, 1e-15);

    // The earth falls away under a horizontal line: hypot(r, R) - r_earth.
    const PathGeometry level =
        solveGeometry({.sensorAltitude_m = 0.0, .losElevation_deg = 0.0, .range_m = 100e3});
    EXPECT_NEAR(level.path->targetAltitude_m, std::hypot(earthRadius_m, 100e3) - earthRadius_m,
                1e-6);
}

TEST(PathGeometry, FindsTheElevationOfATargetAltitude) {
    for (const double elevation_deg : {-30.0, -1.0, 0.0, 0.5, 20.0, 89.0}) {
        const PathGeometry along = solveGeometry(
            {.sensorAltitude_m = 5000.0, .losElevation_deg = elevation_deg, .range_m = 7000.0});
        const PathGeometry between =
            solveGeometry({.sensorAltitude_m = 5000.0,
                           .targetAltitude_m = along.path->targetAltitude_m,
                           .range_m = 7000.0});
        EXPECT_NEAR(irsg::degrees(between.sight->elevation_rad), elevation_deg, 1e-6);
    }
}

TEST(PathGeometry, ACentimetreKeepsItsDigits) {
    const PathGeometry found =
        solveGeometry({.sensorAltitude_m = 2.0, .losElevation_deg = -30.0, .range_m = 0.01});
    EXPECT_NEAR(found.path->targetAltitude_m - 2.0, -0.005, 1e-11);
}

TEST(PathGeometry, EndsAPathToSpaceAtTheTopOfTheAir) {
    const PathGeometry up =
        solveGeometry({.sensorAltitude_m = 1000.0, .losElevation_deg = 90.0, .toSpace = true});
    EXPECT_NEAR(up.path->range_m, 99e3, 1e-6);
    EXPECT_FALSE(up.targetAltitude_m);
    // A limb passes its tangent point and leaves on the other side.
    const PathGeometry limb =
        solveGeometry({.sensorAltitude_m = 20e3, .losElevation_deg = -4.0, .toSpace = true});
    const PathGeometry back = solveGeometry(
        {.sensorAltitude_m = 20e3, .losElevation_deg = -4.0, .range_m = limb.path->range_m});
    EXPECT_NEAR(back.path->targetAltitude_m, spaceAltitude_m, 1e-5);
}

TEST(PathGeometry, TakesTheElevationOfAFlatSceneBesideATargetAltitude) {
    // 20 km away a flat scene is 31 m off; the target's altitude makes the path.
    const PathGeometry found = solveGeometry({.sensorAltitude_m = 100.0,
                                              .losElevation_deg = 0.0,
                                              .targetAltitude_m = 100.0,
                                              .range_m = 20e3});
    EXPECT_EQ(found.path->targetAltitude_m, 100.0);
    EXPECT_EQ(found.sight->elevation_rad, 0.0);
}

TEST(PathGeometry, SaysOnlyWhatTheInputDetermines) {
    const PathGeometry target = solveGeometry({.targetAltitude_m = 300.0});
    EXPECT_FALSE(target.path || target.sight);
    EXPECT_EQ(target.targetAltitude_m, 300.0);
    const PathGeometry sight = solveGeometry({.sensorAltitude_m = 300.0, .losElevation_deg = -5.0});
    EXPECT_FALSE(sight.path || sight.targetAltitude_m);
    EXPECT_TRUE(sight.sight);
}

struct BadRow {
    const char* name;
    PathGeometryInput input;
    std::vector<std::string> named;
};

void PrintTo(const BadRow& row, std::ostream* out) {
    *out << row.name;
}

class BadAtmosphereGeometry : public testing::TestWithParam<BadRow> {};

TEST_P(BadAtmosphereGeometry, IsRefusedByName) {
    try {
        solveGeometry(GetParam().input);
        FAIL() << "nothing was refused";
    } catch (const irsg::InputError& error) {
        for (const std::string& named : GetParam().named) {
            EXPECT_THAT(error.what(), testing::HasSubstr(named));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Rows, BadAtmosphereGeometry,
    testing::Values(
        BadRow{"SensorBelowGround",
               {.sensorAltitude_m = -5.0, .losElevation_deg = 0.0, .range_m = 10.0},
               {"sensor altitude: found -5"}},
        BadRow{"TargetBelowGround", {.targetAltitude_m = -1.0}, {"target altitude: found -1"}},
        BadRow{"NegativeRange", {.sensorAltitude_m = 5.0, .range_m = -1.0}, {"range: found -1"}},
        BadRow{"BeyondTheZenith",
               {.sensorAltitude_m = 5.0, .losElevation_deg = 91.0},
               {"elevation of the line of sight: found 91"}},
        BadRow{"SeveralAtOnce",
               {.sensorAltitude_m = NAN, .losElevation_deg = -91.0, .range_m = INFINITY},
               {"sensor altitude: found nan", "found -91", "range: found inf"}},
        BadRow{"IntoTheGround",
               {.sensorAltitude_m = 100.0, .losElevation_deg = -30.0, .range_m = 500.0},
               {"range: found 500 m", "at most 200", "meets the ground"}},
        BadRow{"ThroughTheEarth",
               {.sensorAltitude_m = 100.0, .losElevation_deg = -1.0, .range_m = 1000e3},
               {"meets the ground"}},
        BadRow{"TooShort",
               {.sensorAltitude_m = 3000.0, .targetAltitude_m = 100.0, .range_m = 2000.0},
               {"range: found 2000 m", "2900 m"}},
        BadRow{"Contradiction",
               {.sensorAltitude_m = 3000.0,
                .losElevation_deg = 10.0,
                .targetAltitude_m = 3000.0,
                .range_m = 2000.0},
               {"found 10 deg with a target altitude of 3000 m", "3347.6"}},
        BadRow{"SpaceWithARange",
               {.sensorAltitude_m = 5.0, .losElevation_deg = 1.0, .range_m = 9.0, .toSpace = true},
               {"range: found 9 m with a path to space"}},
        BadRow{"SpaceWithATarget",
               {.sensorAltitude_m = 5.0,
                .losElevation_deg = 1.0,
                .targetAltitude_m = 9.0,
                .toSpace = true},
               {"target altitude: found 9 m with a path to space"}},
        BadRow{"SpaceFromNowhere", {.toSpace = true}, {"sensor altitude", "elevation"}},
        BadRow{"SpaceThroughTheGround",
               {.sensorAltitude_m = 5.0, .losElevation_deg = -10.0, .toSpace = true},
               {"found -10 deg", "misses the ground"}},
        BadRow{"SpaceFromSpace",
               {.sensorAltitude_m = 2e5, .losElevation_deg = -10.0, .toSpace = true},
               {"sensor altitude: found 2", "100 km"}}),
    [](const auto& row) { return row.param.name; });

} // namespace
} // namespace smat

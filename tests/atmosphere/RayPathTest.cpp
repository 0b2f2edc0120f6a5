#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/RayPath.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Units.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

constexpr double earth_m = 6371.23e3;

std::vector<double> gridOf(const Profile& profile) {
    std::vector<double> grid;
    for (const AirState& level : profile.levels())
        grid.push_back(level.altitude_m);
    return grid;
}

RayTracer tracerOf(ModelAtmosphere model = ModelAtmosphere::usStandard1976,
                   double radius_m = earth_m) {
    const Profile profile = Profile::model(model);
    return RayTracer(profile, gridOf(profile), radius_m);
}

/// Air so thin that rays are straight lines.
RayTracer emptyAir(std::vector<double> grid = {0.0, 1000.0, 2500.0, 5000.0, 20000.0, 100000.0}) {
    const Profile thin({AirState{0.0, 1e-9, 300.0, {}}, AirState{100000.0, 1e-10, 300.0, {}}});
    return RayTracer(thin, std::move(grid));
}

double sumOf(const RayPath& path) {
    double sum = 0.0;
    for (const RaySegment& segment : path.segments)
        sum += segment.length_m;
    return sum;
}

/// What holds for every path: pieces inside their layers, joined end to end, none empty.
void expectSound(const RayTracer& tracer, const RayPath& path) {
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
double meanAltitude_m(const RayTracer& tracer, const RayPath& path) {
    double sum = 0.0;
    for (const RaySegment& each : path.segments) {
        const double low = tracer.gridAltitudes_m()[static_cast<std::size_t>(each.layer)];
        const double high = tracer.gridAltitudes_m()[static_cast<std::size_t>(each.layer) + 1];
        sum += each.length_m * (low + each.meanFraction * (high - low));
    }
    return sum / path.length_m;
}

/// Distance to a sphere of altitude z along a straight line that starts at z0.
double straight_m(double z0, double elevation, double z) {
    const double r0 = earth_m + z0;
    const double s = r0 * std::sin(elevation);
    return std::sqrt(s * s + (z - z0) * (2.0 * earth_m + z + z0)) - s;
}

} // namespace

TEST(RayPath, isAStraightLineWithoutAir) {
    const RayTracer tracer = emptyAir();
    for (const double degrees : {0.0, 0.01, 1.0, 10.0, 45.0, 89.0, 90.0}) {
        const double elevation = radians(degrees);
        const RayPath path = tracer.along({300.0, elevation, 0.0});
        expectSound(tracer, path);
        ASSERT_EQ(path.segments.size(), 5u);
        double previous = 0.0;
        for (const RaySegment& each : path.segments) {
            const double end = straight_m(300.0, elevation, each.endAltitude_m);
            EXPECT_NEAR(each.length_m / (end - previous), 1.0, 1e-10);
            previous = end;
        }
        // The direction turns against the local horizon by the angle at the earth's centre.
        const double cosine = (earth_m + 300.0) * std::cos(elevation) / (earth_m + 1e5);
        EXPECT_NEAR(std::cos(path.endElevation_rad), cosine, 1e-12);
    }
}

TEST(RayPath, downwardsEndsOnTheGroundOrPassesItsTangent) {
    const RayTracer tracer = emptyAir();
    const RayPath down = tracer.along({10000.0, radians(-30.0), 0.0});
    expectSound(tracer, down);
    EXPECT_EQ(down.end, RayPath::End::ground);
    EXPECT_EQ(down.segments.back().endAltitude_m, 0.0);
    const double r = earth_m + 10000.0;
    const double s = r * std::sin(radians(30.0));
    EXPECT_NEAR(down.length_m, s - std::sqrt(s * s - 10000.0 * (r + earth_m)), 1e-6);

    const RayPath limb = tracer.along({10000.0, radians(-2.0), 0.0});
    expectSound(tracer, limb);
    EXPECT_EQ(limb.end, RayPath::End::space);
    const double tangent = r * std::cos(radians(2.0)) - earth_m;
    EXPECT_NEAR(limb.tangentAltitude_m, tangent, 1e-6);
    EXPECT_NEAR(limb.length_m, straight_m(10000.0, radians(-2.0), 1e5), 1e-4);
    const bool isCut = std::ranges::any_of(limb.segments, [&](const RaySegment& each) {
        return std::abs(each.endAltitude_m - tangent) < 1e-6;
    });
    EXPECT_TRUE(isCut);
}

TEST(RayPath, fromSpaceEntersTheAirOrMissesIt) {
    const RayTracer tracer = emptyAir();
    const double sensor = 400e3;
    const double r = earth_m + sensor;
    const double toGround = -std::acos(earth_m / r);
    const double toTop = -std::acos((earth_m + 1e5) / r);
    const RayPath miss = tracer.along({sensor, toTop + 1e-5, 0.0});
    EXPECT_TRUE(miss.segments.empty());
    EXPECT_EQ(miss.end, RayPath::End::space);
    EXPECT_TRUE(tracer.along({sensor, 0.3, 0.0}).segments.empty());
    const RayPath limb = tracer.along({sensor, 0.5 * (toGround + toTop), 0.0});
    expectSound(tracer, limb);
    const double tangentRadius = r * std::cos(0.5 * (toGround + toTop));
    EXPECT_NEAR(limb.length_m,
                2.0 * std::sqrt(std::pow(earth_m + 1e5, 2) - tangentRadius * tangentRadius), 1e-3);
    EXPECT_NEAR(limb.segments.front().startAltitude_m, 1e5, 1e-6);
    const RayPath down = tracer.along({sensor, -0.5 * pi, 0.0});
    EXPECT_NEAR(down.length_m, 1e5, 1e-6);
    EXPECT_EQ(down.end, RayPath::End::ground);
    const RayPath path = tracer.between({sensor, 0.0, sensor});
    expectSound(tracer, path);
    EXPECT_NEAR(path.length_m, 1e5, 1e-6);
    EXPECT_TRUE(tracer.between({2e5, 3e5, 5e5}).segments.empty());
}

TEST(RayPath, joinsTheEndsOfAStraightLine) {
    const RayTracer tracer = emptyAir();
    for (const AirPath& ends :
         {AirPath{0, 100, 1000}, AirPath{3000, 10000, 9000}, AirPath{10, 20, 20},
          AirPath{4000, 4500, 150e3}, AirPath{20000, 9000, 500e3}, AirPath{0, 99999, 99999.001},
          AirPath{35786e3, 5000, 38000e3}, AirPath{90000, 90000, 2000e3}}) {
        const RayPath path = tracer.between(ends);
        expectSound(tracer, path);
        const double low = std::min(ends.sensorAltitude_m, ends.targetAltitude_m);
        const double high = std::max(ends.sensorAltitude_m, ends.targetAltitude_m);
        const double sine =
            ((high - low) * (2.0 * earth_m + low + high) - ends.range_m * ends.range_m) /
            (2.0 * (earth_m + low) * ends.range_m);
        if (ends.targetAltitude_m < ends.sensorAltitude_m) {
            EXPECT_NEAR(path.endElevation_rad, -std::asin(sine), 1e-9);
        }
        if (high <= 1e5) {
            EXPECT_NEAR(path.length_m / ends.range_m, 1.0, 1e-12);
        }
        if (sine < 0.0) {
            EXPECT_NEAR(path.tangentAltitude_m,
                        (earth_m + low) * std::sqrt(1.0 - sine * sine) - earth_m, 1e-4);
        }
    }
}

TEST(RayPath, overAShortDistanceIsFlat) {
    const RayTracer tracer = tracerOf();
    for (const double range : {0.01, 1.0, 100.0}) {
        for (const double rise : {0.0, 0.3 * range, 0.9 * range, range}) {
            const RayPath path = tracer.between({1500.0, 1500.0 + rise, range});
            expectSound(tracer, path);
            EXPECT_NEAR(path.length_m / range, 1.0, 1e-12);
            EXPECT_NEAR(meanAltitude_m(tracer, path), 1500.0 + 0.5 * rise, 1e-3);
            EXPECT_NEAR(std::sin(path.endElevation_rad), rise / range, range * 1e-6);
        }
    }
}

TEST(RayPath, ofOneCentimetreKeepsItsDigits) {
    const RayTracer tracer = tracerOf();
    for (const double altitude : {0.0, 0.1, 2000.0, 5432.1, 40000.0}) {
        const RayPath level = tracer.between({altitude, altitude, 0.01});
        expectSound(tracer, level);
        EXPECT_NEAR(level.length_m, 0.01, 1e-15);
        const RayPath slant = tracer.between({altitude, altitude + 0.005, 0.01});
        EXPECT_NEAR(slant.length_m, 0.01, 1e-15);
        EXPECT_NEAR(slant.endElevation_rad, radians(30.0), 1e-8);
    }
}

TEST(RayPath, ofNoLengthHasNoSegments) {
    const RayPath none = tracerOf().between({100.0, 100.0, 0.0});
    EXPECT_TRUE(none.segments.empty());
    EXPECT_EQ(none.length_m, 0.0);
    EXPECT_EQ(none.end, RayPath::End::target);
    const RayPath tiny = tracerOf().between({100.0, 100.0, 1e-9});
    EXPECT_NEAR(tiny.length_m, 1e-9, 1e-20);
}

TEST(RayPath, isTheSameFromBothEnds) {
    const RayTracer tracer = tracerOf(ModelAtmosphere::tropical);
    for (const AirPath& there :
         {AirPath{0, 10, 10000}, AirPath{2000, 10000, 9235.9}, AirPath{100, 100, 30e3},
          AirPath{5000, 5010, 400e3}, AirPath{0, 90000, 1000e3}, AirPath{3, 17, 60e3},
          AirPath{10, 300e3, 900e3}}) {
        const AirPath back{there.targetAltitude_m, there.sensorAltitude_m, there.range_m};
        const RayPath a = tracer.between(there);
        const RayPath b = tracer.between(back);
        ASSERT_EQ(a.segments.size(), b.segments.size());
        const std::size_t last = a.segments.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            const RaySegment& one = a.segments[i];
            const RaySegment& other = b.segments[last - i];
            EXPECT_EQ(one.layer, other.layer);
            EXPECT_NEAR(one.length_m / other.length_m, 1.0, 1e-9);
            EXPECT_NEAR(one.meanFraction, other.meanFraction, 1e-9);
            EXPECT_NEAR(one.startAltitude_m, other.endAltitude_m, 1e-6);
            EXPECT_NEAR(one.sinElevation, -other.sinElevation, 1e-9);
        }
        EXPECT_EQ(a.tangentAltitude_m, b.tangentAltitude_m);
    }
}

// A ray that left with the elevation that `between` found arrives: follow it with `along`.
TEST(RayPath, betweenTwoPointsIsTheRayThatArrives) {
    const RayTracer tracer = tracerOf();
    for (const double elevation : {-0.02, -0.001, 0.0, 0.001, 0.05, 0.5, 1.2}) {
        const RayPath ray = tracer.along({8000.0, elevation, 0.0});
        ASSERT_EQ(ray.end, RayPath::End::space);
        const RayPath found = tracer.between({8000.0, 1e5, ray.length_m});
        EXPECT_NEAR(found.endElevation_rad, ray.endElevation_rad, 1e-9);
        EXPECT_NEAR(found.tangentAltitude_m, ray.tangentAltitude_m, 1e-3);
        EXPECT_NEAR(found.length_m / ray.length_m, 1.0, 1e-12);
    }
}

TEST(RayPath, betweenEqualAltitudesIsSymmetric) {
    const RayTracer tracer = tracerOf();
    const RayPath path = tracer.between({9000.0, 9000.0, 300e3});
    expectSound(tracer, path);
    const std::size_t count = path.segments.size();
    ASSERT_EQ(count % 2, 0u);
    for (std::size_t i = 0; i < count; ++i)
        EXPECT_NEAR(path.segments[i].length_m / path.segments[count - 1 - i].length_m, 1.0, 1e-9);
    // Refraction lifts the ray: the chord would dip by L^2 / 8 R.
    const double dip = 300e3 * 300e3 / (8.0 * (earth_m + 9000.0));
    EXPECT_GT(path.tangentAltitude_m, 9000.0 - dip);
    EXPECT_NEAR(9000.0 - path.tangentAltitude_m, dip, 0.12 * dip);
}

TEST(RayPath, isContinuousAcrossTheHorizontalAndTheTangent) {
    const RayTracer tracer = tracerOf();
    for (const double altitude : {50.0, 1000.0, 1300.0, 8000.0, 8500.0}) {
        // A level sensor: length and mean altitude change by little for a millionth of a radian.
        const RayPath up = tracer.along({altitude, 1e-6, 0.0});
        const RayPath level = tracer.along({altitude, 0.0, 0.0});
        const RayPath down = tracer.along({altitude, -1e-6, 0.0});
        expectSound(tracer, up);
        expectSound(tracer, down);
        EXPECT_NEAR(up.length_m, level.length_m, 12.0);
        EXPECT_NEAR(down.length_m, level.length_m, 12.0);
        // At a level of the grid the curvature of rays has a step.
        EXPECT_NEAR(down.length_m - level.length_m, level.length_m - up.length_m,
                    std::fmod(altitude, 1000.0) == 0.0 ? 0.1 : 0.001);
    }
    // A target that passes through the height at which the ray leaves horizontally.
    const double range = 50e3;
    double previous = meanAltitude_m(tracer, tracer.between({3000.0, 3000.0, range}));
    for (double target = 3001.0; target < 3400.0; target += 1.0) {
        const RayPath path = tracer.between({3000.0, target, range});
        expectSound(tracer, path);
        EXPECT_NEAR(path.length_m, range, 1e-7);
        const double mean = meanAltitude_m(tracer, path);
        EXPECT_NEAR(mean - previous, 0.5, 0.02) << target;
        previous = mean;
    }
}

TEST(RayPath, isContinuousWhereItTouchesTheGround) {
    const RayTracer tracer = tracerOf();
    double previous = -1.0;
    for (double range = 20e3; range < 45e3; range += 100.0) {
        const RayPath path = tracer.between({20.0, 25.0, range});
        expectSound(tracer, path);
        EXPECT_NEAR(path.length_m, range, 1e-7);
        const double mean = meanAltitude_m(tracer, path);
        if (previous >= 0.0) {
            EXPECT_NEAR(mean, previous, 0.15);
        }
        previous = mean;
    }
    const RayPath flat = tracer.between({0.0, 0.0, 20e3});
    expectSound(tracer, flat);
    EXPECT_NEAR(flat.length_m, 20e3, 1e-9);
    EXPECT_EQ(flat.tangentAltitude_m, 0.0);
    EXPECT_EQ(meanAltitude_m(tracer, flat), 0.0);
}

// The convention at the horizon is 34 arc minutes, visible light and 10 C (Bennett 1982, J.
// Navigation 35, 255). The infrared index is 2 % lower, and refraction at the horizon falls by 0.55
// % per K: 32 to 33 in the standard atmosphere.
TEST(RayPath, bendsTheSunAtTheHorizonByTheKnownAngle) {
    const auto refraction = [](const RayTracer& tracer) {
        double low = radians(-1.0);
        double high = 0.0;
        for (int pass = 0; pass < 40; ++pass) {
            const double middle = 0.5 * (low + high);
            (tracer.towardsSun(0.0, middle).end == RayPath::End::ground ? low : high) = middle;
        }
        return -degrees(high) * 60.0;
    };
    const double standard = refraction(tracerOf());
    const double winter = refraction(tracerOf(ModelAtmosphere::subarcticWinter));
    std::printf("refraction at the horizon: %.2f arc minutes, subarctic winter %.2f\n", standard,
                winter);
    EXPECT_NEAR(standard, 32.5, 0.7);
    EXPECT_GT(winter, 37.0);
    EXPECT_LT(winter, 46.0); // its lowest kilometre is an inversion
}

// Laplace's series: R = (n - 1)(1 - b) tan z - (n - 1)(b - (n - 1) / 2) tan^3 z with b the height
// of the homogeneous atmosphere over the earth's radius (Green 1985, Spherical Astronomy, chapter
// 4); it does not depend on the profile.
TEST(RayPath, bendsTheSunAsLaplaceSays) {
    const Profile profile = Profile::model(ModelAtmosphere::usStandard1976);
    const RayTracer tracer(profile, gridOf(profile));
    const AirState ground = profile.at(0.0);
    const double n1 = tracer.refractiveIndex(0.0) - 1.0;
    EXPECT_NEAR(n1, 2.7272e-4, 0.006e-4);
    const double b = 8.314462618 * ground.temperature_K / (28.92e-3 * 9.80665) / earth_m;
    for (const double apparent : {15.0, 30.0, 45.0, 70.0}) {
        const double tangent = 1.0 / std::tan(radians(apparent));
        const double known =
            n1 * (1.0 - b) * tangent - n1 * (b - 0.5 * n1) * std::pow(tangent, 3.0);
        const RayPath sun = tracer.towardsSun(0.0, radians(apparent) - known);
        const RayPath seen = tracer.along({0.0, radians(apparent), 0.0});
        EXPECT_NEAR(sun.endElevation_rad, seen.endElevation_rad, 0.005 * known) << apparent;
    }
    EXPECT_NEAR(emptyAir().towardsSun(0.0, 0.3).length_m, straight_m(0.0, 0.3, 1e5), 1e-4);
}

TEST(RayPath, seesTheSunBelowTheHorizonFromAloft) {
    const RayTracer tracer = tracerOf();
    const RayPath below = tracer.towardsSun(10000.0, radians(-3.0));
    expectSound(tracer, below);
    EXPECT_EQ(below.end, RayPath::End::space);
    EXPECT_LT(below.tangentAltitude_m, 10000.0);
    EXPECT_GT(below.tangentAltitude_m, 0.0);
    const RayPath hidden = tracer.towardsSun(10000.0, radians(-5.0));
    EXPECT_EQ(hidden.end, RayPath::End::ground);
    EXPECT_TRUE(hidden.segments.empty());
    EXPECT_EQ(tracer.towardsSun(0.0, -0.5 * pi).end, RayPath::End::ground);
    EXPECT_NEAR(tracer.towardsSun(0.0, 0.5 * pi).length_m, 1e5, 1e-6);
    EXPECT_TRUE(tracer.towardsSun(5e5, 0.1).segments.empty());
    EXPECT_EQ(tracer.towardsSun(5e5, -0.1).end, RayPath::End::space);
    EXPECT_EQ(tracer.towardsSun(5e5, radians(-30.0)).end, RayPath::End::ground);
    // A limb ray from orbit is bent twice: its tangent lies higher than the straight line's.
    const double sine = -std::acos((earth_m + 5000.0) / (earth_m + 5e5));
    const RayPath limb = tracer.towardsSun(5e5, sine);
    EXPECT_EQ(limb.end, RayPath::End::space);
    EXPECT_GT(limb.tangentAltitude_m, 8000.0);
}

// Kasten and Young 1989, Appl. Opt. 28, 4735, table II: relative optical air mass of the ISO
// standard atmosphere in the visible (0.7 um).
TEST(RayPath, hasTheAirMassOfKastenAndYoung) {
    const Profile profile = Profile::model(ModelAtmosphere::usStandard1976);
    std::vector<double> grid;
    for (double z = 0.0; z <= 1e5; z += z < 20000.0 ? 250.0 : 2000.0)
        grid.push_back(z);
    const RayTracer tracer(profile, grid);
    const auto mass = [&](double elevation) {
        double sum = 0.0;
        for (const RaySegment& each : tracer.along({0.0, elevation, 0.0}).segments) {
            const auto k = static_cast<std::size_t>(each.layer);
            const double low = profile.at(grid[k]).airDensity_per_m3();
            const double high = profile.at(grid[k + 1]).airDensity_per_m3();
            sum += each.length_m * (low + each.meanFraction * (high - low));
        }
        return sum;
    };
    for (const double zenith : {45.0, 60.0, 80.0, 85.0, 88.0, 90.0}) {
        const double elevation = 90.0 - zenith;
        const double known =
            1.0 / (std::sin(radians(elevation)) + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
        const double ours = mass(radians(elevation)) / mass(0.5 * pi);
        std::printf("air mass at zenith angle %g: %.4f, Kasten and Young %.4f\n", zenith, ours,
                    known);
        EXPECT_NEAR(ours / known, 1.0, 0.01) << zenith;
    }
}

// Path lengths of MODTRAN (headers of its tape7). Its earth radii: 6371.23 km, tropical 6378.39.
// The tropical run covers 0.3 to 15 um and bends as visible light does, 2 % more than ours.
TEST(RayPath, hasTheLengthsOfModtran) {
    const RayTracer standard = tracerOf();
    const RayTracer tropical = tracerOf(ModelAtmosphere::tropical, 6378.39e3);
    const auto length_km = [](const RayTracer& tracer, double altitude_m, double zenith_deg) {
        return tracer.along({altitude_m, radians(90.0 - zenith_deg), 0.0}).length_m * 1e-3;
    };
    std::printf("to space: %.4f %.4f %.4f km\n", length_km(standard, 0.0, 20.0),
                length_km(tropical, 0.0, 89.5), length_km(standard, 2000.0, 90.93655));
    EXPECT_NEAR(length_km(standard, 0.0, 20.0), 106.31252, 2e-4);
    EXPECT_NEAR(length_km(tropical, 0.0, 89.5), 1117.88687, 0.7);
    EXPECT_NEAR(length_km(standard, 2000.0, 90.93655), 1296.0874, 0.05);

    const RayPath slant = standard.between({2000.0, 10000.0, 9235.9});
    const RayPath asGiven = standard.along({2000.0, radians(60.0), 0.0});
    double upToTen = 0.0;
    for (const RaySegment& each : asGiven.segments)
        upToTen += each.endAltitude_m <= 10000.0 + 1e-6 ? each.length_m : 0.0;
    EXPECT_NEAR(upToTen * 1e-3, 9.2359, 2e-4);
    EXPECT_NEAR(slant.length_m, 9235.9, 1e-6);
}

TEST(RayPath, carriesQuantitiesLinearInAltitudeExactly) {
    // Against Simpson's rule along a chord.
    const RayTracer coarse = emptyAir({0.0, 100000.0});
    const RayTracer fine = emptyAir();
    for (const double elevation : {0.0, 0.01, 0.3, 1.5}) {
        const RayPath a = coarse.along({0.0, elevation, 0.0});
        const RayPath b = fine.along({0.0, elevation, 0.0});
        EXPECT_NEAR(a.length_m / b.length_m, 1.0, 1e-9);
        EXPECT_NEAR(meanAltitude_m(coarse, a) / meanAltitude_m(fine, b), 1.0, 1e-8);
        double sum = 0.0;
        const int steps = 20000;
        for (int i = 0; i <= steps; ++i) {
            const double s = b.length_m * i / steps;
            const double r2 = earth_m * earth_m + s * s + 2.0 * earth_m * s * std::sin(elevation);
            const double z = (r2 - earth_m * earth_m) / (std::sqrt(r2) + earth_m);
            sum += z * (i == 0 || i == steps ? 1.0 : i % 2 ? 4.0 : 2.0) / 3.0;
        }
        EXPECT_NEAR(meanAltitude_m(fine, b) * steps / sum, 1.0, 1e-7);
    }
}

TEST(RayPath, isUnchangedByALayerCutInTwo) {
    // Refractivity is exponential in an isothermal dry atmosphere, on any grid.
    const Profile air({AirState{0.0, 1013.0, 260.0, {}}, AirState{80000.0, 0.03, 260.0, {}}});
    const RayTracer coarse(air, {0.0, 2000.0, 4000.0, 10000.0, 30000.0, 80000.0});
    const RayTracer fine(air, {0.0, 500.0, 1000.0, 2000.0, 3000.0, 4000.0, 6000.0, 8000.0, 10000.0,
                               15000.0, 20000.0, 30000.0, 50000.0, 80000.0});
    for (const double elevation : {0.0, 0.001, 0.02, 0.3}) {
        const RayPath a = coarse.along({100.0, elevation, 0.0});
        const RayPath b = fine.along({100.0, elevation, 0.0});
        EXPECT_NEAR(a.length_m / b.length_m, 1.0, 1e-7);
        EXPECT_NEAR(meanAltitude_m(coarse, a) / meanAltitude_m(fine, b), 1.0, 1e-6);
    }
    const AirPath ends{100.0, 500.0, 70e3};
    EXPECT_NEAR(coarse.between(ends).endElevation_rad, fine.between(ends).endElevation_rad, 1e-8);
}

TEST(RayPath, survivesInversionsThatWouldTrapIt) {
    const Profile profile = Profile::model(ModelAtmosphere::subarcticWinter)
                                .withMeteo({2.0, 263.15, 1013.0, 0.8, 253.15});
    const RayTracer tracer(profile, gridOf(profile));
    for (const double range : {1.0, 100.0, 5e3, 20e3, 50e3, 100e3})
        for (const double altitude : {0.0, 0.5, 1.0, 2.0, 10.0, 60.0}) {
            const RayPath path = tracer.between({altitude, 5.0, std::max(range, 60.0)});
            expectSound(tracer, path);
            EXPECT_NEAR(path.length_m / std::max(range, 60.0), 1.0, 1e-10);
        }
    expectSound(tracer, tracer.along({1.0, 0.0, 0.0}));
    EXPECT_EQ(tracer.along({1.0, 0.0, 0.0}).end, RayPath::End::space);
    EXPECT_GT(tracer.refractiveIndex(0.0), tracer.refractiveIndex(1000.0));
}

TEST(RayPath, hasTheRangeAskedBetweenAnyTwoEnds) {
    std::mt19937 generator(1);
    const auto uniform = [&] { return std::uniform_real_distribution<double>(0, 1)(generator); };
    const auto altitude = [&] {
        return uniform() < 0.15 ? 0.0 : std::pow(10.0, -2.0 + 7.0 * uniform());
    };
    double worst = 0.0;
    int count = 0;
    for (const bool isMeasured : {false, true}) {
        Profile profile = Profile::model(ModelAtmosphere::midlatitudeWinter);
        if (isMeasured)
            profile = profile.withMeteo({3.0, 275.0, 1000.0, 0.5, 266.0});
        const RayTracer tracer(profile, gridOf(profile));
        for (int i = 0; i < 6000; ++i) {
            const double sensor = altitude();
            const double target = uniform() < 0.1 ? sensor : altitude();
            const double rise = std::abs(target - sensor);
            const double range = uniform() < 0.3
                                     ? rise * (1.0 + std::pow(10.0, -15.0 * uniform()))
                                     : std::hypot(rise, std::pow(10.0, -2.0 + 8.3 * uniform()));
            try {
                const RayPath path = tracer.between({sensor, target, range});
                expectSound(tracer, path);
                worst = std::max(worst, range > 0.0 ? std::abs(path.length_m / range - 1.0) : 0.0);
                ++count;
            } catch (const InputError& error) {
                EXPECT_THAT(error.what(), HasSubstr("below ground"));
            }
        }
    }
    std::printf("length of %d random paths: wrong by at most %.1e\n", count, worst);
    EXPECT_GT(count, 10000);
    EXPECT_LT(worst, 1e-12);
}

TEST(RayPath, reachesTargetsAtAndAboveTheTop) {
    const RayTracer tracer = tracerOf();
    for (const double target : {99999.9, 1e5, 100000.1, 150e3}) {
        const RayPath path = tracer.between({0.0, target, 1000e3});
        expectSound(tracer, path);
        EXPECT_NEAR(path.segments.back().endAltitude_m, std::min(target, 1e5), 1e-6);
    }
    EXPECT_TRUE(tracer.between({1e5, 1e5 + 10.0, 100.0}).segments.empty());
    EXPECT_TRUE(tracer.along({1e5, 0.1, 0.0}).segments.empty());
    const RayPath limb = tracer.between({60e3, 60e3, 1500e3});
    expectSound(tracer, limb);
    EXPECT_NEAR(limb.length_m, 1500e3, 1e-5);
    const RayPath vertical = tracer.between({1000.0, 5000.0, 4000.0 * (1.0 - 5e-7)});
    EXPECT_NEAR(vertical.length_m, 4000.0, 1e-8);
    EXPECT_NEAR(vertical.endElevation_rad, 0.5 * pi, 1e-7);
}

TEST(RayPath, refusesWhatCannotBe) {
    const RayTracer tracer = tracerOf();
    const double nan = std::nan("");
    struct Case {
        const char* name;
        AirPath path;
        const char* words;
    };
    const Case cases[] = {{"sensor below ground", {-1, 10, 100}, "sensor altitude"},
                          {"target below ground", {1, -10, 100}, "target altitude"},
                          {"negative range", {1, 1, -1}, "range"},
                          {"nan range", {1, 1, nan}, "range"},
                          {"nan altitude", {nan, 1, 10}, "sensor altitude"},
                          {"infinite altitude", {1, INFINITY, 10}, "target altitude"},
                          {"infinite range", {1, 1, INFINITY}, "range"},
                          {"too short", {1000, 5000, 3999}, "difference of the altitudes, 4000 m"},
                          {"no range", {1000, 1001, 0}, "difference of the altitudes"},
                          {"hidden", {0, 0, 170e3}, "below ground"},
                          {"behind the earth", {400e3, 400e3, 5000e3}, "below ground"},
                          {"beyond the earth", {0, 0, 2e7}, "below ground"}};
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name);
        try {
            tracer.between(each.path);
            ADD_FAILURE() << "nothing was refused";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(each.words));
        }
    }
    EXPECT_NO_THROW(tracer.between({0, 0, 159e3}));
    EXPECT_THROW(tracer.along({-1.0, 0.0, 0.0}), InputError);
    EXPECT_THROW(tracer.along({1.0, 2.0, 0.0}), InputError);
    EXPECT_THROW(tracer.along({1.0, nan, 0.0}), InputError);
    EXPECT_THROW(tracer.towardsSun(-1.0, 0.5), InputError);
    EXPECT_THROW(tracer.towardsSun(1.0, nan), InputError);
    const Profile profile = Profile::model(ModelAtmosphere::tropical);
    EXPECT_THROW(RayTracer(profile, {0.0}), LogicError);
    EXPECT_THROW(RayTracer(profile, {1.0, 2.0}), LogicError);
    EXPECT_THROW(RayTracer(profile, {0.0, 2.0, 2.0}), LogicError);
    EXPECT_THROW(RayTracer(profile, {0.0, 2e5}), LogicError);
}

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/RayPath.h"
#include "irsg/radiometry/Units.h"
#include "tests/atmosphere/RayPathSupport.h"

using namespace irsg;
using namespace irsg::raypathtest;

// The convention at the horizon is 34 arc minutes, visible light and 10 C (Bennett 1982, J.
// Navigation 35, 255). The infrared index is 2 % lower, and refraction at the horizon falls by 0.55
// % per K: 32 to 33 in the standard atmosphere.
TEST(RayPathRefraction, BendsTheSunAtTheHorizonByTheKnownAngle) {
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
TEST(RayPathRefraction, BendsTheSunAsLaplaceSays) {
    const Profile profile = Profile::model(ModelAtmosphere::usStandard1976);
    const RayTracer tracer(profile, gridOf(profile));
    const AtmosphericState ground = profile.at(0.0);
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
    EXPECT_NEAR(emptyAtmosphere().towardsSun(0.0, 0.3).length_m, straight_m(0.0, 0.3, 1e5), 1e-4);
}

TEST(RayPathRefraction, SeesTheSunBelowTheHorizonFromAloft) {
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
TEST(RayPathRefraction, HasTheAirMassOfKastenAndYoung) {
    const Profile profile = Profile::model(ModelAtmosphere::usStandard1976);
    std::vector<double> grid;
    for (double z = 0.0; z <= 1e5; z += z < 20000.0 ? 250.0 : 2000.0) {
        grid.push_back(z);
    }
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
TEST(RayPathRefraction, HasTheLengthsOfModtran) {
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
    for (const RaySegment& each : asGiven.segments) {
        upToTen += each.endAltitude_m <= 10000.0 + 1e-6 ? each.length_m : 0.0;
    }
    EXPECT_NEAR(upToTen * 1e-3, 9.2359, 2e-4);
    EXPECT_NEAR(slant.length_m, 9235.9, 1e-6);
}

TEST(RayPathRefraction, SurvivesInversionsThatWouldTrapIt) {
    const Profile profile = Profile::model(ModelAtmosphere::subarcticWinter)
                                .adjustedToSurfaceObservation({2.0, 263.15, 1013.0, 0.8, 253.15});
    const RayTracer tracer(profile, gridOf(profile));
    for (const double range : {1.0, 100.0, 5e3, 20e3, 50e3, 100e3}) {
        for (const double altitude : {0.0, 0.5, 1.0, 2.0, 10.0, 60.0}) {
            const RayPath path = tracer.between({altitude, 5.0, std::max(range, 60.0)});
            expectSound(tracer, path);
            EXPECT_NEAR(path.length_m / std::max(range, 60.0), 1.0, 1e-10);
        }
    }
    expectSound(tracer, tracer.along({1.0, 0.0, 0.0}));
    EXPECT_EQ(tracer.along({1.0, 0.0, 0.0}).end, RayPath::End::space);
    EXPECT_GT(tracer.refractiveIndex(0.0), tracer.refractiveIndex(1000.0));
}

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/RayPath.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "tests/atmosphere/RayPathSupport.h"

using namespace irsg;
using namespace irsg::raypathtest;
using testing::HasSubstr;

TEST(RayPath, IsAStraightLineWithoutAir) {
    const RayTracer tracer = emptyAtmosphere();
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

TEST(RayPath, DownwardsEndsOnTheGroundOrPassesItsTangent) {
    const RayTracer tracer = emptyAtmosphere();
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

TEST(RayPath, FromSpaceEntersTheAirOrMissesIt) {
    const RayTracer tracer = emptyAtmosphere();
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

TEST(RayPath, JoinsTheEndsOfAStraightLine) {
    const RayTracer tracer = emptyAtmosphere();
    for (const AtmosphericPath& ends :
         {AtmosphericPath{0, 100, 1000}, AtmosphericPath{3000, 10000, 9000},
          AtmosphericPath{10, 20, 20}, AtmosphericPath{4000, 4500, 150e3},
          AtmosphericPath{20000, 9000, 500e3}, AtmosphericPath{0, 99999, 99999.001},
          AtmosphericPath{35786e3, 5000, 38000e3}, AtmosphericPath{90000, 90000, 2000e3}}) {
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

TEST(RayPath, OverAShortDistanceIsFlat) {
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

TEST(RayPath, OfOneCentimetreKeepsItsDigits) {
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

TEST(RayPath, OfNoLengthHasNoSegments) {
    const RayPath none = tracerOf().between({100.0, 100.0, 0.0});
    EXPECT_TRUE(none.segments.empty());
    EXPECT_EQ(none.length_m, 0.0);
    EXPECT_EQ(none.end, RayPath::End::target);
    const RayPath tiny = tracerOf().between({100.0, 100.0, 1e-9});
    EXPECT_NEAR(tiny.length_m, 1e-9, 1e-20);
}

TEST(RayPath, IsTheSameFromBothEnds) {
    const RayTracer tracer = tracerOf(ModelAtmosphere::tropical);
    for (const AtmosphericPath& there :
         {AtmosphericPath{0, 10, 10000}, AtmosphericPath{2000, 10000, 9235.9},
          AtmosphericPath{100, 100, 30e3}, AtmosphericPath{5000, 5010, 400e3},
          AtmosphericPath{0, 90000, 1000e3}, AtmosphericPath{3, 17, 60e3},
          AtmosphericPath{10, 300e3, 900e3}}) {
        const AtmosphericPath back{there.targetAltitude_m, there.sensorAltitude_m, there.range_m};
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
TEST(RayPath, BetweenTwoPointsIsTheRayThatArrives) {
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

TEST(RayPath, BetweenEqualAltitudesIsSymmetric) {
    const RayTracer tracer = tracerOf();
    const RayPath path = tracer.between({9000.0, 9000.0, 300e3});
    expectSound(tracer, path);
    const std::size_t count = path.segments.size();
    ASSERT_EQ(count % 2, 0u);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_NEAR(path.segments[i].length_m / path.segments[count - 1 - i].length_m, 1.0, 1e-9);
    }
    // Refraction lifts the ray: the chord would dip by L^2 / 8 R.
    const double dip = 300e3 * 300e3 / (8.0 * (earth_m + 9000.0));
    EXPECT_GT(path.tangentAltitude_m, 9000.0 - dip);
    EXPECT_NEAR(9000.0 - path.tangentAltitude_m, dip, 0.12 * dip);
}

TEST(RayPath, IsContinuousAcrossTheHorizontalAndTheTangent) {
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

TEST(RayPath, IsContinuousWhereItTouchesTheGround) {
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

TEST(RayPath, CarriesQuantitiesLinearInAltitudeExactly) {
    // Against Simpson's rule along a chord.
    const RayTracer coarse = emptyAtmosphere({0.0, 100000.0});
    const RayTracer fine = emptyAtmosphere();
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

TEST(RayPath, IsUnchangedByALayerCutInTwo) {
    // Refractivity is exponential in an isothermal dry atmosphere, on any grid.
    const Profile air(
        {AtmosphericState{0.0, 1013.0, 260.0, {}}, AtmosphericState{80000.0, 0.03, 260.0, {}}});
    const RayTracer coarse(air, {0.0, 2000.0, 4000.0, 10000.0, 30000.0, 80000.0});
    const RayTracer fine(air, {0.0, 500.0, 1000.0, 2000.0, 3000.0, 4000.0, 6000.0, 8000.0, 10000.0,
                               15000.0, 20000.0, 30000.0, 50000.0, 80000.0});
    for (const double elevation : {0.0, 0.001, 0.02, 0.3}) {
        const RayPath a = coarse.along({100.0, elevation, 0.0});
        const RayPath b = fine.along({100.0, elevation, 0.0});
        EXPECT_NEAR(a.length_m / b.length_m, 1.0, 1e-7);
        EXPECT_NEAR(meanAltitude_m(coarse, a) / meanAltitude_m(fine, b), 1.0, 1e-6);
    }
    const AtmosphericPath ends{100.0, 500.0, 70e3};
    EXPECT_NEAR(coarse.between(ends).endElevation_rad, fine.between(ends).endElevation_rad, 1e-8);
}

TEST(RayPath, HasTheRangeAskedBetweenAnyTwoEnds) {
    std::mt19937 generator(1);
    const auto uniform = [&] { return std::uniform_real_distribution<double>(0, 1)(generator); };
    const auto altitude = [&] {
        return uniform() < 0.15 ? 0.0 : std::pow(10.0, -2.0 + 7.0 * uniform());
    };
    double worst = 0.0;
    int count = 0;
    for (const bool isMeasured : {false, true}) {
        Profile profile = Profile::model(ModelAtmosphere::midlatitudeWinter);
        if (isMeasured) {
            profile = profile.adjustedToSurfaceObservation({3.0, 275.0, 1000.0, 0.5, 266.0});
        }
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

TEST(RayPath, ReachesTargetsAtAndAboveTheTop) {
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

TEST(RayPath, RefusesWhatCannotBe) {
    const RayTracer tracer = tracerOf();
    const double nan = std::nan("");
    struct Case {
        const char* name;
        AtmosphericPath path;
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

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/atmosphere/path/SunDiscGeometry.h"
#include "tests/atmosphere/RayPathSupport.h"
#include "tests/atmosphere/SyntheticAtmosphere.h"

using namespace irsg;
using namespace irsg::raypathtest;

namespace {

RadiativeTransfer hazyAtmosphere() {
    AtmosphericModel air{.profile = syntheticatmosphere::profile(290.0, 6.5), .particles = {}};
    air.particles = {
        syntheticatmosphere::particles({0.0, 2000.0, 4000.0}, {5e-5, 1e-5, 0.0}, 0.9, 0.6)};
    return {std::move(air), syntheticatmosphere::table()};
}

const NodeSet dayNodes{{syntheticatmosphere::sunlit, syntheticatmosphere::blue}, {5801.0, 20000.0}};

/// Largest part of its greatest value that a quantity changes by over a microradian.
template <typename Quantity>
double largestStep(Quantity&& quantity) {
    double greatest = 0.0, step = 0.0;
    for (double deg = -4.0; deg <= 1.0; deg += 0.01) {
        const double low = quantity(radians(deg) - 1e-6), high = quantity(radians(deg) + 1e-6);
        greatest = std::max({greatest, low, high});
        step = std::max(step, std::abs(high - low));
        EXPECT_GE(low, 0.0) << deg;
    }
    return greatest > 0.0 ? step / greatest : step;
}

} // namespace

TEST(VisibleSun, IsTheAreaOfTheDiscAboveTheHorizonAndItsMiddle) {
    for (const double x : {-0.99995, -0.9, -0.5, -0.01, 0.0, 0.3, 0.8, 0.999}) {
        double area = 0.0, moment = 0.0;
        constexpr int strips = 400000;
        for (int i = 0; i < strips; ++i) {
            // Strips of the part y > -x, where the angle runs over the rim.
            const double bottom = std::asin(-x);
            const double angle = bottom + (0.5 * pi - bottom) * (i + 0.5) / strips;
            const double chord = 2.0 * std::cos(angle) * std::cos(angle);
            area += chord;
            moment += chord * std::sin(angle);
        }
        const double width = (0.5 * pi - std::asin(-x)) / strips;
        const VisibleSun sun = visibleSun(x * sunDiscRadius_rad);
        EXPECT_NEAR(sun.part / (area * width / pi), 1.0, 1e-4) << x;
        EXPECT_NEAR(sun.middleAbove_rad / sunDiscRadius_rad, moment / area, 1e-4) << x;
    }
}

TEST(VisibleSun, IsContinuousAndWholeOrNothingBeyondTheRims) {
    EXPECT_EQ(visibleSun(sunDiscRadius_rad).part, 1.0);
    EXPECT_EQ(visibleSun(1.0).middleAbove_rad, 0.0);
    EXPECT_EQ(visibleSun(-1.0).part, 0.0);
    EXPECT_DOUBLE_EQ(visibleSun(0.0).part, 0.5);
    for (double x = -1.0005; x < 1.001; x += 1e-5) {
        const VisibleSun low = visibleSun((x - 1e-7) * sunDiscRadius_rad);
        const VisibleSun high = visibleSun((x + 1e-7) * sunDiscRadius_rad);
        EXPECT_GE(high.part, low.part) << x;
        EXPECT_NEAR(low.part, high.part, 2e-7) << x;
        EXPECT_NEAR(low.middleAbove_rad, high.middleAbove_rad, 1e-5 * sunDiscRadius_rad) << x;
    }
}

// Without air the horizon from an altitude h dips by acos(R / (R + h)), 3.2 degrees at 10 km; air
// bends the grazing ray on its way down and up again.
TEST(Sunset, IsAtTheRefractedHorizonOfTheAltitude) {
    const RayTracer empty = emptyAtmosphere();
    EXPECT_NEAR(degrees(empty.trueHorizonElevation_rad(1e4)),
                -degrees(std::acos(earth_m / (earth_m + 1e4))), 1e-9);
    EXPECT_EQ(empty.sunbeam(1e4, empty.trueHorizonElevation_rad(1e4)).part, 0.5);

    const RayTracer tracer = tracerOf();
    const double refraction_deg = -degrees(tracer.trueHorizonElevation_rad(0.0));
    EXPECT_NEAR(refraction_deg * 60.0, 32.5, 0.7);
    const double fromAloft_deg = -degrees(tracer.trueHorizonElevation_rad(1e4));
    std::printf("the sun's middle sets at %.3f deg at the ground, %.3f deg at 3 km, %.3f deg at 10 "
                "km\n",
                -refraction_deg, degrees(tracer.trueHorizonElevation_rad(3e3)), -fromAloft_deg);
    // Bent all the way up from the ground, and before that down to it from 10 km.
    EXPECT_GT(fromAloft_deg, 3.2 + refraction_deg);
    EXPECT_LT(fromAloft_deg, 3.2 + 2.0 * refraction_deg);
    for (const double altitude_m : {0.0, 1.0, 3e3, 1e4, 9.9e4, 5e5}) {
        const double set_rad = tracer.trueHorizonElevation_rad(altitude_m);
        EXPECT_EQ(tracer.sunbeam(altitude_m, set_rad - 1.01 * sunDiscRadius_rad).part, 0.0);
        EXPECT_NEAR(tracer.sunbeam(altitude_m, set_rad).part, 0.5, 1e-6);
        EXPECT_EQ(tracer.sunbeam(altitude_m, set_rad + 1.01 * sunDiscRadius_rad).part, 1.0);
        // Every beam, of a hidden sun too, leaves the air.
        for (const double above : {-30.0, -1.0, -0.5, 0.0, 0.99, 3.0}) {
            EXPECT_EQ(tracer.sunbeam(altitude_m, set_rad + above * sunDiscRadius_rad).ray.end,
                      RayPath::End::space)
                << altitude_m << " " << above;
        }
    }
}

TEST(Sunset, IsContinuousOfDirectSunFluxesSkyAndPath) {
    const RadiativeTransfer air = hazyAtmosphere();
    const auto sun = [](double elevation_rad) { return SunPosition{0.3, elevation_rad}; };
    for (const double altitude_m : {0.0, 3e3, 1e4}) {
        // A disc that rises by a microradian shows up to 1.4e-4 more of itself.
        EXPECT_LT(largestStep([&](double e) {
                      return air.solarIrradiance(dayNodes, altitude_m, sun(e))[0];
                  }),
                  4e-4)
            << altitude_m;
    }
    const auto steps = [&](const char* what, auto quantity) {
        double greatest = 0.0, step = 0.0;
        for (const double deg : {-4.0, -3.7, -3.0, -2.0, -0.81, -0.55, -0.3, 0.0, 0.5, 1.0}) {
            const double low = quantity(sun(radians(deg) - 1e-6))[1];
            const double high = quantity(sun(radians(deg) + 1e-6))[1];
            greatest = std::max({greatest, low, high});
            step = std::max(step, std::abs(high - low));
        }
        EXPECT_GT(greatest, 0.0) << what;
        EXPECT_LT(step, 4e-4 * greatest) << what;
    };
    steps("down", [&](const SunPosition& s) { return air.downwardFlux(dayNodes, 0.0, s); });
    steps("up", [&](const SunPosition& s) { return air.upwardFlux(dayNodes, 3e3, s); });
    steps("sky", [&](const SunPosition& s) {
        return air.backgroundRadiance(dayNodes, {100.0, 0.2, 0.0}, s);
    });
    steps("path", [&](const SunPosition& s) {
        return air.pathRadiance(dayNodes, {100.0, 3000.0, 2e4}, s);
    });
}

TEST(Sunset, LightGoesWithTheSquareOfTheDistance) {
    const RadiativeTransfer air = hazyAtmosphere();
    const SunPosition mean{0.0, 0.4}, near{0.0, 0.4, 0.98};
    const double factor = 1.0 / (0.98 * 0.98);
    const auto expect = [&](const std::vector<double>& a, const std::vector<double>& b) {
        EXPECT_NEAR(b[1] / a[1], factor, 1e-9);
    };
    expect(air.solarIrradiance(dayNodes, 50.0, mean), air.solarIrradiance(dayNodes, 50.0, near));
    expect(air.downwardFlux(dayNodes, 50.0, mean), air.downwardFlux(dayNodes, 50.0, near));
    expect(air.backgroundRadiance(dayNodes, {0.0, 0.3, 0.0}, mean),
           air.backgroundRadiance(dayNodes, {0.0, 0.3, 0.0}, near));
    const auto inVacuum = [&](const SunPosition& sun) {
        return Vacuum().solarIrradiance(0.0, sun, {3.0, 5.0}).at(4.0);
    };
    EXPECT_NEAR(inVacuum(near) / inVacuum(mean), factor, 1e-12);
}

TEST(Sunset, IsSeenWhereAirBendsItTo) {
    const AtmosphereSmart air(AtmosphereSmartParameters{});
    const double horizon_rad = air.transfer().tracer().trueHorizonElevation_rad(0.0);
    const SunView setting = air.sunView(0.0, {0.0, horizon_rad});
    EXPECT_NEAR(setting.elevation_rad, air.horizonElevation_rad(0.0), 1e-9);
    EXPECT_NEAR(setting.part, 0.5, 1e-6);
    // 34 minutes at the horizon, one at 45 degrees.
    EXPECT_NEAR(air.sunView(0.0, {0.0, radians(45.0)}).elevation_rad, radians(45.0 + 0.95 / 60.0),
                radians(0.1 / 60.0));
    const double below = air.sunView(0.0, {0.0, horizon_rad - 1e-6}).elevation_rad;
    const double above = air.sunView(0.0, {0.0, horizon_rad + 1e-6}).elevation_rad;
    EXPECT_NEAR(below, above, 1e-5);
}

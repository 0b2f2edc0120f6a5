// The path tracer that inter-reflection is held against: itself against closed forms.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/PathTracer.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr double pi = 3.141592653589793;

struct Surface {
    double emitted_W_m2_sr = 0.0, reflectivity = 0.0;
    bool isTwoSided = false;
};
using Triangles = std::vector<TracedTriangle>;

void add(Triangles& all, const Vec3& a, const Vec3& b, const Vec3& c, const Surface& surface) {
    all.push_back({{a, b, c}, surface.isTwoSided, surface.emitted_W_m2_sr, surface.reflectivity});
}

/// Centre +- u +- v; its front is the side that u x v points out of.
Triangles plate(const Vec3& centre, const Vec3& u, const Vec3& v, const Surface& surface) {
    Triangles all;
    add(all, centre - u - v, centre + u - v, centre + u + v, surface);
    add(all, centre - u - v, centre + u + v, centre - u + v, surface);
    return all;
}

Triangles joined(std::initializer_list<Triangles> parts) {
    Triangles all;
    for (const Triangles& part : parts) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

/// Six plates around the origin whose fronts face it.
Triangles room(const Vec3& half, const std::function<Surface(int)>& surfaceOf) {
    const Vec3 x{half.x, 0, 0}, y{0, half.y, 0}, z{0, 0, half.z}, o{};
    return joined({plate(x, z, y, surfaceOf(0)), plate(o - x, y, z, surfaceOf(1)),
                   plate(y, x, z, surfaceOf(2)), plate(o - y, z, x, surfaceOf(3)),
                   plate(z, y, x, surfaceOf(4)), plate(o - z, x, y, surfaceOf(5))});
}

/// A ball about the origin from a polar angle on, in rings; the facets' fronts look out or in.
Triangles ball(double radius, double from_rad, int rings, bool isInward,
               const std::function<Surface(double)>& surfaceOf) {
    const int around = 2 * rings;
    const auto at = [&](int i, int j) {
        const double polar = from_rad + (pi - from_rad) * i / rings, azimuth = 2 * pi * j / around;
        return Vec3{radius * std::sin(polar) * std::cos(azimuth),
                    radius * std::sin(polar) * std::sin(azimuth), radius * std::cos(polar)};
    };
    Triangles all;
    for (int i = 0; i < rings; ++i) {
        const Surface surface = surfaceOf(from_rad + (pi - from_rad) * (i + 0.5) / rings);
        for (int j = 0; j < around; ++j) {
            const Vec3 a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            add(all, a, isInward ? c : b, isInward ? b : c, surface);
            add(all, a, isInward ? d : c, isInward ? c : d, surface);
        }
    }
    return all;
}

Vec3 towards(double azimuth_rad, double elevation_rad) {
    return {std::sin(azimuth_rad) * std::cos(elevation_rad),
            std::cos(azimuth_rad) * std::cos(elevation_rad), std::sin(elevation_rad)};
}

void expectClose(const TracedValue& found, double expected, const char* what, double within = 0.0) {
    std::printf("  %-46s %.6f +- %.6f, expected %.6f: %+.3f %%\n", what, found.value, found.error,
                expected, 100 * (found.value / expected - 1));
    EXPECT_NEAR(found.value, expected, 4.0 * found.error + within * expected + 1e-9) << what;
    EXPECT_LT(found.error, 2e-3 * expected) << what;
}

} // namespace

TEST(PathTracerTest, AnIsothermalRoomIsBlack) {
    const double reflectivities[] = {0.1, 0.3, 0.5, 0.7, 0.9, 0.98};
    const Triangles walls = room({2, 1.5, 1}, [&](int side) {
        return Surface{2.5 * (1 - reflectivities[side]), reflectivities[side]};
    });
    const Triangles inside = ball(0.5, 0.0, 8, false, [](double) { return Surface{1.0, 0.6}; });
    const Vec3 to = towards(0.7, 0.4);
    // What of the room is seen through the backs of its walls.
    const double seen_m2 =
        4 * (1.5 * 1 * std::abs(to.x) + 2 * 1 * std::abs(to.y) + 2 * 1.5 * std::abs(to.z));
    for (const Triangles& body : {walls, joined({walls, inside})}) {
        expectClose(PathTracer(body, {}).intensity(to).total, 2.5 * seen_m2, "isothermal room");
    }
}

TEST(PathTracerTest, APlateReceivesByItsViewFactor) {
    // Howell, A Catalog of Radiation Heat Transfer Configuration Factors: C-11, opposed squares at
    // their side's distance, and C-14, squares with a common edge.
    const double opposed = 0.199825, rightAngle = 0.200044;
    const Surface hot{3.0, 0.0}, cold{0.0, 0.5};
    const Vec3 u{0.5, 0, 0}, v{0, 0.5, 0}, w{0, 0, 0.5};
    const TraceSettings settings{.relativeErrorOfBetween = 1e-3};
    const TracedLight facing =
        PathTracer(joined({plate({}, u, v, cold), plate({0, 0, 1}, v, u, hot)}), {})
            .intensity({0, 0, 1}, settings);
    expectClose(facing.onceFromOthers, 0.5 * opposed * 3.0, "opposed squares");
    EXPECT_EQ(facing.emitted.value, 0.0); // seen through its back
    const TracedLight beside =
        PathTracer(joined({plate({}, u, v, cold), plate({-0.5, 0, 0.5}, v, w, hot)}), {})
            .intensity({0, 0, 1}, settings);
    expectClose(beside.onceFromOthers, 0.5 * rightAngle * 3.0, "squares at a right angle");
    // Both reflect: what comes back to the hot one is reflected twice.
    EXPECT_EQ(beside.more.value, 0.0);
}

TEST(PathTracerTest, ASmallHotPartIsAimedAt) {
    // A disc-like square of 1 cm2 over the middle of a square of 4 m2: four corners, each of an
    // element before the corner of a rectangle (C-4 of the catalogue).
    const double side = 1.0 / std::sqrt(1.0 + 0.25);
    const double factor = 4.0 * (1.0 / (2.0 * pi)) * 2.0 * side * std::atan(side);
    const double h = 0.005;
    const Triangles body = joined({plate({}, {1, 0, 0}, {0, 1, 0}, {0.0, 0.8}),
                                   plate({0, 0, 0.5}, {0, h, 0}, {h, 0, 0}, {5000.0, 0.0})});
    const TracedLight found =
        PathTracer(body, {}).intensity({0, 0, 1}, {.relativeErrorOfBetween = 1e-3});
    expectClose(found.onceFromOthers, 0.8 * 5000.0 * 4 * h * h * factor, "small hot part", 1e-4);
}

TEST(PathTracerTest, ABallReflectsTheSunByItsPhase) {
    for (const double phase_rad : {0.0, 0.8, 1.6, 2.4}) {
        const PathTracer tracer(ball(1.0, 0.0, 96, false,
                                     [](double) {
                                         return Surface{0.0, 0.6, true};
                                     }),
                                {.towardsSun = towards(0.3, 0.2), .sun_W_m2 = 10.0});
        const TracedLight found =
            tracer.intensity(towards(0.3, 0.2 + phase_rad), {.relativeError = 1e-3});
        expectClose(found.total,
                    0.6 * 10.0 * 2.0 / (3.0 * pi) *
                        (std::sin(phase_rad) + (pi - phase_rad) * std::cos(phase_rad)),
                    "ball in the sun", 2e-3);
        EXPECT_EQ(found.between.value, 0.0);
    }
}

TEST(PathTracerTest, SkyAndGroundLightAPlateByItsTilt) {
    for (const double tilt_rad : {0.0, 0.5, 1.5, 2.5}) {
        const Vec3 normal = towards(0.0, pi / 2 - tilt_rad);
        const Vec3 v{0, std::cos(tilt_rad), -std::sin(tilt_rad)};
        const TracedLight found = PathTracer(plate({}, {1, 0, 0}, v, {0.0, 0.7}),
                                             {.sky_W_m2_sr = 2.0, .ground_W_m2_sr = 5.0})
                                      .intensity(normal);
        const double ofSky = 0.5 * (1 + std::cos(tilt_rad));
        expectClose(found.total, 4.0 * 0.7 * (2.0 * ofSky + 5.0 * (1 - ofSky)), "tilted plate");
        EXPECT_EQ(found.total.value, found.onceFromOutside.value);
    }
}

TEST(PathTracerTest, ASphericalCavityIsDarkerThanABlackBody) {
    // Sparrow and Jonsson 1962: the radiance of a grey sphere with an opening of half angle a is
    // the same everywhere inside, e / (1 - (1 - e) (1 + cos a) / 2) of a black body. Facets have
    // the same factors where all see each other's fronts.
    for (const double emissivity : {0.3, 0.7}) {
        const double opening_rad = 0.5;
        const Surface surface{emissivity, 1 - emissivity};
        const PathTracer tracer(ball(1.0, opening_rad, 64, true, [&](double) { return surface; }),
                                {});
        const double closed = 0.5 * (1 + std::cos(opening_rad));
        const double apparent = emissivity / (1 - (1 - emissivity) * closed);
        const double opening_m2 = pi * std::pow(std::sin(opening_rad), 2);
        // From above what is seen through the backs of the walls beside the opening is of the same
        // radiance: all of the disc.
        const TracedLight found = tracer.intensity({0, 0, 1}, {.relativeError = 1e-3});
        expectClose(found.total, apparent * pi, "spherical cavity, all of its disc", 2e-3);
        EXPECT_GT(found.total.value, apparent * opening_m2);
    }
}

TEST(PathTracerTest, ASphereSpreadsWhatAPartOfItEmits) {
    // Every two places of a sphere have the same view factor: what is reflected is the same
    // everywhere.
    const double reflectivity = 0.9, part = 0.5 * (1 - std::cos(0.5));
    const PathTracer tracer(ball(1.0, 0.0, 60, true,
                                 [&](double polar_rad) {
                                     return Surface{polar_rad < 0.5 ? 4.0 : 0.0, reflectivity};
                                 }),
                            {});
    const TracedLight found = tracer.intensity({1, 0, 0}, {.relativeError = 1e-3});
    // The rings end at 0.4974 rad and the next at 0.5498.
    const double emitting = 0.5 * (1 - std::cos(pi * 10 / 60));
    EXPECT_NEAR(emitting, part, 0.01);
    expectClose(found.between, pi * reflectivity * 4.0 * emitting / (1 - reflectivity),
                "sphere, reflected", 3e-3);
    expectClose(found.onceFromOthers, pi * reflectivity * 4.0 * emitting, "sphere, reflected once",
                3e-3);
}

TEST(PathTracerTest, BouncesCountWaysFromFacetToFacet) {
    // A room of equal walls in which all emit: n ways give the first n terms of a series.
    const double reflectivity = 0.6;
    const Triangles walls = room({1, 1, 1}, [&](int) { return Surface{1.0, reflectivity}; });
    double expected = 0.0, power = 4.0;
    for (const int bounces : {0, 1, 2, 3}) {
        expected += power;
        power *= reflectivity;
        expectClose(PathTracer(walls, {}).intensity({0, 1, 0}, {.bounces = bounces}).total,
                    expected, "cubic room");
    }
}

TEST(PathTracerTest, BodiesAreSeenApart) {
    const PathTracer tracer(
        [] {
            Triangles all = plate({}, {1, 0, 0}, {0, 1, 0}, {2.0, 0.5, true});
            for (TracedTriangle triangle : plate({0.5, 0, 1}, {1, 0, 0}, {0, 1, 0}, {3.0, 0.5})) {
                triangle.body = 1;
                all.push_back(triangle);
            }
            return all;
        }(),
        {});
    const auto emitted = [&](std::optional<int> body) {
        return tracer.intensity({0, 0, 1}, {.body = body}).emitted;
    };
    expectClose(emitted(0), 2.0 * (4.0 - 3.0), "the lower, which the upper hides");
    expectClose(emitted(1), 3.0 * 4.0, "the upper");
    expectClose(emitted({}), 2.0 + 12.0, "both");
}

TEST(PathTracerTest, StatedErrorsAreThoseThatAreMade) {
    const Triangles body = joined({plate({}, {1, 0, 0}, {0, 1, 0}, {0.0, 0.8, true}),
                                   plate({-1, 0, 0.5}, {0, 1, 0}, {0, 0, 0.5}, {2.0, 0.5, true})});
    const PathTracer tracer(body, {});
    const Vec3 to = towards(1.2, 0.6);
    const double truth = tracer.intensity(to, {.relativeError = 2e-5, .seed = 99}).between.value;
    int covered = 0;
    constexpr int runs = 40;
    for (unsigned seed = 1; seed <= runs; ++seed) {
        const TracedValue found =
            tracer.intensity(to, {.relativeError = 1e-2, .seed = seed}).between;
        covered += std::abs(found.value - truth) <= 2.0 * found.error ? 1 : 0;
    }
    std::printf("  within two standard errors: %d of %d\n", covered, runs);
    EXPECT_GE(covered, 33);
}

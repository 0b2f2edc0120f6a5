#include "irsg/gas/FieldWalls.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/gas/PlumeFields.h"

using namespace irsg;
using namespace smat::test;

namespace {

using Surface = FieldWalls::Surface;

/// Edges along which not as many triangles go in one sense as in the other.
int openEdges(const Surface& surface) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& triangle : surface.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
            edges[std::minmax(from, to)] += from < to ? 1 : -1;
        }
    }
    int open = 0;
    for (const auto& [edge, sum] : edges) {
        open += sum != 0 ? 1 : 0;
    }
    return open;
}

/// Above 0 where triangles look outwards.
double volume_m3(const Surface& surface) {
    double six_m3 = 0.0;
    for (const auto& [i, j, k] : surface.triangles) {
        const auto &a = surface.vertices_m[i], &b = surface.vertices_m[j],
                   &c = surface.vertices_m[k];
        six_m3 += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return six_m3 / 6.0;
}

PlumeField ball() {
    return fieldOfPart({planes(-1, 1, 41), planes(-1, 1, 41), planes(-1, 1, 41)}, 888.0,
                       [](double x_m, double y_m, double z_m) {
                           return std::max(0.0, 1.0 - std::hypot(x_m, y_m, z_m));
                       });
}

TEST(FieldWalls, OfABallAreSpheres) {
    const FieldWalls walls(ball(), 289.0, 50000);
    for (const double radius_m : {0.25, 0.5, 0.75}) {
        const double from_K = 288.0 + 600.0 * (1.0 - radius_m);
        const Surface surface = walls.surfaceFrom(from_K);
        EXPECT_EQ(openEdges(surface), 0) << radius_m;
        EXPECT_NEAR(volume_m3(surface) / (4.0 / 3.0 * std::numbers::pi * std::pow(radius_m, 3)),
                    1.0, 0.035)
            << radius_m;
        for (const GasVector& place_m : surface.vertices_m) {
            ASSERT_NEAR(std::hypot(place_m[0], place_m[1], place_m[2]), radius_m, 0.01);
            ASSERT_NEAR(walls.temperature_K(place_m), from_K, 3.0);
        }
    }
}

TEST(FieldWalls, OfOneGasAreItsBox) {
    const PlumeField field = fieldOfPart({planes(0, 3, 4), planes(-1, 1, 3), planes(0, 1, 2)},
                                         800.0, [](double, double, double) { return 1.0; });
    const FieldWalls walls(field, 800.0, 1000);
    const Surface surface = walls.surfaceFrom(0.0);
    EXPECT_EQ(openEdges(surface), 0);
    EXPECT_NEAR(volume_m3(surface), 6.0, 0.06);
    EXPECT_NEAR(walls.temperature_K({1.5, 0.0, 0.5}), 800.0, 1e-9);
    EXPECT_LT(walls.temperature_K({1.5, 0.0, 1.5}), walls.nothing_K());
}

TEST(FieldWalls, EndWhereTheFieldDoesEachInTheOneBefore) {
    // Cut off where it is hottest, and not round.
    const PlumeField field =
        fieldOfPart({planes(0, 4, 60), planes(-1.2, 1.2, 41), planes(-1.2, 1.2, 41)}, 900.0,
                    [](double x_m, double y_m, double z_m) { return jetPart(x_m, y_m, z_m, 2.0); });
    const FieldWalls walls(field, 300.0, 40000);
    double volume = 0.0, before_K = 1e9;
    for (const double from_K : {880.0, 700.0, 500.0, 400.0, 330.0, 320.0, 319.0, 318.99}) {
        const Surface surface = walls.surfaceFrom(from_K);
        EXPECT_EQ(openEdges(surface), 0) << from_K;
        EXPECT_GT(volume_m3(surface), volume) << from_K;
        volume = volume_m3(surface);
        // Vertices keep clear of nodes, which moves them by up to a hundredth of an edge.
        const double clear_K = std::min(10.0, before_K - from_K);
        for (const GasVector& place_m : surface.vertices_m) {
            ASSERT_LT(walls.temperature_K(place_m), before_K - clear_K + 10.0);
        }
        before_K = from_K;
    }
}

TEST(FieldWalls, GoAroundWhatIsNoGas) {
    PlumeField whole = fieldOfPart({planes(0, 1, 11), planes(0, 1, 11), planes(0, 1, 11)}, 800.0,
                                   [](double, double, double) { return 1.0; });
    std::vector<PlumeField::Node> nodes = whole.nodes();
    for (std::size_t x = 6; x < 11; ++x) {
        for (std::size_t i = 0; i < 121; ++i) {
            nodes[x * 121 + i].isGas = false;
        }
    }
    const PlumeField half = PlumeField::ofNodes(whole.axes_m(), nodes);
    const Surface surface = FieldWalls(half, 800.0, 20000).surfaceFrom(0.0);
    EXPECT_EQ(openEdges(surface), 0);
    EXPECT_NEAR(volume_m3(surface), 0.55, 0.03);
    EXPECT_EQ(half.at({0.9, 0.5, 0.5}).fraction(HotGas::CO2), 0.0);
    EXPECT_NEAR(half.at({0.2, 0.5, 0.5}).fraction(HotGas::CO2), 0.04, 1e-7);
}

TEST(FieldWalls, WantAGridOfACell) {
    EXPECT_THROW(FieldWalls(ball(), 289.0, 7), LogicError);
}

} // namespace

#include "tools/samples/SampleModels.h"

#include <array>
#include <cmath>
#include <numbers>

namespace smat {

using irsg::Vec3;

FlightWriter sphereModel(int rings, int segments) {
    // One vertex for each pole, and a circle of them between each two zones.
    std::vector<FlightVertex> vertices;
    const auto add = [&](const Vec3& p) { vertices.push_back({p, p}); };
    add({0, 0, -1});
    for (int ring = 1; ring < rings; ++ring) {
        const double latitude = std::numbers::pi * (static_cast<double>(ring) / rings - 0.5);
        for (int segment = 0; segment < segments; ++segment) {
            const double longitude = 2 * std::numbers::pi * segment / segments;
            add({std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                 std::sin(latitude)});
        }
    }
    add({0, 0, 1});

    const auto last = static_cast<std::uint32_t>(vertices.size() - 1);
    const auto index = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(1 + (ring - 1) * segments + segment % segments);
    };

    // Counter-clockwise seen from outside: about the south pole west, about the north pole east,
    // and strips that go east with the upper vertex first.
    FlightPrimitive south{FlightPrimitive::Kind::fan, {0}};
    FlightPrimitive north{FlightPrimitive::Kind::fan, {last}};
    for (int segment = 0; segment <= segments; ++segment) {
        south.indices.push_back(index(1, segments - segment));
        north.indices.push_back(index(rings - 1, segment));
    }
    std::vector<FlightPrimitive> primitives{south};
    for (int ring = 1; ring + 1 < rings; ++ring) {
        auto& strip = primitives.emplace_back();
        for (int segment = 0; segment <= segments; ++segment) {
            strip.indices.push_back(index(ring + 1, segment));
            strip.indices.push_back(index(ring, segment));
        }
    }
    primitives.push_back(north);

    FlightWriter writer("sphere");
    writer.addMesh({.name = "sphere", .codes = {1, 1}}, vertices, primitives);
    return writer;
}

FlightWriter boxModel() {
    constexpr double x = 1.0, y = 2.0, z = 0.5;
    struct Side {
        const char* name;
        Vec3 normal;
        std::array<Vec3, 4> corners;
    };
    const std::array<Side, 6> sides{{
        {"nose", {0, 1, 0}, {{{x, y, -z}, {-x, y, -z}, {-x, y, z}, {x, y, z}}}},
        {"tail", {0, -1, 0}, {{{-x, -y, -z}, {x, -y, -z}, {x, -y, z}, {-x, -y, z}}}},
        {"starbrd", {1, 0, 0}, {{{x, -y, -z}, {x, y, -z}, {x, y, z}, {x, -y, z}}}},
        {"port", {-1, 0, 0}, {{{-x, y, -z}, {-x, -y, -z}, {-x, -y, z}, {-x, y, z}}}},
        {"top", {0, 0, 1}, {{{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}}}},
        {"bottom", {0, 0, -1}, {{{x, -y, -z}, {-x, -y, -z}, {-x, y, -z}, {x, y, -z}}}},
    }};
    FlightWriter writer("box");
    int temperature = 0;
    for (const auto& side : sides) {
        std::array<FlightVertex, 4> corners;
        for (std::size_t i = 0; i < 4; ++i)
            corners[i] = {side.corners[i], side.normal};
        FlightSurface surface{.name = side.name, .codes = {++temperature, 1}};
        surface.look.red = static_cast<std::uint8_t>(40 * temperature);
        writer.addFace(surface, corners);
    }
    return writer;
}

FlightWriter plateModel() {
    constexpr double h = 0.5;
    const Vec3 normal{0, 1, 0};
    const std::array<FlightVertex, 4> corners{
        {{{h, 0, -h}, normal}, {{-h, 0, -h}, normal}, {{-h, 0, h}, normal}, {{h, 0, h}, normal}}};
    FlightWriter writer("plate");
    writer.addFace({.name = "plate", .codes = {1, 1}, .twoSided = true}, corners);
    return writer;
}

} // namespace smat

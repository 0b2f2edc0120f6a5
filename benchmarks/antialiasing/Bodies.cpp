#include "benchmarks/antialiasing/Bodies.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"

namespace irsg::study {

namespace {

const IrCodes grey{1, 1};
constexpr double emissivity = 0.9, temperature_K = 320.0;
constexpr int outlineLines = 4000;

test::Triangles boxAt(const Vec3& centre_m, const Vec3& half_m) {
    test::Triangles mesh = test::boxMesh(half_m, std::vector<IrCodes>(6, grey));
    for (test::Triangle& triangle : mesh)
        for (Vec3& vertex : triangle.vertex)
            vertex = vertex + centre_m;
    return mesh;
}

/// 30 m long and wide, of boxes that pierce one another.
test::Triangles wingedBody() {
    test::Triangles mesh = boxAt({}, {1.5, 15.0, 1.7});
    for (const auto& part :
         {boxAt({0.0, 1.0, 0.5}, {15.0, 2.0, 0.3}), boxAt({0.0, -13.0, 0.8}, {5.0, 1.2, 0.2}),
          boxAt({0.0, -13.0, 3.5}, {0.2, 1.6, 3.0}), boxAt({6.0, 2.5, -0.6}, {0.8, 2.4, 0.8}),
          boxAt({-6.0, 2.5, -0.6}, {0.8, 2.4, 0.8})})
        mesh = test::joined(mesh, part);
    return mesh;
}

test::Triangles lShape() {
    return test::joined(test::plateMesh({-0.7, 0, 0}, {0, 0, 1}, {0.3, 0, 0}, grey),
                        test::plateMesh({0.3, 0, -0.8}, {0, 0, 0.2}, {0.7, 0, 0}, grey));
}

struct Point {
    double u, v; ///< right and up per unit depth
};

Point projected(const Vec3& vertex_m, const Viewpoint& camera, const Pose& pose) {
    const Vec3 eye = pose.toWorld(vertex_m) - camera.position_m;
    const double depth = -dot(eye, camera.backward);
    return {dot(eye, camera.right) / depth, dot(eye, camera.up) / depth};
}

/// Integral of the solid angle of a flat detector, (1 + u^2 + v^2)^-3/2, over u from 0.
double alongLine(double u, double v) {
    return u / ((1.0 + v * v) * std::sqrt(1.0 + u * u + v * v));
}

} // namespace

std::vector<Body> bodies() {
    return {{"sphere", test::sphereMesh(1.0, 48, 96, grey), 2.0, {}, 0.0, 0.0, true},
            {"L upright", lShape(), 2.0, {}, 0.0, 0.0, true},
            {"L turned by 7 deg", lShape(), 2.0, {0.0, 0.0, radians(7.0)}, 0.0, 0.0, true},
            {"plane at 30 deg", wingedBody(), 30.0, {}, radians(30.0), radians(30.0), false}};
}

std::vector<Body> chosenBodies(const Options& options) {
    std::vector<Body> chosen = bodies();
    if (!options.bodies.empty())
        std::erase_if(chosen, [&](const Body& body) {
            return std::ranges::find(options.bodies, body.name) == options.bodies.end();
        });
    return chosen;
}

double solidAngle_sr(const Body& body, const Viewpoint& camera, const Pose& pose) {
    if (!body.facesAdd)
        return solidAngleByLines_sr(body.mesh, camera, pose);
    const Vec3 from = pose.attitude.rotation().transposed() * (camera.position_m - pose.position_m);
    return test::convexSolidAngle_sr(body.mesh, from);
}

double solidAngleByLines_sr(const test::Triangles& mesh, const Viewpoint& camera,
                            const Pose& pose) {
    std::vector<std::array<Point, 3>> triangles;
    double bottom = 1e300, top = -1e300;
    for (const test::Triangle& triangle : mesh) {
        auto& points = triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            points[i] = projected(triangle.vertex[i], camera, pose);
            bottom = std::min(bottom, points[i].v);
            top = std::max(top, points[i].v);
        }
    }

    const double step = (top - bottom) / outlineLines;
    double sum = 0.0;
    std::vector<std::pair<double, double>> stretches;
    for (int line = 0; line < outlineLines; ++line) {
        const double v = bottom + (line + 0.5) * step;
        stretches.clear();
        for (const auto& points : triangles) {
            double left = 1e300, right = -1e300;
            for (std::size_t i = 0; i < 3; ++i) {
                const Point &a = points[i], &b = points[(i + 1) % 3];
                if ((a.v > v) == (b.v > v))
                    continue;
                const double u = a.u + (v - a.v) / (b.v - a.v) * (b.u - a.u);
                left = std::min(left, u);
                right = std::max(right, u);
            }
            if (left < right)
                stretches.emplace_back(left, right);
        }
        // What several faces cover counts once.
        std::ranges::sort(stretches);
        double reached = -1e300;
        for (const auto& [left, right] : stretches) {
            if (right <= reached)
                continue;
            sum += alongLine(right, v) - alongLine(std::max(left, reached), v);
            reached = right;
        }
    }
    return sum * step;
}

double greyRadiance_W_m2_sr() {
    return emissivity * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
}

Entity greyEntity(const test::Triangles& mesh) {
    return test::entityOf(test::modelOf(mesh), test::greyDatabase(emissivity, temperature_K));
}

Vec3 phaseShift_m(const Viewpoint& camera, double pixel_m, int step) {
    return camera.right * (std::fmod(step * 0.61803398875, 1.0) * pixel_m) +
           camera.up * (std::fmod(step * 0.41421356237, 1.0) * pixel_m);
}

test::Triangles cornerMarks(const Viewpoint& camera, const Vec3& origin_m, int width_px,
                            int height_px) {
    const double pixel_m = pixel_rad * length(camera.position_m - origin_m);
    const Vec3 right = camera.right * pixel_m, up = camera.up * pixel_m;
    const Vec3 corner = right * (0.5 * width_px - 1.0) + up * (0.5 * height_px - 1.0);
    return test::joined(test::plateMesh(corner, right * 0.5, up * 0.5, grey),
                        test::plateMesh(corner * -1.0, right * 0.5, up * 0.5, grey));
}

} // namespace irsg::study

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes one{1, 1};
constexpr double pixel_rad = 1e-4, emissivity = 0.9, temperature_K = 320.0;

/// A closed cylinder along y.
Triangles cylinderMesh(double radius_m, double halfLength_m, int sides) {
    Triangles mesh;
    const auto rim = [&](int i, double y) {
        const double angle = 2.0 * pi * i / sides;
        return Vec3{radius_m * std::cos(angle), y, radius_m * std::sin(angle)};
    };
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
        mesh.push_back({{a, b, c}, {normal, normal, normal}, one});
    };
    for (int i = 0; i < sides; ++i) {
        const Vec3 nearA = rim(i, -halfLength_m), nearB = rim(i + 1, -halfLength_m);
        const Vec3 farA = rim(i, halfLength_m), farB = rim(i + 1, halfLength_m);
        const Vec3 outward = normalized(Vec3{nearA.x + nearB.x, 0, nearA.z + nearB.z});
        add(nearA, farA, farB, outward);
        add(nearA, farB, nearB, outward);
        add({0, -halfLength_m, 0}, nearA, nearB, {0, -1, 0});
        add({0, halfLength_m, 0}, farB, farA, {0, 1, 0});
    }
    return mesh;
}

struct Errors {
    double squares = 0.0, worst = 0.0, step = 0.0, before = 0.0;
    int count = 0;

    void add(double error) {
        squares += error * error;
        worst = std::max(worst, std::abs(error));
        if (count++ > 0) {
            step = std::max(step, std::abs(error - before));
        }
        before = error;
    }
    double rms() const { return std::sqrt(squares / count); }
};

/// Seen from beside in steps of a degree, at phases of the pixels that are irrational to
/// every lattice; against the solid angle.
Errors errorsOf(const Triangles& mesh, int tileSide_samples, double pixels, double length_m,
                double pitch_deg) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = tileSide_samples;
    settings.background = BackgroundMode::constant;
    irsg.scene.settings = settings;
    irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(emissivity, temperature_K))};
    const double range_m = length_m / (pixels * pixel_rad);
    const double radiance_W_m2_sr =
        emissivity * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
    Errors errors;
    for (int step = 0; step < 24; ++step) {
        irsg.scene.entities[0].pose = {{0, 0, standingAltitude_m}, {0, radians(pitch_deg), 0}};
        look(irsg, {.range_m = range_m,
                    .azimuth_rad = radians(70.0 + step),
                    .elevation_rad = 0.0,
                    .width_px = 200,
                    .height_px = 200,
                    .fieldOfView_rad = 2.0 * std::atan(100.0 * pixel_rad)});
        const Viewpoint& camera = irsg.view.viewpoint;
        const double pixel_m = pixel_rad * range_m;
        Pose pose = irsg.scene.entities[0].pose;
        pose.position_m = pose.position_m +
                          camera.right * (std::fmod(step * 0.61803398875, 1.0) * pixel_m) +
                          camera.up * (std::fmod(step * 0.41421356237, 1.0) * pixel_m);
        irsg.scene.entities[0].pose = pose;
        const Vec3 away = camera.position_m - pose.position_m;
        const Vec3 from = pose.attitude.rotation().transposed() * away;
        const double truth = radiance_W_m2_sr * convexSolidAngle_sr(mesh, from) * dot(away, away);
        errors.add(irsg.measure().all.intensity_W_sr / truth - 1.0);
    }
    return errors;
}

} // namespace

TEST(ThinBody, KeepsItsIntensityAtAnyInclinationAndLength) {
    struct Body {
        const char* name;
        Triangles mesh;
        double length_m;
        /// RMS at windows of 128: where it lies level, and at any inclination. A wire is thinner
        /// than a sample where its window is as high as it is wide.
        double mostLevel, most;
    };
    const std::vector<IrCodes> sides(6, one);
    const Body bodies[] = {
        {"wire", cylinderMesh(0.02, 5.0, 12), 10.0, 2e-3, 1.2e-2},
        {"pipe", cylinderMesh(0.15, 5.0, 24), 10.0, 1.5e-3, 3e-3},
        {"missile", cylinderMesh(0.4, 5.0, 24), 10.0, 1.5e-3, 1.5e-3},
        {"rail", boxMesh({0.05, 5.0, 0.08}, sides), 10.0, 1.5e-3, 3e-3},
        {"plank", boxMesh({1.0, 7.0, 0.1}, sides), 14.0, 2e-3, 3e-3},
    };
    for (const auto& [tileSide_samples, finer] : {std::pair{128, 1.0}, {256, 0.5}}) {
        for (const Body& body : bodies) {
            for (const double pitch_deg : {0.0, 0.4, 3.0, 27.0, 88.0, 90.0}) {
                for (const double pixels : {140.0, 23.0, 0.7}) {
                    const Errors errors =
                        errorsOf(body.mesh, tileSide_samples, pixels, body.length_m, pitch_deg);
                    const double most = finer * (pitch_deg == 0.0 ? body.mostLevel : body.most);
                    const std::string which =
                        std::string(body.name) + " at " + std::to_string(pitch_deg) + " deg, " +
                        std::to_string(pixels) + " px, window " + std::to_string(tileSide_samples);
                    EXPECT_LT(errors.rms(), most) << which;
                    EXPECT_LT(errors.worst, 3.0 * most) << which;
                    EXPECT_LT(errors.step, 3.0 * most) << which;
                    std::printf("%d %-8s %4.1f deg %5.1f px: RMS %.1e, largest %.1e, step %.1e\n",
                                tileSide_samples, body.name, pitch_deg, pixels, errors.rms(),
                                errors.worst, errors.step);
                }
            }
        }
    }
}

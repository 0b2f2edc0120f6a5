#include "irsg/geometry/view/Pose.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {
namespace {

constexpr Vec3 starboard{1, 0, 0}, nose{0, 1, 0}, top{0, 0, 1};
constexpr Vec3 port{-1, 0, 0}, tail{0, -1, 0}, belly{0, 0, -1};
constexpr Vec3 east{1, 0, 0}, north{0, 1, 0}, up{0, 0, 1};
constexpr Vec3 west{-1, 0, 0}, south{0, -1, 0}, down{0, 0, -1};
const double diagonal = std::sqrt(0.5);

void expectNear(const Vec3& found, const Vec3& expected, double tolerance = 1e-14,
                const std::string& what = "") {
    EXPECT_NEAR(found.x, expected.x, tolerance) << what << " x";
    EXPECT_NEAR(found.y, expected.y, tolerance) << what << " y";
    EXPECT_NEAR(found.z, expected.z, tolerance) << what << " z";
}

/// Right-handed, of unit length, and orthogonal.
void expectCameraFrame(const Viewpoint& view) {
    expectNear(cross(view.right, view.up), view.backward);
    EXPECT_NEAR(length(view.right), 1.0, 1e-14);
    EXPECT_NEAR(length(view.up), 1.0, 1e-14);
    EXPECT_NEAR(dot(view.right, view.up), 0.0, 1e-14);
}

Attitude attitudeOf(double yaw_deg, double pitch_deg, double roll_deg) {
    return {radians(yaw_deg), radians(pitch_deg), radians(roll_deg)};
}

TEST(Vectors, AreRightHanded) {
    expectNear(cross(east, north), up, 0.0);
    EXPECT_EQ(dot({1, 2, 3}, {4, -5, 6}), 12.0);
    EXPECT_DOUBLE_EQ(length({2, 3, 6}), 7.0);
    expectNear(normalized({0, 0, -4}), down, 0.0);
}

TEST(Vectors, HaveALengthAtAnyMagnitude) {
    EXPECT_DOUBLE_EQ(length({3e200, 4e200, 0}), 5e200);
    EXPECT_DOUBLE_EQ(length({3e-200, 4e-200, 0}), 5e-200);
    expectNear(normalized({0, 3e-200, 4e-200}), {0, 0.6, 0.8});
}

TEST(Vectors, WithoutLengthHaveNoDirection) {
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_THROW(normalized({0, 0, 0}), LogicError);
    EXPECT_THROW(normalized({inf, 0, 0}), LogicError);
    EXPECT_THROW(normalized({std::nan(""), 0, 0}), LogicError);
}

TEST(Attitude, TurnsTheAxesOfTheModelAsItsNamesSay) {
    const struct {
        const char* name;
        Attitude attitude;
        Vec3 starboard, nose, top;
    } rows[] = {
        {"level, heading north", attitudeOf(0, 0, 0), east, north, up},
        {"yaw 90 looks west, heading = -yaw", attitudeOf(90, 0, 0), north, west, up},
        {"yaw -90 looks east", attitudeOf(-90, 0, 0), south, east, up},
        {"yaw 180 looks south", attitudeOf(180, 0, 0), west, south, up},
        {"pitch 90 nose up", attitudeOf(0, 90, 0), east, up, south},
        {"pitch -90 nose down", attitudeOf(0, -90, 0), east, down, north},
        {"roll 90 starboard down", attitudeOf(0, 0, 90), down, north, east},
        {"roll -90 starboard up", attitudeOf(0, 0, -90), up, north, west},
        {"pitch 45", attitudeOf(0, 45, 0), east, {0, diagonal, diagonal}, {0, -diagonal, diagonal}},
        {"roll 45", attitudeOf(0, 0, 45), {diagonal, 0, -diagonal}, north, {diagonal, 0, diagonal}},
        {"yaw 45", attitudeOf(45, 0, 0), {diagonal, diagonal, 0}, {-diagonal, diagonal, 0}, up},
        {"roll, then pitch, then yaw", attitudeOf(90, 90, 90), west, up, north},
        {"roll about the pitched nose", attitudeOf(0, 90, 90), north, up, east},
    };
    for (const auto& row : rows) {
        const Rotation r = row.attitude.rotation();
        expectNear(r * starboard, row.starboard, 1e-15, row.name);
        expectNear(r * nose, row.nose, 1e-15, row.name);
        expectNear(r * top, row.top, 1e-15, row.name);
    }
}

TEST(Attitude, IsARotationWhoseTransposeTakesItBack) {
    for (double yaw = -3; yaw < 3; yaw += 0.7) {
        for (double pitch = -1.5; pitch < 1.5; pitch += 0.4) {
            for (double roll = -3; roll < 3; roll += 0.9) {
                const Rotation r = Attitude{yaw, pitch, roll}.rotation();
                expectNear(r.transposed() * (r * Vec3{1, -2, 3}), {1, -2, 3});
                expectNear((r.transposed() * r) * Vec3{1, -2, 3}, {1, -2, 3});
                expectNear(cross(r * starboard, r * nose), r * top);
            }
        }
    }
}

TEST(Attitude, PitchOfTheNoseIsItsElevationWhateverYawAndRoll) {
    for (const double yaw : {-2.0, 0.3, 3.0}) {
        for (const double roll : {-1.0, 0.0, 2.5}) {
            expectNear(Attitude{yaw, 0.4, roll}.rotation() * nose, direction(-yaw, 0.4));
        }
    }
}

TEST(Pose, PlacesModelPointsInTheWorld) {
    const Pose pose{{100, 200, 50}, attitudeOf(90, 0, 0)};
    expectNear(pose.toWorld({0, 0, 0}), {100, 200, 50}, 0.0);
    expectNear(pose.toWorld({0, 10, 0}), {90, 200, 50}, 1e-13);
    expectNear(pose.toWorld({3, 0, 1}), {100, 203, 51}, 1e-13);
}

TEST(Direction, RunsFromNorthOverEastAndUp) {
    expectNear(direction(0, 0), north);
    expectNear(direction(radians(90), 0), east);
    expectNear(direction(radians(180), 0), south);
    expectNear(direction(radians(270), 0), west);
    expectNear(direction(1.234, radians(90)), up);
    expectNear(direction(1.234, radians(-90)), down);
    // The sun in the south-west at 30 degrees.
    expectNear(direction(radians(225), radians(30)), {-std::sqrt(0.375), -std::sqrt(0.375), 0.5});
}

TEST(CameraAbout, SeesTheSideThatItsAzimuthNames) {
    const struct {
        const char* name;
        double azimuth_deg, elevation_deg;
        Vec3 position, right, up;
    } rows[] = {
        {"0 looks at the nose", 0, 0, nose * 10, port, top},
        {"90 sees the starboard side", 90, 0, starboard * 10, nose, top},
        {"180 sees the tail", 180, 0, tail * 10, starboard, top},
        {"270 sees the port side", 270, 0, port * 10, tail, top},
        {"from above, tail up", 0, 90, top * 10, port, tail},
        {"from below, nose up", 0, -90, belly * 10, port, nose},
        {"30 degrees above the nose",
         0,
         30,
         {0, 10 * std::cos(radians(30)), 5},
         port,
         {0, -0.5, std::cos(radians(30))}},
    };
    for (const auto& row : rows) {
        const Viewpoint view = Viewpoint::about({0, 0, 0}, 0.0, radians(row.azimuth_deg),
                                                radians(row.elevation_deg), 10.0);
        expectNear(view.position_m, row.position, 1e-14, row.name);
        expectNear(view.right, row.right, 1e-15, row.name);
        expectNear(view.up, row.up, 1e-15, row.name);
        expectNear(view.forward(), row.position * -0.1, 1e-15, row.name);
        expectCameraFrame(view);
    }
}

TEST(CameraAbout, LooksAtTheReferencePoint) {
    const Vec3 target{5, -7, 300};
    for (double azimuth = 0; azimuth < 6.3; azimuth += 0.5) {
        for (double elevation = -1.5; elevation < 1.5; elevation += 0.3) {
            const Viewpoint view = Viewpoint::about(target, 0.8, azimuth, elevation, 1234.5);
            expectNear(view.position_m + view.forward() * 1234.5, target, 1e-12);
            expectCameraFrame(view);
            const Viewpoint same = Viewpoint::lookAt(view.position_m, target);
            expectNear(same.right, view.right, 1e-12);
            expectNear(same.up, view.up, 1e-12);
        }
    }
}

TEST(CameraAbout, TurnsWithTheModel) {
    // Model and camera turned together: every point of the model keeps its place in the picture.
    const Vec3 point{1, -2, 3};
    const auto inCamera = [&](double yaw, double azimuth, double elevation) {
        const Viewpoint view = Viewpoint::about({0, 0, 0}, yaw, azimuth, elevation, 50.0);
        const Vec3 offset = Pose{{0, 0, 0}, {yaw, 0, 0}}.toWorld(point) - view.position_m;
        return Vec3{dot(offset, view.right), dot(offset, view.up), dot(offset, view.backward)};
    };
    for (const double azimuth : {0.0, 1.0, 4.0}) {
        for (const double elevation : {-1.4, 0.2, radians(90)}) {
            for (double yaw = -3; yaw < 3.2; yaw += 0.37) {
                expectNear(inCamera(yaw, azimuth, elevation), inCamera(0.0, azimuth, elevation),
                           1e-13);
            }
        }
    }
}

TEST(CameraAbout, YawOfTheModelAloneIsAnAzimuthOfTheCamera) {
    // Model-Yaw: the camera stays where the nose pointed, and the model turns counter-clockwise
    // seen from above: after a quarter turn its starboard side faces the camera.
    const Viewpoint fixed = Viewpoint::about({0, 0, 0}, 0.0, 0.0, 0.0, 10.0);
    const Viewpoint turned = Viewpoint::about({0, 0, 0}, radians(90), radians(90), 0.0, 10.0);
    expectNear(turned.position_m, fixed.position_m, 1e-14);
    expectNear(Pose{{0, 0, 0}, attitudeOf(90, 0, 0)}.toWorld(starboard * 10), fixed.position_m,
               1e-14);
}

TEST(CameraAbout, DoesNotJumpAtTheZenith) {
    const Viewpoint before = Viewpoint::about({0, 0, 0}, 0, 0.3, radians(90) - 1e-9, 10);
    const Viewpoint after = Viewpoint::about({0, 0, 0}, 0, 0.3, radians(90) + 1e-9, 10);
    expectNear(before.up, after.up, 1e-8);
    expectNear(before.right, after.right, 1e-8);
    expectCameraFrame(Viewpoint::about({0, 0, 0}, 0, 0.3, radians(90), 10));
    expectCameraFrame(Viewpoint::about({0, 0, 0}, 0, 0.3, radians(-90), 10));
}

TEST(CameraElevation, GoesFrontBellyTailTop) {
    const struct {
        double angle_deg;
        Vec3 position, up;
    } rows[] = {
        {0, nose, top},     {90, belly, nose},
        {180, tail, belly}, {270, top, tail},
        {360, nose, top},   {45, {0, diagonal, -diagonal}, {0, diagonal, diagonal}},
    };
    for (const auto& row : rows) {
        const Viewpoint view =
            Viewpoint::aroundPitchPlane({0, 0, 0}, {}, radians(row.angle_deg), 10.0);
        const std::string name = std::to_string(row.angle_deg);
        expectNear(view.position_m, row.position * 10, 1e-14, name);
        expectNear(view.up, row.up, 1e-15, name);
        expectNear(view.right, port, 1e-15, name);
        expectNear(view.forward(), row.position * -1.0, 1e-15, name);
        expectCameraFrame(view);
    }
}

TEST(CameraElevation, StaysInTheFrameOfTheModel) {
    const Vec3 centre{10, 20, 3000};
    const Attitude attitude = attitudeOf(30, 20, -40);
    const Rotation r = attitude.rotation();
    for (double angle = 0; angle < 6.3; angle += 0.4) {
        const Viewpoint level = Viewpoint::aroundPitchPlane({0, 0, 0}, {}, angle, 100.0);
        const Viewpoint view = Viewpoint::aroundPitchPlane(centre, attitude, angle, 100.0);
        expectNear(view.position_m, centre + r * level.position_m, 1e-12);
        expectNear(view.up, r * level.up, 1e-14);
        expectNear(view.right, r * level.right, 1e-14);
        expectCameraFrame(view);
    }
}

TEST(LookAt, TurnsTheUpHintIntoThePlaneOfTheView) {
    const Viewpoint view = Viewpoint::lookAt({0, -10, 10}, {0, 0, 0});
    expectNear(view.right, east);
    expectNear(view.up, {0, diagonal, diagonal});
    expectNear(view.backward, {0, -diagonal, diagonal});
    expectCameraFrame(view);
    // The length of the hint does not count, nor the distance.
    expectNear(Viewpoint::lookAt({0, -1e-6, 1e-6}, {0, 0, 0}, {0, 0, 1e-20}).up, view.up);
}

TEST(LookAt, StraightUpOrDownTakesTheOtherUp) {
    const struct {
        const char* name;
        Vec3 position, hint, fallback, up;
    } rows[] = {
        {"down", {0, 0, 10}, up, north, north},
        {"up", {0, 0, -10}, up, north, north},
        {"down, a hair off", {1e-12, 0, 10}, up, north, north},
        {"along a hint that lies", {0, 10, 0}, north, up, up},
        {"down, fallback down as well", {0, 0, 10}, up, down, north},
        {"null hint", {0, 0, 10}, {0, 0, 0}, north, north},
    };
    for (const auto& row : rows) {
        const Viewpoint view = Viewpoint::lookAt(row.position, {0, 0, 0}, row.hint, row.fallback);
        expectCameraFrame(view);
        expectNear(view.up, row.up, 1e-11, row.name);
    }
    EXPECT_THROW(Viewpoint::lookAt({1, 2, 3}, {1, 2, 3}), LogicError);
}

TEST(Poses, KeepTheirPrecisionSixThousandKilometresFromTheOrigin) {
    const Vec3 far{6.4e6, -6.4e6, 6.4e6};
    const Viewpoint near = Viewpoint::about({0, 0, 0}, 0.3, 1.1, 0.4, 1000.0);
    const Viewpoint view = Viewpoint::about(far, 0.3, 1.1, 0.4, 1000.0);
    expectNear(view.right, near.right, 0.0);
    expectNear(view.up, near.up, 0.0);
    expectNear(view.position_m - far, near.position_m, 1e-9 * 6.4e6 * 1e-6);

    // The target in the camera's frame: straight ahead at the range, to 1e-9 of it.
    const Vec3 offset = far - view.position_m;
    EXPECT_NEAR(dot(offset, view.forward()), 1000.0, 1e-9 * 1000.0 * 10);
    EXPECT_NEAR(length(offset) / 1000.0, 1.0, 1e-9);
    expectNear(Viewpoint::lookAt(view.position_m, far).backward, near.backward, 1e-11);

    const Pose pose{far, attitudeOf(10, 20, 30)};
    expectNear(pose.toWorld({1, 2, 3}) - far, pose.attitude.rotation() * Vec3{1, 2, 3}, 2e-9);
}

} // namespace
} // namespace irsg

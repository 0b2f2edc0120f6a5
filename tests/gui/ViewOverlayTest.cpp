#include <array>
#include <cmath>

#include "gui/view/ViewOverlay.h"
#include "gui/widgets/Theme.h"
#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/SceneBuilder.h"
#include "tests/gui/ViewFixture.h"

namespace smat::gui {
namespace {

using irsg::Vec3;
using test::apart;

const QColor red("#d64545"), green("#2f9e58"), blue("#3b7be0"), yellow("#ffcc00");

/// The camera's axes, written down for themselves: r to the right, u up, f forward.
struct Axes {
    Vec3 r, u, f;
};
Axes axesAt(double azimuth_deg, double elevation_deg) {
    const double a = irsg::radians(azimuth_deg);
    const double e = irsg::radians(elevation_deg);
    return {{-std::cos(a), std::sin(a), 0.0},
            {-std::sin(a) * std::sin(e), -std::cos(a) * std::sin(e), std::cos(e)},
            {-std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), -std::sin(e)}};
}

class ViewOverlayTest : public test::ViewFixture {
  protected:
    /// Where the end of an arrow from the model's centre is seen, 500 m away.
    QPointF seenAt(const Vec3& arrow_m) const {
        const Axes axes = axesAt(view.camera().azimuth_deg, view.camera().elevation_deg);
        const double depth_m = view.camera().range_m + irsg::dot(arrow_m, axes.f);
        const double focal_px =
            0.5 * view.width() / std::tan(0.5 * irsg::radians(project.settings[key::sensorFov]));
        return {0.5 * view.width() + focal_px * irsg::dot(arrow_m, axes.r) / depth_m,
                0.5 * view.height() - focal_px * irsg::dot(arrow_m, axes.u) / depth_m};
    }
    /// Within a pixel of the view, of which the picture may have several of its own.
    static bool has(const QImage& picture, const QPointF& at, const QColor& color) {
        const double ratio = picture.devicePixelRatio();
        const int reach = static_cast<int>(std::ceil(ratio));
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                const QPoint pixel(static_cast<int>(std::floor(ratio * at.x())) + dx,
                                   static_cast<int>(std::floor(ratio * at.y())) + dy);
                if (picture.rect().contains(pixel) &&
                    apart(picture.pixelColor(pixel), color) < 40) {
                    return true;
                }
            }
        }
        return false;
    }
    /// Parts of a line that have its colour, of 12; all for a line too short to tell.
    static int seenOf(const QImage& picture, const QPointF& from, const QPointF& to,
                      const QColor& color) {
        int seen = 0;
        for (int i = 1; i <= 12; ++i) {
            seen += has(picture, from + (to - from) * (0.2 + 0.75 * i / 12.0), color);
        }
        return seen;
    }
    QImage picture() {
        QTest::qWait(20);
        return view.grab().toImage();
    }
    void lookFrom(double azimuth_deg, double elevation_deg) {
        project.settings.set("camera.azimuth", azimuth_deg);
        set("camera.elevation", QString::number(elevation_deg).toStdString());
    }
    /// Size of the model's axes as the view chooses it: 0.4 of the smaller side at most.
    double axis_m() const {
        const double metresPerPixel =
            view.camera().range_m /
            (0.5 * view.width() / std::tan(0.5 * irsg::radians(project.settings[key::sensorFov])));
        return 0.4 * view.height() * metresPerPixel;
    }
    QPointF centre() const { return {0.5 * view.width(), 0.5 * view.height()}; }
};

constexpr std::array<std::pair<double, double>, 8> directions{
    {{20, 10}, {65, -15}, {110, 35}, {155, 5}, {200, -40}, {250, 60}, {295, -25}, {340, -5}}};

TEST_F(ViewOverlayTest, TheSunVectorPointsToTheSunFromEightDirections) {
    Project shown = sample("ship");
    shown.settings.set("camera.range", 700);
    shown.settings.set("environment.sunAzimuth", 135);
    shown.settings.set("environment.sunElevation", 40);
    shown.settings.set("target.altitude", 2000);
    ASSERT_NO_FATAL_FAILURE(show(shown));
    view.overlay().setSunVectorVisible(true);
    const double a = irsg::radians(135.0);
    const double e = irsg::radians(40.0);
    const Vec3 sun{std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
    for (const auto& [azimuth, elevation] : directions) {
        SCOPED_TRACE(azimuth);
        lookFrom(azimuth, elevation);
        const QImage seen = picture();
        const QPointF tip = seenAt(sun * (1.3 * axis_m()));
        EXPECT_GE(seenOf(seen, centre(), tip, yellow), 11);
        // The sun itself at its end, and nothing beyond.
        EXPECT_TRUE(has(seen, tip, yellow));
        const QPointF outwards = (tip - centre()) / QLineF(centre(), tip).length();
        EXPECT_TRUE(has(seen, tip + outwards * 4.0, yellow));
        EXPECT_FALSE(has(seen, tip + outwards * 11.0, yellow));
        // On the other side of the centre there is none.
        EXPECT_LE(seenOf(seen, centre(), centre() - (tip - centre()), yellow), 1);
    }
}

TEST_F(ViewOverlayTest, TheSunVectorPointsToTheSunOfAnEnvironmentFileAsThePictureHasIt) {
    const auto folder = test::freshFolder("environment-sun");
    irsg::toKarma(
        {.sun = {irsg::radians(250.0), irsg::radians(20.0)}, .background = {}, .composition = {}})
        .write(folder / "world.xml");
    Project shown = sample("ship");
    shown.settings.reset("environment.sunAzimuth");
    shown.settings.reset("environment.sunElevation");
    shown.settings.set("environment.atmospheres", (folder / "world.xml").string());
    shown.settings.set("camera.range", 700);
    shown.settings.set("target.altitude", 2000);
    ASSERT_NO_FATAL_FAILURE(show(shown));
    view.overlay().setSunVectorVisible(true);
    lookFrom(20, 10);
    const auto tipFor = [this](double azimuth_rad, double elevation_rad) {
        return seenAt(irsg::direction(azimuth_rad, elevation_rad) * (1.3 * axis_m()));
    };
    const irsg::SunPosition ofPicture = environmentOf(project, project.settings).sun;
    EXPECT_NEAR(irsg::degrees(ofPicture.azimuth_rad), 250.0, 1e-9);
    const QPointF tip = tipFor(ofPicture.azimuth_rad, ofPicture.elevation_rad);
    EXPECT_GE(seenOf(picture(), centre(), tip, yellow), 11);

    // What the project sets itself goes before it, for both.
    set("environment.sunAzimuth", "100");
    EXPECT_LE(seenOf(picture(), centre(), tip, yellow), 3);
    const irsg::SunPosition own = environmentOf(project, project.settings).sun;
    EXPECT_NEAR(irsg::degrees(own.elevation_rad), 20.0, 1e-9);
    EXPECT_GE(seenOf(picture(), centre(), tipFor(irsg::radians(100.0), own.elevation_rad), yellow),
              11);
}

TEST_F(ViewOverlayTest, TheModelsAxesTurnWithItFromEightDirections) {
    Project shown = sample("ship");
    shown.settings.set("camera.range", 700);
    shown.settings.set("target.altitude", 2000);
    shown.settings.set("target.yaw", 30);
    ASSERT_NO_FATAL_FAILURE(show(shown));
    view.overlay().setModelAxesVisible(true);
    const std::pair<Vec3, QColor> axes[] = {
        {{1, 0, 0}, red}, {{0, 1, 0}, green}, {{0, 0, 1}, blue}};
    for (const auto& [azimuth, elevation] : directions) {
        lookFrom(azimuth, elevation);
        const QImage seen = picture();
        for (const auto& [along, color] : axes) {
            // In the frame that turns with the yaw, camera and model stand as without it.
            const QPointF tip = seenAt(along * axis_m());
            EXPECT_GE(seenOf(seen, centre(), tip, color), 10)
                << azimuth << " " << color.name().toStdString();
        }
    }
    set("target.roll", "90");
    lookFrom(20, 10);
    // Starboard down: the axis to starboard points to the ground.
    EXPECT_GE(seenOf(picture(), centre(), seenAt({0, 0, -axis_m()}), red), 10);
}

TEST_F(ViewOverlayTest, TheWorldsAxesStandAtTheBottomLeftFromEightDirections) {
    ASSERT_NO_FATAL_FAILURE(show(sample("ship")));
    const QPointF origin(64.0, 300.0 - 64.0);
    const std::pair<Vec3, QColor> axes[] = {
        {{1, 0, 0}, red}, {{0, 1, 0}, green}, {{0, 0, 1}, blue}};
    for (const auto& [azimuth, elevation] : directions) {
        lookFrom(azimuth, elevation);
        const QImage seen = picture();
        const Axes camera = axesAt(azimuth, elevation);
        for (const auto& [along, color] : axes) {
            const QPointF tip =
                origin + QPointF(irsg::dot(along, camera.r), -irsg::dot(along, camera.u)) * 34.0;
            // Axes may lie in one line; the end of the longer one is its own.
            EXPECT_GE(seenOf(seen, origin, tip, color), 4)
                << azimuth << " " << color.name().toStdString();
        }
    }
}

TEST_F(ViewOverlayTest, EachOfTheThreeComesAndGoesForItself) {
    Project shown = sample("ship");
    shown.settings.set("camera.range", 700);
    shown.settings.set("target.altitude", 2000);
    shown.settings.set("environment.sunAzimuth", 10);
    shown.settings.set("environment.sunElevation", 35);
    ASSERT_NO_FATAL_FAILURE(show(shown));
    lookFrom(65, 25);
    const Axes camera = axesAt(65, 25);
    const QPointF origin(64.0, 300.0 - 64.0);
    const QPointF up = origin + QPointF(0.0, -camera.u.z * 34.0);
    const double a = irsg::radians(10.0);
    const double e = irsg::radians(35.0);
    const QPointF sun = seenAt(
        Vec3{std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)} * (1.3 * axis_m()));
    const QPointF nose = seenAt({0, axis_m(), 0});
    for (int bits = 0; bits < 8; ++bits) {
        SCOPED_TRACE(bits);
        view.overlay().setViewAxesVisible((bits & 1) != 0);
        view.overlay().setModelAxesVisible((bits & 2) != 0);
        view.overlay().setSunVectorVisible((bits & 4) != 0);
        const QImage seen = picture();
        EXPECT_EQ(seenOf(seen, origin, up, blue) >= 9, (bits & 1) != 0);
        EXPECT_EQ(seenOf(seen, centre(), nose, green) >= 9, (bits & 2) != 0);
        EXPECT_EQ(seenOf(seen, centre(), sun, yellow) >= 9, (bits & 4) != 0);
    }
}

TEST(ViewProjectionTest, ARayThroughThePictureOfAPointMeetsThePoint) {
    const auto eye = irsg::Viewpoint::lookAt({120, -300, 80}, {5, 6, 7});
    const auto projection = ViewProjection::of(eye, {640, 480}, 0.2);
    for (const Vec3& point : {Vec3{5, 6, 7}, {10, -20, 3}, {-7, 12, 20}}) {
        const Vec3 ray = projection.ray(projection.toWindow(point));
        const Vec3 back = eye.position_m + ray * irsg::length(point - eye.position_m);
        EXPECT_NEAR(irsg::length(back - point), 0.0, 1e-9);
    }
    EXPECT_NEAR(projection.toWindow({5, 6, 7}).x(), 320.0, 1e-9);
    EXPECT_NEAR(projection.toWindow({5, 6, 7}).y(), 240.0, 1e-9);
}

TEST(ViewProjectionTest, LinesAreCutBeforeTheEye) {
    const auto eye = irsg::Viewpoint::lookAt({0, 0, 0}, {0, 1, 0});
    const auto projection = ViewProjection::of(eye, {100, 100}, 1.0);
    EXPECT_FALSE(projection.line({0, -1, 0}, {1, -5, 0}));
    const auto cut = projection.line({0, 10, 0}, {5, -10, 0});
    ASSERT_TRUE(cut);
    EXPECT_NEAR(cut->p1().x(), 50.0, 1e-9);
    EXPECT_TRUE(std::isfinite(cut->p2().x()));
    EXPECT_GT(cut->p2().x(), 1e4);
}

TEST(ViewProjectionTest, TheSensorsFrameFitsIntoAnyWindow) {
    const ViewFrame frame{0.1, 640, 480};
    // As wide as the sensor, wider, and taller.
    EXPECT_EQ(fieldOfViewOf(frame, {320, 240}), 0.1);
    EXPECT_NEAR(fieldOfViewOf(frame, {640, 240}), 2.0 * std::atan(2.0 * std::tan(0.05)), 1e-12);
    EXPECT_EQ(fieldOfViewOf(frame, {320, 480}), 0.1);
    EXPECT_EQ(frameRectIn(frame, {640, 240}), QRectF(160, 0, 320, 240));
    EXPECT_EQ(frameRectIn(frame, {320, 480}), QRectF(0, 120, 320, 240));
}

} // namespace
} // namespace smat::gui

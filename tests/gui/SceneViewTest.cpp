#include "gui/view/SceneView.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <QTest>
#include <gtest/gtest.h>

#include "gui/workbench/Workbench.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/ProcessCounts.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui {
namespace {

class SceneViewTest : public ::testing::Test {
  protected:
    void SetUp() override {
        if (test::lacksGl()) {
            GTEST_SKIP() << "this desktop gives no OpenGL context";
        }
    }
    SceneViewTest() : project(loadProject(test::writeSampleProject(test::freshFolder("view")))) {
        view.resize(480, 360);
        view.setScene(loadDisplayScene(project, project.settings));
        lookFrom(60.0, 1000.0);
        view.show();
        view.showWholeModel();
        QTest::qWait(50);
    }
    /// Through the sensor of the project, standing there.
    void lookFrom(double azimuth_deg, double range_m) {
        Settings settings = project.settings;
        settings.set("camera.azimuth", azimuth_deg);
        settings.set("camera.range", range_m);
        view.setProject(project, settings);
    }
    Project project;
    SceneView view;
};

TEST(OrbitCameraTest, DraggingRightTurnsTheAzimuthUpAndWraps) {
    OrbitCamera camera{170.0, 0.0, 100.0};
    camera.turn(20.0, 100.0);
    EXPECT_DOUBLE_EQ(camera.azimuth_deg, -170.0);
    EXPECT_DOUBLE_EQ(camera.elevation_deg, 90.0);
}

TEST(OrbitCameraTest, StandsWhereTheProjectSays) {
    const auto nose = OrbitCamera{0.0, 0.0, 100.0}.viewpoint({}, 0.0);
    EXPECT_NEAR(nose.position_m.y, 100.0, 1e-9);
    const auto starboard = OrbitCamera{90.0, 30.0, 100.0}.viewpoint({}, 0.0);
    EXPECT_NEAR(starboard.position_m.x, 100.0 * std::cos(std::numbers::pi / 6.0), 1e-9);
    EXPECT_NEAR(starboard.position_m.z, 50.0, 1e-9);
}

TEST_F(SceneViewTest, DrawsOnDemandOnly) {
    const long before = view.frameCount();
    QTest::qWait(200);
    EXPECT_EQ(view.frameCount(), before);
    lookFrom(61.0, 1000.0);
    QTest::qWait(50);
    EXPECT_GT(view.frameCount(), before);
}

/// Where the covered part of a picture lies, in parts of its width and height.
struct Extent {
    double left = 1.0, right = 0.0, top = 1.0, bottom = 0.0, x = 0.0, y = 0.0;
};
Extent extentOf(int width, int height, const std::function<bool(int, int)>& covered) {
    Extent e;
    long count = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (!covered(x, y)) {
                continue;
            }
            const double u = (x + 0.5) / width;
            const double v = (y + 0.5) / height;
            e.left = std::min(e.left, u);
            e.right = std::max(e.right, u);
            e.top = std::min(e.top, v);
            e.bottom = std::max(e.bottom, v);
            e.x += u;
            e.y += v;
            ++count;
        }
    }
    e.x /= static_cast<double>(std::max(count, 1L));
    e.y /= static_cast<double>(std::max(count, 1L));
    return e;
}

TEST_F(SceneViewTest, ShowsWhatTheSensorSeesFromTheSameSide) {
    Settings& settings = project.settings;
    settings.set("sensor.width", 320);
    settings.set("sensor.height", 240);
    settings.set("target.yaw", "25");
    settings.set("target.pitch", "12");
    settings.set("target.roll", "18");
    settings.set("camera.range", "900");
    settings.set("render.background", "none");
    SceneBuilder builder;
    AnalysisGenerator generator(
        openRenderDoor(), [&](const Project& p, const Settings& s) { return builder.build(p, s); });
    AnalysisData data = AnalysisData::of(project, AnalysisKind::image);
    generator.run(data);
    const Extent sensor =
        extentOf(320, 240, [&](int x, int y) { return data.image.at(x, y) > 1e-3F; });

    view.resize(640, 480);
    view.setScene(loadDisplayScene(project, settings));
    lookFrom(60.0, 900.0);
    QTest::qWait(100);
    const QImage picture = view.grabFramebuffer();
    const Extent seen = extentOf(picture.width(), picture.height(), [&](int x, int y) {
        // The background is the same along a row.
        const QColor here = picture.pixelColor(x, y);
        const QColor edge = picture.pixelColor(1, y);
        return std::abs(here.red() - edge.red()) + std::abs(here.blue() - edge.blue()) > 4;
    });
    const double tolerance = 0.01;
    EXPECT_NEAR(seen.left, sensor.left, tolerance);
    EXPECT_NEAR(seen.right, sensor.right, tolerance);
    EXPECT_NEAR(seen.top, sensor.top, tolerance);
    EXPECT_NEAR(seen.bottom, sensor.bottom, tolerance);
    EXPECT_NEAR(seen.x, sensor.x, tolerance);
    EXPECT_NEAR(seen.y, sensor.y, tolerance);
}

TEST_F(SceneViewTest, KeepsThePictureAcrossResizes) {
    const QImage before = view.grabFramebuffer();
    view.resize(700, 300);
    QTest::qWait(50);
    view.resize(480, 360);
    QTest::qWait(50);
    EXPECT_EQ(view.grabFramebuffer(), before);
}

TEST_F(SceneViewTest, AnalysesAndRedrawsLeaveEachOthersPicturesRight) {
    SceneBuilder builder;
    AnalysisGenerator generator(
        openRenderDoor(), [&](const Project& p, const Settings& s) { return builder.build(p, s); });
    const auto render = [&] {
        AnalysisData data = AnalysisData::of(project, AnalysisKind::image);
        generator.run(data);
        return data.image.primary().values;
    };
    const auto firstImage = render();
    const QImage firstView = view.grabFramebuffer();
    const double shown_m = view.camera().range_m;
    const int threads = smat::test::processCounts().threads;
    for (int i = 0; i < 10; ++i) {
        lookFrom(60.0 + i, shown_m);
        QTest::qWait(5);
        ASSERT_EQ(render(), firstImage) << i;
    }
    lookFrom(60.0, shown_m);
    QTest::qWait(20);
    EXPECT_EQ(view.grabFramebuffer(), firstView);
    EXPECT_LE(smat::test::processCounts().threads, threads);
}

} // namespace
} // namespace smat::gui

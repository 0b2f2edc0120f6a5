// The frusta of the sensor's zoom windows in the 3-D view: those of the picture that is computed.
#include <ctime>

#include <QApplication>
#include <QPainter>

#include "gui/view/SeamedDrawing.h"
#include "gui/view/SensorFrusta.h"
#include "gui/view/ViewHud.h"
#include "gui/view/ViewNavigation.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/image/SampledTiles.h"
#include "irsg/radiometry/Units.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class SensorFrustaTest : public test::WindowFixture {
  protected:
    SensorFrusta& frusta() { return window->findChild<SceneView*>()->frusta(); }
    bool waitForFrusta() {
        return test::waitUntil([&] { return frusta().isUpToDate() && !frusta().windows().empty(); },
                               60.0);
    }
};

TEST_F(SensorFrustaTest, AreThoseThatTheImageWasSampledBy) {
    ASSERT_TRUE(opens(own("turboprop4")));
    workbench.set("sensor.width", "96");
    workbench.set("sensor.height", "64");
    workbench.set("camera.range", "2500");
    auto* view = window->findChild<SceneView*>();
    EXPECT_TRUE(frusta().frusta({}).empty()) << "off at first";
    trigger("zoomFrusta");
    ASSERT_TRUE(waitForFrusta());
    runAnalysis("image");
    const irsg::RadianceImage image = workbench.results().back().data->image;
    EXPECT_EQ(frusta().windows(), irsg::tilesOf(image));
    ASSERT_GT(frusta().windows().size(), 1U) << "object and hot parts";

    // The frame's corners lie half a field of view to the side of where the sensor looks, at the
    // distance of the target.
    const irsg::Vec3 target = view->scene().referencePoint_m;
    const auto drawn = frusta().frusta(target);
    ASSERT_EQ(drawn.size(), frusta().windows().size() + 1);
    EXPECT_NEAR(irsg::length(target - drawn[0].eye_m), 2500.0, 1.0);
    const double width_m = irsg::length(drawn[0].corners_m[1] - drawn[0].corners_m[0]);
    const double fov_rad = irsg::radians(workbench.settings()[key::sensorFov]);
    EXPECT_NEAR(width_m, 2.0 * 2500.0 * std::tan(0.5 * fov_rad), 1e-3 * width_m);
    // A window as wide as its part of the frame.
    const irsg::SampledTile& first = frusta().windows().front();
    EXPECT_NEAR(irsg::length(drawn[1].corners_m[1] - drawn[1].corners_m[0]) / width_m,
                (first.right_px - first.left_px) / 96.0, 1e-9);

    // Seen from beside, and the same when only the inspection camera moves.
    window->findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
    trigger("inspectionCamera");
    view->navigation().fit();
    QTest::qWait(50);
    EXPECT_TRUE(frusta().isUpToDate());
    test::keepScreenshot(*window, "view-frusta");
    const auto before = frusta().windows();
    workbench.set("camera.range", "900");
    ASSERT_TRUE(test::waitUntil(
        [&] { return frusta().isUpToDate() && frusta().windows() != before; }, 60.0));
    test::keepScreenshot(*window, "view-frusta-near");
    trigger("zoomFrusta");
    EXPECT_TRUE(frusta().windows().empty());
}

TEST(SeamedDrawingTest, ALineThatEndsNearTheEyeIsDrawnAtOnce) {
    const auto drawn = [](double end, Qt::PenStyle style) {
        QImage image(100, 100, QImage::Format_RGB32);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(10.0, 0.0);
        drawSeamed(painter, {20.0, 50.0, end, 50.0}, colors::tileFrustum(), 1.4, false, style);
        painter.end();
        return image;
    };
    const std::clock_t begin = std::clock();
    const QImage far = drawn(3e7, Qt::SolidLine);
    drawn(3e7, Qt::DotLine);
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 0.5);
    EXPECT_EQ(far, drawn(300.0, Qt::SolidLine));
    EXPECT_NE(far, drawn(60.0, Qt::SolidLine));
}

} // namespace
} // namespace smat::gui

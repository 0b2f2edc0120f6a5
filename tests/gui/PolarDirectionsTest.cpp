#include <cmath>
#include <numbers>

#include <QTest>
#include <QwtPolarCanvas>
#include <gtest/gtest.h>

#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/project/SceneBuilder.h"
#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

/// Sides of samples/box, m² and K.
struct Side {
    double area_m2, temperature_K;
};
constexpr Side nose{2.0, 300.0}, tail{2.0, 320.0}, starboard{4.0, 340.0}, port{4.0, 360.0},
    top{8.0, 380.0}, bottom{8.0, 400.0};

/// The analyses of samples/box through the real renderer, and what their plots show.
class PolarDirectionsTest : public ::testing::Test {
  protected:
    static ResultTable swept(const std::string& name) {
        const auto folder = std::filesystem::path(SMAT_SOURCE_DIR) / "samples/box";
        static const RenderDoor door = openRenderDoor();
        SceneBuilder scenes;
        AnalysisGenerator generator(
            door, [&](const Project& p, const Settings& s) { return scenes.build(p, s); });
        AnalysisData data = AnalysisData::of(loadProject(folder / "box.smat"), name);
        data.settings.set("polar.step", 15);
        data.settings.set("sensor.width", 64);
        data.settings.set("sensor.height", 64);
        data.settings.set("target.altitude", 2000);
        generator.run(data);
        return data.table;
    }
    static double intensity(const Side& side) {
        return side.area_m2 *
               irsg::bandRadiance_W_m2_sr(irsg::Band::fromText("3-5"), side.temperature_K);
    }
    void show(const ResultTable& table, const char* picture) {
        plot.setData(polarData({{"box", &table}}, "intensity"));
        plot.resize(620, 680);
        plot.show();
        QTest::qWait(20);
        test::keepScreenshot(plot, picture);
    }
    /// Where on the plot (degrees clockwise from the top) this side's intensity is drawn at `angle`
    /// of the analysis: the curve's colour is there.
    bool drawn(double fromTop_deg, const Side& side) {
        const QPointF pole = plot.plotRect().center();
        const double radius = std::abs(plot.canvasPoint(0.0, intensity(side)).y() - pole.y());
        const double turn = fromTop_deg * std::numbers::pi / 180.0;
        const QPointF at = pole + QPointF(radius * std::sin(turn), -radius * std::cos(turn));
        return test::showsColorAt(*plot.canvas(), at, PlotStyle::screen(plot.palette()).curve(0));
    }
    /// All four at once, at right angles: what is at the top, right, bottom and left of the plot.
    void expectAround(const Side& above, const Side& right, const Side& below, const Side& left) {
        EXPECT_TRUE(drawn(0.0, above));
        EXPECT_TRUE(drawn(90.0, right));
        EXPECT_TRUE(drawn(180.0, below));
        EXPECT_TRUE(drawn(270.0, left));
        // The plot tells one order from its mirror image.
        EXPECT_FALSE(drawn(90.0, left));
        EXPECT_FALSE(drawn(270.0, right));
    }
    PolarPlot plot{PlotStyle::screen(QPalette())};
};

TEST_F(PolarDirectionsTest, CameraAzimuthStartsInFrontAndGoesClockwise) {
    const ResultTable table = swept("camera-azimuth");
    EXPECT_NEAR(table.find("intensity")->values[0], intensity(nose), 0.01 * intensity(nose));
    show(table, "polar-box-camera-azimuth");
    expectAround(nose, starboard, tail, port);
    EXPECT_TRUE(plot.data().clockwise);
    EXPECT_TRUE(plot.data().title.contains("camera azimuth, view offset 0°"))
        << plot.data().title.toStdString();
}

TEST_F(PolarDirectionsTest, CameraElevationStartsInFrontAndBeginsDownwards) {
    show(swept("camera-elevation"), "polar-box-camera-elevation");
    // Counter-clockwise about the model's X: the belly is drawn on the left.
    expectAround(nose, top, tail, bottom);
    EXPECT_FALSE(plot.data().clockwise);
}

TEST_F(PolarDirectionsTest, ModelYawTurnsCounterClockwiseBeforeACameraThatStays) {
    const ResultTable table = swept("model-yaw");
    show(table, "polar-box-model-yaw");
    // The nose turns to port of where it was: the camera then sees the starboard side.
    EXPECT_NEAR(table.find("intensity")->values[6], intensity(starboard),
                0.01 * intensity(starboard));
    expectAround(nose, port, tail, starboard);
    EXPECT_FALSE(plot.data().clockwise);
    const auto& yaw = table.find("yaw")->values;
    EXPECT_NEAR(std::remainder(yaw[6] - yaw[0] - 90.0, 360.0), 0.0, 1e-9);
}

} // namespace
} // namespace smat::gui

#include "gui/view/SceneView.h"

#include <filesystem>
#include <numbers>

#include <QTest>
#include <gtest/gtest.h>

#include "gui/Workbench.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui {
namespace {

int threadCount() {
    int count = 0;
    for ([[maybe_unused]] const auto& entry :
         std::filesystem::directory_iterator("/proc/self/task"))
        ++count;
    return count;
}

class SceneViewTest : public ::testing::Test {
  protected:
    void SetUp() override {
        if (!SceneView::problem().isEmpty())
            GTEST_SKIP() << "this desktop gives no OpenGL context";
    }
    SceneViewTest() : project(loadProject(test::writeSampleProject(test::freshFolder("view")))) {
        view.resize(480, 360);
        view.setScene(loadDisplayScene(project, project.settings));
        view.setFrame({10.0 * std::numbers::pi / 180.0, 64, 48});
        view.setCamera({60.0, 15.0, 1000.0}, 0.0);
        view.show();
        view.showWholeModel();
        QTest::qWait(50);
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
    view.setCamera({61.0, 15.0, 1000.0}, 0.0);
    QTest::qWait(50);
    EXPECT_GT(view.frameCount(), before);
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
    auto source = makeIrsgImageSource();
    SceneBuilder builder;
    AnalysisGenerator generator(
        *source, [&](const Project& p, const Settings& s) { return builder.build(p, s); });
    const auto render = [&] {
        AnalysisData data = AnalysisData::of(project, AnalysisKind::image);
        generator.run(data);
        return data.image.primary().values;
    };
    const auto firstImage = render();
    const QImage firstView = view.grabFramebuffer();
    const int threads = threadCount();
    for (int i = 0; i < 20; ++i) {
        view.setCamera({60.0 + i, 15.0, view.camera().range_m}, 0.0);
        QTest::qWait(5);
        ASSERT_EQ(render(), firstImage) << i;
    }
    view.setCamera({60.0, 15.0, view.camera().range_m}, 0.0);
    QTest::qWait(20);
    EXPECT_EQ(view.grabFramebuffer(), firstView);
    EXPECT_LE(threadCount(), threads);
}

} // namespace
} // namespace smat::gui

#include "gui/workbench/FirstScene.h"

#include <filesystem>

#include "gui/workbench/OrbitCamera.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/settings/SettingKeys.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::gui {
namespace {

TEST(FirstScene, AModelFillsThePictureFromItsStarboardBowInTheAirThatComesWithTheProgram) {
    const Settings usual;
    for (const double size_m : {0.02, 3.0, 40.0, 2500.0}) {
        const irsg::BoundingBox box{{-0.5 * size_m, -size_m, 0.0},
                                    {0.5 * size_m, size_m, 0.3 * size_m}};
        const Settings first = firstScene(box, usual);
        const double radius_m = 0.5 * irsg::length(box.max - box.min);
        EXPECT_NEAR(first[key::cameraRange],
                    OrbitCamera::rangeToShow(radius_m, irsg::radians(first[key::sensorFov])),
                    0.006 * first[key::cameraRange]);
        EXPECT_GT(first[key::cameraAzimuth], 20.0);
        EXPECT_LT(first[key::cameraAzimuth], 70.0);
        EXPECT_GT(first[key::cameraElevation], 0.0);
        EXPECT_GE(first[key::targetAltitude], radius_m) << "nothing below the ground";
        EXPECT_GE(first[key::targetAltitude], std::min(1.09 * first[key::cameraRange], 1e4))
            << "a turn of the camera about the target stays above the ground";
        EXPECT_EQ(first.text(key::sensorBand), "3-5");
        EXPECT_TRUE(std::filesystem::exists(first.text(key::environmentAtmospheres)));
    }
}

class FirstSceneTest : public test::WindowFixture {};

TEST_F(FirstSceneTest, AModelThatIsOpenedIsSeenSoAndIsNoChangeYet) {
    const auto model =
        smat::test::writtenFile(folder / "wedge.obj", "v -4 0 0\nv 4 0 0\nv 0 12 0\nv 0 0 3\n"
                                                      "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    ASSERT_TRUE(opens(model));
    EXPECT_FALSE(workbench.isModified());
    EXPECT_EQ(workbench.undoStack().count(), 0);
    EXPECT_EQ(workbench.settings().text(key::cameraAzimuth), "40");
    EXPECT_LT(workbench.settings()[key::cameraRange], 600.0);
    EXPECT_FALSE(workbench.settings().text(key::environmentAtmospheres).empty());
}

} // namespace
} // namespace smat::gui

#include "gui/view/InfraredScene.h"

#include <algorithm>
#include <cmath>

#include "irsg/radiometry/Units.h"
#include "smatcore/settings/SettingAvailability.h"
#include "smatcore/settings/SettingKeys.h"
#include "tests/gui/ViewFixture.h"

namespace smat::gui {
namespace {

/// The pictures of the 3-D view as its thread draws them, without the view.
class InfraredSceneTest : public test::ViewFixture {};

TEST_F(InfraredSceneTest, LoadsNothingAgainForRadiometryAlone) {
    Project project = sample("turboprop4");
    InfraredScene scene;
    InfraredRequest request;
    request.project = std::make_shared<const Project>(project);
    request.settings = project.settings;
    request.size_px = {64, 48};
    request.map = &irsg::ColorMap::named("ironbow");
    const auto first = scene.draw(request);
    EXPECT_EQ(scene.modelsLoaded(), 1);
    request.revision = 1;
    request.settings.set("environment.sunAzimuth", 20);
    const auto second = scene.draw(request);
    EXPECT_EQ(scene.modelsLoaded(), 1);
    EXPECT_NE(first.image->primary().values, second.image->primary().values);

    // New colours alone leave the very image.
    request.map = &irsg::ColorMap::named("white-hot");
    const auto third = scene.draw(request);
    EXPECT_EQ(third.image, second.image);
    EXPECT_NE(third.colors, second.colors);
    EXPECT_EQ(third.radiance_s, 0.0);
}

TEST_F(InfraredSceneTest, FollowsTheHazeOfScattering) {
    if (!whyUnavailable(settingInfo("render.scattering")).empty()) {
        GTEST_SKIP() << "a build without scattering";
    }
    const Project fog = sample("fog");
    InfraredScene scene;
    InfraredRequest request;
    request.project = std::make_shared<const Project>(fog);
    request.settings = fog.settings;
    request.camera.range_m = 400.0;
    request.targetYaw_rad = irsg::radians(fog.settings[key::targetYaw]);
    request.size_px = {64, 48};
    request.horizontalFieldOfView_rad = 0.06;
    request.map = &irsg::ColorMap::named("white-hot");
    using Values = std::vector<float>;
    const auto largestDifference = [](const Values& one, const Values& other) {
        float largest = 0.0F;
        for (std::size_t i = 0; i < one.size(); ++i) {
            largest = std::max(largest, std::abs(one[i] - other.at(i)));
        }
        return largest;
    };
    Values before = scene.draw(request).image->primary().values;
    for (const auto& [name, value] :
         {std::pair<const char*, std::string>{"environment.scatteringCoefficient", "3"},
          {"environment.mtf", SMAT_SOURCE_DIR "/resources/scattering/radiation-fog-mwir.mtf"}}) {
        ++request.revision;
        request.settings.set(name, value);
        const Values after = scene.draw(request).image->primary().values;
        EXPECT_GT(largestDifference(after, before), 1e-4F) << name;
        before = after;
    }
    // And it is the haze that a window has which has shown nothing before.
    const Values fresh = InfraredScene().draw(request).image->primary().values;
    EXPECT_LT(largestDifference(fresh, before), 1e-5F);
}

} // namespace
} // namespace smat::gui

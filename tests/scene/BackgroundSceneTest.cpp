#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/background/Skybox.h"
#include "irsg/render/background/Terrain.h"
#include "tests/support/MadeGraphs.h"
#include "tests/support/SceneFixtures.h"
#include "tests/support/TerrainSheets.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes one{1, 1};

/// A wall that faces south, with a plain texture, its lower left corner given.
std::shared_ptr<const Terrain> wall(const Vec3& corner, double width_m, double height_m,
                                    float texel) {
    return terrainOfGraph(*sheet(corner, {width_m, 0, 0}, {0, 0, height_m},
                                 textureOf(1, [=](int, int) { return texel; })),
                          "wall");
}

std::shared_ptr<const Skybox> plainSky(float texel) {
    std::array<TextureImage, 6> faces;
    for (TextureImage& face : faces) {
        face = {2, 2, std::vector<float>(4, texel)};
    }
    return std::make_shared<const Skybox>(faces);
}

/// A black sphere of 1 m at the standing altitude, seen from the south.
class BackgroundScene : public ::testing::Test {
  protected:
    void SetUp() override {
        air.backgroundValue = 0.5; // over 2 um: 1 W m-2 sr-1
        air.sunValue = 5.0;        // 10 W m-2
        irsg.scene.environment = environmentOf(air, {0.0, 0.0001});
        Entity entity = entityOf(modelOf(sphereMesh(1.0, 48, 96, one)), greyDatabase(1.0, 320.0));
        entity.pose.position_m = {0, 0, standingAltitude_m};
        irsg.scene.entities = {entity};
        settings.sun = settings.ambientReflection = ReflectionMode::off;
        view(100.0);
    }
    void view(double range_m, int side_px = 64) {
        irsg.view.sensor = {.width_px = side_px,
                            .height_px = side_px,
                            .horizontalFieldOfView_rad = 0.04,
                            .band = Band::topHat(3.0, 5.0)};
        irsg.view.viewpoint =
            Viewpoint::lookAt({0, -range_m, standingAltitude_m}, {0, 0, standingAltitude_m});
    }
    RenderedImage render() {
        irsg.scene.settings = settings;
        return irsg.imageWithReport();
    }

    ConstantAtmosphere air;
    InteractiveRenderer irsg{RenderSettings::direct()};
    RenderSettings settings = RenderSettings::direct();
    const double blackBody = bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 320.0);
};

} // namespace

TEST_F(BackgroundScene, IsTheSumOfSkyboxSunAndEnvironmentBehindTheObject) {
    irsg.scene.skybox = plainSky(0.75f);
    settings.skybox = {4.0, 0.25};
    settings.sunDisc = true;
    const RenderedImage result = render();
    EXPECT_FLOAT_EQ(result.image.at(0, 0), 3.0f) << "4 (0.75 - 0.25) + 1";
    EXPECT_NEAR(static_cast<double>(result.image.at(32, 32)), blackBody, 1e-5 * blackBody);
    // Beside the sphere, in the disc of 14 pixels: 0.53 of 2.3 degrees.
    const double sun = 10.0 / (2.0 * pi * (1.0 - std::cos(radians(0.265))));
    EXPECT_EQ(result.report.warnings.size(), 0u);
    view(5000.0);
    const RenderedImage far = render();
    EXPECT_NEAR(static_cast<double>(far.image.at(32, 29)), sun + 1.0, 1e-5 * sun);
    EXPECT_NE(std::ranges::find(far.report.providedBy, "solar disc: constant air"),
              far.report.providedBy.end());
}

TEST_F(BackgroundScene, EntersTheContrastPixelByPixel) {
    // Half the sphere stands before a wall: its contrast is against two backgrounds.
    irsg.scene.terrain = wall({0, 200, 500}, 1000.0, 1000.0, 2.0f);
    settings.terrain = {1.0, 0.0};
    const RenderedImage result = render();
    EXPECT_FLOAT_EQ(result.image.at(0, 0), 1.0f);
    EXPECT_FLOAT_EQ(result.image.at(63, 0), 3.0f);
    const ObjectRadiometry& sphere = result.report.objects.front();
    const double expected = sphere.solidAngle_sr * (blackBody - 0.5 * (1.0 + 3.0)) * 100.0 * 100.0;
    EXPECT_NEAR(sphere.contrastIntensity_W_sr / expected, 1.0, 1e-3);
    const RenderReport measured = irsg.measure();
    EXPECT_NEAR(measured.objects.front().contrastIntensity_W_sr / expected, 1.0, 1e-3);
    EXPECT_NEAR(measured.totalIrradiance_W_m2 / result.report.totalIrradiance_W_m2, 1.0, 1e-6);
}

TEST_F(BackgroundScene, HidesTheObjectBehindAHillInEveryMode) {
    // The wall covers the right half of the view, before the sphere.
    const auto before = wall({0, -50, 500}, 1000.0, 1000.0, 2.0f);
    struct Mode {
        int tileSide_samples, samplesPerAxis;
    };
    for (const Mode& mode : {Mode{0, 1}, {0, 2}, {0, 4}, {128, 1}, {256, 1}, {512, 1}}) {
        for (const double range_m : {100.0, 3000.0, 50000.0}) {
            settings.tileSide_samples = mode.tileSide_samples;
            settings.samplesPerAxis = mode.samplesPerAxis;
            view(range_m);
            irsg.scene.terrain = nullptr;
            render();
            const double whole_sr = irsg.measure().all.solidAngle_sr;
            irsg.scene.terrain = before;
            settings.terrainHides = true;
            const RenderedImage half = render();
            const std::string name = std::to_string(mode.tileSide_samples) + "/" +
                                     std::to_string(mode.samplesPerAxis) + " at " +
                                     std::to_string(range_m);
            // Without a zoom window a far sphere may fall between the samples.
            if (mode.tileSide_samples > 0 || range_m < 200.0) {
                EXPECT_NEAR(half.report.all.solidAngle_sr / whole_sr, 0.5, 0.02) << name;
                EXPECT_NEAR(irsg.measure().all.solidAngle_sr / whole_sr, 0.5, 0.02) << name;
            }
            EXPECT_FLOAT_EQ(half.image.at(40, 32), 3.0f) << name;
            settings.terrainHides = false;
            const double shown_sr = render().report.all.solidAngle_sr;
            EXPECT_NEAR(shown_sr, whole_sr, 1e-9 * whole_sr) << name;
        }
    }
}

TEST_F(BackgroundScene, HidesTransparentSurfacesToo) {
    Entity shell =
        entityOf(modelOf(sphereMesh(1.0, 48, 96, one)), greyDatabase(0.3, 320.0, 0.0, 0.7));
    shell.pose.position_m = {0, 0, standingAltitude_m};
    irsg.scene.entities = {shell};
    irsg.scene.terrain = wall({-500, -50, 500}, 1000.0, 1000.0, 2.0f);
    const RenderedImage hidden = render();
    EXPECT_EQ(hidden.report.all.coveredPixels, 0.0);
    EXPECT_FLOAT_EQ(hidden.image.at(32, 32), 3.0f);
}

TEST_F(BackgroundScene, CountsFlooredPixelsAndSaysSo) {
    irsg.scene.skybox = plainSky(0.0f);
    settings.skybox = {4.0, 0.5};
    const RenderedImage result = render();
    EXPECT_EQ(result.image.at(0, 0), 0.0f);
    EXPECT_EQ(result.report.flooredPixels, 64 * 64);
    ASSERT_EQ(result.report.warnings.size(), 1u);
    EXPECT_NE(result.report.warnings[0].find("4096 pixels"), std::string::npos);
}

TEST_F(BackgroundScene, AsksAGridWhereThereAreRowsAndIsUniformWithOne) {
    settings.backgroundRows = 8;
    settings.backgroundColumns = 2;
    const RenderedImage grid = render();
    EXPECT_FLOAT_EQ(grid.image.at(0, 0), 1.0f);
    settings.backgroundRows = settings.backgroundColumns = 1;
    const RenderedImage uniform = render();
    EXPECT_NEAR(grid.report.all.contrastIntensity_W_sr, uniform.report.all.contrastIntensity_W_sr,
                1e-9 * std::abs(uniform.report.all.contrastIntensity_W_sr));
    settings.background = BackgroundMode::none;
    settings.backgroundRows = 8;
    EXPECT_EQ(render().image.at(0, 0), 0.0f);
}

TEST_F(BackgroundScene, RefusesSettingsThatMeanNothing) {
    settings.backgroundRows = -1;
    EXPECT_THROW(render(), InputError);
    settings.backgroundRows = 4000;
    EXPECT_THROW(render(), InputError);
    settings.backgroundRows = 1;
    settings.skybox.slope_W_m2_sr = std::nan("");
    EXPECT_THROW(render(), InputError);
}

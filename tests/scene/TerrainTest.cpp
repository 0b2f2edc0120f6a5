#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>

#include <osg/MatrixTransform>
#include <osg/Texture2D>
#include <osgDB/WriteFile>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/background/SceneBackground.h"
#include "irsg/render/background/TerrainPass.h"
#include "tests/support/MadeGraphs.h"
#include "tests/support/Refusal.h"
#include "tests/support/SceneFixtures.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TerrainSheets.h"

using namespace irsg;
using namespace irsg::test;
using smat::test::refusalOf;
using smat::test::TemporaryFolder;

namespace {

osg::ref_ptr<osg::Texture2D> plain(float value) {
    return textureOf(8, [=](int, int) { return value; });
}

/// A wall at y = 100 m that fills x > 0, from far below to far above.
std::shared_ptr<const Terrain> wall(float value, const Vec3& position = {}) {
    return terrainOfGraph(*sheet({0, 100, -500}, {500, 0, 0}, {0, 0, 1000}, plain(value)), "wall",
                          position);
}

Viewpoint north(const Vec3& eye = {}) {
    return Viewpoint::lookAt(eye, eye + Vec3{0, 1, 0});
}

FrameBackground drawn(SceneBackground& background, const Sensor& sensor, const Viewpoint& view,
                      const BackgroundSettings& settings, BackgroundReport& report,
                      const SunPosition& sun = {}) {
    ConstantAtmosphere air;
    air.sunValue = 5.0;
    const Environment environment = environmentOf(air, sun);
    const SpectralPoints ends({3.0, 5.0}, {1.0, 1.0}, {3.0, 5.0});
    const BandSky sky(environment, ends);
    GlTerrain painter;
    return background.draw(sensor, view, sky, settings, painter, report);
}

BackgroundSettings onBackground(double uniform_W_m2_sr, TextureScale terrain) {
    BackgroundSettings settings;
    settings.queriesEnvironment = false;
    settings.uniform_W_m2_sr = uniform_W_m2_sr;
    settings.terrain = terrain;
    return settings;
}

} // namespace

TEST(Terrain, ShowsItsTexelsUnchangedWhereItIsAndNothingElsewhere) {
    SceneBackground background;
    background.setTerrain(wall(123.25f));
    BackgroundReport report;
    const auto frame =
        drawn(background, sensorOf(64, 48, 40.0), north(), onBackground(0.0, {}), report);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            EXPECT_EQ(frame.at(x, y), x < 32 ? 0.0 : 123.25) << x << ", " << y;
        }
    }
}

TEST(Terrain, AddsNothingAtTheOffsetAndTheSlopeFromBlackToWhite) {
    SceneBackground background;
    const Sensor sensor = sensorOf(32, 32, 40.0);
    BackgroundReport report;
    const auto settings = onBackground(6.0, {8.0, 128.0 / 255.0});
    background.setTerrain(wall(128.0f / 255.0f));
    EXPECT_EQ(drawn(background, sensor, north(), settings, report).at(31, 16), 6.0);
    background.setTerrain(wall(1.0f));
    const double white = drawn(background, sensor, north(), settings, report).at(31, 16);
    background.setTerrain(wall(0.0f));
    const double black = drawn(background, sensor, north(), settings, report).at(31, 16);
    EXPECT_NEAR(white - black, 8.0, 1e-6);
    EXPECT_EQ(report.flooredPixels, 0);

    BackgroundReport floored;
    const auto dark = drawn(background, sensor, north(), onBackground(1.0, {8.0, 0.5}), floored);
    EXPECT_EQ(dark.at(31, 16), 0.0);
    EXPECT_EQ(floored.flooredPixels, 16 * 32);
}

TEST(Terrain, StaysInTheWorldWhereTheSkyFollowsTheEye) {
    SceneBackground background;
    background.setTerrain(wall(1.0f, {0, 0, 1000}));
    const Sensor sensor = sensorOf(64, 8, 60.0);
    BackgroundReport report;
    const auto here = drawn(background, sensor, north({0, 0, 1000}), onBackground(0.0, {}), report);
    EXPECT_EQ(here.at(33, 4), 1.0);
    EXPECT_EQ(here.at(30, 4), 0.0);
    // 20 m to the west, 100 m before the wall: its edge moves by 0.2 of the image plane.
    const auto west =
        drawn(background, sensor, north({-20, 0, 1000}), onBackground(0.0, {}), report);
    const double edge = 32.0 + 0.2 / sensor.pixelPitch();
    double covered = 0.0;
    for (int x = 0; x < 64; ++x) {
        covered += west.at(x, 4);
    }
    EXPECT_NEAR(64.0 - covered, edge, 0.34) << "to a sample";
}

TEST(Terrain, HidesSkyboxAndSunWithoutMixingAndIsSharedOnItsEdge) {
    std::array<TextureImage, 6> faces;
    for (TextureImage& face : faces) {
        face = {2, 2, std::vector<float>(4, 50.0f)};
    }
    SceneBackground background;
    background.setSkybox(std::make_shared<const Skybox>(faces));
    background.setTerrain(wall(7.0f));
    const Sensor sensor = sensorOf(65, 65, 4.0);
    BackgroundSettings settings = onBackground(2.0, {});
    settings.sunDisc = true;
    BackgroundReport report;
    const auto frame = drawn(background, sensor, north(), settings, report, {0.0, 1e-9});
    EXPECT_EQ(frame.at(2, 2), 52.0);
    EXPECT_EQ(frame.at(60, 2), 9.0);
    EXPECT_EQ(frame.at(34, 31), 9.0) << "the sun stands behind the wall's left half";
    EXPECT_GT(frame.at(31, 31), 1e4);
    const double edge = background.layers().coverage[32];
    EXPECT_NEAR(edge, 0.5, 0.2);
    EXPECT_NEAR(frame.at(32, 0), edge * 7.0 + (1.0 - edge) * 50.0 + 2.0, 1e-9);
    // Each layer alone makes up the sum.
    const BackgroundLayers& layers = background.layers();
    for (std::size_t i = 0; i < layers.sky.size(); ++i) {
        EXPECT_DOUBLE_EQ(frame.at(static_cast<int>(i % 65), static_cast<int>(i / 65)),
                         layers.terrain[i] + (1.0 - layers.coverage[i]) * layers.sky[i] + 2.0);
    }
}

TEST(Terrain, ShowsTheTextureUprightAndAveragesWhatIsFine) {
    // Bright in the upper half of the texture: the wall's z > 0.
    const auto halves =
        terrainOfGraph(*sheet({-100, 100, -50}, {200, 0, 0}, {0, 0, 100},
                              textureOf(64, [](int, int y) { return y < 32 ? 1.0f : 3.0f; })),
                       "halves");
    SceneBackground background;
    background.setTerrain(halves);
    BackgroundReport report;
    const Sensor sensor = sensorOf(32, 32, 20.0);
    const auto frame = drawn(background, sensor, north(), onBackground(0.0, {}), report);
    EXPECT_EQ(frame.at(16, 2), 3.0);
    EXPECT_EQ(frame.at(16, 29), 1.0);

    background.setTerrain(terrainOfGraph(
        *sheet({-100, 100, -100}, {200, 0, 0}, {0, 0, 200},
               textureOf(1024, [](int x, int y) { return (x + y) % 2 ? 1.0f : 0.0f; })),
        "chessboard"));
    const auto grey = drawn(background, sensor, north(), onBackground(0.0, {}), report);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            EXPECT_NEAR(grey.at(x, y), 0.5, 0.05);
        }
    }
}

TEST(Terrain, IsDrawnOverFramesLargerThanOneTarget) {
    SceneBackground background;
    background.setTerrain(wall(2.0f));
    BackgroundReport report;
    const auto frame =
        drawn(background, sensorOf(1500, 40, 40.0), north(), onBackground(0.0, {}), report);
    for (int x = 0; x < 1500; ++x) {
        EXPECT_EQ(frame.at(x, 20), x < 750 ? 0.0 : 2.0) << x;
    }
}

TEST(Terrain, OfDeepTransformsAndFarPlacesKeepsItsDigits) {
    const osg::ref_ptr<osg::MatrixTransform> moved =
        new osg::MatrixTransform(osg::Matrixd::translate(6.4e6, 100.0, 0.0));
    moved->addChild(sheet({0, 0, -500}, {500, 0, 0}, {0, 0, 1000}, plain(4.0f)));
    SceneBackground background;
    background.setTerrain(terrainOfGraph(*moved, "far"));
    BackgroundReport report;
    const auto frame = drawn(background, sensorOf(64, 8, 40.0), north({6.4e6, 0, 0}),
                             onBackground(0.0, {}), report);
    for (int x = 0; x < 64; ++x) {
        EXPECT_EQ(frame.at(x, 4), x < 32 ? 0.0 : 4.0) << x;
    }
}

TEST(Terrain, BehindTheCameraIsNotSeenAndAroundItIs) {
    SceneBackground background;
    background.setTerrain(wall(4.0f, {0, -300, 0}));
    BackgroundReport report;
    const Sensor sensor = sensorOf(16, 16, 40.0);
    const auto empty = drawn(background, sensor, north(), onBackground(1.0, {}), report);
    for (int x = 0; x < 16; ++x) {
        EXPECT_EQ(empty.at(x, 8), 1.0);
    }
    // Ground under the camera that reaches behind it.
    background.setTerrain(
        terrainOfGraph(*sheet({-1e4, -1e4, -10}, {2e4, 0, 0}, {0, 2e4, 0}, plain(4.0f)), "ground"));
    const auto ground = drawn(background, sensor, north(), onBackground(1.0, {}), report);
    EXPECT_EQ(ground.at(8, 15), 5.0);
    EXPECT_EQ(ground.at(8, 0), 1.0);
}

TEST(Terrain, WithoutATextureHidesAndAddsNothing) {
    const auto bare =
        terrainOfGraph(*sheet({0, 100, -500}, {500, 0, 0}, {0, 0, 1000}, nullptr), "bare");
    ASSERT_EQ(bare->remarks().size(), 1u);
    EXPECT_NE(bare->remarks()[0].find("2 triangles without a texture"), std::string::npos);
    SceneBackground background;
    background.setTerrain(bare);
    BackgroundReport report;
    const auto frame =
        drawn(background, sensorOf(16, 16, 40.0), north(), onBackground(3.0, {5.0, 0.25}), report);
    EXPECT_EQ(frame.at(15, 8), 3.0);
    EXPECT_EQ(background.layers().coverage[15], 1.0);
}

TEST(Terrain, IsReadFromFilesWithTheirTextures) {
    const TemporaryFolder folder;
    const osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(4, 4, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int y = 0; y < 4; ++y) {
        std::memset(picture->data(0, static_cast<unsigned int>(y)), 51, 12);
    }
    ASSERT_TRUE(osgDB::writeImageFile(*picture, (folder / "ground.png").string()));
    std::ofstream(folder / "hill.mtl") << "newmtl ground\nmap_Kd ground.png\n";
    // The axes of OBJ files are y up, which OpenSceneGraph turns.
    std::ofstream(folder / "hill.obj")
        << "mtllib hill.mtl\nusemtl ground\nv 0 -500 -100\nv 500 -500 -100\n"
           "v 500 500 -100\nv 0 500 -100\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    const auto terrain = Terrain::load(folder / "hill.obj", {0, 0, 2000});
    EXPECT_EQ(terrain->name(), "hill.obj");
    SceneBackground background;
    background.setTerrain(terrain);
    BackgroundReport report;
    const auto frame = drawn(background, sensorOf(16, 16, 40.0), north({0, 0, 2000}),
                             onBackground(0.0, {10.0, 0.0}), report);
    EXPECT_NEAR(frame.at(15, 8), 2.0, 1e-6);
    EXPECT_EQ(frame.at(0, 8), 0.0);
}

TEST(Terrain, ThatCannotBeUsedIsRefusedByName) {
    const TemporaryFolder folder;
    EXPECT_NE(refusalOf([&] { Terrain::load(folder / "nowhere.obj"); }).find("nowhere.obj"),
              std::string::npos);
    std::ofstream(folder / "empty.obj") << "v 0 0 0\n";
    EXPECT_NE(refusalOf([&] { Terrain::load(folder / "empty.obj"); }).find("empty.obj"),
              std::string::npos);
    std::ofstream(folder / "odd.flat") << "none\n";
    EXPECT_NE(refusalOf([&] { Terrain::load(folder / "odd.flat"); }).find("odd.flat"),
              std::string::npos);

    const auto bad = sheet({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, plain(1.0f));
    bad->getDrawable(0)->asGeometry()->setPrimitiveSet(0, new osg::DrawArrays(GL_QUADS, 2, 4));
    EXPECT_NE(refusalOf([&] { terrainOfGraph(*bad, "bad"); }).find("vertex 5"), std::string::npos);
    const auto infinite =
        sheet({0, 0, std::numeric_limits<double>::infinity()}, {1, 0, 0}, {0, 0, 1}, plain(1.0f));
    EXPECT_NE(refusalOf([&] { terrainOfGraph(*infinite, "far"); }).find("not finite"),
              std::string::npos);
}

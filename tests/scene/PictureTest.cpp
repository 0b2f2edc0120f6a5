// InteractiveRenderer::picture(): the image of render() for a window that follows edits.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/scene/InteractiveRenderer.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

SignatureDatabase glazing() {
    SignatureDatabase database;
    database.temperatures[1] = fixedTemperature(300.0);
    database.temperatures[2] = fixedTemperature(600.0);
    database.temperatures[3] = fixedTemperature(290.0);
    database.materials[1] = greyMaterial(0.6);
    database.materials[2] = greyMaterial(0.9);
    database.materials[2].nAngleFactor = 1.0;
    database.materials[3] = greyMaterial(0.3, 0.6);
    return database;
}

/// A sphere and a hot plate inside a transparent box: of it three layers lie before each other.
class PictureTest : public testing::Test {
  protected:
    PictureTest() {
        irsg.scene.environment = brightAtmosphere();
        irsg.scene.entities = {entityOf(modelOf(glazedMesh()), glazing())};
        // Windows that do not follow the temperatures, so that drawings can be counted.
        RenderSettings settings = RenderSettings::direct();
        settings.hotSpots = false;
        irsg.scene.settings = settings;
        look(irsg, {.range_m = 100.0, .azimuth_rad = 0.5, .elevation_rad = 0.2});
    }
    void edit(const SignatureDatabase& database) {
        irsg.scene.entities[0].database = std::make_shared<const SignatureDatabase>(database);
    }
    long callsOf(const char* stage) const {
        for (const auto& known : irsg.stageTimes().stages) {
            if (known.name == stage) {
                return known.calls;
            }
        }
        return 0;
    }
    void expectThatOfRender(const char* what) {
        const RadianceImage found = irsg.picture();
        const RadianceImage expected = irsg.imageWithReport().image;
        ASSERT_EQ(found.width(), expected.width());
        double worst = 0.0;
        for (std::size_t i = 0; i < found.primary().values.size(); ++i) {
            const double a = static_cast<double>(found.primary().values[i]);
            const double b = static_cast<double>(expected.primary().values[i]);
            worst = std::max(worst, std::abs(a - b) / b);
        }
        EXPECT_LT(worst, 4e-6) << what;
        EXPECT_EQ(found.attributes, expected.attributes) << what;
    }

    InteractiveRenderer irsg{RenderSettings::direct()};
};

TEST_F(PictureTest, FollowsEveryEditAsRenderDoesAndDrawsTheViewOnce) {
    expectThatOfRender("as it is");
    SignatureDatabase database = glazing();
    for (int i = 0; i < 5; ++i) {
        database.temperatures[1] = fixedTemperature(310.0 + 40.0 * i);
        database.temperatures[3] = fixedTemperature(280.0 + 9.0 * i);
        database.materials[1] = greyMaterial(0.3 + 0.1 * i);
        database.materials[3] = greyMaterial(0.2 + 0.05 * i, 0.5 - 0.1 * i);
        edit(database);
        expectThatOfRender("edited");
    }
    EXPECT_EQ(callsOf("factors of pixels"), 1);
    EXPECT_EQ(callsOf("sums of pixels"), 5);
}

TEST_F(PictureTest, MakesSumsAndTheirErrorsOfItsOwnSamples) {
    const auto drawingsOf = [](const Renderer& renderer) {
        const std::vector<StageTimes::Stage> stages = renderer.stageTimes().stages;
        const auto drawing = std::ranges::find(stages, "drawing", &StageTimes::Stage::name);
        return drawing == stages.end() ? 0 : drawing->calls;
    };
    for (const bool areTwo : {false, true}) {
        if (areTwo) {
            irsg.scene.entities.push_back(irsg.scene.entities.front());
            irsg.scene.entities.back().pose.position_m = {0.0, 4.0, 0.5};
        }
        Renderer together, apart;
        const Rendered both =
            together.render(irsg.scene, irsg.view, Outputs::imageWithReports().withErrors());
        EXPECT_EQ(drawingsOf(together), 1);
        const Rendered sums = apart.render(irsg.scene, irsg.view, Outputs::reports().withErrors());
        const ObjectRadiometry &of = both.reports.front().all, &wanted = sums.reports.front().all;
        ASSERT_TRUE(of.errors && wanted.errors);
        EXPECT_EQ(of.errors->intensity_W_sr.sum(), wanted.errors->intensity_W_sr.sum());
        EXPECT_GT(of.errors->intensity_W_sr.sampling, 0.0);
        EXPECT_NEAR(of.intensity_W_sr, wanted.intensity_W_sr, 1e-5 * wanted.intensity_W_sr);
        if (areTwo) {
            EXPECT_EQ(of.intensity_W_sr, wanted.intensity_W_sr);
        }
    }
}

TEST_F(PictureTest, DrawsAnewWhatAnEditMakesOfTheGeometry) {
    irsg.picture();
    irsg.picture();
    ASSERT_EQ(callsOf("factors of pixels"), 1);
    SignatureDatabase database = glazing();
    database.materials[3] = greyMaterial(0.9); // the box hides what is inside
    edit(database);
    expectThatOfRender("opaque");
    database.materials[3].nAngleFactor = 2.0;
    edit(database);
    expectThatOfRender("another N");
    expectThatOfRender("another N again");
    EXPECT_EQ(callsOf("factors of pixels"), 2);
}

TEST_F(PictureTest, FollowsTheViewTheFieldTheSunAndThePose) {
    for (int twice = 0; twice < 2; ++twice) {
        irsg.picture();
    }
    Environment moved = brightAtmosphere();
    moved.sun.azimuth_rad = 2.0;
    irsg.scene.environment = moved;
    expectThatOfRender("sun");
    look(irsg, {.range_m = 90.0, .azimuth_rad = 0.6, .elevation_rad = 0.2});
    expectThatOfRender("view");
    irsg.scene.entities[0].pose = {.position_m = {0.0, 0.0, 0.0}, .attitude = {.yaw_rad = 0.3}};
    expectThatOfRender("pose");
    Sensor sensor = irsg.view.sensor;
    sensor.horizontalFieldOfView_rad *= 1.3;
    irsg.view.sensor = sensor;
    expectThatOfRender("field");
    EXPECT_EQ(callsOf("sums of pixels"), 1);
    expectThatOfRender("the same again");
    EXPECT_EQ(callsOf("sums of pixels"), 2);
}

TEST_F(PictureTest, IsThatOfRenderWhateverTheAntialiasing) {
    for (const int tileSide_samples : {0, 128}) {
        for (const TileStrategy strategy : {TileStrategy::aligned, TileStrategy::published}) {
            RenderSettings settings = RenderSettings::direct();
            settings.tileSide_samples = tileSide_samples;
            settings.tileStrategy = strategy;
            irsg.scene.settings = settings;
            for (int times = 0; times < 3; ++times) {
                expectThatOfRender("near");
            }
        }
    }
    irsg.scene.settings = {};
    look(irsg, {.range_m = 1e6});
    for (int times = 0; times < 3; ++times) {
        expectThatOfRender("a point");
    }
}

} // namespace

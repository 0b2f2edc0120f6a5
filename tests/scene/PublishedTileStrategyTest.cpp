#include "irsg/render/sampling/PublishedTileStrategy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/sampling/MultipassComposer.h"
#include "irsg/render/sampling/TileCamera.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

const IrCodes one{1, 1};
constexpr double pixel_rad = 1e-4;

ObjectTexture randomTexture(int side) {
    ObjectTexture texture(side);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(0.0, 1.0);
    for (std::size_t i = 0; i < texture.radiance.size(); ++i) {
        texture.radiance[i] = 10.0 * u(random);
        texture.opacity[i] = u(random);
    }
    return texture;
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

InteractiveRenderer& generator(TileStrategy strategy, int size = 256) {
    static InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = size;
    settings.tileStrategy = strategy;
    irsg.scene.settings = settings;
    return irsg;
}

View viewOf(double size_m, double size_px) {
    const int frame_px = static_cast<int>(std::ceil(2.0 * size_px)) + 8;
    return {.range_m = size_m / (size_px * pixel_rad),
            .width_px = frame_px,
            .height_px = frame_px,
            .fieldOfView_rad = 2.0 * std::atan(0.5 * frame_px * pixel_rad)};
}

/// Least and largest intensity over 8 x 8 places among the pixels, relative to the mean.
std::pair<double, double> swing(InteractiveRenderer& irsg) {
    const Viewpoint camera = irsg.view.viewpoint;
    const double step_m = pixel_rad * length(camera.position_m - Vec3{0, 0, standingAltitude_m});
    double least = 1e300, largest = 0.0, sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            Pose pose{{0, 0, standingAltitude_m}, {}};
            pose.position_m = pose.position_m + camera.right * ((i / 8.0 + 0.03) * step_m) +
                              camera.up * ((j / 8.0 + 0.05) * step_m);
            irsg.scene.entities[0].pose = pose;
            const double intensity = irsg.imageWithReport().report.all.intensity_W_sr;
            least = std::min(least, intensity);
            largest = std::max(largest, intensity);
            sum += intensity / 64.0;
        }
    }
    return {least / sum, largest / sum};
}

} // namespace

TEST(DownsamplingPass, KeepsTheMeanOfATexture) {
    for (int factor : {2, 4}) {
        const ObjectTexture texture = randomTexture(64);
        const ObjectTexture smaller = DownsamplingPass(factor).apply(texture);
        EXPECT_EQ(smaller.side, 64 / factor);
        EXPECT_NEAR(mean(smaller.radiance) / mean(texture.radiance), 1.0, 1e-12);
        EXPECT_NEAR(mean(smaller.opacity) / mean(texture.opacity), 1.0, 1e-12);
    }
    EXPECT_THROW(DownsamplingPass(3), LogicError);
    EXPECT_THROW(DownsamplingPass(4).apply(ObjectTexture(6)), LogicError);
}

TEST(MultipassComposer, LeadsFrom512To2InFourPasses) {
    std::vector<int> factors;
    const MultipassComposer composer(512, 2);
    for (const DownsamplingPass& pass : composer.passes()) {
        factors.push_back(pass.factor());
    }
    EXPECT_THAT(factors, testing::ElementsAre(4, 4, 4, 4));
    EXPECT_EQ(MultipassComposer(256, 2).passes().size(), 4u);
    EXPECT_EQ(MultipassComposer(128, 128).passes().size(), 0u);
    const ObjectTexture texture = randomTexture(128);
    EXPECT_NEAR(mean(MultipassComposer(128, 2).apply(texture).radiance) / mean(texture.radiance),
                1.0, 1e-12);
    EXPECT_THROW(MultipassComposer(100, 2), LogicError);
    EXPECT_THROW(MultipassComposer(64, 128), LogicError);
}

TEST(TileCamera, MeasuresTheTrueBall) {
    // The report's 34.64 and 0.5774 pixels are those of the box; the sphere has 20 and 0.333.
    Sensor sensor;
    sensor.width_px = sensor.height_px = 100;
    sensor.horizontalFieldOfView_rad = 2.0 * std::atan(50 * pixel_rad);
    const CameraFrame camera(sensor, Viewpoint::lookAt({0, 0, 0}, {0, 1, 0}));
    EXPECT_NEAR(sphereDiameter_px(camera, {0, 1000, 0}, 1.0), 20.0, 1e-4);
    EXPECT_NEAR(sphereDiameter_px(camera, {0, 60000, 0}, 1.0), 1.0 / 3.0, 1e-6);
    EXPECT_TRUE(std::isinf(sphereDiameter_px(camera, {0, 0.5, 0}, 1.0)));
    EXPECT_EQ(nextPowerOfTwo(0.01), 2);
    EXPECT_EQ(nextPowerOfTwo(20.0), 32);
    EXPECT_EQ(nextPowerOfTwo(64.0), 64);
    EXPECT_NEAR(widthAtDistance_m(sensor, 32, 1000), 3.2, 1e-12);
}

TEST(TileCamera, LooksAtTheObjectAndItsSquareCarriesTheWholeTexture) {
    Sensor sensor;
    sensor.width_px = sensor.height_px = 200;
    sensor.horizontalFieldOfView_rad = 2.0 * std::atan(100 * pixel_rad);
    const CameraFrame camera(sensor, Viewpoint::lookAt({0, 0, 0}, {0, 1, 0}));
    const Vec3 centre{3.0, 1000.0, -2.0}; // 30 pixels right, 20 down
    const CameraFrame zoom = tileCamera(camera, centre, 8, 256);
    const Vec3 eye = zoom.toEye(centre);
    EXPECT_NEAR(eye.x, 0.0, 1e-9);
    EXPECT_NEAR(eye.y, 0.0, 1e-9);

    const Billboard billboard(zoom, centre);
    const auto middle = billboard.at(camera, 130.0, 120.0);
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->first, 0.5, 1e-6);
    EXPECT_NEAR(middle->second, 0.5, 1e-6);
    const auto corner = billboard.at(camera, 130.0 - 3.999, 120.0 - 3.999);
    ASSERT_TRUE(corner);
    EXPECT_NEAR(corner->first, 0.0, 1e-3);
    EXPECT_NEAR(corner->second, 0.0, 1e-3);
    EXPECT_FALSE(billboard.at(camera, 134.1, 120.0));
}

TEST(PixelSizeBasedLod, SaysWhenItSwitchesAndNotBefore) {
    PixelSizeBasedLod lod(128);
    EXPECT_TRUE(lod.usesTexture(0, 100));
    EXPECT_TRUE(lod.usesTexture(0, 128));
    EXPECT_TRUE(lod.takeMessages().empty());
    EXPECT_FALSE(lod.usesTexture(0, 129));
    EXPECT_THAT(lod.takeMessages(),
                testing::ElementsAre(testing::HasSubstr("129 pixels wide and is drawn without")));
    EXPECT_TRUE(lod.usesTexture(0, 90));
    EXPECT_THAT(lod.takeMessages(), testing::ElementsAre(testing::HasSubstr("from its texture")));
}

TEST(PublishedTiles, KeepsTheIntensityOfASphereAndSwingsWithALopsidedBody) {
    InteractiveRenderer& irsg = generator(TileStrategy::published);
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 48, 96, one)), greyDatabase(0.9, 320.0))};
    look(irsg, viewOf(2.0, 1.5));
    const auto sphere = swing(irsg);
    EXPECT_GT(sphere.first, 0.98);
    EXPECT_LT(sphere.second, 1.02);

    // An L in a square of two pixels, as the texture of 2 x 2 texels sees it.
    const Triangles lopsided = joined(plateMesh({-0.85, 0, 0}, {0, 0, 1}, {0.15, 0, 0}, one),
                                      plateMesh({0.15, 0, -0.85}, {0, 0, 0.15}, {0.85, 0, 0}, one));
    irsg.scene.entities = {entityOf(modelOf(lopsided), greyDatabase(0.9, 320.0))};
    look(irsg, viewOf(2.0, 1.4));
    const auto published = swing(irsg);
    EXPECT_LT(published.first, 0.9);
    EXPECT_GT(published.second, 1.1);
    const auto aligned = swing(generator(TileStrategy::aligned));
    EXPECT_GT(aligned.first, 0.99);
    EXPECT_LT(aligned.second, 1.01);
}

TEST(PublishedTiles, DrawsObjectsAboveItsSizeAsTheyAreAndSaysSo) {
    InteractiveRenderer& irsg = generator(TileStrategy::published, 64);
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 48, 96, one)), greyDatabase(0.9, 320.0))};
    look(irsg, viewOf(2.0, 60.0));
    const double zoomed = irsg.imageWithReport().report.all.coveredPixels;
    EXPECT_NEAR(zoomed / (pi * 900.0), 1.0, 5e-3);
    look(irsg, viewOf(2.0, 70.0));
    const RenderReport report = irsg.imageWithReport().report;
    EXPECT_NEAR(report.all.coveredPixels / (pi * 35.0 * 35.0), 1.0, 5e-3);
    EXPECT_THAT(report.warnings, testing::Contains(testing::HasSubstr("threshold is 64")));
}

TEST(PublishedTiles, SaysWhereSumsAreThoseOfAlignedTiles) {
    InteractiveRenderer& irsg = generator(TileStrategy::published);
    const Entity sphere = entityOf(modelOf(sphereMesh(1.0, 12, 24, one)), greyDatabase(0.9, 320.0));
    irsg.scene.entities = {sphere};
    look(irsg, viewOf(2.0, 12.0));
    const auto isSaid = testing::Contains(testing::HasSubstr("drawn in pictures alone"));
    EXPECT_THAT(irsg.imageWithReport().report.warnings,
                testing::Not(isSaid)); // sums of its own pixels
    for (const RenderReport& report : irsg.measure({Band::topHat(3, 5), Band::topHat(8, 12)})) {
        EXPECT_THAT(report.warnings, isSaid);
    }
    irsg.scene.entities = {sphere, sphere};
    look(irsg, viewOf(2.0, 12.0));
    EXPECT_THAT(irsg.imageWithReport().report.warnings, isSaid);
    generator(TileStrategy::aligned);
    EXPECT_THAT(irsg.imageWithReport().report.warnings, testing::Not(isSaid));
}

TEST(PublishedTiles, MayBeExchangedFromFrameToFrame) {
    InteractiveRenderer& irsg = generator(TileStrategy::aligned);
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 48, 96, one)), greyDatabase(0.9, 320.0))};
    look(irsg, viewOf(2.0, 10.3));
    const auto aligned = irsg.imageWithReport().image.primary().values;
    const auto published =
        generator(TileStrategy::published).imageWithReport().image.primary().values;
    EXPECT_NE(aligned, published);
    EXPECT_EQ(generator(TileStrategy::aligned).imageWithReport().image.primary().values, aligned);
}

TEST(PublishedTiles, LaysTheNearerObjectOverTheFarther) {
    InteractiveRenderer& irsg = generator(TileStrategy::published);
    Entity nearer = entityOf(modelOf(sphereMesh(1.0, 48, 96, one)), greyDatabase(0.9, 320.0));
    Entity farther = entityOf(nearer.model, greyDatabase(1.0, 900.0));
    irsg.scene.entities = {nearer, farther};
    look(irsg, viewOf(2.0, 12.0));
    irsg.scene.entities[1].pose = {{0, -10, standingAltitude_m}, {}};
    const int middle = irsg.view.sensor.width_px / 2;
    const double cold = 0.9 * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 320.0);
    EXPECT_NEAR(irsg.imageWithReport().image.at(middle, middle) / cold, 1.0, 1e-4);
}

TEST(PublishedTiles, RefusesASizeThatIsNoPowerOfTwo) {
    InteractiveRenderer& irsg = generator(TileStrategy::published, 100);
    irsg.scene.entities = {entityOf(modelOf(sphereMesh(1.0, 8, 8, one)), greyDatabase(0.9, 320.0))};
    EXPECT_THAT([&] { irsg.check(); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr("a power of two")));
}

#include "irsg/radiance/HotSpotSurfaces.h"
#include "irsg/render/sampling/HotSpots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "irsg/radiometry/Planck.h"
#include "irsg/scene/SceneCheck.h"
#include "tests/support/SceneFixtures.h"
#include "tests/support/SceneSpectra.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes skin{1, 1}, lip{2, 1};
constexpr double skin_K = 300.0, lip_K = 900.0;
constexpr double lipWidth_m = 0.02, lipHeight_m = 1.0;

/// A wall of 30 m by 10 m with two narrow upright lips, a millimetre before it.
Triangles wallWithLips() {
    Triangles mesh = plateMesh({}, {0, 0, 5}, {15, 0, 0}, skin);
    for (const double x : {-6.3, 4.7}) {
        mesh = joined(mesh, plateMesh({x, 1e-3, 1.1}, {0.04 * lipHeight_m, 0, 0.5 * lipHeight_m},
                                      {0.5 * lipWidth_m, 0, 0}, lip));
    }
    return mesh;
}

Entity wall() {
    SignatureDatabase database;
    database.materials[1] = greyMaterial(1.0);
    database.temperatures[1] = fixedTemperature(skin_K);
    database.temperatures[2] = fixedTemperature(lip_K);
    return entityOf(modelOf(wallWithLips()), database);
}

double radiance_W_m2_sr(double temperature_K) {
    return bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
}

/// What the lips add to the wall's intensity, W/sr: both are seen from the front.
double lips_W_sr() {
    return 2.0 * lipWidth_m * lipHeight_m * (radiance_W_m2_sr(lip_K) - radiance_W_m2_sr(skin_K));
}
double wall_W_sr() {
    return 30.0 * 10.0 * radiance_W_m2_sr(skin_K);
}

void lookFromFar(InteractiveRenderer& irsg, double size_px) {
    constexpr double range_m = 1e6; // so far that solid angle times range squared is area
    View view;
    view.range_m = range_m;
    view.width_px = view.height_px = 128;
    view.fieldOfView_rad = 128.0 / size_px * 30.0 / range_m;
    look(irsg, view);
}

RenderSettings settingsOf(int tileSide_samples, bool hotSpots) {
    RenderSettings settings = RenderSettings::direct();
    settings.sun = settings.ambientReflection = ReflectionMode::off;
    settings.background = BackgroundMode::constant;
    settings.tileSide_samples = tileSide_samples;
    settings.hotSpots = hotSpots;
    return settings;
}

/// Largest error of the intensity over phases, as a part of what the lips give.
double largestError(InteractiveRenderer& irsg, double size_px) {
    double largest = 0.0;
    for (int i = 0; i < 12; ++i) {
        irsg.scene.entities[0].pose = {{0, 0, standingAltitude_m}, {}};
        lookFromFar(irsg, size_px);
        const Viewpoint& camera = irsg.view.viewpoint;
        const double pixel_m = 30.0 / size_px;
        irsg.scene.entities[0].pose = {
            Vec3{0, 0, standingAltitude_m} +
                camera.right * (std::fmod(i * 0.61803398875, 1.0) * pixel_m) +
                camera.up * (std::fmod(i * 0.41421356237, 1.0) * pixel_m),
            {}};
        const double intensity_W_sr = irsg.imageWithReport().report.all.intensity_W_sr;
        largest = std::max(largest, std::abs(intensity_W_sr - wall_W_sr() - lips_W_sr()));
    }
    return largest / lips_W_sr();
}

} // namespace

TEST(HotSpotSearch, AreSurfacesThatShineOutOfTheirObject) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    for (const auto& [temperature_K, isHot] :
         {std::pair{900.0, true}, {500.0, true}, {330.0, false}, {300.0, false}, {200.0, false}}) {
        Entity entity = wall();
        SignatureDatabase database = *entity.database;
        database.temperatures[2] = fixedTemperature(temperature_K);
        entity.database = std::make_shared<const SignatureDatabase>(database);
        const SceneRadiometry radiometry =
            inBand(environmentOf(ConstantAtmosphere{}), {entity},
                   objectGeometry({entity}, {{0, 0, 0}},
                                  Viewpoint::lookAt({0, 1000, 0}, {}, {0, 0, 1}, {1, 0, 0})),
                   settingsOf(256, true), LineOfSight{}, Band::topHat(3.0, 5.0));
        EXPECT_EQ(hotSpotSurfaces(radiometry, {entity}), (std::vector<bool>{false, isHot}))
            << temperature_K << " K";
    }
}

TEST(HotSpotSearch, AreFoundPieceByPiece) {
    const auto model = modelOf(wallWithLips());
    const auto pieces = connectedPieces(*model->mesh(), lip);
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_NEAR(pieces[0].centre().x, -6.3, 1e-6);
    EXPECT_NEAR(pieces[1].centre().x, 4.7, 1e-6);
    EXPECT_NEAR(pieces[1].max.z - pieces[1].min.z, lipHeight_m, 1e-6);
    EXPECT_EQ(connectedPieces(*model->mesh(), skin).size(), 1u);
    EXPECT_TRUE(connectedPieces(*model->mesh(), IrCodes{7, 7}).empty());
}

TEST(HotSpotSearch, AreNarrowerThanTheSamplesAndKeepTheirIntensity) {
    // 30 m in 256 samples are 12 cm each; the lips are 2 cm wide.
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {wall()};
    for (const double size_px : {90.0, 30.0, 3.0, 0.7, 0.04, 0.01}) {
        irsg.scene.settings = settingsOf(256, true);
        EXPECT_LT(largestError(irsg, size_px), 0.03) << size_px << " px";
    }
    irsg.scene.settings = settingsOf(256, false);
    EXPECT_GT(largestError(irsg, 30.0), 0.1);
}

TEST(HotSpotSearch, AreTheSameInImagesAndInFactors) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    irsg.scene.entities = {wall()};
    for (const bool hotSpots : {true, false, true}) {
        irsg.scene.settings = settingsOf(256, hotSpots);
        lookFromFar(irsg, 20.3);
        const double image = irsg.imageWithReport().report.all.intensity_W_sr;
        EXPECT_NEAR(irsg.measure().all.intensity_W_sr / image, 1.0, 1e-6);
    }
    // Another temperature changes what is hot, and with it the factors.
    SignatureDatabase cold = *wall().database;
    cold.temperatures[2] = fixedTemperature(skin_K);
    irsg.scene.entities[0].database = std::make_shared<const SignatureDatabase>(cold);
    const double image = irsg.imageWithReport().report.all.intensity_W_sr;
    EXPECT_NEAR(irsg.measure().all.intensity_W_sr / image, 1.0, 1e-6);
}

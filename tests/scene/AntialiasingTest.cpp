#include <gtest/gtest.h>

#include <cmath>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

const IrCodes one{1, 1};
constexpr double pixel_rad = 1e-4;
constexpr double emissivity = 0.9, temperature_K = 320.0;

InteractiveRenderer& generator(double background_W_m2_sr = 0.0) {
    static InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(ConstantAtmosphere{});
    RenderSettings settings = RenderSettings::direct();
    settings.background = BackgroundMode::constant;
    settings.background_W_m2_sr = background_W_m2_sr;
    irsg.scene.settings = settings;
    return irsg;
}

void useZoom(InteractiveRenderer& irsg, int size) {
    RenderSettings settings = irsg.scene.settings;
    settings.tileSide_samples = size;
    irsg.scene.settings = settings;
}

/// Looks at the first object, `size_m` wide, so that it is `size_px` pixels wide.
View viewOf(double size_m, double size_px) {
    const int frame_px = static_cast<int>(std::ceil(1.5 * size_px)) + 6;
    return {.range_m = size_m / (size_px * pixel_rad),
            .width_px = frame_px,
            .height_px = frame_px,
            .fieldOfView_rad = 2.0 * std::atan(0.5 * frame_px * pixel_rad)};
}

Entity grey(const Triangles& mesh) {
    return entityOf(modelOf(mesh), greyDatabase(emissivity, temperature_K));
}

double greyRadiance_W_m2_sr() {
    return emissivity * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), temperature_K);
}

/// Moves the first object by fractions of a pixel right and up.
void shift(InteractiveRenderer& irsg, double right_px, double up_px, Attitude attitude = {}) {
    const Viewpoint& camera = irsg.view.viewpoint;
    const double step_m = pixel_rad * length(camera.position_m - Vec3{0, 0, standingAltitude_m});
    Pose pose{{0, 0, standingAltitude_m}, attitude};
    pose.position_m =
        pose.position_m + camera.right * (right_px * step_m) + camera.up * (up_px * step_m);
    irsg.scene.entities[0].pose = pose;
}

struct Errors {
    double rms = 0.0, worst = 0.0;
};

/// Contrast intensity against the solid angle of the mesh, over 12 x 12 phases that are irrational
/// to every lattice of samples.
Errors errorsOverPhases(InteractiveRenderer& irsg, const Triangles& mesh, double size_m,
                        double size_px, double roll_rad) {
    irsg.scene.entities = {grey(mesh)};
    look(irsg, viewOf(size_m, size_px));
    const Attitude attitude{0, 0, roll_rad};
    Errors errors;
    constexpr int phases = 12;
    for (int i = 0; i < phases; ++i) {
        for (int j = 0; j < phases; ++j) {
            shift(irsg, std::fmod(i * 0.61803398875 + 0.1, 1.0),
                  std::fmod(j * 0.41421356237 + 0.3, 1.0), attitude);
            const Vec3 away =
                irsg.view.viewpoint.position_m - irsg.scene.entities[0].pose.position_m;
            const Vec3 from = attitude.rotation().transposed() * away;
            const double truth =
                greyRadiance_W_m2_sr() * convexSolidAngle_sr(mesh, from) * dot(away, away);
            const double error = irsg.measure().all.contrastIntensity_W_sr / truth - 1.0;
            errors.rms += error * error / (phases * phases);
            errors.worst = std::max(errors.worst, std::abs(error));
        }
    }
    errors.rms = std::sqrt(errors.rms);
    return errors;
}

/// An L of two plates 2 m high that face the camera.
Triangles lShape() {
    return joined(plateMesh({-0.7, 0, 0}, {0, 0, 1}, {0.3, 0, 0}, one),
                  plateMesh({0.3, 0, -0.8}, {0, 0, 0.2}, {0.7, 0, 0}, one));
}

const double sizes_px[] = {100.0, 30.0, 3.0, 1.0, 0.6, 0.1, 0.01};

} // namespace

TEST(AlignedTiles, KeepsTheIntensityOfASphereAtEveryPhaseFromAHundredPixelsToAHundredth) {
    const Triangles mesh = sphereMesh(1.0, 48, 96, one);
    InteractiveRenderer& irsg = generator();
    for (double size_px : sizes_px) {
        const Errors errors = errorsOverPhases(irsg, mesh, 2.0, size_px, 0.0);
        EXPECT_LE(errors.rms, 1e-3) << size_px << " px";
        EXPECT_LE(errors.worst, 1e-2) << size_px << " px";
        std::printf("sphere %6.2f px: RMS %.1e, largest %.1e\n", size_px, errors.rms, errors.worst);
    }
}

TEST(AlignedTiles, KeepsTheIntensityOfALopsidedBodyThatIsTurned) {
    InteractiveRenderer& irsg = generator();
    for (double angle_deg : {5.0, 30.0, 45.0, 85.0}) {
        for (double size_px : sizes_px) {
            const Errors errors =
                errorsOverPhases(irsg, lShape(), 2.0, size_px, radians(angle_deg));
            EXPECT_LE(errors.rms, 1e-3) << size_px << " px at " << angle_deg << " deg";
            EXPECT_LE(errors.worst, 1e-2) << size_px << " px at " << angle_deg << " deg";
            std::printf("L at %.0f deg, %6.2f px: RMS %.1e, largest %.1e\n", angle_deg, size_px,
                        errors.rms, errors.worst);
        }
    }
}

/// With one lattice for all edges these turns had 0.24 to 0.47 % RMS.
TEST(AlignedTiles, KeepsTheIntensityWhereALatticeWouldMeetTheEdges) {
    InteractiveRenderer& irsg = generator();
    for (const auto& [angle_deg, size_px] :
         {std::pair{31.5, 0.61}, {37.0, 5.9}, {56.5, 0.61}, {57.5, 0.067}, {85.5, 53.0}}) {
        const Errors errors = errorsOverPhases(irsg, lShape(), 2.0, size_px, radians(angle_deg));
        EXPECT_LE(errors.rms, 1e-3) << size_px << " px at " << angle_deg << " deg";
        EXPECT_LE(errors.worst, 2e-3) << size_px << " px at " << angle_deg << " deg";
    }
}

TEST(AlignedTiles, KeepsTheIntensityOfEdgesAlongThePixels) {
    InteractiveRenderer& irsg = generator();
    for (double size_px : sizes_px) {
        const Errors errors = errorsOverPhases(irsg, lShape(), 2.0, size_px, 0.0);
        EXPECT_LE(errors.rms, 5e-3) << size_px << " px";
        std::printf("L, upright %6.2f px: RMS %.1e, largest %.1e\n", size_px, errors.rms,
                    errors.worst);
    }
}

TEST(AlignedTiles, SharesASmallObjectAmongThePixelsItTouches) {
    // A sphere 0.2 pixels wide on a corner, an edge and in the middle of pixels.
    InteractiveRenderer& irsg = generator();
    irsg.scene.entities = {grey(sphereMesh(1.0, 64, 128, one))};
    look(irsg, viewOf(2.0, 0.2)); // an odd number of pixels: it looks at the middle of one
    const double whole = greyRadiance_W_m2_sr() * pi * 0.01;
    const int middle = irsg.view.sensor.width_px / 2;
    ASSERT_EQ(irsg.view.sensor.width_px % 2, 1);
    const auto pixel = [&](const RadianceImage& image, int right, int down) {
        return static_cast<double>(image.at(middle + right, middle + down));
    };
    const RadianceImage centred = irsg.imageWithReport().image;
    EXPECT_NEAR(pixel(centred, 0, 0) / whole, 1.0, 2e-3);
    EXPECT_EQ(pixel(centred, 1, 0), 0.0);

    shift(irsg, 0.5, 0.0);
    const RadianceImage onEdge = irsg.imageWithReport().image;
    EXPECT_NEAR(pixel(onEdge, 0, 0) / whole, 0.5, 2e-3);
    EXPECT_NEAR(pixel(onEdge, 1, 0) / whole, 0.5, 2e-3);

    shift(irsg, 0.5, 0.5);
    const RadianceImage onCorner = irsg.imageWithReport().image;
    for (const auto& [right, down] : {std::pair{0, 0}, {1, 0}, {0, -1}, {1, -1}}) {
        EXPECT_NEAR(pixel(onCorner, right, down) / whole, 0.25, 2e-3);
    }
}

TEST(AlignedTiles, CrossesItsThresholdsWithoutAJump) {
    // The object becomes less than a pixel, and less than a tile: intensity stays.
    const Triangles mesh = sphereMesh(1.0, 48, 96, one);
    InteractiveRenderer& irsg = generator();
    irsg.scene.entities = {grey(mesh)};
    for (double threshold_px : {128.0, 85.0, 64.0, 2.0, 1.0, 0.5, 0.25, 0.125}) {
        const auto relative = [&](double size_px) {
            const View view = viewOf(2.0, size_px);
            look(irsg, view);
            shift(irsg, 0.37, 0.21);
            const Vec3 away =
                irsg.view.viewpoint.position_m - irsg.scene.entities[0].pose.position_m;
            return irsg.measure().all.intensity_W_sr /
                   (greyRadiance_W_m2_sr() * convexSolidAngle_sr(mesh, away) * dot(away, away));
        };
        EXPECT_NEAR(relative(threshold_px * 1.001), relative(threshold_px * 0.999), 3e-3)
            << threshold_px << " px";
    }
}

TEST(AlignedTiles, HidesAndShowsASmallObjectBeforeALargeOne) {
    // A hot point 0.1 pixels wide, before and behind a cold plate of 40 pixels.
    InteractiveRenderer& irsg = generator();
    Entity plate = grey(plateMesh({}, {0, 0, 4}, {4, 0, 0}, one));
    Entity point = entityOf(modelOf(sphereMesh(0.01, 64, 128, one)), greyDatabase(1.0, 900.0));
    plate.name = "plate";
    point.name = "point";
    irsg.scene.entities = {plate, point};
    look(irsg, viewOf(8.0, 40.0));
    shift(irsg, 0.37, 0.21);
    const double range_m = length(irsg.view.viewpoint.position_m - Vec3{0, 0, standingAltitude_m});

    irsg.scene.entities[1].pose = {{1.01, -1.0, standingAltitude_m + 0.7}, {}};
    const double behind_W_sr = irsg.imageWithReport().report.all.intensity_W_sr;
    EXPECT_EQ(irsg.measure().objects[1].coveredPixels, 0.0);

    irsg.scene.entities[1].pose = {{1.01, 1.0, standingAltitude_m + 0.7}, {}};
    const RenderReport before = irsg.imageWithReport().report;
    const double hot = bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 900.0);
    const double area_m2 = pi * 0.01 * 0.01;
    const double hiddenArea_m2 = area_m2 * std::pow(range_m / (range_m - 1.0), 2);
    EXPECT_NEAR((before.all.intensity_W_sr - behind_W_sr) /
                    (hot * area_m2 - greyRadiance_W_m2_sr() * hiddenArea_m2),
                1.0, 5e-3);
    EXPECT_NEAR(before.objects[1].coveredPixels / (pi * 0.05 * 0.05), 1.0, 5e-3);
}

TEST(AlignedTiles, KeepsTheTargetInABackgroundOfAnyLevel) {
    // The background is the target's own radiance but for 1e-6, and a million times as bright.
    InteractiveRenderer& irsg = generator();
    const Triangles mesh = sphereMesh(1.0, 48, 96, one);
    irsg.scene.entities = {grey(mesh)};
    look(irsg, viewOf(2.0, 0.3));
    shift(irsg, 0.37, 0.21);
    const double dark = irsg.imageWithReport().report.all.contrastIntensity_W_sr;
    for (double ratio : {1.0 + 1e-6, 1e6}) {
        InteractiveRenderer& bright = generator(ratio * greyRadiance_W_m2_sr());
        const ObjectRadiometry all = bright.imageWithReport().report.all;
        EXPECT_NEAR(all.contrastIntensity_W_sr / ((1.0 - ratio) * dark), 1.0,
                    ratio < 2.0 ? 0.2 : 1e-6);
        EXPECT_NEAR(bright.measure().all.contrastIntensity_W_sr / ((1.0 - ratio) * dark), 1.0,
                    ratio < 2.0 ? 0.2 : 1e-6);
    }
}

TEST(AlignedTiles, DrawsTheSameImageTwiceAndInAnyOrderOfObjects) {
    InteractiveRenderer& irsg = generator(0.3);
    Entity ball = grey(sphereMesh(1.0, 64, 128, one));
    Entity box = entityOf(modelOf(boxMesh({0.5, 2, 0.4}, std::vector<IrCodes>(6, one))),
                          greyDatabase(0.5, 400.0));
    Entity far = entityOf(modelOf(lShape()), greyDatabase(0.7, 500.0));
    box.pose = {{0.4, 0.3, standingAltitude_m + 0.2}, {0.3, 0.2, 0.1}};
    far.pose = {{9.0, 0.3, standingAltitude_m + 0.2}, {0.3, 0.2, 0.1}};
    ball.pose = {{0, 0, standingAltitude_m}, {}};
    View view = viewOf(2.0, 12.0);
    view.width_px = view.height_px = 160;
    view.fieldOfView_rad = 2.0 * std::atan(80 * pixel_rad);

    irsg.scene.entities = {ball, box, far};
    look(irsg, view);
    const Viewpoint camera = irsg.view.viewpoint;
    const RadianceImage first = irsg.imageWithReport().image, again = irsg.imageWithReport().image;
    EXPECT_EQ(first.primary().values, again.primary().values);
    irsg.scene.entities = {far, box, ball};
    irsg.view.viewpoint = camera;
    const RadianceImage other = irsg.imageWithReport().image;
    for (std::size_t i = 0; i < other.primary().values.size(); ++i) {
        EXPECT_NEAR(other.primary().values[i], first.primary().values[i],
                    1e-6f * first.primary().values[i]);
    }
}

TEST(AlignedTiles, ShowsWhatLeavesTheFrameStraddlesItOrStandsAroundTheCamera) {
    InteractiveRenderer& irsg = generator();
    const Triangles mesh = sphereMesh(1.0, 48, 96, one);
    irsg.scene.entities = {grey(mesh)};
    look(irsg, viewOf(2.0, 10.0)); // 21 pixels
    // Half of it beyond the right edge, 10.5 pixels from the middle.
    shift(irsg, 10.5, 0.0);
    const double half = irsg.imageWithReport().report.all.coveredPixels;
    EXPECT_NEAR(half / (0.5 * pi * 25.0), 1.0, 5e-3);
    shift(irsg, 15.7, 0.0);
    EXPECT_EQ(irsg.imageWithReport().report.all.coveredPixels, 0.0);

    // Behind the camera; around the camera, whose walls then fill the frame.
    Viewpoint camera = irsg.view.viewpoint;
    irsg.scene.entities[0].pose = {camera.position_m + camera.backward * 50.0, {}};
    EXPECT_EQ(irsg.imageWithReport().report.all.coveredPixels, 0.0);
    irsg.scene.entities[0].pose = {camera.position_m + camera.backward * 0.3, {}};
    const RenderedImage inside = irsg.imageWithReport();
    EXPECT_NEAR(inside.report.all.coveredPixels, 441.0, 1e-6);
    EXPECT_NEAR(inside.image.at(3, 4) / greyRadiance_W_m2_sr(), 1.0, 1e-5);
}

TEST(AlignedTiles, NamesTheSurfaceOfAnObjectSmallerThanAPixel) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.entities = {grey(sphereMesh(1.0, 64, 128, one))};
    look(irsg, viewOf(2.0, 0.1));
    shift(irsg, 0.3, 0.2);
    RenderSettings settings = irsg.scene.settings;
    settings.truthLayers = true;
    irsg.scene.settings = settings;
    const RadianceImage image = irsg.imageWithReport().image;
    const std::size_t middle = image.offset(3, 3);
    EXPECT_EQ(image.find("temperature_index")->values[middle], 1.0f);
    float sum = 0.0f;
    for (const char* term : {"thermal", "sun", "up", "down", "path", "background"}) {
        sum += image.find(term)->values[middle];
    }
    // The terms are a drawing of their own, in which a sample on the outline may fall differently.
    EXPECT_NEAR(sum / image.primary().values[middle], 1.0, 1e-4);
}

TEST(PointSource, KeepsTheIntensityOfItsTileAndIsRenderedOnce) {
    InteractiveRenderer& irsg = generator(0.2);
    Entity body = grey(joined(lShape(), boxMesh({0.3, 0.6, 0.2}, std::vector<IrCodes>(6, one))));
    body.pose.attitude = {0.3, 0.2, 0.1};
    irsg.scene.entities = {body};
    RenderSettings settings = irsg.scene.settings;
    irsg.resetStageTimes();
    for (double size_px : {0.012, 0.008, 0.001, 1e-6}) {
        look(irsg, viewOf(2.0, size_px));
        shift(irsg, 0.37, 0.21, body.pose.attitude);
        const RenderReport point = irsg.imageWithReport().report;
        const ObjectRadiometry measured = irsg.measure().all;
        settings.pointSourceBelow_px = 0.0;
        irsg.scene.settings = settings;
        const ObjectRadiometry drawn = irsg.measure().all;
        settings.pointSourceBelow_px = 1.0 / 64.0;
        irsg.scene.settings = settings;
        EXPECT_NEAR(point.all.contrastIntensity_W_sr / drawn.contrastIntensity_W_sr, 1.0, 2e-3);
        EXPECT_NEAR(measured.contrastIntensity_W_sr / point.all.contrastIntensity_W_sr, 1.0, 1e-5);
        EXPECT_NEAR(measured.irradiance_W_m2 / drawn.irradiance_W_m2, 1.0, 2e-3);
        EXPECT_NEAR(point.all.coveredPixels / drawn.coveredPixels, 1.0, 2e-3);
    }
    irsg.resetStageTimes();
    look(irsg, viewOf(2.0, 0.005));
    shift(irsg, 0.1, 0.1, body.pose.attitude);
    const double first = irsg.imageWithReport().report.all.intensity_W_sr;
    for (const StageTimes::Stage& stage : irsg.stageTimes().stages) {
        EXPECT_NE(stage.name, "drawing");
    }
    // Seen from elsewhere, it is drawn anew.
    View side = viewOf(2.0, 0.005);
    side.azimuth_rad = 0.5;
    look(irsg, side);
    EXPECT_GT(std::abs(irsg.imageWithReport().report.all.intensity_W_sr / first - 1.0), 0.01);
}

TEST(PointSource, DoesNotDependOnWhoSawItFirst) {
    // Seen before from a hair's breadth away, nearer and by another sensor; then as by a new one.
    const Entity body =
        grey(joined(lShape(), boxMesh({0.3, 0.6, 0.2}, std::vector<IrCodes>(6, one))));
    View wanted = viewOf(2.0, 0.005);
    wanted.azimuth_rad = 0.4 + 2e-6;
    InteractiveRenderer& seasoned = generator();
    seasoned.scene.entities = {body};
    View earlier = viewOf(2.0, 0.012);
    earlier.azimuth_rad = 0.4;
    earlier.width_px = earlier.height_px = 31;
    look(seasoned, earlier);
    seasoned.imageWithReport();
    look(seasoned, wanted);
    const auto again = seasoned.imageWithReport();

    InteractiveRenderer fresh{RenderSettings::direct()};
    fresh.scene.environment = seasoned.scene.environment;
    fresh.scene.settings = seasoned.scene.settings;
    fresh.scene.entities = {body};
    look(fresh, wanted);
    const auto first = fresh.imageWithReport();
    EXPECT_GT(first.report.all.coveredPixels, 0.0);
    EXPECT_EQ(again.image.primary().values, first.image.primary().values);
    EXPECT_EQ(again.report.all.intensity_W_sr, first.report.all.intensity_W_sr);
}

TEST(PointSource, LetsGasThroughAsItsWindowDoes) {
    InteractiveRenderer& irsg = generator(0.2);
    Entity body = grey(joined(sphereMesh(1.0, 24, 48, IrCodes{2, 2}),
                              plateMesh({}, {0, 0, 0.6}, {0.6, 0, 0}, one)));
    body.pose.attitude.roll_rad = 0.2;
    SignatureDatabase database = *body.database;
    database.temperatures[2] = fixedTemperature(700.0);
    database.materials[2] = greyMaterial(0.3, 0.7);
    body.database = std::make_shared<const SignatureDatabase>(database);
    irsg.scene.entities = {body};
    look(irsg, viewOf(2.0, 0.01));
    RenderSettings settings = irsg.scene.settings;
    const ObjectRadiometry point = irsg.imageWithReport().report.all;
    settings.pointSourceBelow_px = 0.0;
    irsg.scene.settings = settings;
    const ObjectRadiometry drawn = irsg.imageWithReport().report.all;
    EXPECT_NEAR(point.contrastIntensity_W_sr / drawn.contrastIntensity_W_sr, 1.0, 5e-3);
    EXPECT_NEAR(point.coveredPixels / drawn.coveredPixels, 1.0, 5e-3);
}

TEST(AlignedTiles, SharesTheMemoryOfItsTiles) {
    // Ten windows of 512 samples: of opaque objects, of ones that let light through, and of both
    // with their truth. They need no more than the frame and 32 MB, and hardly more than one of
    // them.
    constexpr std::size_t frame_bytes = 640 * 512 * 3 * sizeof(float);
    constexpr std::size_t allowance_bytes = 32u << 20;
    const std::shared_ptr<const Model> ball = modelOf(sphereMesh(1.0, 16, 32, one));
    const auto memory_bytes = [&](int objects, double transmissivity) {
        InteractiveRenderer irsg{RenderSettings::direct()};
        irsg.scene.environment = environmentOf(ConstantAtmosphere{});
        RenderSettings settings = RenderSettings::direct();
        settings.tileSide_samples = 512;
        settings.background = BackgroundMode::constant;
        settings.truthLayers = true;
        irsg.scene.settings = settings;
        std::vector<Entity> entities;
        for (int i = 0; i < objects; ++i) {
            Entity& entity = entities.emplace_back(
                entityOf(ball, greyDatabase(0.4, temperature_K, 0.0, transmissivity)));
            entity.pose.position_m.x += 3.1 * (i % 5);
            entity.pose.position_m.z += 3.1 * (i / 5);
        }
        irsg.scene.entities = entities;
        View view = viewOf(2.0, 34.0);
        view.width_px = 640;
        view.height_px = 512;
        view.fieldOfView_rad = 2.0 * std::atan(320 * pixel_rad);
        look(irsg, view);
        EXPECT_EQ(irsg.graphicsMemory_bytes(), 0u);
        const RenderReport report = irsg.imageWithReport().report;
        for (const ObjectRadiometry& object : report.objects) {
            EXPECT_GT(object.coveredPixels, 100.0);
        }
        return irsg.graphicsMemory_bytes();
    };
    for (double transmissivity : {0.0, 0.5}) {
        const std::size_t ten = memory_bytes(10, transmissivity);
        EXPECT_GT(ten, 512u * 480u * 3u * sizeof(float));
        EXPECT_LE(ten, frame_bytes + allowance_bytes);
        EXPECT_LE(static_cast<double>(ten),
                  2.0 * static_cast<double>(memory_bytes(1, transmissivity)));
        std::printf("ten windows of 512, transmissivity %.1f: %.1f MB\n", transmissivity,
                    static_cast<double>(ten) / (1 << 20));
    }
}

TEST(SupersamplingInAll, CountsItsSamplesInAll) {
    // Two in all lie side by side: a plate over the lower half of a pixel is seen whole or not.
    InteractiveRenderer& irsg = generator();
    RenderSettings settings = irsg.scene.settings;
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 4;
    irsg.scene.entities = {grey(sphereMesh(1.0, 64, 128, one))};
    look(irsg, viewOf(2.0, 5.0));
    settings.countsPerPixel = true;
    irsg.scene.settings = settings;
    const RadianceImage fourInAll = irsg.imageWithReport().image;
    settings.countsPerPixel = false;
    settings.samplesPerAxis = 2;
    irsg.scene.settings = settings;
    EXPECT_EQ(irsg.imageWithReport().image.primary().values, fourInAll.primary().values);
    useZoom(irsg, 128);
    EXPECT_NE(irsg.imageWithReport().image.primary().values, fourInAll.primary().values);
}

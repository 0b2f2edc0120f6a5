// Shadows of the sun against closed forms, with both engines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <osg/Geode>
#include <osg/Geometry>

#include "irsg/radiometry/Units.h"
#include "irsg/render/background/Terrain.h"
#include "irsg/render/rays/SunShadows.h"
#include "tests/support/MadeGraphs.h"
#include "tests/support/SceneFixtures.h"

namespace irsg {
void PrintTo(EngineChoice engine, std::ostream* out) {
    *out << (engine == EngineChoice::rays ? "rays" : "OpenGL");
}
} // namespace irsg

using namespace irsg;
using namespace irsg::test;

namespace {

const SunPosition sun{0.8, radians(40.0)};
const double sunIrradiance = 3.0; // W m-2 um-1

Environment sunlit() {
    ConstantAtmosphere air;
    air.sunValue = sunIrradiance;
    return environmentOf(air, sun);
}

RenderSettings shadowSettings(EngineChoice engine, SunShadowMode mode) {
    RenderSettings settings = RenderSettings::direct();
    settings.engine = engine;
    settings.sunShadows = mode;
    settings.ambientReflection = ReflectionMode::off;
    settings.background = BackgroundMode::none;
    settings.truthLayers = true;
    return settings;
}

RenderSettings onePixelOneSample(RenderSettings settings) {
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 1;
    return settings;
}

/// A plate of code 1 in the xy plane and, above it, a sphere of code 2.
struct SphereAbovePlate {
    double radius_m = 0.5, height_m = 3.0, half_m = 8.0;

    Entity entity() const {
        Triangles mesh = plateMesh({}, {half_m, 0, 0}, {0, half_m, 0}, {1, 1});
        Triangles sphere = sphereMesh(radius_m, 90, 180, {2, 2});
        for (Triangle& triangle : sphere) {
            for (Vec3& vertex : triangle.vertex) {
                vertex.z += height_m;
            }
        }
        SignatureDatabase database = greyDatabase(0.2, 200.0);
        database.temperatures[2] = fixedTemperature(200.0);
        database.materials[2] = greyMaterial(0.2);
        Entity made = entityOf(modelOf(joined(mesh, sphere)), database);
        made.pose.position_m.z = standingAltitude_m;
        made.referencePoint_m = Vec3{};
        return made;
    }
    Vec3 shadowMiddle_m() const {
        const Vec3 s = direction(sun.azimuth_rad, sun.elevation_rad);
        return Vec3{0, 0, height_m} - s * (height_m / s.z);
    }
    /// Part of the sun's disc that a point of the plate sees: two circles that overlap.
    double visibility(double x_m, double y_m, double discRadius_rad) const {
        const Vec3 towards = Vec3{0, 0, height_m} - Vec3{x_m, y_m, 0};
        const double own = std::asin(radius_m / length(towards));
        const Vec3 s = direction(sun.azimuth_rad, sun.elevation_rad);
        const double apart = std::atan2(length(cross(towards, s)), dot(towards, s));
        if (discRadius_rad == 0.0) {
            return apart < own ? 0.0 : 1.0;
        }
        const double a = discRadius_rad, b = own;
        if (apart >= a + b) {
            return 1.0;
        }
        if (apart <= std::abs(a - b)) {
            return a <= b ? 0.0 : 1.0 - b * b / (a * a);
        }
        const double u = std::acos((apart * apart + a * a - b * b) / (2.0 * apart * a));
        const double v = std::acos((apart * apart + b * b - a * a) / (2.0 * apart * b));
        const double lens =
            a * a * (u - std::sin(u) * std::cos(u)) + b * b * (v - std::sin(v) * std::cos(v));
        return 1.0 - lens / (pi * a * a);
    }
};

/// From straight above, north up, with a square of the plate in the field.
void lookDown(InteractiveRenderer& irsg, const Vec3& middle_m, double range_m, double width_m,
              int pixels) {
    irsg.view.sensor = sensorOf(pixels, pixels, degrees(2.0 * std::atan(0.5 * width_m / range_m)));
    const Vec3 at = middle_m + Vec3{0, 0, standingAltitude_m};
    irsg.view.viewpoint = Viewpoint::lookAt(at + Vec3{0, 0, range_m}, at, {0, 1, 0}, {0, 1, 0});
}

class SunShadowsTest : public testing::TestWithParam<EngineChoice> {
  protected:
    void SetUp() override {
        if (!areRaysBuilt()) {
            GTEST_SKIP() << whyNoRays();
        }
    }
    InteractiveRenderer made(const std::vector<Entity>& entities,
                             const RenderSettings& settings) const {
        InteractiveRenderer irsg{RenderSettings::direct()};
        irsg.scene.environment = sunlit();
        irsg.scene.settings = settings;
        irsg.scene.entities = entities;
        return irsg;
    }
};

/// Air that lets a short and a long half of the band through as given.
Spectrum inHalves(double below, double above) {
    return Spectrum({2.0, 3.999999, 4.000001, 6.0}, {below, below, above, above});
}

} // namespace

TEST_P(SunShadowsTest, OfASphereOnAPlateIsAnEllipse) {
    const SphereAbovePlate scene;
    const Vec3 middle = scene.shadowMiddle_m();
    InteractiveRenderer irsg =
        made({scene.entity()}, onePixelOneSample(shadowSettings(GetParam(), SunShadowMode::point)));
    for (const double range_m : {300.0, 30000.0}) {
        constexpr double width_m = 2.0;
        constexpr int pixels = 400;
        lookDown(irsg, middle, range_m, width_m, pixels);
        const RadianceImage image = irsg.imageWithReport().image;
        const std::vector<float>& sees = image.find("sun_visibility")->values;
        const std::vector<float>& material = image.find("material_index")->values;
        const std::vector<float>& reflected = image.find("sun")->values;
        const double lit = 0.8 / pi * sunIrradiance * 2.0 * std::sin(sun.elevation_rad);
        double dark_m2 = 0.0;
        int wrong = 0;
        for (int y = 0; y < pixels; ++y) {
            for (int x = 0; x < pixels; ++x) {
                const std::size_t i = image.offset(x, y);
                if (material[i] != 1.0f) {
                    continue;
                }
                const double east = middle.x + (x + 0.5 - 0.5 * pixels) * width_m / pixels;
                const double north = middle.y + (0.5 * pixels - y - 0.5) * width_m / pixels;
                const double expected = scene.visibility(east, north, 0.0);
                const auto found = static_cast<double>(sees[i]);
                wrong += std::abs(found - expected) > 1e-6;
                EXPECT_NEAR(static_cast<double>(reflected[i]), lit * found, 1e-5 * lit);
                dark_m2 += (1.0 - found) * width_m * width_m / (pixels * pixels);
            }
        }
        EXPECT_LE(wrong, 60) << "pixels on the border of the shadow, range " << range_m;
        const double ellipse_m2 =
            pi * scene.radius_m * scene.radius_m / std::sin(sun.elevation_rad);
        EXPECT_NEAR(dark_m2 / ellipse_m2, 1.0, 1e-3) << range_m; // 180 corners: 2e-4
        std::printf("  range %.0f m: area %.5f of the ellipse, %d pixels differ\n", range_m,
                    dark_m2 / ellipse_m2, wrong);
    }
}

TEST_P(SunShadowsTest, OfADiscHaveThePenumbraOfTwoCircles) {
    SphereAbovePlate scene;
    scene.height_m = 40.0; // the sphere is 1.4 times as wide as the sun
    scene.half_m = 60.0;
    InteractiveRenderer irsg =
        made({scene.entity()}, onePixelOneSample(shadowSettings(GetParam(), SunShadowMode::disc)));
    constexpr double width_m = 3.0;
    constexpr int pixels = 160;
    const Vec3 middle = scene.shadowMiddle_m();
    lookDown(irsg, middle, 300.0, width_m, pixels);
    const RadianceImage image = irsg.imageWithReport().image;
    const std::vector<float>& sees = image.find("sun_visibility")->values;
    double square = 0.0, sum = 0.0, expectedSum = 0.0, worst = 0.0;
    int between = 0;
    for (int y = 0; y < pixels; ++y) {
        for (int x = 0; x < pixels; ++x) {
            const double east = middle.x + (x + 0.5 - 0.5 * pixels) * width_m / pixels;
            const double north = middle.y + (0.5 * pixels - y - 0.5) * width_m / pixels;
            const double expected = scene.visibility(east, north, SunShadows::discRadius_rad);
            const auto found = static_cast<double>(sees[image.offset(x, y)]);
            between += found > 0.0 && found < 1.0;
            square += (found - expected) * (found - expected);
            worst = std::max(worst, std::abs(found - expected));
            sum += 1.0 - found;
            expectedSum += 1.0 - expected;
        }
    }
    EXPECT_GT(between, 1000);
    EXPECT_LE(std::sqrt(square / (pixels * pixels)), 0.01);
    EXPECT_LE(worst, 0.06); // of 64 rays
    EXPECT_NEAR(sum / expectedSum, 1.0, 3e-3);
    std::printf("  rms %.4f, worst %.3f, sum %.5f\n", std::sqrt(square / (pixels * pixels)), worst,
                sum / expectedSum);
}

TEST_P(SunShadowsTest, OfGlassMultiplyItsTransmissivityNodeByNode) {
    // A plate, and a pane above it that does not stand between it and the sensor.
    Triangles mesh = joined(plateMesh({}, {1, 0, 0}, {0, 1, 0}, {1, 1}),
                            plateMesh({0, 0, 30}, {60, 0, 0}, {0, 60, 0}, {2, 2}));
    for (const int panes : {1, 2}) {
        if (panes == 2) {
            mesh = joined(mesh, plateMesh({0, 0, 31}, {60, 0, 0}, {0, 60, 0}, {2, 2}));
        }
        SignatureDatabase database = greyDatabase(0.2, 200.0);
        database.materials[1].emissivity = inHalves(0.2, 0.8);
        database.temperatures[2] = fixedTemperature(200.0);
        database.materials[2].emissivity = inHalves(0.1, 0.1);
        database.materials[2].transmissivity = inHalves(0.9, 0.1);
        Entity entity = entityOf(modelOf(mesh), database);
        entity.pose.position_m.z = standingAltitude_m;
        entity.referencePoint_m = Vec3{};
        InteractiveRenderer irsg =
            made({entity}, onePixelOneSample(shadowSettings(GetParam(), SunShadowMode::point)));
        look(irsg, {.range_m = 20.0,
                    .azimuth_rad = 0.3,
                    .elevation_rad = 0.6,
                    .width_px = 9,
                    .height_px = 9,
                    .fieldOfView_rad = 0.02});
        const RadianceImage image = irsg.imageWithReport().image;
        const std::size_t i = image.offset(4, 4);
        const double cosine = std::sin(sun.elevation_rad);
        const double expected =
            sunIrradiance * cosine / pi * (0.8 * std::pow(0.9, panes) + 0.2 * std::pow(0.1, panes));
        EXPECT_NEAR(static_cast<double>(image.find("sun")->values[i]) / expected, 1.0, 1e-4);
        EXPECT_EQ(image.find("sun_visibility")->values[i], 1.0f);
        // The same from factors, and as a picture that is followed.
        const double reported = irsg.measure().all.intensity_W_sr;
        const double ofPicture = irsg.imageWithReport().report.all.intensity_W_sr;
        EXPECT_NEAR(reported / ofPicture, 1.0, 1e-5);
        irsg.picture();
        const RadianceImage followed = irsg.picture();
        EXPECT_NEAR(static_cast<double>(followed.primary().values[i]) /
                        static_cast<double>(image.primary().values[i]),
                    1.0, 1e-5);
    }
}

TEST_P(SunShadowsTest, LeaveConvexBodiesAsTheyAre) {
    for (const bool isSmooth : {true, false}) {
        for (const double azimuth_rad : {0.0, 0.8, 2.0, 3.5}) {
            Entity entity = entityOf(modelOf(sphereMesh(1.0, 24, 48, {1, 1}, isSmooth)),
                                     greyDatabase(0.2, 200.0));
            entity.pose.position_m.z = standingAltitude_m;
            std::vector<double> intensities;
            for (const SunShadowMode mode : {SunShadowMode::off, SunShadowMode::point}) {
                InteractiveRenderer irsg = made({entity}, shadowSettings(GetParam(), mode));
                look(irsg, {.range_m = 300.0, .azimuth_rad = azimuth_rad});
                intensities.push_back(irsg.measure().all.intensity_W_sr);
            }
            EXPECT_NEAR(intensities[1] / intensities[0], 1.0, 5e-4)
                << isSmooth << " " << azimuth_rad;
        }
    }
}

TEST_P(SunShadowsTest, AreCastByOtherEntitiesAndTerrainAlsoFromOutsideTheFrame) {
    Entity plate =
        entityOf(modelOf(plateMesh({}, {1, 0, 0}, {0, 1, 0}, {1, 1})), greyDatabase(0.2, 200.0));
    plate.pose.position_m.z = standingAltitude_m;
    const Vec3 s = direction(sun.azimuth_rad, sun.elevation_rad);
    Entity cover =
        entityOf(modelOf(boxMesh({2, 2, 2}, {{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}})),
                 greyDatabase(0.2, 200.0));
    cover.pose.position_m = plate.pose.position_m + s * 80.0;
    // A wall of terrain between them and the sun.
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    const Vec3 right = normalized(cross(s, {0, 0, 1})), up = cross(right, s);
    const Vec3 corners[] = {
        s * 300.0 - right * 20.0 - up * 20.0, s * 300.0 + right * 20.0 - up * 20.0,
        s * 300.0 + right * 20.0 + up * 20.0, s * 300.0 - right * 20.0 + up * 20.0};
    const osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (const Vec3& v : corners) {
        vertices->push_back(
            osg::Vec3(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)));
    }
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    const auto terrain = terrainOfGraph(*geode, "wall", plate.pose.position_m);

    const auto sentBy = [&](const std::vector<Entity>& entities, bool withTerrain, double range_m,
                            ReflectionMode reflection = ReflectionMode::smart) {
        RenderSettings settings = shadowSettings(GetParam(), SunShadowMode::point);
        settings.sun = reflection;
        InteractiveRenderer irsg = made(entities, settings);
        if (withTerrain) {
            irsg.scene.terrain = terrain;
        }
        look(irsg, {.range_m = range_m, .azimuth_rad = 4.0, .elevation_rad = 0.9});
        return irsg.measure().objects.front().intensity_W_sr;
    };
    for (const double range_m : {60.0, 1e6}) { // 1e6: a point
        const double emitted = sentBy({plate}, false, range_m, ReflectionMode::off);
        EXPECT_GT(sentBy({plate}, false, range_m), 10.0 * emitted);
        EXPECT_NEAR(sentBy({plate, cover}, false, range_m) / emitted, 1.0, 1e-5) << range_m;
        EXPECT_NEAR(sentBy({plate}, true, range_m) / emitted, 1.0, 1e-5) << range_m;
    }
}

TEST_P(SunShadowsTest, AreTheSameInSweepsAsInPicturesAndWithBothEngines) {
    const auto model = Model::load(SMAT_SOURCE_DIR "/samples/turboprop4/turboprop4.flt");
    SignatureDatabase database;
    for (const auto& [codes, use] : model->codes()) {
        database.temperatures[codes.temperature] = fixedTemperature(280.0);
        database.materials[codes.material] =
            greyMaterial(0.4, codes.material >= 5 && codes.material <= 7 ? 0.5 : 0.0);
    }
    Entity entity = entityOf(model, database);
    entity.pose.position_m.z = standingAltitude_m;
    const auto intensity = [&](EngineChoice engine, SunShadowMode mode, bool asPicture) {
        InteractiveRenderer irsg = made({entity}, shadowSettings(engine, mode));
        look(irsg, {.range_m = 1500.0,
                    .azimuth_rad = 0.9,
                    .elevation_rad = 0.7,
                    .width_px = 96,
                    .height_px = 96});
        return asPicture ? irsg.imageWithReport().report.all.intensity_W_sr
                         : irsg.measure().all.intensity_W_sr;
    };
    const double swept = intensity(GetParam(), SunShadowMode::point, false);
    EXPECT_NEAR(intensity(GetParam(), SunShadowMode::point, true) / swept, 1.0, 2e-3);
    EXPECT_NEAR(intensity(EngineChoice::rays, SunShadowMode::point, false) / swept, 1.0, 1e-3);
    const double without = intensity(GetParam(), SunShadowMode::off, false);
    EXPECT_LT(swept / without, 0.999);
    std::printf("  with shadows %.4f of without\n", swept / without);
}

INSTANTIATE_TEST_SUITE_P(Engines, SunShadowsTest,
                         testing::Values(EngineChoice::opengl, EngineChoice::rays),
                         [](const auto& row) {
                             return row.param == EngineChoice::rays ? "Rays" : "OpenGl";
                         });

#include <gtest/gtest.h>

#include <cmath>

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

const IrCodes one{1, 1};

RenderSettings samples(int perAxis) {
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = perAxis;
    return settings;
}

InteractiveRenderer& generator() {
    static InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = Environment::vacuum();
    irsg.scene.settings = {};
    return irsg;
}

/// Vacuum without its sun.
Environment darkness() {
    return environmentOf(ConstantAtmosphere{});
}

float centreOf(const RadianceImage& image) {
    return image.at(image.width() / 2, image.height() / 2);
}

} // namespace

TEST(GreySphere, ShowsItsPlanckRadianceInTheCentrePixel) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = darkness();
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 64, 128, one)), greyDatabase(0.9, 320.0))};
    for (const Band& band : {Band::topHat(3.0, 5.0), Band::topHat(8.0, 12.0)}) {
        look(irsg, {.range_m = 100.0, .band = band});
        const double expected = 0.9 * bandRadiance_W_m2_sr(band, 320.0);
        const double found = static_cast<double>(centreOf(irsg.imageWithReport().image));
        EXPECT_NEAR(found / expected, 1.0, 1e-5) << band.name();
        RecordProperty("relative_error_" + band.name(), std::to_string(found / expected - 1.0));
    }
}

TEST(GreySphere, HasTheIntensityOfItsMeshOverAllPixelPhases) {
    // 34 pixels across, supersampling 4, 16 x 16 phases that are irrational to the sampling
    // lattice.
    const Triangles mesh = sphereMesh(1.0, 128, 256, one);
    const double range_m = 1000.0, pixel_rad = 2.0 / range_m / 34.0;
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = darkness();
    irsg.scene.settings = samples(4);
    irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(0.9, 320.0))};
    look(irsg, {.range_m = range_m,
                .width_px = 48,
                .height_px = 48,
                .fieldOfView_rad = 2.0 * std::atan(24.0 * pixel_rad)});

    const double radiance = 0.9 * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 320.0);
    const Viewpoint camera = irsg.view.viewpoint;
    double squares = 0.0, worst = 0.0;
    for (int i = 0; i < 16; ++i) {
        for (int j = 0; j < 16; ++j) {
            const double step_m = pixel_rad * range_m;
            const double u = std::fmod(i * 0.61803398875 + 0.1, 1.0) * step_m;
            const double v = std::fmod(j * 0.41421356237 + 0.3, 1.0) * step_m;
            Pose pose{{0, 0, standingAltitude_m}, {}};
            pose.position_m = pose.position_m + camera.right * u + camera.up * v;
            irsg.scene.entities[0].pose = pose;
            const Vec3 from = camera.position_m - pose.position_m;
            const double truth = radiance * convexSolidAngle_sr(mesh, from) * dot(from, from);
            const double error =
                irsg.imageWithReport().report.all.contrastIntensity_W_sr / truth - 1.0;
            squares += error * error;
            worst = std::max(worst, std::abs(error));
        }
    }
    const double rms = std::sqrt(squares / 256.0);
    EXPECT_LE(rms, 1e-3);
    RecordProperty("rms", std::to_string(rms));
    RecordProperty("worst", std::to_string(worst));
    std::printf("sphere 34 px, 4 samples an axis, 256 phases: RMS %.2e, largest %.2e\n", rms,
                worst);
}

TEST(GreySphere, RadiatesTwoThirdsWithAnAngleFactorOfOne) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = darkness();
    irsg.scene.settings = samples(4);
    const auto model = modelOf(sphereMesh(1.0, 128, 256, one));
    const double range_m = 20000.0;
    auto intensity = [&](double n) {
        irsg.scene.entities = {entityOf(model, greyDatabase(0.9, 320.0, n))};
        look(irsg, {.range_m = range_m,
                    .width_px = 256,
                    .height_px = 256,
                    .fieldOfView_rad = 2.4 / range_m});
        return irsg.imageWithReport().report.all.intensity_W_sr;
    };
    const double lambert = intensity(0.0);
    // Over the disc of a distant sphere the mean of cos^N is 2 / (N + 2).
    for (double n : {0.25, 1.0, 3.0, 50.0}) {
        EXPECT_NEAR(intensity(n) / lambert, 2.0 / (n + 2.0), 3e-4) << "N = " << n;
    }
}

TEST(GreySphere, FollowsTheAngleFactorAlongItsRadius) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = darkness();
    irsg.scene.settings = samples(1);
    const auto model = modelOf(sphereMesh(1.0, 128, 256, one));
    const double range_m = 20000.0;
    for (double n : {0.0, 0.25, 1.0, 3.0}) {
        irsg.scene.entities = {entityOf(model, greyDatabase(1.0, 300.0, n))};
        look(irsg, {.range_m = range_m,
                    .width_px = 201,
                    .height_px = 201,
                    .fieldOfView_rad = 2.0 / range_m});
        const RadianceImage image = irsg.imageWithReport().image;
        const double black = bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 300.0);
        for (int x = 100; x < 195; x += 5) {
            const double sine = (x - 100) / 100.5;
            const double expected = std::pow(std::sqrt(1.0 - sine * sine), n);
            EXPECT_NEAR(static_cast<double>(image.at(x, 100)) / black, expected, 2e-3)
                << "N = " << n << ", sine " << sine;
        }
    }
}

TEST(GreySphere, ObeysTheInverseSquareLaw) {
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = darkness();
    irsg.scene.settings = samples(8);
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 64, 128, one)), greyDatabase(0.9, 320.0))};
    auto irradianceAt = [&](double range_m) {
        look(irsg, {.range_m = range_m,
                    .width_px = 200,
                    .height_px = 200,
                    .fieldOfView_rad = 2.6 / range_m});
        return irsg.imageWithReport().report.all.irradiance_W_m2;
    };
    EXPECT_NEAR(irradianceAt(1000.0) / irradianceAt(2000.0), 4.0, 4e-5);
    EXPECT_NEAR(irradianceAt(1e4) / irradianceAt(1e7), 1e6, 20.0);
}

// One reflection at a time: emission is that of a body at 1 K, which is none.
struct Reflection {
    const char* name;
    double sun, up, down;
    ReflectionMode sunMode, fluxMode;
    FluxWeights weights;
    /// Fraction of the full term that a facet with this normal reflects.
    std::function<double(const Vec3& normal, const Vec3& sun)> expected;
};
void PrintTo(const Reflection& row, std::ostream* out) {
    *out << row.name;
}

class ReflectionOnASphere : public testing::TestWithParam<Reflection> {};

TEST_P(ReflectionOnASphere, FollowsTheFormulaAlongTheVerticalGreatCircle) {
    const Reflection& c = GetParam();
    ConstantAtmosphere air;
    air.sunValue = c.sun;
    air.upValue = c.up;
    air.downValue = c.down;
    air.transmittanceValue = 0.5;
    const SunPosition sun{radians(30.0), radians(40.0)};
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = environmentOf(air, sun);
    RenderSettings settings = samples(1);
    settings.sun = c.sunMode;
    settings.ambientReflection = c.fluxMode;
    settings.fluxWeights = c.weights;
    irsg.scene.settings = settings;
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 256, 512, one)), greyDatabase(0.3, 1.0))};
    const double range_m = 20000.0;
    look(irsg,
         {.range_m = range_m, .width_px = 101, .height_px = 101, .fieldOfView_rad = 2.0 / range_m});
    const RadianceImage image = irsg.imageWithReport().image;

    const double full = 0.7 * 0.5 / pi * 2.0; // rho tau / pi over 2 um, for a flux of 1
    for (int y = 3; y < 98; ++y) {
        // The camera stands north and looks south: image up is z, the near side is +y.
        const double z = (50 - y) / 50.5;
        const Vec3 normal{0.0, std::sqrt(1.0 - z * z), z};
        const double expected =
            full * c.expected(normal, direction(sun.azimuth_rad, sun.elevation_rad));
        EXPECT_NEAR(static_cast<double>(image.at(50, y)), expected, 2e-4 * full) << "row " << y;
    }
}

INSTANTIATE_TEST_SUITE_P(
    EachTermAlone, ReflectionOnASphere,
    testing::Values(
        Reflection{"Sun", 1, 0, 0, ReflectionMode::smart, ReflectionMode::off,
                   FluxWeights::viewFactor,
                   [](const Vec3& n, const Vec3& s) { return std::max(0.0, dot(n, s)); }},
        Reflection{"Up", 0, 1, 0, ReflectionMode::off, ReflectionMode::smart,
                   FluxWeights::viewFactor,
                   [](const Vec3& n, const Vec3&) { return 0.5 * (1.0 - n.z); }},
        Reflection{"Down", 0, 0, 1, ReflectionMode::off, ReflectionMode::smart,
                   FluxWeights::viewFactor,
                   [](const Vec3& n, const Vec3&) { return 0.5 * (1.0 + n.z); }},
        Reflection{"UpByTheReport", 0, 1, 0, ReflectionMode::off, ReflectionMode::smart,
                   FluxWeights::report,
                   [](const Vec3& n, const Vec3&) { return std::acos(n.z) / pi; }},
        Reflection{"DownByTheReport", 0, 0, 1, ReflectionMode::off, ReflectionMode::smart,
                   FluxWeights::report,
                   [](const Vec3& n, const Vec3&) { return 1.0 - std::acos(n.z) / pi; }},
        Reflection{"SunApprox", 1, 0, 0, ReflectionMode::approx, ReflectionMode::off,
                   FluxWeights::viewFactor, [](const Vec3&, const Vec3&) { return 0.25; }},
        Reflection{"UpApprox", 0, 1, 0, ReflectionMode::off, ReflectionMode::approx,
                   FluxWeights::viewFactor, [](const Vec3&, const Vec3&) { return 0.5; }},
        Reflection{"AllOff", 1, 1, 1, ReflectionMode::off, ReflectionMode::off,
                   FluxWeights::viewFactor, [](const Vec3&, const Vec3&) { return 0.0; }}),
    [](const auto& row) { return std::string(row.param.name); });

// A horizontal plate seen from above or below, with the sun above or below its plane.
struct PlateCase {
    const char* name;
    bool frontUp; ///< the front side of the plate points up
    bool seenFromAbove;
    double sunElevation_deg;
    double sun, up, down; ///< expected factors
};
void PrintTo(const PlateCase& row, std::ostream* out) {
    *out << row.name;
}

class TwoSidedPlate : public testing::TestWithParam<PlateCase> {};

TEST_P(TwoSidedPlate, IsLitOnTheSideThatIsSeen) {
    const PlateCase& c = GetParam();
    const Vec3 x{1, 0, 0}, y{0, 1, 0};
    InteractiveRenderer& irsg = generator();
    irsg.scene.entities = {
        entityOf(modelOf(plateMesh({0, 0, 0}, c.frontUp ? x : y, c.frontUp ? y : x, one)),
                 greyDatabase(0.4, 300.0))};
    const double elevation = radians(c.seenFromAbove ? 60.0 : -60.0);
    auto seen = [&](double sun, double up, double down) {
        ConstantAtmosphere air;
        air.sunValue = sun;
        air.upValue = up;
        air.downValue = down;
        irsg.scene.environment = environmentOf(air, {0.0, radians(c.sunElevation_deg)});
        look(irsg, {.range_m = 50.0, .elevation_rad = elevation, .fieldOfView_rad = 0.01});
        return static_cast<double>(centreOf(irsg.imageWithReport().image));
    };
    const double thermal = 0.4 * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 300.0);
    const double full = 0.6 / pi * 2.0;
    EXPECT_NEAR(seen(0, 0, 0), thermal, 1e-5 * thermal) << "thermal is equal on both sides";
    EXPECT_NEAR(seen(1, 0, 0) - thermal, c.sun * full, 1e-6) << "sun";
    EXPECT_NEAR(seen(0, 1, 0) - thermal, c.up * full, 1e-6) << "upward flux";
    EXPECT_NEAR(seen(0, 0, 1) - thermal, c.down * full, 1e-6) << "downward flux";
}

const double sin30 = 0.5;
INSTANTIATE_TEST_SUITE_P(
    AllCases, TwoSidedPlate,
    testing::Values(PlateCase{"FrontUpSeenFromAboveSunUp", true, true, 30, sin30, 0, 1},
                    PlateCase{"FrontUpSeenFromBelowSunUp", true, false, 30, 0, 1, 0},
                    PlateCase{"FrontDownSeenFromAboveSunUp", false, true, 30, sin30, 0, 1},
                    PlateCase{"FrontDownSeenFromBelowSunUp", false, false, 30, 0, 1, 0},
                    PlateCase{"FrontUpSeenFromAboveSunDown", true, true, -30, 0, 0, 1},
                    PlateCase{"FrontUpSeenFromBelowSunDown", true, false, -30, 0, 1, 0},
                    PlateCase{"FrontDownSeenFromBelowSunDown", false, false, -30, 0, 1, 0},
                    PlateCase{"SunInTheZenith", true, true, 90, 1, 0, 1},
                    PlateCase{"SunOnTheHorizon", true, true, 0, 0, 0, 1}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Surface, ThatTransmitsEverythingIsExactlyTheBackground) {
    ConstantAtmosphere air;
    air.backgroundValue = 0.731;
    air.pathRadianceValue = 0.2;
    air.sunValue = air.upValue = air.downValue = 1.0;
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = environmentOf(air);
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 16, 32, one)), greyDatabase(0.0, 300.0, 0.0, 1.0))};
    look(irsg, {.range_m = 60.0});
    const RenderedImage rendered = irsg.imageWithReport();
    for (float value : rendered.image.primary().values) {
        EXPECT_EQ(value, static_cast<float>(rendered.report.background_W_m2_sr));
    }
    EXPECT_NEAR(rendered.report.background_W_m2_sr, 2.0 * 0.731, 1e-12);
    EXPECT_EQ(rendered.report.all.contrastIntensity_W_sr, 0.0);
}

TEST(Surface, ThatIsBlackAndColdShowsExactlyThePathRadiance) {
    ConstantAtmosphere air;
    air.pathRadianceValue = 0.2;
    air.transmittanceValue = 0.3;
    air.backgroundValue = 5.0;
    air.sunValue = air.upValue = air.downValue = 1.0;
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = environmentOf(air);
    RenderSettings settings = RenderSettings::direct();
    settings.sun = settings.ambientReflection = ReflectionMode::off;
    irsg.scene.settings = settings;
    irsg.scene.entities = {entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), greyDatabase(1.0, 1.0))};
    look(irsg, {.range_m = 60.0});
    EXPECT_EQ(centreOf(irsg.imageWithReport().image), static_cast<float>(0.4));
}

TEST(Surface, IsInvisibleInAnIsothermalEnclosure) {
    // Everything at 300 K: a Lambertian grey body radiates and reflects as the walls do.
    const Band band = Band::topHat(8.0, 8.0001);
    const double black = bandRadiance_W_m2_sr(band, 300.0) / band.area_um();
    ConstantAtmosphere air;
    air.transmittanceValue = 0.6;
    air.pathRadianceValue = 0.4 * black;
    air.backgroundValue = black;
    air.upValue = air.downValue = pi * black;
    InteractiveRenderer& irsg = generator();
    irsg.scene.environment = environmentOf(air, {0.0, -0.5});
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 64, 128, one)), greyDatabase(0.55, 300.0, 0.0, 0.0))};
    look(irsg, {.range_m = 60.0, .band = band});
    const RadianceImage image = irsg.imageWithReport().image;
    for (float value : image.primary().values) {
        EXPECT_NEAR(static_cast<double>(value) / (black * band.area_um()), 1.0, 2e-7);
    }
}

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereScatteringLut.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/core/Errors.h"
#include "irsg/image/ImageIntensity.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scene/scattering/SceneScattering.h"
#include "tests/scattering/MtfBytes.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;
using testing::Contains;
using testing::HasSubstr;

namespace {

const IrCodes one{1, 1};

/// exp(tau q(f)), q falling from 0.9 to 0 about a width, for a field of view.
std::filesystem::path databaseFile(double fieldOfView_rad, double width_per_rad = 200.0) {
    const auto file =
        std::filesystem::temp_directory_path() /
        ("haze-" + std::to_string(fieldOfView_rad) + "-" + std::to_string(width_per_rad) + ".mtf");
    std::vector<double> frequencies{0.0};
    for (int i = 0; i < 120; ++i) {
        frequencies.push_back(1e-2 * width_per_rad * std::pow(1e4, i / 119.0));
    }
    const std::vector<double> depths{0.5, 2.0, 6.0};
    std::string bytes;
    const auto put = [&](double value) {
        bytes.resize(bytes.size() + 8);
        putDouble(bytes, bytes.size() - 8, value);
    };
    for (const double value : {fieldOfView_rad, 0.0, 0.0, 0.0}) {
        put(value);
    }
    bytes.resize(40);
    putInt(bytes, 32, static_cast<std::int32_t>(depths.size()));
    putInt(bytes, 36, static_cast<std::int32_t>(frequencies.size()));
    for (const double frequency : frequencies) {
        put(frequency);
    }
    for (const double depth : depths) {
        put(depth);
        for (const double frequency : frequencies) {
            put(std::exp(depth * 0.9 / (1.0 + std::pow(frequency / width_per_rad, 2))));
        }
    }
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
}

/// Air of one temperature, before ground of the same: all that is seen is a black body.
Environment isothermal(double temperature_K, double extinction_per_m) {
    BeerLambertParameters parameters;
    parameters.extinction_per_m = Spectrum::constant(extinction_per_m);
    parameters.airTemperature_K = parameters.groundTemperature_K = temperature_K;
    parameters.solarIrradiance_W_m2_um = Spectrum::constant(0.0);
    parameters.downwardFlux_W_m2_um = Spectrum::constant(0.0);
    parameters.upwardFlux_W_m2_um = Spectrum::constant(0.0);
    Environment environment;
    environment.add(std::make_shared<BeerLambert>(parameters));
    return environment;
}

Environment darkness() {
    return environmentOf(ConstantAtmosphere{});
}

Environment with(Environment environment, const std::filesystem::path& database,
                 double coefficient_per_m) {
    environment.add(std::make_shared<AtmosphereScatteringLut>(database, coefficient_per_m));
    return environment;
}

RenderSettings scattering(bool isOn = true) {
    RenderSettings settings = RenderSettings::direct();
    settings.scattering = isOn;
    return settings;
}

class ScatteringScene : public testing::Test {
  protected:
    void SetUp() override {
        if (!hasScattering()) {
            GTEST_SKIP() << whyNoScattering();
        }
    }

    InteractiveRenderer& sphere(double temperature_K, const Environment& environment,
                                const View& view, const RenderSettings& settings = scattering()) {
        irsg.scene.environment = environment;
        irsg.scene.settings = settings;
        irsg.scene.entities = {
            entityOf(modelOf(sphereMesh(1.0, 32, 64, one)), greyDatabase(1.0, temperature_K))};
        look(irsg, view);
        return irsg;
    }

    InteractiveRenderer irsg{RenderSettings::direct()};
};

double sumOf(const RadianceImage& image) {
    double sum = 0.0;
    for (const float value : image.primary().values) {
        sum += static_cast<double>(value);
    }
    return sum;
}

double number(const RadianceImage& image, const std::string& key) {
    return std::stod(image.attributes.at(key));
}

} // namespace

TEST_F(ScatteringScene, LeavesAnObjectInvisibleThatShinesAsItsBackground) {
    // Half of its light and that of the air before it are exactly what lies behind.
    ConstantAtmosphere air;
    air.transmittanceValue = 0.5;
    air.pathRadianceValue = 0.25;
    RenderSettings settings = scattering();
    settings.background = BackgroundMode::constant;
    settings.background_W_m2_sr =
        0.5 * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 300.0) + 0.25 * 2.0;
    for (const double coefficient_per_m : {0.001, 0.005, 0.02, 0.04, 0.06}) {
        for (const double width_per_rad : {20.0, 200.0}) {
            const Environment hazy =
                with(environmentOf(air), databaseFile(0.05, width_per_rad), coefficient_per_m);
            const RenderedImage seen = sphere(300.0, hazy, {}, settings).imageWithReport();
            const auto [least, most] = std::ranges::minmax(seen.image.primary().values);
            EXPECT_GT(number(seen.image, "scattering.mesh.gain"), 1.05);
            EXPECT_LE((most - least) / most, 1e-5f) << coefficient_per_m;
        }
    }
}

TEST_F(ScatteringScene, GivesItsLightTheGainOfTheMtfLessTheReportedCut) {
    // A field of view that ends inside the frame.
    const Environment air = with(darkness(), databaseFile(0.012), 0.02);
    const View view{.width_px = 96, .height_px = 80};
    const RadianceImage clear = sphere(400.0, air, view, scattering(false)).imageWithReport().image;
    const RadianceImage hazy = sphere(400.0, air, view).imageWithReport().image;
    EXPECT_NEAR(number(hazy, "scattering.mesh.optical_depth"), 2.0, 1e-6);
    const double gain = number(hazy, "scattering.mesh.gain");
    EXPECT_NEAR(gain, std::exp(1.8), 1e-6);
    const double kept = gain * (1.0 - number(hazy, "scattering.mesh.cut"));
    EXPECT_NEAR(sumOf(hazy) / sumOf(clear) / kept, 1.0, 2e-6);
}

TEST_F(ScatteringScene, ReachesPointSourcesToo) {
    const Environment air = with(darkness(), databaseFile(0.012), 2e-4);
    const View view{.range_m = 1e4, .width_px = 65, .height_px = 65, .fieldOfView_rad = 1.0};
    const RadianceImage seen = sphere(400.0, air, view).imageWithReport().image;
    EXPECT_GT(seen.at(32, 32), 0.0f);
    // Its haze is narrower than a pixel here; with finer ones it is seen around the point.
    const View fine{.range_m = 1e6, .width_px = 65, .height_px = 65, .fieldOfView_rad = 0.012};
    const Environment thin = with(darkness(), databaseFile(0.012), 2e-6);
    const RadianceImage spread = sphere(400.0, thin, fine).imageWithReport().image;
    EXPECT_GT(spread.at(40, 32), 0.0f);
    EXPECT_NEAR(spread.at(40, 32) / spread.at(24, 32), 1.0f, 1e-4f);
    EXPECT_NEAR(spread.at(32 + 5, 32) / spread.at(32 + 3, 32 + 4), 1.0f, 0.01f);
}

TEST_F(ScatteringScene, IsTheSameHazeWithEveryAntialiasing) {
    const Environment air = with(darkness(), databaseFile(0.2, 20.0), 0.02);
    const View view{.width_px = 64, .height_px = 64};
    const RadianceImage aligned = sphere(400.0, air, view).imageWithReport().image;
    RenderSettings settings = scattering();
    for (const int perAxis : {1, 4}) {
        settings.tileSide_samples = 0;
        settings.samplesPerAxis = perAxis;
        const RadianceImage seen = sphere(400.0, air, view, settings).imageWithReport().image;
        EXPECT_NEAR(seen.at(4, 32) / aligned.at(4, 32), 1.0f, 0.02f) << perAxis;
    }
    settings = scattering();
    settings.tileStrategy = TileStrategy::published;
    const RadianceImage published = sphere(400.0, air, view, settings).imageWithReport().image;
    EXPECT_NEAR(published.at(4, 32) / aligned.at(4, 32), 1.0f, 0.02f);
}

TEST_F(ScatteringScene, SpreadsEveryObjectByItsOwnPath) {
    irsg.scene.environment = with(darkness(), databaseFile(0.05), 0.01);
    irsg.scene.settings = scattering();
    Entity near = entityOf(modelOf(sphereMesh(1.0, 16, 32, one)), greyDatabase(1.0, 350.0));
    Entity far = near;
    near.name = "near";
    far.name = "far";
    irsg.scene.entities = {near, far};
    look(irsg, {});
    const Viewpoint eye = irsg.view.viewpoint;
    const Vec3 back = eye.forward();
    irsg.scene.entities[1].pose = {{back.x * 200.0 + eye.right.x * 6.0,
                                    back.y * 200.0 + eye.right.y * 6.0,
                                    standingAltitude_m + eye.right.z * 6.0},
                                   {}};
    const RadianceImage image = irsg.imageWithReport().image;
    EXPECT_NEAR(number(image, "scattering.near.optical_depth"), 1.0, 1e-6);
    EXPECT_NEAR(number(image, "scattering.far.optical_depth"), 3.0, 0.01);
}

TEST_F(ScatteringScene, SaysWhenHazeFromOutsideTheFrameIsMissing) {
    irsg.scene.environment = with(darkness(), databaseFile(0.05), 0.01);
    irsg.scene.settings = scattering();
    Entity inner = entityOf(modelOf(sphereMesh(1.0, 16, 32, one)), greyDatabase(1.0, 350.0));
    Entity other = inner;
    inner.name = "inside";
    other.name = "other";
    irsg.scene.entities = {inner, other};
    look(irsg, {});
    const Viewpoint eye = irsg.view.viewpoint;
    const double halfFrame_m = 100.0 * std::tan(0.5 * irsg.view.sensor.horizontalFieldOfView_rad);
    struct Row {
        double right; ///< in halves of the frame
        bool isTold;
    };
    for (const Row row : {Row{0.3, false}, Row{1.0, true}, Row{1.8, true}, Row{1e3, false}}) {
        const double right_m = row.right * halfFrame_m;
        irsg.scene.entities[1].pose = {{eye.right.x * right_m, eye.right.y * right_m,
                                        standingAltitude_m + eye.right.z * right_m},
                                       {}};
        const auto warnings = irsg.imageWithReport().report.warnings;
        EXPECT_EQ(std::ranges::any_of(warnings,
                                      [](const std::string& warning) {
                                          return warning.find("'other' reaches beyond the frame") !=
                                                 std::string::npos;
                                      }),
                  row.isTold)
            << row.right;
        EXPECT_THAT(warnings, testing::Not(Contains(HasSubstr("'inside' reaches"))));
    }
}

TEST_F(ScatteringScene, FollowsAnUnevenBackground) {
    // Haze hides what is behind it by its own coverage: an isothermal scene seen over the horizon.
    RenderSettings settings = scattering();
    settings.backgroundRows = 8;
    const Environment air = with(isothermal(300.0, 0.005), databaseFile(0.02), 0.005);
    const RadianceImage seen =
        sphere(300.0, air, {.elevation_rad = 0.01}, settings).imageWithReport().image;
    const auto [least, most] = std::ranges::minmax(seen.primary().values);
    EXPECT_LE((most - least) / most, 1e-5f);
}

TEST_F(ScatteringScene, GivesEverySumTheHazeOfThePicture) {
    ConstantAtmosphere air;
    air.transmittanceValue = 0.6;
    air.pathRadianceValue = 0.1;
    air.backgroundValue = 0.7;
    // Large, and not in the middle, so that a part of the haze falls beside the frame.
    sphere(340.0, with(environmentOf(air), databaseFile(0.2, 60.0), 0.01),
           {.width_px = 96, .height_px = 80, .fieldOfView_rad = 0.06});
    irsg.scene.entities.front().pose.position_m.x += 1.2;
    const RenderedImage seen = irsg.imageWithReport();
    const ObjectRadiometry& printed = seen.report.all;
    const double small = 1e-5 * printed.intensity_W_sr;
    EXPECT_NEAR(contrastIntensity_W_sr(seen.image, seen.image.primary()).value(),
                printed.contrastIntensity_W_sr, small);
    const auto isPrinted = [&](const ObjectRadiometry& sums) {
        EXPECT_NEAR(sums.intensity_W_sr, printed.intensity_W_sr, small);
        EXPECT_NEAR(sums.contrastIntensity_W_sr, printed.contrastIntensity_W_sr, small);
        EXPECT_NEAR(sums.irradiance_W_m2, printed.irradiance_W_m2, 1e-5 * printed.irradiance_W_m2);
    };
    const RenderReport swept = irsg.measure();
    isPrinted(swept.all);
    isPrinted(swept.objects.front());
    isPrinted(irsg.measure({Band::topHat(8.0, 12.0), irsg.view.sensor.band}).back().all);
    isPrinted(irsg.render(Outputs::reports().alongRange()).reports.front().all);
    ScaledValues nominal;
    irsg.scaledView({{0, ScalingKind::temperature, 1, 0.9, 1.1}})
        ->evaluate(std::vector<double>{1.0}, nominal);
    EXPECT_NEAR(nominal.contrastIntensity.front(), printed.contrastIntensity_W_sr, small);
    // Of a spectrum every number has the haze of the band.
    const std::vector<double> at_per_cm{2200.0, 2900.0};
    const IntensitySpectrum hazy = irsg.measureSpectrum(at_per_cm);
    irsg.scene.settings.scattering = false;
    const RenderReport direct = irsg.measure();
    const IntensitySpectrum clear = irsg.measureSpectrum(at_per_cm);
    const double gain = printed.intensity_W_sr / direct.all.intensity_W_sr;
    EXPECT_GT(gain, 1.3);
    EXPECT_LT(gain, std::exp(0.9) - 0.005);
    for (std::size_t i = 0; i < at_per_cm.size(); ++i) {
        EXPECT_NEAR(hazy.intensity_W_sr_um[i] / clear.intensity_W_sr_um[i], gain, 1e-6);
    }
}

TEST_F(ScatteringScene, GivesSeveralObjectsEachTheHazeOfItsPath) {
    sphere(400.0, with(darkness(), databaseFile(0.02), 0.01), {.width_px = 96, .height_px = 96});
    irsg.scene.entities.push_back(irsg.scene.entities.front());
    irsg.scene.entities.back().pose.position_m.y += 60.0;
    irsg.scene.entities.back().pose.position_m.x += 1.0;
    const RenderedImage seen = irsg.imageWithReport();
    double shown_W_sr_m2 = 0.0; // by pixels, of objects at different ranges
    const RenderReport swept = irsg.measure();
    for (std::size_t e = 0; e < 2; ++e) {
        const ObjectRadiometry& object = seen.report.objects[e];
        shown_W_sr_m2 += object.contrastIntensity_W_sr / std::pow(object.range_m, 2);
        EXPECT_NEAR(swept.objects[e].intensity_W_sr / object.intensity_W_sr, 1.0, 1e-5);
    }
    const double pixels_W_sr = contrastIntensity_W_sr(seen.image, seen.image.primary()).value();
    EXPECT_NEAR(pixels_W_sr / std::pow(seen.report.objects.front().range_m, 2) / shown_W_sr_m2, 1.0,
                1e-5);
    irsg.scene.settings.scattering = false;
    const RenderReport direct = irsg.measure();
    const auto gainOf = [&](std::size_t e) {
        return swept.objects[e].intensity_W_sr / direct.objects[e].intensity_W_sr;
    };
    EXPECT_GT(std::abs(gainOf(1) / gainOf(0) - 1.0), 0.05);
}

TEST_F(ScatteringScene, SaysWhenItTakesTheOpticalDepthFromTheTransmittance) {
    class Quiet : public ConstantAtmosphere {
      public:
        bool supports(AtmosphereProperty property) const override {
            return property != AtmosphereProperty::scatteringOpticalDepth;
        }
    };
    Quiet air;
    air.transmittanceValue = std::exp(-1.5);
    Environment environment;
    environment.add(std::make_shared<Quiet>(air));
    const RenderedImage seen =
        sphere(400.0, with(environment, databaseFile(0.05), 0.0), {}).imageWithReport();
    EXPECT_NEAR(number(seen.image, "scattering.mesh.optical_depth"), 1.5, 1e-9);
    EXPECT_THAT(seen.report.warnings, Contains(HasSubstr("eq. 10")));
}

TEST_F(ScatteringScene, SaysWhenNothingScatters) {
    const RenderedImage seen =
        sphere(400.0, with(isothermal(290.0, 0.005), databaseFile(0.05), 0.0), {})
            .imageWithReport();
    EXPECT_THAT(seen.report.warnings, Contains(HasSubstr("nothing scatters")));
    EXPECT_THAT(seen.report.warnings, Contains(HasSubstr("haze that falls into the frame")));
}

TEST_F(ScatteringScene, SaysWhenTheDatabaseDoesNotFitTheSensor) {
    const RenderedImage seen =
        sphere(400.0, with(darkness(), databaseFile(0.012), 0.02), {}).imageWithReport();
    EXPECT_THAT(seen.report.warnings, Contains(HasSubstr("is too small for that of the sensor")));
}

TEST_F(ScatteringScene, RefusesWhatTheDatabaseDoesNotReach) {
    try {
        sphere(400.0, with(darkness(), databaseFile(0.05), 0.1), {}).imageWithReport();
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the path to 'mesh'"));
        EXPECT_THAT(error.what(), HasSubstr("at most the 6"));
    }
}

TEST_F(ScatteringScene, RefusesToScatterWithoutADatabase) {
    try {
        sphere(400.0, darkness(), {}).imageWithReport();
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("an AtmosphereScatteringLUT or an MTF database"));
    }
}

TEST(ScatteringWithoutItsFloor, IsRefusedByName) {
    if (hasScattering()) {
        GTEST_SKIP() << "there is scattering";
    }
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = with(darkness(), "haze.mtf", 0.01);
    irsg.scene.settings = scattering();
    irsg.scene.entities = {
        entityOf(modelOf(sphereMesh(1.0, 8, 16, one)), greyDatabase(1.0, 300.0))};
    look(irsg, {});
    try {
        irsg.imageWithReport();
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("irsg/scattering"));
    }
    EXPECT_THROW(SceneScattering().check("haze.mtf"), InputError);
}

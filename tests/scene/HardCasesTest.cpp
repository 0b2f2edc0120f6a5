#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/HeldByContext.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

const IrCodes one{1, 1};

Environment darkness() {
    return environmentOf(ConstantAtmosphere{});
}

double total(const RadianceImage& image) {
    double sum = 0.0;
    for (float value : image.primary().values) {
        sum += static_cast<double>(value);
    }
    return sum;
}

bool allFinite(const RadianceImage& image) {
    for (float value : image.primary().values) {
        if (!std::isfinite(value)) {
            return false;
        }
    }
    return true;
}

/// A sphere in the dark, with settings that a test changes.
struct Stage {
    InteractiveRenderer irsg{RenderSettings::direct()};
    std::shared_ptr<const Model> sphere = modelOf(sphereMesh(1.0, 32, 64, one));

    Stage() {
        irsg.scene.environment = darkness();
        irsg.scene.entities = {entityOf(sphere, greyDatabase(0.9, 320.0))};
        look(irsg, {});
    }
};

} // namespace

TEST(FloatTargets, KeepRadiancesFarAboveOneAndBelowZero) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = darkness();
    const auto model = modelOf(plateMesh({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, one));
    for (double level : {1e6, -3.5, 123.25}) {
        SignatureDatabase database = greyDatabase(1.0, 300.0);
        TemperatureEntry& entry = database.temperatures[1];
        entry.mode = EmissionMode::userSpectrum;
        entry.userSpectrum = "flat";
        database.spectra["flat"] = {
            "flat",
            0.0,
            "W m-2 sr-1 um-1",
            "",
            {{"c", Spectrum({1.0, 10.0}, {level / 2.0, level / 2.0}, Spectrum::Outside::zero)}}};
        irsg.scene.entities = {entityOf(model, database)};
        look(irsg, {.range_m = 50.0, .fieldOfView_rad = 0.01});
        const RenderedImage rendered = irsg.imageWithReport();
        EXPECT_EQ(rendered.image.at(32, 32), static_cast<float>(level));
    }
}

TEST(Drawing, ShowsAChangedMaterialInTheVeryNextFrame) {
    Stage stage;
    const double before = total(stage.irsg.imageWithReport().image);
    stage.irsg.scene.entities[0].database =
        std::make_shared<const SignatureDatabase>(greyDatabase(0.45, 320.0));
    EXPECT_NEAR(total(stage.irsg.imageWithReport().image) / before, 0.5, 1e-6);
}

TEST(Drawing, IsBitEqualWhenRepeated) {
    Stage stage;
    const RadianceImage first = stage.irsg.imageWithReport().image;
    look(stage.irsg, {.azimuth_rad = 1.0});
    stage.irsg.imageWithReport();
    look(stage.irsg, {});
    EXPECT_EQ(stage.irsg.imageWithReport().image.primary().values, first.primary().values);
}

TEST(Drawing, PutsTheSkyAtTheTop) {
    // A plate above the axis of the camera is seen in the upper half of the picture, one to
    // starboard of a target seen from its nose in the left half.
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = darkness();
    const auto model = modelOf(plateMesh({0.5, 0, 0.5}, {0.3, 0, 0}, {0, 0, 0.3}, one));
    irsg.scene.entities = {entityOf(model, greyDatabase(1.0, 300.0))};
    look(irsg, {.range_m = 50.0});
    const RadianceImage image = irsg.imageWithReport().image;
    EXPECT_GT(image.at(16, 16), 0.0f);
    EXPECT_EQ(image.at(48, 16), 0.0f);
    EXPECT_EQ(image.at(16, 48), 0.0f);
    EXPECT_EQ(image.at(48, 48), 0.0f);
}

TEST(Drawing, TurnsWithTargetAndSensorTogether) {
    Stage stage;
    const auto box = modelOf(boxMesh({1, 2, 0.5}, std::vector<IrCodes>(6, one)));
    auto intensity = [&](double yaw_rad) {
        Entity entity = entityOf(box, greyDatabase(0.9, 320.0, 1.0));
        entity.pose.attitude.yaw_rad = yaw_rad;
        stage.irsg.scene.entities = {entity};
        look(stage.irsg, {.azimuth_rad = 0.6, .elevation_rad = 0.3, .fieldOfView_rad = 0.08});
        return stage.irsg.imageWithReport().report.all.intensity_W_sr;
    };
    for (double yaw : {0.5, 2.0, 4.0}) {
        EXPECT_NEAR(intensity(yaw) / intensity(0.0), 1.0, 1e-3) << yaw;
    }
}

TEST(Drawing, KeepsItsDigitsFarFromTheWorldsOrigin) {
    Stage stage;
    const double here = total(stage.irsg.imageWithReport().image);
    Pose far{{6.4e6, -6.4e6, standingAltitude_m}, {}};
    stage.irsg.scene.entities[0].pose = far;
    look(stage.irsg, {});
    EXPECT_NEAR(total(stage.irsg.imageWithReport().image) / here, 1.0, 1e-5);
}

TEST(Drawing, KeepsItsDigitsAtTenThousandKilometres) {
    Stage stage;
    for (double range_m : {1e3, 1e5, 1e7}) {
        RenderSettings settings = RenderSettings::direct();
        settings.tileSide_samples = 0;
        settings.samplesPerAxis = 4;
        stage.irsg.scene.settings = settings;
        look(stage.irsg, {.range_m = range_m, .fieldOfView_rad = 2.4 / range_m});
        const double expected = 0.9 * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 320.0) * pi;
        EXPECT_NEAR(stage.irsg.imageWithReport().report.all.intensity_W_sr / expected, 1.0, 5e-3)
            << range_m;
    }
}

TEST(Drawing, WorksFromInsideAnObjectAndAtRangeZero) {
    Stage stage;
    for (double range_m : {0.5, 1e-9}) {
        look(stage.irsg, {.range_m = range_m, .fieldOfView_rad = 1.0});
        const RadianceImage image = stage.irsg.imageWithReport().image;
        const double expected = 0.9 * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 320.0);
        EXPECT_NEAR(static_cast<double>(image.at(32, 32)) / expected, 1.0, 1e-5) << range_m;
    }
}

TEST(Drawing, HandlesEveryShapeOfImage) {
    Stage stage;
    const int sizes[][2] = {{1, 1}, {1, 37}, {37, 1}, {2, 2}, {53, 47}, {640, 3}};
    for (const auto& size : sizes) {
        look(stage.irsg, {.width_px = size[0], .height_px = size[1], .fieldOfView_rad = 0.02});
        const RadianceImage image = stage.irsg.imageWithReport().image;
        EXPECT_EQ(image.width(), size[0]);
        EXPECT_EQ(image.height(), size[1]);
        EXPECT_TRUE(allFinite(image));
        EXPECT_GT(image.at(size[0] / 2, size[1] / 2), 0.0f);
    }
}

TEST(Drawing, GivesTheSamePictureInOneTileAndInMany) {
    // 16 samples an axis at 300 pixels are 4800 samples: several drawings. One sample an axis in
    // the middle of each of those is one drawing of 4800 pixels, cut likewise; compare with 1 of
    // 300.
    Stage stage;
    RenderSettings settings = RenderSettings::direct();
    auto intensityWith = [&](int samples) {
        settings.tileSide_samples = 0;
        settings.samplesPerAxis = samples;
        stage.irsg.scene.settings = settings;
        look(stage.irsg, {.width_px = 300, .height_px = 300, .fieldOfView_rad = 0.022});
        return stage.irsg.imageWithReport().report.all.intensity_W_sr;
    };
    EXPECT_NEAR(intensityWith(16) / intensityWith(4), 1.0, 2e-4);
}

TEST(Drawing, SeesNothingOfAnObjectBehindTheCameraOrOutsideTheFrame) {
    Stage stage;
    Viewpoint away = stage.irsg.view.viewpoint;
    away.backward = away.backward * -1.0;
    away.right = away.right * -1.0;
    stage.irsg.view.viewpoint = away;
    EXPECT_EQ(total(stage.irsg.imageWithReport().image), 0.0);

    look(stage.irsg, {});
    stage.irsg.scene.entities[0].pose = {{50.0, 0.0, standingAltitude_m}, {}};
    EXPECT_EQ(total(stage.irsg.imageWithReport().image), 0.0);
    EXPECT_EQ(stage.irsg.measure().all.intensity_W_sr, 0.0);
}

TEST(Drawing, DropsAnObjectOfAThousandthOfAPixelWithoutHarm) {
    Stage stage;
    look(stage.irsg, {.range_m = 1e6, .fieldOfView_rad = 0.128});
    const RenderedImage rendered = stage.irsg.imageWithReport();
    EXPECT_TRUE(allFinite(rendered.image));
    EXPECT_LE(rendered.report.all.coveredPixels, 1.0);
}

TEST(Drawing, SurvivesDegenerateTrianglesAndMissingNormals) {
    Triangles mesh = sphereMesh(1.0, 16, 32, one);
    mesh.push_back(
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, one, false});
    mesh.push_back(
        {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, one, false});
    Stage stage;
    stage.irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(0.5, 320.0, 1.0))};
    look(stage.irsg, {});
    EXPECT_TRUE(allFinite(stage.irsg.imageWithReport().image));
}

TEST(Drawing, LeavesNothingBehindAfterAHundredAnalyses) {
    auto threads = [] {
        int count = 0;
        for ([[maybe_unused]] const auto& entry :
             std::filesystem::directory_iterator("/proc/self/task")) {
            ++count;
        }
        return count;
    };
    auto files = [] {
        int count = 0;
        for ([[maybe_unused]] const auto& entry :
             std::filesystem::directory_iterator("/proc/self/fd")) {
            ++count;
        }
        return count;
    };
    Stage keepsTheContext;
    keepsTheContext.irsg.imageWithReport();
    for (int i = 0; i < 5; ++i) {
        Stage().irsg.imageWithReport();
    }
    const int threadsBefore = threads(), filesBefore = files();
    const HeldByContext before = heldByContext();
    EXPECT_GT(before.textures, 0);
    EXPECT_GT(before.buffers, 0);
    EXPECT_GT(before.vertexArrays, 0);
    for (int i = 0; i < 100; ++i) {
        Stage stage;
        stage.irsg.imageWithReport();
    }
    const HeldByContext after = heldByContext();
    EXPECT_EQ(threads(), threadsBefore);
    EXPECT_EQ(files(), filesBefore);
    EXPECT_LE(after.textures, before.textures);
    EXPECT_LE(after.buffers, before.buffers);
    EXPECT_LE(after.framebuffers, before.framebuffers);
    EXPECT_LE(after.vertexArrays, before.vertexArrays);
}

TEST(Layers, BeyondTheLimitAreCountedAndReported) {
    Triangles mesh;
    for (int i = 0; i < 6; ++i) {
        const Triangles plate = plateMesh({0, i * 0.1, 0}, {1, 0, 0}, {0, 0, 1}, one);
        mesh.insert(mesh.end(), plate.begin(), plate.end());
    }
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = darkness();
    RenderSettings settings = RenderSettings::direct();
    settings.tileSide_samples = 0;
    settings.samplesPerAxis = 1;
    irsg.scene.entities = {entityOf(modelOf(mesh), greyDatabase(0.3, 320.0, 0.0, 0.7))};
    const double one_W_m2_sr = 0.3 * bandRadiance_W_m2_sr(Band::topHat(3.0, 5.0), 320.0);
    for (int limit : {3, 6, 64}) {
        settings.maximumLayers = limit;
        irsg.scene.settings = settings;
        look(irsg, {.range_m = 50.0, .fieldOfView_rad = 0.01});
        const RenderedImage rendered = irsg.imageWithReport();
        const int drawn = std::min(limit, 6);
        EXPECT_NEAR(static_cast<double>(rendered.image.at(32, 32)) / one_W_m2_sr,
                    (1.0 - std::pow(0.7, drawn)) / 0.3, 1e-5);
        EXPECT_EQ(rendered.report.layersLeftOver, limit < 6 ? 64 * 64 : 0);
        EXPECT_EQ(irsg.measure().layersLeftOver, rendered.report.layersLeftOver);
    }
}

TEST(Layers, OfCoplanarGlassDoNotDependOnTheOrderInTheFile) {
    Triangles forward, backward;
    for (int i = 0; i < 4; ++i) {
        const Triangles plate =
            plateMesh({0.2 * i, 0.3 * i, 0}, {1, 0, 0}, {0, 0, 1}, {1 + i % 2, 1 + i % 2});
        forward = joined(forward, plate);
        backward = joined(plate, backward);
    }
    SignatureDatabase database = greyDatabase(0.3, 320.0, 0.0, 0.7);
    database.temperatures[2] = fixedTemperature(350.0);
    database.materials[2] = greyMaterial(0.5, 0.4);
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = darkness();
    irsg.scene.entities = {entityOf(modelOf(forward), database)};
    look(irsg, {});
    const RadianceImage a = irsg.imageWithReport().image;
    irsg.scene.entities = {entityOf(modelOf(backward), database)};
    look(irsg, {});
    EXPECT_EQ(irsg.imageWithReport().image.primary().values, a.primary().values);
}

struct Refusal {
    const char* name;
    std::function<void(Stage&)> spoil;
    const char* position;
    const char* expected;
};
void PrintTo(const Refusal& row, std::ostream* out) {
    *out << row.name;
}

class SceneChecks : public testing::TestWithParam<Refusal> {};

TEST_P(SceneChecks, NameWhatIsWrong) {
    Stage stage;
    GetParam().spoil(stage);
    try {
        stage.irsg.imageWithReport();
        FAIL() << "must be refused";
    } catch (const InputError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find(GetParam().position), std::string::npos) << what;
        EXPECT_NE(what.find(GetParam().expected), std::string::npos) << what;
    }
}

void replaceDatabase(Stage& stage, const SignatureDatabase& database) {
    stage.irsg.scene.entities[0].database = std::make_shared<const SignatureDatabase>(database);
}

INSTANTIATE_TEST_SUITE_P(
    BadScenes, SceneChecks,
    testing::Values(
        Refusal{"SensorBelowGround",
                [](Stage& s) { look(s.irsg, {.range_m = 5000.0, .elevation_rad = -1.0}); },
                "altitude", "at least 0 m"},
        Refusal{"TargetBelowGround",
                [](Stage& s) {
                    s.irsg.scene.entities[0].pose = {{0, 0, -10}, {}};
                },
                "altitude", "at least 0 m"},
        Refusal{"TemperatureWithoutEntry",
                [](Stage& s) {
                    SignatureDatabase d = greyDatabase(0.9, 300.0);
                    d.temperatures.clear();
                    replaceDatabase(s, d);
                },
                "temperature index 1", "an entry in the signature database"},
        Refusal{"MaterialWithoutEntry",
                [](Stage& s) {
                    SignatureDatabase d = greyDatabase(0.9, 300.0);
                    d.materials.clear();
                    replaceDatabase(s, d);
                },
                "material index 1", "an entry in the signature database"},
        Refusal{"SpectrumShortOfTheBand",
                [](Stage& s) {
                    SignatureDatabase d = greyDatabase(0.9, 300.0);
                    d.materials[1].emissivity = Spectrum({3.2, 5.0}, {0.9, 0.9});
                    replaceDatabase(s, d);
                },
                "emissivity", "covers the band"},
        Refusal{"NegativeTemperature",
                [](Stage& s) { replaceDatabase(s, greyDatabase(0.9, -4.0)); },
                "temperature index 1", "positive temperature"},
        Refusal{"NegativeTemperatureLaterInASweep",
                [](Stage& s) {
                    SignatureDatabase d = greyDatabase(0.9, 300.0);
                    d.temperatures[1].terms.time = LookupTable({0.0, 7200.0}, {0.0, -400.0});
                    replaceDatabase(s, d);
                    EntityState later = s.irsg.scene.entities[0].state;
                    later.time_s = 7200.0;
                    s.irsg.scene.entities[0].otherStates = {later};
                },
                "temperature index 1 (", "at time 7200 s"},
        Refusal{"TemperatureOfNoSurface",
                [](Stage& s) { replaceDatabase(s, greyDatabase(0.9, 2e5)); }, "temperature index 1",
                "at most 100000 K"},
        Refusal{"UnknownUserSpectrum",
                [](Stage& s) {
                    SignatureDatabase d = greyDatabase(0.9, 300.0);
                    d.temperatures[1].mode = EmissionMode::userSpectrum;
                    d.temperatures[1].userSpectrum = "plume";
                    replaceDatabase(s, d);
                },
                "spectrum 'plume'", "the name of a spectrum"},
        Refusal{"TooManySamples",
                [](Stage& s) {
                    RenderSettings settings = RenderSettings::direct();
                    settings.samplesPerAxis = 17;
                    s.irsg.scene.settings = settings;
                },
                "samples per axis", "1 to 16"},
        Refusal{"BackgroundNotANumber",
                [](Stage& s) {
                    RenderSettings settings = RenderSettings::direct();
                    settings.background = BackgroundMode::constant;
                    settings.background_W_m2_sr = std::nan("");
                    s.irsg.scene.settings = settings;
                },
                "background", "finite radiance"}),
    [](const auto& row) { return std::string(row.param.name); });

#include "smatcore/simulate/Simulation.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/image/ExrFile.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/SensorFile.h"
#include "irsg/signature/ScalingXml.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/simulate/FrameFiles.h"
#include "smatcore/simulate/ImagingSensorXml.h"
#include "smatcore/simulate/ScenarioFile.h"
#include "smatcore/support/TextFile.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/SmallSensor.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// Notes what it is told and gives each entity its power as intensity and its number as pixels.
class NotingSource : public test::GreySphere {
  public:
    irsg::RenderReport measure() override {
        irsg::RenderReport report;
        for (std::size_t i = 0; i < scene.entities.size(); ++i) {
            irsg::ObjectRadiometry object;
            object.name = scene.entities[i].name;
            object.range_m = irsg::length(scene.entities[i].pose.position_m - viewpoint.position_m);
            object.intensity_W_sr = scene.entities[i].state.power;
            object.coveredPixels = static_cast<double>(i + 1);
            report.objects.push_back(object);
        }
        report.providedBy = {"transmittance: closed form"};
        return report;
    }
    std::vector<irsg::RenderReport> reports(const irsg::Outputs& outputs) override {
        ++measured;
        return AnalyticSource::reports(outputs);
    }
    irsg::Rendered image(const irsg::Outputs& outputs) override {
        ++images;
        irsg::Rendered rendered;
        rendered.image = irsg::RadianceImage(scene.sensor.width_px, scene.sensor.height_px);
        irsg::RenderReport& report = rendered.reports.emplace_back();
        if (outputs.hasReports()) {
            report = measure();
        } else {
            report.warnings = {"a window of its own"};
        }
        return rendered;
    }

    int measured = 0, images = 0;
};

class ASimulation : public testing::Test {
  protected:
    void SetUp() override {
        writeTextFile(folder / "model.flt", "anything");
        irsg::SignatureDatabase database;
        database.temperatures[0].name = "skin";
        database.temperatures[0].terms = irsg::TemperatureTerms::ofAmbient();
        database.materials[0].name = "paint";
        irsg::saveSignatureFile(database, folder / "model.sigdb");
        writeTextFile(folder / "path.csv", "t,x,y,z,yaw,pitch,roll,power\n"
                                           "1,0,100,50,90,0,0,0.2\n3,20,100,50,90,0,0,0.6\n");
        scenario.file = folder / "s.json";
        scenario.dt_s = 1.0;
        scenario.end_s = 4.0;
        ScenarioEntity mover{.name = "mover",
                             .model = "model.flt",
                             .database = "model.sigdb",
                             .trajectory = "path.csv"};
        mover.timeOffset_s = 0.25;
        mover.mach = 0.8;
        ScenarioEntity tower{
            .name = "tower", .model = "model.flt", .database = "model.sigdb", .trajectory = {}};
        tower.pose = {{0, 0, 10}, {irsg::radians(90), 0, 0}};
        tower.power = 0.9;
        scenario.entities = {mover, tower};
        ScenarioSensor fixed{.name = "fixed", .offset = {{0, -100, 10}, {}}, .track = "mover"};
        ScenarioSensor deck{.name = "deck", .mount = MountKind::entity, .carrier = "tower"};
        deck.offset = {{0, 2, 1}, {0, 0, 0}};
        scenario.sensors = {fixed, deck};
    }

    LoadedScenario load(const Settings& overrides = {}) {
        SceneBuilder builder([this](const std::filesystem::path&, const irsg::ModelOptions&) {
            ++loads;
            return std::shared_ptr<const irsg::Model>();
        });
        return loadScenarioFiles(scenario, builder, overrides);
    }
    std::string refusal() {
        try {
            const LoadedScenario loaded = load();
            NotingSource source;
            SceneGenerator3D generator(loaded, source);
            const SimulationPlan plan = planSimulation(scenario, {});
            generator.check(plan.sensors, plan.times_s());
        } catch (const irsg::InputError& error) {
            return error.what();
        }
        return "accepted";
    }

    test::TemporaryFolder folder;
    Scenario scenario;
    int loads = 0;
};

TEST_F(ASimulation, PutsEverybodyWhereTheyAreAtEachTime) {
    const LoadedScenario loaded = load();
    NotingSource source;
    SceneGenerator3D generator(loaded, source);
    const SensorFrame frame = generator.frame(0, 2.0);
    const std::vector<irsg::Entity>& entities = source.scene.entities;
    ASSERT_EQ(entities.size(), 2u);
    EXPECT_EQ(entities[0].pose.position_m, (irsg::Vec3{10, 100, 50}));
    EXPECT_EQ(entities[1].pose, scenario.entities[1].pose);
    EXPECT_EQ(entities[0].state.time_s, 2.25);
    EXPECT_NEAR(entities[0].state.power, 0.4, 1e-15);
    EXPECT_EQ(entities[0].state.mach, 0.8);
    EXPECT_EQ(entities[1].state.time_s, 2.0);
    EXPECT_EQ(entities[1].state.power, 0.9);
    EXPECT_EQ(frame.time_s, 2.0);
    EXPECT_NEAR(frame.objects[0]->intensity_W_sr, 0.4, 1e-15);
    EXPECT_EQ(frame.objects[1]->coveredPixels, 2.0);
}

/// A sensor of 24 x 20 pixels with the noise of its photons alone.
irsg::SensorDescription counting() {
    irsg::SensorDescription sensor = test::smallSensor();
    sensor.title = "counting";
    sensor.electronics.readNoise_e = 0.0;
    sensor.electronics.gain = 1.0;
    sensor.electronics.bits = 24;
    return sensor;
}

/// Draws an even field.
class EvenSource : public NotingSource {
  public:
    irsg::Rendered image(const irsg::Outputs& outputs) override {
        irsg::Rendered rendered = NotingSource::image(outputs);
        std::ranges::fill(rendered.image.channels.front().values, radiance_W_m2_sr);
        return rendered;
    }
    float radiance_W_m2_sr = 0.02f;
};

TEST_F(ASimulation, ASensorReadsFramesInCountsWithNoiseOfTheirOwn) {
    irsg::saveSensor(counting(), folder / "counting.smatsensor");
    for (ScenarioSensor& sensor : scenario.sensors) {
        sensor.settings.set("image.sensor", "counting.smatsensor");
        sensor.settings.set("image.quantity", "counts");
        sensor.settings.set("image.sensorSamples", 2);
        sensor.settings.set("sensor.width", 99); // which the sensor overrides
    }
    const LoadedScenario loaded = load();
    EXPECT_EQ(loaded.sensors[0].scene.sensor.width_px, 24);
    EXPECT_EQ(loaded.sensors[0].settings.text("sensor.band"), "4-4.1");
    EvenSource source;
    SceneGenerator3D generator(loaded, source);
    const SensorFrame frame = generator.frame(0, 2.0);
    EXPECT_EQ(source.scene.sensor.width_px, 48); // drawn above the pixel grid
    ASSERT_EQ(frame.rendered.image.width(), 24);
    EXPECT_EQ(frame.rendered.image.primary().name, "counts");
    EXPECT_NE(frame.rendered.image.find("L"), nullptr);
    // The numbers of the table are those without a sensor.
    EXPECT_NEAR(frame.objects[0]->intensity_W_sr, 0.4, 1e-15);
    EXPECT_EQ(frame.objects[1]->coveredPixels, 2.0);
    // Mean and deviation follow from the radiance: photons alone, a count an electron.
    const irsg::PixelResponse response(counting());
    const double expected =
        static_cast<double>(source.radiance_W_m2_sr) * response.signalPerRadiance();
    double mean = 0.0, squares = 0.0;
    const std::vector<float>& counts = frame.rendered.image.primary().values;
    for (const float value : counts) {
        mean += static_cast<double>(value) / 480.0;
        squares += std::pow(static_cast<double>(value) - expected, 2) / 480.0;
    }
    EXPECT_NEAR(mean, expected, 5.0 * std::sqrt(expected / 480.0));
    EXPECT_NEAR(squares / expected, 1.0, 0.3);

    // A frame is the same whatever was before it, and no other has its noise: at another step, or
    // of another sensor of the same seed.
    const auto countsOf = [&](std::size_t sensor, double time_s) {
        return generator.frame(sensor, time_s).rendered.image.primary().values;
    };
    EXPECT_NE(countsOf(0, 3.0), counts);
    EXPECT_NE(countsOf(1, 2.0), counts);
    EXPECT_EQ(countsOf(0, 2.0), counts);

    // Full pixels are told, once for the run.
    source.radiance_W_m2_sr = 1e3f;
    SimulationResult result;
    runSimulation(
        generator, planSimulation(scenario, {.sensors = {"fixed"}, .from_s = {}, .to_s = {}}),
        [](SensorFrame&, std::size_t) {}, result);
    EXPECT_THAT(result.sensors[0].warnings,
                Contains("up to 480 pixels of a frame are saturated in the sensor"));
}

TEST_F(ASimulation, RefusesSensorsThatCannotReadFrames) {
    scenario.sensors[0].settings.set("image.quantity", "counts");
    EXPECT_THAT(refusal(), AllOf(HasSubstr("sensor fixed, image.quantity"), HasSubstr("counts")));
    irsg::saveSensor(counting(), folder / "counting.smatsensor");
    scenario.sensors[0].settings.set("image.sensor", "counting.smatsensor");
    EXPECT_EQ(refusal(), "accepted");
    scenario.sensors[0].settings.set("image.truthLayers", "true");
    EXPECT_THAT(refusal(), HasSubstr("sensor fixed, image.truthLayers"));
    scenario.sensors[0].settings.reset("image.truthLayers");
    scenario.sensors[1].settings.set("image.sensor", "absent.smatsensor");
    EXPECT_THAT(refusal(), HasSubstr("absent.smatsensor"));
}

TEST_F(ASimulation, ASensorOfSeveralBandsHasAFrameAndColumnsForEach) {
    scenario.sensors[0].settings.set("sensor.band", "3-5,8-12");
    const LoadedScenario loaded = load();
    NotingSource source;
    SceneGenerator3D generator(loaded, source);
    SimulationResult result;
    std::vector<std::pair<std::size_t, irsg::Band>> seen;
    runSimulation(
        generator, planSimulation(scenario, {.sensors = {"fixed"}, .from_s = 1, .to_s = 2}),
        [&](SensorFrame& frame, std::size_t) {
            seen.emplace_back(frame.band, source.scene.sensor.band);
        },
        result);
    const irsg::Band mid = irsg::Band::topHat(3, 5), far = irsg::Band::topHat(8, 12);
    EXPECT_THAT(seen, ElementsAre(std::pair(0u, mid), std::pair(1u, far), std::pair(0u, mid),
                                  std::pair(1u, far)));
    const ResultTable& table = result.sensors[0].table;
    ASSERT_EQ(table.rowCount(), 2u);
    for (const char* key : {"irradiance_total@3-5um", "mover.range", "mover.intensity@3-5um",
                            "mover.intensity@8-12um", "tower.pixels@8-12um"}) {
        EXPECT_NE(table.find(key), nullptr) << key;
    }
    EXPECT_NEAR(table.find("mover.intensity@8-12um")->values[1], 0.4, 1e-12);
    // A picture each, and the sums of all of a step together.
    EXPECT_EQ(source.images, 4);
    EXPECT_EQ(source.measured, 2);
    EXPECT_THAT(result.sensors[0].warnings, Contains(HasSubstr("a window of its own")));
    EXPECT_THAT(result.sensors[0].providedBy, ElementsAre("transmittance: closed form"));
    const FrameFiles files(loaded, folder / "out", {".exr"}, "");
    EXPECT_EQ(files.frameFile(0, 7, ".exr", 1).filename(), "frame_000007@8-12um.exr");
    EXPECT_EQ(files.frameFile(1, 7, ".exr").filename(), "frame_000007.exr");
}

TEST_F(ASimulation, ATrackingSensorLooksAtItsTargetWhereverThatIs) {
    const LoadedScenario loaded = load();
    NotingSource source;
    source.referencePoint = {0, 0, 5};
    SceneGenerator3D generator(loaded, source);
    for (const double time_s : {1.0, 2.5, 3.0}) {
        generator.frame(0, time_s);
        const irsg::Vec3 target = source.target().pose.toWorld(source.referencePoint);
        const irsg::Vec3 ahead = irsg::normalized(target - source.viewpoint.position_m);
        EXPECT_EQ(source.viewpoint.position_m, (irsg::Vec3{0, -100, 10}));
        EXPECT_NEAR(irsg::dot(source.viewpoint.forward(), ahead), 1.0, 1e-14);
        EXPECT_GT(source.viewpoint.up.z, 0.0);
    }
}

TEST_F(ASimulation, ACarriedSensorSitsAndLooksInItsCarriersAxes) {
    // The tower's nose points west, so that an offset to starboard lies north.
    scenario.sensors[1].offset = {{3, 2, 1}, {irsg::radians(-90), 0, 0}};
    const LoadedScenario loaded = load();
    NotingSource source;
    SceneGenerator3D generator(loaded, source);
    generator.frame(1, 2.0);
    const irsg::Vec3 at = source.viewpoint.position_m;
    EXPECT_NEAR(irsg::length(at - irsg::Vec3{-2, 3, 11}), 0.0, 1e-12);
    EXPECT_NEAR(irsg::length(source.viewpoint.forward() - irsg::Vec3{0, 1, 0}), 0.0, 1e-12);
    EXPECT_NEAR(irsg::length(source.viewpoint.right - irsg::Vec3{1, 0, 0}), 0.0, 1e-12);
    EXPECT_NEAR(irsg::length(source.viewpoint.up - irsg::Vec3{0, 0, 1}), 0.0, 1e-12);
}

TEST_F(ASimulation, ASensorFollowsATrajectoryOfItsOwn) {
    ScenarioSensor& sensor = scenario.sensors[1];
    sensor = {.name = "drone", .mount = MountKind::trajectory, .trajectory = "path.csv"};
    const LoadedScenario loaded = load();
    NotingSource source;
    SceneGenerator3D generator(loaded, source);
    generator.frame(1, 1.5);
    EXPECT_EQ(source.viewpoint.position_m, (irsg::Vec3{5, 100, 50}));
    EXPECT_NEAR(irsg::length(source.viewpoint.forward() - irsg::Vec3{-1, 0, 0}), 0.0, 1e-12);
    EXPECT_FALSE(generator.sees(1, 0.5));
}

TEST_F(ASimulation, WhoIsNotThereIsNotDrawnAndNotSeen) {
    const LoadedScenario loaded = load();
    NotingSource source;
    SceneGenerator3D generator(loaded, source);
    EXPECT_FALSE(generator.sees(0, 0.0)); // its target is not there
    EXPECT_TRUE(generator.sees(1, 0.0));
    const SensorFrame frame = generator.frame(1, 0.0);
    ASSERT_EQ(source.scene.entities.size(), 1u);
    EXPECT_EQ(source.scene.entities[0].name, "tower");
    EXPECT_FALSE(frame.objects[0]);
    EXPECT_EQ(frame.objects[1]->intensity_W_sr, 0.9);
    EXPECT_THROW(generator.frame(0, 0.0), irsg::LogicError);
    generator.frame(1, 2.0);
    EXPECT_EQ(source.scene.entities.size(), 2u);
}

TEST_F(ASimulation, DrawsAllSensorsAndTimesOfModelsThatWereLoadedOnce) {
    const LoadedScenario loaded = load();
    NotingSource source;
    SceneGenerator3D generator(loaded, source);
    for (const double time_s : {1.0, 2.0, 3.0}) {
        generator.frame(0, time_s);
        generator.frame(1, time_s);
    }
    EXPECT_EQ(loads, 1);
}

TEST_F(ASimulation, EverySensorHasItsOwnSettings) {
    scenario.settings.set("sensor.band", "8-12");
    scenario.settings.set("render.sun", "off");
    scenario.sensors[0].settings.set("sensor.width", 32);
    writeTextFile(folder / "i.xml",
                  "<data><fileType>Parameters</fileType><type>/ImagingSensor</type>"
                  "<parameter name=\"AntialiasingMode\"><double>1</double></parameter>"
                  "<parameter name=\"UseAtmosphereScattering\"><double>1</double></parameter>"
                  "<parameter name=\"Gain\"><double>1</double></parameter></data>");
    scenario.settings.set("render.antialiasing", 0);
    scenario.sensors[1].imagingSensor = "i.xml";
    Settings overrides;
    overrides.set("sensor.height", 16);
    const LoadedScenario loaded = load(overrides);
    EXPECT_EQ(loaded.sensors[0].scene.sensor.width_px, 32);
    EXPECT_EQ(loaded.sensors[1].scene.sensor.width_px, 640);
    for (const LoadedSensor& sensor : loaded.sensors) {
        EXPECT_EQ(sensor.scene.sensor.height_px, 16);
        EXPECT_EQ(sensor.scene.sensor.band, irsg::Band::topHat(8, 12));
        EXPECT_EQ(sensor.scene.settings.sun, irsg::ReflectionMode::off);
    }
    EXPECT_EQ(loaded.sensors[0].scene.settings.samplesPerAxis, 1);
    EXPECT_EQ(loaded.sensors[1].scene.settings.samplesPerAxis, 2);
    EXPECT_TRUE(loaded.sensors[0].warnings.empty());
    ASSERT_EQ(loaded.sensors[1].warnings.size(), 1u);
    EXPECT_THAT(loaded.sensors[1].warnings[0], HasSubstr("i.xml: line 1: Gain"));
    EXPECT_FALSE(loaded.sensors[0].scene.settings.scattering);
    EXPECT_TRUE(loaded.sensors[1].scene.settings.scattering);
    // The sensor's own word goes before that of its file.
    scenario.sensors[1].settings.set("render.antialiasing", 2);
    EXPECT_EQ(load().sensors[1].scene.settings.samplesPerAxis, 4);
}

TEST_F(ASimulation, RefusesAnImagingSensorThatTurnsOnWhatNobodyNames) {
    writeTextFile(folder / "i.xml",
                  "<data><fileType>Parameters</fileType><type>/ImagingSensor</type>"
                  "<parameter name=\"UseSkyboxBackground\"><double>1</double></parameter></data>");
    scenario.sensors[1].imagingSensor = "i.xml";
    EXPECT_THAT(refusal(), HasSubstr("i.xml: UseSkyboxBackground: found 1, expected 0, or files in "
                                     "the setting environment.skybox"));
}

TEST_F(ASimulation, SharesTheAirOfSensorsThatAreAlikeInIt) {
    writeTextFile(folder / "air.csv", "wavelength [um],extinction [km-1]\n3,0.1\n14,0.1\n");
    scenario.settings.set("environment.atmospheres", "air.csv");
    scenario.sensors.push_back({.name = "third", .offset = {{0, 0, 9}, {}}});
    scenario.sensors[2].settings.set("environment.sunElevation", 10);
    const LoadedScenario loaded = load();
    const auto air = [&](std::size_t i) {
        return loaded.sensors[i].scene.environment.atmospheres().front();
    };
    EXPECT_EQ(air(0), air(1));
    EXPECT_NE(air(0), air(2));
    EXPECT_NEAR(loaded.sensors[2].scene.environment.sun.elevation_rad, irsg::radians(10), 1e-15);
}

TEST_F(ASimulation, CollectsTheDiagnosticsOfAllFiles) {
    scenario.entities[0].trajectory = "none.csv";
    scenario.entities[1].model = "none.flt";
    scenario.sensors[0].imagingSensor = "none.xml";
    scenario.sensors[1].settings.set("environment.atmospheres", "none.air");
    const std::string all = refusal();
    for (const char* name : {"none.csv", "none.flt", "none.xml", "none.air"}) {
        EXPECT_THAT(all, HasSubstr(name));
    }
    EXPECT_EQ(all.find("none.flt"), all.rfind("none.flt")) << "said once, not for each sensor";
}

TEST_F(ASimulation, RefusesAnEngineThatIsSaidTwice) {
    scenario.entities[0].power = 0.5;
    EXPECT_THAT(refusal(), HasSubstr("entities.0.power: found a value beside a trajectory"));
}

TEST_F(ASimulation, RefusesPlacesBelowTheGroundBeforeItDraws) {
    scenario.entities[1].pose.position_m.z = -30;
    const std::string all = refusal();
    EXPECT_THAT(all, HasSubstr("reference point of tower at 0 s"));
    EXPECT_THAT(all, HasSubstr("an altitude of -30 m"));
    EXPECT_THAT(all, HasSubstr("sensor deck at 0 s"));
}

TEST_F(ASimulation, RefusesASensorInsideTheReferencePointOfItsTarget) {
    scenario.sensors[0].offset.position_m = {10, 100, 50};
    EXPECT_THAT(refusal(), HasSubstr("sensor fixed at 2 s: found 0 m to mover, which it tracks"));
}

TEST_F(ASimulation, RunsEveryStepForEverySensorAndSaysWhatIsMissing) {
    const LoadedScenario loaded = load();
    NotingSource source;
    SceneGenerator3D generator(loaded, source);
    SimulationResult result;
    std::vector<std::string> frames;
    runSimulation(
        generator, planSimulation(scenario, {}),
        [&](SensorFrame& frame, std::size_t number) {
            frames.push_back(std::to_string(frame.sensor) + "/" + std::to_string(number));
        },
        result);
    EXPECT_THAT(frames, ElementsAre("1/0", "0/1", "1/1", "0/2", "1/2", "0/3", "1/3", "1/4"));
    EXPECT_EQ(result.state, AnalysisState::complete);
    EXPECT_EQ(result.sensors[0].frames, 3u);
    EXPECT_EQ(result.sensors[0].framesMissing, 2u);
    EXPECT_THAT(result.sensors[0].warnings, Contains(HasSubstr("no frame at 2 of the steps")));
    const ResultTable& table = result.sensors[1].table;
    EXPECT_THAT(table.find("time")->values, ElementsAre(0, 1, 2, 3, 4));
    EXPECT_TRUE(std::isnan(table.find("mover.intensity")->values[0]));
    EXPECT_NEAR(table.find("mover.intensity")->values[2], 0.4, 1e-15);
    EXPECT_EQ(table.find("tower.pixels")->values[0], 1.0);
    EXPECT_EQ(table.find("tower.contrast_intensity")->header(),
              "tower.contrast_intensity [W sr-1]");
}

TEST_F(ASimulation, StopsBetweenFramesAndKeepsWhatIsDone) {
    const LoadedScenario loaded = load();
    NotingSource source;
    SceneGenerator3D generator(loaded, source);
    SimulationResult result;
    std::stop_source stop;
    runSimulation(
        generator, planSimulation(scenario, {.sensors = {"deck"}, .from_s = {}, .to_s = {}}),
        [&](SensorFrame&, std::size_t number) {
            if (number == 1) {
                stop.request_stop();
            }
        },
        result, {}, stop.get_token());
    EXPECT_EQ(result.state, AnalysisState::partial);
    EXPECT_EQ(result.sensors.at(0).table.rowCount(), 2u);
}

TEST_F(ASimulation, PlansTheSensorsAndTimesThatAreWanted) {
    const SimulationPlan plan =
        planSimulation(scenario, {.sensors = {"deck"}, .from_s = 1.5, .to_s = 3.0});
    EXPECT_THAT(plan.sensors, ElementsAre(1u));
    EXPECT_THAT(plan.times_s(), ElementsAre(2.0, 3.0));
    EXPECT_EQ(plan.steps[0].number, 2u);
    EXPECT_THROW(planSimulation(scenario, {.sensors = {"x"}, .from_s = {}, .to_s = {}}),
                 irsg::InputError);
    EXPECT_THROW(planSimulation(scenario, {.sensors = {}, .from_s = 1.2, .to_s = 1.8}),
                 irsg::InputError);
}

TEST_F(ASimulation, FramesAndTablesSayHowTheyCameToBe) {
    scenario.settings.set("sensor.width", 8);
    scenario.settings.set("sensor.height", 6);
    const LoadedScenario loaded = load();
    NotingSource source;
    SceneGenerator3D generator(loaded, source);
    const FrameFiles files(loaded, folder / "out", {".exr", ".csv"}, "smat-batch simulate");
    EXPECT_TRUE(files.makeFolders({0, 1}).empty());
    SensorFrame frame = generator.frame(1, 0.0);
    files.write(frame, 12);
    const irsg::RadianceImage image = irsg::readExr(folder / "out/deck/frame_000012.exr");
    EXPECT_TRUE(std::filesystem::exists(folder / "out/deck/frame_000012.csv"));
    EXPECT_EQ(image.width(), 8);
    const auto& attributes = image.attributes;
    EXPECT_EQ(attributes.at("time_s"), "0");
    EXPECT_EQ(attributes.at("frame"), "12");
    EXPECT_EQ(attributes.at("sensor"), "deck");
    EXPECT_EQ(attributes.at("scenario"), "s.json");
    EXPECT_EQ(attributes.at("command"), "smat-batch simulate");
    EXPECT_EQ(attributes.at("sensor.width"), "8 px");
    EXPECT_EQ(attributes.at("entity.mover"), "not there");
    EXPECT_EQ(attributes.at("entity.tower.position_m"), "0 0 10");
    EXPECT_EQ(attributes.at("entity.tower.yaw_pitch_roll_deg"), "90 0 0");
    EXPECT_EQ(attributes.at("answered by"), "transmittance: closed form");
    EXPECT_THAT(files.makeFolders({1}), ElementsAre(HasSubstr("2 frames already")));
    EXPECT_THROW(FrameFiles(loaded, folder / "out", {".gif"}, "").checkExtensions(),
                 irsg::InputError);
    writeTextFile(folder / "file", "in the way");
    EXPECT_THROW(FrameFiles(loaded, folder / "file", {".exr"}, "").makeFolders({0}),
                 irsg::InputError);
}

TEST_F(ASimulation, WritesTheSettingsOfASensorAsAnImagingSensorFile) {
    writeTextFile(folder / "i.xml",
                  "<data><fileType>Parameters</fileType><type>/ImagingSensor</type>"
                  "<parameter name=\"Gain\"><double>3</double></parameter></data>");
    scenario.sensors[1].imagingSensor = "i.xml";
    scenario.settings.set("sensor.mode", "ck");
    scenario.settings.set("render.antialiasing", 1);
    const LoadedScenario loaded = load();
    const FrameFiles files(loaded, folder.path(), {".exr"}, "");
    for (const std::size_t sensor : {0u, 1u}) {
        files.writeImagingSensor(sensor);
        const auto document = irsg::KarmaXml::read(files.imagingSensorFile(sensor));
        const ImagingSensorReading reading = imagingSensorFromKarma(document);
        EXPECT_EQ(reading.parameters, imagingSensorParametersOf(loaded.sensors[sensor].settings));
        EXPECT_EQ(reading.parameters.calculationMode, 2.0);
        EXPECT_EQ(reading.remarks.size(), sensor) << "what else stood in its own file is kept";
    }
}

/// Scaling files beside model.flt: temperature 0 and emissivity 0 of the database.
void writeScales(const std::filesystem::path& folder) {
    using irsg::ScalingKind;
    const std::filesystem::path model = folder / "model.flt";
    writeTextFile(irsg::scalingFile(model, ScalingKind::temperature),
                  irsg::scalingXml({{0, {{irsg::DistributionKind::normal, 0.9, 1.1}, ""}}}));
    writeTextFile(irsg::scalingFile(model, ScalingKind::emissivity),
                  irsg::scalingXml({{0, {{irsg::DistributionKind::uniform, 0.75, 0.75}, ""}}}));
}

TEST_F(ASimulation, DrawsTheSunsDiscAndAppliesScalingFilesUnlessItIsToldNotTo) {
    EXPECT_TRUE(load().sensors[0].scene.settings.sunDisc);
    EXPECT_FALSE(load().sensors[0].settings[key::scalingUse]) << "there are no files";
    scenario.sensors[1].settings.set("render.sunDisc", "false");
    scenario.sensors[1].settings.set("scaling.use", "false");
    writeScales(folder.path());
    const LoadedScenario loaded = load();
    EXPECT_TRUE(loaded.sensors[0].scene.settings.sunDisc);
    EXPECT_FALSE(loaded.sensors[1].scene.settings.sunDisc);
    // Each entity of one model has draws of its own, those of any other sensor.
    const auto& scaled = loaded.sensors[0].scene.entities;
    const double drawn = scaled[0].temperatureScale.at(0);
    EXPECT_GT(drawn, 0.9);
    EXPECT_LT(drawn, 1.1);
    EXPECT_NE(drawn, scaled[1].temperatureScale.at(0));
    EXPECT_EQ(scaled[0].emissivityScale.at(0), 0.75);
    EXPECT_TRUE(loaded.sensors[1].scene.entities[0].temperatureScale.empty());
    EXPECT_EQ(load().sensors[0].scene.entities[0].temperatureScale.at(0), drawn);
    scenario.settings.set("scaling.seed", "2");
    EXPECT_NE(load().sensors[0].scene.entities[0].temperatureScale.at(0), drawn);
    Settings without;
    without.set("scaling.use", "false");
    EXPECT_TRUE(load(without).sensors[0].scene.entities[0].temperatureScale.empty());
}

TEST_F(ASimulation, RefusesScalingsThatAreAskedForAndAbsent) {
    scenario.settings.set("scaling.use", "true");
    EXPECT_THAT(refusal(), HasSubstr("model(temperaturesScalings).xml: found no such file"));
}

TEST_F(ASimulation, FramesAndTablesSayWhatWasDrawn) {
    writeScales(folder.path());
    const LoadedScenario loaded = load();
    const double value = loaded.sensors[1].scene.entities[1].temperatureScale.at(0);
    NotingSource source;
    SimulationResult result;
    const FrameFiles files(loaded, folder / "out", {".exr"}, "");
    files.makeFolders({0, 1});
    writeSimulation(loaded, planSimulation(scenario, {}), files, source, result);
    const std::string ofTower =
        "tower temperature 0 (skin): " + irsg::numberText(value) + ", normal, 0.9 to 1.1";
    const auto attributes = irsg::readExr(folder / "out/deck/frame_000001.exr").attributes;
    EXPECT_THAT(attributes.at("drawn scale"), HasSubstr(ofTower));
    EXPECT_THAT(attributes.at("drawn scale"), HasSubstr("tower emissivity 0 (paint): 0.75"));
    EXPECT_EQ(attributes.at("scaling.seed"), "1");
    EXPECT_EQ(attributes.at("scaling.use"), "true");
    const Provenance table = ResultTable::load(folder / "out/deck.csv").provenance;
    EXPECT_THAT(table.entries,
                Contains(std::pair<std::string, std::string>("drawn scale", ofTower)));
    EXPECT_EQ(table.value("scaling.seed"), "1");
}

} // namespace
} // namespace smat

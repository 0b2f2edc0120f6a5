#include "smatcore/project/SceneBuilder.h"

#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/background/Skybox.h"
#include "irsg/render/background/Terrain.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/analysis/PlacedCase.h"
#include "smatcore/settings/RenderWords.h"
#include "smatcore/support/TextFile.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

/// A folder with a file that stands for a model, and a signature database.
class SceneBuilderTest : public testing::Test {
  protected:
    void SetUp() override {
        writeTextFile(folder / "model.flt", "anything");
        irsg::SignatureDatabase database;
        database.temperatures[0].name = "skin";
        database.temperatures[0].terms = irsg::TemperatureTerms::ofAmbient();
        database.materials[0].name = "paint";
        irsg::saveSignatureFile(database, folder / "model.sigdb");
        project.file = folder / "p.smat";
        project.models = {{.name = "", .file = "model.flt", .database = "model.sigdb"}};
    }

    SceneBuilder builder() {
        return SceneBuilder([this](const std::filesystem::path&, const irsg::ModelOptions&) {
            ++loads;
            return std::shared_ptr<const irsg::Model>();
        });
    }

    std::vector<irsg::Diagnostic> refused() {
        try {
            builder().build(project, project.settings);
        } catch (const irsg::InputError& error) {
            return error.diagnostics();
        }
        return {};
    }

    test::TemporaryFolder folder;
    Project project;
    int loads = 0;
};

TEST_F(SceneBuilderTest, TakesEveryNumberOverInTheUnitsOfTheRenderer) {
    Settings& settings = project.settings;
    settings.set("sensor.width", "100");
    settings.set("sensor.height", "50");
    settings.set("sensor.fov", "30");
    settings.set("sensor.band", "8-12");
    settings.set("target.yaw", "90");
    settings.set("target.pitch", "10");
    settings.set("target.roll", "-20");
    settings.set("target.altitude", "1234");
    settings.set("state.time", "3");
    settings.set("state.power", "0.5");
    settings.set("state.mach", "0.8");
    settings.set("environment.sunAzimuth", "90");
    settings.set("environment.sunElevation", "30");
    settings.set("environment.ambientTemperature", "250");
    settings.set("render.antialiasing", "1");
    settings.set("render.sun", "approx");
    settings.set("render.ambientReflection", "off");
    settings.set("render.fluxWeights", "report");
    settings.set("render.referenceTransmittance", "segment");
    settings.set("render.background", "2.5");
    settings.set("render.layers", "3");
    project.models[0].fallbackMaterial = 7;
    const SceneDescription scene = builder().build(project, settings);

    EXPECT_EQ(scene.sensor.width_px, 100);
    EXPECT_EQ(scene.sensor.height_px, 50);
    EXPECT_NEAR(scene.sensor.horizontalFieldOfView_rad, irsg::pi / 6, 1e-15);
    EXPECT_EQ(scene.sensor.band, irsg::Band::topHat(8, 12));
    const irsg::Entity& target = scene.entities.at(0);
    EXPECT_EQ(target.name, "model");
    EXPECT_EQ(target.pose.position_m, (irsg::Vec3{0, 0, 1234}));
    EXPECT_NEAR(target.pose.attitude.yaw_rad, irsg::pi / 2, 1e-15);
    EXPECT_NEAR(target.pose.attitude.pitch_rad, irsg::radians(10), 1e-15);
    EXPECT_NEAR(target.pose.attitude.roll_rad, irsg::radians(-20), 1e-15);
    EXPECT_EQ(target.state.time_s, 3);
    EXPECT_EQ(target.state.power, 0.5);
    EXPECT_EQ(target.state.mach, 0.8);
    EXPECT_EQ(target.fallbackMaterial, 7);
    EXPECT_EQ(target.database->temperatures.at(0).name, "skin");
    EXPECT_NEAR(scene.environment.sun.azimuth_rad, irsg::pi / 2, 1e-15);
    EXPECT_NEAR(scene.environment.sun.elevation_rad, irsg::pi / 6, 1e-15);
    EXPECT_EQ(scene.environment.defaultAmbient_K, 250);
    EXPECT_EQ(scene.environment.atmospheres().size(), 1u);
    EXPECT_EQ(scene.settings.tileSide_samples, 0);
    EXPECT_EQ(scene.settings.samplesPerAxis, 2);
    EXPECT_EQ(scene.settings.sun, irsg::ReflectionMode::approx);
    EXPECT_EQ(scene.settings.ambientReflection, irsg::ReflectionMode::off);
    EXPECT_EQ(scene.settings.fluxWeights, irsg::FluxWeights::report);
    EXPECT_EQ(scene.settings.referenceTransmittance, irsg::ReferenceTransmittance::segment);
    EXPECT_EQ(scene.settings.background, irsg::BackgroundMode::constant);
    EXPECT_EQ(scene.settings.background_W_m2_sr, 2.5);
    EXPECT_EQ(scene.settings.maximumLayers, 3);
    EXPECT_TRUE(scene.settings.errors);
}

TEST(RenderSettingsOf, AreWithoutErrorsOnlyWhereTheseAreOff) {
    for (const auto& [word, expected] :
         {std::pair("off", false), {"sum", true}, {"causes", true}}) {
        Settings settings;
        settings.set("render.errors", word);
        EXPECT_EQ(renderSettingsOf(settings).errors, expected) << word;
    }
    EXPECT_TRUE(renderSettingsOf(Settings()).errors) << "as the library has it";
}

TEST(RenderSettingsOf, RefuseReflectionsBetweenSurfacesThatApproximateFluxesDoNotHave) {
    struct Row {
        const char *bounces, *ambient;
        bool isRefused;
    };
    for (const Row& row : {Row{"converged", "approx", true}, Row{"2", "approx", true},
                           Row{"0", "approx", false}, Row{nullptr, "approx", false},
                           Row{"2", "smart", false}, Row{"converged", "off", false}}) {
        Settings settings;
        settings.set("render.ambientReflection", row.ambient);
        if (row.bounces != nullptr) {
            settings.set("render.bounces", row.bounces);
        }
        const std::string refusal = test::refusalOf([&] { (void)renderSettingsOf(settings); });
        EXPECT_EQ(refusal.find("render.bounces") != std::string::npos, row.isRefused)
            << row.ambient << " " << refusal;
    }
}

TEST_F(SceneBuilderTest, LoadsEachFileOnceUntilItChanges) {
    SceneBuilder shared = builder();
    project.models.push_back(project.models[0]);
    const auto first = shared.build(project, project.settings);
    const auto second = shared.build(project, project.settings);
    EXPECT_EQ(loads, 1);
    EXPECT_EQ(first.entities[0].database, second.entities[1].database);
    writeTextFile(folder / "model.flt", "another content");
    shared.build(project, project.settings);
    EXPECT_EQ(loads, 2);
}

TEST_F(SceneBuilderTest, RefusesAllThatIsWrongAtOnce) {
    project.models[0].file = "missing.flt";
    project.models.push_back({.name = "", .file = "model.flt", .database = "missing.sigdb"});
    project.models.push_back({.name = "", .file = "model.flt", .database = ""});
    project.settings.set("environment.atmospheres", "missing.csv;air.xml");
    project.settings.set("sensor.response", "missing-response.csv");
    std::vector<std::string> places;
    for (const irsg::Diagnostic& diagnostic : refused()) {
        places.push_back(std::filesystem::path(diagnostic.file).filename().string() + "|" +
                         diagnostic.position);
    }
    EXPECT_THAT(places, testing::UnorderedElementsAre("missing.flt|", "missing.sigdb|",
                                                      "p.smat|models.2.database", "missing.csv|",
                                                      "air.xml|",
                                                      testing::HasSubstr("missing-response.csv")));
}

TEST_F(SceneBuilderTest, AnEnvironmentFileBringsItsAtmospheresSunAndBackground) {
    const std::string head = "<data><fileType>Parameters</fileType><type>/";
    writeTextFile(folder / "summer.xml", head + "AtmosphereSmart</type></data>");
    writeTextFile(folder / "haze.csv", "wavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n");
    writeTextFile(folder / "world.xml",
                  head +
                      "Environment</type>"
                      "<parameter name=\"SunAzimuth\"><double>1.5</double></parameter>"
                      "<parameter name=\"SunElevation\"><double>0.25</double></parameter>"
                      "<parameter name=\"BackgroundRadianceWavelengths\"><vector><double>3</double>"
                      "<double>5</double></vector></parameter>"
                      "<parameter name=\"BackgroundRadianceValues\"><vector><double>1</double>"
                      "<double>2</double></vector></parameter>"
                      "<composition><composite name=\"A\"><component>AtmosphereSmart</component>"
                      "<parameters>.\\summer.xml</parameters></composite></composition></data>");
    project.settings.set("environment.atmospheres", "world.xml;haze.csv");
    const auto environment = environmentOf(project, project.settings);
    ASSERT_EQ(environment.atmospheres().size(), 2u);
    EXPECT_EQ(environment.atmospheres()[0]->name(), "AtmosphereSmart (summer.xml)");
    EXPECT_EQ(environment.atmospheres()[1]->name(), "Beer-Lambert (haze.csv)");
    EXPECT_EQ(environment.sun.azimuth_rad, 1.5);
    EXPECT_EQ(environment.sun.elevation_rad, 0.25);
    EXPECT_EQ(environment.defaultBackground->at(4.0), 1.5);
    EXPECT_EQ(environment.defaultAmbient_K, 288.15);

    // What the project sets itself goes before the file's.
    project.settings.set("environment.sunElevation", "45");
    const auto other = environmentOf(project, project.settings);
    EXPECT_EQ(other.sun.azimuth_rad, 1.5);
    EXPECT_NEAR(other.sun.elevation_rad, irsg::pi / 4, 1e-15);

    project.settings.set("environment.atmospheres", "summer.xml");
    const auto smart = environmentOf(project, project.settings);
    ASSERT_EQ(smart.atmospheres().size(), 1u);
    EXPECT_NEAR(smart.sun.azimuth_rad, irsg::pi, 1e-15);
    EXPECT_FALSE(smart.defaultBackground);
}

/// Another text than that in effect.
std::string otherThan(const SettingInfo& setting, const Settings& settings) {
    using enum SettingKind;
    std::vector<std::string> candidates = setting.choices;
    if (setting.kind == boolean) {
        candidates = {"false", "true"};
    } else if (setting.kind == band) {
        candidates = {"3-4", "4-5"};
    } else if (setting.kind == path || setting.kind == pathList) {
        candidates = {"one.file", "another.file"};
    } else if (setting.kind != choice) {
        candidates = {irsg::numberText(setting.minimum), irsg::numberText(setting.maximum)};
    }
    return candidates.front() != settings.text(setting.key) ? candidates.front()
                                                            : candidates.back();
}

TEST_F(SceneBuilderTest, TheKeyOfAnEnvironmentChangesWithEverySettingThatItIsMadeOf) {
    // What else stands in that section; all settings of other sections are not of the environment.
    const std::set<std::string> besideTheAtmosphere = {
        "environment.skybox",      "environment.skyboxSlope",  "environment.skyboxOffset",
        "environment.terrain",     "environment.terrainSlope", "environment.terrainOffset",
        "environment.terrainEast", "environment.terrainNorth", "environment.terrainAltitude"};
    std::size_t found = 0;
    for (const SettingInfo& setting : settingTable()) {
        found += besideTheAtmosphere.count(setting.key);
        const std::string before = environmentKey(project, project.settings);
        const std::string value = otherThan(setting, project.settings);
        project.settings.set(setting.key, value);
        EXPECT_EQ(environmentKey(project, project.settings) != before,
                  setting.section() == "environment" && !besideTheAtmosphere.contains(setting.key))
            << setting.key << " " << value;
    }
    EXPECT_EQ(found, besideTheAtmosphere.size());
    // Files are named from where the project stands.
    Project elsewhere = project;
    elsewhere.file = folder / "elsewhere" / "p.smat";
    EXPECT_NE(environmentKey(elsewhere, project.settings),
              environmentKey(project, project.settings));
}

TEST_F(SceneBuilderTest, TheKeyOfAnEnvironmentChangesWhenAFileOfTheAirIsWrittenAgain) {
    const auto air = folder / "air.csv";
    writeTextFile(air, "one");
    project.settings.set("environment.atmospheres", air.string());
    const std::string before = environmentKey(project, project.settings);
    EXPECT_EQ(environmentKey(project, project.settings), before);
    writeTextFile(air, "another");
    EXPECT_NE(environmentKey(project, project.settings), before);
}

// The place of the sun that is set costs no reading of the air.
TEST_F(SceneBuilderTest, TheKeyOfAnEnvironmentSaysOfTheSunWhetherItsPlaceIsSet) {
    Settings& settings = project.settings;
    for (const char* name : {"environment.sunAzimuth", "environment.sunElevation"}) {
        const std::string unset = environmentKey(project, settings);
        settings.set(name, "10");
        const std::string set = environmentKey(project, settings);
        EXPECT_NE(set, unset) << name;
        settings.set(name, "20");
        EXPECT_EQ(environmentKey(project, settings), set) << name;
        settings.reset(name);
        EXPECT_EQ(environmentKey(project, settings), unset) << name;
    }
}

TEST_F(SceneBuilderTest, EverySensorThatSettingsTakeIsOneThatARendererTakes) {
    for (const char* name : {"sensor.width", "sensor.height", "sensor.fov"}) {
        const SettingInfo& info = settingInfo(name);
        for (const double value : {info.minimum, info.maximum}) {
            Settings settings;
            settings.set(name, irsg::numberText(value));
            EXPECT_NO_THROW(sensorOf(project, settings).check()) << name << " " << value;
            // What is beyond is refused by its name.
            const double beyond = value == info.minimum ? 0.0 : 2.0 * value;
            EXPECT_THAT(test::refusalOf([&] { settings.set(name, irsg::numberText(beyond)); }),
                        testing::HasSubstr(name));
        }
    }
}

TEST_F(SceneBuilderTest, ARendererIsGivenAllOfAScene) {
    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    scene.environment.defaultAmbient_K = 251.0;
    scene.sensor.width_px = 17;
    scene.settings.backgroundRows = 5;
    const std::filesystem::path valley = SMAT_SOURCE_DIR "/samples/valley";
    Settings settings;
    settings.set("environment.skybox", (valley / "sky").string());
    settings.set("environment.terrain", (valley / "valley.osgb").string());
    SceneBuilder builder;
    scene.skybox = builder.skybox(project, settings);
    scene.terrain = builder.terrain(project, settings);
    scene.entities.emplace_back().name = "one";
    scene.entities.emplace_back().name = "two";
    RenderDoor door;
    door.referencePoint = [](const irsg::Entity&) { return irsg::Vec3{1.0, 2.0, 3.0}; };
    const irsg::Pose pose{{10.0, 0.0, 0.0}, {}};
    const PlacedCase placed =
        CasePlacer(door, scene).place(scene, {std::nullopt, EntityPlace{pose, {}}}, {});
    EXPECT_EQ(placed.scene.environment.defaultAmbient_K, 251.0);
    EXPECT_EQ(placed.view.sensor.width_px, 17);
    EXPECT_EQ(placed.scene.settings, scene.settings);
    EXPECT_EQ(placed.scene.skybox, scene.skybox);
    EXPECT_EQ(placed.scene.terrain, scene.terrain);
    ASSERT_EQ(placed.scene.entities.size(), 1u) << "those that are there";
    EXPECT_EQ(placed.scene.entities[0].name, "two");
    EXPECT_EQ(placed.scene.entities[0].pose, pose);
    EXPECT_EQ(placed.referencePoints_m[0], (irsg::Vec3{11.0, 2.0, 3.0}));
}

TEST_F(SceneBuilderTest, AProjectWithoutModelsIsRefused) {
    project.models.clear();
    ASSERT_EQ(refused().size(), 1u);
    EXPECT_EQ(refused()[0].position, "models");
}

TEST_F(SceneBuilderTest, AFolderIsNoModel) {
    project.models[0].file = ".";
    ASSERT_EQ(refused().size(), 1u);
    EXPECT_EQ(refused()[0].value, "a folder");
}

TEST(SettingsOfRendering, AreThoseOfTheLibraryByDefault) {
    EXPECT_EQ(renderSettingsOf(Settings()), irsg::RenderSettings());
    // Each default is the library's own value, read back from its row.
    Settings all;
    for (const SettingInfo& setting : settingTable()) {
        all.set(setting.key, setting.defaultText);
    }
    EXPECT_EQ(renderSettingsOf(all), irsg::RenderSettings());
}

TEST(SettingsOfRendering, HaveAWordForEachChoiceOfTheLibrary) {
    const auto expectOneToOne = [](const auto& words) {
        for (const auto& [word, value] : words) {
            EXPECT_EQ(wordOf(words, value), word);
            EXPECT_EQ(valueOf(words, word), value);
        }
    };
    expectOneToOne(engineWords);
    expectOneToOne(zoomWords);
    expectOneToOne(reflectionWords);
    expectOneToOne(shadowWords);
    expectOneToOne(fluxWeightWords);
    expectOneToOne(referenceTransmittanceWords);
    expectOneToOne(supersamplingWords);
    EXPECT_THROW(valueOf(engineWords, "steam"), irsg::LogicError);
}

TEST_F(SceneBuilderTest, LoadsSkyboxAndTerrainOnceWithTheirScales) {
    Settings& settings = project.settings;
    const std::filesystem::path valley = SMAT_SOURCE_DIR "/samples/valley";
    settings.set("environment.skybox", (valley / "sky").string());
    settings.set("environment.skyboxSlope", "0.5");
    settings.set("environment.skyboxOffset", "0.25");
    settings.set("environment.terrain", (valley / "valley.osgb").string());
    settings.set("environment.terrainSlope", "2");
    settings.set("environment.terrainOffset", "0.5");
    settings.set("environment.terrainEast", "100");
    settings.set("environment.terrainNorth", "-200");
    settings.set("environment.terrainAltitude", "30");
    settings.set("render.backgroundRows", "16");
    settings.set("render.backgroundColumns", "3");
    settings.set("render.sunDisc", "true");
    settings.set("render.terrainHides", "false");
    SceneBuilder shared = builder();
    const SceneDescription scene = shared.build(project, settings);
    ASSERT_TRUE(scene.skybox);
    ASSERT_TRUE(scene.terrain);
    EXPECT_EQ(scene.skybox->faceSize(), 512);
    EXPECT_FALSE(scene.skybox->brightSpot_rad()) << "the sample's sky has no sun";
    EXPECT_NEAR(scene.terrain->pose().position_m.x, 100.0, 1e-6);
    EXPECT_NEAR(scene.terrain->pose().position_m.y, -200.0, 1e-6);
    EXPECT_GT(scene.terrain->bounds().max.x, 7000.0);
    EXPECT_EQ(scene.settings.skybox, (irsg::TextureScale{0.5, 0.25}));
    EXPECT_EQ(scene.settings.terrain, (irsg::TextureScale{2.0, 0.5}));
    EXPECT_EQ(scene.settings.backgroundRows, 16);
    EXPECT_EQ(scene.settings.backgroundColumns, 3);
    EXPECT_TRUE(scene.settings.sunDisc);
    EXPECT_FALSE(scene.settings.terrainHides);

    const SceneDescription again = shared.build(project, settings);
    EXPECT_EQ(again.skybox, scene.skybox);
    EXPECT_EQ(again.terrain, scene.terrain);
    settings.set("environment.terrainEast", "200");
    EXPECT_NE(shared.build(project, settings).terrain, scene.terrain);
    settings.set("environment.skybox", "none");
    settings.set("environment.terrain", "");
    EXPECT_FALSE(shared.build(project, settings).skybox);
    EXPECT_FALSE(shared.build(project, settings).terrain);
}

TEST_F(SceneBuilderTest, RefusesSkyboxAndTerrainByTheirKeys) {
    project.settings.set("environment.skybox", "a.png;b.png");
    project.settings.set("environment.terrain", "missing.osgb");
    const std::vector<irsg::Diagnostic> diagnostics = refused();
    ASSERT_EQ(diagnostics.size(), 2u);
    EXPECT_EQ(diagnostics[0].position, "environment.skybox");
    EXPECT_EQ(diagnostics[0].value, "2 files");
    EXPECT_EQ(diagnostics[1].position, "environment.terrain");
    EXPECT_EQ(std::filesystem::path(diagnostics[1].file).filename(), "missing.osgb");

    std::filesystem::create_directory(folder / "sky");
    project.settings.set("environment.skybox", "sky");
    project.settings.set("environment.terrain", "");
    ASSERT_EQ(refused().size(), 6u);
    EXPECT_EQ(refused()[3].position, "environment.skybox, skybox face west");
}

} // namespace
} // namespace smat

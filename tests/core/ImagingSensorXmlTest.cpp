#include "smatcore/simulate/ImagingSensorXml.h"

#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/atmosphere/KarmaSupport.h"
#include "tests/support/SharedMaterial.h"

namespace smat {
namespace {

using irsg::KarmaXml;
using irsg::numberXml;
using testing::HasSubstr;

std::string sensorXml(const std::string& inside) {
    std::string text = irsg::smartXml(inside);
    const std::string type = "/AtmosphereSmart/Root/Atmosphere/AtmosphereSmart";
    return text.replace(text.find(type), type.size(), "/ImagingSensor/Root/Sensor/ImagingSensor");
}

ImagingSensorReading readOf(const std::string& inside) {
    return imagingSensorFromKarma(KarmaXml::parse(sensorXml(inside), "sensor.xml"));
}

TEST(ImagingSensorXml, TheFileOfTheReportIsReadAndComesBackEqual) {
    const auto file = smat::test::sharedMaterial("data/karma/ImagingSensor.xml");
    if (file.empty()) {
        GTEST_SKIP() << "the KARMA files of the shared material are not here";
    }
    KarmaXml document = KarmaXml::read(file);
    const ImagingSensorReading reading = imagingSensorFromKarma(document);
    const ImagingSensorParameters expected{.calculationMode = 2,
                                           .antialiasingMode = 4,
                                           .isUniformBackground = 0,
                                           .numberOfBackgroundColumns = 4,
                                           .numberOfBackgroundRows = 16,
                                           .useSkyboxBackground = 1,
                                           .useTerrainBackground = 0,
                                           .skyboxTextureRadianceSlope = 0.5,
                                           .skyboxTextureColorOffset = 0.5,
                                           .terrainTextureRadianceSlope = 0.8,
                                           .terrainTextureColorOffset = 0.5,
                                           .useAtmosphereScattering = 0};
    EXPECT_EQ(reading.parameters, expected);
    EXPECT_TRUE(reading.remarks.empty());
    EXPECT_EQ(document.parameters().size(), imagingSensorParameters().size());
    toKarma(reading.parameters, document);
    EXPECT_EQ(irsg::significant(document.text()), irsg::significant(irsg::contentOf(file)));
}

TEST(ImagingSensorXml, WhatIsWrittenIsReadBackEqual) {
    ImagingSensorParameters parameters;
    double value = 0.0;
    for (const ImagingSensorParameter& known : imagingSensorParameters()) {
        parameters.*known.field = known.isWhole ? known.maximum : 0.125 + value;
        value += 0.0625;
    }
    KarmaXml document = toKarma(parameters);
    EXPECT_EQ(imagingSensorFromKarma(KarmaXml::parse(document.text(), "again.xml")).parameters,
              parameters);
    // What a file does not say is not made up, and goes where it was known.
    parameters.numberOfBackgroundRows.reset();
    parameters.calculationMode.reset();
    toKarma(parameters, document);
    EXPECT_EQ(imagingSensorFromKarma(document).parameters, parameters);
    EXPECT_EQ(readOf("").parameters, ImagingSensorParameters());
}

TEST(ImagingSensorXml, UnknownNamesAreReportedAndKept) {
    const std::string text = sensorXml(numberXml("Gain", "3") + numberXml("AntialiasingMode", "2"));
    KarmaXml document = KarmaXml::parse(text, "sensor.xml");
    const ImagingSensorReading reading = imagingSensorFromKarma(document);
    ASSERT_EQ(reading.remarks.size(), 1u);
    EXPECT_THAT(reading.remarks[0], HasSubstr("line 5: Gain is no parameter"));
    toKarma(reading.parameters, document);
    EXPECT_EQ(document.text().find("Gain") != std::string::npos, true);
}

struct BadRow {
    const char* name;
    std::string text;
    std::vector<std::string> named;
};
void PrintTo(const BadRow& row, std::ostream* out) {
    *out << row.name;
}
class ABadImagingSensor : public testing::TestWithParam<BadRow> {};

TEST_P(ABadImagingSensor, IsRefusedWithLineNameAndValue) {
    const std::string refusal = irsg::refusalOf(
        [] { imagingSensorFromKarma(KarmaXml::parse(GetParam().text, "sensor.xml")); });
    for (const std::string& word : GetParam().named) {
        EXPECT_THAT(refusal, HasSubstr(word));
    }
}

BadRow bad(const char* name, const std::string& parameter, const std::string& value,
           const std::string& range) {
    return {name, sensorXml(numberXml(parameter, value)), {"line 5", parameter, value, range}};
}

INSTANTIATE_TEST_SUITE_P(
    Inputs, ABadImagingSensor,
    testing::Values(
        bad("NoSuchCalculation", "CalculationMode", "3", "1 or 2"),
        bad("CalculationZero", "CalculationMode", "0", "1 or 2"),
        bad("NoSuchAntialiasing", "AntialiasingMode", "6", "0 to 5"),
        bad("BrokenAntialiasing", "AntialiasingMode", "2.5", "0 to 5"),
        bad("NegativeAntialiasing", "AntialiasingMode", "-1", "0 to 5"),
        bad("HalfUniform", "IsUniformBackground", "0.5", "0 or 1"),
        bad("NoRows", "NumberOfBackgroundRows", "0", "1 to 1024"),
        bad("TooManyColumns", "NumberOfBackgroundColumns", "1025", "1 to 1024"),
        bad("TwoSkyboxes", "UseSkyboxBackground", "2", "0 or 1"),
        bad("TwoTerrains", "UseTerrainBackground", "2", "0 or 1"),
        bad("SlopeBeyondReason", "SkyboxTextureRadianceSlope", "2e+09", "W m-2 sr-1"),
        bad("OffsetBeyondReason", "TerrainTextureColorOffset", "-2e+09", "-1e9 to 1e9"),
        bad("ScatteringTwice", "UseAtmosphereScattering", "2", "0 or 1"),
        bad("NoNumber", "AntialiasingMode", "many", "number"),
        bad("Infinite", "TerrainTextureRadianceSlope", "inf", "number"),
        BadRow{"AnotherKind",
               sensorXml(irsg::vectorXml("AntialiasingMode", "1 2")),
               {"AntialiasingMode", "a vector", "a double"}},
        BadRow{"AnotherType", irsg::smartXml(""), {"AtmosphereSmart", "/ImagingSensor"}},
        BadRow{"SeveralAtOnce",
               sensorXml(numberXml("CalculationMode", "3") + numberXml("AntialiasingMode", "9")),
               {"line 5", "CalculationMode", "line 6", "AntialiasingMode"}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(ImagingSensorSettings, EveryParameterSetsItsSetting) {
    const ImagingSensorSettings set = settingsOf({.calculationMode = 2,
                                                  .antialiasingMode = 5,
                                                  .isUniformBackground = 0,
                                                  .numberOfBackgroundColumns = 3,
                                                  .numberOfBackgroundRows = 16,
                                                  .useSkyboxBackground = 1,
                                                  .useTerrainBackground = 0,
                                                  .skyboxTextureRadianceSlope = 0.25,
                                                  .skyboxTextureColorOffset = 0.5,
                                                  .terrainTextureRadianceSlope = 0.75,
                                                  .terrainTextureColorOffset = 0.125,
                                                  .useAtmosphereScattering = 0});
    EXPECT_EQ(set.settings.text("sensor.mode"), "ck");
    EXPECT_EQ(set.settings[key::renderAntialiasing], 5);
    EXPECT_EQ(set.settings[key::renderBackgroundColumns], 3);
    EXPECT_EQ(set.settings[key::renderBackgroundRows], 16);
    EXPECT_EQ(set.settings[key::environmentSkyboxSlope], 0.25);
    EXPECT_EQ(set.settings[key::environmentSkyboxOffset], 0.5);
    EXPECT_EQ(set.settings[key::environmentTerrainSlope], 0.75);
    EXPECT_EQ(set.settings[key::environmentTerrainOffset], 0.125);
    EXPECT_FALSE(set.settings.isSet("environment.skybox")) << "the scenario names it";
    EXPECT_TRUE(set.settings.isSet("environment.terrain")) << "off, whatever the scenario names";
    EXPECT_TRUE(set.settings[key::environmentTerrain].empty());
    ASSERT_EQ(set.needed.size(), 1u);
    EXPECT_EQ(set.needed[0].setting, "environment.skybox");
    EXPECT_TRUE(settingsOf({}).settings.values().empty());
}

TEST(ImagingSensorSettings, AUniformBackgroundIsOneLineOfSightWhateverItsNumbersSay) {
    const ImagingSensorSettings set = settingsOf(
        {.isUniformBackground = 1, .numberOfBackgroundColumns = 4, .numberOfBackgroundRows = 16});
    EXPECT_EQ(set.settings[key::renderBackgroundColumns], 1);
    EXPECT_EQ(set.settings[key::renderBackgroundRows], 1);
}

TEST(ImagingSensorSettings, AsManyRowsAsAreNeededBecomeANumberOfTheFile) {
    Settings settings;
    settings.set("render.backgroundRows", "0");
    const ImagingSensorParameters parameters = imagingSensorParametersOf(settings);
    EXPECT_EQ(parameters.numberOfBackgroundRows, 32.0);
    EXPECT_EQ(parameters.isUniformBackground, 0.0);
}

TEST(ImagingSensorSettings, TurnScatteringOnAndOff) {
    EXPECT_TRUE(settingsOf({.useAtmosphereScattering = 1}).settings[key::renderScattering]);
    const ImagingSensorSettings off = settingsOf({.useAtmosphereScattering = 0});
    EXPECT_TRUE(off.settings.isSet("render.scattering"));
    EXPECT_FALSE(off.settings[key::renderScattering]);
    Settings settings;
    settings.set("render.scattering", "true");
    EXPECT_EQ(imagingSensorParametersOf(settings).useAtmosphereScattering, 1.0);
}

TEST(ImagingSensorSettings, ComeBackFromTheSettings) {
    Settings settings;
    for (const auto& [key, text] : {std::pair("sensor.mode", "ck"),
                                    {"render.antialiasing", "3"},
                                    {"render.backgroundRows", "16"},
                                    {"render.backgroundColumns", "4"},
                                    {"environment.skyboxSlope", "-0.5"},
                                    {"environment.skyboxOffset", "1.5"},
                                    {"environment.terrainSlope", "0.75"},
                                    {"environment.terrainOffset", "0.25"},
                                    {"environment.skybox", "none"},
                                    {"render.scattering", "true"},
                                    {"environment.terrain", ""}}) {
        settings.set(key, text);
    }
    const KarmaXml document = toKarma(imagingSensorParametersOf(settings));
    const ImagingSensorReading reading =
        imagingSensorFromKarma(KarmaXml::parse(document.text(), "again.xml"));
    EXPECT_EQ(settingsOf(reading.parameters).settings, settings);
    settings.set("environment.skybox", "clouds");
    settings.set("environment.terrain", "hills.osgt");
    EXPECT_EQ(imagingSensorParametersOf(settings).useSkyboxBackground, 1.0);
    EXPECT_EQ(imagingSensorParametersOf(settings).useTerrainBackground, 1.0);
}

} // namespace
} // namespace smat

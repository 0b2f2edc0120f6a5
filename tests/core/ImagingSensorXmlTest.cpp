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

TEST(ImagingSensorXml, theFileOfTheReportIsReadAndComesBackEqual) {
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

TEST(ImagingSensorXml, whatIsWrittenIsReadBackEqual) {
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

TEST(ImagingSensorXml, unknownNamesAreReportedAndKept) {
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

TEST_P(ABadImagingSensor, isRefusedWithLineNameAndValue) {
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
        bad("NegativeSlope", "SkyboxTextureRadianceSlope", "-0.5", "W m-2 sr-1"),
        bad("OffsetAboveWhite", "TerrainTextureColorOffset", "1.5", "0 to 1"),
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

TEST(ImagingSensorSettings, everyParameterSetsItsSetting) {
    const ImagingSensorSettings set =
        settingsOf({.calculationMode = 2, .antialiasingMode = 1, .useAtmosphereScattering = 0});
    EXPECT_EQ(set.settings.text("sensor.mode"), "ck");
    EXPECT_EQ(set.settings.integer("render.antialiasing"), 1);
    EXPECT_TRUE(set.warnings.empty());
    EXPECT_TRUE(settingsOf({}).settings.values().empty());
}

TEST(ImagingSensorSettings, scatteringThatIsNotThereIsSaidPlainly) {
    const ImagingSensorSettings set = settingsOf({.useAtmosphereScattering = 1});
    ASSERT_EQ(set.warnings.size(), 1u);
    EXPECT_THAT(set.warnings[0], HasSubstr("UseAtmosphereScattering"));
}

TEST(ImagingSensorSettings, comeBackFromTheSettings) {
    Settings settings;
    settings.set("sensor.mode", "ck");
    settings.set("render.antialiasing", 1);
    const ImagingSensorParameters parameters = imagingSensorParametersOf(settings);
    EXPECT_EQ(settingsOf(parameters).settings.with(settings), settingsOf(parameters).settings);
}

} // namespace
} // namespace smat

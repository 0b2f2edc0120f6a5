#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmartParameters.h"
#include "tests/atmosphere/KarmaSupport.h"
#include "tests/support/SharedMaterial.h"

namespace irsg {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

SmartReading readOf(const std::string& inside) {
    return fromKarma(KarmaXml::parse(smartXml(inside), "air.xml"));
}

TEST(AtmosphereSmartParameters, AreTheTwentySevenOfTheReport) {
    std::vector<std::string> names;
    for (const SmartParameter& parameter : smartParameters()) {
        names.emplace_back(parameter.name);
    }
    EXPECT_THAT(names,
                ElementsAre("AerosolModel", "AirMass", "AlbedoValues", "AlbedoWavelengths",
                            "AtmosphereModel", "BaseWavelengthMax", "BaseWavelengthMin",
                            "CloudBaseAltitude", "CloudExtinction", "CloudModel", "CloudThickness",
                            "GroundTemperature", "IrradianceMode", "MeasurementHeight",
                            "MeteoModel", "ModelType", "PressureMH", "RelativeHumidityMH",
                            "Resolution", "ScatteringMode", "TemperatureALT0", "TemperatureMH",
                            "Visibility", "WindDirection", "WindSpeed", "WindSpeedAverage24",
                            "WindSpeedMeasurementHeight"));
    EXPECT_TRUE(diagnosticsOf({}).empty());
    EXPECT_TRUE(remarksOn({}).empty());
}

TEST(AtmosphereSmartParameters, TheFileOfTheReportHoldsTheValuesOfAnnexA) {
    const auto file = smat::test::sharedMaterial("data/karma/AtmosphereSmart.xml");
    if (file.empty()) {
        GTEST_SKIP() << "the KARMA files of the shared material are not here";
    }
    KarmaXml document = KarmaXml::read(file);
    const SmartReading reading = fromKarma(document);
    // Annex A's values are the defaults, but for the tables.
    AtmosphereSmartParameters annexA;
    EXPECT_EQ(annexA.irradianceMode, 2);
    annexA.irradianceMode = 1;
    EXPECT_EQ(reading.parameters, annexA);
    EXPECT_TRUE(reading.remarks.empty());
    toKarma(reading.parameters, document);
    EXPECT_EQ(significant(document.text()), significant(contentOf(file)));
}

TEST(AtmosphereSmartParameters, AnEmptyFileHasTheDefaultsAndSaysSo) {
    const SmartReading reading = readOf("");
    EXPECT_EQ(reading.parameters, AtmosphereSmartParameters());
    EXPECT_EQ(reading.remarks.size(), 27u);
    EXPECT_THAT(reading.remarks, Contains("no GroundTemperature: taken as 20 C"));
    EXPECT_THAT(reading.remarks, Contains("no ModelType: taken as SMART_ATMOSPHERIC_MODEL"));
}

TEST(AtmosphereSmartParameters, WhatIsNotKnownIsKeptAndSaid) {
    KarmaXml document = KarmaXml::parse(
        smartXml(numberXml("Visiblity", "5000") + numberXml("AirMass", "4")), "air.xml");
    const SmartReading reading = fromKarma(document);
    EXPECT_THAT(reading.remarks, Contains(HasSubstr("line 5: Visiblity is no parameter")));
    toKarma(reading.parameters, document);
    EXPECT_THAT(document.text(), HasSubstr("Visiblity"));
    EXPECT_EQ(fromKarma(KarmaXml::parse(document.text(), "again")).parameters.airMass, 4);
}

TEST(AtmosphereSmartParameters, SettingsWithoutEffectAreSaid) {
    const struct {
        const char* name;
        std::string inside;
        const char* says;
    } rows[] = {
        {"a cloud's thickness without a cloud", numberXml("CloudThickness", "500"),
         "CloudThickness 500 m has no effect without a cloud"},
        {"a cloud's base without a cloud", numberXml("CloudBaseAltitude", "1000"),
         "CloudBaseAltitude 1000 m has no effect"},
        {"measured weather without its model", numberXml("TemperatureMH", "3"),
         "TemperatureMH 3 C has no effect in MeteoModel 1"},
        {"measured air far apart that nobody uses",
         numberXml("TemperatureMH", "-30") + numberXml("TemperatureALT0", "30"),
         "TemperatureALT0 30 C has no effect"},
        {"wind over land", numberXml("WindSpeed", "12"), "WindSpeed 12 m/s has no effect"},
        {"air mass over land", numberXml("AirMass", "7"), "AirMass 7 has no effect"},
        {"wind direction", numberXml("WindDirection", "1"), "WindDirection 1 rad has no effect"},
    };
    for (const auto& row : rows) {
        EXPECT_THAT(readOf(row.inside).remarks, Contains(HasSubstr(row.says))) << row.name;
    }
    const auto navy = readOf(numberXml("AerosolModel", "3") + numberXml("WindSpeed", "12") +
                             numberXml("AirMass", "7"));
    EXPECT_THAT(navy.remarks, testing::Not(Contains(HasSubstr("no effect"))));
}

TEST(AtmosphereSmartParameters, OurOwnAreWrittenOnlyWhereTheyDiffer) {
    AtmosphereSmartParameters parameters;
    EXPECT_THAT(toKarma(parameters).text(), testing::Not(HasSubstr("Co2_ppmv")));
    parameters.co2_ppmv = 360.0;
    parameters.ch4_ppmv = 1.9;
    parameters.n2o_ppmv = 0.0;
    parameters.aerosols = 0;
    parameters.ozoneScale = 0.9;
    parameters.waterScale = 1.25;
    parameters.groundAltitude_m = 1155.0;
    parameters.radiosonde = "ascent.csv";
    KarmaXml document = toKarma(parameters);
    EXPECT_EQ(fromKarma(document).parameters, parameters);
    toKarma(AtmosphereSmartParameters(), document);
    EXPECT_THAT(document.text(), testing::Not(HasSubstr("Co2_ppmv")));
    for (const char* name : {"Radiosonde", "Ch4_ppmv", "N2o_ppmv", "Aerosols", "OzoneScale",
                             "WaterScale", "GroundAltitude"}) {
        EXPECT_THAT(document.text(), testing::Not(HasSubstr(name)));
    }
}

TEST(AtmosphereSmartParameters, WhatIsWrittenIsReadBackEqual) {
    std::mt19937 random(7);
    const auto real = [&](double least, double most) {
        return std::uniform_real_distribution(least, most)(random);
    };
    const auto code = [&](std::vector<int> codes) {
        return codes[std::uniform_int_distribution<std::size_t>(0, codes.size() - 1)(random)];
    };
    for (int trial = 0; trial < 300; ++trial) {
        AtmosphereSmartParameters p;
        p.aerosolModel = code({0, 1, 2, 3, 4, 5, 6, 7});
        p.airMass = code({1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
        p.albedoValues.clear();
        p.albedoWavelengths_um.clear();
        const int points = code({1, 2, 12, 40});
        for (int i = 0; i < points; ++i) {
            p.albedoValues.push_back(real(0.0, 1.0));
            p.albedoWavelengths_um.push_back(0.3 + i + real(0.0, 0.9));
        }
        p.atmosphereModel = code({1, 2, 3, 4, 5, 6});
        p.baseWavelengthMin_um = real(0.2, 10.0);
        p.baseWavelengthMax_um = real(10.0, 40.0);
        p.cloudModel = code({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 18, 19});
        p.cloudBaseAltitude_m = code({0, 1}) ? -1.0 : real(0.0, 9e3);
        p.cloudThickness_m = code({0, 1}) ? 0.0 : real(1.0, 9e3);
        p.cloudExtinction_per_m = code({0, 1}) ? 0.0 : real(1e-6, 1.0);
        p.groundTemperature_C = real(-60.0, 60.0);
        p.irradianceMode = code({1, 2});
        p.measurementHeight_m = real(2.0, 40.0);
        p.meteoModel = code({1, 2});
        p.pressureMH_mbar = real(800.0, 1200.0);
        p.relativeHumidityMH_percent = real(0.0, 100.0);
        p.resolution_per_cm = code({1, 5, 15});
        p.scatteringMode = p.cloudModel == 0 ? code({1, 2}) : 2;
        p.temperatureALT0_C = real(0.0, 30.0);
        p.temperatureMH_C = p.temperatureALT0_C + real(-9.9, 9.9);
        p.visibility_m = code({0, 1}) ? 0.0 : real(10.0, 300e3);
        p.windDirection_rad = real(0.0, 6.28);
        p.windSpeed_m_s = real(0.1, 30.0);
        p.windSpeedAverage24_m_s = real(0.1, 30.0);
        p.windSpeedMeasurementHeight_m = real(2.0, 40.0);
        p.co2_ppmv = code({0, 1}) ? 400.0 : real(0.0, 1000.0);
        const KarmaXml document = toKarma(p, "trial " + std::to_string(trial));
        const SmartReading again = fromKarma(KarmaXml::parse(document.text(), "again.xml"));
        ASSERT_EQ(again.parameters, p) << document.text();
    }
}

TEST(AtmosphereSmartParameters, TheManualListsThemAsTheyAre) {
    const std::string manual =
        contentOf(std::filesystem::path(SMAT_SOURCE_DIR) / "docs" / "atmosphere-parameters.md");
    for (const auto table : {smartParameters(), ownSmartParameters()}) {
        for (const SmartParameter& parameter : table) {
            std::string row = "| `";
            row.append(parameter.name).append("` | ").append(parameter.unit).append(" | ");
            row.append(valueText(parameter, {})).append(" | ").append(parameter.range);
            row.append(" | ").append(parameter.help).append(" |\n");
            EXPECT_THAT(manual, HasSubstr(row));
        }
    }
}

TEST(AtmosphereSmartParameters, AreSaidAsText) {
    std::set<std::string> texts;
    for (const SmartParameter& parameter : smartParameters()) {
        texts.insert(std::string(parameter.name) + "=" + valueText(parameter, {}));
    }
    EXPECT_THAT(texts, Contains("CloudBaseAltitude=-1"));
    EXPECT_THAT(texts, Contains("AlbedoWavelengths=1.5 2 2.5 3 3.5 4 5 6 8 10 12 14"));
}

struct BadParameters {
    const char* name;
    std::string inside;
    std::vector<const char*> says;
};
void PrintTo(const BadParameters& row, std::ostream* stream) {
    *stream << row.name;
}

class BadSmartParameters : public testing::TestWithParam<BadParameters> {};

TEST_P(BadSmartParameters, AreRefusedByName) {
    const std::string message = refusalOf([] { readOf(GetParam().inside); });
    EXPECT_THAT(message, HasSubstr("air.xml"));
    for (const char* words : GetParam().says) {
        EXPECT_THAT(message, HasSubstr(words));
    }
}

BadParameters bad(const char* name, const char* parameter, const char* value,
                  std::vector<const char*> says) {
    says.push_back(parameter);
    says.push_back("line 5");
    return {name, numberXml(parameter, value), std::move(says)};
}

INSTANTIATE_TEST_SUITE_P(
    Values, BadSmartParameters,
    testing::Values(
        bad("anAerosolBelowAll", "AerosolModel", "-1", {"found -1", "0 to 7"}),
        bad("anAerosolAboveAll", "AerosolModel", "8", {"found 8", "0 to 7"}),
        bad("halfAnAerosol", "AerosolModel", "0.5", {"found 0.5", "a whole number: 0 to 7"}),
        bad("anAerosolBeyondIntegers", "AerosolModel", "1e300", {"a whole number"}),
        bad("noAirMass", "AirMass", "0", {"1 to 10"}),
        bad("anAirMassAboveAll", "AirMass", "11", {"1 to 10"}),
        bad("atmosphereZero", "AtmosphereModel", "0", {"1 to 6"}),
        bad("atmosphereSeven", "AtmosphereModel", "7", {"1 to 6"}),
        bad("aBandFromBelowTheRange", "BaseWavelengthMin", "0.1", {"0.1 um", "0.2 to 40 um"}),
        bad("aBandToAboveTheRange", "BaseWavelengthMax", "41", {"41 um", "0.2 to 40 um"}),
        bad("aBandInNanometres", "BaseWavelengthMin", "3000", {"3000 um"}),
        bad("aCloudBaseAboveTheWeather", "CloudBaseAltitude", "30000", {"30000 m", "20000"}),
        bad("aCloudExtinctionPerKilometre", "CloudExtinction", "92", {"92 m-1", "not km-1"}),
        bad("cloudEleven", "CloudModel", "11", {"0 to 10, 18 or 19"}),
        bad("cloudSeventeen", "CloudModel", "17", {"0 to 10, 18 or 19"}),
        bad("aCloudOfHalfAMetre", "CloudThickness", "0.5", {"0.5 m", "1 to 20000 m"}),
        bad("groundInKelvin", "GroundTemperature", "293.15", {"293.15 C", "-100 to 100 C"}),
        bad("groundBelowAbsoluteZero", "GroundTemperature", "-300", {"-300 C"}),
        bad("irradianceModeThree", "IrradianceMode", "3", {"1 or 2"}),
        bad("aMeasurementOnTheGround", "MeasurementHeight", "0", {"0 m", "2 to 40 m"}),
        bad("aMeasurementFromAMast", "MeasurementHeight", "100", {"100 m", "2 to 40 m"}),
        bad("meteoModelZero", "MeteoModel", "0", {"1 or 2"}),
        bad("pressureInPascal", "PressureMH", "101325", {"101325 mbar", "800 to 1200 mbar"}),
        bad("pressureOfAMountain", "PressureMH", "700", {"800 to 1200 mbar"}),
        bad("humidityAboveAll", "RelativeHumidityMH", "101", {"101 %", "0 to 100 %"}),
        bad("humidityBelowZero", "RelativeHumidityMH", "-1", {"0 to 100 %"}),
        bad("resolutionTen", "Resolution", "10", {"10 cm-1", "1, 5 or 15 cm-1"}),
        bad("resolutionBetweenIntegers", "Resolution", "1.5", {"a whole number"}),
        bad("scatteringModeZero", "ScatteringMode", "0", {"1 or 2"}),
        bad("airAtZeroTooCold", "TemperatureALT0", "-51", {"-51 C", "-50 to 50 C"}),
        bad("airAtZeroTooWarm", "TemperatureALT0", "51", {"-50 to 50 C"}),
        bad("measuredAirTooCold", "TemperatureMH", "-41", {"-40 to 40 C"}),
        bad("measuredAirInKelvin", "TemperatureMH", "293", {"293 C", "-40 to 40 C"}),
        bad("visibilityBelowZero", "Visibility", "-1", {"-1 m", "10 to 300000 m"}),
        bad("visibilityInKilometres", "Visibility", "5", {"5 m", "10 to 300000 m"}),
        bad("visibilityBeyondAll", "Visibility", "1e9", {"10 to 300000 m"}),
        bad("windDirectionInDegrees", "WindDirection", "270", {"270 rad", "2 pi"}),
        bad("noWind", "WindSpeed", "0", {"0 m/s", "0.1 to 30 m/s"}),
        bad("aStormAllDay", "WindSpeedAverage24", "31", {"31 m/s"}),
        bad("windMeasuredTooHigh", "WindSpeedMeasurementHeight", "50", {"50 m", "2 to 40 m"}),
        bad("carbonDioxideBelowZero", "Co2_ppmv", "-1", {"-1 ppmv"}),
        bad("methaneBeyondAll", "Ch4_ppmv", "20000", {"20000 ppmv", "0 to 10000 ppmv"}),
        bad("nitrousOxideBeyondAll", "N2o_ppmv", "10001", {"0 to 10000 ppmv"}),
        bad("aGroundBelowTheSea", "GroundAltitude", "-1", {"-1 m", "0 to 5000 m"}),
        bad("aGroundAboveTheAlps", "GroundAltitude", "5001", {"5001 m", "0 to 5000 m"}),
        bad("ozoneBelowZero", "OzoneScale", "-0.1", {"-0.1", "0 to 100"}),
        bad("ozoneBeyondAll", "OzoneScale", "101", {"0 to 100"}),
        bad("waterBelowZero", "WaterScale", "-1", {"-1", "0 to 100"}),
        bad("waterBeyondAll", "WaterScale", "1e3", {"0 to 100"}),
        bad("aerosolsNeitherOnNorOff", "Aerosols", "2", {"0 or 1"}),
        bad("aerosolsHalf", "Aerosols", "0.5", {"0.5"}),
        bad("aNumberThatIsNone", "Visibility", "nan", {"'nan'", "a finite number"}),
        BadParameters{"anotherModelType",
                      "<parameter name=\"ModelType\"><entityType>OTHER</entityType></parameter>",
                      {"ModelType", "'OTHER'", "SMART_ATMOSPHERIC_MODEL"}},
        BadParameters{"aModelTypeThatIsANumber",
                      numberXml("ModelType", "1"),
                      {"ModelType", "a double", "a entityType"}},
        BadParameters{"aVectorInPlaceOfANumber",
                      vectorXml("Visibility", "1 2"),
                      {"line 5, parameter Visibility", "a vector", "a double"}},
        BadParameters{"aNumberInPlaceOfAVector",
                      numberXml("AlbedoValues", "0.2"),
                      {"line 5, parameter AlbedoValues", "a double", "a vector"}},
        BadParameters{"anEmptyBand",
                      numberXml("BaseWavelengthMin", "5") + numberXml("BaseWavelengthMax", "5"),
                      {"BaseWavelengthMin", "less than BaseWavelengthMax, 5 um"}},
        BadParameters{"aBandThatRunsBackwards",
                      numberXml("BaseWavelengthMin", "12") + numberXml("BaseWavelengthMax", "8"),
                      {"12 um", "less than BaseWavelengthMax, 8 um"}},
        BadParameters{"aBandThatAgreesWithNoDefault",
                      numberXml("BaseWavelengthMin", "8"),
                      {"8 um", "less than BaseWavelengthMax, 5 um"}},
        BadParameters{"albedosOfDifferentNumber",
                      vectorXml("AlbedoValues", "0.1 0.2") +
                          vectorXml("AlbedoWavelengths", "3 4 5"),
                      {"AlbedoValues", "2 numbers", "as many as AlbedoWavelengths, 3"}},
        BadParameters{"albedoWavelengthsThatFall",
                      vectorXml("AlbedoValues", "0.1 0.2 0.3") +
                          vectorXml("AlbedoWavelengths", "3 5 4"),
                      {"AlbedoWavelengths", "4 um after 5 um", "ascend"}},
        BadParameters{"albedoWavelengthsThatRepeat",
                      vectorXml("AlbedoValues", "0.1 0.2") + vectorXml("AlbedoWavelengths", "3 3"),
                      {"3 um after 3 um"}},
        BadParameters{"anAlbedoAboveOne",
                      vectorXml("AlbedoValues", "0.1 1.1") + vectorXml("AlbedoWavelengths", "3 4"),
                      {"AlbedoValues", "found 1.1", "0 to 1"}},
        BadParameters{"anAlbedoBelowZero",
                      vectorXml("AlbedoValues", "-0.1 1") + vectorXml("AlbedoWavelengths", "3 4"),
                      {"AlbedoValues", "found -0.1"}},
        BadParameters{"albedoWavelengthsOfZero",
                      vectorXml("AlbedoValues", "0.1 1") + vectorXml("AlbedoWavelengths", "0 4"),
                      {"AlbedoWavelengths", "0 um"}},
        BadParameters{"noAlbedoAtAll",
                      "<parameter name=\"AlbedoValues\"><vector/></parameter>"
                      "<parameter name=\"AlbedoWavelengths\"><vector/></parameter>",
                      {"AlbedoWavelengths", "no numbers"}},
        BadParameters{
            "singleScatteringInACloud",
            numberXml("ScatteringMode", "1") + numberXml("CloudModel", "3"),
            {"line 5, parameter ScatteringMode", "1 with CloudModel 3", "more than once"}},
        BadParameters{"measuredTemperaturesTooFarApart",
                      numberXml("MeteoModel", "2") + numberXml("TemperatureMH", "5") +
                          numberXml("TemperatureALT0", "15.1"),
                      {"line 6, parameter TemperatureMH", "5 C", "TemperatureALT0, 15.1 C"}},
        BadParameters{"aMeasuredTemperatureFarFromADefault",
                      numberXml("MeteoModel", "2") + numberXml("TemperatureMH", "31"),
                      {"31 C", "TemperatureALT0, 20 C"}},
        BadParameters{"aCloudThatReachesTheStratosphere",
                      numberXml("CloudModel", "1") + numberXml("CloudBaseAltitude", "15000") +
                          numberXml("CloudThickness", "8000"),
                      {"CloudThickness", "23000 m", "20000 m"}},
        BadParameters{"severalFaultsAtOnce",
                      numberXml("Resolution", "2") + numberXml("WindSpeed", "99") +
                          numberXml("AirMass", "2.5"),
                      {"line 5, parameter Resolution", "line 6, parameter WindSpeed",
                       "line 7, parameter AirMass"}}),
    [](const auto& row) { return row.param.name; });

TEST(AtmosphereSmartParameters, AFileOfAnotherTypeIsRefused) {
    const KarmaXml document("/Environment/Root/Environment", "");
    EXPECT_THAT(refusalOf([&] { fromKarma(document); }), HasSubstr("/AtmosphereSmart"));
}

} // namespace
} // namespace irsg

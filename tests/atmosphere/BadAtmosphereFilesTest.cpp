#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "tests/atmosphere/SyntheticTape7.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

/// A file of air as people get it wrong, and all that they are told: position, value, what was
/// expected.
struct Bad {
    const char* name;
    const char* file; ///< "ascent.csv" is that of an AtmosphereSmart
    std::string text;
    const char* says;
};
void PrintTo(const Bad& row, std::ostream* out) {
    *out << row.name;
}

std::string smart(const std::string& parameters) {
    return "<?xml version=\"1.0\"?>\n<data>\n<fileType>Parameters</fileType>\n"
           "<type>/AtmosphereSmart/Root/Atmosphere/AtmosphereSmart</type>\n" +
           parameters + "\n</data>\n";
}
const std::string haze = "wavelength [um],extinction [km-1]\n";
const std::string ascent = "altitude [m],pressure [hPa],temperature [K],relative_humidity [%]\n";

class BadAtmosphereFiles : public testing::TestWithParam<Bad> {};

} // namespace

TEST_P(BadAtmosphereFiles, AreRefusedByFilePositionValueAndWhatWasExpected) {
    const Bad& bad = GetParam();
    const auto folder = smat::test::ownFolder();
    auto file = smat::test::writtenFile(folder / bad.file, bad.text);
    if (bad.file == std::string("ascent.csv")) {
        file = smat::test::writtenFile(folder / "air.xml",
                                       smart("<parameter name=\"Radiosonde\"><string>ascent.csv"
                                             "</string></parameter>"));
    }
    const std::string said = smat::test::refusalOf([&] { loadAtmosphere(file); });
    EXPECT_THAT(said, HasSubstr(std::string(bad.file) + ": " + bad.says));
}

INSTANTIATE_TEST_SUITE_P(
    Air, BadAtmosphereFiles,
    testing::Values(
        Bad{"xmlValueIsWord", "bad.xml",
            smart("<parameter name=\"Visibility\"><double>23 km</double></parameter>"),
            "line 5, parameter Visibility: found '23 km', expected a finite number"},
        Bad{"xmlCommaDecimal", "bad.xml",
            smart("<parameter name=\"Visibility\"><double>23,5</double></parameter>"),
            "line 5, parameter Visibility: found '23,5', expected a finite number"},
        Bad{"xmlEmptyValue", "bad.xml",
            smart("<parameter name=\"Visibility\"><double></double></parameter>"),
            "line 5, parameter Visibility: found nothing, expected a finite number"},
        Bad{"xmlHex", "bad.xml",
            smart("<parameter name=\"Visibility\"><double>0x10</double></parameter>"),
            "line 5, parameter Visibility: found '0x10', expected a finite number"},
        Bad{"xmlInf", "bad.xml",
            smart("<parameter name=\"Visibility\"><double>inf</double></parameter>"),
            "line 5, parameter Visibility: found 'inf', expected a finite number"},
        Bad{"xmlNan", "bad.xml",
            smart("<parameter name=\"GroundTemperature\"><double>nan</double></parameter>"),
            "line 5, parameter GroundTemperature: found 'nan', expected a finite number"},
        Bad{"xmlTwice", "bad.xml",
            smart("<parameter name=\"Visibility\"><double>500</double></parameter>\n<parameter "
                  "name=\"Visibility\"><double>600</double></parameter>"),
            "line 6, parameter Visibility: found the same name again, expected each parameter "
            "once, not again after line 5"},
        Bad{"xmlNoName", "bad.xml", smart("<parameter><double>5</double></parameter>"),
            "line 5, parameter: found no name, expected the attribute name=\"...\""},
        Bad{"xmlNoValue", "bad.xml", smart("<parameter name=\"Visibility\"></parameter>"),
            "line 5, parameter Visibility: found no value, expected one value: double, vector, "
            "vector3, entityType or string"},
        Bad{"xmlTwoValues", "bad.xml",
            smart("<parameter "
                  "name=\"Visibility\"><double>500</double><double>600</double></parameter>"),
            "line 5, parameter Visibility: found 2 values, expected one value: double, vector, "
            "vector3, entityType or string"},
        Bad{"xmlVectorForNumber", "bad.xml",
            smart(
                "<parameter name=\"Visibility\"><vector><double>500</double></vector></parameter>"),
            "line 5, parameter Visibility: found a vector, expected a double"},
        Bad{"xmlNumberForVector", "bad.xml",
            smart("<parameter name=\"AlbedoValues\"><double>0.1</double></parameter>"),
            "line 5, parameter AlbedoValues: found a double, expected a vector"},
        Bad{"xmlStringForNumber", "bad.xml",
            smart("<parameter name=\"Visibility\"><string>500</string></parameter>"),
            "line 5, parameter Visibility: found a string, expected a double"},
        Bad{"xmlAlbedoWord", "bad.xml",
            smart("<parameter "
                  "name=\"AlbedoValues\"><vector><double>0.1</double><double>x</double></vector></"
                  "parameter>"),
            "line 5, parameter AlbedoValues: found 'x', expected a finite number"},
        Bad{"xmlUnclosed", "bad.xml",
            "<?xml "
            "version=\"1.0\"?>\n<data>\n<fileType>Parameters</fileType>\n<type>/AtmosphereSmart/"
            "Root/Atmosphere/AtmosphereSmart</type>\n<parameter "
            "name=\"Visibility\"><double>500</double></parameter>",
            "line 5: found Start-end tags mismatch, expected well-formed XML"},
        Bad{"xmlWrongClose", "bad.xml",
            smart("<parameter name=\"Visibility\"><double>500</parameter></double>"),
            "line 5: found Start-end tags mismatch, expected well-formed XML"},
        Bad{"xmlOtherType", "bad.xml",
            "<?xml "
            "version=\"1.0\"?>\n<data>\n<fileType>Parameters</fileType>\n<type>/Sea/Root/Sea</"
            "type>\n\n</data>\n",
            "type: found '/Sea/Root/Sea', expected a type that ends in /AtmosphereSmart or "
            "/AtmosphereScatteringLUT"},
        Bad{"xmlNoType", "bad.xml", "<data>\n<fileType>Parameters</fileType>\n</data>\n",
            "type: found no type, expected a type that ends in /AtmosphereSmart or "
            "/AtmosphereScatteringLUT"},
        Bad{"xmlEntity", "bad.xml",
            smart("<parameter name=\"Visibility\"><double>&big;</double></parameter>"),
            "line 5, parameter Visibility: found '&big;', expected a finite number"},
        Bad{"xmlCloudTop", "bad.xml",
            smart("<parameter name=\"CloudModel\"><double>1</double></parameter>\n<parameter "
                  "name=\"CloudBaseAltitude\"><double>19000</double></parameter><parameter "
                  "name=\"CloudThickness\"><double>2000</double></parameter>"),
            "line 6, parameter CloudThickness: found a top at 21000 m, expected base and thickness "
            "together up to 20000 m"},
        Bad{"xmlModelType", "bad.xml",
            smart("<parameter name=\"ModelType\"><entityType>OTHER_MODEL</entityType></parameter>"),
            "line 5, parameter ModelType: found 'OTHER_MODEL', expected SMART_ATMOSPHERIC_MODEL"},
        Bad{"xmlRadiosondeMissing", "bad.xml",
            smart("<parameter name=\"Radiosonde\"><string>nowhere.csv</string></parameter>"),
            "parameter Radiosonde: found 'nowhere.csv', expected a file that is there"},
        Bad{"xmlRadiosondeFolder", "bad.xml",
            smart("<parameter name=\"Radiosonde\"><string>.</string></parameter>"),
            "parameter Radiosonde: found '.', expected a file that is there"},
        Bad{"hazeTwoDecimalSigns", "bad.csv", "wavelength [um];extinction [km-1]\n3;0.1\n5;0,1\n",
            "line 3, column 2: found '0,1', expected a number of at least 0"},
        Bad{"hazeDecimalComma", "bad.csv", haze + "3,0,1\n5,0,1\n",
            "line 2: found '3 cells', expected 2 cells as in the header"},
        Bad{"hazeElectronvolts", "bad.csv", "energy [eV],extinction [km-1]\n3000,0.1\n5000,0.1\n",
            "line 1, column 1: found 'energy [eV]', expected one of 'wavelength [um]'"},
        Bad{"hazeExponent", "bad.csv", haze + "3,1e999\n5,0.1\n",
            "line 2, column 2: found '1e999', expected a number of at least 0"},
        Bad{"hazeUnitInCell", "bad.csv", haze + "3,0.1 km-1\n5,0.1\n",
            "line 2, column 2: found '0.1 km-1', expected a number of at least 0"},
        Bad{"hazeTemperatureTwice", "bad.csv",
            "# air_temperature [K]: 288\n# air_temperature [K]: 289\nwavelength [um],extinction "
            "[km-1]\n3,1\n5,1\n",
            "line 2: found 'air_temperature [K]', expected this key once, not again after line 1"},
        Bad{"tableWord", "bad.smatatm",
            "{\"format\": \"smat tabulated atmosphere\", \"version\": \"one\"}",
            "format: found \"smat tabulated atmosphere\", expected \"irsg tabulated atmosphere\""},
        Bad{"tableOtherFormat", "bad.smatatm", "{\"format\": \"picture\", \"version\": 1}",
            "format: found \"picture\", expected \"irsg tabulated atmosphere\""},
        Bad{"tableEmpty", "bad.smatatm", "",
            "line 1, column 1: found the end of the text, expected a tabulated atmosphere (JSON)"},
        Bad{"tableArray", "bad.smatatm", "[]",
            "found [], expected a tabulated atmosphere (a JSON object)"},
        Bad{"tableCut", "bad.smatatm", "{\"format\": \"smat",
            "line 1, column 17: found the end of the text, expected a tabulated atmosphere (JSON)"},
        Bad{"noKind", "bad.xyz", "hello\n",
            "found no atmosphere of a kind that is known, expected .xml of AtmosphereSmart, .xml "
            "of AtmosphereScatteringLUT, .csv of a radiative output, .smatatm, "},
        Bad{"empty", "bad.json", "",
            "found no atmosphere of a kind that is known, expected .xml of AtmosphereSmart, .xml "
            "of AtmosphereScatteringLUT, .csv of a radiative output, .smatatm, "},
        Bad{"zero", "bad.tp7", std::string(3, '\0'),
            "byte 0: found a NUL byte, expected text, not binary data"},
        Bad{"tapeModel", "bad.tp7", replaced(tape7({}), "T F 6", "T F ?"),
            "line 1: found '?', expected a number for MODEL in columns 5 to 5"},
        Bad{"tapeGround", "bad.tp7",
            replaced(tape7({}), "0.00000   0.00000   0.00000   0.00000\n",
                     "0.00000   0.00000   0.00000   deep   \n"),
            "line 2: found 'deep', expected a number for GNDALT in columns 71 to 80"},
        Bad{"tapeStep", "bad.tp7", replaced(tape7({}), "      10.0", "      ten."),
            "line 9: found 'ten.', expected a number for DV in columns 21 to 30"},
        Bad{"tapeWidth", "bad.tp7", replaced(tape7({}), "      20.0NW", "      2,0.NW"),
            "line 9: found '2,0.', expected a number for FWHM in columns 31 to 40"},
        Bad{"tapeZenith", "bad.tp7",
            replaced(tape7({}), "  90.00000   1.00000", "  9o.00000   1.00000"),
            "line 6: found '9o.00000', expected a number for ANGLE in columns 21 to 30"},
        Bad{"tapeAxisStars", "bad.tp7", replaced(tape7({}), " 2010.00 0.9", "******** 0.9"),
            "line 13: found '********', expected a number for FREQ"},
        Bad{"ascentDecimalComma", "ascent.csv", ascent + "0,1013,288,15,50\n1000,899,281,50\n",
            "line 2: found '5 cells', expected 4 cells as in the header"},
        Bad{"ascentUnit", "ascent.csv", ascent + "0,1013 hPa,288,50\n1000,899,281,50\n",
            "line 2, column 2: found '1013 hPa', expected 1e-06 to 1200 hPa"},
        Bad{"ascentMissing", "ascent.csv", ascent + "0,1013,,50\n1000,899,281,50\n",
            "line 2, column 3: found nothing, expected 100 to 400 K"},
        Bad{"ascentOfOneRow", "ascent.csv",
            "altitude [m]\tpressure [hPa]\ttemperature [K]\trelative_humidity "
            "[%]\n0\t1013\t288\t50\n",
            "found 1 rows of numbers, expected at least two"},
        Bad{"ascentPressureZero", "ascent.csv", ascent + "0,0,288,50\n1000,899,281,50\n",
            "line 2, column 2: found '0', expected 1e-06 to 1200 hPa"},
        Bad{"ascentAltitudeInf", "ascent.csv", ascent + "0,1013,288,50\ninf,899,281,50\n",
            "line 3, column 1: found 'inf', expected 0 to 120000 m"},
        Bad{"ascentTooHigh", "ascent.csv", ascent + "0,1013,288,50\n130000,0.001,281,50\n",
            "line 3, column 1: found '130000', expected 0 to 120000 m"},
        Bad{"ascentGroundWord", "ascent.csv", ascent + "ground,1013,288,50\n1000,899,281,50\n",
            "line 2, column 1: found 'ground', expected 0 to 120000 m"}),
    [](const auto& row) { return std::string(row.param.name); });

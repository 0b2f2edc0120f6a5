#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

const SpectralRange mwir{3.0, 5.0};
const SunPosition noon{0.0, 1.0};

BeerLambert atmosphereOf(const std::string& text, const std::string& fileName = "air.csv") {
    return BeerLambert::fromCsv(smat::test::writtenFile(smat::test::ownFolder() / fileName, text));
}

} // namespace

TEST(BeerLambertCsv, ReadsEverythingAFileMayHold) {
    const BeerLambert air = atmosphereOf("# name: All of it\r\n"
                                         "# Written by hand: a test.\r\n"
                                         "# air_temperature [K]: 280\r\n"
                                         "# ground_temperature [K]: 290\r\n"
                                         "# note: one\r\n"
                                         "# note: two\r\n"
                                         "sky_radiance [W m-2 sr-1 um-1],wavelength [um],"
                                         "extinction [km-1],solar_irradiance [W m-2 um-1],"
                                         "down_flux [W m-2 um-1],up_flux [W m-2 um-1]\r\n"
                                         "0.5,3,2,10,1,3\r\n"
                                         "0.7,5,4,20,2,5\r\n");
    EXPECT_EQ(air.name(), "All of it");
    EXPECT_EQ(air.base(), mwir);
    EXPECT_EQ(air.ambientTemperature_K(0.0), 280.0);
    EXPECT_EQ(air.parameters().groundTemperature_K, 290.0);
    EXPECT_DOUBLE_EQ(air.parameters().extinction_per_m.at(4.0), 3e-3);
    EXPECT_DOUBLE_EQ(air.solarIrradiance(0.0, noon, mwir).at(4.0), 15.0);
    EXPECT_DOUBLE_EQ(air.downwardFlux(0.0, noon, mwir).at(4.0), 1.5);
    EXPECT_DOUBLE_EQ(air.upwardFlux(0.0, noon, mwir).at(4.0), 4.0);
    EXPECT_DOUBLE_EQ(air.parameters().skyRadiance_W_m2_sr_um->at(4.0), 0.6);
}

TEST(BeerLambertCsv, FillsWhatIsMissingFromItsTemperatures) {
    const BeerLambert air = atmosphereOf("# air_temperature [K]: 280\n"
                                         "# sky_temperature [K]: 250\n"
                                         "wavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n",
                                         "plain.csv");
    EXPECT_EQ(air.name(), "Beer-Lambert (plain.csv)");
    EXPECT_EQ(air.parameters().groundTemperature_K, 280.0);
    for (const double x : {3.0, 3.7, 4.9}) {
        const double down = pi * planckRadiance_W_m2_sr_um(x, 250.0);
        const double up = pi * planckRadiance_W_m2_sr_um(x, 280.0);
        EXPECT_NEAR(air.downwardFlux(0.0, noon, mwir).at(x) / down, 1.0, 1e-6);
        EXPECT_NEAR(air.upwardFlux(0.0, noon, mwir).at(x) / up, 1.0, 1e-6);
        EXPECT_NEAR(air.parameters().skyRadiance_W_m2_sr_um->at(x) * pi / down, 1.0, 1e-6);
        EXPECT_NEAR(air.solarIrradiance(0.0, noon, mwir).at(x) /
                        extraterrestrialSolarIrradiance(mwir).at(x),
                    1.0, 1e-12);
    }
    const BeerLambert bare = atmosphereOf("wavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n");
    EXPECT_EQ(bare.ambientTemperature_K(0.0), 288.15);
    EXPECT_FALSE(bare.parameters().skyRadiance_W_m2_sr_um);
    const double down = pi * planckRadiance_W_m2_sr_um(4.0, 288.15);
    EXPECT_NEAR(bare.downwardFlux(0.0, noon, mwir).at(4.0) / down, 1.0, 1e-6);
}

TEST(BeerLambertCsv, SaysTheTemperatureThatIsNotGivenAndThoseOfNoAir) {
    const std::string table = "wavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n";
    const auto remarksOn = [&](const std::string& head) {
        const CollectedRemarks remarks;
        atmosphereOf(head + table);
        return testing::PrintToString(remarks.sentences());
    };
    EXPECT_THAT(remarksOn(""), HasSubstr("has no 'air_temperature [K]': the air has 288.15 K"));
    EXPECT_THAT(remarksOn("# air_temperature [K]: 17\n"),
                HasSubstr("line 1: air_temperature [K] is 17 K, below 100 K"));
    EXPECT_THAT(remarksOn("# air_temperature [K]: 280\n# ground_temperature [K]: 12\n"),
                HasSubstr("line 2: ground_temperature [K] is 12 K"));
    for (const char* sound : {"0", "100", "280"}) {
        EXPECT_EQ(remarksOn("# air_temperature [K]: " + std::string(sound) + "\n"), "{}");
    }
}

TEST(BeerLambertCsv, TakesAnEqualsSignForAColon) {
    const std::string table = "wavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n";
    const BeerLambert air = atmosphereOf("# air_temperature [K] = 290\n# name = a haze: thin\n"
                                         "# extinction = 3.912 / V\n# sun=none\n" +
                                         table);
    EXPECT_EQ(air.ambientTemperature_K(0.0), 290.0);
    EXPECT_EQ(air.name(), "a haze: thin");
    EXPECT_EQ(air.solarIrradiance(0.0, noon, mwir).at(4.0), 0.0);
    EXPECT_THROW(atmosphereOf("# air_temprature [K] = 290\n" + table), InputError);
    EXPECT_EQ(atmosphereOf("# name: a = b\n" + table).name(), "a = b");
}

TEST(BeerLambertCsv, ExtinctionPerMetreAndWordsOfOtherLanguagesGiveOneAir) {
    const auto expected =
        atmosphereOf("# air_temperature [K]: 280\nwavelength [um],extinction [km-1]\n"
                     "3,0.125\n5,0.25\n")
            .parameters();
    for (const char* text :
         {"# air_temperature [K]: 280\nwavelength [um],extinction [m-1]\n3,0.000125\n5,0.00025\n",
          "# Lufttemperatur [K]: 280\nWellenl\u00e4nge [\u00b5m];Extinktionskoeffizient [1/m]\n"
          "3;0,000125\n5;0,00025\n",
          "# Temp\u00e9rature de l'air (K): 280\nlongueur d'onde (nm);coefficient d'extinction "
          "(km\u207b\u00b9)\n3000;0,125\n5000;0,25\n",
          "# Air temperature in K: 280\nk [per km],\u00c5\n0.125,30000\n0.25,50000\n"}) {
        const auto air = atmosphereOf(text).parameters();
        EXPECT_EQ(air.extinction_per_m.wavelengths_um(), expected.extinction_per_m.wavelengths_um())
            << text;
        for (const double wavelength_um : {3.0, 5.0}) {
            EXPECT_NEAR(air.extinction_per_m.at(wavelength_um),
                        expected.extinction_per_m.at(wavelength_um), 1e-18)
                << text;
        }
        EXPECT_EQ(air.airTemperature_K, 280.0) << text;
    }
}

TEST(BeerLambertCsv, TheSunCanBeSwitchedOff) {
    const BeerLambert air =
        atmosphereOf("# sun: none\nwavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n");
    EXPECT_EQ(air.solarIrradiance(0.0, noon, mwir), Spectrum::constant(0.0));
}

TEST(BeerLambertCsv, TheSampleHazeIsReadAndBehavesLikeOne) {
    const BeerLambert haze =
        BeerLambert::fromCsv(SMAT_SOURCE_DIR "/resources/atmospheres/haze-23km.csv");
    EXPECT_EQ(haze.name(), "Haze 23 km (sample)");
    EXPECT_EQ(haze.base(), (SpectralRange{0.3, 15.0}));
    const AtmosphericPath fiveKilometres{0.0, 0.0, 5000.0};
    const Spectrum tau = haze.transmittance(fiveKilometres, mwir);
    EXPECT_LT(tau.at(4.26), 1e-30);
    EXPECT_GT(tau.at(3.8), 0.8);
    // Koschmieder: contrast 0.02 at the visibility, through the aerosol alone.
    EXPECT_NEAR(haze.transmittance({0.0, 0.0, 23000.0}, {0.5, 0.6}).at(0.55), 0.02, 0.001);
    for (const SpectralRange& range : {mwir, SpectralRange{8.0, 12.0}, SpectralRange{0.3, 15.0}}) {
        const auto nodes = haze.transmittance(fiveKilometres, range).size();
        const auto pathNodes = haze.pathRadiance(fiveKilometres, noon, range).size();
        EXPECT_LT(nodes, 200000u);
        std::printf("haze-23km, 5 km, %g-%g um: %zu nodes of transmittance, %zu of path radiance\n",
                    range.min_um, range.max_um, nodes, pathNodes);
    }
}

TEST(BeerLambertCsv, AxesOfEveryHeadAndDirectionGiveOneAir) {
    const Spectrum expected =
        atmosphereOf("wavelength [um],extinction [km-1]\n2.5,0.1\n4,0.3\n12.5,0.2\n")
            .parameters()
            .extinction_per_m;
    for (const char* text : {"um,extinction [km-1]\n2.5,0.1\n4,0.3\n12.5,0.2\n",
                             "wavelength [nm],extinction [km-1]\n2500,0.1\n4000,0.3\n12500,0.2\n",
                             "wavenumber [cm-1],extinction [km-1]\n4000,0.1\n2500,0.3\n800,0.2\n",
                             "Wavelength (um);extinction [km-1]\n12,5;0,2\n4;0,3\n2,5;0,1\n"}) {
        const Spectrum read = atmosphereOf(text).parameters().extinction_per_m;
        for (const double wavelength_um : {2.5, 3.0, 4.0, 10.0, 12.5}) {
            EXPECT_NEAR(read.at(wavelength_um), expected.at(wavelength_um), 1e-15) << text;
        }
    }
}

namespace {

struct BadFile {
    const char* name;
    std::string text;
    const char* message; ///< what stands behind "FILE: "
};
void PrintTo(const BadFile& row, std::ostream* out) {
    *out << row.name;
}

class BeerLambertCsvRefuses : public testing::TestWithParam<BadFile> {};

const std::string header = "wavelength [um],extinction [km-1]\n";
const std::string good = header + "3,0.1\n5,0.1\n";

} // namespace

TEST_P(BeerLambertCsvRefuses, WithFileLineValueAndExpectation) {
    const std::filesystem::path path =
        smat::test::writtenFile(smat::test::ownFolder() / "bad.csv", GetParam().text);
    try {
        BeerLambert::fromCsv(path);
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(path.string() + ": " + GetParam().message));
        for (const Diagnostic& diagnostic : error.diagnostics()) {
            EXPECT_FALSE(diagnostic.value.empty());
            EXPECT_FALSE(diagnostic.expected.empty());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Of, BeerLambertCsvRefuses,
    testing::Values(
        BadFile{"empty", "", "found no rows, expected a header"},
        BadFile{"headerOnly", header, "found 0 rows of numbers, expected at least two"},
        BadFile{"oneRow", header + "3,0.1\n", "found 1 rows of numbers"},
        BadFile{"noExtinction", "wavelength [um],up_flux [W m-2 um-1]\n3,1\n5,1\n",
                "line 1: found 'wavelength [um]', expected a column 'extinction [km-1]'"},
        BadFile{"noWavelength", "extinction [km-1]\n1\n2\n",
                "line 1: found 'extinction [km-1]', expected a column 'wavelength [um]'"},
        BadFile{"extinctionPerMegametre", "wavelength [um],extinction [Mm-1]\n3,1\n5,1\n",
                "line 1, column 2: found 'extinction [Mm-1]', expected one of"},
        BadFile{"columnTwice",
                "wavelength [um],extinction [km-1],extinction [km-1]\n3,1,1\n5,1,1\n",
                "line 1, column 3: found 'extinction [km-1]', expected each column once"},
        BadFile{"noHeaderAtAll", "3,0.1\n4,0.1\n5,0.1\n", "line 1, column 1: found '3'"},
        BadFile{"shortRow", header + "3,0.1\n4\n5,0.1\n",
                "line 3: found '1 cells', expected 2 cells"},
        BadFile{"longRow", header + "3,0.1\n4,0.1,7\n5,0.1\n", "line 3: found '3 cells'"},
        BadFile{"word", header + "3,thick\n5,0.1\n", "line 2, column 2: found 'thick'"},
        BadFile{"emptyCell", header + "3,\n5,0.1\n", "line 2, column 2: found nothing"},
        BadFile{"extinctionNan", header + "3,nan\n5,0.1\n", "line 2, column 2: found 'nan'"},
        BadFile{"extinctionInfinite", header + "3,1\n5,inf\n", "line 3, column 2: found 'inf'"},
        BadFile{"extinctionNegative", header + "3,1\n5,-0.1\n",
                "line 3, column 2: found '-0.1', expected a number of at least 0"},
        BadFile{"wavelengthNegative", header + "-3,1\n5,1\n", "line 2, column 1: found '-3'"},
        BadFile{"wavelengthZero", header + "0,1\n5,1\n", "line 2, column 1: found '0'"},
        BadFile{"turnsBack", header + "5,1\n3,1\n4,1\n",
                "line 4, column 1: found '4', expected an axis that descends strictly"},
        BadFile{"duplicated", header + "3,1\n3,1\n5,1\n", "line 3, column 1: found '3'"},
        BadFile{"fluxNegative",
                "wavelength [um],extinction [km-1],up_flux [W m-2 um-1]\n"
                "3,1,-1\n5,1,1\n",
                "line 2, column 3: found '-1'"},
        BadFile{"airTemperatureWord", "# air_temperature [K]: warm\n" + good,
                "line 1: found 'warm', expected a temperature of at least 0 K"},
        BadFile{"airTemperatureNegative", "# air_temperature [K]: -5\n" + good,
                "line 1: found '-5'"},
        BadFile{"airTemperatureEmpty", "# air_temperature [K]:\n" + good, "line 1: found nothing"},
        BadFile{"celsiusInAnotherLanguage", "# Lufttemperatur [\u00b0C]: 15\n" + good,
                "line 1: found 'Lufttemperatur [\u00b0C]', expected one of"},
        BadFile{"bothUnitsOfExtinction",
                "wavelength [um],extinction [km-1],extinction [m-1]\n3,1,0.001\n5,1,0.001\n",
                "line 1, column 3: found 'extinction [m-1]', expected each column once"},
        BadFile{"extinctionWithoutUnit", "wavelength [um],Extinktion\n3,1\n5,1\n",
                "line 1, column 2: found 'Extinktion', expected one of"},
        BadFile{"celsius", "# air_temperature [C]: 15\n" + good,
                "line 1: found 'air_temperature [C]', expected one of"},
        BadFile{"keyWithoutUnit", "# air_temperature: 288\n" + good,
                "line 1: found 'air_temperature'"},
        BadFile{"misspelledKey", good + "# ground_temprature [K]: 288\n",
                "line 4: found 'ground_temprature [K]'"},
        BadFile{"keyTwice", "# sun: none\n# sun: nominal\n" + good,
                "line 2: found 'sun', expected this key once"},
        BadFile{"unknownSun", "# sun: bright\n" + good, "line 1: found 'bright'"},
        BadFile{"sunGivenTwice",
                "# sun: nominal\nwavelength [um],extinction [km-1],"
                "solar_irradiance [W m-2 um-1]\n3,1,1\n5,1,1\n",
                "line 1: found 'nominal', expected either this key or the column"},
        BadFile{"emptyName", "# name:\n" + good, "line 1: found nothing, expected a name"},
        BadFile{"openQuote", header + "3,\"1\n5,1\n", "line 2: found '3,\"1'"},
        BadFile{"binary", good + std::string("\0\0", 2), "byte 46: found a NUL byte"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(BeerLambertCsv, NamesEveryDiagnosticAtOnce) {
    try {
        atmosphereOf("# air_temperature [K]: x\n# sun: y\n" + header + "3,a\n2,b\n2.5,-1\n");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 6u) << error.what();
    }
}

TEST(BeerLambertCsv, RefusesAFileThatIsNotThere) {
    EXPECT_THROW(BeerLambert::fromCsv("no/such/air.csv"), InputError);
}

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

Profile ascentOf(const std::string& text) {
    const auto file = smat::test::writtenFile(smat::test::ownFolder() / "ascent.csv", text);
    return Profile::fromRadiosonde(file, Profile::model(ModelAtmosphere::usStandard1976));
}

} // namespace

TEST(Radiosonde, ReadsHumidityInThreeForms) {
    const double saturated_hPa = saturationPressure_hPa(288.15);
    const Profile relative =
        ascentOf("altitude [m],pressure [hPa],temperature [K],relative_humidity [%]\n"
                 "0,1013,288.15,50\n1000,899,281,40\n");
    EXPECT_NEAR(relative.at(0.0).fraction(Gas::H2O), 0.5 * saturated_hPa / 1013.0, 1e-12);
    EXPECT_NEAR(relativeHumidity(relative.at(1000.0)), 0.4, 1e-12);

    const Profile dew = ascentOf("dew_point [C],temperature [C],pressure [hPa],altitude [m]\n"
                                 "15,15,1013,0\n-3,8,899,1000\n");
    EXPECT_NEAR(relativeHumidity(dew.at(0.0)), 1.0, 1e-12);
    EXPECT_NEAR(dew.at(1000.0).fraction(Gas::H2O), saturationPressure_hPa(270.15) / 899.0, 1e-12);

    const Profile mixing = ascentOf("altitude [m],pressure [hPa],temperature [K],h2o [ppmv]\n"
                                    "0,1013,288.15,7745\n1000,899,281,6071\n");
    EXPECT_NEAR(mixing.at(0.0).fraction(Gas::H2O), 7745e-6, 1e-15);
}

TEST(Radiosonde, ReadsTablesAsWeatherServicesPrintThem) {
    const std::string rule(77, '-');
    const std::string head = rule +
                             "\n   PRES   HGHT   TEMP   DWPT   RELH   MIXR   DRCT   SKNT   THTA"
                             "   THTE   THTV\n    hPa     m      C      C      %    g/kg    deg"
                             "   knot     K      K      K \n" +
                             rule + "\n";
    const std::string levels = " 1013.0      0   15.0    7.0     59   6.20    100     10  287.1"
                               "  304.6  288.2\n  899.0   1000    8.0   -3.0     46   3.50    110"
                               "     12  289.8  300.4  290.4\n";
    const Profile expected = ascentOf("altitude [m],pressure [hPa],temperature [C],dew_point [C]\n"
                                      "0,1013,15,7\n1000,899,8,-3\n");
    const std::string tails[] = {
        "", "Station information and sounding indices\n\n  Station identifier: ABCD\n"};
    for (const std::string& tail : tails) {
        for (const char* below : {"", " 1030.0   -140\n"}) {
            const CollectedRemarks remarks;
            const Profile air = ascentOf(head + below + levels + tail);
            for (const double altitude_m : {0.0, 400.0, 1000.0, 3000.0}) {
                EXPECT_EQ(air.at(altitude_m).pressure_hPa, expected.at(altitude_m).pressure_hPa);
                EXPECT_EQ(air.at(altitude_m).temperature_K, expected.at(altitude_m).temperature_K);
                EXPECT_EQ(air.at(altitude_m).fraction(Gas::H2O),
                          expected.at(altitude_m).fraction(Gas::H2O));
            }
            const std::string all = testing::PrintToString(remarks.sentences());
            EXPECT_THAT(all, HasSubstr("leaves out 'MIXR [g/kg]', 'DRCT [deg]'"));
            EXPECT_THAT(all, HasSubstr("'RELH [%]'"));
            EXPECT_EQ(all.find("1 levels that lack") != all.npos, *below != '\0') << all;
        }
    }
}

TEST(Radiosonde, SaysWhereHumiditiesAreRatherFractions) {
    const auto remarksOn = [](const char* first, const char* second) {
        const CollectedRemarks remarks;
        ascentOf(
            "altitude [m],pressure [hPa],temperature [K],relative_humidity [%]\n0,1013,288.15," +
            std::string(first) + "\n1000,899,281," + second + "\n");
        return testing::PrintToString(remarks.sentences());
    };
    EXPECT_THAT(remarksOn("0.5", "1"), HasSubstr("no relative humidity is above 1 %: fractions"));
    EXPECT_EQ(remarksOn("50", "0.5"), "{}");
    EXPECT_EQ(remarksOn("0", "0"), "{}");
}

TEST(Radiosonde, TakesOtherGasesWhereTheFileHasThem) {
    const Profile air =
        ascentOf("altitude [m],pressure [hPa],temperature [K],h2o [ppmv],co2 [ppmv],ch4 [ppmv]\n"
                 "0,1013,288.15,7745,500,2.5\n1000,899,281,6071,500,2.5\n");
    EXPECT_NEAR(air.at(500.0).fraction(Gas::CO2), 500e-6, 1e-12);
    EXPECT_NEAR(air.at(500.0).fraction(Gas::CH4), 2.5e-6, 1e-15);
    EXPECT_NEAR(air.at(0.0).fraction(Gas::O3), 0.0266e-6, 1e-15);
}

TEST(Radiosonde, BlendsIntoTheAirAboveOverFiveKilometres) {
    const Profile background = Profile::model(ModelAtmosphere::usStandard1976);
    const Profile air = ascentOf("altitude [m],pressure [hPa],temperature [K],h2o [ppmv]\n"
                                 "0,1020,290,8000\n10000,270,230,80\n");
    EXPECT_EQ(air.top_m(), background.top_m());
    EXPECT_NEAR(air.at(10000.0).temperature_K, 230.0, 1e-9);
    EXPECT_NEAR(air.at(10000.0).pressure_hPa, 270.0, 1e-9);
    EXPECT_NEAR(air.at(12500.0).temperature_K - background.at(12500.0).temperature_K,
                0.5 * (230.0 - background.at(10000.0).temperature_K), 0.05);
    for (const double z : {15000.0, 16000.0, 40000.0, 99000.0}) {
        EXPECT_NEAR(air.at(z).temperature_K, background.at(z).temperature_K, 1e-9);
        EXPECT_NEAR(air.at(z).pressure_hPa / background.at(z).pressure_hPa, 1.0, 1e-9);
    }
    // Between the rows the other gases follow the background.
    EXPECT_NEAR(air.at(5000.0).fraction(Gas::O3) / background.at(5000.0).fraction(Gas::O3), 1.0,
                1e-9);
}

TEST(Radiosonde, ThatStartsAboveTheGroundIsContinuedDown) {
    const Profile air = ascentOf("altitude [m],pressure [hPa],temperature [K],h2o [ppmv]\n"
                                 "100,1001,288,7000\n1000,899,281,6071\n");
    EXPECT_EQ(air.at(0.0).temperature_K, 288.0);
    EXPECT_NEAR(air.at(0.0).fraction(Gas::H2O), 7000e-6, 1e-15);
    EXPECT_NEAR(air.at(0.0).pressure_hPa, 1001.0 * std::exp(100.0 / 8450.0), 0.05);
}

TEST(Radiosonde, ThatReachesTheTopNeedsNothingAbove) {
    const Profile air = ascentOf("altitude [m],pressure [hPa],temperature [K],h2o [ppmv]\n"
                                 "0,1013,288,7000\n50000,0.8,270,5\n110000,0.0001,240,1\n");
    EXPECT_EQ(air.top_m(), 110000.0);
}

TEST(Radiosonde, RefusesEveryKindOfErrorByName) {
    const std::string head = "altitude [m],pressure [hPa],temperature [K],relative_humidity [%]\n";
    struct Case {
        const char* name;
        std::string text;
        const char* words;
    };
    const Case cases[] = {
        {"empty", "", "no rows"},
        {"header only", head, "at least two"},
        {"one row", head + "0,1013,288,50\n", "1 rows of numbers"},
        {"no altitude", "pressure [hPa],temperature [K],h2o [ppmv]\n1013,288,5\n899,281,5\n",
         "'altitude [m]'"},
        {"no pressure", "altitude [m],temperature [K],h2o [ppmv]\n0,288,5\n1,281,5\n",
         "'pressure [hPa]'"},
        {"no temperature", "altitude [m],pressure [hPa],h2o [ppmv]\n0,1013,5\n1,1000,5\n",
         "'temperature [K]' or 'temperature [C]'"},
        {"no humidity", "altitude [m],pressure [hPa],temperature [K]\n0,1013,288\n1,1000,288\n",
         "'dew_point [C]'"},
        {"two temperatures",
         "altitude [m],pressure [hPa],temperature [K],temperature [C],h2o [ppmv]\n"
         "0,1013,288,15,5\n1,1000,288,15,5\n",
         "2 such columns"},
        {"two humidities",
         "altitude [m],pressure [hPa],temperature [K],dew_point [C],h2o [ppmv]\n"
         "0,1013,288,1,5\n1,1000,288,1,5\n",
         "2 such columns"},
        {"unknown column",
         "altitude [m],pressure [hPa],temperature [K],h2o [ppmv],wind [m/s]\n0,1013,288,5,1\n",
         "found 'wind [m/s]'"},
        {"unknown unit", "altitude [ft],pressure [hPa],temperature [K],h2o [ppmv]\n0,1013,288,5\n",
         "found 'altitude [ft]'"},
        {"column twice",
         "altitude [m],altitude [m],pressure [hPa],temperature [K],h2o [ppmv]\n0,0,1013,288,5\n",
         "each column once"},
        {"short row", head + "0,1013,288\n1000,899,281,50\n", "3 cells"},
        {"long row", head + "0,1013,288,50\n1000,899,281,50,1\n", "5 cells"},
        {"not a number", head + "0,1013,cold,50\n1000,899,281,50\n", "found 'cold'"},
        {"nan", head + "0,1013,nan,50\n1000,899,281,50\n", "found 'nan'"},
        {"below ground", head + "-1,1013,288,50\n1000,899,281,50\n", "0 to 120000 m"},
        {"starts too high", head + "1500,850,288,50\n2000,799,281,50\n", "first altitude"},
        {"descending", head + "0,1013,288,50\n2000,799,281,50\n1000,700,281,50\n",
         "altitudes ascend strictly"},
        {"twice the same", head + "0,1013,288,50\n0,899,281,50\n", "altitudes ascend strictly"},
        {"rising pressure", head + "0,1013,288,50\n1000,1014,281,50\n", "pressure falls"},
        {"pressure in Pa", head + "0,101300,288,50\n1000,89900,281,50\n", "found '101300'"},
        {"temperature in C", head + "0,1013,15,50\n1000,899,281,50\n", "100 to 400 K"},
        {"too hot", head + "0,1013,488,50\n1000,899,281,50\n", "100 to 400 K"},
        {"too humid", head + "0,1013,288,101\n1000,899,281,50\n", "0 to 100 %"},
        {"negative humidity", head + "0,1013,288,-1\n1000,899,281,50\n", "0 to 100 %"},
        {"dew point above the air",
         "altitude [m],pressure [hPa],temperature [C],dew_point [C]\n0,1013,15,16\n1000,899,8,1\n",
         "at most the temperature"},
        {"all water",
         "altitude [m],pressure [hPa],temperature [K],h2o [ppmv]\n0,1013,288,2e6\n"
         "1000,899,281,5\n",
         "found '2e6'"},
        {"does not join", head + "0,1013,288,50\n5000,1000,280,50\n", "within a fifth"}};
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name);
        try {
            ascentOf(each.text);
            ADD_FAILURE() << "nothing was refused";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr(each.words));
            EXPECT_THAT(error.what(), HasSubstr("ascent.csv"));
        }
    }
    EXPECT_THROW(Profile::fromRadiosonde("no such file", Profile::model(ModelAtmosphere::tropical)),
                 InputError);
}

TEST(Radiosonde, NamesEveryDiagnosticAtOnce) {
    try {
        ascentOf("altitude [m],pressure [hPa],temperature [K],relative_humidity [%]\n"
                 "0,1013,15,150\n1000,x,281,50\n500,800,281,50\n");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 3u) << error.what();
    }
}

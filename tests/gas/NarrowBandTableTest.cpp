#include "irsg/gas/NarrowBandTable.h"

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/gas/GasOptics.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using testing::HasSubstr;

namespace {

const std::string good =
    "# gas: CO\n# law: malkmus\n# between temperatures: straight\n# temperatures: 300 500\n# "
    "source: made up\n"
    "wavenumber [cm-1],k_300 [cm-1 atm-1],k_500 [cm-1 atm-1],inverse_spacing_300 "
    "[cm],inverse_spacing_500 [cm]\n2000,1,3,0.2,0.4\n2010,2,6,0.4,0.8\n";

NarrowBandTable tableOf(const std::string& text) {
    const smat::test::TemporaryFolder folder;
    std::ofstream(folder / "table.csv") << text;
    return NarrowBandTable::read(folder / "table.csv");
}

std::string replaced(const std::string& what, const std::string& by) {
    std::string text = good;
    text.replace(text.find(what), what.size(), by);
    return text;
}

TEST(NarrowBandTable, IsLinearInWavenumberAndTemperature) {
    const NarrowBandTable table = tableOf(good);
    EXPECT_EQ(table.gas(), HotGas::CO);
    EXPECT_EQ(table.law(), StrengthLaw::malkmus);
    EXPECT_EQ(table.source(), "made up");
    EXPECT_DOUBLE_EQ(table.at(2000.0, 300.0).k_per_cm_atm, 1.0);
    EXPECT_DOUBLE_EQ(table.at(2010.0, 500.0).inverseSpacing_cm, 0.8);
    EXPECT_DOUBLE_EQ(table.at(2005.0, 400.0).k_per_cm_atm, 3.0);
    EXPECT_DOUBLE_EQ(table.at(2005.0, 250.0).k_per_cm_atm, 1.5) << "clamped to 300 K";
    EXPECT_DOUBLE_EQ(table.at(2005.0, 3000.0).k_per_cm_atm, 4.5) << "clamped to 500 K";
    EXPECT_EQ(table.at(1999.0, 300.0).k_per_cm_atm, 0.0);
    EXPECT_EQ(table.at(2011.0, 300.0).k_per_cm_atm, 0.0);
}

TEST(NarrowBandTable, FollowsBoltzmannsFactorBetweenTemperatures) {
    std::string text = good;
    text.replace(text.find("straight"), 8, "boltzmann");
    const NarrowBandTable table = tableOf(text);
    // k = exp(a - b/T) is met exactly: 1 at 300 K, 3 at 500 K.
    const double b = std::log(3.0) / (1.0 / 300.0 - 1.0 / 500.0);
    for (const double T : {300.0, 350.0, 400.0, 470.0, 500.0}) {
        EXPECT_NEAR(table.at(2000.0, T).k_per_cm_atm, std::exp(b * (1.0 / 300.0 - 1.0 / T)), 1e-12)
            << T;
    }
    EXPECT_DOUBLE_EQ(table.at(2000.0, 900.0).k_per_cm_atm, 3.0);
}

TEST(NarrowBandTable, GivesWhatALayerContributes) {
    const NarrowBandTable table = tableOf(good);
    GasLayer layer;
    layer.temperature_K = 500.0;
    layer.length_m = 0.5;
    layer.pressure_atm = 2.0;
    layer.fraction(HotGas::CO) = 0.1;
    const NarrowBandLayer given = narrowBandLayer(table, layer, 0.05, 2000.0);
    EXPECT_DOUBLE_EQ(given.depth, 3.0 * 10.0 * 273.0 / 500.0); // 0.1 x 2 atm x 50 cm
    EXPECT_DOUBLE_EQ(given.collision, 0.05 * 0.4);
    EXPECT_NEAR(given.doppler, 0.4 * 5.94e-6 * 2000.0 * std::sqrt(500.0 / (273.0 * 28.0)), 1e-12);
}

TEST(NarrowBandTable, HasTheWidthsOfTheTechnicalNote) {
    GasLayer layer;
    layer.temperature_K = 273.0;
    layer.pressure_atm = 2.0;
    EXPECT_DOUBLE_EQ(collisionHalfWidth_per_cm(HotGas::CO2, layer), 0.14) << "in nitrogen";
    layer.fraction(HotGas::H2O) = 0.5;
    layer.oxygenFraction = 0.5;
    EXPECT_DOUBLE_EQ(collisionHalfWidth_per_cm(HotGas::H2O, layer),
                     2.0 * (0.5 * 0.09 + 0.5 * 0.04 + 0.5 * 0.44));
    layer.temperature_K = 4.0 * 273.0;
    EXPECT_DOUBLE_EQ(collisionHalfWidth_per_cm(HotGas::H2O, layer),
                     2.0 * ((0.5 * 0.09 + 0.5 * 0.04) / 2.0 + 0.5 * 0.44 / 4.0));
}

TEST(NarrowBandTable, IsShippedForEveryGas) {
    for (const GasSource source : {GasSource::automatic, GasSource::lines, GasSource::radcal}) {
        const GasAnswers answers = gasAnswers(source);
        for (std::size_t gas = 0; gas < hotGasCount; ++gas) {
            ASSERT_TRUE(answers[gas].first.table);
            EXPECT_EQ(answers[gas].first.table->gas(), static_cast<HotGas>(gas));
            EXPECT_THAT(describe(answers[gas]), HasSubstr(": "));
        }
        const auto carbonDioxide = static_cast<std::size_t>(HotGas::CO2);
        EXPECT_EQ(answers[carbonDioxide].first.source == GasSource::radcal,
                  source == GasSource::radcal);
    }
    EXPECT_EQ(gasAnswers(GasSource::radcal)[static_cast<std::size_t>(HotGas::CH4)].first.source,
              GasSource::lines)
        << "RADCAL's tables have no methane";
}

TEST(NarrowBandTable, StatesAnErrorEverywhere) {
    for (const GasSource source : {GasSource::automatic, GasSource::lines, GasSource::radcal}) {
        for (std::size_t gas = 0; gas < hotGasCount; ++gas) {
            for (double nu = 50.0; nu < 10000.0; nu += 50.0) {
                for (const double T : {250.0, 300.0, 900.0, 1500.0, 3000.0}) {
                    const GasAnswer answer = gasAnswers(source)[gas];
                    const double error =
                        statedGasError(answer.at(nu), static_cast<HotGas>(gas), nu, T);
                    EXPECT_GT(error, 0.0);
                    EXPECT_LE(error, 1.0);
                }
            }
        }
    }
}

struct Wrong {
    const char* name;
    std::string text;
    const char* message;
};
class NarrowBandTableRefuses : public testing::TestWithParam<Wrong> {};

TEST_P(NarrowBandTableRefuses, ByName) {
    EXPECT_THAT(smat::test::refusalOf([] { tableOf(GetParam().text); }),
                HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Tables, NarrowBandTableRefuses,
    testing::Values(Wrong{"Empty", "", "# gas"},
                    Wrong{"NoGas", replaced("# gas: CO\n", ""), "no line '# gas"},
                    Wrong{"OtherGas", replaced("# gas: CO", "# gas: NO"), "CO2, H2O, CO or CH4"},
                    Wrong{"OtherLaw", replaced("malkmus", "elsasser"), "goody or malkmus"},
                    Wrong{"OtherWay", replaced("straight", "cubic"), "straight or boltzmann"},
                    Wrong{"NoTemperatures", replaced("# temperatures: 300 500", "# temperatures:"),
                          "temperatures in K"},
                    Wrong{"Falling", replaced("300 500", "500 300"), "ascending temperatures"},
                    Wrong{"Word", replaced("300 500", "300 hot"), "hot"},
                    Wrong{"Columns", replaced("k_500", "k_600"), "k_500 [cm-1 atm-1]"},
                    Wrong{"Cells", replaced("2000,1,3,0.2,0.4", "2000,1,3,0.2"), "5 cells"},
                    Wrong{"Number", replaced("2000,1,3", "2000,one,3"), "one"},
                    Wrong{"Axis", replaced("2010", "1990"), "ascending"}),
    [](const auto& row) { return std::string(row.param.name); });

} // namespace

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/support/SharedMaterial.h"
#include "tests/support/TemporaryFolder.h"
#include "tools/atmosphere-tables/lines/PartitionSums.h"

namespace irsg::lbl {
namespace {

const std::string columns = "temperature_K,H2O_1,H2O_2,CO2_1,O3_1,N2O_1,CO_1,CH4_1,O2_1";

/// A folder with a table of that text.
std::filesystem::path folderOf(const std::string& text) {
    return smat::test::writtenFile(smat::test::ownFolder() / "tips_12_molecules.csv", text)
        .parent_path();
}

TEST(PartitionSums, AreInterpolatedBetweenTheirTemperatures) {
    const auto sums = PartitionSums::read(folderOf("# a table\n" + columns +
                                                   "\n"
                                                   "200,100,50,1,1,1,1,1,1\n"
                                                   "296,200,80,2,1,1,1,1,1\n"
                                                   "300,204,88,2,1,1,1,1,1\n"));
    EXPECT_NEAR(sums.ratioTo296(Gas::H2O, 1, 296.0), 1.0, 1e-15);
    EXPECT_NEAR(sums.ratioTo296(Gas::H2O, 1, 200.0), 2.0, 1e-12);
    EXPECT_NEAR(sums.ratioTo296(Gas::H2O, 1, 298.0), 200.0 / 202.0, 1e-12);
    EXPECT_NEAR(sums.ratioTo296(Gas::H2O, 2, 248.0), 80.0 / 65.0, 1e-12);
    // An isotopologue that is not there is taken as the first.
    EXPECT_NEAR(sums.ratioTo296(Gas::CO2, 7, 200.0), 2.0, 1e-12);
}

TEST(PartitionSums, OfARigidRotorGoWithThePowerOfThreeHalves) {
    const PartitionSums sums = PartitionSums::rigidRotor();
    EXPECT_NEAR(sums.ratioTo296(Gas::O3, 1, 150.0), std::pow(296.0 / 150.0, 1.5), 1e-5);
}

TEST(PartitionSums, NameWhatIsWrongWithATable) {
    struct Case {
        const char* name;
        std::string text;
        std::string expected;
    };
    const Case cases[] = {
        {"nothing", "", "temperatures and partition sums"},
        {"no gas", "temperature_K,H2O_1\n200,1\n300,2\n", "CO2_1"},
        {"short row", columns + "\n200,1,1,1,1,1,1,1,1\n300,1,1\n", "9 cells"},
        {"no number", columns + "\n200,1,1,1,1,1,1,1,1\n300,1,1,x,1,1,1,1,1\n", "a number above 0"},
        {"zero", columns + "\n200,1,1,1,1,1,1,1,1\n300,1,1,0,1,1,1,1,1\n", "a number above 0"},
        {"not ascending", columns + "\n300,1,1,1,1,1,1,1,1\n200,1,1,1,1,1,1,1,1\n",
         "temperatures that ascend"},
        {"no temperature",
         "T" + columns.substr(11) + "\n200,1,1,1,1,1,1,1,1\n300,1,1,1,1,1,1,1,1\n",
         "temperature_K"},
        {"only a rare isotopologue", "temperature_K,CO_2,CO_0,CO_99\n200,1,1,1\n300,1,1,1\n",
         "CO_1"},
    };
    for (const Case& bad : cases) {
        try {
            (void)PartitionSums::read(folderOf(bad.text));
            ADD_FAILURE() << bad.name;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(bad.expected), std::string::npos)
                << bad.name << ": " << error.what();
        }
    }
    EXPECT_THROW((void)PartitionSums::read("no such folder"), InputError);
}

TEST(PartitionSums, OfTheSharedTableAreThoseOfTips2017) {
    const auto folder = smat::test::sharedMaterial("data/atmosphere/lines/partition");
    if (folder.empty()) {
        GTEST_SKIP() << "the partition sums of the shared material are not here";
    }
    const PartitionSums sums = PartitionSums::read(folder);
    EXPECT_NEAR(sums.ratioTo296(Gas::H2O, 1, 200.0), 174.58 / 97.415, 1e-9);
    // Linear molecules: T, and the vibrational factor.
    EXPECT_NEAR(sums.ratioTo296(Gas::CO, 1, 200.0) / 1.48, 1.0, 0.003);
    EXPECT_NEAR(sums.ratioTo296(Gas::O2, 1, 200.0) / 1.48, 1.0, 0.005);
    // The bending mode of CO2 at 667 cm-1 (twice) holds 8 % of the molecules at 296 K.
    const double bend = std::pow(
        (1.0 - std::exp(-1.4388 * 667.4 / 200.0)) / (1.0 - std::exp(-1.4388 * 667.4 / 296.0)), 2.0);
    EXPECT_NEAR(sums.ratioTo296(Gas::CO2, 1, 200.0) / (1.48 * bend), 1.0, 0.004);
    for (std::size_t g = 0; g < lineGasCount; ++g) {
        EXPECT_EQ(sums.ratioTo296(static_cast<Gas>(g), 1, 296.0), 1.0);
    }
}

TEST(MolarMass, KnowsTheIsotopologues) {
    EXPECT_NEAR(molarMass_g(Gas::H2O, 1), 18.0106, 1e-4);
    EXPECT_NEAR(molarMass_g(Gas::H2O, 4), 19.0167, 1e-4); // HDO
    EXPECT_NEAR(molarMass_g(Gas::CO2, 2) - molarMass_g(Gas::CO2, 1), 1.0034, 1e-4);
    EXPECT_NEAR(molarMass_g(Gas::CO2, 3) - molarMass_g(Gas::CO2, 1), 2.0042, 2e-4);
    EXPECT_EQ(molarMass_g(Gas::O2, 9), molarMass_g(Gas::O2, 1));
}

} // namespace
} // namespace irsg::lbl

#include "irsg/gas/PlumeTable.h"

#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/support/TemporaryFolder.h"

using namespace irsg;
using smat::test::TemporaryFolder;

namespace {

/// What an exhaust becomes in air: 1 in a core, then falling along the axis, bell-shaped across.
double mixedPart(double x_m, double r_m) {
    const double width_m = 0.12 + 0.09 * x_m;
    const double axis = std::min(1.0, 0.12 * 6.0 / std::max(x_m, 1e-6) / 6.2 * 5.0);
    return axis * std::exp(-r_m * r_m / (width_m * width_m));
}

/// 60 x 40 nodes of a jet of 900 K in air of 288 K.
std::string jet() {
    std::string text = "x [m],r [m],T [K],CO2,H2O\n";
    for (int i = 0; i < 60; ++i) {
        for (int j = 0; j < 40; ++j) {
            const double x_m = 6.0 * i / 59, r_m = 1.6 * j / 39, part = mixedPart(x_m, r_m);
            text += std::to_string(x_m) + "," + std::to_string(r_m) + "," +
                    std::to_string(288.0 + 612.0 * part) + "," + std::to_string(0.04 * part) + "," +
                    std::to_string(0.04 * part) + "\n";
        }
    }
    return text;
}

class PlumeTables : public testing::Test {
  protected:
    PlumeTable tableOf(const std::string& text) const {
        std::ofstream(folder_.path() / "plume.csv") << text;
        return PlumeTable::read(folder_.path() / "plume.csv");
    }
    std::string refusalOf(const std::string& text) const {
        try {
            tableOf(text);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }

    TemporaryFolder folder_;
};

TEST_F(PlumeTables, AreReadWhateverTheOrderOfRows) {
    const PlumeTable table =
        tableOf("r [m],x [m],T [K],CO2,p [atm]\n"
                "1,0,400,0.02,1\n0,0,800,0.1,1\n0,2,600,0.06,2\n1,2,300,0,2\n");
    EXPECT_EQ(table.x_m(), (std::vector<double>{0.0, 2.0}));
    EXPECT_EQ(table.r_m(), (std::vector<double>{0.0, 1.0}));
    const GasLayer middle = table.at(1.0, 0.5);
    EXPECT_DOUBLE_EQ(middle.temperature_K, 525.0);
    EXPECT_DOUBLE_EQ(middle.fraction(HotGas::CO2), 0.045);
    EXPECT_DOUBLE_EQ(middle.pressure_atm, 1.5);
    EXPECT_DOUBLE_EQ(table.at(-9.0, 9.0).temperature_K, 400.0);
}

TEST_F(PlumeTables, AreRefusedByLineAndValue) {
    const std::string head = "x [m],r [m],T [K],CO2\n";
    const std::string good = head + "0,0,800,0.1\n0,1,400,0\n1,0,700,0.1\n1,1,300,0\n";
    EXPECT_EQ(refusalOf(good), "");
    for (const auto& [text, named] : std::vector<std::pair<std::string, std::string>>{
             {"x [m],r [m],CO2\n0,0,0.1\n1,1,0\n", "no column T [K]"},
             {"x [m],r [m],T [C],CO2\n0,0,800,0.1\n", "T [C]"},
             {head + "0,0,hot,0.1\n0,1,400,0\n1,0,700,0.1\n1,1,300,0\n", "line 2, column 3"},
             {head + "0,0,800,1.1\n0,1,400,0\n1,0,700,0.1\n1,1,300,0\n", "CO2 = 1.1"},
             {head + "0,0,800,0.1\n0,1,200,0\n1,0,700,0.1\n1,1,300,0\n", "T_K = 200"},
             {head + "0,0,800,0.1\n0,1,400,0\n1,0,700,0.1\n", "no row of x = 1, r = 1"},
             {good + "1,1,300,0\n", "again"},
             {head + "0,1,800,0.1\n0,2,400,0\n1,1,700,0.1\n1,2,300,0\n", "r from 1"},
             {head + "0,0,800,0.1\n0,-1,400,0\n1,0,700,0.1\n1,-1,300,0\n", "r = -1"}}) {
        EXPECT_NE(refusalOf(text).find(named), std::string::npos) << refusalOf(text);
    }
    const PlumeTable ring = tableOf(head + "0,0,500,0.1\n0,1,800,0.1\n1,0,500,0.1\n1,1,800,0.1\n");
    EXPECT_THROW(plumeZones(ring, 3), InputError);
    const PlumeTable air = tableOf(head + "0,0,800,0\n0,1,400,0\n1,0,700,0\n1,1,300,0\n");
    EXPECT_THROW(plumeZones(air, 3), InputError);
}

TEST_F(PlumeTables, OfOneGasAreOneZone) {
    const PlumeTable table =
        tableOf("x [m],r [m],T [K],CO2\n0,0,800,0.1\n0,1,800,0.1\n3,0,800,0.1\n3,1,800,0.1\n");
    const auto zones = plumeZones(table, 5);
    ASSERT_EQ(zones.size(), 1u);
    EXPECT_NEAR(zones[0].gas.temperature_K, 800.0, 1e-9);
    for (const PlumeZonesError& error : PlumeIntensities(table, {4.2, 4.8}).errorsOf(zones)) {
        // Its sharp edge is what lines of sight that are not the same leave.
        EXPECT_NEAR(error.relative(), 0.0, 0.005) << error.view;
    }
}

TEST_F(PlumeTables, SendWhatADenseIntegrationDoes) {
    const PlumeTable table = tableOf(jet());
    const SpectralRange band{4.45, 4.47};
    const PlumeIntensities intensities(table, band);
    const auto largest = [&](std::size_t count) {
        double error = 0.0;
        for (const PlumeZonesError& of : intensities.errorsOf(plumeZones(table, count))) {
            error = std::max(error, std::abs(of.relative()));
        }
        return error;
    };
    EXPECT_GT(largest(1), 0.2) << "the bound is not met by anything";
    EXPECT_LT(largest(6), 0.15);
    EXPECT_LT(largest(16), 0.02);
}

} // namespace

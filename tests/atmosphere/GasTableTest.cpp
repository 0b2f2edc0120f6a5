#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/GasTable.h"
#include "irsg/atmosphere/engine/NodeAbsorption.h"
#include "irsg/core/Errors.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

/// ln k = a + b ln p + c / T, which the interpolation must give exactly.
double lnCross(double lnPressure, double temperature_K, double offset) {
    return -50.0 + offset + 0.8 * lnPressure - 1500.0 / temperature_K;
}

GasTable::Grid grid() {
    return {{1100.0, 600.0, 300.0, 100.0, 30.0, 1.0}, {180.0, 220.0, 260.0, 300.0, 340.0}, 0.04, 4};
}

std::vector<float> block(Gas gas, double offset) {
    const GasTable::Grid shape = grid();
    std::vector<float> values;
    auto rows = [&](std::size_t count, double shift) {
        for (std::size_t i = 0; i < count; ++i) {
            for (const double T : shape.temperatures_K) {
                values.push_back(static_cast<float>(
                    lnCross(std::log(shape.pressures_hPa[i]), T, offset + shift)));
            }
        }
    };
    rows(shape.pressures_hPa.size(), 0.0);
    if (gas == Gas::H2O) {
        rows(shape.moistPressures, 0.5);
    }
    return values;
}

BinSet bins(double width_per_cm) {
    return {width_per_cm,
            {{1000.0, 1005.0, 0, 2}, {1005.0, 1010.0, 2, 1}},
            {0, 1, 2},
            {0.25f, 0.75f, 1.0f}};
}

GasTable table() {
    return GasTable(grid(), {1001.0, 1004.0, 1008.0},
                    {{0, Gas::H2O, block(Gas::H2O, 0.0)},
                     {2, Gas::H2O, block(Gas::H2O, 2.0)},
                     {1, Gas::CO2, block(Gas::CO2, 1.0)},
                     {2, Gas::CO2, block(Gas::CO2, -1.0)}},
                    {bins(1.0), bins(5.0), bins(15.0)}, "a recipe");
}

AtmosphericState air(double pressure_hPa, double temperature_K, double water,
                     double carbonDioxide) {
    AtmosphericState state;
    state.pressure_hPa = pressure_hPa;
    state.temperature_K = temperature_K;
    state.moleFraction[0] = water;
    state.moleFraction[1] = carbonDioxide;
    return state;
}

TEST(GasTable, InterpolatesALogarithmThatIsLinearExactly) {
    const AtmosphericState state = air(432.1, 277.7, 0.0, 4e-4);
    const double expected = std::exp(lnCross(std::log(432.1), 277.7, 1.0));
    EXPECT_NEAR(table().crossSection_cm2(1, Gas::CO2, state) / expected, 1.0, 1e-3);
    EXPECT_EQ(table().crossSection_cm2(0, Gas::CO2, state), 0.0);
    EXPECT_EQ(table().crossSection_cm2(1, Gas::O3, state), 0.0);
}

TEST(GasTable, BroadensWaterInProportionToItsFraction) {
    const AtmosphericState state = air(700.0, 290.0, 0.02, 0.0);
    const double expected = std::exp(lnCross(std::log(700.0), 290.0, 0.25));
    EXPECT_NEAR(table().crossSection_cm2(0, Gas::H2O, state) / expected, 1.0, 1e-3);
}

TEST(GasTable, AddsTheGasesOfANode) {
    const AtmosphericState state = air(700.0, 290.0, 0.02, 4e-4);
    const std::vector<std::uint32_t> nodes{2, 0, 1};
    std::vector<float> absorption(3, -1.0f);
    table().absorption_per_m(state, nodes, absorption);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        double expected = 0.0;
        for (const Gas gas : {Gas::H2O, Gas::CO2}) {
            expected +=
                table().crossSection_cm2(nodes[i], gas, state) * 1e-4 * state.density_per_m3(gas);
        }
        EXPECT_NEAR(absorption[i] / expected, 1.0, 1e-5) << i;
    }
}

TEST(NodeAbsorption, IsThatOfTheTableForEveryStateInAnyOrder) {
    const GasTable gases = table();
    // More nodes than are summed at a time, and each of them often.
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t i = 0; i < 1100; ++i) {
        nodes.push_back((i * i + i / 3) % 3);
    }
    const NodeAbsorption absorption(gases, nodes);
    const AtmosphericState states[] = {air(700.0, 290.0, 0.02, 4e-4), air(20.0, 200.0, 0.0, 4e-4),
                                       air(700.0, 290.0, 0.02, 4e-4), air(1e-3, 350.0, 1e-6, 0.0)};
    std::vector<std::vector<float>> found;
    for (const AtmosphericState& state : states) {
        found.emplace_back(nodes.size(), -1.0f);
        absorption.at(state, found.back());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            double expected = 0.0;
            for (const Gas gas : {Gas::H2O, Gas::CO2}) {
                expected +=
                    gases.crossSection_cm2(nodes[i], gas, state) * 1e-4 * state.density_per_m3(gas);
            }
            ASSERT_NEAR(found.back()[i], expected, 1e-5 * expected) << i;
        }
    }
    EXPECT_EQ(found[0], found[2]);
}

TEST(GasTable, ClampsWhatLiesBeyondItsGrid) {
    const double hot = table().crossSection_cm2(1, Gas::CO2, air(700.0, 500.0, 0.0, 4e-4));
    const double edge = table().crossSection_cm2(1, Gas::CO2, air(700.0, 340.0, 0.0, 4e-4));
    EXPECT_DOUBLE_EQ(hot, edge);
    EXPECT_DOUBLE_EQ(table().crossSection_cm2(1, Gas::CO2, air(0.01, 250.0, 0.0, 4e-4)),
                     table().crossSection_cm2(1, Gas::CO2, air(1.0, 250.0, 0.0, 4e-4)));
}

TEST(GasTable, FindsTheBinsThatTouchARange) {
    const BinSet set = bins(5.0);
    using Pair = std::pair<std::size_t, std::size_t>;
    EXPECT_EQ(set.range(1000.0, 1010.0), Pair(0, 2));
    EXPECT_EQ(set.range(1005.0, 1006.0), Pair(1, 2));
    EXPECT_EQ(set.range(1001.0, 1005.0), Pair(0, 1));
    EXPECT_EQ(set.range(2000.0, 2001.0).first, set.range(2000.0, 2001.0).second);
}

class GasTableFile : public testing::Test {
  protected:
    void SetUp() override { table().write(file_); }

    const std::filesystem::path folder_ = smat::test::ownFolder();
    const std::filesystem::path file_ = folder_ / "small.gastable";
};

TEST_F(GasTableFile, ReadsBackWhatWasWritten) {
    const auto read = GasTable::read(file_);
    EXPECT_EQ(read->header(), "a recipe");
    EXPECT_EQ(read->nodeCount(), 3u);
    EXPECT_EQ(read->bins(5).weights, table().bins(5).weights);
    const AtmosphericState state = air(700.0, 290.0, 0.02, 4e-4);
    EXPECT_DOUBLE_EQ(read->crossSection_cm2(2, Gas::H2O, state),
                     table().crossSection_cm2(2, Gas::H2O, state));
}

TEST_F(GasTableFile, RefusesEveryFlippedByteAndEveryCut) {
    std::ifstream in(file_, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    auto put = [&](const std::string& text) {
        std::ofstream(file_, std::ios::binary | std::ios::trunc) << text;
    };
    for (std::size_t i = 0; i < bytes.size(); i += 7) {
        std::string damaged = bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        put(damaged);
        EXPECT_THROW((void)GasTable::read(file_), InputError) << "byte " << i;
        put(bytes.substr(0, i));
        EXPECT_THROW((void)GasTable::read(file_), InputError) << "cut at " << i;
    }
    EXPECT_THROW((void)GasTable::read(folder_ / "none.gastable"), InputError);
}

TEST(GasTable, RefusesPartsThatDoNotFit) {
    EXPECT_THROW(
        GasTable(grid(), {1001.0}, {{0, Gas::CO2, {1.0f}}}, {bins(1.0), bins(5.0), bins(15.0)}, ""),
        LogicError);
    EXPECT_THROW((void)table().bins(7), LogicError);
}

} // namespace
} // namespace irsg

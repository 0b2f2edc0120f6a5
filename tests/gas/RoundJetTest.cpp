#include "irsg/gas/RoundJet.h"

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

using namespace irsg;

namespace {

TEST(RoundJet, BurnsFuelToWhatItsAtomsMake) {
    // Kerosene C12H23 of 0.02 of the mass of dry air without CO2: by hand 0.003462 mol per mol.
    RoundJet jet;
    jet.airWater = jet.airCO2 = 0.0;
    const GasLayer gas = jet.nozzleGas();
    EXPECT_NEAR(gas.fraction(HotGas::CO2), 0.04073, 2e-5);
    EXPECT_NEAR(gas.fraction(HotGas::H2O), 0.03903, 2e-5);
    EXPECT_NEAR(gas.oxygenFraction, 0.14516, 2e-5);
    // Hydrogen makes water alone; carbon CO2 alone, mole by mole of oxygen.
    jet.carbon = 0.0;
    jet.hydrogen = 2.0;
    EXPECT_EQ(jet.nozzleGas().fraction(HotGas::CO2), 0.0);
    jet.carbon = 1.0;
    jet.hydrogen = 0.0;
    jet.fuelAirRatio = 0.05;
    EXPECT_NEAR(jet.nozzleGas().fraction(HotGas::CO2) + jet.nozzleGas().oxygenFraction, 0.2095,
                1e-12);
}

TEST(RoundJet, KeepsTheFlowOfExhaust) {
    RoundJet jet;
    const PlumeTable table = jet.table();
    const GasLayer hot = jet.nozzleGas();
    EXPECT_DOUBLE_EQ(table.node(0, 0).temperature_K, 800.0);
    // Far away the part on the axis falls with the distance, and half widths are near 0.11 of it.
    const std::size_t last = table.x_m().size() - 1;
    const double x_m = table.x_m()[last];
    const auto part = [&](double r_m) {
        return table.at(x_m, r_m).fraction(HotGas::CO2) / (hot.fraction(HotGas::CO2) - jet.airCO2);
    };
    EXPECT_NEAR(part(0.0), 5.0 * 0.3 * std::sqrt(288.0 / 800.0) / x_m, 1e-6);
    double half_m = 0.0;
    while (part(half_m) > 0.5 * part(0.0)) {
        half_m += 0.001;
    }
    EXPECT_NEAR(half_m / x_m, 0.115, 0.015);
    // Temperature follows the part.
    EXPECT_NEAR(table.at(x_m, 0.0).temperature_K, 288.0 + part(0.0) * 512.0, 1e-6);
}

TEST(RoundJet, IsLongerInAirThatGoesAlong) {
    RoundJet still, along;
    along.coflow_m_s = 100.0;
    EXPECT_NEAR(along.table().x_m().back() / still.table().x_m().back(), 3.0, 1e-9);
}

TEST(RoundJet, IsRefusedWhereACoflowMakesItEndless) {
    RoundJet jet;
    jet.coflow_m_s = 180.0;
    try {
        jet.table();
        FAIL() << "950 diameters";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("ends_at: found 0.06, expected 0.12 at least"),
                  std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("950 diameters long"), std::string::npos)
            << error.what();
    }
    jet.endsAt = 0.12;
    EXPECT_NEAR(jet.table().x_m().back() / jet.diameter_m, 475.0, 1.0);
}

TEST(RoundJet, NamesWhatCannotBe) {
    RoundJet jet;
    jet.fuelAirRatio = 0.1;
    jet.temperature_K = 280.0;
    jet.coflow_m_s = 300.0;
    try {
        jet.nozzleGas();
        FAIL() << "more fuel than the air can burn";
    } catch (const InputError& error) {
        for (const char* named : {"fuel_air", "T_K", "coflow_m_s"}) {
            EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << named;
        }
    }
}

TEST(RoundJet, NamesWhatIsOutsideTheLimitsOfGas) {
    const std::vector<std::tuple<const char*, double RoundJet::*, std::vector<double>>> wrong = {
        {"T_K", &RoundJet::temperature_K, {3001.0, std::nan("")}},
        {"air_K", &RoundJet::air_K, {-5.0, 0.0, 249.0, std::nan("")}},
        {"p_atm", &RoundJet::pressure_atm, {-1.0, 0.0, 10.5}},
        {"air_H2O", &RoundJet::airWater, {-0.1, 2.0}},
        {"air_CO2", &RoundJet::airCO2, {-0.1, 2.0}},
        {"soot_ppmv", &RoundJet::soot_ppmv, {-4.0, 1001.0}}};
    for (const auto& [named, number, values] : wrong) {
        for (const double value : values) {
            RoundJet jet;
            jet.*number = value;
            try {
                jet.table();
                ADD_FAILURE() << named << " " << value;
            } catch (const InputError& error) {
                EXPECT_NE(std::string(error.what()).find(std::string(named) + ": found"),
                          std::string::npos)
                    << named << " " << value << ": " << error.what();
            }
        }
    }
}

} // namespace

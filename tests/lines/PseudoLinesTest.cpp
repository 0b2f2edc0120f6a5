#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/support/TemporaryFolder.h"
#include "tools/atmosphere-tables/lines/PseudoLines.h"
#include "tools/atmosphere-tables/lines/RandomNumbers.h"

namespace irsg::lbl {
namespace {

constexpr double typicalK_cm2 = 1e-20;
const PartitionSums rotor = PartitionSums::rigidRotor();

/// A band that rises and falls sevenfold every 190 cm-1.
std::vector<BandPoint> wavyBand(double exponent, double pressureExponent,
                                double temperatureExponent) {
    std::vector<BandPoint> points;
    for (double nu_per_cm = 5000.0; nu_per_cm <= 5205.0; nu_per_cm += LowtranBands::step_per_cm) {
        points.push_back({nu_per_cm, typicalK_cm2 * std::exp(std::sin(nu_per_cm / 30.0)), exponent,
                          pressureExponent, temperatureExponent});
    }
    return points;
}

struct Error {
    double rms = 0.0, bias = 0.0;
};

/// Of the transmittance over 20 cm-1, over points that have neighbours on both sides.
Error errorOf(const LineList& list, const std::vector<BandPoint>& points, double depth,
              double pressure_hPa, double temperature_K) {
    const WavenumberGrid grid{5040.0, 0.01, 12001};
    const auto k = crossSection_cm2(list, rotor, grid, temperature_K, pressure_hPa, 0.0,
                                    defaultLineShape(list.gas));
    const double column = std::pow(depth, 1.0 / points[0].exponent) / typicalK_cm2;
    Error error;
    double count = 0.0;
    for (const BandPoint& point : points) {
        if (point.wavenumber_per_cm < 5055.0 || point.wavenumber_per_cm > 5145.0) {
            continue;
        }
        const auto first =
            static_cast<std::size_t>((point.wavenumber_per_cm - 5050.0) / grid.step_per_cm);
        double mean = 0.0;
        for (std::size_t i = 0; i < 2000; ++i) {
            mean += std::exp(-column * k[first + i]) / 2000.0;
        }
        const double difference =
            mean - std::exp(-point.opticalDepth(column, pressure_hPa, temperature_K));
        error.rms += difference * difference;
        error.bias += difference;
        count += 1.0;
    }
    return {std::sqrt(error.rms / count), error.bias / count};
}

struct Band {
    Gas gas;
    double exponent, pressureExponent, temperatureExponent;
    double rmsAtGround, rmsAloft; ///< 1013 and 300 hPa
};
void PrintTo(const Band& row, std::ostream* out) {
    *out << gasNames[static_cast<std::size_t>(row.gas)] << " of exponent " << row.exponent;
}
class PseudoBand : public testing::TestWithParam<Band> {};

TEST_P(PseudoBand, AbsorbsAsItsModelWhateverTheAmountThePressureAndTheTemperature) {
    const Band& band = GetParam();
    const auto points = wavyBand(band.exponent, band.pressureExponent, band.temperatureExponent);
    const LineList list{band.gas, pseudoLines(points, pseudoGas(band.gas), 5005.0, 5200.0), {}};
    for (const double depth : {0.02, 0.1, 0.3, 0.7, 1.2, 2.0, 3.5}) {
        EXPECT_LT(errorOf(list, points, depth, 1013.25, 296.0).rms, band.rmsAtGround) << depth;
        EXPECT_LT(errorOf(list, points, depth, 1013.25, 250.0).rms, band.rmsAtGround) << depth;
        EXPECT_LT(errorOf(list, points, depth, 300.0, 230.0).rms, band.rmsAloft) << depth;
    }
}

INSTANTIATE_TEST_SUITE_P(OfLowtran, PseudoBand,
                         testing::Values(Band{Gas::H2O, 0.5454, 0.9362, -1.6338, 0.032, 0.032},
                                         Band{Gas::H2O, 0.6508, 0.6642, 0.2764, 0.036, 0.06},
                                         Band{Gas::O3, 0.7593, 0.4221, 0.7678, 0.042, 0.062},
                                         Band{Gas::CH4, 0.5844, 0.7139, -0.4185, 0.03, 0.03}),
                         [](const auto& info) {
                             return std::string(
                                        gasNames[static_cast<std::size_t>(info.param.gas)]) +
                                    std::to_string(info.index);
                         });

TEST(PseudoLines, AreTheSameEveryTimeAndOthersForAnotherSeed) {
    const auto points = wavyBand(0.5844, 0.7139, -0.4185);
    PseudoGas gas = pseudoGas(Gas::CH4);
    const auto first = pseudoLines(points, gas, 5005.0, 5050.0);
    const auto second = pseudoLines(points, gas, 5005.0, 5050.0);
    ASSERT_EQ(first.size(), second.size());
    ASSERT_GT(first.size(), 100u);
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].wavenumber_per_cm, second[i].wavenumber_per_cm);
        EXPECT_EQ(first[i].intensity, second[i].intensity);
    }
    gas.seed += 1;
    const auto other = pseudoLines(points, gas, 5005.0, 5050.0);
    EXPECT_NE(first.front().wavenumber_per_cm, other.front().wavenumber_per_cm);
}

TEST(PseudoLines, StayInTheirRangeInOrderAndFew) {
    for (const Gas gas : {Gas::H2O, Gas::O3, Gas::CH4}) {
        const auto lines = pseudoLines(wavyBand(0.6, 0.7, 0.0), pseudoGas(gas), 5012.3, 5101.7);
        EXPECT_LT(lines.size(), 90.0 / 5.0 * 70.0);
        double last_per_cm = 5012.3;
        for (const Line& line : lines) {
            EXPECT_GE(line.wavenumber_per_cm, last_per_cm);
            EXPECT_GT(line.intensity, 0.0);
            EXPECT_GE(line.lowerEnergy_per_cm, 0.0);
            last_per_cm = line.wavenumber_per_cm;
        }
        EXPECT_LE(last_per_cm, 5101.7);
    }
}

TEST(PseudoLines, AreNoneWhereTheModelHasNoAbsorption) {
    auto points = wavyBand(0.6, 0.7, 0.0);
    for (BandPoint& point : points) {
        if (point.wavenumber_per_cm > 5100.0) {
            point.coefficient_cm2 = 0.0;
        }
    }
    const auto lines = pseudoLines(points, pseudoGas(Gas::O3), 5005.0, 5200.0);
    ASSERT_FALSE(lines.empty());
    EXPECT_LT(lines.back().wavenumber_per_cm, 5102.5);
    for (BandPoint& point : points) {
        point.coefficient_cm2 = 0.0;
    }
    EXPECT_TRUE(pseudoLines(points, pseudoGas(Gas::O3), 5005.0, 5200.0).empty());
    EXPECT_THROW((void)pseudoGas(Gas::CO), LogicError);
}

TEST(RandomNumbers, AreThoseOfTheAlgorithm) {
    RandomNumbers random(0); // its first output for seed 0 is 0xe220a8397b1dcdaf
    EXPECT_EQ(random.next(), static_cast<double>(0xe220a8397b1dcdafULL >> 11) * 0x1.0p-53);
    double mean = 0.0;
    for (int i = 0; i < 10000; ++i) {
        mean += random.next() / 10000.0;
    }
    EXPECT_NEAR(mean, 0.5, 0.01);
}

class LowtranFolder : public testing::Test {
  protected:
    LowtranFolder() {
        write("bandmodel_bands.csv", "# bands\n"
                                     "gas,v_low_cm-1,v_high_cm-1,a,n_pressure,m_temperature\n"
                                     "H2O,0,10,0.5,0.9,-2\nO3,5,10,0.8,0.4,1\n");
        write("bandmodel_cprime.csv",
              "wavenumber_cm-1,Cprime_H2O,Cprime_CO2,Cprime_O3,Cprime_N2O,Cprime_CO,Cprime_CH4,"
              "Cprime_O2\n0,-1,,,,,,\n5,0,,-2,,,,\n10,1,,,,,,\n");
    }
    void write(const std::string& name, const std::string& text) {
        smat::test::writtenFile(folder_ / name, text);
    }
    const std::filesystem::path folder_ = smat::test::ownFolder();
};

TEST_F(LowtranFolder, GivesTheTransmittanceOfTheReport) {
    const LowtranBands bands = LowtranBands::read(folder_);
    const auto water = bands.points(Gas::H2O, 5.0, 100.0);
    ASSERT_EQ(water.size(), 2u);
    EXPECT_EQ(water[0].wavenumber_per_cm, 5.0);
    // 2 g cm-2 at 506.625 hPa and 300 K: W = 2 * 0.5^0.9 * (273.15 / 300)^-2, tau = exp(-W^0.5).
    const double amount = 2.0 * std::pow(0.5, 0.9) * std::pow(300.0 / 273.15, 2.0);
    EXPECT_NEAR(water[0].opticalDepth(2.0 * 6.02214076e23 / 18.01528, 506.625, 300.0),
                std::sqrt(amount), 1e-9);
    // 3 atm-cm of ozone: W = 3, tau = exp(-(0.01 * 3)^0.8).
    const auto ozone = bands.points(Gas::O3, 5.0, 5.0);
    EXPECT_NEAR(ozone[0].opticalDepth(3.0 * 2.686780111e19, 1013.25, 273.15), std::pow(0.03, 0.8),
                1e-9);
    EXPECT_EQ(bands.points(Gas::O3, 10.0, 10.0)[0].opticalDepth(1e25, 1013.25, 273.15), 0.0);
    EXPECT_EQ(bands.points(Gas::CO2, 0.0, 10.0)[0].opticalDepth(1e25, 1013.25, 273.15), 0.0);
}

TEST_F(LowtranFolder, MustBeWhole) {
    write("bandmodel_bands.csv", "gas,v_low_cm-1,v_high_cm-1,a\nH2O,0,10,0.5\n");
    EXPECT_THROW((void)LowtranBands::read(folder_), InputError);
    write("bandmodel_bands.csv",
          "gas,v_low_cm-1,v_high_cm-1,a,n_pressure,m_temperature\nH2O,0,10,half,0.9,-2\n");
    EXPECT_THROW((void)LowtranBands::read(folder_), InputError);
    EXPECT_THROW((void)LowtranBands::read(folder_ / "nothing"), InputError);
}

} // namespace
} // namespace irsg::lbl

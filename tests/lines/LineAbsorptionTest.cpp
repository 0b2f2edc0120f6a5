#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/Voigt.h"

namespace irsg::lbl {
namespace {

const PartitionSums rotor = PartitionSums::rigidRotor();

Line strongLine(double wavenumber_per_cm, double intensity = 1e-20) {
    Line line;
    line.wavenumber_per_cm = wavenumber_per_cm;
    line.intensity = intensity;
    line.lowerEnergy_per_cm = 300.0;
    return line;
}

/// The sum over lines point by point, without a pyramid.
std::vector<double> pointByPoint(const LineList& list, const WavenumberGrid& grid,
                                 double temperature_K, double pressure_hPa,
                                 const LineShape& shape) {
    std::vector<double> sum(grid.count, 0.0);
    constexpr double c2 = 1.438776877;
    const double pressure_atm = pressure_hPa / 1013.25, ratio = 296.0 / temperature_K;
    for (const Line& line : list.lines) {
        const double nu = line.wavenumber_per_cm;
        const double intensity = line.intensity * std::pow(ratio, 1.5) *
                                 std::exp(-c2 * line.lowerEnergy_per_cm * (ratio - 1.0) / 296.0) *
                                 std::expm1(-c2 * nu / temperature_K) /
                                 std::expm1(-c2 * nu / 296.0);
        // Half width sqrt(2 ln 2 R T / M) nu / c.
        const double doppler_per_cm = nu / 299792458.0 *
                                      std::sqrt(2.0 * std::numbers::ln2 * 8.31446261815324 *
                                                temperature_K / (1e-3 * molarMass_g(list.gas, 1)));
        const VoigtProfile profile(doppler_per_cm,
                                   pressure_atm * static_cast<double>(line.airWidth_cm_atm) *
                                       std::pow(ratio, static_cast<double>(line.widthExponent)));
        const double pedestal = shape.removePedestal ? profile.at(shape.cut_per_cm) : 0.0;
        const double centre = nu + pressure_atm * static_cast<double>(line.airShift_cm_atm);
        for (std::size_t i = 0; i < grid.count; ++i) {
            const double x = std::abs(grid.at(i) - centre);
            if (x > shape.cut_per_cm) {
                continue;
            }
            const double chi = shape.carbonDioxideWings ? carbonDioxideChi(x, temperature_K) : 1.0;
            sum[i] += intensity * (profile.at(x) * chi - pedestal);
        }
    }
    return sum;
}

TEST(LineAbsorption, GivesOneLineInClosedForm) {
    const LineList list{Gas::CO, {strongLine(2100.0)}, {}};
    const WavenumberGrid grid{2099.0, 0.001, 2001};
    const std::vector<double> k =
        crossSection_cm2(list, rotor, grid, 296.0, 1013.25, 0.0, defaultLineShape(Gas::CO));
    const VoigtProfile profile(3.581163e-7 * 2100.0 * std::sqrt(296.0 / 27.9949), 0.07);
    for (const std::size_t i : {0u, 300u, 900u, 990u, 1000u, 1400u, 2000u}) {
        const double expected = 1e-20 * profile.at(grid.at(i) - 2100.0);
        EXPECT_NEAR(k[i] / expected, 1.0, 3e-5) << grid.at(i);
    }
}

TEST(LineAbsorption, FollowsBoltzmannAndThePartitionSum) {
    const LineList list{Gas::CO, {strongLine(2100.0)}, {}};
    const WavenumberGrid grid{2095.0, 0.001, 10001};
    auto area = [&](double temperature_K) {
        double sum = 0.0;
        for (const double value : crossSection_cm2(list, rotor, grid, temperature_K, 1.0, 0.0,
                                                   defaultLineShape(Gas::CO))) {
            sum += value * grid.step_per_cm;
        }
        return sum;
    };
    EXPECT_NEAR(area(296.0) / 1e-20, 1.0, 1e-3);
    const double expected = std::pow(296.0 / 220.0, 1.5) *
                            std::exp(-1.438776877 * 300.0 * (1.0 / 220.0 - 1.0 / 296.0)) *
                            std::expm1(-1.438776877 * 2100.0 / 220.0) /
                            std::expm1(-1.438776877 * 2100.0 / 296.0);
    EXPECT_NEAR(area(220.0) / area(296.0), expected, 1e-4 * expected);
}

TEST(LineAbsorption, IsWhatASumPointByPointGives) {
    struct Case {
        Gas gas;
        double pressure_hPa, temperature_K, step_per_cm;
    };
    for (const Case& now :
         {Case{Gas::H2O, 1013.0, 296.0, 0.001}, Case{Gas::H2O, 100.0, 250.0, 0.001},
          Case{Gas::H2O, 1.0, 220.0, 0.001}, Case{Gas::H2O, 100.0, 250.0, 0.002},
          Case{Gas::CO2, 1013.0, 296.0, 0.001}, Case{Gas::CO2, 1.0, 220.0, 0.002},
          Case{Gas::O3, 1013.0, 230.0, 0.002}, Case{Gas::O3, 10.0, 330.0, 0.001}}) {
        LineList list{now.gas, {}, {}};
        for (int i = 0; i < 90; ++i) {
            Line line = strongLine(2180.0 + 0.7371 * i, 1e-22 * (1 + (i * i) % 7));
            line.airShift_cm_atm = -0.003f;
            line.widthExponent = 0.5f + 0.01f * static_cast<float>(i % 30);
            list.lines.push_back(line);
        }
        // Strong lines to the sides, within and beyond the cuts.
        for (const double nu : {1905.3, 2160.0, 2182.0, 2222.0, 2460.0, 2510.0}) {
            list.lines.push_back(strongLine(nu, 1e-19));
        }
        const LineShape shape = defaultLineShape(now.gas);
        const WavenumberGrid grid{2200.0, now.step_per_cm, 2001};
        const auto fast =
            crossSection_cm2(list, rotor, grid, now.temperature_K, now.pressure_hPa, 0.0, shape);
        const auto slow = pointByPoint(list, grid, now.temperature_K, now.pressure_hPa, shape);
        for (std::size_t i = 0; i < grid.count; ++i) {
            ASSERT_NEAR(fast[i] / slow[i], 1.0, 1e-4)
                << gasNames[static_cast<std::size_t>(now.gas)] << " " << now.pressure_hPa << " "
                << grid.at(i);
        }
    }
}

TEST(LineAbsorption, IsTheSumOverItsLines) {
    LineList list{Gas::O3, {}, {}};
    const WavenumberGrid grid{1000.0, 0.002, 5000};
    std::vector<double> alone(grid.count, 0.0);
    for (int i = 0; i < 20; ++i) {
        list.lines.push_back(strongLine(998.0 + 0.7371 * i, 1e-22 * (1 + i % 7)));
        const auto one = crossSection_cm2({Gas::O3, {list.lines.back()}, {}}, rotor, grid, 250.0,
                                          100.0, 0.0, {25.0, false, false});
        for (std::size_t k = 0; k < grid.count; ++k) {
            alone[k] += one[k];
        }
    }
    const auto all = crossSection_cm2(list, rotor, grid, 250.0, 100.0, 0.0, {25.0, false, false});
    for (std::size_t k = 0; k < grid.count; ++k) {
        EXPECT_NEAR(all[k] / alone[k], 1.0, 1e-9);
    }
}

TEST(LineAbsorption, BroadensByTheGasItself) {
    const LineList list{Gas::H2O, {strongLine(1000.0)}, {}};
    const WavenumberGrid grid{1000.0, 0.01, 1001};
    const LineShape shape{25.0, false, false};
    const auto dry = crossSection_cm2(list, rotor, grid, 296.0, 1013.25, 0.0, shape);
    const auto moist = crossSection_cm2(list, rotor, grid, 296.0, 1013.25, 0.5, shape);
    // Far out the shape goes with the width: 0.5 * 0.07 + 0.5 * 0.1 against 0.07.
    EXPECT_NEAR(moist[1000] / dry[1000], 0.085 / 0.07, 1e-3);
}

TEST(LineAbsorption, LeavesOutLinesThatAreTooWeak) {
    const LineList strong{Gas::CO, {strongLine(2100.0, 1e-20)}, {}};
    LineList both = strong;
    both.lines.push_back(strongLine(2100.3, 1e-30));
    const WavenumberGrid grid{2100.0, 0.001, 1001};
    const LineShape shape = defaultLineShape(Gas::CO);
    EXPECT_EQ(crossSection_cm2(both, rotor, grid, 296.0, 1013.25, 0.0, shape, 1e-28),
              crossSection_cm2(strong, rotor, grid, 296.0, 1013.25, 0.0, shape));
}

TEST(LineAbsorption, EndsAtTheCutWithAndWithoutAPedestal) {
    const LineList list{Gas::H2O, {strongLine(1000.0)}, {}};
    const WavenumberGrid grid{1000.0, 0.01, 3000};
    const auto k = crossSection_cm2(list, rotor, grid, 296.0, 1013.25, 0.0, {25.0, true, false});
    const auto whole =
        crossSection_cm2(list, rotor, grid, 296.0, 1013.25, 0.0, {25.0, false, false});
    EXPECT_NEAR(k[2490] / (whole[2490]), 0.008, 0.002); // 1 - (24.9 / 25)^2
    const VoigtProfile profile(3.581163e-7 * 1000.0 * std::sqrt(296.0 / 18.0106), 0.07);
    EXPECT_NEAR((whole[2000] - k[2000]) / (1e-20 * profile.at(25.0)), 1.0, 1e-3);
    // The edge of the cut is as wide as the interpolation reaches.
    for (std::size_t i = 2800; i < grid.count; ++i) {
        EXPECT_EQ(k[i], 0.0);
        EXPECT_EQ(whole[i], 0.0);
    }
}

TEST(LineAbsorption, WeakensTheWingsOfCarbonDioxide) {
    EXPECT_EQ(carbonDioxideChi(2.9, 296.0), 1.0);
    for (const double at_per_cm : {3.0, 10.0, 70.0}) {
        EXPECT_NEAR(carbonDioxideChi(at_per_cm + 1e-9, 250.0),
                    carbonDioxideChi(at_per_cm - 1e-9, 250.0), 1e-8);
    }
    double last = 1.0;
    for (double x = 4.0; x < 300.0; x += 1.0) {
        const double chi = carbonDioxideChi(-x, 296.0);
        EXPECT_LT(chi, last);
        last = chi;
    }
    // Perrin and Hartmann's parameters for nitrogen.
    const double b1 = 0.416 - 0.354 * std::exp(-0.00386 * 296.0);
    const double b2 = 0.00167 + 0.0421 * std::exp(-0.00248 * 296.0);
    EXPECT_NEAR(carbonDioxideChi(8.0, 296.0), std::exp(-5.0 * b1), 1e-12);
    EXPECT_NEAR(carbonDioxideChi(40.0, 296.0), std::exp(-7.0 * b1 - 30.0 * b2), 1e-12);
    EXPECT_NEAR(carbonDioxideChi(170.0, 296.0), std::exp(-7.0 * b1 - 60.0 * b2 - 2.0), 1e-12);
}

TEST(LineAbsorption, RefusesAGridOrAirThatIsNone) {
    const LineList list{Gas::CO, {strongLine(2100.0)}, {}};
    EXPECT_THROW((void)crossSection_cm2(list, rotor, {}, 296.0, 1013.0, 0.0, {}), LogicError);
    EXPECT_THROW((void)crossSection_cm2(list, rotor, {1.0, 0.1, 3}, 0.0, 1013.0, 0.0, {}),
                 LogicError);
    EXPECT_THROW((void)crossSection_cm2(list, rotor, {1.0, 0.1, 3}, 296.0, 0.0, 0.0, {}),
                 LogicError);
}

} // namespace
} // namespace irsg::lbl

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "irsg/atmosphere/lbl/LineAbsorption.h"
#include "irsg/atmosphere/lbl/Voigt.h"
#include "irsg/radiometry/Errors.h"

namespace irsg::lbl {
namespace {

const PartitionSums rotor = PartitionSums::rigidRotor();

Line strongLine(double wavenumber_cm, double intensity = 1e-20) {
    Line line;
    line.wavenumber_cm = wavenumber_cm;
    line.intensity = intensity;
    line.lowerEnergy_cm = 300.0;
    return line;
}

TEST(ComplexErrorFunction, agreesWithPublishedValues) {
    // Abramowitz and Stegun, table 7.9.
    EXPECT_NEAR(complexErrorFunction({0.0, 0.0}).real(), 1.0, 1e-7);
    EXPECT_NEAR(complexErrorFunction({0.0, 1.0}).real(), 0.427584, 1e-6);
    EXPECT_NEAR(complexErrorFunction({1.0, 1.0}).real(), 0.304744, 1e-6);
    EXPECT_NEAR(complexErrorFunction({1.0, 1.0}).imag(), 0.208219, 1e-6);
    // y / pi * integral of exp(-t^2) / ((x - t)^2 + y^2), by the trapezoidal rule.
    EXPECT_NEAR(complexErrorFunction({3.9, 3.0}).real(), 0.072061059, 1e-8);
}

TEST(VoigtProfile, becomesAGaussianAndALorentzian) {
    const double width = 0.01;
    const VoigtProfile gauss(width, 0.0);
    for (const double x : {0.0, 0.005, 0.01, 0.02}) {
        const double expected = std::sqrt(std::numbers::ln2 / std::numbers::pi) / width *
                                std::exp(-std::numbers::ln2 * x * x / (width * width));
        EXPECT_NEAR(gauss.at(x) / expected, 1.0, 1e-5) << x;
    }
    const VoigtProfile lorentz(1e-7, 0.07);
    for (const double x : {0.0, 0.01, 0.07, 1.0, 20.0})
        EXPECT_NEAR(lorentz.at(x) * std::numbers::pi * (x * x + 0.07 * 0.07) / 0.07, 1.0, 1e-4)
            << x;
}

TEST(VoigtProfile, hasUnitAreaWhateverItsWidths) {
    for (const double lorentz : {1e-4, 1e-3, 1e-2, 0.1}) {
        const VoigtProfile profile(0.01, lorentz);
        constexpr std::size_t count = 400001;
        std::vector<double> values(count, 0.0);
        profile.add(-20.0, 1e-4, count, 1.0, values.data());
        double area = 0.0;
        for (const double value : values)
            area += value * 1e-4;
        area += 2.0 * lorentz / (std::numbers::pi * 20.0); // the wings beyond
        EXPECT_NEAR(area, 1.0, 2e-5) << lorentz;
    }
}

TEST(VoigtProfile, addsWhatItGivesPointByPoint) {
    const VoigtProfile profile(0.003, 0.001);
    std::vector<double> sum(400, 1.0);
    profile.add(-0.2, 0.001, sum.size(), 2.0, sum.data());
    for (std::size_t i = 0; i < sum.size(); i += 7)
        EXPECT_NEAR(sum[i], 1.0 + 2.0 * profile.at(-0.2 + 0.001 * static_cast<double>(i)),
                    1e-9 * sum[i]);
}

TEST(LineAbsorption, givesOneLineInClosedForm) {
    const LineList list{Gas::CO, {strongLine(2100.0)}, {}};
    const WavenumberGrid grid{2099.0, 0.001, 2001};
    const std::vector<double> k =
        crossSection_cm2(list, rotor, grid, 296.0, 1013.25, 0.0, defaultLineShape(Gas::CO));
    const VoigtProfile profile(3.581163e-7 * 2100.0 * std::sqrt(296.0 / 27.9949), 0.07);
    for (const std::size_t i : {0u, 300u, 900u, 990u, 1000u, 1400u, 2000u}) {
        const double expected = 1e-20 * profile.at(grid.at(i) - 2100.0);
        EXPECT_NEAR(k[i] / expected, 1.0, 2e-4) << grid.at(i);
    }
}

TEST(LineAbsorption, followsBoltzmannAndThePartitionSum) {
    const LineList list{Gas::CO, {strongLine(2100.0)}, {}};
    const WavenumberGrid grid{2095.0, 0.001, 10001};
    auto area = [&](double temperature_K) {
        double sum = 0.0;
        for (const double value : crossSection_cm2(list, rotor, grid, temperature_K, 1.0, 0.0,
                                                   defaultLineShape(Gas::CO)))
            sum += value * grid.step_cm;
        return sum;
    };
    EXPECT_NEAR(area(296.0) / 1e-20, 1.0, 1e-3);
    const double expected = std::pow(296.0 / 220.0, 1.5) *
                            std::exp(-1.438776877 * 300.0 * (1.0 / 220.0 - 1.0 / 296.0)) *
                            std::expm1(-1.438776877 * 2100.0 / 220.0) /
                            std::expm1(-1.438776877 * 2100.0 / 296.0);
    EXPECT_NEAR(area(220.0) / area(296.0), expected, 1e-4 * expected);
}

TEST(LineAbsorption, isTheSumOverLinesWhateverTheGrid) {
    LineList list{Gas::H2O, {}, {}};
    for (int i = 0; i < 60; ++i)
        list.lines.push_back(strongLine(1480.0 + 0.7371 * i, 1e-22 * (1 + i % 7)));
    const LineShape shape = defaultLineShape(Gas::H2O);
    for (const double pressure_hPa : {1013.0, 100.0, 1.0}) {
        const WavenumberGrid fine{1500.0, 0.001, 3000}, coarse{1500.0, 0.05, 60};
        const auto a = crossSection_cm2(list, rotor, fine, 250.0, pressure_hPa, 0.0, shape);
        const auto b = crossSection_cm2(list, rotor, coarse, 250.0, pressure_hPa, 0.0, shape);
        std::vector<double> alone(fine.count, 0.0);
        for (const Line& line : list.lines) {
            const auto one = crossSection_cm2({Gas::H2O, {line}, {}}, rotor, fine, 250.0,
                                              pressure_hPa, 0.0, shape);
            for (std::size_t i = 0; i < alone.size(); ++i)
                alone[i] += one[i];
        }
        for (std::size_t i = 0; i < coarse.count; ++i) {
            EXPECT_NEAR(a[50 * i] / b[i], 1.0, 3e-3) << pressure_hPa << " " << coarse.at(i);
            EXPECT_NEAR(a[50 * i] / alone[50 * i], 1.0, 1e-6);
        }
    }
}

TEST(LineAbsorption, endsAtTheCutWithAndWithoutAPedestal) {
    const LineList list{Gas::H2O, {strongLine(1000.0)}, {}};
    const WavenumberGrid grid{1000.0, 0.01, 3000};
    const auto k = crossSection_cm2(list, rotor, grid, 296.0, 1013.25, 0.0, {25.0, true, false});
    const auto whole =
        crossSection_cm2(list, rotor, grid, 296.0, 1013.25, 0.0, {25.0, false, false});
    EXPECT_NEAR(k[2490] / (whole[2490]), 0.008, 0.002); // 1 - (24.9 / 25)^2
    const VoigtProfile profile(3.581163e-7 * 1000.0 * std::sqrt(296.0 / 18.0106), 0.07);
    EXPECT_NEAR((whole[2000] - k[2000]) / (1e-20 * profile.at(25.0)), 1.0, 1e-3);
    for (std::size_t i = 2700; i < grid.count; ++i) {
        EXPECT_EQ(k[i], 0.0);
        EXPECT_EQ(whole[i], 0.0);
    }
}

TEST(LineAbsorption, weakensTheWingsOfCarbonDioxide) {
    EXPECT_EQ(carbonDioxideChi(2.9, 296.0), 1.0);
    for (const double at_cm : {3.0, 10.0, 70.0})
        EXPECT_NEAR(carbonDioxideChi(at_cm + 1e-9, 250.0), carbonDioxideChi(at_cm - 1e-9, 250.0),
                    1e-8);
    double last = 1.0;
    for (double x = 4.0; x < 300.0; x += 1.0) {
        const double chi = carbonDioxideChi(-x, 296.0);
        EXPECT_LT(chi, last);
        last = chi;
    }
    EXPECT_NEAR(carbonDioxideChi(8.0, 296.0),
                std::exp(-5.0 * (0.416 - 0.354 * std::exp(-1.14256))), 1e-12);
}

TEST(LineAbsorption, refusesAGridOrAirThatIsNone) {
    const LineList list{Gas::CO, {strongLine(2100.0)}, {}};
    EXPECT_THROW((void)crossSection_cm2(list, rotor, {}, 296.0, 1013.0, 0.0, {}), LogicError);
    EXPECT_THROW((void)crossSection_cm2(list, rotor, {1.0, 0.1, 3}, 0.0, 1013.0, 0.0, {}),
                 LogicError);
    EXPECT_THROW((void)crossSection_cm2(list, rotor, {1.0, 0.1, 3}, 296.0, 0.0, 0.0, {}),
                 LogicError);
}

} // namespace
} // namespace irsg::lbl

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tools/atmosphere-tables/lines/Voigt.h"

namespace irsg::lbl {
namespace {

/// Re w(x + i y) by another way: the trapezoidal rule for y / pi * integral of exp(-t^2) / ((x -
/// t)^2 + y^2) and the residue of the pole (Hunter and Regan 1972, Math. Comp. 26, 539), good to
/// 1e-14.
double trapezoidal(double x, double y) {
    constexpr double step = 0.4;
    const double phase = x / step - std::floor(x / step);
    const bool between = phase <= 0.25 || phase >= 0.75; // nodes are kept away from the pole
    double sum = 0.0;
    for (int n = -25; n <= 25; ++n) {
        const double t = (n + (between ? 0.5 : 0.0)) * step;
        sum += std::exp(-t * t) * y / ((x - t) * (x - t) + y * y);
    }
    sum *= step / std::numbers::pi;
    if (y < std::numbers::pi / step) {
        const std::complex<double> z(x, y), i(0.0, 1.0);
        const std::complex<double> turn = std::exp(-2.0 * std::numbers::pi * i * z / step);
        sum += (2.0 * std::exp(-z * z) / (1.0 + (between ? 1.0 : -1.0) * turn)).real();
    }
    return sum;
}

TEST(ComplexErrorFunction, AgreesWithPublishedValues) {
    // Abramowitz and Stegun, table 7.9.
    EXPECT_NEAR(complexErrorFunction({0.0, 0.0}).real(), 1.0, 1e-7);
    EXPECT_NEAR(complexErrorFunction({0.0, 1.0}).real(), 0.427584, 1e-6);
    EXPECT_NEAR(complexErrorFunction({1.0, 1.0}).real(), 0.304744, 1e-6);
    EXPECT_NEAR(complexErrorFunction({1.0, 1.0}).imag(), 0.208219, 1e-6);
    EXPECT_NEAR(complexErrorFunction({3.9, 3.0}).real(), 0.072061, 1e-6);
}

TEST(ComplexErrorFunction, KeepsItsDigitsFromTheCentreToTheWings) {
    for (double y = 1e-6; y < 1e3; y *= 1.9) {
        for (double x = 1e-3; x < 30.0; x *= 1.03) {
            const double expected = trapezoidal(x, y);
            EXPECT_NEAR(complexErrorFunction({x, y}).real() / expected, 1.0, 5e-6) << x << " " << y;
        }
    }
}

TEST(VoigtProfile, IsTheErrorFunctionAtEveryPoint) {
    // Half widths of a Gaussian with sqrt(ln 2) make x and y the distances themselves.
    const double unit = std::sqrt(std::numbers::ln2), rootPi = std::sqrt(std::numbers::pi);
    for (const double y : {1e-6, 1e-4, 0.01, 0.3, 2.0, 9.0, 11.0, 200.0}) {
        const VoigtProfile profile(unit, y);
        std::vector<double> values(2001, 0.0);
        profile.add(-20.0, 0.02, values.size(), rootPi, values.data());
        for (std::size_t i = 0; i < values.size(); i += 3) {
            const double x = -20.0 + 0.02 * static_cast<double>(i);
            const double expected = trapezoidal(std::abs(x), y);
            EXPECT_NEAR(values[i] / expected, 1.0, 5e-6) << x << " " << y;
            EXPECT_NEAR(profile.at(x) * rootPi / expected, 1.0, 5e-6) << x << " " << y;
        }
    }
}

TEST(VoigtProfile, BecomesAGaussianAndALorentzian) {
    const double width = 0.01;
    const VoigtProfile gauss(width, 0.0);
    for (const double x : {0.0, 0.005, 0.01, 0.02}) {
        const double expected = std::sqrt(std::numbers::ln2 / std::numbers::pi) / width *
                                std::exp(-std::numbers::ln2 * x * x / (width * width));
        EXPECT_NEAR(gauss.at(x) / expected, 1.0, 1e-9) << x;
    }
    const VoigtProfile lorentz(1e-7, 0.07);
    for (const double x : {0.0, 0.01, 0.07, 1.0, 20.0, 300.0}) {
        EXPECT_NEAR(lorentz.at(x) * std::numbers::pi * (x * x + 0.07 * 0.07) / 0.07, 1.0, 1e-9)
            << x;
    }
}

TEST(VoigtProfile, HasUnitAreaWhateverItsWidths) {
    for (const double lorentz : {1e-4, 1e-3, 1e-2, 0.1}) {
        const VoigtProfile profile(0.01, lorentz);
        constexpr std::size_t count = 400001;
        std::vector<double> values(count, 0.0);
        profile.add(-20.0, 1e-4, count, 1.0, values.data());
        double area = 0.0;
        for (const double value : values) {
            area += value * 1e-4;
        }
        area += 2.0 * lorentz / (std::numbers::pi * 20.0); // the wings beyond
        EXPECT_NEAR(area, 1.0, 1e-6) << lorentz;
    }
}

TEST(VoigtProfile, AddsToWhatIsThere) {
    // Stretches that end before, in and after the core, of lengths that fill no vector.
    const VoigtProfile profile(0.003, 0.001);
    for (const double first : {-0.2, -0.01, 0.0, 0.1}) {
        for (const std::size_t count : {0u, 1u, 7u, 13u, 400u}) {
            std::vector<double> sum(count + 1, 1.0);
            profile.add(first, 0.001, count, 2.0, sum.data());
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_NEAR(sum[i], 1.0 + 2.0 * profile.at(first + 0.001 * static_cast<double>(i)),
                            1e-9 * sum[i]);
            }
            EXPECT_EQ(sum[count], 1.0);
        }
    }
}

} // namespace
} // namespace irsg::lbl

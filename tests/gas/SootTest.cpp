#include "irsg/gas/Soot.h"

#include <numbers>

#include <gtest/gtest.h>

using namespace irsg;

namespace {

TEST(Soot, AbsorbsInTheRayleighLimit) {
    // n = k = 1: (n^2 - k^2 + 2)^2 + 4 n^2 k^2 = 8, so kappa = 4.5 pi f / lambda.
    EXPECT_NEAR(sootAbsorption_per_m(4.0, 1e-6, {1.0, 1.0}), 4.5 * std::numbers::pi / 4.0, 1e-12);
    EXPECT_EQ(sootAbsorption_per_m(4.0, 1e-6, {1.6, 0.0}), 0.0);
    EXPECT_DOUBLE_EQ(sootAbsorption_per_m(4.0, 3e-6), 3.0 * sootAbsorption_per_m(4.0, 1e-6));
}

TEST(Soot, HasTheIndexOfFlameSoot) {
    // Chang and Charalampopoulos 1990 at 1 um, where the logarithms vanish.
    EXPECT_DOUBLE_EQ(sootRefractiveIndex(1.0).real(), 1.811);
    EXPECT_DOUBLE_EQ(sootRefractiveIndex(1.0).imag(), 0.5821);
    // Measured there at 3.89, 10.9 and 21.1 um, to which the polynomials are fitted. With another
    // sign of the cubic term, as in the source of RADCAL, k would be 2.33 at 10.9 um.
    const double measured[][3] = {{3.89, 2.10, 1.11}, {10.9, 2.78, 1.87}, {21.1, 3.47, 2.58}};
    for (const auto& [um, n, k] : measured) {
        EXPECT_NEAR(sootRefractiveIndex(um).real(), n, 0.12 * n) << um;
        EXPECT_NEAR(sootRefractiveIndex(um).imag(), k, 0.12 * k) << um;
    }
    EXPECT_EQ(sootRefractiveIndex(0.1), sootRefractiveIndex(0.4)) << "held beyond";
    // The engineering form 5.5 f nu (cm-1), within its own spread, at 2 to 5 um.
    for (const double um : {2.0, 3.0, 4.0, 5.0}) {
        EXPECT_NEAR(sootAbsorption_per_m(um, 1e-6) / (550.0 * 1e-6 * 1e4 / um), 1.0, 0.35) << um;
    }
    // Propane soot of Dalzell and Sarofim 1969 at 3 and 4 um: flames differ by the stated error.
    EXPECT_NEAR(sootAbsorption_per_m(3.0, 1e-6) / sootAbsorption_per_m(3.0, 1e-6, {2.21, 1.23}),
                1.0, 0.2);
    EXPECT_NEAR(sootAbsorption_per_m(4.0, 1e-6) / sootAbsorption_per_m(4.0, 1e-6, {2.38, 1.44}),
                1.0, 0.2);
}

} // namespace

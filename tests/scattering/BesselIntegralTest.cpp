#include "irsg/scattering/BesselIntegral.h"

#include <cmath>

#include <gtest/gtest.h>

namespace irsg {
namespace {

TEST(BesselIntegral, HasThePrintedValues) {
    // Abramowitz and Stegun, table 11.1, ten digits.
    EXPECT_NEAR(integralOfJ0(1.0), 0.9197304101, 5e-11);
    EXPECT_NEAR(integralOfJ0(5.0), 0.7153119178, 5e-11);
    EXPECT_NEAR(integralOfJ0(10.0), 1.0670113040, 5e-11);
}

TEST(BesselIntegral, IsSmoothWhereTheTableEnds) {
    const double slope = (integralOfJ0(64.0 + 1e-4) - integralOfJ0(64.0 - 1e-4)) / 2e-4;
    EXPECT_NEAR(slope, ::j0(64.0), 1e-6);
    EXPECT_NEAR(integralOfJ0(64.0), integralOfJ0(std::nextafter(64.0, 0.0)), 1e-11);
}

TEST(BesselIntegral, TendsToOne) {
    EXPECT_NEAR(integralOfJ0(1e6), 1.0 + ::j1(1e6), 1e-9);
}

TEST(BesselIntegral, LosesNothingOfTheDifferenceForSmallArguments) {
    EXPECT_NEAR(besselOverMean(1e-3) / (-1e-6 / 6.0), 1.0, 1e-6);
    const double below = besselOverMean(std::nextafter(2.0, 0.0));
    EXPECT_NEAR(besselOverMean(2.0), below, 1e-11);
}

} // namespace
} // namespace irsg

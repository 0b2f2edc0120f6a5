#include "irsg/gas/NarrowBand.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace irsg;

namespace {

const StrengthLaw laws[] = {StrengthLaw::goody, StrengthLaw::malkmus};

double depthOf(StrengthLaw law, const NarrowBandLayer& layer) {
    NarrowBandSum sum;
    sum.add(layer);
    return sum.opticalDepth(law);
}

TEST(NarrowBand, OfWeakLinesAbsorbsByTheirMeanCoefficient) {
    for (const StrengthLaw law : laws) {
        for (const double depth : {1e-12, 1e-8, 1e-5}) {
            EXPECT_NEAR(depthOf(law, {depth, 5.0, 2.0}) / depth, 1.0, 1e-3);
        }
    }
    // Where lines overlap entirely, X is the depth at any amount.
    for (const StrengthLaw law : laws) {
        EXPECT_NEAR(depthOf(law, {20.0, 1e7, 1.0}), 20.0, 0.01);
    }
}

TEST(NarrowBand, OfStrongLinesGrowsByTheSquareRoot) {
    // Goody and Malkmus: 2 sqrt(a X).
    for (const StrengthLaw law : laws) {
        EXPECT_NEAR(depthOf(law, {1e7, 1e-2, 1e-9}) / (2.0 * std::sqrt(1e-2 * 1e7)), 1.0, 2e-3);
    }
}

TEST(NarrowBand, FollowsTheCurvesOfGrowthOfCollisions) {
    // X / sqrt(1 + X/4a) and 2a (sqrt(1 + X/a) - 1) at X = 3, a = 0.5.
    EXPECT_NEAR(collisionDepth(StrengthLaw::goody, 3.0, 0.5), 3.0 / std::sqrt(2.5), 1e-12);
    EXPECT_NEAR(collisionDepth(StrengthLaw::malkmus, 3.0, 0.5), std::sqrt(7.0) - 1.0, 1e-12);
    EXPECT_EQ(collisionDepth(StrengthLaw::goody, 0.0, 0.5), 0.0);
    EXPECT_EQ(collisionDepth(StrengthLaw::malkmus, 3.0, 0.0), 0.0);
    // 1.7 a sqrt(ln(1 + (0.58824 X/a)^2)) at X = a = 1.
    EXPECT_NEAR(dopplerDepth(StrengthLaw::goody, 1.0, 1.0),
                1.7 * std::sqrt(std::log(1.0 + 0.58824 * 0.58824)), 1e-12);
}

TEST(NarrowBand, CombinesCollisionsAndDopplerBroadening) {
    // NASA SP-3080, eqs. 5-25 and 5-26, by hand for x_c = 0.6, x_D = 0.8 of X = 1.
    const double collision = 0.25 / (1.0 / 0.36 - 1.0); // Goody gives 0.6
    double doppler = 1.0;                               // gives 0.8, found by bisection
    double low = 1e-3, high = 10.0;
    for (int i = 0; i < 200; ++i) {
        doppler = 0.5 * (low + high);
        (dopplerDepth(StrengthLaw::goody, 1.0, doppler) < 0.8 ? low : high) = doppler;
    }
    const double yc = 1.0 - 0.36, yd = 1.0 - 0.64;
    const double y = 1.0 / (yc * yc) + 1.0 / (yd * yd) - 1.0;
    EXPECT_NEAR(depthOf(StrengthLaw::goody, {1.0, collision, doppler}),
                std::sqrt(1.0 - 1.0 / std::sqrt(y)), 1e-9);
}

TEST(NarrowBand, OfEqualLayersIsThatOfTheWhole) {
    for (const StrengthLaw law : laws) {
        NarrowBandSum parts;
        for (int i = 0; i < 7; ++i) {
            parts.add({0.3, 0.2, 0.05});
        }
        EXPECT_NEAR(parts.opticalDepth(law), depthOf(law, {2.1, 0.2, 0.05}), 1e-12);
    }
}

TEST(NarrowBand, StaysBetweenNothingAndTheMeanCoefficient) {
    for (const StrengthLaw law : laws) {
        for (double depth = 1e-9; depth < 1e9; depth *= 10.0) {
            for (double collision = 1e-9; collision < 1e9; collision *= 30.0) {
                for (double doppler = 1e-9; doppler < 1e9; doppler *= 30.0) {
                    const double value = depthOf(law, {depth, collision, doppler});
                    EXPECT_GE(value, 0.0);
                    EXPECT_LE(value, depth);
                }
            }
        }
    }
    EXPECT_EQ(depthOf(StrengthLaw::goody, {0.0, 0.0, 0.0}), 0.0);
    EXPECT_EQ(depthOf(StrengthLaw::goody, {5.0, 0.0, 0.0}), 0.0) << "saturated lines of no width";
}

} // namespace

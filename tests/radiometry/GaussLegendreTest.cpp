#include "irsg/radiometry/GaussLegendre.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

using namespace irsg;

TEST(GaussLegendre, TheTwoPointRuleHasTheNodesOfTheBooks) {
    const GaussRule& rule = gaussLegendre(2);
    EXPECT_NEAR(rule.nodes[0], 0.5 - 0.5 / std::sqrt(3.0), 1e-16);
    EXPECT_NEAR(rule.nodes[1], 0.5 + 0.5 / std::sqrt(3.0), 2e-16);
    EXPECT_NEAR(rule.weights[0], 0.5, 1e-16);
}

TEST(GaussLegendre, IntegratesPolynomialsUpToItsDegreeExactly) {
    for (int points = 1; points <= 32; ++points) {
        const GaussRule& rule = gaussLegendre(points);
        ASSERT_EQ(rule.nodes.size(), static_cast<std::size_t>(points));
        for (int degree = 0; degree <= 2 * points - 1; ++degree) {
            double sum = 0.0;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                sum += rule.weights[i] * std::pow(rule.nodes[i], degree);
            }
            EXPECT_NEAR(sum * (degree + 1), 1.0, 2e-14) << points << " points, degree " << degree;
        }
    }
}

TEST(GaussLegendre, ThereAreRulesOf1To32PointsOnly) {
    EXPECT_THROW((void)gaussLegendre(0), LogicError);
    EXPECT_THROW((void)gaussLegendre(33), LogicError);
}

#include "irsg/geometry/view/Vec3.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace irsg {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Vec3, LengthIsThatOfHypot) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> coordinate(-1.0, 1.0), exponent(-300.0, 300.0);
    for (int i = 0; i < 10'000; ++i) {
        const double scale = i % 2 == 0 ? 1.0 : std::pow(10.0, exponent(random));
        const Vec3 v{scale * coordinate(random), i % 3 == 0 ? 0.0 : scale * coordinate(random),
                     scale * coordinate(random)};
        EXPECT_DOUBLE_EQ(length(v), std::hypot(v.x, v.y, v.z));
    }
}

TEST(Vec3, NoSquareOverflowsOrVanishes) {
    EXPECT_DOUBLE_EQ(length({3e300, 0.0, -4e300}), 5e300);
    EXPECT_DOUBLE_EQ(length({-2e-300, 3e-300, 6e-300}), 7e-300);
    EXPECT_EQ(length({0.0, -0.0, 0.0}), 0.0);
}

TEST(Vec3, WhatIsNoNumberHasNoLengthAndNoDirection) {
    for (const Vec3& v : {Vec3{nan, 0, 0}, Vec3{0, nan, 0}, Vec3{0, 0, nan}, Vec3{1, nan, 2},
                          Vec3{nan, 1, 2}, Vec3{1, 2, nan}}) {
        EXPECT_TRUE(std::isnan(length(v)));
        EXPECT_THROW(normalized(v), LogicError);
    }
    EXPECT_THROW(normalized({0, 0, 0}), LogicError);
    EXPECT_THROW(normalized({infinity, 1, 1}), LogicError);
}

} // namespace
} // namespace irsg

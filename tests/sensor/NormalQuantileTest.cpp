#include "irsg/sensor/NormalQuantile.h"

#include <cmath>

#include <gtest/gtest.h>

namespace irsg {

namespace {

TEST(NormalQuantile, InvertsTheErrorFunction) {
    for (const double z : {-8.5, -7.2, -5.0, -3.0, -1.5, -1.4, -0.3, 0.0, 1e-4, 1.43, 1.45, 2.5}) {
        const double probability = 0.5 * std::erfc(-z / std::sqrt(2.0));
        EXPECT_NEAR(normalQuantile(probability), z, 2e-14 * std::max(1.0, std::abs(z))) << z;
    }
}

} // namespace

} // namespace irsg

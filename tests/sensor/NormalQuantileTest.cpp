#include "irsg/sensor/NormalQuantile.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace irsg {

namespace {

TEST(NormalQuantile, InvertsTheErrorFunction) {
    for (const double z : {-8.5, -7.2, -5.0, -3.0, -1.5, -1.4, -0.3, 0.0, 1e-4, 1.43, 1.45, 2.5}) {
        const double probability = 0.5 * std::erfc(-z / std::sqrt(2.0));
        EXPECT_NEAR(normalQuantile(probability), z, 2e-14 * std::max(1.0, std::abs(z))) << z;
    }
}

TEST(NormalQuantile, ManyAtOnceAreTheSameToTheBit) {
    // More than a block, middle and tails mixed, both edges of the middle.
    std::vector<double> values{
        0.075, 0.925, std::nextafter(0.075, 0.0), std::nextafter(0.925, 1.0), 1e-300, 0x1p-53};
    for (int i = 1; i < 1000; ++i) {
        values.push_back(std::fmod(i * 0.6180339887498949, 1.0));
    }
    std::vector<double> expected;
    for (const double value : values) {
        expected.push_back(normalQuantile(value));
    }
    normalQuantiles(values);
    EXPECT_EQ(values, expected);
}

} // namespace

} // namespace irsg

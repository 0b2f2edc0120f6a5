// The standard deviation of a background from pixel to pixel.
#include "smatcore/analysis/BackgroundClutter.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace smat {
namespace {

constexpr std::size_t width = 300, height = 200;
const std::vector<bool> everywhere(width* height, true);

std::vector<double> picture(double (*value)(double x, double y)) {
    std::vector<double> values;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            values.push_back(value(static_cast<double>(x), static_cast<double>(y)));
        }
    }
    return values;
}

TEST(BackgroundClutter, NoiseThatIsIndependentFromPixelToPixelKeepsItsDeviation) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(50.0, 2.5);
    std::vector<double> values(width * height);
    for (double& value : values) {
        value = normal(random);
    }
    EXPECT_NEAR(pixelDeviation(values, everywhere, width), 2.5, 0.03);
}

TEST(BackgroundClutter, WhatIsEvenOrChangesEvenlyIsNone) {
    EXPECT_NEAR(pixelDeviation(picture([](double, double) { return 7.0; }), everywhere, width), 0.0,
                1e-12);
    EXPECT_NEAR(pixelDeviation(picture([](double x, double y) { return 3.0 * x - 2.0 * y; }),
                               everywhere, width),
                0.0, 1e-9);
    // Of waves along the rows a pixel's difference to its neighbours: 3/4 (1 - cos k).
    const double wave =
        pixelDeviation(picture([](double x, double) { return std::sqrt(2.0) * std::sin(0.5 * x); }),
                       everywhere, width);
    EXPECT_NEAR(wave, std::sqrt(8.0 / 9.0) * 0.75 * (1.0 - std::cos(0.5)), 0.01 * wave);
}

TEST(BackgroundClutter, PixelsBesideOnesThatAreNoBackgroundDoNotCount) {
    std::vector<double> values(width * height, 1.0);
    std::vector<bool> isBackground = everywhere;
    values[100 * width + 100] = 1e6;
    EXPECT_GT(pixelDeviation(values, isBackground, width), 1.0);
    isBackground[100 * width + 100] = false;
    EXPECT_EQ(pixelDeviation(values, isBackground, width), 0.0);
    EXPECT_EQ(pixelDeviation({1.0, 2.0, 3.0, 4.0}, {true, true, true, true}, 2), 0.0);
}

} // namespace
} // namespace smat

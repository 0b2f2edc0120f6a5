// The standard deviation of a background from pixel to pixel.
#include "smatcore/analysis/BackgroundClutter.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace smat {
namespace {

constexpr std::size_t width = 300, height = 200;

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
    EXPECT_NEAR(pixelDeviation(values, width).deviation, 2.5, 0.03);
}

TEST(BackgroundClutter, WhatIsEvenOrChangesEvenlyIsNone) {
    EXPECT_NEAR(pixelDeviation(picture([](double, double) { return 7.0; }), width).deviation, 0.0,
                1e-12);
    EXPECT_NEAR(pixelDeviation(picture([](double x, double y) { return 3.0 * x - 2.0 * y; }), width)
                    .deviation,
                0.0, 1e-9);
    // Of waves along the rows a pixel's difference to its neighbours: 3/4 (1 - cos k).
    const double wave =
        pixelDeviation(picture([](double x, double) { return std::sqrt(2.0) * std::sin(0.5 * x); }),
                       width)
            .deviation;
    EXPECT_NEAR(wave, std::sqrt(8.0 / 9.0) * 0.75 * (1.0 - std::cos(0.5)), 0.01 * wave);
}

TEST(BackgroundClutter, TheMarginDoesNotCount) {
    std::vector<double> values(width * height, 1.0);
    values[3 * width + 100] = 1e6;
    EXPECT_GT(pixelDeviation(values, width).deviation, 1.0);
    EXPECT_GT(pixelDeviation(values, width, 4).deviation, 1.0) << "its neighbours do";
    EXPECT_EQ(pixelDeviation(values, width, 5).deviation, 0.0);
    EXPECT_EQ(pixelDeviation({1.0, 2.0, 3.0, 4.0}, 2).deviation, 0.0);
}

TEST(BackgroundClutter, ItsErrorHoldsTheDeviationOfNoiseAndOfPatches) {
    // 200 pictures each, of which the error, of two standard deviations, holds 19 of 20.
    std::mt19937 random(11);
    std::normal_distribution<double> normal(0.0, 1.0);
    int held = 0;
    constexpr int pictures = 200;
    constexpr std::size_t side = 64;
    for (int n = 0; n < pictures; ++n) {
        std::vector<double> values(side * side);
        for (double& value : values) {
            value = normal(random);
        }
        const PixelDeviation found = pixelDeviation(values, side);
        EXPECT_LT(found.error, 0.08);
        held += std::abs(found.deviation - 1.0) <= found.error;
    }
    EXPECT_GE(held, 183); // 1 % of such tests would have less
}

} // namespace
} // namespace smat

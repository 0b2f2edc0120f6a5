#include "irsg/sensor/FourierTransform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

std::vector<double> someValues(std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(std::sin(static_cast<double>(i * i % 97)) + 0.01 * static_cast<double>(i));
    }
    return values;
}

struct Grid {
    std::size_t width, height;
};

class FourierTransform : public testing::TestWithParam<Grid> {};

TEST_P(FourierTransform, IsTheSumOfItsDefinition) {
    const auto [width, height] = GetParam();
    const std::vector<double> values = someValues(width * height);
    const HalfSpectrum spectrum = transformOf(values, width, height);
    for (std::size_t l = 0; l < height; ++l) {
        for (std::size_t k = 0; k < spectrum.columns(); ++k) {
            std::complex<double> sum = 0.0;
            for (std::size_t y = 0; y < height; ++y) {
                for (std::size_t x = 0; x < width; ++x) {
                    const double turns = static_cast<double>(k * x) / static_cast<double>(width) +
                                         static_cast<double>(l * y) / static_cast<double>(height);
                    sum += std::polar(values[y * width + x], -2.0 * std::numbers::pi * turns);
                }
            }
            ASSERT_LT(std::abs(spectrum.values[l * spectrum.columns() + k] - sum), 1e-10)
                << k << ", " << l;
        }
    }
}

TEST_P(FourierTransform, ComesBack) {
    const auto [width, height] = GetParam();
    const std::vector<double> values = someValues(width * height);
    const std::vector<double> back = transformBack(transformOf(values, width, height));
    ASSERT_EQ(back.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        ASSERT_NEAR(back[i], values[i], 1e-12);
    }
}

TEST_P(FourierTransform, InSinglePrecisionIsTheSame) {
    const auto [width, height] = GetParam();
    const std::vector<double> values = someValues(width * height);
    const HalfSpectrum expected = transformOf(values, width, height);
    const std::vector<float> singles(values.begin(), values.end());
    HalfSpectrumOf<float> spectrum = transformOf(singles, width, height);
    double largest = 0.0;
    for (const std::complex<double>& value : expected.values) {
        largest = std::max(largest, std::abs(value));
    }
    for (std::size_t i = 0; i < expected.values.size(); ++i) {
        ASSERT_LT(std::abs(std::complex<double>(spectrum.values[i]) - expected.values[i]),
                  1e-6 * largest);
    }
    const std::vector<float> back = transformBack(std::move(spectrum));
    for (std::size_t i = 0; i < back.size(); ++i) {
        ASSERT_NEAR(back[i], singles[i], 2e-5); // of numbers up to 14
    }
}

// Odd and even sides, one row, one column, more rows than a thread takes at once.
INSTANTIATE_TEST_SUITE_P(Sides, FourierTransform,
                         testing::Values(Grid{12, 10}, Grid{15, 9}, Grid{8, 1}, Grid{1, 27},
                                         Grid{4, 50}, Grid{36, 3}, Grid{14, 22}, Grid{30, 45}));

TEST(FourierTransformSize, IsTheNextProductOfTwoThreeAndFive) {
    EXPECT_EQ(smoothSize(0), 1u);
    EXPECT_EQ(smoothSize(7), 8u);
    EXPECT_EQ(smoothSize(704), 720u);
    EXPECT_EQ(smoothSize(625), 625u);
}

TEST(FourierTransformSize, RefusesAnotherNumberOfValues) {
    EXPECT_THROW((void)transformOf(std::vector<double>(7), 4, 2), LogicError);
    EXPECT_THROW((void)transformOf(std::vector<double>(), 0, 0), LogicError);
}

} // namespace

} // namespace irsg

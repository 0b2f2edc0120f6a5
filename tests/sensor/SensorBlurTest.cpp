#include "irsg/sensor/SensorBlur.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

constexpr std::size_t width = 26, height = 18;

/// A sensor that blurs rows and columns differently.
SensorDescription drifting() {
    SensorDescription sensor = test::staringSensor();
    sensor.motion.lineOfSightRate_urad_per_s = 6e4;
    return sensor;
}

TEST(SensorBlur, AnyPlaceWithinAPixelHasItsOwnPointSpread) {
    // Of mirrored places the transforms are mirrored: each against its own transform, cells at
    // the middle of an odd number of samples included.
    const PointSpread spread(drifting(), 300.0);
    for (const int samples : {1, 2, 3, 4}) {
        const SensorBlur blur(spread, width, height, samples);
        const auto cells = static_cast<std::size_t>(samples);
        for (std::size_t v = 0; v < cells; ++v) {
            for (std::size_t u = 0; u < cells; ++u) {
                std::vector<float> radiance(width * height * cells * cells, 0.0f);
                radiance[(9 * cells + v) * width * cells + 12 * cells + u] = 1.0f;
                const std::vector<double> found = blur.blurred(radiance);
                const auto placeOf = [&](std::size_t i) {
                    return (static_cast<double>(i) + 0.5) / samples - 0.5;
                };
                const std::vector<double> expected =
                    transformBack(spread.spectrumOf(1.0 / samples, placeOf(u), placeOf(v)));
                const std::size_t side = spread.side_px();
                for (std::size_t y = 0; y < height; ++y) {
                    for (std::size_t x = 0; x < width; ++x) {
                        const std::size_t fromX = (x + side - 12) % side;
                        const std::size_t fromY = (y + side - 9) % side;
                        ASSERT_NEAR(found[y * width + x],
                                    expected[fromY * side + fromX] / (samples * samples), 2e-7)
                            << samples << " samples, place " << u << ", " << v << ", pixel " << x
                            << ", " << y;
                    }
                }
            }
        }
    }
}

TEST(SensorBlur, AnEvenFrameStaysEven) {
    // To far better than single precision, at any level.
    for (const float level : {3e-7f, 0.7f, 4e6f}) {
        const SensorBlur blur(PointSpread(drifting(), 300.0), width, height, 2);
        for (const double value : blur.blurred(std::vector<float>(width * height * 4, level))) {
            ASSERT_NEAR(value / static_cast<double>(level), 1.0, 1e-9);
        }
    }
}

TEST(SensorBlur, AHotCellBesideAColdSkyIsRightToAMillionth) {
    // Linear: the same frame with another level, and a cell of a thousand times the contrast.
    const SensorBlur blur(PointSpread(drifting(), 300.0), width, height, 1);
    std::vector<float> cell(width * height, 0.0f);
    cell[9 * width + 12] = 1.0f;
    const std::vector<double> alone = blur.blurred(cell);
    std::vector<float> both(width * height, 0.25f);
    both[9 * width + 12] = 1000.25f;
    const std::vector<double> found = blur.blurred(both);
    for (std::size_t i = 0; i < alone.size(); ++i) {
        ASSERT_NEAR(found[i], 0.25 + 1000.0 * alone[i], 1e-6 * 1000.0) << i;
    }
}

TEST(SensorBlur, IsEqualOnAnyNumberOfThreads) {
    const SensorBlur blur(PointSpread(drifting(), 300.0), width, height, 3);
    std::vector<float> radiance(width * height * 9);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        radiance[i] = 0.1f + 0.01f * static_cast<float>(i * i % 23);
    }
    setMostThreads(1);
    const std::vector<double> one = blur.blurred(radiance);
    setMostThreads(3);
    const std::vector<double> three = blur.blurred(radiance);
    setMostThreads(0);
    EXPECT_EQ(one, three);
}

TEST(SensorBlur, RefusesAnotherNumberOfCells) {
    const SensorBlur blur(PointSpread(drifting(), 300.0), width, height, 2);
    EXPECT_THROW((void)blur.blurred(std::vector<float>(width * height)), LogicError);
}

} // namespace

} // namespace irsg

#include "irsg/scattering/HazeFunction.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"
#include "irsg/scattering/PixelHaze.h"
#include "tests/scattering/KnownHaze.h"

namespace irsg {
namespace {

TEST(HazeFunction, HasTheClosedFormOfAnExponential) {
    const KnownHaze known{50.0, 0.8};
    const HazeFunction function(known.curve());
    EXPECT_NEAR(function.energy(), 0.8, 1e-12);
    for (const double angle : {1e-5, 1e-4, 1e-3, 3e-3, 0.01, 0.05, 0.3}) {
        SCOPED_TRACE(angle);
        EXPECT_NEAR(function.density_sr(angle) / known.density_sr(angle), 1.0,
                    angle < 0.1 ? 1e-3 : 2e-2); // a millionth of the centre's, of a curve of nodes
        EXPECT_NEAR(function.energyWithin(angle), known.energyWithin(angle), 1e-5);
    }
}

TEST(HazeFunction, HasTheDensityOfAConstantBelowItsFirstFrequency) {
    // A pedestal that ends at f1 is an Airy-like pattern: 2 pi H f1 J1(2 pi f1 t) / (2 pi t).
    const MtfCurve curve({0.0, 10.0, 10.000001}, {1.5, 1.5, 1.0});
    const HazeFunction function(curve);
    const double t = 0.03, a = 2.0 * pi * t;
    EXPECT_NEAR(function.density_sr(t), 2.0 * pi * 0.5 * 10.0 * ::j1(10.0 * a) / a, 1e-3);
}

TEST(PixelHaze, HasTheClosedFormOverEveryPixel) {
    const KnownHaze known{50.0, 0.8};
    const double pitch = 1e-3;
    const PixelHaze haze(HazeFunction(known.curve()), pitch, 200);
    const int places[][2] = {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {5, 0}, {3, 4}, {20, 7}, {100, 60}};
    for (const auto& [x, y] : places) {
        SCOPED_TRACE(testing::Message() << x << ", " << y);
        EXPECT_NEAR(haze.at(x, y) / known.pixel(x, y, pitch), 1.0, 2e-3);
    }
}

TEST(PixelHaze, AccountsForAllEnergy) {
    for (const int support : {1, 2, 7, 64, 300}) {
        const KnownHaze known{20.0, 2.5};
        const PixelHaze haze(HazeFunction(known.curve()), 5e-4, support);
        double sum = 0.0;
        for (int y = -support; y <= support; ++y) {
            for (int x = -support; x <= support; ++x) {
                sum += haze.at(x, y);
            }
        }
        EXPECT_NEAR(sum, haze.energy(), 1e-9) << support;
        EXPECT_NEAR(haze.energy() + haze.cut(), 2.5, 1e-9) << support;
        EXPECT_GT(haze.cut(), 0.0);
    }
}

TEST(PixelHaze, IsNothingBeyondItsSupport) {
    const PixelHaze haze(HazeFunction(KnownHaze{20.0, 2.5}.curve()), 5e-4, 40);
    EXPECT_EQ(haze.at(41, 0), 0.0);
    EXPECT_EQ(haze.at(35, 35), 0.0);
    EXPECT_EQ(haze.at(-3, 4), haze.at(4, 3));
}

} // namespace
} // namespace irsg

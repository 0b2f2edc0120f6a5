#include "irsg/sensor/ResolvableTemperature.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/SensorNumbers.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

using Direction = ResolvableTemperature::Direction;

/// A clear circular pupil and a full pixel alone blur it.
double transferInClosedForm(const SensorDescription& sensor, double f) {
    const double cutoff = sensor.optics.aperture_m / 4e-6;
    const double x = f / cutoff;
    const double diffraction = 2.0 / pi * (std::acos(x) - x * std::sqrt(1.0 - x * x));
    const double turn = pi * f * sensor.pixelAngle_rad();
    return diffraction * std::sin(turn) / turn;
}

TEST(ResolvableTemperature, IsTheClosedFormOfFourBars) {
    const SensorDescription sensor = test::staringSensor();
    const double netd_K = sensorNumbers(sensor, 300.0, ConeConvention::exact, 1.0).netd_K;
    const ResolvableTemperature resolvable(sensor, 300.0, {.threshold = 2.0, .integration_s = 0.3});
    for (const double f : {100.0, 1000.0, 3000.0, 6600.0}) {
        // First harmonic pi^2 / 8; the noise of a bar 1/(2f) wide and seven times as long, in
        // nine frames.
        const double bar_px = 1.0 / (2.0 * f * sensor.pixelAngle_rad());
        const double noise_K = netd_K / std::sqrt(7.0 * bar_px * bar_px) / 3.0;
        const double expected_K = pi * pi / 8.0 * 2.0 * noise_K / transferInClosedForm(sensor, f);
        EXPECT_NEAR(resolvable.mrtd_K(f, Direction::horizontal) / expected_K, 1.0, 1e-6) << f;
        EXPECT_NEAR(resolvable.mrtd_K(f, Direction::vertical) / expected_K, 1.0, 1e-6) << f;
    }
    EXPECT_EQ(resolvable.mrtd_K(0.0, Direction::horizontal), 0.0);
    EXPECT_EQ(resolvable.mrtd_K(6700.0, Direction::horizontal),
              std::numeric_limits<double>::infinity()); // Nyquist's is 6666.7
}

TEST(ResolvableTemperature, AFrequencyIsResolvedAtItsOwnDifference) {
    SensorDescription sensor = test::staringSensor();
    sensor.motion.lineOfSightRate_urad_per_s = 5e4; // 100 urad along the rows
    const ResolvableTemperature resolvable(sensor, 290.0);
    for (const double f : {50.0, 800.0, 4000.0}) {
        for (const Direction direction : {Direction::horizontal, Direction::vertical}) {
            EXPECT_NEAR(resolvable.frequency_per_rad(resolvable.mrtd_K(f, direction), direction) /
                            f,
                        1.0, 1e-9);
        }
    }
    EXPECT_GT(resolvable.mrtd_K(4000.0, Direction::horizontal),
              1.2 * resolvable.mrtd_K(4000.0, Direction::vertical));
    EXPECT_NEAR(resolvable.frequency_per_rad(0.05),
                std::sqrt(resolvable.frequency_per_rad(0.05, Direction::horizontal) *
                          resolvable.frequency_per_rad(0.05, Direction::vertical)),
                1e-9);
    EXPECT_EQ(resolvable.frequency_per_rad(0.0), 0.0);
    EXPECT_EQ(resolvable.frequency_per_rad(1e6), resolvable.nyquist_per_rad());
}

TEST(ResolvableTemperature, BothDirectionsTogetherHaveADifferenceOfTheirOwn) {
    SensorDescription sensor = test::staringSensor();
    const ResolvableTemperature alike(sensor, 290.0);
    // Of equal directions it is that of each, at Nyquist's frequency as well.
    for (const double f : {300.0, 4000.0, alike.nyquist_per_rad()}) {
        EXPECT_NEAR(alike.mrtd_K(f) / alike.mrtd_K(f, Direction::horizontal), 1.0, 1e-9) << f;
    }
    EXPECT_EQ(alike.mrtd_K(0.0), 0.0);
    EXPECT_EQ(alike.mrtd_K(1.001 * alike.nyquist_per_rad()),
              std::numeric_limits<double>::infinity());
    sensor.motion.lineOfSightRate_urad_per_s = 5e4;
    const ResolvableTemperature unlike(sensor, 290.0);
    EXPECT_NEAR(unlike.frequency_per_rad(unlike.mrtd_K(4000.0)) / 4000.0, 1.0, 1e-9);
    EXPECT_GT(unlike.mrtd_K(4000.0), unlike.mrtd_K(4000.0, Direction::vertical));
    EXPECT_LT(unlike.mrtd_K(4000.0), unlike.mrtd_K(4000.0, Direction::horizontal));
}

TEST(ResolvableTemperature, NothingIsResolvedPastAReversal) {
    SensorDescription sensor = test::staringSensor();
    sensor.optics.defocus_waves = 1.0;
    sensor.optics.defocusWavelength_um = 4.0;
    sensor.detector.pitch_um = 4.0; // so that Nyquist's frequency lies beyond it
    sensor.check();
    const ResolvableTemperature resolvable(sensor, 300.0);
    const double end = resolvable.frequency_per_rad(1e9, Direction::horizontal);
    EXPECT_LT(end, 0.5 * resolvable.nyquist_per_rad());
    EXPECT_NEAR(SensorTransfer(sensor, 300.0).at(end, 0.0), 0.0, 1e-6);
    EXPECT_EQ(resolvable.mrtd_K(1.5 * end, Direction::horizontal),
              std::numeric_limits<double>::infinity());
}

TEST(ResolvableTemperature, FramesDoNotAverageThePattern) {
    SensorDescription sensor = test::staringSensor();
    sensor.noise.vh = 0.5;
    const auto mrtd_K = [&](double rate_Hz) {
        sensor.electronics.frameRate_Hz = rate_Hz;
        return ResolvableTemperature(sensor, 300.0).mrtd_K(1000.0, Direction::horizontal);
    };
    // Slower than the eye there is one frame.
    EXPECT_NEAR(mrtd_K(5.0) / mrtd_K(1.0), 1.0, 1e-12);
    EXPECT_NEAR(mrtd_K(500.0) / mrtd_K(5.0), std::hypot(0.1, 0.5) / std::hypot(1.0, 0.5), 1e-9);
}

TEST(ResolvableTemperature, RefusesWhatCannotBe) {
    const SensorDescription sensor = test::staringSensor();
    EXPECT_THROW(ResolvableTemperature(sensor, 0.0), InputError);
    EXPECT_THROW(ResolvableTemperature(sensor, 300.0, {.threshold = 0.0}), InputError);
    EXPECT_THROW(ResolvableTemperature(sensor, 300.0, {.integration_s = -1.0}), InputError);
}

TEST(TaskProbability, IsTheTargetTransferFunction) {
    // Holst's table of the function: 1.00 at 3, 0.95 at 2, 0.80 at 1.5, 0.30 at 0.75, 0.10 at 0.5,
    // 0.02 at 0.25 times the cycles of 50 %.
    EXPECT_EQ(taskProbability(0.75, 0.75), 0.5);
    EXPECT_NEAR(taskProbability(6.0, 3.0), 0.95, 0.01);
    EXPECT_NEAR(taskProbability(4.5, 3.0), 0.80, 0.025);
    EXPECT_NEAR(taskProbability(2.25, 3.0), 0.30, 0.02);
    EXPECT_NEAR(taskProbability(1.5, 3.0), 0.10, 0.01);
    EXPECT_NEAR(taskProbability(0.75, 3.0), 0.02, 0.01);
    EXPECT_EQ(taskProbability(0.0, 3.0), 0.0);
    EXPECT_EQ(taskProbability(-1.0, 3.0), 0.0);
    for (const double probability : {1e-6, 0.02, 0.3, 0.5, 0.9, 0.999999}) {
        EXPECT_NEAR(taskProbability(taskCycles(probability, 6.0), 6.0) / probability, 1.0, 1e-9);
    }
    EXPECT_THROW((void)taskCycles(1.0, 3.0), InputError);
    EXPECT_THROW((void)taskCycles(0.0, 3.0), InputError);
    EXPECT_THROW((void)taskCycles(0.5, 0.0), InputError);
}

} // namespace

} // namespace irsg

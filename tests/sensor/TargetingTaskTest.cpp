#include "irsg/sensor/TargetingTask.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

using Direction = TargetingTask::Direction;

TEST(EyeThreshold, IsBartensFormula) {
    // Worked out by hand for 34 cd/m2, a picture of 20 degrees and 4 cycles/degree:
    // a = 540 (1 + 0.7 / 34)^-0.2 / (1 + 12 / (20 (7/3)^2)) = 484.417,
    // b = 0.3 (1 + 100 / 34)^0.15 = 0.368539.
    const double a = 540.0 * std::pow(1.0205882353, -0.2) / (1.0 + 0.6 / 5.4444444444);
    const double b = 0.3 * std::pow(3.9411764706, 0.15);
    EXPECT_NEAR(a, 484.42, 1.0);
    EXPECT_NEAR(b, 0.36853, 1e-3);
    const double sensitivity =
        a * 4.0 * std::exp(-4.0 * b) * std::sqrt(1.0 + 0.06 * std::exp(4.0 * b));
    EXPECT_NEAR(eyeThreshold(4.0, 34.0, 20.0) * sensitivity, 1.0, 1e-9);
    // Contrast sensitivity is a few hundred where it is best, at some cycles/degree, and more light
    // and a larger picture let the eye see more.
    double best = 1.0, where = 0.0;
    for (double u = 0.1; u < 60.0; u *= 1.02) {
        if (eyeThreshold(u, 34.0, 20.0) < best) {
            best = eyeThreshold(u, 34.0, 20.0);
            where = u;
        }
    }
    EXPECT_GT(where, 1.5);
    EXPECT_LT(where, 6.0);
    EXPECT_GT(1.0 / best, 200.0);
    EXPECT_LT(1.0 / best, 700.0);
    EXPECT_LT(eyeThreshold(2.0, 100.0, 20.0), eyeThreshold(2.0, 10.0, 20.0));
    EXPECT_LT(eyeThreshold(0.5, 34.0, 20.0), eyeThreshold(0.5, 34.0, 5.0));
}

/// Without noise worth the name.
SensorDescription quietSensor() {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.band = {3.0, 5.0};
    sensor.detector.columns = 640;
    sensor.detector.rows = 512;
    sensor.detector.well_e = 1e12;
    sensor.electronics.gain = 1.0;
    return sensor;
}

/// The definition by brute force: sqrt(C / CTF) summed where CTF < C.
double integralOf(const TargetingTask& task, double nyquist, double contrast, Direction direction) {
    constexpr int steps = 8000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double threshold = task.threshold(nyquist * (i + 0.5) / steps, direction);
        sum += threshold < contrast ? std::sqrt(contrast / threshold) * nyquist / steps : 0.0;
    }
    return sum;
}

TEST(TargetingTask, IsTheIntegralOfItsDefinition) {
    SensorDescription sensor = quietSensor();
    for (const double smear : {0.0, 3e4}) {
        sensor.motion.lineOfSightRate_urad_per_s = smear;
        for (const SensorDisplay& display :
             {SensorDisplay(),
              SensorDisplay{.pixel_mrad = 0.3, .luminance_cd_m2 = 5.0, .sceneContrast_K = 3.0}}) {
            const TargetingTask task(sensor, 300.0, {}, display);
            const double nyquist = 0.5 / sensor.pixelAngle_rad();
            for (const double difference : {0.05, 0.5, 4.0}) {
                const double contrast = std::min(1.0, 0.5 * difference / display.sceneContrast_K);
                const double expected =
                    std::sqrt(integralOf(task, nyquist, contrast, Direction::horizontal) *
                              integralOf(task, nyquist, contrast, Direction::vertical));
                EXPECT_NEAR(task.cycles_per_rad(difference) / expected, 1.0, 1e-3)
                    << difference << " K, " << smear;
            }
        }
    }
}

TEST(TargetingTask, ItsThresholdIsTheEyesThroughTheTransferOfSensorAndDisplay) {
    const SensorDescription sensor = quietSensor();
    const SensorDisplay display;
    const TargetingTask task(sensor, 300.0, {}, display);
    const SensorTransfer transfer(sensor, 300.0);
    const PixelResponse response(sensor);
    const double noise_K = perceivedNoise_K(sensor, response.noise(response.signal(300.0)),
                                            response.contrast_per_K(300.0), {});
    const double p = sensor.pixelAngle_rad();
    const double field_deg = degrees(0.8e-3) * std::sqrt(640.0 * 512.0);
    for (const double f : {0.05 / p, 0.2 / p, 0.4 / p}) {
        const double shown = std::sin(pi * f * p) / (pi * f * p);
        const double eye =
            eyeThreshold(f * p / degrees(0.8e-3), 34.0, field_deg) / (transfer.at(f, 0.0) * shown);
        // The bandwidth by brute force over g = 0 to 40 f.
        double bandwidth = 0.0;
        for (int i = 0; i < 200000; ++i) {
            const double g = 40.0 * f * (i + 0.5) / 200000.0, octave = std::log(g / f);
            const double through =
                std::exp(-2.2 * octave * octave) * std::sin(pi * g * p) / (pi * g * p);
            bandwidth += 2.0 * through * through * 40.0 * f / 200000.0;
        }
        const double density = p * p * 0.2 * noise_K * noise_K;
        const double noise = 169.6 * 169.6 * density * bandwidth / p / (10.0 * 10.0);
        EXPECT_NEAR(task.threshold(f, Direction::horizontal) / (eye * std::sqrt(1.0 + noise)), 1.0,
                    1e-5)
            << f * p;
        EXPECT_GT(noise, 0.0);
    }
}

TEST(TargetingTask, NoiseAndBlurShortenItAndContrastAboveOneIsOne) {
    SensorDescription sensor = quietSensor();
    const TargetingTask task(sensor, 300.0);
    EXPECT_LT(task.cycles_per_rad(1.0, 0.5), task.cycles_per_rad(1.0, 0.05));
    EXPECT_EQ(task.cycles_per_rad(0.0), 0.0);
    EXPECT_EQ(task.cycles_per_rad(20.0), task.cycles_per_rad(200.0));
    EXPECT_EQ(task.cycles_per_rad(-2.0), task.cycles_per_rad(2.0));
    sensor.motion.jitter_urad = 80.0;
    EXPECT_LT(TargetingTask(sensor, 300.0).cycles_per_rad(1.0), task.cycles_per_rad(1.0));
}

TEST(TargetingTask, ItsProbabilityIsOfTheLawAndComesBack) {
    EXPECT_EQ(taskProbability(14.5, 14.5, targetingLaw), 0.5);
    // x = 2: E = 1.99, 2^1.99 = 3.9724.
    EXPECT_NEAR(taskProbability(5.4, 2.7, targetingLaw), 3.97237 / 4.97237, 1e-5);
    for (const double probability : {0.1, 0.5, 0.95}) {
        EXPECT_NEAR(
            taskProbability(taskCycles(probability, 18.8, targetingLaw), 18.8, targetingLaw),
            probability, 1e-12);
    }
}

TEST(TargetingTask, RefusesDisplaysThatCannotBe) {
    EXPECT_THROW(TargetingTask(quietSensor(), 300.0, {}, {.sceneContrast_K = 0.0}), InputError);
    EXPECT_THROW(TargetingTask(quietSensor(), 300.0, {}, {.pixel_mrad = -1.0}), InputError);
    EXPECT_THROW(TargetingTask(quietSensor(), 300.0, {}, {.luminance_cd_m2 = 0.0}), InputError);
    EXPECT_THROW(TargetingTask(quietSensor(), 0.0), InputError);
}

TEST(NominalRange, IsWhereTheTargetsDifferenceIsJustResolved) {
    SensorDescription sensor = quietSensor();
    sensor.electronics.readNoise_e = 2000.0;
    const ResolvableTemperature resolvable(sensor, 300.0);
    double before = 1e9;
    for (const JohnsonTask& task : nominalTasks()) {
        for (const double extinction : {0.2, 1.0}) {
            const double range_m =
                nominalRange_m(resolvable, {.extinction_per_km = extinction}, task.cyclesOfHalf);
            const double frequency = task.cyclesOfHalf * range_m / 2.3;
            EXPECT_LE(range_m, before); // equal where sampling ends both
            before = range_m;
            // The difference that is left is the MRTD there, unless sampling is what ends it.
            const double left_K = 2.0 * std::exp(-1e-3 * extinction * range_m);
            if (frequency < 0.999 * resolvable.nyquist_per_rad()) {
                EXPECT_NEAR(resolvable.mrtd_K(frequency) / left_K, 1.0, 1e-6);
            } else {
                EXPECT_GE(left_K, resolvable.mrtd_K(0.998 * resolvable.nyquist_per_rad()));
            }
        }
        before = 1e9;
    }
    // Sampling alone: Nyquist's frequency times the target's side through the cycles.
    const double sampled_m = nominalRange_m(ResolvableTemperature(quietSensor(), 300.0),
                                            {.difference_K = 1e3, .extinction_per_km = 0.0}, 6.0);
    EXPECT_NEAR(sampled_m, 0.5 * (0.2 / 15e-6) * 2.3 / 6.0, 1e-6 * sampled_m);
    EXPECT_THROW((void)nominalRange_m(resolvable, {.extinction_per_km = -1.0}, 1.0), InputError);
    EXPECT_THROW((void)nominalRange_m(resolvable, {.side_m = 0.0}, 1.0), InputError);
}

} // namespace

} // namespace irsg

#include "irsg/sensor/SensorNumbers.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/ResolvableTemperature.h"
#include "irsg/sensor/TargetingTask.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

using enum ConeConvention;

/// The photon radiance of a black body, photons s-1 m-2 sr-1, by Simpson's rule of our own.
double photonRadiance(double from_um, double to_um, double temperature_K) {
    constexpr int steps = 20000;
    const auto at = [&](double um) {
        const double metres = 1e-6 * um;
        const double x = planckConstant_J_s * speedOfLight_m_s /
                         (metres * boltzmannConstant_J_K * temperature_K);
        return 2.0 * speedOfLight_m_s / std::pow(metres, 4) / std::expm1(x);
    };
    double sum = at(from_um) + at(to_um);
    for (int i = 1; i < steps; ++i) {
        sum += (i % 2 == 1 ? 4.0 : 2.0) * at(from_um + (to_um - from_um) * i / steps);
    }
    return sum * 1e-6 * (to_um - from_um) / (3.0 * steps);
}

TEST(SensorNumbers, ElectronsAreThePhotonIntegral) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.band = {3.0, 5.0};
    for (const double background_K : {220.0, 300.0, 800.0}) {
        const double photons = photonRadiance(3.0, 5.0, background_K);
        const double area = std::pow(15e-6, 2);
        const double electrons = area * 2e-3 * 0.8 * 0.7 * photons;
        const PixelResponse exactly(sensor, exact), small(sensor, smallAngle);
        EXPECT_NEAR(exactly.signal(background_K).scene / (electrons * pi / 17.0), 1.0, 1e-7);
        EXPECT_NEAR(small.signal(background_K).scene / (electrons * pi / 16.0), 1.0, 1e-7);
    }
}

TEST(SensorNumbers, ElectronsAreThoseOfPybsm) {
    // pyBSM 0.16.1: blackbody_radiance, at_focal_plane_irradiance, photon_detection_rate, by the
    // trapezoidal rule over 200001 wavelengths. Its cone is 1/(4F^2+1), its constants those of
    // 2014, which lowers it by 4e-6.
    SensorDescription sensor = test::staringSensor();
    sensor.detector.band = {3.0, 5.0};
    EXPECT_NEAR(PixelResponse(sensor, exact).signal(300.0).scene / 1948045.686806198, 1.0, 1e-5);
}

TEST(SensorNumbers, SpectraOfTransmissionAndEfficiencyAreMultipliedThenIntegrated) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.band = {3.0, 5.0};
    sensor.optics.transmission = Spectrum({3.0, 4.0, 5.0}, {0.2, 0.9, 0.5});
    sensor.detector.response = Spectrum({3.0, 3.7, 5.0}, {0.1, 0.8, 0.4});
    constexpr int steps = 200000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double um = 3.0 + 2.0 * (i + 0.5) / steps;
        sum += planckRadiance_W_m2_sr_um(um, 300.0) * sensor.optics.transmission.at(um) *
               sensor.detector.response.at(um) * 1e-6 * um /
               (planckConstant_J_s * speedOfLight_m_s) * 2.0 / steps;
    }
    const double expected = std::pow(15e-6, 2) * pi / 17.0 * 2e-3 * sum;
    EXPECT_NEAR(PixelResponse(sensor).signal(300.0).scene / expected, 1.0, 1e-6);
    // The band that images are rendered in gives the same.
    const double byBand =
        bandRadiance_W_m2_sr(sensor.band(), 300.0) * PixelResponse(sensor).signalPerRadiance();
    EXPECT_NEAR(byBand / expected, 1.0, 1e-5);
}

TEST(SensorNumbers, ANarrowBandHasClosedForms) {
    SensorDescription sensor = test::staringSensor();
    sensor.electronics.readNoise_e = 200.0;
    sensor.detector.darkCurrent_e_per_s = 1e7;
    const double ensquared = 0.6;
    const SensorNumbers numbers = sensorNumbers(sensor, 300.0, exact, ensquared);
    const double area = std::pow(15e-6, 2), pupil = pi * 0.0025;
    const double perJoule = 0.7 * 4e-6 / (planckConstant_J_s * speedOfLight_m_s); // electrons
    const double radiance = planckRadiance_W_m2_sr_um(4.0, 300.0) * 2e-3;
    const double electrons = area * pi / 17.0 * 2e-3 * 0.8 * perJoule * radiance;
    EXPECT_NEAR(numbers.signal.scene / electrons, 1.0, 1e-5);
    EXPECT_NEAR(numbers.signal.dark, 2e4, 1e-9);
    const double noise = std::sqrt(electrons + 2e4 + 200.0 * 200.0 + 100.0 / 12.0);
    EXPECT_NEAR(numbers.noise.temporal() / noise, 1.0, 1e-5);
    const double x = secondRadiationConstant_um_K / (4.0 * 300.0);
    const double slope = electrons * x / 300.0 / -std::expm1(-x);
    EXPECT_NEAR(numbers.netd_K * slope / noise, 1.0, 1e-4);
    EXPECT_NEAR(numbers.ner_W_m2_sr * electrons / radiance / noise, 1.0, 1e-3);
    EXPECT_NEAR(numbers.nei_W_m2 * pupil * 2e-3 * 0.8 * perJoule * ensquared / noise, 1.0, 1e-3);
    EXPECT_NEAR(numbers.neiWholePoint_W_m2, numbers.nei_W_m2 * ensquared, 1e-20);
    EXPECT_NEAR(numbers.nep_W * perJoule * 2e-3 / noise, 1.0, 1e-3);
    EXPECT_NEAR(numbers.dStar_cm_sqrtHz_W * numbers.nep_W / (1.5e-3 * std::sqrt(250.0)), 1.0, 1e-9);
    EXPECT_NEAR(numbers.wellFill, numbers.signal.total() / 7e6, 1e-12);
}

TEST(SensorNumbers, OpticsAndHousingShineToo) {
    SensorDescription sensor = test::staringSensor();
    sensor.optics.temperature_K = 300.0;
    sensor.optics.emissivity = 0.2;
    sensor.optics.housingTemperature_K = 300.0;
    sensor.optics.coldShieldEfficiency = 0.9;
    const PixelSignal signal = PixelResponse(sensor).signal(300.0);
    EXPECT_NEAR(signal.optics / signal.scene, 0.2 / 0.8, 1e-9);
    EXPECT_NEAR(signal.housing / signal.scene, 0.1 * 16.0 / 0.8, 1e-9); // pi less pi / 17
}

TEST(SensorNumbers, AThermalDetectorsNoiseIsItsNetd) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.responseKind = ResponseKind::absorptance;
    sensor.detector.band = {8.0, 14.0};
    sensor.detector.well_e.reset();
    sensor.detector.thermalNetd_K = 0.05;
    sensor.detector.thermalNetdTemperature_K = 300.0;
    sensor.electronics.gain = 1e-16;
    sensor.check();
    EXPECT_NEAR(sensorNumbers(sensor, 300.0, exact, 0.7).netd_K, 0.05, 1e-6);
    EXPECT_GT(sensorNumbers(sensor, 250.0, exact, 0.7).netd_K, 0.06);
    // Absorbed power.
    EXPECT_NEAR(PixelResponse(sensor).signal(300.0).scene,
                0.56 * std::pow(15e-6, 2) * pi / 17.0 *
                    bandRadiance_W_m2_sr(Band::topHat(8.0, 14.0), 300.0),
                1e-18);
}

TEST(SensorNumbers, ABackgroundThatRadiatesNothingHasAnInfiniteNetd) {
    SensorDescription sensor = test::staringSensor();
    sensor.optics.emissivity = 0.1;
    sensor.optics.temperature_K = 1e-300;
    for (const double background_K : {1e-300, 0.1, 3.0}) {
        const SensorNumbers numbers = sensorNumbers(sensor, background_K, exact, 1.0);
        EXPECT_TRUE(std::isinf(numbers.netd_K)) << background_K;
        EXPECT_EQ(numbers.signal.total(), 0.0) << background_K;
        EXPECT_GT(numbers.nei_W_m2, 0.0);
        EXPECT_THROW(ResolvableTemperature(sensor, background_K, {}), InputError);
        EXPECT_THROW(TargetingTask(sensor, background_K, {}, {}), InputError);
    }
}

TEST(SensorNumbers, PatternNoiseIsInPartsOfTheTemporalOneAtTheReference) {
    SensorDescription sensor = test::staringSensor();
    sensor.noise = {.referenceTemperature_K = 300.0, .tv = 0.3, .vh = 0.4};
    const SensorNumbers numbers = sensorNumbers(sensor, 300.0, exact, 1.0);
    EXPECT_NEAR(numbers.noise.pattern / numbers.noise.temporal(), 0.5, 1e-12);
    EXPECT_NEAR(numbers.totalNetd_K / numbers.netd_K, std::sqrt(1.25), 1e-12);
    EXPECT_NEAR(sensorNumbers(sensor, 350.0, exact, 1.0).noise.pattern, numbers.noise.pattern,
                1e-9);
    EXPECT_THROW(sensorNumbers(sensor, 0.0, exact, 1.0), InputError);
}

} // namespace

} // namespace irsg

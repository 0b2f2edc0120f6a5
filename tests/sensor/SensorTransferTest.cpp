#include "irsg/sensor/SensorTransfer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"

#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/PupilTransfer.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

double named(const std::vector<SensorTransfer::Component>& components, const std::string& name) {
    for (const auto& component : components) {
        if (component.name == name) {
            return component.value;
        }
    }
    ADD_FAILURE() << "no component " << name;
    return NAN;
}

TEST(SensorTransfer, EachComponentHasItsClosedForm) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.fillFactor = 0.81;
    sensor.optics.aberrationBlur_urad = 12.0;
    sensor.motion = {.jitter_urad = 20.0, .lineOfSightRate_urad_per_s = 3e4};
    sensor.detector.timeConstant_s = 1e-3;
    sensor.check();
    const SensorTransfer transfer(sensor);
    const double f = 7000.0, u = f * 4e-6 / 0.1;
    const auto parts = transfer.components(f, 0.0);
    EXPECT_NEAR(named(parts, "diffraction"), 2.0 / pi * (std::acos(u) - u * std::sqrt(1.0 - u * u)),
                1e-6);
    EXPECT_EQ(named(parts, "defocus"), 1.0);
    const auto sine = [](double x) { return std::sin(pi * x) / (pi * x); };
    EXPECT_NEAR(named(parts, "detector"), sine(0.9 * 15e-6 / 0.2 * f), 1e-12);
    EXPECT_NEAR(named(parts, "aberration"), std::exp(-2.0 * std::pow(pi * 12e-6 * f, 2)), 1e-12);
    EXPECT_NEAR(named(parts, "jitter"), std::exp(-2.0 * std::pow(pi * 20e-6 * f, 2)), 1e-12);
    EXPECT_NEAR(named(parts, "motion"), sine(3e4 * 1e-6 * 2e-3 * f), 1e-12);
    EXPECT_NEAR(named(parts, "time_constant"),
                1.0 / std::sqrt(1.0 + std::pow(2.0 * pi * f * 0.03 * 1e-3, 2)), 1e-12);
    double product = 1.0;
    for (const auto& part : parts) {
        product *= part.value;
    }
    EXPECT_NEAR(transfer.at(f, 0.0), product, 1e-12);
    // Motion is along the rows.
    EXPECT_EQ(named(transfer.components(0.0, f), "motion"), 1.0);
    EXPECT_EQ(named(transfer.components(0.0, f), "time_constant"), 1.0);
    EXPECT_NEAR(transfer.at(0.0, 0.0), 1.0, 1e-12);
}

TEST(SensorTransfer, DefocusIsInWavesOfItsWavelength) {
    SensorDescription sensor = test::staringSensor();
    sensor.optics.defocus_waves = 1.0;
    sensor.optics.defocusWavelength_um = 2.0;
    const SensorTransfer transfer(sensor);
    const double f = 9000.0;
    EXPECT_NEAR(transfer.optics(f, 0.0),
                pupilTransfer(PupilShape::circular, 0.0, 0.5, 2.0 * f * 4e-6 / 0.1, 0.0), 1e-4);
    const auto parts = transfer.components(f, 0.0);
    EXPECT_NEAR(named(parts, "diffraction") * named(parts, "defocus"), transfer.optics(f, 0.0),
                1e-12);
}

TEST(SensorTransfer, AWideBandIsAveragedByItsSignal) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.band = {3.0, 5.0};
    sensor.detector.response = Spectrum({3.0, 4.0, 5.0}, {0.1, 0.8, 0.4});
    sensor.optics.transmission = Spectrum({3.0, 5.0}, {0.5, 0.9});
    sensor.check();
    for (const double source_K : {250.0, 300.0, 900.0}) {
        const SensorTransfer transfer(sensor, source_K);
        for (const double f : {1000.0, 12000.0, 24000.0, 30000.0}) {
            double sum = 0.0, weights = 0.0;
            constexpr int steps = 4000;
            for (int i = 0; i < steps; ++i) {
                const double um = 3.0 + 2.0 * (i + 0.5) / steps;
                const double weight = planckRadiance_W_m2_sr_um(um, source_K) * um *
                                      sensor.detector.response.at(um) *
                                      sensor.optics.transmission.at(um);
                const double u = std::min(1.0, f * 1e-6 * um / 0.1);
                sum += weight * 2.0 / pi * (std::acos(u) - u * std::sqrt(1.0 - u * u));
                weights += weight;
            }
            EXPECT_NEAR(transfer.diffraction(f, 0.0), sum / weights, 1e-5) << source_K << " " << f;
        }
    }
    EXPECT_THROW(SensorTransfer(sensor, 0.0), InputError);
}

} // namespace

} // namespace irsg

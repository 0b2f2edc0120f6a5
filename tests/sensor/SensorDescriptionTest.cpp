#include "irsg/sensor/SensorDescription.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

TEST(SensorDescription, AConeHasBothConventions) {
    SensorDescription sensor = test::staringSensor(); // F/2
    EXPECT_NEAR(sensor.optics.cone_sr(ConeConvention::exact), pi / 17.0, 1e-14);
    EXPECT_NEAR(sensor.optics.cone_sr(ConeConvention::smallAngle), pi / 16.0, 1e-14);
    sensor.optics.pupil = PupilShape::annular;
    sensor.optics.obscuration = 0.5;
    EXPECT_NEAR(sensor.optics.cone_sr(ConeConvention::exact), pi / 17.0 - pi / 65.0, 1e-14);
    EXPECT_NEAR(sensor.optics.apertureArea_m2(), 0.75 * pi * 0.0025, 1e-14);
    sensor.optics.pupil = PupilShape::square;
    sensor.optics.obscuration = 0.0;
    // Its exact cone, summed over the square: cos^4 / f^2.
    double sum = 0.0;
    constexpr int steps = 400;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j < steps; ++j) {
            const double x = 0.5 * ((i + 0.5) / steps - 0.5), y = 0.5 * ((j + 0.5) / steps - 0.5);
            sum += std::pow(1.0 + x * x + y * y, -2) * std::pow(0.5 / steps, 2);
        }
    }
    EXPECT_NEAR(sensor.optics.cone_sr(ConeConvention::exact), sum, 1e-6);
}

TEST(SensorDescription, ItsBandIsTheSignalPerJouleRelativeToItsPeak) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.band = {3.0, 5.0};
    sensor.detector.response = Spectrum({2.5, 4.0, 5.5}, {0.2, 0.9, 0.3});
    sensor.optics.transmission = Spectrum({2.0, 6.0}, {0.9, 0.5});
    sensor.check();
    const Band band = sensor.band();
    EXPECT_EQ(band.range(), (SpectralRange{3.0, 5.0}));
    const double peak = sensor.peakSignalPerJoule();
    double largest = 0.0;
    for (double um = 3.0; um <= 5.0; um += 0.0137) {
        const double expected =
            sensor.optics.transmission.at(um) * sensor.signalPerJoule(um) / peak;
        EXPECT_NEAR(band.responseAt(um), expected, 3e-5) << um;
        largest = std::max(largest, expected);
    }
    EXPECT_NEAR(largest, 1.0, 1e-3);
    // One photon of 4 um carries h c / lambda.
    EXPECT_NEAR(sensor.signalPerJoule(4.0), 0.9 * 4e-6 / (planckConstant_J_s * speedOfLight_m_s),
                1e6);
}

TEST(SensorDescription, ItsPinholeHasTheDetectorsFieldOfView) {
    const SensorDescription sensor = test::staringSensor();
    const Sensor pinhole = sensor.pinhole();
    EXPECT_EQ(pinhole.width_px, 48);
    EXPECT_EQ(pinhole.height_px, 40);
    EXPECT_NEAR(pinhole.pixelPitch(), 15e-6 / 0.2, 1e-15);
}

TEST(SensorDescription, RefusesWhatCannotBeByItsKey) {
    struct Row {
        const char* key;
        std::function<void(SensorDescription&)> spoil;
    };
    const Row rows[] = {
        {"detector.well_e", [](auto& s) { s.detector.well_e = 0.5; }},
        {"detector.well_e", [](auto& s) { s.detector.well_e.reset(); }},
        {"optics.focalLength_m", [](auto& s) { s.optics.focalLength_m = 0.03; }}, // F/0.3
        {"optics.aperture_m", [](auto& s) { s.optics.aperture_m = 0.0; }},
        {"optics.aperture_m", [](auto& s) { s.optics.aperture_m = NAN; }},
        {"optics.obscuration", [](auto& s) { s.optics.obscuration = 0.2; }},
        {"optics.obscuration", [](auto& s) { s.optics.pupil = PupilShape::annular; }},
        {"optics.transmission", [](auto& s) { s.optics.transmission = Spectrum::constant(1.2); }},
        {"optics.transmission",
         [](auto& s) {
             s.optics.transmission = Spectrum({4.0, 5.0}, {0.5, 0.5});
         }},
        {"optics.emissivity", [](auto& s) { s.optics.emissivity = 0.3; }},
        {"optics.defocusWavelength_um", [](auto& s) { s.optics.defocus_waves = 1.0; }},
        {"optics.coldShieldEfficiency", [](auto& s) { s.optics.coldShieldEfficiency = 1.5; }},
        {"detector.quantumEfficiency",
         [](auto& s) { s.detector.response = Spectrum::constant(1.1); }},
        {"detector.quantumEfficiency",
         [](auto& s) {
             s.detector.response = Spectrum({3.0, 4.0}, {0.5, 0.5});
         }},
        {"detector.pitch_um", [](auto& s) { s.detector.pitch_um = -1.0; }},
        {"detector.fillFactor", [](auto& s) { s.detector.fillFactor = 0.0; }},
        {"detector.columns", [](auto& s) { s.detector.columns = 0; }},
        {"detector.integrationTime_s", [](auto& s) { s.detector.integrationTime_s = 0.0; }},
        {"detector.band_um",
         [](auto& s) {
             s.detector.band = {5.0, 3.0};
         }},
        {"detector.netd_K", [](auto& s) { s.detector.thermalNetd_K = 0.05; }},
        {"detector.netd_K", [](auto& s) { s.detector.responseKind = ResponseKind::absorptance; }},
        {"electronics.gain_e_per_count", [](auto& s) { s.electronics.gain = 0.0; }},
        {"electronics.bits", [](auto& s) { s.electronics.bits = 40; }},
        {"electronics.offset_counts",
         [](auto& s) { s.electronics.offset_counts = 1048575.0; }}, // of 20 bits
        {"electronics.readNoise_e", [](auto& s) { s.electronics.readNoise_e = -1.0; }},
        {"motion.jitter_urad", [](auto& s) { s.motion.jitter_urad = -1.0; }},
        {"noise.vh", [](auto& s) { s.noise.vh = -0.1; }},
        {"noise.hotPixelFraction",
         [](auto& s) { s.noise.deadPixelFraction = s.noise.hotPixelFraction = 0.7; }},
    };
    for (const Row& row : rows) {
        SensorDescription sensor = test::staringSensor();
        row.spoil(sensor);
        try {
            sensor.check();
            ADD_FAILURE() << row.key << " was taken";
        } catch (const InputError& error) {
            bool isNamed = false;
            for (const Diagnostic& one : error.diagnostics()) {
                isNamed = isNamed || one.position == row.key;
            }
            EXPECT_TRUE(isNamed) << row.key << ": " << error.what();
        }
    }
}

} // namespace

} // namespace irsg

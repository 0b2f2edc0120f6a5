#include "irsg/sensor/PointSpread.h"

#include <cmath>
#include <complex>
#include <utility>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Units.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

TEST(PointSpread, AirysPatternFallsIntoASquare) {
    // The ensquared energy of an Airy pattern, by summing the pattern itself over the square.
    const SensorDescription sensor = test::staringSensor();
    const PointSpread spread(sensor, 300.0);
    const double scale = pi * 0.1 / 4e-6 * sensor.pixelAngle_rad(); // pi D / lambda times a pixel
    constexpr int steps = 2000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; j <= i; ++j) {
            const double r = scale * std::hypot(0.5 * (i + 0.5) / steps, 0.5 * (j + 0.5) / steps);
            const double airy = 2.0 * std::cyl_bessel_j(1.0, r) / r;
            sum += (i == j ? 1.0 : 2.0) * airy * airy;
        }
    }
    // Normalised to 1 over the plane: peak pi/4 (D / lambda)^2 per sr; four quadrants.
    const double peak = pi / 4.0 * std::pow(0.1 / 4e-6 * sensor.pixelAngle_rad(), 2);
    const double expected = 4.0 * peak * sum * std::pow(0.5 / steps, 2);
    EXPECT_NEAR(spread.energyAt(0.0, 0.0), expected, 2e-6);
}

// Up to the defocus that a sensor may have, beside the pupil's own integral: the amplitude at an
// angle v, in radii of the pupil times 2 pi / lambda, is that of exp(2 pi i W t) J0(v sqrt(t)) over
// t from 0 to 1.
TEST(PointSpread, DefocusOfManyWavesFallsAsThePupilsOwnIntegral) {
    SensorDescription sensor = test::staringSensor();
    sensor.optics.defocusWavelength_um = 4.0;
    const double scale = pi * 0.1 / 4e-6 * sensor.pixelAngle_rad();
    const double peak = pi / 4.0 * std::pow(0.1 / 4e-6 * sensor.pixelAngle_rad(), 2);
    const GaussRule& rule = gaussLegendre(12);
    for (const double waves : {8.0, -20.0}) {
        sensor.optics.defocus_waves = waves;
        sensor.check();
        const auto intensityAt = [&](double v) {
            std::complex<double> sum = 0.0;
            constexpr int panels = 40;
            for (int panel = 0; panel < panels; ++panel) {
                for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                    const double t = (panel + rule.nodes[i]) / panels;
                    sum += rule.weights[i] / panels * std::polar(1.0, 2.0 * pi * waves * t) *
                           std::cyl_bessel_j(0.0, v * std::sqrt(t));
                }
            }
            return std::norm(sum);
        };
        const PointSpread spread(sensor, 300.0);
        for (const auto& [column, row] : {std::pair{0.0, 0.0}, {0.5, 0.5}, {3.0, 1.0}}) {
            double energy = 0.0;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
                    energy += rule.weights[i] * rule.weights[j] *
                              intensityAt(scale * std::hypot(column + rule.nodes[i] - 0.5,
                                                             row + rule.nodes[j] - 0.5));
                }
            }
            // The band of 2 nm and the wings beyond the 12 nodes are what is left.
            EXPECT_NEAR(spread.energyAt(column, row), peak * energy, 1e-7)
                << waves << " waves, " << column << ", " << row;
        }
    }
}

TEST(PointSpread, AGaussianBlurFallsAsItsErrorFunctions) {
    SensorDescription sensor = test::staringSensor();
    sensor.optics.aperture_m = 0.39; // diffraction is 1/40 of the blur
    sensor.motion.jitter_urad = 200.0;
    sensor.check();
    const PointSpread spread(sensor, 300.0);
    // Diffraction's own blur widens it: the closed form holds to its share.
    const double sigma = 200e-6 / sensor.pixelAngle_rad();
    const auto part = [&](double centre) {
        const double scale = 1.0 / (std::sqrt(2.0) * sigma);
        return 0.5 * (std::erf((centre + 0.5) * scale) - std::erf((centre - 0.5) * scale));
    };
    EXPECT_NEAR(spread.energyAt(0.0, 0.0), part(0.0) * part(0.0), 0.03 * part(0.0) * part(0.0));
    EXPECT_NEAR(spread.energyAt(2.0, 1.0) / spread.energyAt(0.0, 0.0),
                part(2.0) * part(1.0) / (part(0.0) * part(0.0)), 0.01);
}

TEST(PointSpread, AllEnergyOfAPointIsOnThePixels) {
    for (const PupilShape shape : {PupilShape::circular, PupilShape::annular, PupilShape::square}) {
        SensorDescription sensor = test::staringSensor();
        sensor.optics.pupil = shape;
        sensor.optics.obscuration = shape == PupilShape::annular ? 0.35 : 0.0;
        sensor.optics.defocus_waves = 0.4;
        sensor.optics.defocusWavelength_um = 4.0;
        sensor.check();
        const PointSpread spread(sensor, 300.0);
        for (const double shift : {0.0, 0.21, 0.5}) {
            const HalfSpectrum spectrum = spread.spectrumOf(0.0, shift, -0.3);
            EXPECT_NEAR(spectrum.values[0].real(), 1.0, 1e-9);
            double sum = 0.0;
            for (const double value : transformBack(spectrum)) {
                sum += value;
            }
            EXPECT_NEAR(sum, 1.0, 1e-9);
        }
    }
}

TEST(PointSpread, AGapBetweenActiveAreasTakesEnergyAtSomePlaces) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.fillFactor = 0.25;
    const PointSpread spread(sensor, 300.0);
    const double on = spread.spectrumOf(0.0, 0.0, 0.0).values[0].real();
    const double between = spread.spectrumOf(0.0, 0.5, 0.5).values[0].real();
    EXPECT_GT(on, 1.05);
    EXPECT_LT(between, 0.95);
    // A whole pixel of uniform light is seen as it is.
    EXPECT_NEAR(spread.spectrumOf(1.0, 0.2, 0.0).values[0].real(), 1.0, 1e-9);
}

TEST(PointSpread, RefusesWhatNoImageHolds) {
    SensorDescription sensor = test::staringSensor();
    sensor.motion.jitter_urad = 1e5;
    EXPECT_THROW(PointSpread(sensor, 300.0), InputError);
    sensor = test::staringSensor();
    sensor.detector.pitch_um = 9e5;
    EXPECT_THROW(PointSpread(sensor, 300.0), InputError);
}

} // namespace

} // namespace irsg

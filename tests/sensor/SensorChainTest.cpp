#include "irsg/sensor/SensorChain.h"

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

std::size_t pixels(const SensorDescription& sensor) {
    return static_cast<std::size_t>(sensor.detector.columns * sensor.detector.rows);
}

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double varianceOf(const std::vector<double>& values) {
    const double mean = meanOf(values);
    double sum = 0.0;
    for (const double value : values) {
        sum += (value - mean) * (value - mean);
    }
    return sum / static_cast<double>(values.size());
}

TEST(SensorChain, AUniformFieldIsItsSignalEverywhere) {
    SensorDescription sensor = test::staringSensor();
    for (const double fill : {1.0, 0.6}) {
        sensor.detector.fillFactor = fill;
        const SensorChain chain(sensor);
        for (const int samples : {1, 3}) {
            const std::vector<float> field(
                pixels(sensor) * static_cast<std::size_t>(samples * samples), 0.25f);
            for (const double value : chain.exposed(field, samples)) {
                ASSERT_NEAR(value / (0.25 * chain.response().signalPerRadiance()), 1.0, 1e-9);
            }
        }
    }
}

TEST(SensorChain, ARadianceThatIsNoNumberIsRefusedByItsPlace) {
    const SensorChain chain(test::staringSensor());
    for (const float wrong :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        std::vector<float> field(pixels(chain.sensor()) * 4, 0.25f);
        field[7 * 96 + 93] = wrong;
        try {
            (void)chain.exposed(field, 2);
            ADD_FAILURE() << wrong << " was taken";
        } catch (const InputError& error) {
            EXPECT_EQ(error.diagnostics().front().position, "radiance in row 7, column 93");
        }
    }
}

// The blur is of single precision: what is far beyond the others must not drown them.
TEST(SensorChain, WhatIsFarBeyondAFullWellStaysNearItsPlace) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.columns = 96;
    const SensorChain chain(sensor);
    std::vector<float> field(pixels(sensor), 0.25f);
    const std::vector<double> usual = chain.exposed(field, 1);
    const std::size_t reach = chain.pointSpread().side_px() / 2;
    ASSERT_LT(reach + 2, 96u);
    // Single precision of four full wells.
    const double error = 4e-6 * chain.response().fullSignal();
    for (const float bright : {1e12f, 1e30f, -1e30f}) {
        field[1] = bright;
        const std::vector<double> signal = chain.exposed(field, 1);
        for (std::size_t y = 0; y < 40; ++y) {
            for (std::size_t x = reach + 2; x < 96; ++x) {
                ASSERT_NEAR(signal[y * 96 + x], usual[y * 96 + x], error)
                    << bright << " at " << x << ", " << y;
            }
        }
        // Near it is its share of a point's light.
        const double share = chain.pointSpread().energyAt(0.0, 0.0);
        EXPECT_GT(signal[1] / (static_cast<double>(bright) * usual[1] / 0.25), 0.3 * share);
        EXPECT_GT(signal[2] / static_cast<double>(bright), 0.0);
    }
}

TEST(SensorChain, AFieldOfCellsIsTheSumOfTheirPointSpreads) {
    // Against the direct sum over points within a cell, whose pixels energyAt integrates.
    SensorDescription sensor = test::staringSensor();
    sensor.optics.defocus_waves = 0.3;
    sensor.optics.defocusWavelength_um = 4.0;
    const SensorChain chain(sensor);
    std::vector<float> field(pixels(sensor) * 4, 0.0f);
    const std::size_t column = 31, row = 24; // in cells: right upper quarter of pixel 15, 12
    field[row * 96 + column] = 1.0f;
    const std::vector<double> signal = chain.exposed(field, 2);
    for (const int x : {14, 15, 16, 18}) {
        for (const int y : {11, 12}) {
            double sum = 0.0; // of 16 points in the cell
            const GaussRule& rule = gaussLegendre(4);
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = 0; j < 4; ++j) {
                    sum += rule.weights[i] * rule.weights[j] *
                           chain.pointSpread().energyAt(x - 15.0 - 0.5 * rule.nodes[i],
                                                        y - 12.0 + 0.5 * rule.nodes[j]);
                }
            }
            EXPECT_NEAR(signal[static_cast<std::size_t>(y * 48 + x)] /
                            chain.response().signalPerRadiance(),
                        0.25 * sum, 1e-6)
                << x << " " << y;
        }
    }
    // All but what falls beside a frame of 48 x 40.
    const double seen =
        std::accumulate(signal.begin(), signal.end(), 0.0) / chain.response().signalPerRadiance();
    EXPECT_LT(seen, 0.25);
    EXPECT_GT(seen, 0.2475);
    EXPECT_THROW((void)chain.exposed(field, 3), LogicError);
}

TEST(SensorChain, APointOverSixtyFourShiftsHasItsEnsquaredEnergy) {
    for (const double blur_urad : {0.0, 40.0}) {
        SensorDescription sensor = test::staringSensor();
        sensor.motion.jitter_urad = blur_urad;
        const SensorChain chain(sensor);
        const std::vector<float> dark(pixels(sensor), 0.0f);
        const double whole = 1e-6 * chain.response().signalPerIrradiance();
        for (int i = 0; i < 64; ++i) {
            const double u = (i % 8) / 8.0 - 0.5, v = (i / 8) / 8.0 - 0.5;
            const auto signal = chain.exposed(
                dark, 1, {{.column_px = 20.0 + u, .row_px = 17.0 + v, .irradiance_W_m2 = 1e-6}});
            // Middle, edge and corner of what it falls on.
            for (const auto& [x, y] : {std::pair{20, 17}, {21, 17}, {21, 18}, {23, 16}}) {
                const double energy = chain.pointSpread().energyAt(x - 20.0 - u, y - 17.0 - v);
                ASSERT_NEAR(signal[static_cast<std::size_t>(y * 48 + x)] / whole, energy, 1e-5)
                    << u << " " << v << " at " << x << ", " << y;
            }
        }
    }
}

TEST(SensorChain, APointAtEdgeAndCornerLosesOnlyWhatFallsBeside) {
    const SensorDescription sensor = test::staringSensor();
    const SensorChain chain(sensor);
    const std::vector<float> dark(pixels(sensor), 0.0f);
    const double whole = chain.response().signalPerIrradiance();
    const auto at = [&](double column, double row) {
        return chain.exposed(dark, 1, {{column, row, 1.0}});
    };
    for (const auto& [column, row] : {std::pair{0.0, 17.25}, {0.3, -0.4}, {47.4, 39.2}}) {
        const auto signal = at(column, row);
        const auto x = static_cast<std::size_t>(std::lround(column));
        const auto y = static_cast<std::size_t>(std::lround(std::max(0.0, row)));
        EXPECT_NEAR(signal[y * 48 + x] / whole,
                    chain.pointSpread().energyAt(static_cast<double>(x) - column,
                                                 static_cast<double>(y) - row),
                    1e-5);
    }
    // A point far off the frame is not wrapped into it.
    EXPECT_NEAR(meanOf(at(-200.0, 10.0)) / whole, 0.0, 1e-15);
}

TEST(SensorChain, NoiseHasItsMeanAndVariance) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.columns = 320;
    sensor.detector.rows = 256;
    sensor.electronics.readNoise_e = 30.0;
    sensor.detector.darkCurrent_e_per_s = 1e5;
    for (const double mean_e : {4.0, 45.0, 900.0, 2e5}) {
        const SensorChain chain(sensor);
        const std::vector<double> signal(pixels(sensor), mean_e);
        const auto values = chain.noisy(signal, 7, 3);
        const double expected = mean_e + 200.0, variance = expected + 900.0;
        EXPECT_NEAR(meanOf(values) / expected, 1.0, 0.01) << mean_e;
        EXPECT_NEAR(varianceOf(values) / variance, 1.0, 0.01) << mean_e;
    }
    // Few electrons follow Poisson's law: no negative ones, and some pixels with none.
    sensor.electronics.readNoise_e = 0.0;
    sensor.detector.darkCurrent_e_per_s = 0.0;
    const auto few = SensorChain(sensor).noisy(std::vector<double>(pixels(sensor), 2.0), 7, 0);
    const auto none = std::count(few.begin(), few.end(), 0.0);
    EXPECT_NEAR(static_cast<double>(none) / static_cast<double>(few.size()), std::exp(-2.0), 0.005);
    EXPECT_NEAR(meanOf(few), 2.0, 0.02);
    double variance = 0.0;
    for (std::uint32_t i = 0; i < 8; ++i) {
        variance +=
            varianceOf(SensorChain(sensor).noisy(std::vector<double>(pixels(sensor), 2.0), 7, i)) /
            8.0;
    }
    EXPECT_NEAR(variance, 2.0, 0.015);
}

/// The seven components of frames of one size, as the directional averages of D'Agostino and Webb
/// find them, averaged as variances over several cubes.
struct Components {
    double tvh = 0.0, tv = 0.0, th = 0.0, vh = 0.0, t = 0.0, v = 0.0, h = 0.0;
};

Components analysed(const SensorChain& chain, int cubes, int frames) {
    const auto width = static_cast<std::size_t>(chain.sensor().detector.columns);
    const auto height = static_cast<std::size_t>(chain.sensor().detector.rows);
    const auto depth = static_cast<std::size_t>(frames);
    Components sum;
    for (int cube = 0; cube < cubes; ++cube) {
        std::vector<double> vh(width * height), tv(depth * height), th(depth * width), t(depth),
            v(height), h(width);
        double mean = 0.0, squares = 0.0;
        const double m = static_cast<double>(width), n = static_cast<double>(height),
                     f = static_cast<double>(frames);
        const std::vector<double> signal(width * height, 0.0);
        for (std::size_t k = 0; k < depth; ++k) {
            const auto values = chain.noisy(signal, static_cast<std::uint64_t>(cube) + 11,
                                            static_cast<std::uint32_t>(k));
            for (std::size_t y = 0; y < height; ++y) {
                for (std::size_t x = 0; x < width; ++x) {
                    const double value = values[y * width + x];
                    mean += value / (m * n * f);
                    squares += value * value / (m * n * f);
                    vh[y * width + x] += value / f;
                    tv[k * height + y] += value / m;
                    th[k * width + x] += value / n;
                    t[k] += value / (m * n);
                    v[y] += value / (m * f);
                    h[x] += value / (n * f);
                }
            }
        }
        // Variances of the averages hold those of the others divided by what was averaged over.
        const double all = squares - mean * mean;
        const double st = varianceOf(t), sv = varianceOf(v), sh = varianceOf(h);
        const double stv = varianceOf(tv) - st - sv, sth = varianceOf(th) - st - sh,
                     svh = varianceOf(vh) - sv - sh;
        const double stvh = all - st - sv - sh - stv - sth - svh;
        sum.tvh += stvh / cubes;
        sum.tv += (stv - stvh / m) / cubes;
        sum.th += (sth - stvh / n) / cubes;
        sum.vh += (svh - stvh / f) / cubes;
        sum.t += (st - stv / n - sth / m) / cubes;
        sum.v += (sv - stv / f - svh / m) / cubes;
        sum.h += (sh - sth / f - svh / n) / cubes;
    }
    return sum;
}

TEST(SensorChain, TheSevenComponentsOfNoiseAreRecovered) {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.columns = 160;
    sensor.detector.rows = 160;
    sensor.electronics.readNoise_e = 100.0;
    sensor.noise = {.referenceTemperature_K = 20.0,
                    .tv = 0.6,
                    .th = 0.5,
                    .t = 0.8,
                    .vh = 0.7,
                    .v = 0.9,
                    .h = 1.1};
    sensor.check();
    const SensorChain chain(sensor);
    // 1000 frames; patterns that stay are drawn 25 times, since a frame has only 160 rows.
    const Components found = analysed(chain, 25, 40);
    const double unit = std::hypot(100.0, 10.0 / std::sqrt(12.0));
    const auto parts = [&](double variance) { return std::sqrt(variance) / unit; };
    EXPECT_NEAR(parts(found.tvh), 100.0 / unit, 0.03);
    EXPECT_NEAR(parts(found.tv) / 0.6, 1.0, 0.03);
    EXPECT_NEAR(parts(found.th) / 0.5, 1.0, 0.03);
    EXPECT_NEAR(parts(found.vh) / 0.7, 1.0, 0.03);
    EXPECT_NEAR(parts(found.t) / 0.8, 1.0, 0.03); // 1000 numbers: 2.2 % is their own deviation
    EXPECT_NEAR(parts(found.v) / 0.9, 1.0, 0.03);
    EXPECT_NEAR(parts(found.h) / 1.1, 1.0, 0.03);
}

TEST(SensorChain, FramesAreEqualOnAnyNumberOfThreadsAndDifferBySeed) {
    SensorDescription sensor = test::staringSensor();
    sensor.noise.vh = 0.2;
    const SensorChain chain(sensor);
    std::vector<float> field(pixels(sensor) * 4);
    for (std::size_t i = 0; i < field.size(); ++i) {
        field[i] = 0.1f + 0.01f * static_cast<float>(i % 7);
    }
    const auto frame = [&](unsigned threads, std::uint64_t seed, std::uint32_t number) {
        setMostThreads(threads);
        auto read = chain.read(chain.exposed(field, 2), seed, number);
        setMostThreads(0);
        return read.counts;
    };
    const auto one = frame(1, 5, 0);
    EXPECT_EQ(frame(3, 5, 0), one);
    EXPECT_NE(frame(1, 6, 0), one);
    EXPECT_NE(frame(1, 5, 1), one);
}

TEST(SensorChain, CountsAreTheSignalAndGiveTheRadianceBack) {
    SensorDescription sensor = test::staringSensor();
    sensor.optics.temperature_K = 300.0;
    sensor.optics.emissivity = 0.1;
    sensor.electronics.offset_counts = 100.0;
    sensor.electronics.gain = 2.0;
    const SensorChain chain(sensor);
    const double radiance = 5e-3;
    const std::vector<double> signal(pixels(sensor),
                                     radiance * chain.response().signalPerRadiance());
    const SensorReading frame = chain.read(signal, 1, 0);
    double counts = 0.0, back = 0.0;
    for (std::size_t i = 0; i < frame.counts.size(); ++i) {
        counts += frame.counts[i] / static_cast<double>(frame.counts.size());
        back += frame.radiance_W_m2_sr[i] / static_cast<double>(frame.counts.size());
    }
    const double total = signal.front() + chain.response().offset().offset();
    EXPECT_NEAR(counts, 100.0 + total / 2.0, 5.0 * std::sqrt(total) / 2.0 / std::sqrt(1920.0));
    EXPECT_NEAR(back / radiance, 1.0, 1e-3);
    EXPECT_EQ(frame.saturated, 0u);
}

TEST(SensorChain, FullAndBadPixelsAreCounted) {
    SensorDescription sensor = test::staringSensor();
    const SensorChain plain(sensor);
    std::vector<double> signal(pixels(sensor), 1000.0);
    for (std::size_t i = 0; i < 10; ++i) {
        signal[i] = 8e6;
    }
    const SensorReading frame = plain.read(signal, 1, 0);
    EXPECT_EQ(frame.saturated, 10u);
    EXPECT_EQ(frame.counts[3], 7e5f);
    sensor.electronics.bits = 8; // the converter ends before the well
    EXPECT_EQ(SensorChain(sensor).read(signal, 1, 0).counts[3], 255.0f);

    sensor = test::staringSensor();
    sensor.noise.deadPixelFraction = 0.1;
    sensor.noise.hotPixelFraction = 0.2;
    const SensorChain bad(sensor);
    const SensorReading first = bad.read(signal, 1, 0), second = bad.read(signal, 1, 1);
    EXPECT_NEAR(static_cast<double>(first.dead), 192.0, 40.0);
    EXPECT_NEAR(static_cast<double>(first.hot), 384.0, 55.0);
    EXPECT_EQ(second.dead, first.dead); // they stay
    EXPECT_LE(first.saturated, 10u);
}

TEST(SensorChain, AnImageBecomesOneOfCounts) {
    const SensorDescription sensor = test::staringSensor();
    const SensorChain chain(sensor);
    RadianceImage image(96, 80);
    image.attributes["band"] = "of the sensor";
    for (float& value : image.channels.front().values) {
        value = 0.01f;
    }
    const SensorReading frame = readBySensor(image, chain, 2, 42, 0);
    EXPECT_EQ(image.width(), 48);
    EXPECT_EQ(image.height(), 40);
    EXPECT_EQ(image.primary().name, "counts");
    EXPECT_EQ(image.primary().values, frame.counts);
    ASSERT_NE(image.find("L"), nullptr);
    EXPECT_EQ(image.attributes["band"], "of the sensor");
    EXPECT_EQ(image.attributes["sensor.seed"], "42");
    EXPECT_EQ(image.attributes["sensor.saturatedPixels"], "0");
}

} // namespace

} // namespace irsg

// A scene behind each stage of a sensor, against the closed forms of its transfer function.
#include "irsg/sensor/SensorStages.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/SensorChain.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

SensorDescription blurringSensor() {
    SensorDescription sensor = test::staringSensor();
    sensor.detector.fillFactor = 0.81;
    sensor.optics.aberrationBlur_urad = 12.0;
    sensor.motion = {.jitter_urad = 20.0, .lineOfSightRate_urad_per_s = 3e4};
    sensor.detector.timeConstant_s = 1e-3;
    return sensor;
}

/// Upright bars of a sine of 10 with `period_px` about 100.
StageScene bars(std::size_t side_px, int samples, double period_px) {
    StageScene scene{side_px, side_px, samples, {}};
    const std::size_t side = side_px * static_cast<std::size_t>(samples);
    for (std::size_t y = 0; y < side; ++y) {
        for (std::size_t x = 0; x < side; ++x) {
            const double at_px = (static_cast<double>(x) + 0.5) / samples;
            scene.radiance_W_m2_sr.push_back(
                static_cast<float>(100.0 + 10.0 * std::cos(2.0 * pi * at_px / period_px)));
        }
    }
    return scene;
}

/// Of the bars, from the quarters in the middle, where the sides are far.
double amplitude(const std::vector<float>& picture, std::size_t side, int samples,
                 double period_px) {
    const auto period = static_cast<std::size_t>(period_px * samples);
    const std::size_t from = (side / 2 / period - 1) * period;
    double cosine = 0.0, sine = 0.0;
    for (std::size_t x = from; x < from + 2 * period; ++x) {
        const double angle = 2.0 * pi * (static_cast<double>(x) + 0.5) / (period_px * samples);
        cosine += picture[side / 2 * side + x] * std::cos(angle);
        sine += picture[side / 2 * side + x] * std::sin(angle);
    }
    return std::hypot(cosine, sine) / static_cast<double>(period);
}

TEST(SensorStages, EveryComponentBelongsToOneStage) {
    const auto all = SensorTransfer(blurringSensor()).components(3000.0, 1000.0);
    std::size_t count = 0;
    double product = 1.0;
    for (const SensorStage stage : sensorStages) {
        for (const auto& one : componentsOf(stage, all)) {
            product *= one.value;
            ++count;
        }
    }
    EXPECT_EQ(count, all.size());
    EXPECT_NEAR(product, SensorTransfer(blurringSensor()).at(3000.0, 1000.0), 1e-12);
    EXPECT_TRUE(componentsOf(SensorStage::electronics, all).empty());
    ASSERT_EQ(componentsOf(SensorStage::motion, all).size(), 2u);
    EXPECT_EQ(componentsOf(SensorStage::motion, all).front().name, "jitter");
}

TEST(SensorStages, BarsLoseWhatTheTransferFunctionOfEachStageTakes) {
    const SensorDescription sensor = blurringSensor();
    const int samples = 4;
    const std::size_t side_px = 64, side = side_px * samples;
    for (const double period_px : {4.0, 8.0}) {
        const StageScene scene = bars(side_px, samples, period_px);
        const StagePictures pictures = stagePictures(sensor, scene);
        const auto all =
            SensorTransfer(sensor).components(1.0 / (period_px * sensor.pixelAngle_rad()), 0.0);
        double left = 10.0;
        EXPECT_EQ(pictures.radiance_W_m2_sr[0], scene.radiance_W_m2_sr);
        for (std::size_t stage = 0; stage < 3; ++stage) {
            for (const auto& one : componentsOf(sensorStages[stage], all)) {
                left *= one.value;
            }
            EXPECT_NEAR(amplitude(pictures.radiance_W_m2_sr[stage + 1], side, samples, period_px) /
                            left,
                        1.0, 5e-3)
                << period_px << " px, stage " << stage;
        }
    }
}

TEST(SensorStages, AnEvenSceneStaysEvenAndCountsAreThoseOfTheChain) {
    SensorDescription sensor = blurringSensor();
    StageScene even{12, 10, 3, std::vector<float>(36 * 30, 2.5F)};
    for (const std::vector<float>& picture : stagePictures(sensor, even).radiance_W_m2_sr) {
        ASSERT_EQ(picture.size(), even.radiance_W_m2_sr.size());
        for (const float value : picture) {
            EXPECT_NEAR(value, 2.5, 1e-5);
        }
    }
    const StagePictures pictures = stagePictures(sensor, even, 300.0, 7);
    sensor.detector.columns = 12;
    sensor.detector.rows = 10;
    const SensorChain chain(sensor);
    EXPECT_EQ(pictures.counts, chain.read(chain.exposed(even.radiance_W_m2_sr, 3), 7, 0).counts);
    EXPECT_NE(pictures.counts, stagePictures(sensor, even, 300.0, 8).counts);
    even.radiance_W_m2_sr.pop_back();
    EXPECT_THROW(stagePictures(sensor, even), LogicError);
}

} // namespace

} // namespace irsg

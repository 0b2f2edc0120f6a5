// The range at which a sensor sees a target, against closed forms.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/sensor/PointSpread.h"
#include "irsg/sensor/ResolvableTemperature.h"
#include "irsg/sensor/TargetingTask.h"
#include "tests/cli/SensorFiles.h"

namespace smat::test {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(SmatBatchDetection, InVacuumTheRangeIsTheRootOfIntensityOverNoise) {
    const TemporaryFolder folder;
    const Ran info = smatBatch(
        {"sensor", "info", sensorFile(folder), "--background-temperature", "300", "--json"});
    const double nei = nlohmann::json::parse(info.out).at("nei_total_W_m2");
    const Ran ran = smatBatch(
        with({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder), "--step",
              "120", "--snr", "5", "--background-temperature", "300", "--out", folder / "r.csv"},
             plain));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "r.csv");
    EXPECT_EQ(table.provenance.value("analysis"), "detection");
    ASSERT_EQ(table.rowCount(), 3u);
    for (std::size_t row = 0; row < 3; ++row) {
        EXPECT_EQ(valueOf(table, "outcome", row), 0.0);
        EXPECT_NEAR(valueOf(table, "nei", row) / nei, 1.0, 1e-9);
        const double intensity = std::abs(valueOf(table, "contrast_intensity", row));
        EXPECT_NEAR(valueOf(table, "detection_range", row) / std::sqrt(intensity / (nei * 5.0)),
                    1.0, 1e-4);
        EXPECT_LT(valueOf(table, "extent", row), 1.0);
        EXPECT_GE(valueOf(table, "error_detection_range", row), 0.0);
    }
}

TEST(SmatBatchDetection, BarsAreResolvedWhereTheSensorSaysAndNearerForMore) {
    const TemporaryFolder folder;
    const auto rangesOf = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"detection",
                                          sample("sphere/sphere.smat"),
                                          "--sensor",
                                          sensorFile(folder),
                                          "--step",
                                          "180",
                                          "--nearest",
                                          "10",
                                          "--farthest",
                                          "10000",
                                          "--background-temperature",
                                          "290",
                                          "--criterion",
                                          "johnson",
                                          "--out",
                                          folder / "bars.csv"};
        const Ran ran = smatBatch(with(with(std::move(words), plain), more));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "bars.csv");
    };
    const ResultTable recognised = rangesOf({"--task", "recognition"});
    // The mean contrast of a sphere does not change with range in vacuum: cycles fall with it.
    const double range_m = valueOf(recognised, "detection_range", 0);
    const double difference_K = valueOf(recognised, "temperature_difference", 0);
    const irsg::ResolvableTemperature resolvable(irsg::loadSensor(sensorFile(folder)), 290.0);
    EXPECT_NEAR(valueOf(recognised, "cycles", 0), 3.0, 3e-3);
    EXPECT_NEAR(valueOf(recognised, "probability", 0), 0.5, 1e-3);
    const double extent_rad =
        valueOf(recognised, "extent", 0) * irsg::loadSensor(sensorFile(folder)).pixelAngle_rad();
    EXPECT_NEAR(resolvable.frequency_per_rad(difference_K) * extent_rad, 3.0, 3e-3);
    const ResultTable identified = rangesOf({"--task", "identification"});
    EXPECT_NEAR(valueOf(identified, "detection_range", 0) / range_m, 0.5, 2e-3);
    const ResultTable surely = rangesOf({"--cycles", "3", "--probability", "95"});
    EXPECT_NEAR(valueOf(surely, "detection_range", 0) / range_m, 3.0 / irsg::taskCycles(0.95, 3.0),
                2e-3);
    // What does not belong to the criterion is refused.
    const Ran mixed =
        smatBatch({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                   "--criterion", "johnson", "--snr", "3", "--out", folder / "x.csv"});
    EXPECT_EQ(mixed.exitCode, 2);
    EXPECT_THAT(mixed.err, HasSubstr("--snr"));
    const Ran vacuum =
        smatBatch({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                   "--criterion", "johnson", "--out", folder / "x.csv"});
    EXPECT_EQ(vacuum.exitCode, 2) << "before a background of 0 K";
    EXPECT_THAT(vacuum.err, HasSubstr("background"));
}

// Who asks for recognition and forgets the criterion would get the range of a point.
TEST(SmatBatchDetection, RefusesOptionsThatDoNothingBesideTheOthers) {
    const TemporaryFolder folder;
    const std::vector<std::string> bars = {"--criterion", "johnson"};
    for (const auto& [words, option] :
         {std::pair<std::vector<std::string>, const char*>{{"--task", "recognition"}, "--task"},
          {{"--cycles", "3"}, "--cycles"},
          {{"--scene-contrast", "3"}, "--scene-contrast"},
          {with(bars, {"--task", "recognition", "--cycles", "3"}), "--task"},
          {with(bars, {"--clutter", "0.1"}), "--clutter"},
          {with(bars, {"--point", "corner"}), "--point"},
          {{"--snr", "5", "--false-alarms", "1e-6"}, "--false-alarms"},
          {{"--leave-out", "black"}, "--leave-out"},
          {{"--ranges", "1000", "--probability", "90"}, "--probability"},
          {{"--band", "8-12"}, "--band"},
          {{"--set", "sensor.band=8-12"}, "--band"},
          {{"--response", "r.csv"}, "--response"},
          {{"--range", "77"}, "--range"},
          {{"--errors", "causes"}, "--errors"},
          {{"--target-error", "0.5"}, "--target-error"},
          {{"--by-part", "material"}, "--by-part"},
          {{"--steps", "adaptive"}, "--steps"}}) {
        const Ran ran = smatBatch(with({"detection", sample("sphere/sphere.smat"), "--sensor",
                                        sensorFile(folder), "--out", folder / "x.csv"},
                                       words));
        EXPECT_EQ(ran.exitCode, 2) << option;
        EXPECT_THAT(ran.err, HasSubstr("error: " + std::string(option) + ":")) << ran.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "x.csv"));
    }
}

TEST(SmatBatchDetection, TargetingTaskIsMetWhereItsIntegralHasTheCycles) {
    const TemporaryFolder folder;
    const auto rangeOf = [&](const std::vector<std::string>& more) {
        const Ran ran =
            smatBatch(with(with({"detection", sample("sphere/sphere.smat"), "--sensor",
                                 sensorFile(folder), "--step", "180", "--nearest", "10",
                                 "--farthest", "10000", "--background-temperature", "290",
                                 "--criterion", "ttp", "--out", folder / "ttp.csv"},
                                plain),
                           more));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "ttp.csv");
    };
    const irsg::SensorDescription sensor = irsg::loadSensor(sensorFile(folder));
    const ResultTable recognised = rangeOf({"--task", "recognition", "--scene-contrast", "20"});
    EXPECT_EQ(recognised.provenance.value("detection.criterion"), "ttp");
    const irsg::TargetingTask task(sensor, 290.0, {}, {.sceneContrast_K = 20.0});
    const double extent_rad = valueOf(recognised, "extent", 0) * sensor.pixelAngle_rad();
    const double cycles =
        task.cycles_per_rad(valueOf(recognised, "temperature_difference", 0)) * extent_rad;
    EXPECT_NEAR(cycles, 14.5, 0.02);
    EXPECT_NEAR(valueOf(recognised, "cycles", 0), 14.5, 0.02);
    EXPECT_NEAR(valueOf(recognised, "probability", 0), 0.5, 1e-3);
    // The contrast of a sphere in vacuum does not change with range: cycles fall with it.
    const double range_m = valueOf(recognised, "detection_range", 0);
    const ResultTable surely =
        rangeOf({"--task", "recognition", "--scene-contrast", "20", "--probability", "90"});
    EXPECT_NEAR(valueOf(surely, "detection_range", 0) / range_m,
                14.5 / irsg::taskCycles(0.9, 14.5, irsg::targetingLaw), 2e-3);
    // A display of less contrast shows less of the target.
    const ResultTable dull = rangeOf({"--task", "recognition", "--scene-contrast", "400"});
    EXPECT_LT(valueOf(dull, "detection_range", 0), 0.9 * range_m);
    const Ran mixed =
        smatBatch({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                   "--criterion", "johnson", "--scene-contrast", "3", "--out", folder / "x.csv"});
    EXPECT_EQ(mixed.exitCode, 2);
    EXPECT_THAT(mixed.err, HasSubstr("--scene-contrast"));
}

TEST(SmatBatchDetection, SurfacesThatAreLeftOutDoNotCount) {
    const TemporaryFolder folder;
    const std::vector<std::string> bars = {"--sensor",
                                           sensorFile(folder),
                                           "--step",
                                           "180",
                                           "--background-temperature",
                                           "290",
                                           "--criterion",
                                           "johnson",
                                           "--cycles",
                                           "2",
                                           "--nearest",
                                           "20",
                                           "--out",
                                           folder / "d.csv"};
    const auto tableOf = [&](const std::vector<std::string>& words) {
        const Ran ran = smatBatch(words);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(words.back());
    };
    const auto detected = [&](const std::vector<std::string>& more) {
        return tableOf(with(with({"detection", sample("ship/ship.smat")}, more), bars));
    };
    const ResultTable whole = detected({});
    EXPECT_EQ(whole.find("left_out"), nullptr);
    const ResultTable cool = detected({"--leave-out", "funnel", "--leave-out", "funnel plume"});
    EXPECT_EQ(cool.provenance.value("detection.leftOut"), "funnel");
    // The part that is left out is what a polar plot by parts gives at that range.
    const std::string range = irsg::numberText(valueOf(cool, "detection_range", 0));
    const ResultTable parts =
        tableOf({"polar", sample("ship/ship.smat"), "--step", "180", "--band", "4-4.1", "--range",
                 range, "--by-part", "temperature", "--out", folder / "p.csv"});
    const double hot = valueOf(parts, "ship/funnel.contrast_intensity", 0) +
                       valueOf(parts, "ship/funnel plume.contrast_intensity", 0);
    const double all = valueOf(parts, "contrast_intensity", 0);
    EXPECT_GT(hot, 0.1 * all);
    EXPECT_NEAR(valueOf(cool, "left_out", 0), hot / all, 0.02 * hot / all);
    EXPECT_LT(valueOf(cool, "detection_range", 0), whole.find("detection_range")->values.at(0));
    // Without any surface nothing is resolved.
    const ResultTable none =
        detected({"--leave-out", "ship paint", "--leave-out", "hot metal", "--leave-out",
                  "gas of the plume", "--leave-out", "painted steel of the hull"});
    EXPECT_EQ(valueOf(none, "outcome", 0), -1.0);
    EXPECT_NEAR(valueOf(none, "left_out", 0), 1.0, 1e-9);

    const Ran refused =
        smatBatch(with({"detection", sample("ship/ship.smat"), "--leave-out", "funel"}, bars));
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("funnel plume"));
    const Ran point =
        smatBatch({"detection", sample("ship/ship.smat"), "--sensor", sensorFile(folder),
                   "--leave-out", "funnel", "--out", folder / "x.csv"});
    EXPECT_EQ(point.exitCode, 2);
    EXPECT_THAT(point.err, HasSubstr("--leave-out"));
}

TEST(SmatBatchDetection, APointIsDetectedWithItsProbabilityOverAllPlacesInAPixel) {
    const TemporaryFolder folder;
    const irsg::SensorDescription sensor = irsg::loadSensor(sensorFile(folder));
    const auto tableOf = [&](const std::vector<std::string>& more) {
        const Ran ran = smatBatch(with(
            with({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                  "--step", "180", "--background-temperature", "300", "--out", folder / "r.csv"},
                 plain),
            more));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "r.csv");
    };
    const ResultTable table = tableOf({"--false-alarms", "1e-6", "--probability", "90"});
    const double snr = valueOf(table, "snr", 0);
    // 4.7534 deviations are passed once in a million; the mean over places by the midpoint rule.
    const irsg::PointSpread spread(sensor, 300.0);
    const double centre = spread.energyAt(0.0, 0.0);
    double probability = 0.0;
    for (int i = 0; i < 16; ++i) {
        for (int j = 0; j < 16; ++j) {
            const double energy = spread.energyAt((i + 0.5) / 32.0, (j + 0.5) / 32.0);
            probability +=
                0.5 * std::erfc((4.753424309 - snr * energy / centre) / std::sqrt(2.0)) / 256.0;
        }
    }
    EXPECT_NEAR(probability, 0.9, 2e-3);
    EXPECT_NEAR(valueOf(table, "probability", 0), 0.9, 1e-3);
    // In vacuum the range is where that ratio is.
    const double intensity = std::abs(valueOf(table, "contrast_intensity", 0));
    const double nei = valueOf(table, "nei", 0);
    EXPECT_NEAR(valueOf(table, "detection_range", 0) / std::sqrt(intensity / (nei * snr)), 1.0,
                1e-4);
    // Clutter adds to the noise as its temperature's signal does.
    const irsg::PixelResponse response(sensor);
    const double noise = response.noise(response.signal(300.0)).total();
    const double clutter = 0.5 * response.contrast_per_K(300.0);
    const ResultTable cluttered = tableOf({"--clutter", "0.5"});
    EXPECT_NEAR(valueOf(cluttered, "nei", 0) / nei, std::hypot(noise, clutter) / noise, 1e-9);
    EXPECT_GT(clutter, noise);
    EXPECT_EQ(cluttered.find("probability"), nullptr);

    for (const auto& [option, value] : {std::pair{"--false-alarms", "0.6"}, {"--clutter", "-1"}}) {
        const Ran refused =
            smatBatch({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                       option, value, "--out", folder / "x.csv"});
        EXPECT_EQ(refused.exitCode, 2) << option;
    }
    const Ran both =
        smatBatch({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                   "--snr", "4", "--false-alarms", "1e-6", "--out", folder / "x.csv"});
    EXPECT_EQ(both.exitCode, 2);
    EXPECT_THAT(both.err, HasSubstr("--snr"));
}

TEST(SmatBatchDetection, SensitivitiesInVacuumAreThoseOfTheClosedForm) {
    const TemporaryFolder folder;
    const auto tableOf = [&](const irsg::SensorDescription& sensor) {
        saveSensor(sensor, folder / "one.smatsensor");
        const Ran ran =
            smatBatch(with({"detection", sample("sphere/sphere.smat"), "--sensor",
                            folder / "one.smatsensor", "--step", "180", "--background-temperature",
                            "300", "--sensitivity", "--out", folder / "s.csv"},
                           plain));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_THAT(ran.out, HasSubstr("Sensitivity of the range to: aperture"));
        return ResultTable::load(folder / "s.csv");
    };
    // R = sqrt(I / (NEI SNR)), NEI = noise / (signal per irradiance).
    const irsg::SensorDescription sensor = smallSensor();
    const ResultTable table = tableOf(sensor);
    const irsg::PixelResponse response(sensor);
    const irsg::PixelNoise noise = response.noise(response.signal(300.0));
    const double photons = std::pow(noise.photon / noise.total(), 2);
    const double read = std::pow(noise.read / noise.total(), 2);
    EXPECT_GT(photons, 0.1);
    EXPECT_GT(read, 0.001);
    EXPECT_NEAR(valueOf(table, "sensitivity_threshold", 0), -0.5, 1e-3);
    EXPECT_NEAR(valueOf(table, "sensitivity_read_noise", 0), -0.5 * read, 1e-4);
    for (const char* key : {"transmission", "response", "integration_time"}) {
        EXPECT_NEAR(valueOf(table, (std::string("sensitivity_") + key).c_str(), 0),
                    0.5 * (1.0 - 0.5 * photons), 1e-3)
            << key;
    }
    EXPECT_NEAR(valueOf(table, "sensitivity_extinction", 0), 0.0, 2e-3);
    EXPECT_EQ(table.find("sensitivity_jitter"), nullptr) << "there is none";
    // The whole search gives the same for a larger aperture, whose blur is less as well.
    const auto rangeOf = [&](double factor) {
        irsg::SensorDescription changed = sensor;
        changed.optics.aperture_m *= factor;
        return valueOf(tableOf(changed), "detection_range", 0);
    };
    EXPECT_NEAR(valueOf(table, "sensitivity_aperture", 0),
                std::log(rangeOf(1.01) / rangeOf(0.99)) / std::log(1.01 / 0.99), 2e-3);
    // A grey target before nothing: its light goes with the emissivity, and with the temperature
    // as Planck's law at 4.05 um does.
    EXPECT_NEAR(valueOf(table, "sensitivity_emissivity", 0), 0.5, 2e-3);
    EXPECT_GT(valueOf(table, "sensitivity_temperature", 0), 2.0);
}

TEST(SmatBatchDetection, InAirOfBeersLawTheRangeIsLambertsFunction) {
    const TemporaryFolder folder;
    // exp(-k r): a constant extinction, no path radiance that the sphere would not have.
    write(folder / "air.csv",
          "# air_temperature [K]: 20\nwavelength [um],extinction [km-1]\n3,0.2\n5,0.2\n");
    const Ran ran = smatBatch(
        with({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
              "--atmosphere", folder / "air.csv", "--step", "180", "--background-temperature",
              "300", "--sensitivity", "--out", folder / "r.csv"},
             plain));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "r.csv");
    const double range_m = valueOf(table, "detection_range", 0);
    // d ln R / d ln k of exp(-k R) / R^2 = c, and of the threshold.
    EXPECT_NEAR(valueOf(table, "sensitivity_extinction", 0),
                -2e-4 * range_m / (2.0 + 2e-4 * range_m), 2e-3);
    EXPECT_NEAR(valueOf(table, "sensitivity_threshold", 0), -1.0 / (2.0 + 2e-4 * range_m), 2e-3);
    const double nei = valueOf(table, "nei", 0);
    // The intensity without air.
    const double source =
        std::abs(valueOf(table, "contrast_intensity", 0)) * std::exp(2e-4 * range_m);
    const double x = 1e-4 / std::sqrt(5.0 * nei / source);
    double w = std::log1p(x);
    for (int i = 0; i < 50; ++i) {
        w -= (w * std::exp(w) - x) / (std::exp(w) * (1.0 + w));
    }
    EXPECT_NEAR(range_m / (1e4 * w), 1.0, 1e-4);
}

// Of air of one temperature over ground as warm as it what is behind the target is the same
// whatever the extinction: all of the air may be thicker, which moves the range as stated.
TEST(SmatBatchDetection, TheSensitivityToExtinctionIsThatOfThickerAirOnSlantPathsAsWell) {
    const TemporaryFolder folder;
    const auto detectedIn = [&](double factor, const std::string& offset_deg) {
        std::string text = "# air_temperature [K]: 20\nwavelength [um],extinction [km-1]\n";
        for (const auto& [wavelength_um, extinction_per_km] :
             {std::pair{3.0, 0.02}, {3.9, 0.1}, {4.3, 0.9}, {5.0, 0.2}}) {
            text += std::to_string(wavelength_um) + "," +
                    std::to_string(factor * extinction_per_km) + "\n";
        }
        write(folder / "air.csv", text);
        const Ran ran =
            smatBatch(with({"detection", sample("sphere/sphere.smat"), "--sensor",
                            sensorFile(folder), "--atmosphere", folder / "air.csv", "--step", "180",
                            "--offset", offset_deg, "--sensitivity", "--out", folder / "r.csv"},
                           plain));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "r.csv");
    };
    for (const char* offset_deg : {"0", "5", "40"}) {
        const auto rangeIn = [&](double factor) {
            return valueOf(detectedIn(factor, offset_deg), "detection_range", 0);
        };
        const double stated = valueOf(detectedIn(1.0, offset_deg), "sensitivity_extinction", 0);
        EXPECT_NEAR(std::log(rangeIn(1.01) / rangeIn(0.99)) / std::log(1.01 / 0.99), stated, 2e-3)
            << offset_deg;
        EXPECT_LT(stated, -0.1) << offset_deg;
    }
}

TEST(SmatBatchDetection, InAirOfABandADenseSearchFindsTheSameRange) {
    const TemporaryFolder folder;
    const auto rangeOf = [&](const char* looks) {
        const Ran ran = smatBatch(with(
            {"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
             "--atmosphere", std::string(SMAT_SOURCE_DIR) + "/resources/atmospheres/haze-23km.csv",
             "--step", "180", "--looks", looks, "--out", folder / "r.csv"},
            plain));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        const ResultTable table = ResultTable::load(folder / "r.csv");
        EXPECT_EQ(valueOf(table, "outcome", 0), 0.0);
        // The ratio is the threshold there, as an own look says.
        EXPECT_NEAR(valueOf(table, "snr", 0), 5.0, 5e-3);
        return valueOf(table, "detection_range", 0);
    };
    EXPECT_NEAR(rangeOf("4") / rangeOf("40"), 1.0, 1e-5);
}

// What the samples know of their surfaces, gases and air holds the bands of thermal sensors.
TEST(SmatBatchDetection, ThermalSensorsOfTheLibraryServeTheSamples) {
    const TemporaryFolder folder;
    const std::string sensors = std::string(SMAT_SOURCE_DIR) + "/resources/sensors/";
    for (const char* name : {"corvette", "heron", "ship", "tern", "turboprop4"}) {
        for (const char* sensor : {"cooled-mwir", "lwir-scanner", "scanning-seeker",
                                   "uncooled-bolometer", "warning-wide-field"}) {
            const Ran ran =
                smatBatch({"detection", sample(std::string(name) + "/" + name + ".smat"),
                           "--sensor", sensors + sensor + ".smatsensor", "--step", "180",
                           "--dry-run", "--out", folder / "r.csv"});
            EXPECT_EQ(ran.exitCode, 0) << name << ", " << sensor << ": " << ran.err;
        }
    }
}

// A wall 1 km north of the target: the camera at 0 degrees sees it up to there.
TEST(SmatBatchDetection, RangesThatEndWhereTerrainHidesTheTargetSaySo) {
    const TemporaryFolder folder;
    write(folder / "wall.stl", "solid wall\n"
                               "facet normal 0 1 0\nouter loop\n"
                               "vertex -300 1000 -300\nvertex 300 1000 -300\n"
                               "vertex 300 1000 300\nendloop\nendfacet\n"
                               "facet normal 0 1 0\nouter loop\n"
                               "vertex -300 1000 -300\nvertex 300 1000 300\n"
                               "vertex -300 1000 300\nendloop\nendfacet\n"
                               "endsolid wall\n");
    const Ran ran = smatBatch(with({"detection",
                                    sample("sphere/sphere.smat"),
                                    "--sensor",
                                    sensorFile(folder),
                                    "--step",
                                    "180",
                                    "--altitude",
                                    "100",
                                    "--terrain",
                                    folder / "wall.stl",
                                    "--terrain-altitude",
                                    "100",
                                    "--terrain-slope",
                                    "1",
                                    "--terrain-offset",
                                    "1",
                                    "--background-temperature",
                                    "300",
                                    "--out",
                                    folder / "r.csv"},
                                   plain));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "r.csv");
    ASSERT_EQ(table.rowCount(), 2u);
    EXPECT_NEAR(valueOf(table, "detection_range", 0), 1000.0, 2.0);
    EXPECT_THAT(table.warningOf(0),
                StartsWith("hidden at longer ranges, at which its contrast is 0"));
    EXPECT_GT(valueOf(table, "detection_range", 1), 3000.0);
    EXPECT_EQ(table.warningOf(1), "");
    EXPECT_THAT(ran.err, HasSubstr("1 of 2 aspects end where the target is hidden"));
}

// Waves and sky meet behind a ship, in pixels of the project that are larger than the ship.
TEST(SmatBatchDetection, RangesBeforeTerrainDoNotDependOnThePixelsOfTheProject) {
    const TemporaryFolder folder;
    std::vector<double> ranges_m;
    for (const char* fieldOfView_deg : {"15", "2"}) {
        const Ran ran =
            smatBatch({"detection", sample("corvette/corvette.smat"), "--sensor",
                       std::string(SMAT_SOURCE_DIR) + "/resources/sensors/cooled-mwir.smatsensor",
                       "--set", "render.bounces=0", "--from", "0", "--to", "1", "--step", "1",
                       "--fov", fieldOfView_deg, "--out", folder / "r.csv"});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        ranges_m.push_back(valueOf(ResultTable::load(folder / "r.csv"), "detection_range", 0));
    }
    EXPECT_GT(ranges_m[0], 20e3);
    EXPECT_NEAR(ranges_m[0] / ranges_m[1], 1.0, 1e-9);
}

// Far behind the range that is found the path goes into the ground, which nobody asked about.
TEST(SmatBatchDetection, RefusalsOfRangesBeyondTheOneThatIsFoundAreNotTold) {
    const TemporaryFolder folder;
    const Ran ran =
        smatBatch({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                   "--step", "180", "--altitude", "1000", "--atmosphere",
                   std::string(SMAT_SOURCE_DIR) + "/resources/atmospheres/temperate-maritime.xml",
                   "--out", folder / "r.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_LT(valueOf(ResultTable::load(folder / "r.csv"), "detection_range", 0), 200e3);
    EXPECT_THAT(ran.err, testing::Not(HasSubstr("nothing is seen over")));
}

// The search of an aspect begins where the one before it ended.
TEST(SmatBatchDetection, RangesOfARoseAreThoseOfEachAspectAlone) {
    const TemporaryFolder folder;
    const auto rose = [&](const char* from, const char* to, const char* step) {
        const Ran ran =
            smatBatch(with({"detection", sample("turboprop4/turboprop4.smat"), "--sensor",
                            sensorFile(folder), "--set", "render.bounces=0", "--from", from, "--to",
                            to, "--step", step, "--out", folder / "r.csv"},
                           plain));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "r.csv");
    };
    const ResultTable whole = rose("0", "360", "45");
    ASSERT_EQ(whole.rowCount(), 8u);
    const ResultTable alone = rose("135", "136", "1");
    const double range_m = valueOf(whole, "detection_range", 3);
    EXPECT_NEAR(valueOf(alone, "detection_range", 0) / range_m, 1.0, 1e-4);
    EXPECT_GT(std::abs(valueOf(whole, "detection_range", 0) / range_m - 1.0), 0.05)
        << "aspects differ";
}

} // namespace

} // namespace smat::test

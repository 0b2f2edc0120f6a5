// Ranges against wind, visibility, humidity, hour, band and paint, over directions, how sensitive
// they are to the atmosphere, and whether their errors hold the truth.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/geometry/view/Vec3.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/sensor/PointSpread.h"
#include "irsg/sensor/SensorNumbers.h"
#include "tests/cli/SensorFiles.h"

namespace smat::test {

namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

/// A detection of a sample by the small sensor.
ResultTable detected(const TemporaryFolder& folder, const std::string& project, const Words& more,
                     const irsg::SensorDescription& sensor = smallSensor()) {
    const Ran ran = smatBatch(
        with({"detection", sample(project), "--sensor", sensorFile(folder, sensor),
              "--background-temperature", "300", "--bounces", "0", "--out", folder / "r.csv"},
             more));
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    return ResultTable::load(folder / "r.csv");
}

/// An atmosphere of the program with other parameters.
std::string atmosphere(const TemporaryFolder& folder, const std::string& name,
                       const Words& parameters) {
    const std::filesystem::path shipped =
        std::filesystem::path(SMAT_SOURCE_DIR) / "resources/atmospheres/temperate-maritime.xml";
    const Ran ran =
        smatBatch(with(with({"atmosphere", "set", shipped}, parameters), {"--out", folder / name}));
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    return folder / name;
}

const std::string sphere = "sphere/sphere.smat";

/// The sample's box with another emissivity.
std::string boxWith(const TemporaryFolder& folder, double emissivity) {
    const std::filesystem::path from = sample("box/box.smat").parent_path();
    for (const char* name : {"box.smat", "box.flt"}) {
        std::filesystem::copy_file(from / name, folder / name,
                                   std::filesystem::copy_options::overwrite_existing);
    }
    std::string text = contentOf(from / "signature.json");
    const std::string known = "\"emissivity\": 1,";
    text.replace(text.find(known), known.size(),
                 "\"emissivity\": " + irsg::numberText(emissivity) + ",");
    write(folder / "signature.json", text);
    std::filesystem::remove(folder / "box.sigdb");
    const Ran ran = smatBatch({"db", "import", folder / "signature.json", folder / "box.sigdb"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    return folder / "box.smat";
}

/// A side of the box that is seen from its level.
struct Side {
    irsg::Vec3 normal;
    double distance_m, area_m2, temperature_K;
};
constexpr Side sides[] = {{{0, 1, 0}, 2.0, 2.0, 300.0},
                          {{0, -1, 0}, 2.0, 2.0, 320.0},
                          {{1, 0, 0}, 1.0, 4.0, 340.0},
                          {{-1, 0, 0}, 1.0, 4.0, 360.0}};

/// The sum of what the sides that are seen differ from the background by, times their solid angles,
/// W m-2 at the pupil without extinction.
template <typename Contrast>
double irradianceOfBox(double azimuth_rad, double range_m, const Contrast& contrast) {
    const irsg::Vec3 eye = irsg::Vec3{std::sin(azimuth_rad), std::cos(azimuth_rad), 0.0} * range_m;
    double sum = 0.0;
    for (const Side& side : sides) {
        const irsg::Vec3 towards = eye - side.normal * side.distance_m;
        const double distance_m = irsg::length(towards);
        const double cosine = irsg::dot(towards, side.normal) / distance_m;
        if (cosine > 0.0) {
            sum += contrast(side.temperature_K) * side.area_m2 * cosine / (distance_m * distance_m);
        }
    }
    return sum;
}

TEST(SmatBatchDetectionComparison, RangesInVacuumGoWithTheRootOfThePaintsEmissivity) {
    const TemporaryFolder folder;
    const Words paint = {"--step", "120", "--against", "paint", "--paint", "grey 0.9", "--values"};
    const ResultTable numbers = detected(folder, sphere, with(with(paint, {"0.9,0.225"}), plain));
    ASSERT_EQ(numbers.rowCount(), 2u);
    EXPECT_EQ(numbers.columns().front().key, "emissivity");
    EXPECT_EQ(valueOf(numbers, "emissivity", 1), 0.225);
    const double range_m = valueOf(numbers, "detection_range", 0);
    EXPECT_NEAR(valueOf(numbers, "detection_range", 1) / range_m, 0.5, 1e-4);
    const ResultTable nominal = detected(folder, sphere, with({"--step", "120"}, plain));
    double mean_m = 0.0, error_m = 0.0;
    for (std::size_t row = 0; row < 3; ++row) {
        mean_m += valueOf(nominal, "detection_range", row) / 3.0;
        error_m += valueOf(nominal, "error_detection_range", row) / 3.0;
    }
    EXPECT_NEAR(range_m, mean_m, 1e-9 * mean_m);
    EXPECT_NEAR(valueOf(numbers, "error_detection_range", 0), error_m, 1e-6 * error_m);
    EXPECT_NEAR(valueOf(numbers, "greatest_range", 0),
                std::ranges::max(nominal.find("detection_range")->values), 1e-6 * mean_m);
    EXPECT_EQ(numbers.provenance.value("detection.against"), "paint");
    // By name: the material of the database itself, and one of the library.
    const ResultTable names = detected(folder, sphere, with(with(paint, {"grey 0.9,0.9"}), plain));
    EXPECT_EQ(names.columns().front().key, "paint");
    EXPECT_NEAR(valueOf(names, "detection_range", 0), range_m, 1e-9 * range_m);
    EXPECT_NEAR(valueOf(names, "detection_range", 1), range_m, 1e-4 * range_m);
}

TEST(SmatBatchDetectionComparison, ABandIsThatOfASensorWithIt) {
    const TemporaryFolder folder;
    irsg::SensorDescription sensor = smallSensor();
    sensor.detector.band = {3.5, 5.0};
    const ResultTable table = detected(
        folder, sphere,
        with({"--step", "180", "--against", "band", "--values", "3.6-4.1, 4.5-4.9"}, plain),
        sensor);
    ASSERT_EQ(table.rowCount(), 2u);
    EXPECT_EQ(valueOf(table, "band_to", 0), 4.1);
    sensor.detector.band = {4.5, 4.9};
    const ResultTable alone = detected(folder, sphere, with({"--step", "180"}, plain), sensor);
    EXPECT_NEAR(valueOf(table, "detection_range", 1), valueOf(alone, "detection_range", 0),
                2e-4 * valueOf(alone, "detection_range", 0));
}

TEST(SmatBatchDetectionComparison, AirIsThatOfAFileWithTheValue) {
    const TemporaryFolder folder;
    struct Row {
        const char* against;
        const char* values;
        Words before, after;
    };
    for (const Row& row :
         {Row{"wind",
              "3,18",
              {"AerosolModel=3", "Visibility=0"},
              {"AerosolModel=3", "Visibility=0", "WindSpeed=18", "WindSpeedAverage24=18"}},
          Row{"visibility", "23000,6000", {"Visibility=23000"}, {"Visibility=6000"}},
          Row{"humidity", "20,90", {"MeteoModel=2"}, {"MeteoModel=2", "RelativeHumidityMH=90"}}}) {
        const Words view = with({"--step", "180", "--altitude", "300"}, plain);
        const ResultTable table =
            detected(folder, sphere,
                     with(view, {"--atmosphere", atmosphere(folder, "before.xml", row.before),
                                 "--against", row.against, "--values", row.values}));
        ASSERT_EQ(table.rowCount(), 2u) << row.against;
        const ResultTable alone =
            detected(folder, sphere,
                     with(view, {"--atmosphere", atmosphere(folder, "after.xml", row.after)}));
        const double expected_m =
            0.5 * (valueOf(alone, "detection_range", 0) + valueOf(alone, "detection_range", 1));
        EXPECT_NEAR(valueOf(table, "detection_range", 1), expected_m, 1e-6 * expected_m)
            << row.against;
        EXPECT_GT(std::abs(valueOf(table, "detection_range", 0) - expected_m), 1e-3 * expected_m)
            << row.against;
    }
}

TEST(SmatBatchDetectionComparison, AnHourHasItsSunWhereAPlaceIsGiven) {
    const TemporaryFolder folder;
    const Words view = {"--step", "90", "--shadows", "off", "--ambient-reflection", "off"};
    const Words hours = {"--against", "hour", "--values", "8,12"};
    // Without one nothing of it is another at another hour.
    for (const Words& still : {Words{}, {"--sun", "off", "--sun-of", "2025-06-21,48,15"}}) {
        const Ran ran = smatBatch(with(with(with({"detection", sample(sphere), "--sensor",
                                                  sensorFile(folder), "--out", folder / "x.csv"},
                                                 view),
                                            hours),
                                       still));
        EXPECT_EQ(ran.exitCode, 2) << still.size();
        EXPECT_THAT(ran.err, HasSubstr("temperature"));
    }
    const ResultTable moved =
        detected(folder, sphere, with(with(view, hours), {"--sun-of", "2025-06-21,48,15"}));
    // At 15 degrees east 8 h of mean solar time are 7 h of universal time.
    const ResultTable alone = detected(folder, sphere,
                                       with(view, {"--date", "2025-06-21", "--utc", "07:00",
                                                   "--latitude", "48", "--longitude", "15"}));
    double expected_m = 0.0;
    for (std::size_t row = 0; row < 4; ++row) {
        expected_m += 0.25 * valueOf(alone, "detection_range", row);
    }
    EXPECT_NEAR(valueOf(moved, "detection_range", 0), expected_m, 1e-4 * expected_m);
    EXPECT_NE(valueOf(moved, "detection_range", 1), valueOf(moved, "detection_range", 0));
}

TEST(SmatBatchDetectionComparison, AMaterialThatNoFaceHasIsNoPaint) {
    const TemporaryFolder folder;
    const std::string project = boxWith(folder, 1.0);
    std::string text = contentOf(folder / "signature.json");
    const std::string head = "\"materials\": {";
    ASSERT_NE(text.find(head), std::string::npos);
    text.insert(text.find(head) + head.size(),
                "\"77\": {\"name\": \"spare\", \"emissivity\": 0.5},");
    write(folder / "signature.json", text);
    std::filesystem::remove(folder / "box.sigdb");
    ASSERT_EQ(smatBatch({"db", "import", folder / "signature.json", folder / "box.sigdb"}).exitCode,
              0);
    for (const auto& [paint, exitCode] : {std::pair{"spare", 2}, {"black", 0}}) {
        const Ran ran = smatBatch(
            with({"detection", project, "--sensor", sensorFile(folder), "--background-temperature",
                  "300", "--step", "180", "--against", "paint", "--paint", paint, "--values",
                  "0.1,0.9", "--out", folder / "x.csv"},
                 plain));
        EXPECT_EQ(ran.exitCode, exitCode) << paint << ran.err;
    }
}

// The path of a view from above climbs out of the air that a longer one would be in: the depth of
// the path itself is what changes.
TEST(SmatBatchDetectionComparison, ExtinctionHasASensitivityOnLevelAndSlantPaths) {
    const TemporaryFolder folder;
    const auto extinctionAt = [&](const char* offset_deg, const Words& air) {
        const ResultTable table =
            detected(folder, sphere,
                     with(with(with({"--step", "180", "--to", "10", "--altitude", "300",
                                     "--sensitivity", "--offset", offset_deg},
                                    air),
                               plain),
                          {}));
        return valueOf(table, "sensitivity_extinction", 0);
    };
    const Words air = {"--atmosphere", atmosphere(folder, "air.xml", {"Visibility=20000"})};
    EXPECT_LT(extinctionAt("0", air), -0.05);
    // A little air is added where the path leaves it.
    EXPECT_LT(extinctionAt("5", air), extinctionAt("0", air));
    // Most of the steeper path is above it.
    EXPECT_LT(extinctionAt("40", air), -1e-3);
    EXPECT_GT(extinctionAt("40", air), extinctionAt("5", air));
    EXPECT_NEAR(extinctionAt("5", {"--atmosphere", "vacuum"}), 0.0, 1e-6);
}

TEST(SmatBatchDetectionComparison, DirectionsAreThoseOfATableAndAgreeWithAPolarPlot) {
    const TemporaryFolder folder;
    const ResultTable table =
        detected(folder, "box/box.smat",
                 with({"--cases", "directions", "--set", "table.azimuthStep=90", "--set",
                       "table.elevationStep=45", "--set", "table.elevationFrom=0"},
                      plain));
    ASSERT_EQ(table.rowCount(), 12u);
    EXPECT_EQ(table.columns()[0].key, "azimuth");
    EXPECT_EQ(table.columns()[1].key, "elevation");
    EXPECT_EQ(table.columns()[2].key, "detection_range");
    const ResultTable polar =
        detected(folder, "box/box.smat", with({"--step", "90", "--offset", "45"}, plain));
    // But for where the aspect before each begins its search (design/054).
    for (std::size_t row = 0; row < 4; ++row) {
        EXPECT_NEAR(valueOf(table, "detection_range", row + 4),
                    valueOf(polar, "detection_range", row),
                    3e-5 * valueOf(polar, "detection_range", row));
    }
}

TEST(SmatBatchDetectionComparison, RefusesWhatItCannotCompare) {
    const TemporaryFolder folder;
    const std::string sensor = sensorFile(folder);
    for (const auto& [words, said] :
         {std::pair<Words, const char*>{{"--values", "3"}, "--against"},
          {{"--against", "tide", "--values", "3"}, "wind"},
          {{"--against", "wind"}, "--values"},
          {{"--against", "wind", "--values", "3"}, "AtmosphereSmart"},
          {{"--against", "wind", "--values", "300"}, "30 m/s"},
          {{"--against", "humidity", "--values", "x"}, "humidity"},
          {{"--against", "band", "--values", "4"}, "MIN-MAX"},
          {{"--against", "band", "--values", "4.1-4.0"}, "MIN-MAX"},
          {{"--against", "paint", "--values", "0.3"}, "--paint"},
          {{"--against", "paint", "--values", "0.3", "--paint", "gold"}, "grey 0.9"},
          {{"--against", "paint", "--values", "1.3", "--paint", "grey 0.9"}, "0 to 1"},
          {{"--against", "hour", "--values", "25"}, "24 h"},
          {{"--against", "hour", "--values", "5", "--sun-of", "2025-06-21,91,0"}, "--sun-of"},
          {{"--against", "band", "--values", "4-4.1", "--sun-of", "2025-06-21,9,0"}, "--sun-of"},
          {{"--against", "hour", "--values", "5", "--ranges", "100"}, "--ranges"},
          {{"--against", "hour", "--values", "5", "--sensitivity"}, "--sensitivity"},
          {{"--cases", "directions", "--set", "table.ranges=100,200"}, "table.ranges"},
          {{"--cases", "all"}, "directions"}}) {
        const Ran ran = smatBatch(with(
            {"detection", sample(sphere), "--sensor", sensor, "--out", folder / "x.csv"}, words));
        EXPECT_EQ(ran.exitCode, 2) << words.back() << ran.out;
        EXPECT_THAT(ran.err, HasSubstr(said)) << words.back();
    }
}

TEST(SmatBatchDetectionComparison, SensitivitiesToTheAirAreThoseOfWholeSearches) {
    const TemporaryFolder folder;
    const Words view = with({"--step", "180", "--to", "10", "--altitude", "300"}, plain);
    const Words measured = {"MeteoModel=2", "RelativeHumidityMH=60", "Visibility=20000",
                            "TemperatureMH=10", "TemperatureALT0=10"};
    const auto rangeIn = [&](const Words& parameters, const Words& more = {}) {
        return detected(folder, sphere,
                        with(with(view, {"--atmosphere", atmosphere(folder, "air.xml",
                                                                    with(measured, parameters))}),
                             more));
    };
    const ResultTable table = rangeIn({}, {"--sensitivity"});
    const auto wholeSearch = [&](const Words& less, const Words& more, double ratio) {
        return std::log(valueOf(rangeIn(more), "detection_range", 0) /
                        valueOf(rangeIn(less), "detection_range", 0)) /
               std::log(ratio);
    };
    EXPECT_NEAR(valueOf(table, "sensitivity_visibility", 0),
                wholeSearch({"Visibility=19800"}, {"Visibility=20200"}, 202.0 / 198.0), 5e-3);
    EXPECT_GT(valueOf(table, "sensitivity_visibility", 0), 0.01);
    EXPECT_NEAR(valueOf(table, "sensitivity_humidity", 0),
                wholeSearch({"RelativeHumidityMH=58"}, {"RelativeHumidityMH=62"}, 62.0 / 58.0),
                5e-3);
    EXPECT_LT(valueOf(table, "sensitivity_humidity", 0), -0.01);
    const double warmer = wholeSearch({"TemperatureMH=9", "TemperatureALT0=9"},
                                      {"TemperatureMH=11", "TemperatureALT0=11"}, 284.15 / 282.15);
    EXPECT_NEAR(valueOf(table, "sensitivity_air_temperature", 0), warmer,
                0.02 * std::abs(warmer) + 5e-3);
    // A model atmosphere has no measured temperature; all water vapour stands for its humidity.
    const Words model = {"--atmosphere", atmosphere(folder, "model.xml", {"Visibility=0"})};
    const ResultTable ofModel =
        detected(folder, sphere, with(with(view, model), {"--sensitivity"}));
    EXPECT_EQ(ofModel.find("sensitivity_air_temperature"), nullptr);
    EXPECT_EQ(ofModel.find("sensitivity_visibility"), nullptr) << "it is the aerosol model's own";
    EXPECT_LT(valueOf(ofModel, "sensitivity_humidity", 0), 0.0);
}

TEST(SmatBatchDetectionComparison, ErrorsHoldTheTruthOfRandomSensorsAirsAndTargets) {
    const TemporaryFolder folder;
    std::mt19937 random(5);
    const auto any = [&](double least, double most) {
        return std::exp(
            std::uniform_real_distribution<double>(std::log(least), std::log(most))(random));
    };
    int held = 0, all = 0;
    for (int n = 0; n < 12; ++n) {
        irsg::SensorDescription sensor = smallSensor();
        sensor.optics.aperture_m = any(0.02, 0.15);
        sensor.detector.pitch_um = any(10.0, 40.0);
        sensor.detector.integrationTime_s = any(1e-4, 2e-3);
        sensor.electronics.readNoise_e = any(20.0, 1000.0);
        sensor.detector.well_e = 1e9;
        const double from_um = any(3.4, 4.5);
        sensor.detector.band = {from_um, from_um + 0.3};
        const double snr = any(2.0, 20.0), extinction_per_m = n % 2 == 0 ? 0.0 : any(2e-5, 1e-3);
        const double emissivity = any(0.2, 1.0);
        write(folder / "air.csv",
              "# air_temperature [K]: 280\nwavelength [um],extinction [km-1]\n3," +
                  irsg::numberText(1e3 * extinction_per_m) + "\n6," +
                  irsg::numberText(1e3 * extinction_per_m) + "\n");
        Words words = with({"--step", "36", "--from", irsg::numberText(any(1.0, 30.0)), "--snr",
                            irsg::numberText(snr), "--nearest", "1000"},
                           plain);
        if (extinction_per_m > 0.0) {
            words = with(words, {"--atmosphere", folder / "air.csv"});
        }
        // Its paint by the database of a copy.
        const std::string box = boxWith(folder, emissivity);
        const Ran ran =
            smatBatch(with({"detection", box, "--sensor", sensorFile(folder, sensor),
                            "--background-temperature", "300", "--out", folder / "r.csv"},
                           words));
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        const ResultTable table = ResultTable::load(folder / "r.csv");
        const irsg::PixelResponse response(sensor);
        const double nei =
            response.noise(response.signal(300.0)).total() /
            (response.signalPerIrradiance() * irsg::PointSpread(sensor, 300.0).energyAt(0.0, 0.0));
        const irsg::Band band = sensor.band();
        const double behind =
            extinction_per_m > 0.0 ? irsg::bandRadiance_W_m2_sr(band, 280.0) : 0.0;
        const auto contrast = [&](double temperature_K) {
            return emissivity * irsg::bandRadiance_W_m2_sr(band, temperature_K) - behind;
        };
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            if (valueOf(table, "outcome", row) != 0.0) {
                continue;
            }
            const double azimuth_rad = std::numbers::pi * valueOf(table, "azimuth", row) / 180.0;
            // A dense search by bisection of what the box's faces send.
            double low_m = 100.0, high_m = 1e9;
            for (int i = 0; i < 100; ++i) {
                const double range_m = std::sqrt(low_m * high_m);
                const double irradiance =
                    std::abs(irradianceOfBox(azimuth_rad, range_m, contrast)) *
                    std::exp(-extinction_per_m * range_m);
                (irradiance / nei > snr ? low_m : high_m) = range_m;
            }
            ++all;
            const double error_m = valueOf(table, "error_detection_range", row);
            held += std::abs(valueOf(table, "detection_range", row) - low_m) <= error_m;
            EXPECT_LT(error_m, 0.05 * low_m);
        }
    }
    EXPECT_GT(all, 100);
    EXPECT_GE(held, 0.95 * all) << all;
}

} // namespace

} // namespace smat::test

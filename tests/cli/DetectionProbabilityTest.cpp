// The probability of detection over range, and over draws of scaling files.
#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/sensor/PointSpread.h"
#include "irsg/sensor/TargetingTask.h"
#include "tests/cli/SensorFiles.h"

namespace smat::test {

namespace {

using testing::HasSubstr;

// The haze of the sample answers to an optical depth of 8, which is some 1.3 km.
TEST(SmatBatchDetectionProbability, RangesThatTheSceneRefusesHaveTheProbabilityOfNoiseAlone) {
    const TemporaryFolder folder;
    const std::vector<std::string> fog = {
        "detection", sample("fog/fog.smat"),
        "--sensor",  std::string(SMAT_SOURCE_DIR) + "/resources/sensors/cooled-mwir.smatsensor",
        "--set",     "polar.from=0",
        "--set",     "polar.to=1",
        "--step",    "1",
        "--out",     folder / "p.csv"};
    for (const char* ranges : {"1000,2000", "2000", "2000,1000"}) {
        const Ran ran = smatBatch(with(fog, {"--ranges", ranges}));
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        const ResultTable table = ResultTable::load(folder / "p.csv");
        for (std::size_t row = 0; row < table.rowCount(); ++row) {
            const bool isRefused = valueOf(table, "range", row) == 2000.0;
            const double alone = 0.5 * std::erfc(5.0 / std::sqrt(2.0));
            for (const char* key : {"probability", "least_probability", "greatest_probability"}) {
                EXPECT_NEAR(valueOf(table, key, row), isRefused ? alone : 1.0, 1e-9)
                    << ranges << ", " << key;
            }
            EXPECT_EQ(valueOf(table, "snr", row) == 0.0, isRefused) << ranges;
            EXPECT_EQ(table.warningOf(row).empty(), !isRefused) << ranges;
        }
    }
    // Seen as far as there is an answer: nothing hides it there.
    const Ran ran = smatBatch(fog);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable found = ResultTable::load(folder / "p.csv");
    EXPECT_EQ(valueOf(found, "outcome", 0), 1.0);
    EXPECT_TRUE(std::isnan(valueOf(found, "error_detection_range", 0)));
    EXPECT_GT(valueOf(found, "detection_range", 0), 1000.0);
    EXPECT_LT(valueOf(found, "detection_range", 0), 2000.0);
    EXPECT_THAT(found.warningOf(0),
                testing::StartsWith(
                    "above the threshold at the farthest range that the scene answers for"));
    EXPECT_THAT(ran.err, HasSubstr("2 of 2 aspects end where the scene refuses longer ranges"));
    EXPECT_THAT(ran.err, testing::Not(HasSubstr("terrain")));
}

TEST(SmatBatchDetectionProbability, ProbabilityOverRangeIsThatOfTheSignalWithItsNoise) {
    const TemporaryFolder folder;
    const irsg::SensorDescription sensor = irsg::loadSensor(sensorFile(folder));
    const auto tableOf = [&](const std::vector<std::string>& more) {
        const Ran ran = smatBatch(with(
            with({"detection", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                  "--step", "180", "--background-temperature", "300", "--out", folder / "p.csv"},
                 plain),
            more));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "p.csv");
    };
    const ResultTable rose = tableOf({"--snr", "5", "--probability", "90"});
    const double range_m = valueOf(rose, "detection_range", 0);
    const ResultTable table =
        tableOf({"--snr", "5", "--ranges",
                 irsg::numberText(range_m) + "," + irsg::numberText(1.5 * range_m) + "," +
                     irsg::numberText(100.0 * range_m)});
    ASSERT_EQ(table.rowCount(), 3u);
    EXPECT_NEAR(valueOf(table, "probability", 0), 0.9, 1e-3);
    // In vacuum the ratio falls with the square of the range; the mean over places by the
    // midpoint rule.
    const irsg::PointSpread spread(sensor, 300.0);
    const double snr = valueOf(rose, "snr", 0) / 2.25;
    EXPECT_NEAR(valueOf(table, "snr", 1), snr, 1e-3 * snr);
    double probability = 0.0;
    for (int i = 0; i < 16; ++i) {
        for (int j = 0; j < 16; ++j) {
            const double ratio = snr * spread.energyAt((i + 0.5) / 32.0, (j + 0.5) / 32.0) /
                                 spread.energyAt(0.0, 0.0);
            probability += 0.5 * std::erfc((5.0 - ratio) / std::sqrt(2.0)) / 256.0;
        }
    }
    EXPECT_NEAR(valueOf(table, "probability", 1), probability, 2e-3);
    EXPECT_GT(probability, 0.01);
    // Far away noise alone is left.
    EXPECT_NEAR(valueOf(table, "probability", 2), 0.5 * std::erfc(5.0 / std::sqrt(2.0)), 1e-8);
    EXPECT_LE(valueOf(table, "least_probability", 1), valueOf(table, "probability", 1));
    EXPECT_GE(valueOf(table, "greatest_probability", 1), valueOf(table, "probability", 1));

    // A task: 50 % where its cycles are, by its law elsewhere.
    for (const auto& [criterion, law] :
         {std::pair{"johnson", irsg::johnsonLaw}, {"ttp", irsg::targetingLaw}}) {
        const std::vector<std::string> bars = {"--criterion", criterion, "--task", "recognition"};
        const double half_m =
            valueOf(tableOf(with(bars, {"--nearest", "10"})), "detection_range", 0);
        const ResultTable task = tableOf(with(
            bars, {"--ranges", irsg::numberText(half_m) + "," + irsg::numberText(2 * half_m)}));
        EXPECT_NEAR(valueOf(task, "probability", 0), 0.5, 2e-3) << criterion;
        const double cyclesOfHalf = valueOf(task, "cycles", 0);
        EXPECT_NEAR(valueOf(task, "probability", 1),
                    irsg::taskProbability(0.5 * cyclesOfHalf, cyclesOfHalf, law), 2e-3)
            << criterion;
    }
    for (const std::vector<std::string>& wrong :
         {std::vector<std::string>{"--ranges", "0,5"},
          {"--ranges", "5,x"},
          {"--draws", "4"},
          {"--ranges", "500", "--sensitivity"},
          {"--ranges", "500", "--nearest", "10"},
          {"--ranges", "500", "--draws", "4"}}) { // beside the sphere is no scaling file
        const Ran refused =
            smatBatch(with({"detection", sample("sphere/sphere.smat"), "--sensor",
                            sensorFile(folder), "--step", "180", "--out", folder / "x.csv"},
                           wrong));
        EXPECT_EQ(refused.exitCode, 2) << wrong.front() << " " << wrong.back();
    }
}

TEST(SmatBatchDetectionProbability, DrawsOfAScaleOfTheIntensityAreThoseOfTheClosedForm) {
    const TemporaryFolder folder;
    const std::filesystem::path spheres = sample("sphere/sphere.smat").parent_path();
    for (const char* name : {"sphere.smat", "sphere.flt", "sphere.sigdb"}) {
        std::filesystem::copy_file(spheres / name, folder / name);
    }
    // The emissivity is scaled by 0.4 to 1 alike.
    constexpr double least = 0.4, most = 1.0;
    write(folder / "sphere(emissivitiesScalings).xml",
          R"(<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<data><fileType>Parameters</fileType>
  <parameter name="1"><vector3><double>0.4</double><double>1</double><double>0</double></vector3>
  <documentation>material 1</documentation></parameter>
</data>)");
    const auto tableOf = [&](const std::vector<std::string>& more) {
        const Ran ran = smatBatch(with(
            with({"detection", folder / "sphere.smat", "--sensor", sensorFile(folder), "--step",
                  "180", "--background-temperature", "300", "--out", folder / "p.csv"},
                 plain),
            more));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "p.csv");
    };
    const double nominal_m = valueOf(tableOf({"--snr", "5"}), "detection_range", 0);
    constexpr double draws = 400.0;
    std::string ranges;
    const std::vector<double> factors = {0.6, 0.75, 0.9, 1.1};
    for (const double factor : factors) {
        ranges += (ranges.empty() ? "" : ",") + irsg::numberText(factor * nominal_m);
    }
    const ResultTable table = tableOf({"--ranges", ranges, "--draws", "400"});
    ASSERT_EQ(table.rowCount(), factors.size());
    // In vacuum the ratio is 5 s / factor^2 in the middle of a pixel.
    const irsg::PointSpread spread(irsg::loadSensor(sensorFile(folder)), 300.0);
    const double centre = spread.energyAt(0.0, 0.0);
    std::vector<double> energies;
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            energies.push_back(spread.energyAt((i + 0.5) / 16.0, (j + 0.5) / 16.0) / centre);
        }
    }
    for (std::size_t row = 0; row < factors.size(); ++row) {
        constexpr int steps = 200;
        double mean = 0.0, square = 0.0;
        for (int k = 0; k < steps; ++k) {
            const double scale = least + (most - least) * (k + 0.5) / steps;
            double probability = 0.0;
            for (const double energy : energies) {
                const double ratio = 5.0 * scale / (factors[row] * factors[row]) * energy;
                probability += 0.5 * std::erfc((5.0 - ratio) / std::sqrt(2.0)) / 64.0;
            }
            mean += probability / steps;
            square += probability * probability / steps;
        }
        const double deviation = std::sqrt(square - mean * mean);
        EXPECT_NEAR(valueOf(table, "probability", row), mean, 3.0 * deviation / std::sqrt(draws))
            << factors[row];
        EXPECT_NEAR(valueOf(table, "deviation_probability", row), deviation, 0.15 * deviation)
            << factors[row];
    }
    // Every draw is another: the mean of few is not that of many, and the same seed gives it again.
    const std::vector<std::string> few = {"--ranges", ranges, "--draws", "3"};
    const double once = valueOf(tableOf(few), "probability", 1);
    EXPECT_EQ(valueOf(tableOf(few), "probability", 1), once);
    EXPECT_NE(once, valueOf(table, "probability", 1));
    EXPECT_NE(valueOf(tableOf(with(few, {"--seed", "5"})), "probability", 1), once);
}

TEST(SmatBatchDetectionProbability, DrawsWithoutASpreadAreTheNominalProbability) {
    const TemporaryFolder folder;
    // The scales of the sample's files are 1 to 1.
    const auto tableOf = [&](const std::vector<std::string>& more) {
        const Ran ran = smatBatch(
            with(with({"detection", sample("ship/ship.smat"), "--sensor", sensorFile(folder),
                       "--step", "180", "--background-temperature", "290", "--atmosphere", "none",
                       "--ranges", "200000,400000", "--out", folder / "p.csv"},
                      plain),
                 more));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "p.csv");
    };
    const ResultTable nominal = tableOf({}), drawn = tableOf({"--draws", "8"});
    for (std::size_t row = 0; row < 2; ++row) {
        EXPECT_NEAR(valueOf(drawn, "probability", row), valueOf(nominal, "probability", row),
                    1e-12);
        EXPECT_NEAR(valueOf(drawn, "deviation_probability", row), 0.0, 1e-12);
    }
    EXPECT_EQ(drawn.provenance.value("detection.draws"), "8");
}

} // namespace

} // namespace smat::test

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/image/ImageFile.h"
#include "irsg/sensor/ResolvableTemperature.h"
#include "smatcore/support/TextFile.h"
#include "tests/cli/Scenarios.h"
#include "tests/cli/SensorFiles.h"

namespace smat::test {

namespace {

using testing::HasSubstr;

TEST(SmatBatchSensor, StatesNumbersByCauseAndConvention) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch(
        {"sensor", "info", sensorFile(folder), "--background-temperature", "290", "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    const auto& exact = json.at("by_convention").at("1/(4F^2+1)");
    const auto& small = json.at("by_convention").at("1/(4F^2)");
    EXPECT_NEAR(small.at("electrons").at("scene").get<double>() /
                    exact.at("electrons").at("scene").get<double>(),
                65.0 / 64.0, 1e-12);
    EXPECT_EQ(json.at("electrons"), exact.at("electrons"));
    EXPECT_EQ(json.at("noise_electrons").at("read"), 100.0);
    EXPECT_EQ(json.at("background_temperature_K"), 290.0);
    for (const char* key : {"netd_K", "nei_W_m2", "ner_W_m2_sr", "d_star_cm_sqrtHz_W"}) {
        EXPECT_GT(json.at(key).get<double>(), 0.0) << key;
    }
    EXPECT_THAT(smatBatch({"sensor", "info", sensorFile(folder)}).out, HasSubstr("netd_K"));
}

TEST(SmatBatchSensor, TabulatesTransferByComponent) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"sensor", "mtf", sensorFile(folder), "--frequencies",
                               "0,500,6100,20000", "--out", folder / "m.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "m.csv");
    ASSERT_EQ(table.rowCount(), 4u);
    for (std::size_t row = 0; row < 4; ++row) {
        double product = 1.0;
        for (const ResultColumn& column : table.columns()) {
            if (column.key != "frequency" && column.key != "system") {
                product *= column.values[row];
            }
        }
        EXPECT_NEAR(product, valueOf(table, "system", row), 1e-12);
    }
    EXPECT_NEAR(valueOf(table, "diffraction", 2), 0.393, 0.005); // half the cutoff is 0.391
    EXPECT_EQ(valueOf(table, "system", 3), 0.0);
}

TEST(SmatBatchSensor, RefusesByName) {
    const TemporaryFolder folder;
    const std::string good = sensorFile(folder);
    std::string text = irsg::sensorToJson(smallSensor());
    text.replace(text.find("\"focalLength_m\": 0.2"), 20, "\"focalLength_m\": 0.015");
    write(folder / "fast.smatsensor", text);
    const std::string project = sample("sphere/sphere.smat");
    struct Row {
        std::vector<std::string> words;
        const char* said;
    };
    for (const Row& row : {
             Row{{"sensor", "info", folder / "fast.smatsensor"}, "F/0.3"},
             Row{{"sensor", "info", folder / "none.smatsensor"}, "none.smatsensor"},
             Row{{"sensor", "info", good, "--background-temperature", "0"}, "above 0 K"},
             Row{{"sensor", "mtf", good, "--frequencies", "0,-5", "--out", folder / "m.csv"}, "-5"},
             Row{{"sensor", "mtf", good, "--out", folder / "m.csv"}, "--frequencies"},
             Row{{"sensor", "mtf", good, "--frequencies", "0"}, "--out"},
             Row{{"sensor", "mtf", good, "--frequencies", "0", "--direction", "up", "--out",
                  folder / "m.csv"},
                 "horizontal"},
             Row{{"image", project, "--quantity", "counts", "--out", folder / "i.exr"},
                 "image.quantity"},
             Row{{"image", project, "--sensor", good, "--truth-layers", "--out", folder / "i.exr"},
                 "image.truthLayers"},
             Row{{"image", project, "--sensor", folder / "fast.smatsensor", "--out",
                  folder / "i.exr"},
                 "F/0.3"},
             Row{{"explain", project, "--sensor", good, "--pixel", "1,1"}, "image.sensor"},
             Row{{"detection", project, "--out", folder / "r.csv"}, "--sensor"},
             Row{{"detection", project, "--sensor", good, "--snr", "0", "--out", folder / "r.csv"},
                 "--snr"},
             Row{{"detection", project, "--sensor", good, "--nearest", "500", "--farthest", "400",
                  "--out", folder / "r.csv"},
                 "--farthest"},
             Row{{"detection", project, "--sensor", good, "--point", "side", "--out",
                  folder / "r.csv"},
                 "corner"},
         }) {
        const Ran ran = smatBatch(row.words);
        EXPECT_EQ(ran.exitCode, 2) << row.words.at(0) << " " << row.said;
        EXPECT_THAT(ran.err, HasSubstr(row.said));
    }
}

TEST(SmatBatchSensor, AnImageInCountsIsKeptBySeedAndHasRadianceBeside) {
    const TemporaryFolder folder;
    const auto counted = [&](const char* name, const std::vector<std::string>& more) {
        const Ran ran = smatBatch(
            with(with({"image", sample("sphere/sphere.smat"), "--sensor", sensorFile(folder),
                       "--range", "12000", "--quantity", "counts", "--out", folder / name},
                      plain),
                 more));
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return irsg::readImageFile(folder / name);
    };
    const irsg::RadianceImage one = counted("a.exr", {});
    EXPECT_EQ(one.width(), 24);
    EXPECT_EQ(one.height(), 20);
    ASSERT_NE(one.find("counts"), nullptr);
    ASSERT_NE(one.find("L"), nullptr);
    EXPECT_EQ(one.primary().name, "counts");
    const irsg::RadianceImage again = counted("b.exr", {"--threads", "1"});
    EXPECT_EQ(again.find("counts")->values, one.find("counts")->values);
    const irsg::RadianceImage other = counted("c.exr", {"--noise-seed", "2"});
    EXPECT_NE(other.find("counts")->values, one.find("counts")->values);
}

TEST(SmatBatchSensor, TabulatesNominalRanges) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"sensor", "range", sensorFile(folder), "--extinctions", "0,1",
                               "--out", folder / "ranges.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "ranges.csv");
    ASSERT_EQ(table.rowCount(), 6u);
    const irsg::ResolvableTemperature resolvable(irsg::loadSensor(sensorFile(folder)), 300.0);
    for (std::size_t row = 0; row < 6; ++row) {
        const double left_K = 2.0 * std::exp(-1e-3 * valueOf(table, "extinction", row) *
                                             valueOf(table, "range", row));
        EXPECT_NEAR(resolvable.frequency_per_rad(left_K) * 2.3 / valueOf(table, "range", row),
                    valueOf(table, "line_pairs", row), 1e-6);
    }
    const Ran refused = smatBatch(
        {"sensor", "range", sensorFile(folder), "--extinctions", "0,x", "--out", folder / "x.csv"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("--extinctions"));
}

TEST(SmatBatchSensor, TabulatesWhatIsResolved) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"sensor", "mrtd", sensorFile(folder), "--frequencies",
                               "0,1000,3000,1e6", "--out", folder / "mrtd.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "mrtd.csv");
    const irsg::ResolvableTemperature resolvable(irsg::loadSensor(sensorFile(folder)), 300.0);
    using Direction = irsg::ResolvableTemperature::Direction;
    EXPECT_EQ(valueOf(table, "mrtd", 0), 0.0);
    for (const std::size_t row : {1u, 2u}) {
        const double f = valueOf(table, "frequency", row);
        EXPECT_NEAR(valueOf(table, "mrtd_vertical", row), resolvable.mrtd_K(f, Direction::vertical),
                    1e-12);
        EXPECT_NEAR(resolvable.frequency_per_rad(valueOf(table, "mrtd", row)) / f, 1.0, 1e-9);
    }
    EXPECT_TRUE(std::isnan(valueOf(table, "mrtd", 3)));
    const Ran refused = smatBatch({"sensor", "mrtd", sensorFile(folder), "--frequencies", "100",
                                   "--threshold", "0", "--out", folder / "x.csv"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("--threshold"));
}

TEST(SmatBatchSensor, SimulateWritesFramesInCountsEqualOnAnyNumberOfThreads) {
    const TemporaryFolder folder;
    (void)sensorFile(folder);
    writeTextFile(folder / "s.json",
                  scenarioOf(entity("box", "box", R"("position_m": [0, 4000, 100])"),
                             R"({"name": "south", "position_m": [0, 0, 100],
                   "image": {"sensor": "small.smatsensor", "sensorSamples": 2}})",
                             R"("dt_s": 1, "end_s": 2)"));
    const Ran ran = simulated(folder, {"--quantity", "counts", "--film", "film.png"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const irsg::RadianceImage frame = irsg::readExr(folder / "out/south/frame_000001.exr");
    EXPECT_EQ(frame.primary().name, "counts");
    EXPECT_EQ(frame.width(), 24);
    EXPECT_EQ(frame.attributes.at("sensor.title"), "small");
    EXPECT_EQ(frame.attributes.at("sensor.frame"), "1");
    EXPECT_EQ(frame.attributes.at("frame"), "1");
    EXPECT_TRUE(std::filesystem::exists(folder / "film-000002.png"));
    // The box stands before a cold sky.
    const auto [least, most] = std::ranges::minmax(frame.primary().values);
    EXPECT_GT(most, least + 300.0f);
    // In parts, on one thread, by --set: the same frames.
    const Ran again = smatBatch({"simulate", "s.json", "--out", "again", "--from", "1", "--set",
                                 "image.quantity=counts", "--threads", "1"},
                                folder.path());
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(pixels(folder / "again/south/frame_000001.exr"), frame.primary().values);

    const Ran bad =
        smatBatch({"simulate", "s.json", "--out", "bad", "--set", "image.sensor=absent.smatsensor"},
                  folder.path());
    EXPECT_EQ(bad.exitCode, 2);
    EXPECT_THAT(bad.err, HasSubstr("absent.smatsensor"));
}

} // namespace

} // namespace smat::test

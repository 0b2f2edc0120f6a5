#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/image/ExrFile.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "smatcore/data/ResultTable.h"
#include "tests/cli/Scenarios.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string flyby = sample("flyby/flyby.json");

/// A sphere that passes behind a box: seen from the south they are in line at 2 s.
std::string passing(const std::string& sensors) {
    return scenarioOf(entity("sphere", "sphere", R"("trajectory": "sphere.csv")") + ", " +
                          entity("box", "box", R"("position_m": [0, 100, 100])"),
                      sensors);
}
const char* const spherePath = "t,x,y,z,yaw,pitch,roll\n0,-4,200,100,0,0,0\n4,4,200,100,0,0,0\n";

TEST(SmatBatchSimulate, WritesTheFramesAndTablesOfTheSample) {
    const TemporaryFolder folder;
    const Ran ran =
        smatBatch({"simulate", flyby, "--out", folder / "out", "--from", "5", "--to", "6",
                   "--format", "exr", "--format", "png", "--light-error", "0.02", "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json["state"], "complete");
    ASSERT_EQ(json["sensors"].size(), 2u);
    for (const std::string name : {"mwir", "lwir"}) {
        for (const char* frame : {"frame_000010", "frame_000011", "frame_000012"}) {
            EXPECT_TRUE(
                std::filesystem::exists(folder / "out" / name / (frame + std::string(".exr"))));
            EXPECT_TRUE(
                std::filesystem::exists(folder / "out" / name / (frame + std::string(".png"))));
        }
        const ResultTable table = ResultTable::load(folder / "out" / (name + ".csv"));
        EXPECT_EQ(table.rowCount(), 3u);
        EXPECT_EQ(table.columns()[0].header(), "time [s]");
        EXPECT_GT(table.find("near.pixels")->values[0], 1000.0);
        EXPECT_EQ(table.find("far.irradiance")->unit, "W m-2");
        EXPECT_EQ(table.provenance.value("sensor"), name);
        EXPECT_EQ(table.provenance.value("state"), "complete");
    }
    const irsg::RadianceImage image = irsg::readExr(folder / "out/mwir/frame_000012.exr");
    EXPECT_EQ(image.attributes.at("time_s"), "6");
    EXPECT_EQ(image.attributes.at("entity.near.position_m"), "0 1400 1350");
}

TEST(SmatBatchSimulate, TwoSensorsGiveTheImagesOfTwoRunsBitForBit) {
    const TemporaryFolder folder;
    const auto run = [&](const std::string& out, const Words& more) {
        Words words = {"simulate", flyby,  "--out", folder / out,    "--from",
                       "6",        "--to", "6.5",   "--light-error", "0.02"};
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = smatBatch(words);
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
    };
    run("both", {});
    run("mwir", {"--sensor", "mwir"});
    run("lwir", {"--sensor", "lwir"});
    for (const std::string name : {"mwir", "lwir"}) {
        for (const char* frame : {"frame_000012.exr", "frame_000013.exr"}) {
            EXPECT_EQ(pixels(folder / "both" / name / frame), pixels(folder / name / name / frame))
                << name << " " << frame;
        }
        const ResultTable both = ResultTable::load(folder / "both" / (name + ".csv"));
        const ResultTable alone = ResultTable::load(folder / name / (name + ".csv"));
        EXPECT_EQ(both.columns(), alone.columns()) << name;
    }
    EXPECT_NE(pixels(folder / "both/mwir/frame_000012.exr"),
              pixels(folder / "both/lwir/frame_000012.exr"));
    EXPECT_FALSE(std::filesystem::exists(folder / "mwir/lwir"));
}

TEST(SmatBatchSimulate, WhatStandsBeforeHidesWhatIsBehind) {
    const TemporaryFolder folder;
    write(folder / "sphere.csv", spherePath);
    write(folder / "s.json", passing(south));
    const Ran ran = simulated(folder);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "out/south.csv");
    const auto& seen = table.find("sphere.pixels")->values;
    ASSERT_EQ(seen.size(), 5u);
    // The box's tail is 2 m by 1 m at 98 m: it covers the disc of 2 m behind it, 200 m away.
    EXPECT_NEAR(seen[0], seen[4], 0.1 * seen[0]);
    EXPECT_EQ(seen[2], 0.0);
    EXPECT_GT(seen[0], 20.0);
    const auto& box = table.find("box.intensity")->values;
    const auto [least, most] = std::minmax_element(box.begin(), box.end());
    // Nothing hides the box; in a window that it shares its edges are sampled elsewhere.
    EXPECT_NEAR(*least, *most, 5e-3 * *most);

    // The middle of the picture is the box's, whatever is behind: its tail, black, at 320 K.
    const irsg::RadianceImage image = irsg::readExr(folder / "out/south/frame_000002.exr");
    const double tail = irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(3, 5), 320.0);
    EXPECT_NEAR(image.at(24, 16), tail, 1e-5 * tail);
}

TEST(SmatBatchSimulate, TheOrderOfTheEntitiesChangesNoImage) {
    const TemporaryFolder folder;
    write(folder / "sphere.csv", spherePath);
    const std::string one = entity("sphere", "sphere", R"("trajectory": "sphere.csv")"),
                      other = entity("box", "box", R"("position_m": [0, 100, 100])");
    write(folder / "s.json", scenarioOf(one + "," + other, south));
    ASSERT_EQ(simulated(folder, {"--to", "1"}).exitCode, 0);
    const auto before = pixels(folder / "out/south/frame_000001.exr");
    write(folder / "s.json", scenarioOf(other + "," + one, south));
    ASSERT_EQ(simulated(folder, {"--to", "1"}).exitCode, 0);
    const auto after = pixels(folder / "out/south/frame_000001.exr");
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_NEAR(before[i], after[i], 1e-6 * std::abs(before[i]));
    }
}

TEST(SmatBatchSimulate, FramesKeepTheirNumbersWhereASensorIsNotThere) {
    const TemporaryFolder folder;
    write(folder / "sphere.csv", "t,x,y,z,yaw,pitch,roll\n1,0,200,100,0,0,0\n3,0,200,120,0,0,0\n");
    write(folder / "s.json",
          passing(R"({"name": "eye", "position_m": [0, 0, 100], "track": "sphere"},
                     {"name": "rider", "carrier": "sphere", "offset_m": [0, 5, 0]},
                     {"name": "drone", "trajectory": "sphere.csv", "hold": true,
                      "offset_m": [0, -150, 0]})"));
    const Ran ran = simulated(folder, {"--format", "csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("eye: 3 frames, complete"));
    EXPECT_THAT(ran.out, HasSubstr("no frame at 2 of the steps"));
    EXPECT_THAT(ran.out, HasSubstr("drone: 5 frames, complete"));
    for (const char* name : {"eye", "rider"}) {
        EXPECT_FALSE(std::filesystem::exists(folder / "out" / name / "frame_000000.csv"));
        EXPECT_TRUE(std::filesystem::exists(folder / "out" / name / "frame_000001.csv"));
        EXPECT_FALSE(std::filesystem::exists(folder / "out" / name / "frame_000004.csv"));
    }
    const ResultTable table = ResultTable::load(folder / "out/drone.csv");
    EXPECT_TRUE(std::isnan(table.find("sphere.intensity")->values[0]));
    EXPECT_FALSE(std::isnan(table.find("sphere.intensity")->values[1]));
    EXPECT_NEAR(table.find("sphere.range")->values[2], 150.0, 1e-9);
}

TEST(SmatBatchSimulate, DrawsFramesInWhichNobodyIs) {
    const TemporaryFolder folder;
    write(folder / "sphere.csv", "t,x,y,z,yaw,pitch,roll\n2,0,200,100,0,0,0\n");
    write(folder / "s.json",
          scenarioOf(entity("sphere", "sphere", R"("trajectory": "sphere.csv")"), south));
    const Ran ran = simulated(folder, {"--background", "1.5"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    for (const float value : pixels(folder / "out/south/frame_000000.exr")) {
        EXPECT_EQ(value, 1.5f);
    }
    const auto there = pixels(folder / "out/south/frame_000002.exr");
    EXPECT_GT(*std::max_element(there.begin(), there.end()), 1.6f);
}

TEST(SmatBatchSimulate, TellsOfWhatIsCutOffAndNotOfWhatNobodySees) {
    // The near box fills the frame and more; the one behind the sensor has sums of 0.
    const TemporaryFolder folder;
    write(folder / "s.json",
          scenarioOf(entity("near", "box", R"("position_m": [0, 12, 100])") + "," +
                         entity("behind", "box", R"("position_m": [0, -500, 100])") + "," +
                         entity("far", "box", R"("position_m": [0, 5000, 100])"),
                     south, R"("dt_s": 1, "end_s": 0)"));
    const Ran ran = simulated(folder);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("near reaches beyond the frame; what lies outside is not in the "
                                   "sums"));
    EXPECT_THAT(ran.out, Not(HasSubstr("behind reaches")));
    EXPECT_THAT(ran.out, Not(HasSubstr("far reaches")));
}

TEST(SmatBatchSimulate, WritesOnlyBandAndAirAboveAPicture) {
    const TemporaryFolder folder;
    write(folder / "sphere.csv", spherePath);
    write(folder / "s.json", passing(south));
    const Ran ran =
        simulated(folder, {"--to", "0", "--format", "png", "--width", "64", "--height", "64"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    // A range and an altitude of the settings, which are none of the scenario, would make it wider
    // than plane and colour bar.
    const std::string picture = contentOf(folder / "out/south/frame_000000.png");
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(picture.at(i)); };
    const int width_px = byte(18) * 256 + byte(19);
    EXPECT_GT(width_px, 256 + 100);
    EXPECT_LT(width_px, 450);
}

TEST(SmatBatchSimulate, GivesTheSameBytesTwice) {
    const TemporaryFolder folder;
    for (const char* name : {"a", "b"}) {
        std::filesystem::create_directories(folder / name);
        write(folder / name / "sphere.csv", spherePath);
        write(folder / name / "s.json", passing(south));
        const Ran ran = smatBatch({"simulate", "s.json", "--out", "out", "--to", "1", "--format",
                                   "exr", "--format", "csv", "--format", "png"},
                                  folder / name);
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
    }
    for (const char* name : {"south.csv", "south/frame_000001.exr", "south/frame_000001.csv",
                             "south/frame_000001.png"}) {
        EXPECT_EQ(contentOf(folder / "a/out" / name), contentOf(folder / "b/out" / name)) << name;
    }
}

TEST(SmatBatchSimulate, ADryRunSaysWhatWouldBeDrawn) {
    const Ran ran = smatBatch({"simulate", flyby, "--dry-run"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("mwir: 25 steps from 0 to 12 s, 320 x 240 px"));
    EXPECT_THAT(ran.out, HasSubstr("frame_000000.exr to frame_000024.exr"));
    const auto json = nlohmann::json::parse(
        smatBatch({"simulate", flyby, "--dry-run", "--json", "--sensor", "lwir"}).out);
    ASSERT_EQ(json["plans"].size(), 1u);
    EXPECT_EQ(json["plans"][0]["steps"], 25);
}

/// Files below a folder, by their places in it.
std::set<std::string> filesBelow(const std::filesystem::path& folder) {
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.insert(entry.path().lexically_relative(folder).string());
        }
    }
    return files;
}

TEST(SmatBatchSimulate, ADryRunListsTheFilesThatTheRunWritesAndNoOther) {
    // The sphere that one of the sensors tracks is there from 1 to 3 s, what a third tracks never.
    const std::string sensors = std::string(south) +
                                R"(, {"name": "both", "position_m": [0, 0, 100], "track": "sphere",
              "sensor": {"band": "3-5,8-12"}})";
    const std::string never =
        sensors + R"(, {"name": "never", "position_m": [0, 0, 100], "track": "late"})";
    const std::string late = R"("trajectory": "late.csv")";
    const struct {
        const char* name;
        Words more;
        std::string sensors;
        std::size_t frames, films;
    } rows[] = {{"one form", {}, sensors, 5 + 6, 0},
                {"three forms and pictures",
                 {"--format", "exr", "--format", "csv", "--format", "png", "--film", "film.png"},
                 sensors,
                 33,
                 3},
                {"one film", {"--sensor", "south", "--film", "film.png"}, sensors, 5, 1},
                {"a sensor that sees nothing", {"--film", "film.png"}, never, 5 + 6, 3},
                {"some steps", {"--from", "2", "--to", "4"}, sensors, 3 + 4, 0},
                {"a part of the steps", {"--shard", "2/2"}, sensors, 2 + 4, 0}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const TemporaryFolder folder;
        write(folder / "sphere.csv",
              "t,x,y,z,yaw,pitch,roll\n1,0,200,100,0,0,0\n3,4,200,100,0,0,0\n");
        write(folder / "late.csv",
              "t,x,y,z,yaw,pitch,roll\n91,0,200,100,0,0,0\n93,4,200,100,0,0,0\n");
        write(folder / "s.json",
              scenarioOf(entity("sphere", "sphere", R"("trajectory": "sphere.csv")") + "," +
                             entity("late", "sphere", late),
                         row.sensors));
        const std::set<std::string> before = filesBelow(folder.path());
        Words dry = row.more;
        dry.insert(dry.end(), {"--dry-run", "--json"});
        const Ran announced = simulated(folder, dry);
        ASSERT_EQ(announced.exitCode, 0) << announced.err;
        EXPECT_EQ(filesBelow(folder.path()), before) << "a dry run writes nothing";
        const auto json = nlohmann::json::parse(announced.out);
        std::set<std::string> listed;
        std::size_t frames = 0;
        const bool isPart = std::ranges::find(row.more, "--shard") != row.more.end();
        for (const auto& plan : json["plans"]) {
            frames += plan["frames"].size();
            listed.insert(plan["frames"].begin(), plan["frames"].end());
            listed.insert(plan["settings"].get<std::string>());
            listed.insert(plan["table"].get<std::string>() + (isPart ? ".part2of2" : ""));
        }
        EXPECT_EQ(frames, row.frames);
        EXPECT_EQ(json["films"].size(), row.films);
        for (const auto& film : json["films"]) {
            listed.insert(film.begin(), film.end());
        }
        listed.insert(before.begin(), before.end());
        const Ran ran = simulated(folder, row.more);
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_EQ(filesBelow(folder.path()), listed);
    }
}

TEST(SmatBatchSimulate, AnImagingSensorFileSetsWhatItSays) {
    const TemporaryFolder folder;
    write(folder / "sphere.csv", spherePath);
    write(folder / "i.xml",
          "<data><fileType>Parameters</fileType>"
          "<type>/ImagingSensor/Root/Sensor/ImagingSensor</type>"
          "<parameter name=\"AntialiasingMode\"><double>1</double></parameter>"
          "<parameter name=\"UseAtmosphereScattering\"><double>1</double></parameter></data>");
    write(folder / "s.json", passing(R"({"name": "south", "position_m": [0, 0, 100],
                                         "imagingSensor": "i.xml"})"));
    // Scattering without a database is no scattering: refused, not left out.
    const Ran ran = simulated(folder, {"--to", "0", "--json"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("an AtmosphereScatteringLUT or an MTF database"));
    const std::string database =
        std::filesystem::path(SMAT_SOURCE_DIR) / "resources/scattering/droplets-100um-mwir.mtf";
    const Ran with = simulated(folder, {"--to", "0", "--json", "--mtf", database});
    ASSERT_EQ(with.exitCode, 0) << with.err;
    const auto sensor = nlohmann::json::parse(with.out)["sensors"][0];
    EXPECT_EQ(sensor["settings"]["render.antialiasing"], "1");
    EXPECT_EQ(sensor["settings"]["render.scattering"], "true");
}

TEST(SmatBatchSimulate, WidebandPointsAreTrainedOnceForEachSensor) {
    const TemporaryFolder folder;
    write(folder / "sphere.csv", spherePath);
    const std::string air =
        std::filesystem::path(SMAT_SOURCE_DIR) / "resources/atmospheres/subarctic-winter.xml";
    write(folder / "s.json",
          scenarioOf(entity("sphere", "sphere", R"("trajectory": "sphere.csv")"),
                     R"({"name": "a", "position_m": [0, 0, 100], "sensor": {"band": "4.4-4.6"}},
                        {"name": "b", "position_m": [0, 0, 100], "sensor": {"band": "4-4.1"}})",
                     R"("dt_s": 1, "end_s": 2, "environment": {"atmospheres": [")" + air + "\"]}"));
    const Ran ran = simulated(folder, {"--mode", "ck", "--timing"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.err, testing::ContainsRegex("wideband points +2 "));
}

TEST(SmatBatchSimulate, AnInterruptOrATerminationKeepsFramesAndTables) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TemporaryFolder folder;
        write(folder / "sphere.csv", spherePath);
        write(folder / "s.json",
              scenarioOf(entity("sphere", "sphere", R"("trajectory": "sphere.csv", "hold": true)"),
                         south, R"("dt_s": 0.001, "end_s": 900)"));
        const Ran ran = smatBatch({"simulate", "s.json", "--out", "out", "--verbose"},
                                  folder.path(), "frames of 1 sensor", signal);
        EXPECT_EQ(ran.exitCode, 1) << ran.err;
        EXPECT_THAT(ran.err, HasSubstr("stopped"));
        const ResultTable table = ResultTable::load(folder / "out/south.csv");
        EXPECT_EQ(table.provenance.value("state"), "partial");
        EXPECT_LT(table.rowCount(), 900000u);
        // A whole frame for each row, and no half of one.
        std::size_t frames = 0;
        if (std::filesystem::exists(folder / "out/south")) {
            for (const auto& entry : std::filesystem::directory_iterator(folder / "out/south")) {
                EXPECT_EQ(entry.path().filename().string().rfind("frame_", 0), 0u);
                EXPECT_NO_THROW(irsg::readExr(entry.path())) << entry.path();
                ++frames;
            }
        }
        EXPECT_EQ(table.rowCount(), frames);
    }
}

struct BadRow {
    const char* name;
    std::string json;
    Words arguments, named;
};
void PrintTo(const BadRow& row, std::ostream* out) {
    *out << row.name;
}
class ABadSimulation : public testing::TestWithParam<BadRow> {};

TEST_P(ABadSimulation, IsRefusedWithPlaceAndValue) {
    const TemporaryFolder folder;
    write(folder / "sphere.csv", spherePath);
    write(folder / "file", "in the way");
    write(folder / "s.json", GetParam().json);
    const Ran ran = smatBatch(GetParam().arguments, folder.path());
    EXPECT_EQ(ran.exitCode, 2) << ran.out << ran.err;
    for (const std::string& word : GetParam().named) {
        EXPECT_THAT(ran.err, HasSubstr(word));
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "out/south/frame_000000.exr"));
}

const Words plain = {"simulate", "s.json", "--out", "out"};
Words with(const Words& more) {
    Words words = plain;
    words.insert(words.end(), more.begin(), more.end());
    return words;
}
const std::string ball = entity("ball", "sphere", R"("position_m": [0, 200, 100])");

INSTANTIATE_TEST_SUITE_P(
    Inputs, ABadSimulation,
    testing::Values(
        BadRow{"NoScenario", "", {"simulate", "none.json", "--out", "out"}, {"none.json"}},
        BadRow{"NotJson", "engage!", plain, {"s.json", "line 1", "a scenario"}},
        BadRow{"UnknownKey",
               scenarioOf(ball, south, R"("dt_s": 1, "end_s": 1, "fps": 9)"),
               plain,
               {"s.json: fps, line 5", "an unknown key with 9", "dt_s"}},
        BadRow{"NoOut", passing(south), {"simulate", "s.json"}, {"--out", "folder"}},
        BadRow{"OutThatIsAFile",
               passing(south),
               {"simulate", "s.json", "--out", "file"},
               {"file/south", "no folder"}},
        BadRow{"UnknownSensor", passing(south), with({"--sensor", "north"}), {"north", "south"}},
        BadRow{"UnknownForm", passing(south), with({"--format", "gif"}), {"--format", "gif"}},
        BadRow{"WordForATime", passing(south), with({"--from", "noon"}), {"--from", "noon"}},
        BadRow{"NoStepInTime",
               passing(south),
               with({"--from", "9"}),
               {"none from 9 to 4 s", "0 to 4 s"}},
        BadRow{"CameraBySet",
               passing(south),
               with({"--set", "camera.range=9"}),
               {"--set", "camera.range"}},
        BadRow{"UnknownSetting", passing(south), with({"--set", "a.b=9"}), {"a.b"}},
        BadRow{"NoTrajectory",
               scenarioOf(entity("a", "sphere", R"("trajectory": "none.csv")"), south),
               plain,
               {"none.csv"}},
        BadRow{"NoModel",
               scenarioOf(R"({"model": "none.flt", "database": "none.sigdb",
                              "position_m": [0, 0, 9]})",
                          south),
               plain,
               {"none.flt", "none.sigdb"}},
        BadRow{"NoImagingSensor",
               scenarioOf(ball, R"({"name": "south", "position_m": [0, 0, 1],
                                    "imagingSensor": "none.xml"})"),
               plain,
               {"none.xml"}},
        BadRow{"SensorBelowTheGround",
               scenarioOf(ball, R"({"name": "south", "position_m": [0, 0, -5]})"),
               plain,
               {"sensor south at 0 s", "-5 m", "at least 0 m"}},
        BadRow{"EntityBelowTheGround",
               scenarioOf(entity("ball", "sphere", R"("position_m": [0, 200, -9])"), south),
               plain,
               {"ball at 0 s", "-9 m"}},
        BadRow{"SensorInItsTarget",
               scenarioOf(ball, R"({"name": "south", "position_m": [0, 200, 100],
                                    "track": "ball"})"),
               plain,
               {"sensor south at 0 s", "ball, which it tracks"}},
        BadRow{"DatabaseOfAnotherModel",
               scenarioOf(R"({"name": "a", "model": ")" +
                              sample("chessboard/chessboard.flt").string() + R"(", "database": ")" +
                              sample("sphere/sphere.sigdb").string() +
                              R"(", "position_m": [0, 200, 100]})",
                          south),
               plain,
               {"a: material index", "faces"}}),
    [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace smat::test

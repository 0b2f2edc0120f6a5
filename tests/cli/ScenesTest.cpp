// Scenes of several models, made on the command line without a line of JSON: each model with a
// place, a state and a database of its own gives what it gives alone.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/geometry/view/Pose.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

/// A database whose only temperature follows time, power and speed.
const char* living = R"({"format": "smat-signature", "version": 1, "title": "living",
 "materials": {"1": {"name": "grey", "emissivity": 0.8, "transmissivity": 0, "nAngleFactor": 0}},
 "spectra": {}, "temperatures": {"1": {"name": "all", "mode": "temperature", "userSpectrum": "",
 "terms": {"base_K": 0, "ambientFactor": 1, "ambientOffset_K": 11.85, "recoveryFactor": 0.9,
  "power": {"loop": false, "nodes": [[0, 0], [1, 100]]},
  "time_s": {"loop": false, "nodes": [[-100, -50], [100, 50]]}}}}})";

std::string modelOf(const char* name) {
    return sample(name).string();
}

class Scenes : public testing::Test {
  protected:
    Ran run(std::vector<std::string> arguments, int exitCode = 0) {
        Ran ran = smatBatch(arguments, folder.path());
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        return ran;
    }
    /// The ship with a sphere and a crate, each with its own place, state and database.
    void makeThree() {
        write(folder / "living.json", living);
        run({"db", "import", "living.json", "living.sigdb"});
        run({"project",
             "new",
             "three.smat",
             modelOf("ship/ship.flt"),
             "--reference-point",
             "0,0,0",
             "--altitude",
             "0",
             "--heading",
             "20",
             "--power",
             "0.6",
             "--set",
             "sensor.width=32",
             "--set",
             "sensor.height=32",
             "--set",
             "sensor.fov=40",
             "--set",
             "camera.range=300000",
             "--set",
             "camera.azimuth=50",
             "--set",
             "camera.elevation=10",
             "--set",
             "time.step=10"});
        run({"project",
             "add",
             "three.smat",
             modelOf("sphere/sphere.flt"),
             "--name",
             "ball",
             "--database",
             "living.sigdb",
             "--east",
             "9000",
             "--north",
             "-4000",
             "--altitude",
             "2500",
             "--heading",
             "75",
             "--pitch",
             "10",
             "--roll",
             "-20",
             "--power",
             "0.25",
             "--time-offset",
             "12",
             "--reference-point",
             "0,0,0"});
        run({"project", "add", "three.smat", modelOf("sphere/sphere.flt"), "--name", "dart",
             "--database", "living.sigdb", "--east", "-7000", "--north", "6000", "--altitude",
             "8000", "--mach", "0.9", "--reference-point", "0,0,0"});
    }
    nlohmann::json info(const char* project) {
        return nlohmann::json::parse(run({"project", "info", project, "--json"}).out);
    }
    static std::vector<double> column(const ResultTable& table, const std::string& key) {
        const ResultColumn* found = table.find(key);
        EXPECT_NE(found, nullptr) << key;
        return found == nullptr ? std::vector<double>() : found->values;
    }
    ResultTable timePlot(std::vector<std::string> more) {
        more.insert(more.begin(), {"time"});
        more.insert(more.end(), {"--out", "time.json"});
        run(more);
        return ResultTable::load(folder / "time.json");
    }
    TemporaryFolder folder;
};

TEST_F(Scenes, GiveOfEachModelWhatItGivesAlone) {
    makeThree();
    const ResultTable all = timePlot({"three.smat"});
    const Project three = loadProject(folder / "three.smat");
    const irsg::Pose ship = targetPoseOf(three.settings);
    const irsg::Vec3 camera = irsg::Viewpoint::about(ship.position_m, ship.attitude.yaw_rad,
                                                     irsg::radians(50), irsg::radians(10), 300000)
                                  .position_m;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string name = three.models[i].shownName();
        // Alone it is the target, seen by the same camera, which then turns about it, at the times
        // that it is ahead of the scene.
        std::filesystem::copy_file(folder / "three.smat", folder / "alone.smat",
                                   std::filesystem::copy_options::overwrite_existing);
        run({"project", "target", "alone.smat", name});
        for (const ProjectModel& other : three.models) {
            if (other.shownName() != name) {
                run({"project", "remove", "alone.smat", other.shownName()});
            }
        }
        const irsg::Pose pose = poseOf(three, three.settings, i);
        const irsg::Vec3 way = camera - pose.position_m;
        const double range_m = irsg::length(way), ahead_s = three.models[i].own.timeOffset_s;
        const auto text = [](double value) { return std::to_string(value); };
        const ResultTable alone =
            timePlot({"alone.smat", "--from", text(ahead_s), "--to", text(ahead_s + 10), "--range",
                      text(range_m), "--azimuth",
                      text(irsg::degrees(std::atan2(way.x, way.y) + pose.attitude.yaw_rad)),
                      "--elevation", text(irsg::degrees(std::asin(way.z / range_m)))});
        for (const std::string key : {"intensity", "contrast_intensity", "irradiance"}) {
            const auto mine = column(all, name + "." + key), own = column(alone, key);
            ASSERT_EQ(mine.size(), 2U);
            ASSERT_EQ(own.size(), 2U);
            EXPECT_NE(own[0], 0.0) << name << key;
            // Irradiance is that of pixels, whose tilt goes with their place in the frame.
            const double bound = key == "irradiance" ? 2e-3 : 1e-6;
            for (std::size_t at = 0; at < 2; ++at) {
                EXPECT_NEAR(mine[at], own[at], bound * std::abs(own[at])) << name << key << at;
            }
        }
    }
    // A sphere of 1 m has a closed form: 300 K, 6 K of its 12 s ahead and 25 K of its power.
    const double radiance = 0.8 * irsg::bandRadiance_W_m2_sr(irsg::Band::fromText("3-5"), 331.0);
    const ResultTable dark = timePlot({"three.smat", "--sun", "off"});
    EXPECT_NEAR(column(dark, "ball.intensity")[0], irsg::pi * radiance, 2e-3 * irsg::pi * radiance);
}

TEST_F(Scenes, StateOverridesStayThoseOfTheirModels) {
    makeThree();
    const auto all = [&](std::vector<std::string> more) {
        more.insert(more.begin(), "three.smat");
        return timePlot(std::move(more));
    };
    const auto ofTime = [&](const ResultTable& table, const std::string& name) {
        return column(table, name + ".intensity");
    };
    const ResultTable before = all({}), faster = all({"--set", "models.dart.mach=0.2"}),
                      throttled = all({"--power", "0.1"});
    for (const std::string name : {"ship", "ball"}) {
        EXPECT_EQ(ofTime(before, name), ofTime(faster, name)) << name;
    }
    EXPECT_LT(ofTime(faster, "dart")[0], 0.8 * ofTime(before, "dart")[0]);
    // What has no power of its own has that of the target.
    EXPECT_EQ(ofTime(before, "ball"), ofTime(throttled, "ball"));
    EXPECT_LT(ofTime(throttled, "ship")[0], ofTime(before, "ship")[0]);
    EXPECT_LT(ofTime(throttled, "dart")[0], ofTime(before, "dart")[0]);
    // A sweep over power is one over the target's.
    run({"condition", "three.smat", "--over", "power", "--from", "0", "--to", "1", "--points", "2",
         "--out", "power.json"});
    const ResultTable sweep = ResultTable::load(folder / "power.json");
    EXPECT_EQ(ofTime(sweep, "ball")[0], ofTime(sweep, "ball")[1]);
    EXPECT_LT(ofTime(sweep, "dart")[0], 0.8 * ofTime(sweep, "dart")[1]);
    EXPECT_THAT(contentOf(folder / "power.json"),
                HasSubstr("east 9000 m, north -4000 m, altitude 2500 m, heading 75 deg, pitch 10 "
                          "deg, roll -20 deg, power 0.25, timeOffset 12 s"));
}

TEST_F(Scenes, AreMadeAndChangedWithoutJson) {
    run({"project", "new", "one.smat", modelOf("box/box.flt"), "--title", "A box"});
    run({"project", "add", "one.smat", modelOf("box/box.flt")});
    auto models = info("one.smat")["models"];
    ASSERT_EQ(models.size(), 2U);
    EXPECT_EQ(models[1]["name"], "box-2");
    EXPECT_GT(models[1]["east"].get<double>(), 2.0) << "beside the first";
    EXPECT_EQ(models[1]["altitude"], 1000.0) << "as high as the target";
    EXPECT_EQ(models[1]["power"], "target");
    run({"project", "set", "one.smat", "box-2", "--name", "mate", "--yaw", "-90", "--power", "0.5",
         "--fallback-material", "1"});
    run({"project", "set", "one.smat", "0", "--heading", "30", "--set", "camera.range=500"});
    models = info("one.smat")["models"];
    EXPECT_EQ(models[1]["heading"], 90.0);
    EXPECT_EQ(models[0]["yaw"], -30.0);
    const Project project = loadProject(folder / "one.smat");
    EXPECT_EQ(project.settings[key::targetYaw], -30.0);
    EXPECT_EQ(project.settings[key::cameraRange], 500.0);
    EXPECT_EQ(project.models[1].fallbackMaterial, 1);
    run({"project", "set", "one.smat", "mate", "--power", "target", "--fallback-material", "none"});
    EXPECT_EQ(loadProject(folder / "one.smat").models[1].own, StateOverride());
    // What a flag turned on, it turns off; beside it everything stays.
    const auto optionsOf = [&] { return loadProject(folder / "one.smat").models[1].options; };
    run({"project", "set", "one.smat", "mate", "--cut-texture-alpha", "--unit", "cm"});
    EXPECT_TRUE(optionsOf().cutsTextureAlpha);
    run({"project", "set", "one.smat", "mate", "--unit", "mm"});
    EXPECT_TRUE(optionsOf().cutsTextureAlpha);
    EXPECT_EQ(optionsOf().placing.unit_m, 1e-3);
    run({"project", "set", "one.smat", "mate", "--cut-texture-alpha", "false"});
    EXPECT_FALSE(optionsOf().cutsTextureAlpha);
    EXPECT_EQ(optionsOf().placing.unit_m, 1e-3);
    run({"project", "remove", "one.smat", "box"});
    EXPECT_EQ(info("one.smat")["models"][0]["name"], "mate");
    EXPECT_EQ(info("one.smat")["models"][0]["heading"], 90.0);
}

TEST_F(Scenes, RefuseWhatCannotBe) {
    run({"project", "new", "two.smat", modelOf("box/box.flt")});
    run({"project", "add", "two.smat", modelOf("box/box.flt"), "--name", "mate"});
    const std::string before = contentOf(folder / "two.smat");
    const std::vector<std::pair<std::vector<std::string>, std::string>> bad = {
        {{"project", "new", "two.smat", modelOf("box/box.flt")}, "two.smat, which exists"},
        {{"project", "new", "two.json", modelOf("box/box.flt")}, "a name that ends in .smat"},
        {{"project", "new", "new.smat", "nothing.flt"}, "nothing.flt"},
        {{"project", "add", "two.smat", "nothing.flt"}, "nothing.flt"},
        {{"project", "remove", "two.smat", "third"}, "box (0), mate (1)"},
        {{"project", "set", "two.smat", "mate"}, "nothing to set"},
        {{"project", "set", "two.smat", "mate", "--east", "far"}, "--east: found far"},
        {{"project", "set", "two.smat", "mate", "--pitch", "91"}, "from -90 to 90"},
        {{"project", "set", "two.smat", "mate", "--heading", "1", "--yaw", "1"}, "they are one"},
        {{"project", "set", "two.smat", "mate", "--mach", "-1"}, "--mach: found -1"},
        {{"project", "set", "two.smat", "0", "--east", "5"}, "nothing for the target"},
        {{"project", "set", "two.smat", "0", "--power", "target"}, "from 0 to 1000000"},
        {{"project", "set", "two.smat", "mate", "--reference-point", "1,2"}, "x,y,z in m"},
        {{"range", "two.smat", "--set", "models.mate.colour=1", "--out", "r.csv"},
         "one of east, north"},
        {{"range", "two.smat", "--set", "models.box.power=1", "--out", "r.csv"},
         "state.power says it of the target"},
        {{"range", "two.smat", "--set", "models.nobody.east=1", "--out", "r.csv"}, "mate (1)"},
        {{"simulate", modelOf("flyby/flyby.json"), "--set", "models.mate.east=1", "--out", "r"},
         "models.mate.east"},
    };
    for (const auto& [arguments, said] : bad) {
        EXPECT_THAT(run(arguments, 2).err, HasSubstr(said));
        EXPECT_EQ(contentOf(folder / "two.smat"), before) << said;
    }
    run({"project", "remove", "two.smat", "mate"});
    EXPECT_THAT(run({"project", "remove", "two.smat", "box"}, 2).err, HasSubstr("at least one"));
}

} // namespace
} // namespace smat::test

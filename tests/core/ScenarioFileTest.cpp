#include "smatcore/simulate/ScenarioFile.h"

#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/support/TextFile.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::filesystem::path here = "/scenarios/flyby/flyby.json";

Scenario readText(const std::string& text) {
    return scenarioFromJson(text, here);
}

Scenario fullScenario() {
    Scenario scenario;
    scenario.file = here;
    scenario.title = "Two aircraft";
    scenario.notes = "One before the other";
    scenario.dt_s = 0.25;
    scenario.start_s = -1.0;
    scenario.end_s = 2.0;
    scenario.settings.set("environment.atmospheres", "air.csv");
    scenario.settings.set("render.sun", "off");
    ScenarioEntity transport{.name = "transport",
                             .model = "../models/transport.flt",
                             .database = "/far/away/transport.sigdb",
                             .options = {.placing = {.nose = irsg::ModelAxis::minusX},
                                         .forceTwoSided = true,
                                         .cutsTextureAlpha = true},
                             .referencePoint_m = irsg::Vec3{1, 2, 3},
                             .fallbackTemperature = 4,
                             .fallbackMaterial = -5,
                             .trajectory = "transport.csv",
                             .hold = true,
                             .timeOffset_s = 0.5,
                             .power = 0.7,
                             .mach = 0.4};
    ScenarioEntity tower{.name = "tower",
                         .model = "tower.flt",
                         .database = "tower.sigdb",
                         .trajectory = {},
                         .pose = {{10, 20, 0}, {irsg::radians(33), 0, irsg::radians(-4)}}};
    scenario.entities = {transport, tower};
    ScenarioSensor fixed{.name = "fixed", .offset = {{0, 0, 5}, {}}, .track = "transport"};
    fixed.settings.set("sensor.band", "8-12");
    fixed.settings.set("render.sun", "smart"); // the default, against the scenario
    ScenarioSensor nose{.name = "nose",
                        .mount = MountKind::entity,
                        .carrier = "transport",
                        .offset = {{0, 12, 0}, {0, irsg::radians(-3), 0}},
                        .imagingSensor = "ImagingSensor.xml"};
    ScenarioSensor drone{.name = "drone",
                         .mount = MountKind::trajectory,
                         .trajectory = "drone.csv",
                         .hold = true,
                         .track = "tower"};
    scenario.sensors = {fixed, nose, drone};
    return scenario;
}

TEST(ScenarioFile, ComesBackEqual) {
    const Scenario scenario = fullScenario();
    Scenario back = readText(scenarioToJson(scenario, here));
    EXPECT_EQ(scenarioToJson(back, here), scenarioToJson(scenario, here));
    // Angles go through degrees.
    ASSERT_EQ(back.entities.size(), 2u);
    ASSERT_EQ(back.sensors.size(), 3u);
    EXPECT_NEAR(back.entities[1].pose.attitude.yaw_rad, irsg::radians(33), 1e-12);
    back.entities[1].pose = scenario.entities[1].pose;
    back.sensors[1].offset = scenario.sensors[1].offset;
    EXPECT_EQ(back, scenario);
}

TEST(ScenarioFile, SavesAndLoads) {
    const test::TemporaryFolder folder;
    saveScenario(fullScenario(), folder / "s.json");
    const Scenario back = loadScenario(folder / "s.json");
    EXPECT_EQ(back.file, folder / "s.json");
    EXPECT_EQ(back.resolve(back.entities[0].model).lexically_normal(),
              "/scenarios/models/transport.flt");
    EXPECT_THROW(saveScenario(back, folder / "none" / "s.json"), irsg::InputError);
    EXPECT_THROW(loadScenario(folder / "t.json"), irsg::InputError);
}

TEST(ScenarioFile, TheExampleOfTheManualIsRead) {
    const std::string page = readTextFile(SMAT_SOURCE_DIR "/docs/formats-scenario.md");
    const std::size_t begin = page.find("```json\n") + 8;
    const Scenario scenario = readText(page.substr(begin, page.find("```", begin) - begin));
    EXPECT_EQ(scenario.entities.size(), 2u);
    EXPECT_EQ(scenario.sensors.size(), 3u);
}

TEST(Scenario, StepsFromStartToEndWithBoth) {
    Scenario scenario{.file = {}, .dt_s = 0.1, .start_s = 0.0, .end_s = 0.3};
    EXPECT_EQ(scenario.times_s().size(), 4u); // 0.3 is not 3 x 0.1 in binary
    scenario.end_s = 0.35;
    EXPECT_EQ(scenario.times_s().size(), 4u);
    scenario.end_s = 0.0;
    EXPECT_THAT(scenario.times_s(), ElementsAre(0.0));
    scenario = {.file = {}, .dt_s = 0.5, .start_s = -1.0, .end_s = 0.0};
    EXPECT_THAT(scenario.times_s(), ElementsAre(-1.0, -0.5, 0.0));
}

struct BadRow {
    const char* name;
    std::string text;
    std::vector<std::string> named; ///< all in one diagnostic
};
void PrintTo(const BadRow& row, std::ostream* out) {
    *out << row.name;
}
class ABadScenario : public testing::TestWithParam<BadRow> {};

TEST_P(ABadScenario, IsRefusedWithKeyPathLineAndValue) {
    std::vector<std::string> messages;
    try {
        readText(GetParam().text);
        FAIL() << "accepted";
    } catch (const irsg::InputError& error) {
        for (const irsg::Diagnostic& diagnostic : error.diagnostics()) {
            messages.push_back(diagnostic.message());
        }
    }
    std::vector<testing::Matcher<std::string>> words;
    for (const std::string& word : GetParam().named) {
        words.emplace_back(HasSubstr(word));
    }
    EXPECT_THAT(messages, testing::Contains(testing::AllOfArray(words)));
    EXPECT_EQ(messages.size(), 1u) << testing::PrintToString(messages);
}

const std::string entity =
    R"({"name": "a", "model": "a.flt", "database": "a.sigdb", "position_m": [0, 0, 9]})";
const std::string sensor = R"({"name": "s", "position_m": [0, -99, 9], "track": "a"})";
const std::string fixedSensor = R"({"name": "s", "position_m": [0, -99, 9]})";

std::string scenarioOf(const std::string& entities, const std::string& sensors,
                       const std::string& more = R"("dt_s": 1, "end_s": 2)") {
    return "{\"version\": 1,\n \"entities\": [" + entities + "],\n \"sensors\": [" + sensors +
           "],\n " + more + "}";
}
/// A key of an entity or a sensor besides what it needs.
std::string entityWith(const std::string& more) {
    return scenarioOf(R"({"name": "a", "model": "a.flt", "database": "a.sigdb", )" + more + "}",
                      sensor);
}
std::string sensorWith(const std::string& more) {
    return scenarioOf(entity, R"({"name": "s", )" + more + "}");
}
const std::string stands = R"("position_m": [0, 0, 9], )";

INSTANTIATE_TEST_SUITE_P(
    Inputs, ABadScenario,
    testing::Values(
        BadRow{"NoJson", "engagement", {here, "line 1", "a scenario"}},
        BadRow{"AList", "[]", {"an object with version"}},
        BadRow{"NoVersion", "{}", {"version", "nothing", "version 1"}},
        BadRow{"NewerVersion", R"({"version": 2, "x": 1})", {"version", "newer program"}},
        BadRow{"NoStep", scenarioOf(entity, sensor, R"("end_s": 2)"), {"dt_s", "nothing"}},
        BadRow{"StepOfZero",
               scenarioOf(entity, sensor, R"("dt_s": 0, "end_s": 2)"),
               {"dt_s, line 4", "found 0", "1e-06"}},
        BadRow{"NoEnd", scenarioOf(entity, sensor, R"("dt_s": 2)"), {"end_s", "nothing"}},
        BadRow{"EndBeforeStart",
               scenarioOf(entity, sensor, R"("dt_s": 1, "end_s": 2, "start_s": 3)"),
               {"end_s, line 4", "found 2", "start_s, 3 s"}},
        BadRow{"TooManySteps",
               scenarioOf(entity, sensor, R"("dt_s": 1e-6, "end_s": 2)"),
               {"end_s", "1000000 steps"}},
        BadRow{"UnknownKey",
               scenarioOf(entity, sensor, R"("dt_s": 1, "end_s": 2, "fps": 25)"),
               {"fps, line 4", "an unknown key with 25", "dt_s, end_s, entities"}},
        BadRow{"UnknownSetting",
               scenarioOf(entity, sensor,
                          R"("dt_s": 1, "end_s": 2, "sensor": {"widht": 9, "width": 8})"),
               {"sensor.widht, line 4", "an unknown key with 9", "response, width"}},
        BadRow{"SettingOutOfRange",
               sensorWith(stands + R"("sensor": {"width": 0})"),
               {"sensors.0.sensor.width, line 3", "found 0", "16384"}},
        BadRow{"CameraOfASensor",
               sensorWith(stands + R"("camera": {"range": 9})"),
               {"sensors.0.camera", "none in a scenario"}},
        BadRow{"PolarSettings",
               scenarioOf(entity, sensor, R"("dt_s": 1, "end_s": 2, "polar": {"step": 9})"),
               {"polar", "none in a scenario"}},
        BadRow{"NoEntities", scenarioOf("", fixedSensor), {"entities", "[]"}},
        BadRow{"NoSensors", scenarioOf(entity, ""), {"sensors", "[]", "at least one"}},
        BadRow{"AnEntityThatIsAWord", scenarioOf(entity + ", \"b\"", sensor), {"entities.1", "b"}},
        BadRow{"NoModel",
               scenarioOf(R"({"name": "a", "database": "d", "position_m": [0, 0, 0]})", sensor),
               {"entities.0.model", "nothing"}},
        BadRow{"NoDatabase",
               scenarioOf(R"({"name": "a", "model": "d", "position_m": [0, 0, 0]})", sensor),
               {"entities.0.database", "nothing", ".sigdb"}},
        BadRow{"Nowhere",
               scenarioOf(R"({"name": "a", "model": "d", "database": "d"})", sensor),
               {"entities.0", "no place", "a CSV to follow"}},
        BadRow{"TrajectoryThatIsANumber",
               entityWith(R"("trajectory": 7)"),
               {"entities.0.trajectory", "7", "a text"}},
        BadRow{"PoseBesideATrajectory",
               entityWith(R"("trajectory": "t.csv", "yaw_deg": 3)"),
               {"entities.0.yaw_deg", "3", "no pose"}},
        BadRow{"HoldWithoutATrajectory",
               entityWith(stands + R"("hold": true)"),
               {"entities.0.hold", "a trajectory"}},
        BadRow{"PlaceOfTwoNumbers",
               entityWith(R"("position_m": [0, 0])"),
               {"entities.0.position_m", "[0,0]", "three numbers"}},
        BadRow{"UnknownKeyOfAnEntity",
               entityWith(stands + R"("colour": "red")"),
               {"entities.0.colour, line 2", "an unknown key with \"red\"", "database, fallback"}},
        BadRow{"NegativeMach", entityWith(stands + R"("mach": -1)"), {"entities.0.mach", "-1"}},
        BadRow{"NameTwice",
               scenarioOf(entity + "," + entity, sensor),
               {"entities.1.name", "\"a\"", "no other entity"}},
        BadRow{"NameThatSplitsAColumn",
               scenarioOf("{\"name\": \"a,b\"," + entity.substr(13), fixedSensor),
               {"entities.0.name", "a,b", "tables"}},
        BadRow{"SensorWithoutName",
               scenarioOf(entity, R"({"position_m": [0, 0, 9]})"),
               {"sensors.0.name", "nothing", "folder"}},
        BadRow{"SensorNameWithAPath",
               scenarioOf(entity, R"({"name": "../s", "position_m": [0, 0, 9]})"),
               {"sensors.0.name", "../s", "folder"}},
        BadRow{"SensorTwice",
               scenarioOf(entity, sensor + "," + sensor),
               {"sensors.1.name", "\"s\"", "no other sensor"}},
        BadRow{
            "SensorNowhere", sensorWith(R"("track": "a")"), {"sensors.0", "no place", "carrier"}},
        BadRow{"SensorAtTwoPlaces",
               sensorWith(stands + R"("carrier": "a")"),
               {"sensors.0", "position_m and carrier", "one of"}},
        BadRow{"UnknownCarrier",
               sensorWith(R"("carrier": "b")"),
               {"sensors.0.carrier", "\"b\"", "an entity: a"}},
        BadRow{"UnknownTarget",
               sensorWith(stands + R"("track": "b")"),
               {"sensors.0.track", "\"b\"", "an entity: a"}},
        BadRow{"TracksItsCarrier",
               sensorWith(R"("carrier": "a", "track": "a")"),
               {"sensors.0.track", "\"a\"", "another entity"}},
        BadRow{"AttitudeOfATracker",
               sensorWith(stands + R"("track": "a", "pitch_deg": 3)"),
               {"sensors.0.pitch_deg", "3", "tracks"}},
        BadRow{"OffsetOfAFixedSensor",
               sensorWith(stands + R"("offset_m": [0, 0, 1])"),
               {"sensors.0.offset_m", "position_m is the place"}},
        BadRow{"HoldOfACarriedSensor",
               sensorWith(R"("carrier": "a", "hold": true)"),
               {"sensors.0.hold", "a trajectory"}},
        BadRow{"KeyTwice",
               scenarioOf(entity, sensor, R"("dt_s": 1, "end_s": 2, "end_s": 3)"),
               {"end_s, line 4", "occurs twice"}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(ScenarioFile, ReportsAllDiagnosticsAtOnce) {
    try {
        readText(R"({"version": 1, "dt_s": "fast", "entities": [{"model": 3, "position_m": 1}],
                     "sensors": [{"track": "x", "sensor": {"fov": 500}}], "speed": 1})");
        FAIL() << "accepted";
    } catch (const irsg::InputError& error) {
        const std::string all = error.what();
        for (const char* place :
             {"dt_s", "end_s", "entities.0.model", "entities.0.database", "entities.0.position_m",
              "sensors.0.name", "sensors.0.track", "sensors.0.sensor.fov", "speed"}) {
            EXPECT_THAT(all, HasSubstr(place));
        }
    }
}

} // namespace
} // namespace smat

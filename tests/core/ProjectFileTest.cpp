#include "smatcore/project/ProjectFile.h"

#include <filesystem>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/support/TextFile.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

const std::filesystem::path here = "/projects/ship/ship.smat";

Project readText(const std::string& text) {
    return projectFromJson(text, here);
}

Project fullProject() {
    Project project;
    project.file = here;
    project.title = "A ship";
    project.notes = "Two lines\nof notes";
    ProjectModel target;
    target.name = "ship";
    target.file = "ship.flt";
    target.database = "../common/ship.sigdb";
    target.options.placing.nose = irsg::ModelAxis::minusX;
    target.options.forceTwoSided = true;
    target.options.cutsTextureAlpha = true;
    target.referencePoint_m = irsg::Vec3{1, 2, 3};
    target.fallbackTemperature = 0;
    target.fallbackMaterial = -4;
    ProjectModel boat;
    boat.file = "boat.flt";
    boat.database = "boat.sigdb";
    boat.pose = {{100, -20, 0.5}, {irsg::radians(33), irsg::radians(-4), irsg::radians(120)}};
    project.models = {target, boat};
    project.settings.set("sensor.width", 320);
    project.settings.set("sensor.fov", 0.1 + 0.2);
    project.settings.set("sensor.band", "8-12");
    project.settings.set("render.background", 1.25);
    project.settings.set("environment.atmospheres", "vacuum;haze.csv");
    NamedAnalysis image{"mwir", AnalysisKind::image, {}, "a note", ""};
    image.settings.set("sensor.band", "3-5");
    image.settings.set("image.truthLayers", "true");
    NamedAnalysis polar{"turn", AnalysisKind::polar, {}, "", ""};
    polar.settings.set("polar.type", "model-yaw");
    polar.settings.set("render.background", "none");
    project.analyses = {image, polar};
    return project;
}

TEST(ProjectFile, ComesBackEqual) {
    Project project = fullProject();
    // Paths come back in the form that suits the file's folder.
    project.settings.set("environment.atmospheres", "haze.csv");
    const Project back = readText(projectToJson(project, here));
    EXPECT_EQ(back.models[0], project.models[0]);
    EXPECT_EQ(back.models[1].pose.position_m, project.models[1].pose.position_m);
    EXPECT_NEAR(back.models[1].pose.attitude.roll_rad, project.models[1].pose.attitude.roll_rad,
                1e-12);
    EXPECT_EQ(back.settings, project.settings);
    EXPECT_EQ(back.analyses, project.analyses);
    EXPECT_EQ(back.title, project.title);
    EXPECT_EQ(back.notes, project.notes);
    EXPECT_EQ(projectToJson(back, here), projectToJson(project, here));
}

TEST(ProjectFile, TakesBandsAndResponsesAsAListOrAText) {
    for (const char* band : {R"("8-12, 3-5")", R"(["8-12", "3.0-5"])"}) {
        const Project read =
            readText(std::string(R"({"version": 1, "sensor": {"band": )") + band + "}}");
        EXPECT_EQ(read.settings.text("sensor.band"), "8-12,3-5") << band;
        EXPECT_EQ(readText(projectToJson(read, here)).settings, read.settings);
    }
    const Project one = readText(R"({"version": 1, "sensor": {"response": "a.csv"}})");
    EXPECT_EQ(one.settings.text("sensor.response"), "a.csv");
    EXPECT_NE(projectToJson(one, here).find(R"("response": "a.csv")"), std::string::npos);
    const Project two = readText(R"({"version": 1, "sensor": {"response": ["a.csv", "b.csv"]}})");
    EXPECT_EQ(two.settings.text("sensor.response"), "a.csv;b.csv");
    EXPECT_EQ(readText(projectToJson(two, here)).settings, two.settings);
}

TEST(ProjectFile, LeavesDefaultsOutAndSortsKeys) {
    Project project;
    project.settings.set("sensor.width", 640); // the default
    project.settings.set("target.yaw", 5);
    project.settings.set("camera.range", 7);
    EXPECT_EQ(projectToJson(project, here), R"({
  "camera": {
    "range": 7.0
  },
  "program": ")" + irsg::programWithVersion() + R"(",
  "target": {
    "yaw": 5.0
  },
  "version": 1
}
)");
}

TEST(ProjectFile, AnAnalysisMaySetADefaultAgainstItsProject) {
    Project project;
    project.settings.set("sensor.width", 320);
    NamedAnalysis image{"wide", AnalysisKind::image, {}, "", ""};
    image.settings.set("sensor.width", 640);
    project.analyses = {image};
    const Project back = readText(projectToJson(project, here));
    EXPECT_EQ(back.settings.with(back.analyses[0].settings)[key::sensorWidth], 640);
}

TEST(ProjectFile, KeepsUnknownKeysAndNamesThem) {
    const std::string text = R"({"version": 1, "future": {"a": [1, 2]},
        "sensor": {"width": 320, "noise": 0.1},
        "models": [{"file": "a.flt", "livery": "grey"}],
        "analyses": {"one": {"kind": "image", "camera": {"lens": "f2"}, "author": "x"}}})";
    const Project project = readText(text);
    EXPECT_THAT(unknownKeys(project),
                testing::UnorderedElementsAre("future", "sensor.noise", "models.0.livery",
                                              "analyses.one.author", "analyses.one.camera.lens"));
    const std::string saved = projectToJson(project, here);
    for (const char* kept : {"\"noise\": 0.1", "\"livery\": \"grey\"", "\"lens\": \"f2\"",
                             "\"author\": \"x\"", "\"future\""}) {
        EXPECT_THAT(saved, testing::HasSubstr(kept));
    }
    EXPECT_EQ(projectToJson(readText(saved), here), saved);
}

TEST(ProjectFile, PathsFollowTheProjectToAnotherFolder) {
    Project project;
    project.file = here;
    project.models = {{.name = "", .file = "ship.flt", .database = "/far/away/ship.sigdb"}};
    const std::string text = projectToJson(project, "/projects/copy/ship.smat");
    EXPECT_THAT(text, testing::HasSubstr("\"file\": \"../ship/ship.flt\""));
    EXPECT_THAT(text, testing::HasSubstr("\"database\": \"/far/away/ship.sigdb\""));
}

TEST(ProjectFile, TheExampleOfTheManualHoldsOnlyWhatIsKnown) {
    const std::string page = readTextFile(SMAT_SOURCE_DIR "/docs/formats-project.md");
    const std::size_t begin = page.find("```json\n") + 8;
    const Project project = readText(page.substr(begin, page.find("```", begin) - begin));
    EXPECT_TRUE(unknownKeys(project).empty());
    EXPECT_EQ(project.models.size(), 2u);
    EXPECT_EQ(project.analyses.size(), 3u);
}

TEST(ProjectFile, SavesAndLoads) {
    const test::TemporaryFolder folder;
    const Project project = fullProject();
    saveProject(project, folder / "p.smat");
    const Project back = loadProject(folder / "p.smat");
    EXPECT_EQ(back.file, folder / "p.smat");
    EXPECT_EQ(back.analyses.size(), 2u);
    EXPECT_FALSE(std::filesystem::exists(folder / "p.smat.part"));
    EXPECT_THROW(saveProject(project, folder / "none" / "p.smat"), irsg::InputError);
}

TEST(ProjectFile, ReportsAllDiagnosticsAtOnceWithKeyPathAndLine) {
    try {
        readText("{\"version\": 1,\n \"sensor\": {\"width\": 0,\n \"fov\": \"wide\"},\n"
                 " \"models\": [{\"database\": 7}],\n"
                 " \"analyses\": {\"x\": {\"kind\": \"movie\"}}}");
        FAIL();
    } catch (const irsg::InputError& error) {
        std::vector<std::string> positions;
        for (const irsg::Diagnostic& diagnostic : error.diagnostics()) {
            positions.push_back(diagnostic.position);
            EXPECT_EQ(diagnostic.file, here.string());
        }
        EXPECT_THAT(positions,
                    testing::UnorderedElementsAre(
                        "sensor.width, line 2", "sensor.fov, line 3", "models.0.file, line 4",
                        "models.0.database, line 4", "analyses.x.kind, line 5"));
    }
}

const std::string endlessNesting =
    R"({"version": 1, "x": )" + std::string(100000, '[') + std::string(100000, ']') + "}";

struct MalformedRow {
    const char* name;
    const char* text;
    const char* position; ///< how the first diagnostic's position begins
    const char* value;    ///< what is in its value
};

void PrintTo(const MalformedRow& row, std::ostream* out) {
    *out << row.name;
}

class MalformedProject : public testing::TestWithParam<MalformedRow> {};

TEST_P(MalformedProject, IsRefusedWithPositionValueAndExpectation) {
    try {
        readText(GetParam().text);
        FAIL() << "accepted";
    } catch (const irsg::InputError& error) {
        const irsg::Diagnostic& diagnostic = error.diagnostics().front();
        EXPECT_EQ(diagnostic.file, here.string());
        EXPECT_THAT(diagnostic.position, testing::StartsWith(GetParam().position));
        EXPECT_THAT(diagnostic.value, testing::HasSubstr(GetParam().value));
        EXPECT_FALSE(diagnostic.expected.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(
    Projects, MalformedProject,
    testing::Values(
        MalformedRow{"Nothing", "", "line 1, column 1", "the end of the text"},
        MalformedRow{"NoJson", "hello", "line 1", "not JSON"},
        MalformedRow{"CutOff", "{\"version\": 1,\n\"sensor\": {", "line 2, column 12",
                     "the end of the text"},
        MalformedRow{"BrokenUtf8", "{\"version\": 1, \"title\": \"\xff\"}", "line 1", "not JSON"},
        MalformedRow{"EndlessNesting", endlessNesting.c_str(), "line 1", "nested"},
        MalformedRow{"List", "[1]", "", "[1]"}, MalformedRow{"Number", "7", "", "7"},
        MalformedRow{"NoVersion", "{}", "version", "nothing"},
        MalformedRow{"NewerVersion", R"({"version": 2, "sensor": 7})", "version", "2"},
        MalformedRow{"VersionZero", R"({"version": 0})", "version", "0"},
        MalformedRow{"VersionInWords", R"({"version": "1"})", "version", "\"1\""},
        MalformedRow{"FractionalVersion", R"({"version": 1.5})", "version", "1.5"},
        MalformedRow{"KeyTwice", "{\"version\": 1, \"sensor\": {\"width\": 1,\n\"width\": 2}}",
                     "sensor.width, line 2", "twice"},
        MalformedRow{"TitleNoText", R"({"version": 1, "title": 5})", "title", "5"},
        MalformedRow{"NotesNoText", R"({"version": 1, "notes": []})", "notes", "[]"},
        MalformedRow{"ModelsNoList", R"({"version": 1, "models": {}})", "models", "{}"},
        MalformedRow{"ModelNoObject", R"({"version": 1, "models": ["a.flt"]})", "models.0",
                     "a.flt"},
        MalformedRow{"ModelWithoutFile", R"({"version": 1, "models": [{}]})", "models.0.file",
                     "nothing"},
        MalformedRow{"ModelWithEmptyFile", R"({"version": 1, "models": [{"file": ""}]})",
                     "models.0.file", "nothing"},
        MalformedRow{"ModelFileNoText", R"({"version": 1, "models": [{"file": 3}]})",
                     "models.0.file", "3"},
        MalformedRow{"UnknownNoseAxis",
                     R"({"version": 1, "models": [{"file": "a", "noseAxis": "up"}]})",
                     "models.0.noseAxis", "up"},
        MalformedRow{"TwoSidedNoTruth",
                     R"({"version": 1, "models": [{"file": "a", "twoSided": 1}]})",
                     "models.0.twoSided", "1"},
        MalformedRow{"PoseOfTheTarget",
                     R"({"version": 1, "models": [{"file": "a", "yaw_deg": 5}]})",
                     "models.0.yaw_deg", "5"},
        MalformedRow{"PositionOfTwoNumbers",
                     R"({"version": 1, "models": [{"file": "a"}, {"file": "b",
                        "position_m": [1, 2]}]})",
                     "models.1.position_m, line 2", "[1,2]"},
        MalformedRow{
            "PositionOfWords",
            R"({"version": 1, "models": [{"file": "a", "referencePoint_m": [1, 2, "x"]}]})",
            "models.0.referencePoint_m", "x"},
        MalformedRow{"PositionFarAway",
                     R"({"version": 1, "models": [{"file": "a"}, {"file": "b",
                        "position_m": [1, 2, 1e300]}]})",
                     "models.1.position_m", "1e+300"},
        MalformedRow{"PitchBeyondTheZenith",
                     R"({"version": 1, "models": [{"file": "a"}, {"file": "b", "pitch_deg": 91}]})",
                     "models.1.pitch_deg", "91"},
        MalformedRow{"FractionalIndex",
                     R"({"version": 1, "models": [{"file": "a", "fallbackMaterial": 0.5}]})",
                     "models.0.fallbackMaterial", "0.5"},
        MalformedRow{"SectionNoObject", R"({"version": 1, "sensor": 640})", "sensor", "640"},
        MalformedRow{"NumberOutOfRange", R"({"version": 1, "sensor": {"fov": 180}})", "sensor.fov",
                     "180"},
        MalformedRow{"NumberInQuotes", R"({"version": 1, "sensor": {"width": "640"}})",
                     "sensor.width", "\"640\""},
        MalformedRow{"NumberThatIsNull", R"({"version": 1, "sensor": {"width": null}})",
                     "sensor.width", "null"},
        MalformedRow{"NumberThatIsTrue", R"({"version": 1, "sensor": {"width": true}})",
                     "sensor.width", "true"},
        MalformedRow{"FractionOfAPixel", R"({"version": 1, "sensor": {"width": 1.5}})",
                     "sensor.width", "1.5"},
        MalformedRow{"ReversedBand", R"({"version": 1, "sensor": {"band": "5-3"}})", "sensor.band",
                     "5-3"},
        MalformedRow{"BandAsNumbers", R"({"version": 1, "sensor": {"band": [3, 5]}})",
                     "sensor.band", "[3,5]"},
        MalformedRow{"BandTwice", R"({"version": 1, "sensor": {"band": ["3-5", "3-5"]}})",
                     "sensor.band", "[\"3-5\",\"3-5\"]"},
        MalformedRow{"ResponseAsNumber", R"({"version": 1, "sensor": {"response": 3}})",
                     "sensor.response", "3"},
        MalformedRow{"UnknownChoice", R"({"version": 1, "render": {"sun": "yes"}})", "render.sun",
                     "yes"},
        MalformedRow{"BackgroundInQuotes", R"({"version": 1, "render": {"background": "1.5"}})",
                     "render.background", "1.5"},
        MalformedRow{"TruthInWords", R"({"version": 1, "range": {"log": "true"}})", "range.log",
                     "true"},
        MalformedRow{"AtmosphereNoList",
                     R"({"version": 1, "environment": {"atmospheres": "a.csv"}})",
                     "environment.atmospheres", "a.csv"},
        MalformedRow{"AtmosphereNoName", R"({"version": 1, "environment": {"atmospheres": [1]}})",
                     "environment.atmospheres", "[1]"},
        MalformedRow{"AnalysesNoObject", R"({"version": 1, "analyses": []})", "analyses", "[]"},
        MalformedRow{"AnalysisNoObject", R"({"version": 1, "analyses": {"a": 1}})", "analyses.a",
                     "1"},
        MalformedRow{"AnalysisWithoutKind", R"({"version": 1, "analyses": {"a": {}}})",
                     "analyses.a.kind", "nothing"},
        MalformedRow{"AnalysisOfUnknownKind",
                     R"({"version": 1, "analyses": {"a": {"kind": "film"}}})", "analyses.a.kind",
                     "film"},
        MalformedRow{"AnalysisThatLeavesItsFolder",
                     R"({"version": 1, "analyses": {"../a": {"kind": "image"}}})", "analyses.../a",
                     "../a"},
        MalformedRow{"AnalysisWithABadSetting",
                     R"({"version": 1, "analyses": {"a": {"kind": "polar",
                        "polar": {"step": 0}}}})",
                     "analyses.a.polar.step, line 2", "0"}),
    [](const auto& row) { return row.param.name; });

TEST(ProjectOfModel, TakesTheDatabaseBesideTheModel) {
    const test::TemporaryFolder folder;
    saveProject(Project(), folder / "signature.sigdb"); // any file will do
    EXPECT_EQ(projectOfModel(folder / "boat.flt").models[0].database, folder / "signature.sigdb");
    saveProject(Project(), folder / "boat.sigdb");
    EXPECT_EQ(projectOfModel(folder / "boat.flt").models[0].database, folder / "boat.sigdb");
    EXPECT_EQ(projectOfModel(folder / "boat.flt", "x.sigdb").models[0].database, "x.sigdb");
}

} // namespace
} // namespace smat

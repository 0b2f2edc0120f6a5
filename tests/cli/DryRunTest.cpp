#include <functional>
#include <map>
#include <ostream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/signature/ScalingXml.h"
#include "tests/cli/Program.h"
#include "tests/cli/Scenarios.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder with a project of a box, a scenario of it, and what a run of either needs.
class Rehearsal : public testing::Test {
  protected:
    Rehearsal() {
        copyScaledBox(folder_.path());
        project_ = {{"version", 1},
                    {"models", {{{"name", "box"}, {"file", "box.flt"}, {"database", "box.sigdb"}}}},
                    {"sensor", {{"width", 16}, {"height", 16}}},
                    {"render", {{"bounces", 0}}},
                    {"analyses", {{"look", {{"kind", "image"}}}}}};
        scenario_ = nlohmann::json::parse(scenarioOf(ownBox, south, R"("dt_s": 1, "end_s": 1)"));
        save();
    }
    void save() {
        write(folder_ / "p.smat", project_.dump());
        write(folder_ / "s.json", scenario_.dump());
    }
    /// All that lies in the folder with its contents.
    std::map<std::string, std::string> state() const {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / ".")) {
            files[entry.path().string()] = entry.is_regular_file() ? contentOf(entry.path()) : "";
        }
        return files;
    }
    /// The refusals of a program's messages; warnings may differ.
    static std::vector<std::string> errorsOf(const Ran& ran) {
        std::vector<std::string> errors;
        std::istringstream text(ran.err);
        for (std::string line; std::getline(text, line);) {
            if (line.starts_with("error: ")) {
                errors.push_back(line);
            }
        }
        return errors;
    }
    /// Rehearses, expects that nothing was changed, then runs, and expects the same refusal.
    void expectRefusedAlike(const Words& words, const std::string& because) {
        SCOPED_TRACE(testing::PrintToString(words));
        const auto before = state();
        Words rehearsal = words;
        rehearsal.emplace_back("--dry-run");
        const Ran dry = smatBatch(rehearsal, folder_.path());
        EXPECT_EQ(dry.exitCode, 2) << dry.err;
        EXPECT_THAT(dry.err, HasSubstr(because));
        EXPECT_EQ(state(), before);
        const Ran real = smatBatch(words, folder_.path());
        EXPECT_EQ(real.exitCode, 2) << real.err;
        EXPECT_EQ(errorsOf(dry), errorsOf(real));
    }

    TemporaryFolder folder_;
    nlohmann::json project_, scenario_;
};

/// Each command that can be rehearsed.
const std::vector<Words>& commands() {
    static const std::string sensor =
        std::string(SMAT_SOURCE_DIR) + "/resources/sensors/cooled-mwir.smatsensor";
    static const std::vector<Words> all = {
        {"polar", "p.smat", "--out", "r.csv"},
        {"image", "p.smat", "--out", "r.exr"},
        {"spectrum", "p.smat", "--out", "r.csv"},
        {"run", "p.smat", "--out", "results"},
        {"cost-accuracy", "p.smat", "--repeats", "1", "--out", "r.csv"},
        {"detection", "p.smat", "--sensor", sensor, "--out", "r.csv"},
        {"montecarlo", "p.smat", "--samples", "4", "--out", "r.csv"},
        {"montecarlo", "p.smat", "--samples", "4", "--shard", "1/2", "--out", "r.csv"},
        {"montecarlo", "s.json", "--samples", "4", "--out", "m.csv"},
        {"simulate", "s.json", "--out", "frames"}};
    return all;
}

struct Fault {
    const char* name;
    /// Done to project and scenario alike; each has the section.
    std::function<void(nlohmann::json&)> change;
    const char* because;
};

void PrintTo(const Fault& fault, std::ostream* out) {
    *out << fault.name;
}

class RehearsalOfFault : public Rehearsal, public testing::WithParamInterface<Fault> {};

TEST_P(RehearsalOfFault, RefusesWhatTheRunRefuses) {
    GetParam().change(project_);
    GetParam().change(scenario_);
    save();
    for (const Words& words : commands()) {
        expectRefusedAlike(words, GetParam().because);
    }
}

void setModel(nlohmann::json& one, const char* key, const std::string& value) {
    const bool isProject = one.contains("models");
    one[isProject ? "models" : "entities"][0]
       [isProject && key == std::string("model") ? "file" : key] = value;
}

INSTANTIATE_TEST_SUITE_P(
    All, RehearsalOfFault,
    testing::Values(
        Fault{"AResponseThatIsMissing",
              [](auto& one) { one["sensor"]["response"] = {"nowhere.csv"}; }, "nowhere.csv"},
        Fault{"AnAtmosphereThatIsMissing",
              [](auto& one) { one["environment"]["atmospheres"] = {"nowhere.smatatm"}; },
              "nowhere.smatatm"},
        Fault{"AnAtmosphereThatIsNone",
              [](auto& one) { one["environment"]["atmospheres"] = {"box.flt"}; }, "box.flt"},
        Fault{"ATerrainThatIsMissing",
              [](auto& one) { one["environment"]["terrain"] = "nowhere.flt"; }, "nowhere.flt"},
        Fault{"AModelThatIsMissing", [](auto& one) { setModel(one, "model", "nowhere.flt"); },
              "nowhere.flt"},
        Fault{"ADatabaseThatIsMissing",
              [](auto& one) { setModel(one, "database", "nowhere.sigdb"); }, "nowhere.sigdb"},
        Fault{"ADatabaseThatIsNone", [](auto& one) { setModel(one, "database", "box.flt"); },
              "box.flt"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST_F(Rehearsal, OfASoundRunSaysWhatWouldBeDrawnAndWritesNothing) {
    for (Words words : commands()) {
        const auto before = state();
        words.emplace_back("--dry-run");
        const Ran ran = smatBatch(words, folder_.path());
        EXPECT_EQ(ran.exitCode, 0) << words.front() << ran.err;
        EXPECT_FALSE(ran.out.empty()) << words.front();
        EXPECT_EQ(state(), before);
    }
}

TEST_F(Rehearsal, RefusesPlacesThatCannotBeWritten) {
    fs::create_directory(folder_ / "taken.csv");
    write(folder_ / "protected.csv", "x");
    fs::permissions(folder_ / "protected.csv", fs::perms::owner_read);
    for (Words words : commands()) {
        const bool isFolder = words.front() == "run" || words.front() == "simulate";
        const std::string ending = fs::path(words.back()).extension().string();
        if (isFolder) {
            words.back() = "box.flt";
            expectRefusedAlike(words, "a place where no folder can be made");
            words.back() = "box.flt/below";
            expectRefusedAlike(words, "a place where no folder can be made");
            continue;
        }
        const bool isOneTable = words.back() == "r.csv";
        words.back() = "nowhere/r" + ending;
        expectRefusedAlike(words, "a folder that does not exist");
        if (isOneTable) {
            words.back() = "taken.csv";
            expectRefusedAlike(words, "a folder");
            words.back() = "protected.csv";
            expectRefusedAlike(words, "a write-protected file");
        }
    }
}

TEST_F(Rehearsal, RefusesAnInputAsOutput) {
    write(folder_ / "response.csv", "wavelength [um],response\n3,1\n4,1\n");
    project_["sensor"]["response"] = {"response.csv"};
    save();
    for (const Words& words : commands()) {
        if (words.back() == "r.csv") {
            Words onInput = words;
            onInput.back() = "response.csv";
            expectRefusedAlike(onInput, "an input as output");
        }
    }
}

TEST_F(Rehearsal, RefusesWhatOnlyTheSceneShows) {
    // A code without an entry, and a target below the ground.
    const Ran made = smatBatch({"db", "export", "box.sigdb", "box.json"}, folder_.path());
    ASSERT_EQ(made.exitCode, 0) << made.err;
    auto database = nlohmann::json::parse(contentOf(folder_ / "box.json"));
    ASSERT_FALSE(database["temperatures"].empty());
    database["temperatures"].erase(database["temperatures"].begin());
    write(folder_ / "less.json", database.dump());
    const Ran imported = smatBatch({"db", "import", "less.json", "less.sigdb"}, folder_.path());
    ASSERT_EQ(imported.exitCode, 0) << imported.err;
    setModel(project_, "database", "less.sigdb");
    setModel(scenario_, "database", "less.sigdb");
    save();
    for (const Words& words : commands()) {
        expectRefusedAlike(words, "temperature index");
    }
    setModel(project_, "database", "box.sigdb");
    setModel(scenario_, "database", "box.sigdb");
    project_["target"]["altitude"] = 10;
    project_["camera"]["elevation"] = -60;
    scenario_["entities"][0]["position_m"] = {0, 5000, -50};
    save();
    for (const Words& words : commands()) {
        // Those that take their elevations from the sweep see it.
        const bool isTurned = words.front() == "montecarlo" && words[1] == "p.smat";
        if (words.front() != "polar" && words.front() != "detection" && !isTurned) {
            expectRefusedAlike(words, "at least 0 m");
        }
    }
}

TEST_F(Rehearsal, RefusesAHazeDatabaseThatIsMissingOrNoneForImages) {
    for (const char* database : {"nowhere.mtf", "box.flt"}) {
        for (nlohmann::json* one : {&project_, &scenario_}) {
            (*one)["environment"]["mtf"] = database;
            (*one)["render"]["scattering"] = true;
        }
        save();
        for (const Words& words : commands()) {
            if (words.front() == "image" || words.front() == "run" || words.front() == "simulate") {
                expectRefusedAlike(words, database);
            }
        }
    }
}

TEST_F(Rehearsal, RefusesAFilmWithoutAPlaceForIt) {
    Words words = commands().back();
    words.insert(words.end(), {"--film", "nowhere/film.png"});
    expectRefusedAlike(words, "a folder that does not exist");
}

TEST_F(Rehearsal, RefusesASensorThatNoFrameIsDrawnThrough) {
    const std::string shipped =
        contentOf(std::string(SMAT_SOURCE_DIR) + "/resources/sensors/cooled-mwir.smatsensor");
    nlohmann::json sensor = nlohmann::json::parse(shipped, nullptr, true, true);
    sensor["detector"]["columns"] = 16384;
    write(folder_ / "wide.smatsensor", sensor.dump());
    expectRefusedAlike({"image", "p.smat", "--sensor", "wide.smatsensor", "--out", "r.exr"},
                       "image.sensorSamples");
    expectRefusedAlike(
        {"simulate", "s.json", "--set", "image.sensor=wide.smatsensor", "--out", "frames"},
        "image.sensorSamples");
    sensor["detector"]["columns"] = 64;
    sensor["motion"]["jitter_urad"] = 1e6;
    write(folder_ / "wide.smatsensor", sensor.dump());
    expectRefusedAlike({"image", "p.smat", "--sensor", "wide.smatsensor", "--out", "r.exr"},
                       "a point spread over more than");
    // What the sensor gives, and what only a sensor takes.
    for (const Words& idle : {Words{"--width", "100"}, {"--fov", "10"}, {"--band", "8-12"}}) {
        Words words = {"image", "p.smat", "--sensor", "wide.smatsensor", "--out", "r.exr"};
        words.insert(words.end(), idle.begin(), idle.end());
        expectRefusedAlike(words, idle.front() + ": found");
    }
    expectRefusedAlike({"image", "p.smat", "--noise-seed", "3", "--out", "r.exr"},
                       "--noise-seed: found");
    fs::remove(irsg::scalingFile(folder_ / "box.flt", irsg::ScalingKind::emissivity));
    fs::remove(irsg::scalingFile(folder_ / "box.flt", irsg::ScalingKind::temperature));
    expectRefusedAlike({"detection", "p.smat", "--sensor",
                        std::string(SMAT_SOURCE_DIR) + "/resources/sensors/cooled-mwir.smatsensor",
                        "--ranges", "1000", "--draws", "2", "--out", "r.csv"},
                       "scaling file");
}

TEST_F(Rehearsal, RefusesToGoOnWithCasesOfAnotherSweep) {
    write(folder_ / "r.csv.cases", "{\"format\": 1}\n");
    for (Words words :
         {Words{"polar", "p.smat"}, Words{"montecarlo", "p.smat", "--samples", "4"}}) {
        words.insert(words.end(), {"--set", "polar.step=120", "--out", "r.csv", "--resume"});
        expectRefusedAlike(words, "r.csv.cases");
    }
}

TEST_F(Rehearsal, OfMonteCarloRefusesWhatCannotBeDrawn) {
    const Words ofProject = {"montecarlo", "p.smat", "--out", "r.csv"};
    const Words ofScenario = {"montecarlo", "s.json", "--out", "m.csv"};
    const auto with = [](Words words, const Words& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    for (const Words& words : {ofProject, ofScenario}) {
        expectRefusedAlike(with(words, {"--samples", "1"}), "a whole number from 2");
    }
    expectRefusedAlike(with(ofProject, {"--analysis", "look"}), "an image");
    expectRefusedAlike(with(ofProject, {"--shard", "1/2", "--ranking"}), "ranking");
    expectRefusedAlike(with(ofProject, {"--shard", "1/2", "--draws", "d.csv"}), "--draws");
    expectRefusedAlike(with(ofProject, {"--samples", "10000000"}), "values in all");
    // One file cannot hold two results.
    expectRefusedAlike(with(ofProject, {"--draws", "r.csv"}), "two results");
    expectRefusedAlike(with(ofProject, {"--ranking", "--draws", "./r-ranking.csv"}), "two results");
    // At which the sweep has no case, and a percentile that no number of draws bounds.
    expectRefusedAlike(with(ofProject, {"--ranking-at", "1e9"}), "from 0 to 355 deg");
    expectRefusedAlike(with(ofProject, {"--statistic", "p100", "--standard-error", "0.01"}),
                       "draws on both sides");
    // Files of a scenario have the names of its parts.
    fs::create_directory(folder_ / "m-south-box.csv");
    expectRefusedAlike(ofScenario, "m-south-box.csv");
    fs::remove(folder_ / "m-south-box.csv");
    fs::create_directory(folder_ / "d-south.csv");
    expectRefusedAlike(with(ofScenario, {"--draws", "d.csv"}), "d-south.csv");
    fs::remove(folder_ / "d-south.csv");
    fs::create_directory(folder_ / "r-ranking.csv");
    expectRefusedAlike(with(ofProject, {"--ranking"}), "r-ranking.csv");
    fs::remove(folder_ / "r-ranking.csv");
    fs::remove(irsg::scalingFile(folder_ / "box.flt", irsg::ScalingKind::emissivity));
    expectRefusedAlike(ofProject, "scaling file");
    expectRefusedAlike(ofScenario, "scaling file");
}

TEST_F(Rehearsal, OfMonteCarloSaysHowManyCasesAndDraws) {
    const auto plansOf = [&](const Words& words) {
        const Ran ran = smatBatch(words, folder_.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return nlohmann::json::parse(ran.out)["plans"];
    };
    const auto ofProject = plansOf({"montecarlo", "p.smat", "--set", "polar.step=120", "--samples",
                                    "300", "--dry-run", "--json"});
    ASSERT_EQ(ofProject.size(), 1u);
    EXPECT_EQ(ofProject[0]["kind"], "polar");
    EXPECT_EQ(ofProject[0]["cases"], 3);
    EXPECT_EQ(ofProject[0]["draws"], 300);
    const auto ofScenario = plansOf({"montecarlo", "s.json", "--dry-run", "--json"});
    ASSERT_EQ(ofScenario.size(), 1u);
    EXPECT_EQ(ofScenario[0]["sensor"], "south");
    EXPECT_EQ(ofScenario[0]["steps"], 2);
    EXPECT_EQ(ofScenario[0]["draws"], 1024);
}

} // namespace
} // namespace smat::test

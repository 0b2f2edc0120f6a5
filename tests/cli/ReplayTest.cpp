// smat-batch replay: results run again from what they say of themselves, and what changed since
// told apart. A grey sphere in vacuum: its intensity goes with its emissivity and with the
// response.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class SmatBatchReplay : public testing::Test {
  protected:
    void SetUp() override {
        std::filesystem::copy(std::filesystem::path(sample("sphere/sphere.smat")).parent_path(),
                              folder.path(), std::filesystem::copy_options::recursive);
        setResponse("1");
    }
    Ran in(const std::vector<std::string>& arguments) {
        return smatBatch(arguments, folder.path());
    }
    void setResponse(const std::string& response) {
        write(folder / "response.csv", "um,response\n3," + response + "\n5," + response + "\n");
    }
    void setEmissivity(const std::string& emissivity) {
        std::string text = contentOf(folder / "signature.json");
        const std::string before = R"("emissivity": 0.9)";
        text.replace(text.find(before), before.size(), R"("emissivity": )" + emissivity);
        write(folder / "edited.json", text);
        std::filesystem::remove(folder / "sphere.sigdb");
        ASSERT_EQ(in({"db", "import", "edited.json", "sphere.sigdb"}).exitCode, 0);
    }
    void makePolar() {
        const Ran ran = in({"polar", "sphere.smat", "--step", "90", "--sun", "off", "--bounces",
                            "0", "--response", "response.csv", "--out", "polar.csv"});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
    }
    static double relative(const Json& differences, const std::string& column) {
        for (const Json& one : differences) {
            if (one["name"] == column) {
                return one["relative"];
            }
        }
        return 0.0;
    }
    static Json causeOf(const Json& replay, const std::string& role) {
        for (const Json& cause : replay["causes"]) {
            if (cause["role"] == role) {
                return cause;
            }
        }
        return {};
    }

    const TemporaryFolder folder;
};

TEST_F(SmatBatchReplay, OfWhatNobodyChangedGivesTheSameNumbers) {
    makePolar();
    const std::string before = contentOf(folder / "polar.csv");
    EXPECT_THAT(before, HasSubstr(" database sphere.sigdb\n"));
    const Ran ran = in({"replay", "polar.csv", "--out", "again.csv"});
    EXPECT_EQ(ran.exitCode, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("Every number is the same."));
    for (const char* input : {"same      database sphere.sigdb", "same      model sphere.flt",
                              "same      sensor.response response.csv", "same      renderer"}) {
        EXPECT_THAT(ran.out, HasSubstr(input));
    }
    // The project's own settings may be others by now: the result says what it was asked for.
    std::string project = contentOf(folder / "sphere.smat");
    const std::string range = "\"range\": 100\n";
    ASSERT_NE(project.find(range), std::string::npos);
    write(folder / "sphere.smat",
          project.replace(project.find(range), range.size(), "\"range\": 200\n"));
    EXPECT_EQ(in({"replay", "polar.csv"}).exitCode, 0);
}

TEST_F(SmatBatchReplay, TellsWhichInputChangedAndByHowMuch) {
    makePolar();
    setEmissivity("0.45");
    const Ran ran = in({"replay", "polar.csv", "--json"});
    EXPECT_EQ(ran.exitCode, 1) << ran.err;
    const Json replay = Json::parse(ran.out);
    EXPECT_FALSE(replay["same"]);
    ASSERT_EQ(replay["causes"].size(), 1U);
    EXPECT_EQ(replay["causes"][0]["name"], "sphere.sigdb");
    EXPECT_TRUE(replay["causes"][0]["told_apart"]);
    EXPECT_NEAR(relative(replay["causes"][0]["effect"], "intensity"), 0.5, 1e-9);
    EXPECT_EQ(in({"replay", "polar.csv", "--tolerance", "0.6"}).exitCode, 0);
    EXPECT_THAT(in({"replay", "polar.csv"}).out, HasSubstr("50 % of the largest value"));
}

TEST_F(SmatBatchReplay, TellsSeveralChangesApartByTheFilesAsTheyWere) {
    makePolar();
    for (const char* name : {"sphere.sigdb", "response.csv"}) {
        std::filesystem::copy_file(folder / name, folder / (std::string("former-") + name));
    }
    setEmissivity("0.45");
    setResponse("0.25");
    const Ran unknown = in({"replay", "polar.csv"});
    EXPECT_EQ(unknown.exitCode, 1);
    EXPECT_THAT(unknown.out, HasSubstr("database sphere.sigdb: not told apart"));
    // An eighth is left. The one that goes back alone: a half and three quarters of what is then.
    const std::vector<std::vector<std::string>> given{
        {"--previous", "former-sphere.sigdb", "--previous", "former-response.csv"},
        {"--previous", "former-sphere.sigdb"}};
    for (const auto& former : given) {
        std::vector<std::string> arguments{"replay", "polar.csv", "--json"};
        arguments.insert(arguments.end(), former.begin(), former.end());
        const Json replay = Json::parse(in(arguments).out);
        EXPECT_NEAR(relative(replay["differences"], "intensity"), 0.875, 1e-9);
        EXPECT_NEAR(relative(causeOf(replay, "database")["effect"], "intensity"), 0.5, 1e-9);
        EXPECT_NEAR(relative(causeOf(replay, "sensor.response")["effect"], "intensity"), 0.75,
                    1e-9);
    }
    const Ran none = in({"replay", "polar.csv", "--previous", "sphere.smat"});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_THAT(none.err, HasSubstr("the content of one of the files that have changed since: "
                                    "sphere.sigdb"));
}

TEST_F(SmatBatchReplay, IsToldWhereTheProjectLies) {
    makePolar();
    std::filesystem::create_directory(folder / "away");
    std::filesystem::copy(folder / "polar.csv", folder / "away/polar.csv");
    const auto replayed = [&](std::vector<std::string> options) {
        std::vector<std::string> arguments = {"replay", "polar.csv"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return smatBatch(arguments, folder / "away");
    };
    std::filesystem::create_directory(folder / "far");
    std::filesystem::rename(folder / "sphere.smat", folder / "far/sphere.smat");
    for (const char* name : {"sphere.flt", "sphere.sigdb", "response.csv"}) {
        std::filesystem::copy(folder / name, folder / "far" / name);
    }
    EXPECT_EQ(replayed({}).exitCode, 2);
    const Ran told = replayed({"--project", "../far/sphere.smat"});
    EXPECT_EQ(told.exitCode, 0) << told.out << told.err;
    // One of another name is not the result's.
    std::filesystem::copy(folder / "far/sphere.smat", folder / "far/other.smat");
    const Ran other = replayed({"--project", "../far/other.smat"});
    EXPECT_EQ(other.exitCode, 2);
    EXPECT_THAT(other.err, HasSubstr("sphere.smat"));
}

TEST_F(SmatBatchReplay, OfAnImageComparesItsPixels) {
    ASSERT_EQ(in({"image", "sphere.smat", "--width", "40", "--height", "32", "--sun", "off",
                  "--out", "a picture.exr"})
                  .exitCode,
              0);
    EXPECT_EQ(in({"replay", "a picture.exr"}).exitCode, 0);
    setEmissivity("0.45");
    const Ran ran = in({"replay", "a picture.exr", "--json"});
    EXPECT_EQ(ran.exitCode, 1);
    const Json replay = Json::parse(ran.out);
    EXPECT_NEAR(relative(replay["causes"][0]["effect"], "L"), 0.5, 1e-6);
    EXPECT_THAT(replay["causes"][0]["effect"][0]["at"].get<std::string>(), HasSubstr("pixel "));
    // What a line of a shell needs quotes for has them in the result.
    const Ran table =
        in({"image", "sphere.smat", "--width", "8", "--height", "8", "--out", "a table.json"});
    ASSERT_EQ(table.exitCode, 0) << table.err;
    EXPECT_THAT(contentOf(folder / "a table.json"), HasSubstr("--out 'a table.json'"));
}

TEST_F(SmatBatchReplay, OfAPlacedModelTellsThatItStandsElsewhere) {
    ASSERT_EQ(in({"project", "add", "sphere.smat", "sphere.flt", "--name", "other", "--east", "10"})
                  .exitCode,
              0);
    makePolar();
    EXPECT_EQ(in({"replay", "polar.csv"}).exitCode, 0);
    ASSERT_EQ(in({"project", "set", "sphere.smat", "other", "--east", "12"}).exitCode, 0);
    const Ran ran = in({"replay", "polar.csv"});
    EXPECT_THAT(ran.out, HasSubstr("changed   place of model 2: east 10 m"));
}

TEST_F(SmatBatchReplay, RefusesWhatItCannotRunAgain) {
    makePolar();
    write(folder / "foreign.csv", "angle [deg],contrast_intensity [W sr-1]\n0,1\n90,2\n");
    const Ran foreign = in({"replay", "foreign.csv"});
    EXPECT_EQ(foreign.exitCode, 2);
    EXPECT_THAT(foreign.err, HasSubstr("does not say how it was computed"));
    const Ran tool =
        in({"radiative", "none", "--quantity", "all", "--range", "1000", "--sensor-altitude", "100",
            "--los-elevation", "0", "--band", "3-5", "--out", "r.csv"});
    ASSERT_EQ(tool.exitCode, 0) << tool.err;
    EXPECT_THAT(in({"replay", "r.csv"}).err, HasSubstr("found radiative"));
    // A table of Monte Carlo names the analysis that was repeated: a run of that is another.
    std::string realisations = contentOf(folder / "polar.csv");
    const std::string analysis = "# analysis: polar\n";
    ASSERT_NE(realisations.find(analysis), std::string::npos);
    write(folder / "draws.csv",
          realisations.insert(realisations.find(analysis) + analysis.size(),
                              "# monte carlo: 64 draws of the sobol sequence, "
                              "seed 1\n"));
    const Ran ofDraws = in({"replay", "draws.csv"});
    EXPECT_EQ(ofDraws.exitCode, 2);
    EXPECT_THAT(ofDraws.err, HasSubstr("draws.csv: monte carlo: found 64 draws"));
    EXPECT_EQ(in({"replay", "gone.csv"}).exitCode, 2);
    std::filesystem::rename(folder / "sphere.smat", folder / "moved.smat");
    EXPECT_THAT(in({"replay", "polar.csv"}).err, HasSubstr("neither open nor beside"));
    // A project of another name is not taken for it, and is named.
    EXPECT_THAT(in({"replay", "polar.csv", "--project", "moved.smat"}).err,
                HasSubstr("sphere.smat, which is neither open (open: moved.smat) nor beside"));
}

} // namespace
} // namespace smat::test

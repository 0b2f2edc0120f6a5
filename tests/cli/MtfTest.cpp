#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/core/FileReading.h"
#include "irsg/image/ImageFile.h"
#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/scattering/DamagedMtfFiles.h"
#include "tests/support/Sanitized.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::filesystem::path shipped =
    std::filesystem::path(SMAT_SOURCE_DIR) / "resources/scattering";

class SmatBatchMtf : public testing::Test {
  protected:
    TemporaryFolder folder;
};

TEST_F(SmatBatchMtf, InfoShowsTheHeaderOfEveryShippedDatabase) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(shipped)) {
        if (entry.path().extension() != ".mtf") {
            continue;
        }
        ++files;
        const Ran ran = smatBatch({"mtf", "info", entry.path()});
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_THAT(ran.out, HasSubstr("field of view: 60 deg"));
        EXPECT_THAT(ran.out, HasSubstr("optical depths: 8 from 0.25 to 8"));
        EXPECT_EQ(ran.out.find("note:"), std::string::npos) << ran.out;
    }
    EXPECT_GE(files, 10);
}

TEST_F(SmatBatchMtf, AnImageWithHazeHasEqualBytesFromEveryEmptyCache) {
    std::set<std::string> bytes;
    for (int i = 0; i < 8; ++i) {
        setenv("SMAT_CACHE", (folder / ("cache" + std::to_string(i))).c_str(), 1);
        const Ran ran =
            smatBatch({"image", std::string(SMAT_SOURCE_DIR) + "/samples/box/box.smat", "--engine",
                       "rays", "--width", "48", "--height", "40", "--antialiasing", "1",
                       "--scattering", "true", "--scattering-coefficient", "0.5", "--mtf",
                       shipped / "droplets-100um-mwir.mtf", "--out", "a.csv"},
                      folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        bytes.insert(irsg::readFile(folder / "a.csv"));
    }
    setenv("SMAT_CACHE", "", 1); // as tests have it
    EXPECT_EQ(bytes.size(), 1U);
    EXPECT_NE(*bytes.begin(), "");
}

TEST_F(SmatBatchMtf, InfoReadsADatabaseOfBefore) {
    const std::string file = std::filesystem::path(SMAT_SOURCE_DIR) / "tests/kept/haze.mtf";
    const Ran ran = smatBatch({"--json", "mtf", "info", file});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto curves = nlohmann::json::parse(ran.out)["curves"];
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_NEAR(curves[0]["mtf_zero"].get<double>(), 1.62031, 1e-5);
    EXPECT_NEAR(curves[1]["mtf_zero"].get<double>(), 6.89273, 1e-5);
}

TEST_F(SmatBatchMtf, InfoGivesProgramsNumbersWithTheirUnits) {
    const std::string file = shipped / "droplets-100um-mwir.mtf";
    const auto json = nlohmann::json::parse(smatBatch({"--json", "mtf", "info", file}).out);
    EXPECT_EQ(json["file"], file);
    std::map<std::string, nlohmann::json> fields;
    for (const auto& field : json["fields"]) {
        fields[field["name"]] = field;
    }
    EXPECT_NEAR(fields.at("field of view")["value"].get<double>(), 60.0, 1e-9);
    EXPECT_EQ(fields.at("field of view")["unit"], "deg");
    EXPECT_NEAR(fields.at("particle diameter")["value"].get<double>(), 100.0, 1e-9);
    EXPECT_NEAR(fields.at("wavelength")["value"].get<double>(), 4.0, 1e-9);
    EXPECT_EQ(fields.at("optical depths")["value"], json["curves"].size());
    EXPECT_EQ(json["curves"][7]["optical_depth"], 8.0);
    EXPECT_GT(json["curves"][7]["mtf_zero"], 2000.0);
    EXPECT_TRUE(json["notes"].empty());
}

TEST_F(SmatBatchMtf, InfoRefusesDamagedFilesByNameAndByte) {
    const auto damaged = irsg::damagedMtfFiles();
    ASSERT_GE(damaged.size(), 30u);
    for (std::size_t i = 0; i < damaged.size(); ++i) {
        SCOPED_TRACE(damaged[i].name);
        const std::filesystem::path file = folder / ("damaged-" + std::to_string(i) + ".mtf");
        write(file, damaged[i].bytes);
        const Ran ran = smatBatch({"mtf", "info", file});
        EXPECT_EQ(ran.exitCode, 2);
        EXPECT_THAT(ran.err, StartsWith("error: " + file.string()));
        EXPECT_THAT(ran.err, HasSubstr(damaged[i].position));
        EXPECT_THAT(ran.err, HasSubstr("expected"));
    }
    EXPECT_EQ(smatBatch({"mtf", "info", folder / "none.mtf"}).exitCode, 2);
    EXPECT_EQ(smatBatch({"mtf", "info", folder.path()}).exitCode, 2);
}

TEST_F(SmatBatchMtf, BuildMakesWhatInfoReads) {
    const Ran built = smatBatch({"mtf", "build", "--out", "a.mtf", "--diameter", "10",
                                 "--wavelength", "10", "--optical-depths", "0.5,2", "--layers",
                                 "1:0,2:3", "--frequencies", "41", "--table", "a.csv"},
                                folder.path());
    EXPECT_EQ(built.exitCode, 0) << built.err;
    EXPECT_THAT(built.out, HasSubstr("particle diameter: 10 um"));
    EXPECT_EQ(smatBatch({"mtf", "info", "a.mtf"}, folder.path()).exitCode, 0);
    const ResultTable table = ResultTable::load(folder / "a.csv");
    EXPECT_EQ(table.rowCount(), 41u);
    EXPECT_NE(table.find("mtf_0.5"), nullptr);
}

TEST_F(SmatBatchMtf, BuildTakesTheAerosolOfTheAir) {
    const auto built = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"--json", "mtf", "build", "--out", "a.mtf", "--aerosol",
                                     "rural", "--wavelength", "3.75"});
        const Ran ran = smatBatch(words, folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return nlohmann::json::parse(ran.out);
    };
    // Of Shettle and Fenn's rural aerosol at 80 %: extinction 0.11506, absorption 0.00886.
    const auto usual = built({});
    EXPECT_NEAR(usual["albedo"].get<double>(), 1.0 - 0.00886 / 0.11506, 1e-6);
    EXPECT_NEAR(usual["asymmetry"].get<double>(), 0.7336, 1e-5);
    const auto dry = built({"--humidity", "0"});
    EXPECT_NEAR(dry["albedo"].get<double>(), 1.0 - 0.00867 / 0.09956, 1e-6);
    EXPECT_EQ(smatBatch({"mtf", "info", "a.mtf"}, folder.path()).exitCode, 0);
}

TEST_F(SmatBatchMtf, BuildIsInterruptedAndResumedToTheSameFile) {
    const std::vector<std::string> words{
        "mtf",          "build", "--method",         "monte-carlo", "--diameter",    "10",
        "--wavelength", "10",    "--optical-depths", "0.5,2",       "--frequencies", "31",
        "--photons",    "400000"};
    auto whole = words, cut = words;
    whole.insert(whole.end(), {"--out", "whole.mtf", "--table", "whole.csv"});
    cut.insert(cut.end(), {"--out", "cut.mtf"});
    EXPECT_EQ(smatBatch(whole, folder.path()).exitCode, 0);
    const ResultTable table = ResultTable::load(folder / "whole.csv");
    EXPECT_NE(table.find("error_mtf_2"), nullptr);

    // What somebody else keeps there stays his.
    write(folder / "cut.mtf.part", "a letter\n");
    EXPECT_EQ(smatBatch(cut, folder.path()).exitCode, 2);
    EXPECT_EQ(contentOf(folder / "cut.mtf.part"), "a letter\n");

    // Ctrl-C while photons are traced, over what another recipe left.
    write(folder / "cut.mtf.part", "smat mtf batches 1; of another recipe\n");
    auto told = cut;
    told.insert(told.begin(), "--verbose");
    const Ran stopped = smatBatch(told, folder.path(), "tracing photons");
    ASSERT_EQ(stopped.exitCode, 1) << stopped.err;
    EXPECT_THAT(stopped.err, HasSubstr("goes on from"));
    EXPECT_FALSE(std::filesystem::exists(folder / "cut.mtf"));
    const std::string kept = contentOf(folder / "cut.mtf.part");
    EXPECT_THAT(kept, StartsWith("smat mtf batches 1; "));
    EXPECT_EQ(kept.find("another recipe"), std::string::npos);
    EXPECT_GE(std::ranges::count(kept, '\n'), 2) << "a batch that is finished";

    EXPECT_EQ(smatBatch(cut, folder.path()).exitCode, 0);
    EXPECT_EQ(contentOf(folder / "cut.mtf"), contentOf(folder / "whole.mtf"));
    EXPECT_FALSE(std::filesystem::exists(folder / "cut.mtf.part"));
}

TEST_F(SmatBatchMtf, BuildRefusesWhatCannotBe) {
    const std::vector<std::vector<std::string>> wrong{
        {"--out", "a.txt"},
        {},
        {"--out", "a.mtf", "--wavelength", "20"},
        {"--out", "a.mtf", "--diameter", "-1"},
        {"--out", "a.mtf", "--droplets", "snow"},
        {"--out", "a.mtf", "--droplets", "advection-fog", "--diameter", "3"},
        {"--out", "a.mtf", "--optical-depths", "2,1"},
        {"--out", "a.mtf", "--optical-depths", "2,x"},
        {"--out", "a.mtf", "--layers", "1"},
        {"--out", "a.mtf", "--layers", "1:0"},
        {"--out", "a.mtf", "--photons", "0.5"},
        {"--out", "a.mtf", "--method", "magic"},
        {"--out", "a.mtf", "--fov", "200"},
        {"--out", "a.mtf", "--aerosol", "smoke"},
        {"--out", "a.mtf", "--aerosol", "rural", "--humidity", "120"},
        {"--out", "a.mtf", "--aerosol", "rural", "--diameter", "3"},
        {"--out", "a.mtf", "--aerosol", "rural", "--droplets", "single"},
        {"--out", "a.mtf", "--humidity", "50"},
        {"--out", "nowhere/a.mtf", "--diameter", "1"}};
    for (std::vector<std::string> words : wrong) {
        words.insert(words.begin(), {"mtf", "build"});
        const Ran ran = smatBatch(words, folder.path());
        EXPECT_EQ(ran.exitCode, 2) << words.back();
        EXPECT_THAT(ran.err, HasSubstr("expected"));
    }
}

TEST_F(SmatBatchMtf, AnImageHasTheHazeThatIsAskedFor) {
    const std::string project = sample("chessboard/chessboard.smat");
    const std::vector<std::string> words{"image",    project, "--width", "64",
                                         "--height", "48",    "--out",   "clear.exr"};
    EXPECT_EQ(smatBatch(words, folder.path()).exitCode, 0);
    auto hazy = words;
    hazy.back() = "hazy.exr";
    hazy.insert(hazy.end(), {"--scattering", "--mtf", shipped / "advection-fog-mwir.mtf",
                             "--scattering-coefficient", "20"});
    const Ran ran = smatBatch(hazy, folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(contentOf(folder / "clear.exr"), contentOf(folder / "hazy.exr"));
    const irsg::RadianceImage image = irsg::readImageFile(folder / "hazy.exr");
    EXPECT_NEAR(std::stod(image.attributes.at("scattering.chessboard.optical_depth")), 1.2, 0.01);

    // Without a database scattering is refused, not left out.
    auto without = words;
    without.insert(without.end(), {"--scattering"});
    const Ran refused = smatBatch(without, folder.path());
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("an AtmosphereScatteringLUT or an MTF database"));
}

TEST_F(SmatBatchMtf, ColdCachesGiveEqualBytes) {
    const char* const before = std::getenv("XDG_CACHE_HOME");
    const std::string kept = before ? before : "";
    std::string first;
    // A size whose measured plans differ from run to run on most machines.
    for (const char* cache : {"one", "two", "three", "four"}) {
        std::filesystem::create_directories(folder / cache);
        setenv("XDG_CACHE_HOME", (folder.path() / cache).c_str(), 1);
        const Ran ran =
            smatBatch({"image", sample("chessboard/chessboard.smat"), "--width", "320", "--height",
                       "256", "--out", "hazy.csv", "--scattering", "--mtf",
                       shipped / "advection-fog-mwir.mtf", "--scattering-coefficient", "20"},
                      folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        const std::string bytes = contentOf(folder / "hazy.csv");
        EXPECT_FALSE(std::filesystem::exists(folder / (std::string(cache) + "/smat/fftw-wisdom")));
        if (first.empty()) {
            first = bytes;
        }
        EXPECT_EQ(bytes, first) << cache;
    }
    before ? setenv("XDG_CACHE_HOME", kept.c_str(), 1) : unsetenv("XDG_CACHE_HOME");
}

} // namespace
} // namespace smat::test

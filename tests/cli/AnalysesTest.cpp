#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <ostream>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFile.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

const std::string sphere = sample("sphere/sphere.smat");

TEST(SmatBatchRun, WritesEveryAnalysisOfTheProject) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch(
        {"run", sphere, "--out", folder / "out", "--width", "64", "--height", "64", "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_GE(json["analyses"].size(), 4u);
    for (const auto& analysis : json["analyses"]) {
        EXPECT_EQ(analysis["state"], "complete");
        EXPECT_FALSE(analysis["files"].empty());
        for (const auto& file : analysis["files"]) {
            EXPECT_GT(std::filesystem::file_size(file.get<std::string>()), 100u) << file;
        }
    }
    for (const char* name : {"mwir-image.exr", "mwir-image.csv", "mwir-image.png", "range.csv",
                             "range.json", "spectrum.csv"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / "out" / name)) << name;
    }
}

/// While it lives EGL finds no driver, as on a machine without any.
class WithoutOpenGl {
  public:
    WithoutOpenGl() { setenv(name, "/dev/null", 1); }
    ~WithoutOpenGl() { unsetenv(name); }

  private:
    static constexpr const char* name = "__EGL_VENDOR_LIBRARY_FILENAMES";
};

TEST(SmatBatchRun, NeedsNoOpenGlWithRays) {
    if (!irsg::areRaysBuilt()) {
        GTEST_SKIP() << irsg::whyNoRays();
    }
    const TemporaryFolder folder;
    const WithoutOpenGl without;
    const Ran refused = smatBatch({"image", sphere, "--out", folder / "a.exr"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("OpenGL"));
    const Ran ran = smatBatch({"run", sphere, "--engine", "rays", "--out", folder / "out",
                               "--width", "64", "--height", "64", "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const nlohmann::json said = nlohmann::json::parse(ran.out);
    ASSERT_FALSE(said.at("analyses").empty());
    for (const auto& analysis : said["analyses"]) {
        EXPECT_EQ(analysis["state"], "complete");
        EXPECT_THAT(analysis["renderer"].get<std::string>(), HasSubstr("Embree"));
    }
    const Ran chosen = smatBatch({"image", sphere, "--engine", "auto", "--out", folder / "b.exr"});
    ASSERT_EQ(chosen.exitCode, 0) << chosen.err;
    EXPECT_THAT(irsg::readExr(folder / "b.exr").attributes.at("renderer"),
                HasSubstr("auto: this machine has no OpenGL"));
}

TEST(SmatBatchRun, GivesTheSameBytesTwice) {
    const TemporaryFolder folder;
    for (const char* name : {"a", "b"}) {
        std::filesystem::create_directories(folder / name);
        const Ran ran = smatBatch(
            {"run", sphere, "--analysis", "mwir-image", "--analysis", "range", "--out", "out"},
            folder / name);
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
    }
    for (const char* name :
         {"mwir-image.exr", "mwir-image.csv", "mwir-image.png", "range.csv", "range.json"}) {
        EXPECT_EQ(contentOf(folder / "a" / "out" / name), contentOf(folder / "b" / "out" / name))
            << name;
    }
}

TEST(SmatBatchImage, TheCentreOfTheSphereIsItsClosedForm) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"image", sphere, "--sun", "off", "--out", folder / "a.exr"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const irsg::RadianceImage image = irsg::readExr(folder / "a.exr");
    const double expected = 0.9 * irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(3, 5), 320.0);
    EXPECT_NEAR(image.at(image.width() / 2, image.height() / 2), expected, 1e-5 * expected);
    EXPECT_EQ(image.attributes.at("render.sun"), "off");
}

TEST(SmatBatchImage, TakesABareModelWithItsDatabase) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"image", sample("sphere/sphere.flt"), "--database",
                               sample("sphere/sphere.sigdb"), "--range", "100", "--out",
                               folder / "a.csv", "--out", folder / "a.png"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "a.csv"));
    EXPECT_TRUE(std::filesystem::exists(folder / "a.png"));
}

TEST(SmatBatchPolar, HasTheColumnsOfTheFormatsPage) {
    const TemporaryFolder folder;
    const Ran ran =
        smatBatch({"polar", sphere, "--sun", "off", "--step", "90", "--out", folder / "p.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "p.csv");
    std::vector<std::string> headers;
    for (const ResultColumn& column : table.columns()) {
        headers.push_back(column.header());
    }
    EXPECT_THAT(headers, testing::ElementsAre(
                             "angle [deg]", "azimuth [deg]", "elevation [deg]", "yaw [deg]",
                             "intensity [W sr-1]", "contrast_intensity [W sr-1]",
                             "irradiance [W m-2]", "pixels", "error_intensity [W sr-1]",
                             "error_contrast_intensity [W sr-1]", "error_irradiance [W m-2]"));
    EXPECT_THAT(ran.out, testing::ContainsRegex("Highest contrast intensity.* ± .* W sr-1"));
    const double expected =
        irsg::pi * 0.9 * irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(3, 5), 320.0);
    for (const double intensity : table.find("intensity")->values) {
        EXPECT_NEAR(intensity, expected, 2e-3 * expected);
    }
}

struct SidesRow {
    const char* type;
    std::vector<double> temperatures_K; ///< of the sides seen at 0, 90, 180 and 270 deg
    std::vector<double> areas_m2;
};

void PrintTo(const SidesRow& row, std::ostream* out) {
    *out << row.type;
}

class SmatBatchBox : public testing::TestWithParam<SidesRow> {};

TEST_P(SmatBatchBox, ShowsItsSixSidesInTheOrderOfTheMode) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"polar", sample("box/box.smat"), "--type", GetParam().type, "--step",
                               "90", "--elevation", "0", "--out", folder / "p.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto intensity = ResultTable::load(folder / "p.csv").find("intensity")->values;
    ASSERT_EQ(intensity.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        // The near side fills a little more than parallel light would: (1000 / 998)^2 at most.
        const double expected =
            GetParam().areas_m2[i] *
            irsg::bandRadiance_W_m2_sr(irsg::Band::topHat(3, 5), GetParam().temperatures_K[i]);
        EXPECT_NEAR(intensity[i], expected, 0.01 * expected) << 90 * i << " deg";
    }
}

INSTANTIATE_TEST_SUITE_P(
    Types, SmatBatchBox,
    testing::Values(SidesRow{"camera-azimuth", {300, 340, 320, 360}, {2, 4, 2, 4}},
                    SidesRow{"camera-elevation", {300, 400, 320, 380}, {2, 8, 2, 8}},
                    SidesRow{"model-yaw", {300, 340, 320, 360}, {2, 4, 2, 4}}),
    [](const auto& row) {
        std::string name = row.param.type;
        name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
        return name;
    });

TEST(SmatBatchRange, TheIrradianceOfTheSphereFollowsTheInverseSquareLaw) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"range", sphere, "--sun", "off", "--from", "100", "--to", "400",
                               "--points", "4", "--out", folder / "r.json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "r.json");
    const auto& range = table.find("range")->values;
    const auto& irradiance = table.find("irradiance")->values;
    ASSERT_EQ(range.size(), 4u);
    for (std::size_t i = 0; i < range.size(); ++i) {
        const double ratio = irradiance[i] * range[i] * range[i] / (irradiance[0] * 1e4);
        EXPECT_NEAR(ratio, 1.0, 3e-3) << range[i];
    }
}

TEST(SmatBatchRange, ANamedAnalysisGivesTheSameNumbersFromRunAndFromItsOwnCommand) {
    const TemporaryFolder folder;
    ASSERT_EQ(smatBatch({"run", sphere, "--analysis", "range", "--out", folder / "out"}).exitCode,
              0);
    ASSERT_EQ(
        smatBatch({"range", sphere, "--analysis", "range", "--out", folder / "r.csv"}).exitCode, 0);
    EXPECT_EQ(ResultTable::load(folder / "out" / "range.csv").columns(),
              ResultTable::load(folder / "r.csv").columns());
}

/// The values of that key in the provenance.
std::vector<std::string> told(const Provenance& provenance, const std::string& of) {
    std::vector<std::string> values;
    for (const auto& [key, value] : provenance.entries) {
        if (key == of) {
            values.push_back(value);
        }
    }
    return values;
}

std::string imagingSensor(const std::string& parameters) {
    return "<data><fileType>Parameters</fileType><type>/ImagingSensor/Root/Sensor/ImagingSensor"
           "</type>\n" +
           parameters + "</data>\n";
}
std::string parameter(const std::string& name, const std::string& value) {
    return "<parameter name=\"" + name + "\"><double>" + value + "</double></parameter>\n";
}

TEST(SmatBatchImagingSensor, IsReadByImageAndSweepsBelowOtherOptions) {
    const TemporaryFolder folder;
    write(folder / "i.xml",
          imagingSensor(parameter("AntialiasingMode", "1") +
                        parameter("TerrainTextureColorOffset", "0.25") +
                        parameter("NumberOfBackgroundRows", "5") + parameter("Gain", "3")));
    const auto run = [&](std::vector<std::string> words) {
        const Ran ran = smatBatch(words, folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ran;
    };
    const Ran image = run({"image", sphere, "--imaging-sensor", "i.xml", "--out", "a.exr"});
    EXPECT_THAT(image.err, HasSubstr("i.xml: line 5: Gain is no parameter of ImagingSensor"));
    const irsg::RadianceImage read = irsg::readExr(folder / "a.exr");
    EXPECT_EQ(read.attributes.at("render.antialiasing"), "1");
    EXPECT_EQ(read.attributes.at("render.backgroundRows"), "5");
    EXPECT_EQ(read.attributes.at("environment.terrainOffset"), "0.25");
    run({"image", sphere, "--antialiasing", "1", "--set", "render.backgroundRows=5", "--out",
         "b.exr"});
    EXPECT_EQ(irsg::readExr(folder / "b.exr").primary().values, read.primary().values);
    run({"polar", sphere, "--step", "180", "--imaging-sensor", "i.xml", "--antialiasing", "2",
         "--out", "a.csv"});
    const Provenance polar = ResultTable::load(folder / "a.csv").provenance;
    EXPECT_EQ(polar.value("render.antialiasing"), "2") << "the option goes over the file";
    EXPECT_EQ(polar.value("environment.terrainOffset"), "0.25");
    for (const char* command :
         {"spectrum", "range", "time", "condition", "run", "montecarlo", "explain", "simulate"}) {
        EXPECT_THAT(smatBatch({command, "--help"}).out, HasSubstr("--imaging-sensor")) << command;
    }
}

TEST(SmatBatchImagingSensor, OfAProjectIsWrittenAndReadBackAsItWas) {
    const TemporaryFolder folder;
    write(folder / "p.smat", R"({"version": 1, "models": [{"file": "x.flt"}],
  "environment": {"skyboxSlope": 12}, "render": {"antialiasing": 5, "backgroundColumns": 3,
  "backgroundRows": 7}})");
    const Ran wrote =
        smatBatch({"settings", "--project", "p.smat", "--imaging-sensor", "o.xml"}, folder.path());
    ASSERT_EQ(wrote.exitCode, 0) << wrote.err;
    const Ran ran =
        smatBatch({"polar", sphere, "--step", "180", "--imaging-sensor", "o.xml", "--out", "a.csv"},
                  folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const Provenance polar = ResultTable::load(folder / "a.csv").provenance;
    EXPECT_EQ(polar.value("render.antialiasing"), "5");
    EXPECT_EQ(polar.value("render.backgroundColumns"), "3");
    EXPECT_EQ(polar.value("render.backgroundRows"), "7");
    EXPECT_EQ(polar.value("environment.skyboxSlope"), "12 W m-2 sr-1");
    EXPECT_NE(smatBatch({"settings", "--imaging-sensor", "o.xml"}, folder.path()).exitCode, 0);
}

TEST(SmatBatchImagingSensor, ThatIsWrongIsRefusedByItsPlace) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& parameters) {
        write(folder / "i.xml", imagingSensor(parameters));
        const Ran ran = smatBatch({"image", sphere, "--imaging-sensor", "i.xml", "--out", "a.exr"},
                                  folder.path());
        EXPECT_EQ(ran.exitCode, 2);
        return ran.err;
    };
    EXPECT_THAT(refusal(parameter("AntialiasingMode", "6")),
                testing::AllOf(HasSubstr("i.xml"), HasSubstr("line 2"), HasSubstr("0 to 5")));
    EXPECT_THAT(refusal(parameter("UseSkyboxBackground", "1")),
                HasSubstr("UseSkyboxBackground: found 1, expected 0, or files in the setting "
                          "environment.skybox of the project or an option"));
    EXPECT_THAT(smatBatch({"image", sphere, "--imaging-sensor", "none.xml", "--out", "a.exr"},
                          folder.path())
                    .err,
                HasSubstr("none.xml"));
}

TEST(SmatBatchScalings, EveryResultSaysWhatWasDrawnWithWhichSeed) {
    const TemporaryFolder folder;
    const std::string project =
        (std::filesystem::path(SMAT_SOURCE_DIR) / "tests/kept/kept.smat").string();
    const auto run = [&](std::vector<std::string> words) {
        const Ran ran = smatBatch(words);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
    };
    run({"polar", project, "--step", "180", "--band", "3-5", "--scalings", "--out",
         folder / "a.csv", "--out", folder / "a.json"});
    const ResultTable csv = ResultTable::load(folder / "a.csv");
    const std::vector<std::string> drawn = told(csv.provenance, "drawn scale");
    ASSERT_EQ(drawn.size(), 2u);
    EXPECT_THAT(drawn[0], testing::MatchesRegex("temperature 1.*: 0\\.9.*, uniform, 0.98 to 1.02|"
                                                "temperature 1.*: 1\\.0.*, uniform, 0.98 to 1.02"));
    EXPECT_THAT(drawn[1], testing::HasSubstr("emissivity 1"));
    EXPECT_EQ(told(csv.provenance, "scaling.seed"), std::vector<std::string>{"1"});
    EXPECT_EQ(told(ResultTable::load(folder / "a.json").provenance, "drawn scale"), drawn);
    run({"image", project, "--band", "3-5", "--scalings", "--seed", "1", "--out",
         folder / "a.exr"});
    EXPECT_EQ(irsg::readImageFile(folder / "a.exr").attributes.at("drawn scale"),
              drawn[0] + "; " + drawn[1]);
    run({"polar", project, "--step", "180", "--band", "3-5", "--out", folder / "b.csv"});
    EXPECT_TRUE(told(ResultTable::load(folder / "b.csv").provenance, "drawn scale").empty());
    EXPECT_TRUE(told(ResultTable::load(folder / "b.csv").provenance, "scaling.seed").empty());
}

TEST(SmatBatchDryRun, SaysWhatWouldBeDrawnAndDrawsNothing) {
    const Ran ran = smatBatch({"polar", sphere, "--step", "10", "--dry-run"});
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_THAT(ran.out, HasSubstr("polar: 36 cases, angle 0 to 350 deg"));
}

/// Seconds of each line of --timing, by its first words.
std::map<std::string, double> stages(const std::string& text) {
    std::map<std::string, double> found;
    std::istringstream lines(text.substr(std::min(text.find("stage "), text.size())));
    std::string line;
    std::getline(lines, line); // the names of the columns
    const std::regex row(R"((\S.*?) +(?:\d+ +)?(\d+\.\d+) +\d+\.\d+)");
    for (std::smatch words; std::getline(lines, line);) {
        if (std::regex_match(line, words, row)) {
            found[words[1]] = std::stod(words[2]);
        }
    }
    return found;
}

TEST(SmatBatchTiming, StagesAddUpToTheSumThatIsPrintedWhichIsTheTimeItTook) {
    const TemporaryFolder folder;
    const auto start = std::chrono::steady_clock::now();
    const Ran ran = smatBatch({"image", sphere, "--out", folder / "a.exr", "--timing"});
    const double took_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(ran.exitCode, 0);
    std::map<std::string, double> seconds = stages(ran.err);
    for (const char* stage : {"start program", "load", "analyse", "save", "end program", "other"}) {
        EXPECT_EQ(seconds.count(stage), 1u) << stage << " in\n" << ran.err;
    }
    ASSERT_EQ(seconds.count("sum"), 1u) << ran.err;
    const double printed_s = seconds.at("sum");
    seconds.erase("sum");
    double sum_s = 0.0;
    for (const auto& [stage, time_s] : seconds) {
        EXPECT_GE(time_s, 0.0) << stage;
        sum_s += time_s;
    }
    EXPECT_NEAR(sum_s, printed_s, 1e-4 * static_cast<double>(seconds.size())) << "rounded";
    EXPECT_GT(printed_s, 0.0);
    // No stage is counted in another one, too. What the program takes beside is no matter here.
    EXPECT_LE(sum_s, 1.02 * took_s + 0.05);
}

TEST(SmatBatchStop, AnInterruptOrATerminationKeepsWhatWasDoneAndSaysSo) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TemporaryFolder folder;
        const Ran ran = smatBatch({"time", sphere, "--from", "0", "--to", "100000", "--step", "0.2",
                                   "--verbose", "--out", folder / "t.csv"},
                                  ".", "cases", signal);
        EXPECT_EQ(ran.exitCode, 1) << ran.err;
        EXPECT_THAT(ran.err, HasSubstr("stopped"));
        if (std::filesystem::exists(folder / "t.csv")) {
            const ResultTable table = ResultTable::load(folder / "t.csv");
            EXPECT_EQ(table.provenance.value("state"), "partial");
            EXPECT_LT(table.rowCount(), 500001u);
        }
    }
}

struct EmptyViewRow {
    const char* name;
    std::vector<std::string> options;
};

void PrintTo(const EmptyViewRow& row, std::ostream* out) {
    *out << row.name;
}

class SmatBatchEmptyView : public testing::TestWithParam<EmptyViewRow> {};

TEST_P(SmatBatchEmptyView, IsDoneWithANoteThatNothingWasHit) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = {"image", sphere, "--out", folder / "a.exr"};
    arguments.insert(arguments.end(), GetParam().options.begin(), GetParam().options.end());
    const Ran ran = smatBatch(arguments);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("no sample hits the target"));
}

INSTANTIATE_TEST_SUITE_P(Views, SmatBatchEmptyView,
                         testing::Values(EmptyViewRow{"CameraAtTheReferencePoint",
                                                      {"--range", "0"}},
                                         EmptyViewRow{"CameraInsideTheTarget", {"--range", "0.5"}},
                                         EmptyViewRow{"TargetFarBelowASampleOfMode2",
                                                      {"--range", "1e7", "--antialiasing", "2"}}),
                         [](const auto& row) { return row.param.name; });

TEST(SmatBatchProject, WarnsOfKeysItDoesNotKnow) {
    const TemporaryFolder folder;
    write(folder / "p.smat", R"({"version": 1, "sensor": {"widht": 7},
        "models": [{"file": ")" + sample("sphere/sphere.flt").string() +
                                 R"(", "database": ")" + sample("sphere/sphere.sigdb").string() +
                                 R"("}]})");
    const Ran ran = smatBatch({"image", folder / "p.smat", "--dry-run"});
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_THAT(ran.err, HasSubstr("warning: "));
    EXPECT_THAT(ran.err, HasSubstr("sensor.widht"));
}

} // namespace
} // namespace smat::test

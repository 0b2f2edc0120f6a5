#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

/// Two images of 8 x 4 that differ in one pixel, (5, 2): A has 3.5 where B has 3.
class CompareCommand : public testing::Test {
  protected:
    CompareCommand() {
        irsg::RadianceImage b(8, 4);
        for (float& value : b.primary().values) {
            value = 3.0F;
        }
        irsg::RadianceImage a = b;
        a.primary().values[a.offset(5, 2)] = 3.5F;
        irsg::writeExr(a, folder / "a.exr");
        irsg::writeExr(b, folder / "b.exr");
        irsg::writeCsvImage(a, folder / "a.csv");
        std::string matrix;
        for (int y = 0; y < 4; ++y) {
            matrix += "3 3 3 3 3 3 3 3\n";
        }
        write(folder / "karma.txt", matrix);
    }
    Ran compare(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "compare");
        return smatBatch(arguments, folder.path());
    }
    TemporaryFolder folder;
};

TEST_F(CompareCommand, FindsTheChangedPixelWithSignAndPlaceAndFails) {
    for (const auto& [first, second] :
         {std::pair("a.exr", "b.exr"), {"a.csv", "b.exr"}, {"a.exr", "karma.txt"}}) {
        const Ran ran = compare({first, second});
        EXPECT_EQ(ran.exitCode, 2);
        EXPECT_THAT(ran.out, HasSubstr("0.5 W m-2 sr-1, at (5, 2), A 3.5, B 3"));
        EXPECT_THAT(ran.out, HasSubstr("FAILURE"));
        if (second == std::string("karma.txt")) {
            EXPECT_THAT(ran.err, HasSubstr("karma.txt: columns separated by blanks"));
        } else {
            EXPECT_EQ(ran.err, "");
        }
    }
    EXPECT_THAT(compare({"b.exr", "a.exr"}).out, HasSubstr("-0.5 W m-2 sr-1, at (5, 2)"));
}

TEST_F(CompareCommand, TheQuantityThatIsShownIsComparedAndNoTwoQuantities) {
    irsg::RadianceImage warm(8, 4, "T_apparent", "K");
    warm.channel("L", "W m-2 sr-1");
    irsg::writeExr(warm, folder / "cold.exr");
    warm.primary().values[3] = 300.0F;
    irsg::writeExr(warm, folder / "warm.exr");
    const Ran ran = compare({"warm.exr", "cold.exr"});
    EXPECT_EQ(ran.exitCode, 2) << "their radiance alone is equal";
    EXPECT_THAT(ran.out, HasSubstr("temperature, channel T_apparent\n"));
    EXPECT_THAT(ran.out, HasSubstr("300 K, at (3, 0)"));
    EXPECT_EQ(compare({"warm.exr", "cold.exr", "--channel", "L"}).exitCode, 0);
    const Ran json = compare({"warm.exr", "cold.exr", "--json"});
    EXPECT_EQ(nlohmann::json::parse(json.out)["comparisons"][0]["quantity"], "temperature");
    const Ran mixed = compare({"warm.exr", "a.exr"});
    EXPECT_EQ(mixed.exitCode, 2);
    EXPECT_EQ(mixed.out, "");
    EXPECT_THAT(mixed.err, HasSubstr("a.exr: found radiance (channel L), expected temperature as "
                                     "in channel T_apparent of warm.exr"));
    EXPECT_THAT(compare({"warm.exr", "a.exr", "--channel", "L"}).out, HasSubstr("W m-2 sr-1"));
}

TEST_F(CompareCommand, ATableOfResultsIsRefusedInOneSentence) {
    std::string table = "range [m],contrast_intensity [W sr-1]\n";
    for (int i = 1; i < 100; ++i) {
        table += std::to_string(i) + ",2\n";
    }
    write(folder / "range.csv", table);
    const Ran ran = compare({"range.csv", "range.csv"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("range.csv: line 1: found a table of results (columns range "
                                   "[m],contrast_intensity [W sr-1]), expected an image"));
}

TEST_F(CompareCommand, TheExitCodeIsTheVerdict) {
    struct Row {
        std::vector<std::string> options;
        int exitCode;
    };
    const std::vector<Row> rows = {
        {{}, 2},
        {{"--fail", "0.4"}, 2},
        {{"--fail", "0.6"}, 1},
        {{"--fail", "0.6", "--warn", "0.6"}, 0},
        {{"--fail", "0.6", "--warn", "0.6", "--hard-warn", "0.4"}, 1},
        {{"--fail", "0.6", "--warn", "0.6", "--hard-fail", "0.4"}, 2},
        {{"--fail-relative", "0.1"}, 2},
        {{"--fail-relative", "0.2"}, 1},
        {{"--fail-relative", "0.2", "--warn-relative", "0.2"}, 0},
        {{"--fail-percent", "3"}, 2},
        {{"--fail-percent", "3.2", "--warn-percent", "3.2"}, 0},
        {{"--allow-failures", "1"}, 1},
        {{"--allow-failures", "1", "--allow-warnings", "1"}, 0},
        {{"--rectangle", "0,0,5,4"}, 0},
        {{"--rectangle", "5,2,1,1"}, 2},
        {{"--rectangle", "0,0,5,4", "--rectangle", "5,2,1,1"}, 2},
    };
    for (const Row& row : rows) {
        std::vector<std::string> arguments = {"a.exr", "b.exr"};
        arguments.insert(arguments.end(), row.options.begin(), row.options.end());
        const Ran ran = compare(arguments);
        EXPECT_EQ(ran.exitCode, row.exitCode) << testing::PrintToString(row.options) << ran.err;
        EXPECT_THAT(ran.out, HasSubstr(row.exitCode == 0   ? "PASS"
                                       : row.exitCode == 1 ? "WARNING"
                                                           : "FAILURE"));
    }
}

TEST_F(CompareCommand, GivesAllNumbersToMachines) {
    const Ran ran = compare({"a.exr", "b.exr", "--json"});
    EXPECT_EQ(ran.exitCode, 2);
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json["verdict"], "FAILURE");
    const auto& numbers = json["comparisons"][0];
    EXPECT_DOUBLE_EQ(numbers["mean_error"], 0.5 / 32.0);
    EXPECT_DOUBLE_EQ(numbers["rms_error"], std::sqrt(0.25 / 32.0));
    EXPECT_EQ(numbers["max_error_at"], (nlohmann::json{{"x", 5}, {"y", 2}, {"a", 3.5}, {"b", 3}}));
    EXPECT_EQ(numbers["fail_pixels"], 1);
    EXPECT_DOUBLE_EQ(numbers["fail_percent"], 3.125);
    EXPECT_DOUBLE_EQ(numbers["peak"], 3.5);
    EXPECT_DOUBLE_EQ(numbers["sum_difference"], 0.5);
    EXPECT_EQ(numbers["unit"], "W m-2 sr-1");
    EXPECT_EQ(
        nlohmann::json::parse(compare({"b.exr", "b.exr", "--json"}).out)["comparisons"][0]["psnr"],
        "inf");
}

TEST_F(CompareCommand, WritesTheDifferenceAsImageValuesAndPicture) {
    compare({"a.exr", "b.exr", "--out", "d.exr", "--out", "d.csv", "--out", "d.png"});
    const irsg::RadianceImage exr = irsg::readExr(folder / "d.exr");
    EXPECT_EQ(exr.primary().name, "difference");
    EXPECT_EQ(exr.at(5, 2), 0.5F);
    EXPECT_EQ(exr.at(2, 2), 0.0F);
    EXPECT_EQ(exr.attributes.at("compare.max_error"), "0.5 W m-2 sr-1");
    EXPECT_EQ(irsg::readCsvImage(folder / "d.csv").primary().values, exr.primary().values);
    EXPECT_TRUE(contentOf(folder / "d.png").starts_with("\x89PNG"));
}

TEST_F(CompareCommand, TakesTheChannelThatIsNamed) {
    irsg::RadianceImage a(2, 1), b(2, 1);
    a.channel("range_m", "m").values = {5.0F, 6.0F};
    b.channel("range_m", "m").values = {5.0F, 7.0F};
    irsg::writeExr(a, folder / "x.exr");
    irsg::writeExr(b, folder / "y.exr");
    EXPECT_EQ(compare({"x.exr", "y.exr"}).exitCode, 0);
    const Ran ran = compare({"x.exr", "y.exr", "--channel", "range_m"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.out, HasSubstr("-1 m, at (1, 0)"));
}

TEST_F(CompareCommand, NaNFailsWhateverIsAllowed) {
    write(folder / "nan.csv", "3,3\n3,nan\n");
    write(folder / "three.csv", "3,3\n3,3\n");
    const Ran ran = compare({"nan.csv", "three.csv", "--fail", "1e9", "--warn", "1e9",
                             "--allow-failures", "100", "--allow-warnings", "100"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.out, HasSubstr("1 px, the first at (1, 1)"));
}

TEST_F(CompareCommand, RefusesWhatCannotBeCompared) {
    write(folder / "small.csv", "1,2\n3,4\n");
    write(folder / "word.csv", "1,2\n3,hot\n");
    struct Row {
        std::vector<std::string> arguments;
        std::vector<std::string> words;
    };
    const std::vector<Row> rows = {
        {{"a.exr", "small.csv"}, {"small.csv", "2 x 2 pixels", "8 x 4 pixels", "a.exr"}},
        {{"a.exr", "word.csv"}, {"word.csv", "line 2", "hot"}},
        {{"a.exr", "gone.exr"}, {"gone.exr"}},
        {{"a.exr", "b.exr", "--channel", "T"}, {"a.exr", "'T'", "channels: L"}},
        {{"a.exr", "b.exr", "--fail", "much"}, {"--fail", "much", "finite number"}},
        {{"a.exr", "b.exr", "--fail=-1"}, {"fail threshold", "-1", "from 0"}},
        {{"a.exr", "b.exr", "--warn-percent", "100"}, {"warn percent", "less than 100"}},
        {{"a.exr", "b.exr", "--allow-failures", "1.5"}, {"--allow-failures", "whole number"}},
        {{"a.exr", "b.exr", "--rectangle", "1,2,3"}, {"--rectangle", "1,2,3", "x,y,width,height"}},
        {{"a.exr", "b.exr", "--rectangle", "7,0,2,1"}, {"2 x 1 at (7, 0)", "8 x 4"}},
        {{"a.exr", "b.exr", "--out", "d.jpeg"},
         {"--out", "d.jpeg", ".exr, .csv, .png, .tif or .tiff"}},
        {{"a.exr"}, {"B is required"}},
    };
    for (const Row& row : rows) {
        const Ran ran = compare(row.arguments);
        EXPECT_EQ(ran.exitCode, 2) << testing::PrintToString(row.arguments);
        for (const std::string& word : row.words) {
            EXPECT_THAT(ran.err, HasSubstr(word));
        }
        EXPECT_EQ(ran.out, "");
    }
}

TEST_F(CompareCommand, RenderedImagesKnowTheirContrastIntensity) {
    const std::string project = sample("turboprop4/turboprop4.smat");
    for (const char* mode : {"0", "4"}) {
        const Ran ran =
            smatBatch({"image", project, "--width", "96", "--height", "64", "--antialiasing", mode,
                       "--out", folder / (std::string("m") + mode + ".exr"), "--json"});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        write(folder / (std::string("m") + mode + ".json"), ran.out);
    }
    const Ran ran = compare({"m0.exr", "m4.exr", "--json"});
    const auto json = nlohmann::json::parse(ran.out)["comparisons"][0];
    ASSERT_TRUE(json.contains("contrast_intensity_a")) << ran.out;
    EXPECT_EQ(json["total_unit"], "W sr-1");
    // The renderer sums before it rounds to float, and counts what the frame cuts off.
    const std::string summary = contentOf(folder / "m4.json");
    const auto of4 = nlohmann::json::parse(summary);
    double rendered = 0.0;
    for (const auto& item : of4["analyses"][0]["summary"]) {
        if (item["label"].get<std::string>().find("ontrast intensity") != std::string::npos) {
            rendered = item["value"];
        }
    }
    EXPECT_NEAR(json["contrast_intensity_b"].get<double>(), rendered, 1e-3 * std::abs(rendered))
        << summary;
}

} // namespace
} // namespace smat::test

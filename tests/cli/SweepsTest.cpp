#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/image/ExrFile.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

const std::string sphere = sample("sphere/sphere.smat");

std::vector<double> column(const ResultTable& table, const std::string& key) {
    const ResultColumn* found = table.find(key);
    return found == nullptr ? std::vector<double>{} : found->values;
}

/// A project of two of the sample's spheres, the second 800 m nearer and 12 m aside.
std::string twoSpheres(const TemporaryFolder& folder) {
    const auto file = [](const char* name) {
        return sample(std::string("sphere/") + name).string();
    };
    const std::string model = R"({"file": ")" + file("sphere.flt") + R"(", "database": ")" +
                              file("sphere.sigdb") + R"(", "name": "ball")";
    write(folder / "two.smat", R"({"version": 1, "sensor": {"fov": 30},
        "render": {"sun": "off", "fluxes": "off", "background": "none"},
        "models": [)" + model + "}, " +
                                   model + R"(, "position_m": [12, 800, 1000]}]})");
    return folder / "two.smat";
}

TEST(SmatBatchBands, OneRunGivesWhatOneRunForEachBandGives) {
    const TemporaryFolder folder;
    const auto ranges = [&](const std::string& band, const std::string& name) {
        const Ran ran = smatBatch({"range", sphere, "--band", band, "--from", "500", "--to", "2000",
                                   "--points", "3", "--out", folder / name});
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / name);
    };
    const ResultTable all = ranges("3-4,4-5,3-5", "all.csv");
    const ResultTable one = ranges("3-5", "one.csv");
    for (const char* quantity : {"intensity", "contrast_intensity", "irradiance", "pixels"}) {
        EXPECT_EQ(column(all, std::string(quantity) + "@3-5um"), column(one, quantity)) << quantity;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR((column(all, "intensity@3-4um")[i] + column(all, "intensity@4-5um")[i]) /
                        column(all, "intensity@3-5um")[i],
                    1.0, 1e-6);
    }
}

TEST(SmatBatchBands, MayBeGivenOneByOneAndNotTwice) {
    const TemporaryFolder folder;
    const std::vector<std::string> start = {"range", sphere,  "--points",
                                            "2",     "--out", folder / "a.csv"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), start.begin(), start.end());
        return smatBatch(more);
    };
    ASSERT_EQ(with({"--band", "3-5", "--band", "8-12"}).exitCode, 0);
    EXPECT_NE(ResultTable::load(folder / "a.csv").find("intensity@8-12um"), nullptr);
    const Ran twice = with({"--band", "3-5,3.0-5"});
    EXPECT_EQ(twice.exitCode, 2);
    EXPECT_THAT(twice.err, HasSubstr("each once"));
    write(folder / "near.csv", "um,response\n3,0\n4,1\n5,0\n");
    write(folder / "far.csv", "um,response\n8,1\n12,1\n");
    ASSERT_EQ(with({"--response", folder / "near.csv", "--response", folder / "far.csv"}).exitCode,
              0);
    EXPECT_NE(ResultTable::load(folder / "a.csv").find("intensity@near"), nullptr);
}

TEST(SmatBatchBands, AnImageOfSeveralIsAFileEach) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"image", sphere, "--band", "3-5,8-12", "--width", "32", "--height",
                               "32", "--out", folder / "a.exr", "--out", folder / "a.json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(irsg::readExr(folder / "a@3-5um.exr").attributes.at("band.name"), "3-5 um");
    EXPECT_EQ(irsg::readExr(folder / "a@8-12um.exr").attributes.at("band.name"), "8-12 um");
    EXPECT_TRUE(std::filesystem::exists(folder / "a@8-12um.json"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.exr"));
    const Ran spectrum =
        smatBatch({"spectrum", sphere, "--band", "3-5,8-12", "--out", folder / "s.csv"});
    EXPECT_EQ(spectrum.exitCode, 2);
    EXPECT_THAT(spectrum.err, HasSubstr("one band: a spectrum"));
}

TEST(SmatBatchObjects, HaveColumnsAtTheirOwnRangesWhoseSumTheTotalIs) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"range", twoSpheres(folder), "--from", "1000", "--to", "2000",
                               "--points", "2", "--out", folder / "a.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "a.csv");
    ASSERT_NE(table.find("ball-2.intensity"), nullptr);
    for (std::size_t i = 0; i < 2; ++i) {
        const double first = column(table, "ball.intensity")[i];
        const double second = column(table, "ball-2.intensity")[i];
        EXPECT_NEAR(second / first, 1.0, 5e-3) << "equal spheres without air";
        EXPECT_NEAR(column(table, "intensity")[i] / (first + second), 1.0, 1e-12);
    }
    EXPECT_NEAR(column(table, "intensity")[0] / column(table, "intensity")[1], 1.0, 5e-3);
}

// Where a sweep by steps ends if its end is no whole number of steps from its beginning, as the
// help of its options says.
TEST(SmatBatchSweep, ByStepsEndsAsItsHelpSays) {
    const TemporaryFolder folder;
    struct Row {
        std::vector<std::string> arguments;
        const char* column;
        std::vector<double> expected;
        const char* help;
    };
    const Row rows[] = {
        {{"time", sphere, "--from", "0", "--to", "1", "--step", "0.3"},
         "time",
         {0.0, 0.3, 0.6, 0.9},
         "the last case is the last step at or before it"},
        {{"polar", sphere, "--from", "0", "--to", "100", "--step", "30"},
         "angle",
         {0.0, 30.0, 60.0, 90.0, 100.0},
         "Last angle of a sector, which has a case whatever the step"},
        {{"polar", sphere, "--from", "0", "--to", "1", "--step", "1", "--offset-to", "25"},
         "elevation",
         {0.0, 0.0, 10.0, 10.0, 20.0, 20.0},
         "the last is the last step at or below it"},
        {{"table", sphere, "--elevation-from", "0", "--elevation-to", "50", "--elevation-step",
          "40", "--azimuth-step", "180"},
         "elevation",
         {0.0, 0.0, 40.0, 40.0, 50.0, 50.0},
         "Last elevation, which has cases whatever the step"}};
    for (const Row& row : rows) {
        SCOPED_TRACE(row.help);
        std::vector<std::string> arguments = row.arguments;
        arguments.insert(arguments.end(), {"--out", folder / "a.csv"});
        const Ran ran = smatBatch(arguments);
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        const ResultTable table = ResultTable::load(folder / "a.csv");
        const std::vector<double> values = column(table, row.column);
        ASSERT_EQ(values.size(), row.expected.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_NEAR(values[i], row.expected[i], 1e-9);
        }
        // Lines of the help break anywhere.
        const std::string help = smatBatch({row.arguments.front(), "--help"}).out;
        std::string words;
        for (const char c : help) {
            const bool isBlank = c == ' ' || c == '\n';
            if (!isBlank || !words.ends_with(' ')) {
                words += isBlank ? ' ' : c;
            }
        }
        EXPECT_THAT(words, HasSubstr(row.help));
    }
}

TEST(SmatBatchSweep, TellsOfATargetThatReachesOutOfTheFrame) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"range", sphere, "--from", "10", "--to", "1000", "--points", "4",
                               "--log", "--fov", "2", "--out", folder / "a.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const std::string sentence = "at 10 m (and 1 more): sphere reaches beyond the frame";
    EXPECT_THAT(ran.err, HasSubstr("warning: range: " + sentence));
    EXPECT_THAT(contentOf(folder / "a.csv"), HasSubstr("# warning: " + sentence));
    const ResultTable table = ResultTable::load(folder / "a.csv");
    for (std::size_t row = 0; row < 4; ++row) {
        EXPECT_EQ(table.warningOf(row).empty(), row > 1) << row;
    }
}

TEST(SmatBatchSweep, AnImageTellsOfWhatItsSumsAreWithout) {
    const TemporaryFolder folder;
    for (const auto& [range_m, isWhole] : {std::pair{"10", false}, {"1000", true}}) {
        const Ran ran = smatBatch(
            {"image", sphere, "--range", range_m, "--fov", "2", "--out", folder / "a.exr"});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_EQ(ran.err.find("sphere reaches beyond the frame; what lies outside is not in the "
                               "sums") == std::string::npos,
                  isWhole)
            << range_m << ' ' << ran.err;
    }
}

TEST(SmatBatchSweep, ATargetWithinTheFrameHasNoWarningForTheCornersOfItsBox) {
    // A sphere of 1 m seen from 5 m is 11.54 degrees wide on each side, the near side of its
    // box 14.04.
    const TemporaryFolder folder;
    for (const auto& [fov_deg, isWhole] : {std::pair{"23.3", true}, {"22.8", false}}) {
        const Ran ran =
            smatBatch({"range", sphere, "--from", "5", "--to", "100", "--points", "2", "--set",
                       "range.steps=fixed", "--fov", fov_deg, "--out", folder / "a.csv"});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_EQ(ran.err.find("beyond the frame") == std::string::npos, isWhole)
            << fov_deg << ' ' << ran.err;
    }
}

// The aircraft at 500 m in 2 degrees: what reaches out of the frame is missing from the sums, and
// whoever reads that a sweep is complete reads that too.
TEST(SmatBatchSweep, OfEveryKindTellsWhatItsSumsAreWithout) {
    const TemporaryFolder folder;
    const std::string sentence = "turboprop4 reaches beyond the frame; what lies "
                                 "outside is not in the sums";
    for (const std::vector<std::string>& kind :
         {std::vector<std::string>{"polar", "--step", "180", "--steps", "fixed"},
          {"range", "--from", "500", "--to", "600", "--points", "2", "--set", "range.steps=fixed"},
          {"time", "--from", "0", "--to", "1", "--step", "1"}}) {
        for (const bool isToldAsJson : {false, true}) {
            std::vector<std::string> words = kind;
            words.insert(words.begin() + 1, sample("turboprop4/turboprop4.smat"));
            words.insert(words.end(),
                         {"--range", "500", "--fov", "2", "--atmosphere", "none", "--antialiasing",
                          "3", "--shadows", "off", "--bounces", "0", "--width", "64", "--height",
                          "64", "--out", folder / "a.csv"});
            if (isToldAsJson) {
                words.emplace_back("--json");
            }
            const Ran ran = smatBatch(words);
            ASSERT_EQ(ran.exitCode, 0) << ran.err;
            EXPECT_THAT(ran.err, HasSubstr("warning: " + kind.front() + ": " + sentence));
            // Beside the word "complete", on the screen and in the file.
            EXPECT_THAT(ran.out, HasSubstr("complete"));
            EXPECT_THAT(ran.out, HasSubstr(sentence)) << kind.front();
            EXPECT_THAT(contentOf(folder / "a.csv"), HasSubstr("# warning: " + sentence));
        }
    }
}

TEST(SmatBatchSweep, RefusesPublishedTilesWithTheReason) {
    const TemporaryFolder folder;
    for (const char* command : {"polar", "range", "time"}) {
        const Ran ran = smatBatch({command, sphere, "--zoom", "sills", "--out", folder / "a.csv"});
        EXPECT_EQ(ran.exitCode, 2);
        EXPECT_THAT(ran.err, HasSubstr("render.zoom"));
        EXPECT_THAT(ran.err, HasSubstr("do not add to pixels"));
    }
}

TEST(SmatBatchTable, HasTheNumbersOfARunForEachStateAndBand) {
    const TemporaryFolder folder;
    const std::string project = sample("box/box.smat");
    const std::vector<std::string> view = {"--width", "64", "--height", "64"};
    const auto ran = [&](std::vector<std::string> arguments, const std::string& name) {
        arguments.insert(arguments.end(), view.begin(), view.end());
        arguments.insert(arguments.end(), {"--out", folder / name});
        const Ran one = smatBatch(arguments);
        EXPECT_EQ(one.exitCode, 0) << one.err;
        return ResultTable::load(folder / name);
    };
    const ResultTable table =
        ran({"table", project, "--azimuth-step", "90", "--elevation-from", "0", "--elevation-to",
             "20", "--elevation-step", "20", "--machs", "0.2,0.8", "--band", "3-5,8-12"},
            "table.csv");
    ASSERT_EQ(table.rowCount(), 16u);
    for (const std::string mach : {"0.2", "0.8"}) {
        for (const std::string elevation : {"0", "20"}) {
            const ResultTable polar = ran({"polar", project, "--step", "90", "--offset", elevation,
                                           "--mach", mach, "--band", "8-12"},
                                          "polar.csv");
            std::size_t at = 0;
            for (std::size_t i = 0; i < table.rowCount(); ++i) {
                if (column(table, "mach")[i] != std::stod(mach) ||
                    column(table, "elevation")[i] != std::stod(elevation)) {
                    continue;
                }
                EXPECT_EQ(column(table, "contrast_intensity@8-12um")[i],
                          column(polar, "contrast_intensity")[at]);
                EXPECT_GT(column(table, "source_intensity@8-12um")[i], 0.0);
                ++at;
            }
            EXPECT_EQ(at, 4u);
        }
    }
}

TEST(SmatBatchTable, IsReadByGnuOctaveAsItIsWrittenAsCsv) {
#ifndef SMAT_HAS_MATIO
    GTEST_SKIP() << "built without matio, which writes MATLAB's layout";
#endif
    const std::string octave = "octave-cli";
    if (runProgram({octave, "--version"}).exitCode != 0) {
        GTEST_SKIP() << "GNU Octave (octave-cli) is not installed";
    }
    const TemporaryFolder folder;
    const std::string mat = folder / "table.mat", csv = folder / "table.csv";
    const Ran table = smatBatch({"table",
                                 sample("turboprop4/turboprop4.smat"),
                                 "--azimuth-step",
                                 "45",
                                 "--elevation-from",
                                 "-20",
                                 "--elevation-to",
                                 "20",
                                 "--elevation-step",
                                 "20",
                                 "--band",
                                 "3-5,8-12",
                                 "--width",
                                 "64",
                                 "--height",
                                 "64",
                                 "--out",
                                 mat,
                                 "--out",
                                 csv});
    ASSERT_EQ(table.exitCode, 0) << table.err;
    const std::string script = std::string(SMAT_SOURCE_DIR) + "/benchmarks/read_table.m";
    const auto read = [&](const std::string& other) {
        return runProgram({octave, "--norc", script, mat, other});
    };
    const Ran same = read(csv);
    EXPECT_EQ(same.exitCode, 0) << same.out << same.err;
    EXPECT_THAT(same.out, HasSubstr("48 cells, largest relative difference"));

    // Other numbers under the same name are told.
    std::string text = contentOf(csv);
    const auto rename = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    rename(",contrast_intensity@3-5um", ",other@3-5um");
    rename(",source_intensity@3-5um", ",contrast_intensity@3-5um");
    write(folder / "other.csv", text);
    EXPECT_EQ(read(folder / "other.csv").exitCode, 1);
}

TEST(SmatBatchParts, AreJoinedToTheBytesOfOneRun) {
    const TemporaryFolder folder;
    const auto ran = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"table",
                                   sample("box/box.smat"),
                                   "--azimuth-step",
                                   "45",
                                   "--elevation-from",
                                   "-30",
                                   "--elevation-to",
                                   "30",
                                   "--elevation-step",
                                   "30",
                                   "--ranges",
                                   "800,1500",
                                   "--machs",
                                   "0.2,0.8",
                                   "--band",
                                   "3-5,8-12",
                                   "--width",
                                   "64",
                                   "--height",
                                   "64"});
        const Ran one = smatBatch(more);
        EXPECT_EQ(one.exitCode, 0) << one.err;
    };
    ran({"--out", folder / "one.csv"});
    const std::string all = folder / "all.csv";
    std::vector<std::string> parts;
    for (const std::string part : {"1", "2", "3"}) {
        ran({"--shard", part + "/3", "--out", all});
        parts.push_back(all + ".part" + part + "of3");
        EXPECT_FALSE(std::filesystem::exists(all));
    }
    const Ran missing = smatBatch({"merge", parts[0], parts[2], "--out", all});
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_THAT(missing.err, HasSubstr("2/3"));
    // One that was cut off is gone on with.
    const std::string second = contentOf(parts[1]);
    write(parts[1], second.substr(0, 2 * second.size() / 3));
    ran({"--shard", "2/3", "--resume", "--out", all});
    const Ran merged = smatBatch({"merge", parts[2], parts[0], parts[1], "--out", all});
    EXPECT_EQ(merged.exitCode, 0) << merged.err;
    EXPECT_EQ(withoutCommand(all), withoutCommand(folder / "one.csv"));
    const Ran image =
        smatBatch({"image", sample("box/box.smat"), "--shard", "1/2", "--out", folder / "a.exr"});
    EXPECT_EQ(image.exitCode, 2);
}

TEST(SmatBatchTargetError, IsChosenAlikeByPartsAndToldInTheResult) {
    const TemporaryFolder folder;
    const auto ran = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"polar", sphere, "--step", "60", "--atmosphere", "none",
                                   "--target-error", "0.5%", "--width", "64", "--height", "64"});
        const Ran one = smatBatch(more);
        EXPECT_EQ(one.exitCode, 0) << one.err;
    };
    ran({"--out", folder / "one.csv"});
    EXPECT_THAT(contentOf(folder / "one.csv"), HasSubstr("# answered by: target error 0.5 %: "));
    EXPECT_FALSE(column(ResultTable::load(folder / "one.csv"), "error_contrast_intensity").empty());
    const std::string all = folder / "all.csv";
    ran({"--shard", "1/2", "--out", all});
    ran({"--shard", "2/2", "--out", all});
    const Ran merged = smatBatch({"merge", all + ".part1of2", all + ".part2of2", "--out", all});
    EXPECT_EQ(merged.exitCode, 0) << merged.err;
    EXPECT_EQ(withoutCommand(all), withoutCommand(folder / "one.csv"));
}

TEST(SmatBatchAdaptiveSteps, HaveNoParts) {
    const TemporaryFolder folder;
    const std::vector<std::string> start = {"range", sphere,    "--points",
                                            "3",     "--steps", "adaptive"};
    auto part = start, whole = start;
    part.insert(part.end(), {"--shard", "1/2", "--out", folder / "a.csv"});
    const Ran refused = smatBatch(part);
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("range.steps"));
    whole.insert(whole.end(), {"--out", folder / "a.csv"});
    const Ran ran = smatBatch(whole);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(contentOf(folder / "a.csv"), HasSubstr("# answered by: adaptive steps: 3 + "));
}

/// Sum of the columns of parts of an object, "" of one alone, for a quantity and band.
std::vector<double> sumOfParts(const ResultTable& table, const std::string& object,
                               const std::string& quantity) {
    std::vector<double> sum(table.rowCount(), 0.0);
    for (const ResultColumn& one : table.columns()) {
        const ColumnName name = ColumnName::of(one.key);
        if (name.part().empty() || !name.object.starts_with(object) ||
            ColumnName{name.prefix, "", name.quantity, name.band}.key() != quantity) {
            continue;
        }
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += one.values[i];
        }
    }
    return sum;
}

TEST(SmatBatchByPart, PartsAddUpToTheWholeInEveryBandAndAreNamed) {
    const TemporaryFolder folder;
    const std::string ship = sample("ship/ship.smat");
    for (const char* by : {"temperature", "material"}) {
        SCOPED_TRACE(by);
        const Ran ran =
            smatBatch({"polar", ship, "--by-part", by, "--step", "180", "--atmosphere", "none",
                       "--band", "3-5,8-12", "--width", "160", "--height", "120", "--set",
                       "render.bounces=1", "--out", folder / "polar.csv"});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        const ResultTable table = ResultTable::load(folder / "polar.csv");
        for (const char* quantity :
             {"intensity@3-5um", "contrast_intensity@3-5um", "irradiance@8-12um"}) {
            const std::vector<double> whole = column(table, quantity);
            const std::vector<double> parts = sumOfParts(table, "ship/", quantity);
            ASSERT_EQ(whole.size(), 2u);
            for (std::size_t i = 0; i < whole.size(); ++i) {
                EXPECT_NEAR(parts[i] / whole[i], 1.0, 1e-9) << quantity;
            }
        }
        EXPECT_THAT(ran.out, HasSubstr("of the largest contrast, at "));
        // The numbers of the whole are those without parts.
        const Ran plain = smatBatch({"polar", ship, "--step", "180", "--atmosphere", "none",
                                     "--band", "3-5,8-12", "--width", "160", "--height", "120",
                                     "--set", "render.bounces=1", "--out", folder / "plain.csv"});
        ASSERT_EQ(plain.exitCode, 0) << plain.err;
        const ResultTable without = ResultTable::load(folder / "plain.csv");
        EXPECT_EQ(column(without, "contrast_intensity@3-5um"),
                  column(table, "contrast_intensity@3-5um"));
        for (const ResultColumn& one : without.columns()) {
            EXPECT_EQ(ColumnName::of(one.key).part(), "") << one.key;
        }
    }
}

TEST(SmatBatchByPart, EachOfSeveralObjectsHasItsParts) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"range", twoSpheres(folder), "--by-part", "temperature", "--from",
                               "2000", "--to", "3000", "--points", "2", "--out", folder / "r.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "r.csv");
    for (const std::string object : {"ball", "ball-2"}) {
        const std::vector<double> whole = column(table, object + ".intensity");
        const std::vector<double> parts = sumOfParts(table, object + "/", "intensity");
        ASSERT_EQ(whole.size(), 2u);
        for (std::size_t i = 0; i < whole.size(); ++i) {
            EXPECT_NEAR(parts[i] / whole[i], 1.0, 1e-9) << object;
        }
    }
}

} // namespace
} // namespace smat::test

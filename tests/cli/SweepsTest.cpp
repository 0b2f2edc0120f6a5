#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/image/ExrFile.h"
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

TEST(SmatBatchSweep, TellsOfATargetThatReachesOutOfTheFrame) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"range", sphere, "--from", "10", "--to", "1000", "--points", "4",
                               "--log", "--fov", "2", "--out", folder / "a.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const std::string sentence = "at 10 m (and 1 more): the bounding box of ";
    EXPECT_THAT(ran.err, HasSubstr("warning: range: " + sentence));
    EXPECT_THAT(contentOf(folder / "a.csv"), HasSubstr("# warning: " + sentence));
}

TEST(SmatBatchSweep, RefusesThePublishedZoomWithTheReason) {
    const TemporaryFolder folder;
    for (const char* command : {"polar", "range", "time"}) {
        const Ran ran = smatBatch({command, sphere, "--zoom", "sills", "--out", folder / "a.csv"});
        EXPECT_EQ(ran.exitCode, 2);
        EXPECT_THAT(ran.err, HasSubstr("render.zoom"));
        EXPECT_THAT(ran.err, HasSubstr("do not add to pixels"));
    }
}

} // namespace
} // namespace smat::test

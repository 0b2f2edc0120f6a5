// Projects and scenarios with all files that they need, copied to another place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<double> intensities(const fs::path& project, const TemporaryFolder& folder) {
    const Ran ran = smatBatch({"range", project.string(), "--points", "2", "--from", "800", "--to",
                               "900", "--width", "64", "--height", "48", "--set",
                               "render.bounces=0", "--mode", "ck", "--out", folder / "r.csv"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.err, Not(HasSubstr("not found there"))) << ran.err;
    return ResultTable::load(folder / "r.csv").find("intensity")->values;
}

/// A sample with an air of the program, in a folder that can be taken away.
fs::path original(const TemporaryFolder& folder) {
    fs::create_directories(folder / "there");
    for (const auto& entry : fs::directory_iterator(sample("corvette"))) {
        if (entry.is_regular_file()) {
            fs::copy(entry.path(), folder.path() / "there" / entry.path().filename());
        }
    }
    // Its plumes as shells: the wideband mode does not take zones of gas.
    for (const char* file : {"corvette.flt", "corvette.sigdb"}) {
        fs::copy(fs::path(SMAT_SOURCE_DIR) / "tests/data/shells/corvette" / file,
                 folder.path() / "there" / file, fs::copy_options::overwrite_existing);
    }
    fs::copy(sample("../resources/atmospheres/temperate-maritime.xml"),
             folder.path() / "there/own-air.xml");
    return folder.path() / "there/corvette.smat";
}

TEST(SmatBatchCollect, ACollectedProjectRunsWhereTheOriginalIsGone) {
    const TemporaryFolder folder;
    const fs::path project = original(folder);
    const Ran set =
        smatBatch({"project", "set", project.string(), "0", "--set",
                   "environment.atmospheres=" + (folder / "there/own-air.xml").string()});
    ASSERT_EQ(set.exitCode, 0) << set.err;
    const std::vector<double> before = intensities(project, folder);
    const Ran ran = smatBatch({"project", "collect", project.string(), folder / "copy/moved.smat"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("own-air.xml"));
    fs::remove_all(folder / "there");
    fs::rename(folder.path() / "copy", folder.path() / "elsewhere");
    EXPECT_EQ(intensities(folder.path() / "elsewhere/moved.smat", folder), before);
    // It names no file outside of its folder.
    EXPECT_THAT(contentOf(folder.path() / "elsewhere/moved.smat"),
                Not(HasSubstr((folder / "").string())));
}

TEST(SmatBatchCollect, TexturesAndMaterialsOfAModelAreFoundByTheirNames) {
    const TemporaryFolder folder;
    fs::create_directories(folder / "a/tex");
    fs::create_directories(folder / "shared");
    write(folder / "a/box.obj",
          "mtllib box.mtl\nusemtl skin\nv 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n");
    write(folder / "a/box.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd tex/skin one.png\n"
                                "map_Ks ../shared/gloss.png\n");
    write(folder / "a/tex/skin one.png", "x");
    write(folder / "a/tex/other.png", "x");
    write(folder / "shared/gloss.png", "x");
    ASSERT_EQ(smatBatch({"project", "new", folder / "a/p.smat", folder / "a/box.obj"}).exitCode, 0);
    const Ran ran = smatBatch({"project", "collect", folder / "a/p.smat", folder / "b/p.smat"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const fs::path models = folder.path() / "b/p.files/models/box";
    for (const char* file : {"a/box.obj", "a/box.mtl", "a/tex/skin one.png", "shared/gloss.png"}) {
        EXPECT_TRUE(fs::exists(models / file)) << file;
    }
    EXPECT_FALSE(fs::exists(models / "a/tex/other.png"));
}

TEST(SmatBatchCollect, ACollectedScenarioRunsWhereTheOriginalIsGone) {
    const TemporaryFolder folder;
    fs::copy(sample("flyby"), folder / "flyby", fs::copy_options::recursive);
    fs::copy(sample("turboprop4"), folder / "turboprop4", fs::copy_options::recursive);
    const Ran ran =
        smatBatch({"project", "collect", folder / "flyby/flyby.json", folder / "copy/flyby.json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    fs::remove_all(folder / "flyby");
    fs::remove_all(folder / "turboprop4");
    const Ran simulated =
        smatBatch({"simulate", folder / "copy/flyby.json", "--dry-run", "--out", folder / "out"});
    EXPECT_EQ(simulated.exitCode, 0) << simulated.err;
    EXPECT_THAT(simulated.err, Not(HasSubstr("not found there")));
}

TEST(SmatBatchCollect, RefusesWhatIsMissingByNameAndWhatIsThere) {
    const TemporaryFolder folder;
    const fs::path project = original(folder);
    write(folder / "taken.smat", "{}");
    const Ran taken = smatBatch({"project", "collect", project.string(), folder / "taken.smat"});
    EXPECT_EQ(taken.exitCode, 2);
    EXPECT_THAT(taken.err, HasSubstr("which exists"));
    write(folder / "other.smat", R"({"version": 1, "models": [{"file": "there/nothing.obj"}]})");
    const Ran missing =
        smatBatch({"project", "collect", folder / "other.smat", folder / "copy.smat"});
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_THAT(missing.err, HasSubstr("nothing.obj"));
    EXPECT_FALSE(fs::exists(folder / "copy.smat"));
}

} // namespace
} // namespace smat::test

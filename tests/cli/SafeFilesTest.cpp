#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/Program.h"
#include "tests/support/DecimalCommas.h"
#include "tests/support/QuietListener.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// A shell line with SMAT for the program; its exit code and what it printed on standard error.
Ran shell(const std::string& line, const fs::path& folder) {
    const std::string command = "cd '" + folder.string() + "' && ( " + line + " ) 2>err.txt";
    const int status = std::system(("SMAT='" SMAT_BATCH "'; " + command).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), "",
            contentOf(folder / "err.txt")};
}

const std::string box = sample("box/box.flt").string();

TEST(SmatBatchStreams, AFullOrClosedOutputIsARefusal) {
    const TemporaryFolder folder;
    const std::string database = sample("box/box.sigdb").string();
    for (const std::string& command :
         {"$SMAT model info " + box, "$SMAT db export " + database, std::string("$SMAT settings"),
          "$SMAT --json model info " + box, std::string("$SMAT --help")}) {
        for (const char* where : {" > /dev/full", " >&-"}) {
            const Ran ran = shell(command + where, folder.path());
            EXPECT_EQ(ran.exitCode, 2) << command << where << ran.err;
            EXPECT_THAT(ran.err, HasSubstr("standard output")) << command << where;
        }
        EXPECT_EQ(shell(command + " > /dev/null", folder.path()).exitCode, 0) << command;
    }
    // A reader that goes away.
    const Ran ran = shell("( $SMAT settings; echo $? > code ) | true; sleep 0.2; exit $(cat code)",
                          folder.path());
    EXPECT_TRUE(ran.exitCode == 2 || ran.exitCode == 0) << ran.exitCode;
}

TEST(SmatBatchStreams, AFullOrClosedErrorStreamChangesNoExitCode) {
    const TemporaryFolder folder;
    for (const char* where : {" 2>/dev/full", " 2>&-"}) {
        EXPECT_EQ(shell("$SMAT model info none.flt" + std::string(where), folder.path()).exitCode,
                  2);
        EXPECT_EQ(
            shell("$SMAT model info '" + box + "' >/dev/null" + where, folder.path()).exitCode, 0);
        EXPECT_EQ(shell("$SMAT nonsense" + std::string(where), folder.path()).exitCode, 2);
        EXPECT_EQ(shell("$SMAT --timing --verbose model info '" + box + "' >/dev/null" + where,
                        folder.path())
                      .exitCode,
                  0);
    }
}

TEST(SmatBatchNames, ThatAreNoUtf8GetASentence) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"model", "info", "a\xff.flt"}, folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, AllOf(HasSubstr("a\\xff.flt"), HasSubstr("UTF-8")));
    // A name in a file of others is shown as well as it can be.
    std::string obj = "mtllib \xff\xfe.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";
    write(folder / "a.obj", obj);
    const Ran info = smatBatch({"--json", "model", "info", "a.obj"}, folder.path());
    EXPECT_EQ(info.exitCode, 0) << info.err;
    EXPECT_EQ(nlohmann::json::parse(info.out)["codes"].size(), 1u);
}

TEST(SmatBatchOutput, IsNeverAnInput) {
    const TemporaryFolder folder;
    fs::copy(sample("box"), folder / "box");
    fs::copy(fs::path(SMAT_SOURCE_DIR) / "resources/atmospheres", folder / "air");
    write(folder / "image.csv", "1 2\n3 4\n");
    fs::create_symlink("image.csv", folder / "link.csv");
    const std::vector<std::vector<std::string>> lines = {
        {"convert", "box/box.flt", "box/box.flt"},
        {"compare", "image.csv", "image.csv", "--out", "image.csv"},
        {"compare", "image.csv", "image.csv", "--out", "link.csv"},
        {"db", "export", "box/box.sigdb", "--out", "box/box.sigdb"},
        {"temperature-profile", "air/subarctic-winter.xml", "--min", "0", "--max", "10", "--step",
         "5", "--out", "air/subarctic-winter.xml"},
        {"range", "box/box.smat", "--from", "100", "--to", "200", "--points", "2", "--out",
         "box/box.smat"},
    };
    for (const auto& words : lines) {
        const fs::path target = folder / words.back();
        const std::string before = contentOf(target);
        const Ran ran = smatBatch(words, folder.path());
        EXPECT_EQ(ran.exitCode, 2) << words[0] << ran.err;
        EXPECT_EQ(contentOf(target), before) << words[0];
    }
}

TEST(SmatBatchOutput, OfManyConversionsToOneFileIsOneOfThem) {
    const TemporaryFolder folder;
    std::vector<std::thread> runs;
    std::vector<int> codes(8, -1);
    for (std::size_t i = 0; i < codes.size(); ++i) {
        runs.emplace_back([&, i] {
            codes[i] = smatBatch({"convert", box, "a.osgb"}, folder.path()).exitCode;
        });
    }
    for (std::thread& run : runs) {
        run.join();
    }
    EXPECT_THAT(codes, testing::Each(0));
    EXPECT_EQ(smatBatch({"model", "info", "a.osgb"}, folder.path()).exitCode, 0);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(SmatBatchDatabase, ImportOverADatabaseAsksForReplace) {
    const TemporaryFolder folder;
    const std::string json = sample("box/signature.json").string();
    EXPECT_EQ(smatBatch({"db", "import", json, "a.sigdb"}, folder.path()).exitCode, 0);
    const std::string before = contentOf(folder / "a.sigdb");
    const Ran ran = smatBatch({"db", "import", json, "a.sigdb"}, folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, AllOf(HasSubstr("a.sigdb"), HasSubstr("--replace")));
    EXPECT_EQ(contentOf(folder / "a.sigdb"), before);
    EXPECT_EQ(smatBatch({"db", "import", json, "a.sigdb", "--replace"}, folder.path()).exitCode, 0);
}

TEST(SmatBatchLimits, OfTheSizeOfFilesAreToldInWords) {
    const TemporaryFolder folder;
    for (const std::string file : {"a.exr", "a.csv", "a.tif", "a.png", "a.json"}) {
        write(folder / file, "what was there");
        const Ran ran = shell("ulimit -f 1; $SMAT image '" + sample("sphere/sphere.smat").string() +
                                  "' --width 64 --height 64 --out " + file,
                              folder.path());
        EXPECT_EQ(ran.exitCode, 2) << file << ran.err;
        EXPECT_THAT(ran.err, AllOf(HasSubstr(file), HasSubstr("larger than is allowed")));
        EXPECT_EQ(contentOf(folder / file), "what was there");
    }
}

TEST(SmatBatchLimits, AreToldByEveryCommandThatWrites) {
    const std::string box = sample("box/box").string();
    const std::string air = std::string(SMAT_SOURCE_DIR) + "/resources/atmospheres/haze-23km.csv";
    const std::pair<const char*, std::string> rows[] = {
        {"a.osgt", "convert '" + box + ".flt' a.osgt"},
        {"a.osgb", "convert '" + box + ".flt' a.osgb"},
        {"a.ive", "convert '" + box + ".flt' a.ive"},
        {"p.csv", "polar '" + box + ".smat' --step 5 --width 8 --height 8 --out p.csv"},
        {"j.json", "db export '" + box + ".sigdb' j.json"},
        {"r.csv", "radiative '" + air +
                      "' --quantity transmittance --sensor-altitude 1000 --los-elevation 0 "
                      "--range 5000 --out r.csv"}};
    for (const auto& [file, command] : rows) {
        const TemporaryFolder folder;
        write(folder / file, "what was there");
        const Ran ran = shell("ulimit -f 1; $SMAT " + command, folder.path());
        EXPECT_EQ(ran.exitCode, 2) << file << ran.err;
        EXPECT_THAT(ran.err, AllOf(HasSubstr(file), HasSubstr("larger than is allowed")));
        EXPECT_EQ(contentOf(folder / file), "what was there");
    }
}

TEST(SmatBatchBounds, NameAHundredDiagnosticsAndHowManyMore) {
    const TemporaryFolder folder;
    fs::copy(sample("flyby"), folder / "flyby");
    std::string rows = "t,x,y,z,yaw,pitch,roll\n";
    for (int i = 0; i < 20000; ++i) {
        rows += "5,0,0,100,0,0,0\n";
    }
    write(folder / "flyby/near.csv", rows);
    const Ran ran =
        smatBatch({"simulate", "flyby/flyby.json", "--out", "out", "--dry-run"}, folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_LT(std::count(ran.err.begin(), ran.err.end(), '\n'), 250);
    EXPECT_THAT(ran.err, HasSubstr("more"));
    for (const char* endless : {"/dev/zero", "/dev/urandom"}) {
        const Ran refused = smatBatch({"compare", endless, endless}, folder.path());
        EXPECT_EQ(refused.exitCode, 2);
        EXPECT_THAT(refused.err, HasSubstr(endless));
    }
}

TEST(SmatBatchModels, RunNothingAndCallNobody) {
    const TemporaryFolder folder;
    const QuietListener listener;
    write(folder / "evil.lua", "os.execute('touch " + (folder / "ran").string() + "')\n");
    for (const std::string& name : {listener.address("evil.lua"), std::string("evil.lua")}) {
        write(folder / "a.mtl", "newmtl m\nmap_Kd " + name + "\n");
        write(folder / "a.obj",
              "mtllib a.mtl\nmtllib " + name + "\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl m\nf 1 2 3\n");
        EXPECT_EQ(smatBatch({"model", "info", "a.obj"}, folder.path()).exitCode, 0);
        EXPECT_EQ(smatBatch({"convert", "a.obj", "a.osgt"}, folder.path()).exitCode, 0);
        EXPECT_EQ(smatBatch({"model", "info", name}, folder.path()).exitCode, 2);
        write(folder / "p.smat",
              R"({"version": 1, "models": [{"file": ")" + name + R"(", "database": "b.sigdb"}]})");
        EXPECT_EQ(smatBatch({"image", "p.smat", "--out", "o.exr"}, folder.path()).exitCode, 2);
    }
    EXPECT_FALSE(listener.heard());
    EXPECT_FALSE(fs::exists(folder / "ran"));
}

TEST(SmatBatchLocale, IsTheSameWithDecimalCommas) {
    const TemporaryFolder folder;
    write(folder / "a.obj", "v 0.0 0.0 0.0\nv 1.0 0.0 0.0\nv 0.0 1.0 0.0\n"
                            "v 1.5 0 0.5\nv 0 2.5 0.5\nv 0 0 0.5\nf 1 2 3\nf 6 4 5\n");
    ASSERT_EQ(smatBatch({"convert", "a.obj", "a.osgt"}, folder.path()).exitCode, 0);
    const std::vector<std::vector<std::string>> lines = {
        {"model", "info", "a.obj"},
        {"model", "info", "a.osgt"},
        {"db", "export", sample("ship/ship.sigdb").string()},
        {"temperature-profile",
         (fs::path(SMAT_SOURCE_DIR) / "resources/atmospheres/subarctic-winter.xml").string(),
         "--min", "0", "--max", "1000", "--step", "500", "--out", "t.csv"}};
    std::vector<std::string> outputs;
    for (const auto& words : lines) {
        outputs.push_back(smatBatch(words, folder.path()).out);
    }
    const std::string table = contentOf(folder / "t.csv");
    for (const char* name : {"de_DE", "fr_CA"}) {
        const TemporaryFolder place;
        const DecimalCommas locale(name, place.path());
        if (!locale.isThere()) {
            GTEST_SKIP() << "this system cannot make the locale " << name;
        }
        for (std::size_t i = 0; i < lines.size(); ++i) {
            EXPECT_EQ(smatBatch(lines[i], folder.path()).out, outputs[i]) << name << lines[i][0];
        }
        EXPECT_EQ(contentOf(folder / "t.csv"), table) << name;
    }
}

} // namespace
} // namespace smat::test

// A model without codes on the command line: placed, given codes by names, and drawn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

/// A box of 200 by 400 by 100 and a pane on it, in y-up Wavefront, the nose along z.
class OwnModels : public testing::Test {
  protected:
    OwnModels() {
        write(folder / "hut.mtl", "newmtl Paint_Grey\nKd 0.5 0.5 0.5\nnewmtl Glass\nKd 0 0 0\n");
        write(folder / "hut.obj", "mtllib hut.mtl\n"
                                  "v -100 0 -200\nv 100 0 -200\nv 100 0 200\nv -100 0 200\n"
                                  "v -100 100 -200\nv 100 100 -200\nv 100 100 200\nv -100 100 200\n"
                                  "o Walls\nusemtl Paint_Grey\n"
                                  "f 1 2 3 4\nf 1 5 6 2\nf 2 6 7 3\nf 4 3 7 8\nf 1 4 8 5\n"
                                  "o Skylight\nusemtl Glass\nf 5 8 7 6\n");
    }
    nlohmann::json info(std::vector<std::string> more) {
        more.insert(more.begin(), {"model", "info", "hut.obj", "--json"});
        return nlohmann::json::parse(run(more).out);
    }
    Ran run(const std::vector<std::string>& arguments, int exitCode = 0) {
        Ran ran = smatBatch(arguments, folder.path());
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        return ran;
    }
    TemporaryFolder folder;
};

TEST_F(OwnModels, ArePlacedAsTheOptionsSay) {
    const auto plain = info({});
    EXPECT_EQ(plain["max_m"][1], 200.0);
    EXPECT_EQ(plain["placing"]["upAxis"], "+z");
    EXPECT_EQ(plain["guess"]["unit_m"], 1.0);
    const auto placed = info({"--unit", "cm", "--nose-axis=-x", "--origin", "base"});
    EXPECT_NEAR(placed["max_m"][1].get<double>(), 1.0, 1e-6) << "half the width";
    EXPECT_NEAR(placed["max_m"][0].get<double>(), 2.0, 1e-6);
    EXPECT_NEAR(placed["max_m"][2].get<double>(), 1.0, 1e-6);
    EXPECT_NEAR(placed["min_m"][2].get<double>(), 0.0, 1e-6);
    EXPECT_NEAR(info({"--unit", "0.0254", "--origin", "100,0,0"})["max_m"][0].get<double>(), 0.0,
                1e-6);
}

TEST_F(OwnModels, GetCodesByNamesAndLoseThemAgain) {
    EXPECT_THAT(
        run({"model", "codes", "hut.obj", "--rule", "material:*=1,2", "--rule", "object:Sky*=3,"})
            .out,
        HasSubstr("hut.codes.json: 2 rules, 0 painted surfaces, saved"));
    auto codes = info({})["codes"];
    ASSERT_EQ(codes.size(), 2U);
    EXPECT_EQ(codes[0]["temperature"], 1);
    EXPECT_EQ(codes[1]["temperature"], 3);
    EXPECT_EQ(codes[1]["material"], 2);
    EXPECT_EQ(codes[1]["faces"], 1);
    // A rule for the same name takes the place of the one before.
    run({"model", "codes", "hut.obj", "--rule", "material:*=7,8"});
    EXPECT_EQ(info({})["codes"][0]["temperature"], 3);
    EXPECT_EQ(info({})["codes"][1]["temperature"], 7);
    const auto listed = nlohmann::json::parse(run({"model", "codes", "hut.obj", "--json"}).out);
    EXPECT_EQ(listed["rules"].size(), 2U);
    EXPECT_EQ(listed["names"]["material"][0]["name"], "Glass");
    EXPECT_EQ(listed["names"]["object"].size(), 2U);
    run({"model", "codes", "hut.obj", "--remove", "object:Sky*"});
    EXPECT_EQ(info({})["codes"].size(), 1U);
    run({"model", "codes", "hut.obj", "--clear"});
    EXPECT_FALSE(std::filesystem::exists(folder / "hut.codes.json"));
}

TEST_F(OwnModels, AreSuggestedASignatureWithWhichTheyAreDrawn) {
    run({"model", "codes", "hut.obj", "--suggest", "--database", "hut.sigdb"});
    const auto image = run({"image", "hut.obj", "--unit", "cm", "--range", "50", "--band", "8-12",
                            "--set", "target.altitude=0", "--out", "hut.csv"});
    EXPECT_THAT(image.out, HasSubstr("Intensity"));
    EXPECT_THAT(smatBatch({"db", "info", "hut.sigdb"}, folder.path()).out,
                HasSubstr("window glass, 4 mm"));
    // What it made it does not overwrite.
    EXPECT_THAT(run({"model", "codes", "hut.obj", "--suggest", "--database", "hut.sigdb"}, 2).err,
                HasSubstr("exists already"));
}

TEST_F(OwnModels, SayWhatIsWrongWithAnOptionAndWriteNothing) {
    const std::pair<std::vector<std::string>, const char*> wrong[] = {
        {{"model", "codes", "hut.obj", "--rule", "colour:a=1,2"}, "--rule: found colour:a,"},
        {{"model", "codes", "hut.obj", "--rule", "material:a=1"}, "--rule: found material:a=1"},
        {{"model", "codes", "hut.obj", "--rule", "material:a=,"}, "--rule: found material:a=,"},
        {{"model", "codes", "hut.obj", "--rule", "material:a=1.5,2"}, "--rule"},
        {{"model", "codes", "hut.obj", "--rule", "material:a=99999999999,2"}, "--rule"},
        {{"model", "codes", "hut.obj", "--remove", "material:a"}, "--remove: found material:a"},
        {{"model", "codes", "hut.obj", "--suggest"}, "--database"},
        {{"model", "codes", "hut.obj", "--database", "a.sigdb"}, "--database: found a.sigdb"},
        {{"model", "codes", "gone.obj", "--rule", "material:a=1,2"}, "gone.obj"},
        {{"model", "info", "hut.obj", "--unit", "ell"}, "--unit: found ell"},
        {{"model", "info", "hut.obj", "--unit", "0"}, "--unit: found 0"},
        {{"model", "info", "hut.obj", "--up-axis", "up"}, "--up-axis: found up"},
        {{"model", "info", "hut.obj", "--nose-axis", "+z"}, "noseAxis: found +z with +z up"},
        {{"model", "info", "hut.obj", "--origin", "1,2"}, "--origin: found 1,2"},
        {{"model", "info", "hut.obj", "--origin", "1,2,nan"}, "--origin: found 1,2,nan"},
        {{"image", std::string(sample("ship/ship.smat")), "--unit", "cm", "--out", "a.png"},
         "--unit"},
    };
    for (const auto& [arguments, said] : wrong) {
        EXPECT_THAT(run(arguments, 2).err, HasSubstr(said));
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "hut.codes.json"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.sigdb"));
}

TEST_F(OwnModels, AreRefusedWithADamagedFileOfCodes) {
    write(folder / "hut.codes.json", "{\"format\": \"smat-codes\", \"version\": 1,\n\"rules\": [\n"
                                     "{\"material\": \"Glass\", \"temperatureIndex\": \"hot\"}]}");
    EXPECT_THAT(run({"model", "info", "hut.obj"}, 2).err,
                HasSubstr("hut.codes.json: rules.0.temperatureIndex, line 3: found \"hot\""));
}

} // namespace
} // namespace smat::test

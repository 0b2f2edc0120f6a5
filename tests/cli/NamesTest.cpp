// Names that are mistyped, and those of earlier versions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// How often a text stands in another.
std::size_t countOf(const std::string& part, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

struct MistypedRow {
    const char* name;
    std::vector<std::string> arguments;
    const char* told;
};

void PrintTo(const MistypedRow& row, std::ostream* out) {
    *out << row.name;
}

class Mistyped : public testing::TestWithParam<MistypedRow> {};

TEST_P(Mistyped, IsAnsweredWithTheNearestNames) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch(GetParam().arguments, folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr(GetParam().told));
    EXPECT_EQ(countOf("error: ", ran.err), 1u) << ran.err;
}

const std::string box = sample("box/box.smat").string();

std::vector<std::string> image(std::vector<std::string> more) {
    more.insert(more.begin(), {"image", box, "--out", "a.exr"});
    return more;
}

INSTANTIATE_TEST_SUITE_P(
    Names, Mistyped,
    testing::Values(
        MistypedRow{"ACommand",
                    {"poler", "p.smat"},
                    "smat-batch: found poler, expected a command; did you mean 'polar'?"},
        MistypedRow{"ACommandWithOptionsBefore",
                    {"--threads", "2", "rnage"},
                    "found rnage, expected a command; did you mean 'range'?"},
        MistypedRow{"ACommandOfACommand",
                    {"db", "inof", "a.sigdb"},
                    "smat-batch db: found inof, expected a command; did you mean 'info'?"},
        MistypedRow{"ACommandLikeNone",
                    {"xyzzy"},
                    "found xyzzy, expected a command (smat-batch --help lists them)"},
        MistypedRow{"AnOption", image({"--azimut", "5"}),
                    "smat-batch image: found --azimut, expected an option that it has; did you "
                    "mean '--azimuth'? (smat-batch image --help lists them)"},
        MistypedRow{"AnOptionWithItsValue", image({"--heigth=5"}), "did you mean '--height'?"},
        MistypedRow{"AnOptionOfEveryCommand", image({"--verbos"}), "did you mean '--verbose'?"},
        MistypedRow{"AWordTooMany",
                    {"image", box, "5", "--out", "a.exr"},
                    "found 5, expected no further argument"},
        MistypedRow{"ASetting", image({"--set", "sensor.widht=5"}),
                    "--set: sensor.widht: found 5, expected a setting that exists (smat-batch "
                    "settings lists them); did you mean 'sensor.width'?"},
        MistypedRow{"ASettingWithoutItsSection", image({"--set", "fov=5"}),
                    "did you mean 'sensor.fov'?"},
        MistypedRow{"AChoiceOfAnOption", image({"--sun", "smrt"}),
                    "expected off, approx or smart; did you mean 'smart'?"},
        MistypedRow{"AChoiceOfASetting", image({"--set", "render.supersampling=peraxs"}),
                    "expected perAxis or perPixel; did you mean 'perAxis'?"},
        MistypedRow{"ATruthValue", image({"--set", "render.sunDisc=ture"}), "did you mean 'true'?"},
        MistypedRow{"AKeyOfAModel", image({"--set", "models.0.alitude=5"}),
                    "did you mean 'altitude'?"},
        MistypedRow{"AnAnalysis",
                    {"run", box, "--analysis", "camera-azimut", "--out", "o"},
                    "did you mean 'camera-azimuth'?"},
        MistypedRow{"AWordOfAnOption",
                    {"montecarlo", box, "--sequence", "sobl", "--out", "a.csv"},
                    "--sequence: found sobl, expected sobol or plain; did you mean 'sobol'?"}),
    [](const auto& row) { return std::string(row.param.name); });

/// A project of the box's model with these sections of settings besides.
void writeProject(const std::filesystem::path& file, const std::string& sections) {
    write(file, R"({"version": 1, "models": [{"file": ")" + sample("box/box.flt").string() +
                    R"("}])" + (sections.empty() ? "" : ", ") + sections + "}");
}

TEST(MistypedInAProject, KeysAndChoicesAreAnsweredWithTheNearestNames) {
    const TemporaryFolder folder;
    const auto errorsOf = [&](const std::string& sections) {
        writeProject(folder / "p.smat", sections);
        return smatBatch({"image", "p.smat", "--width", "4", "--height", "4", "--out", "a.exr"},
                         folder.path())
            .err;
    };
    EXPECT_THAT(errorsOf(R"("sensor": {"widht": 5})"),
                HasSubstr("the key sensor.widht is not known to this version and has no effect; "
                          "did you mean 'sensor.width'?"));
    EXPECT_THAT(errorsOf(R"("sesnor": {"width": 5})"),
                HasSubstr("the key sesnor is not known to this version and has no effect; did you "
                          "mean 'sensor'?"));
    EXPECT_THAT(errorsOf(R"("render": {"sun": "of"})"),
                HasSubstr(R"(found "of", expected off, approx or smart; did you mean 'off'?)"));
    EXPECT_THAT(errorsOf(R"("analyses": {"a": {"kind": "poler"}})"),
                HasSubstr("did you mean 'polar'?"));
}

TEST(FormerNames, OfSettingsAreReadInAProjectWithOneRemarkAndWrittenAsOfToday) {
    const TemporaryFolder folder;
    writeProject(folder / "p.smat",
                 R"("render": {"fluxes": "off", "hotParts": false, "supersampling": "inAll"},
                    "analyses": {"a": {"kind": "image", "render": {"fluxes": "approx"}}})");
    const Ran ran =
        smatBatch({"project", "set", "p.smat", "0", "--altitude", "500"}, folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    for (const char* remark : {"p.smat: render.fluxes is called render.ambientReflection now",
                               "p.smat: render.hotParts is called render.hotSpots now",
                               "the value inAll of render.supersampling is called perPixel now"}) {
        EXPECT_EQ(countOf(remark, ran.err), 1u) << remark << "\n" << ran.err;
    }
    const auto json = nlohmann::json::parse(contentOf(folder / "p.smat"));
    const nlohmann::json today = {
        {"ambientReflection", "off"}, {"hotSpots", false}, {"supersampling", "perPixel"}};
    EXPECT_EQ(json["render"], today);
    EXPECT_EQ(json["analyses"]["a"]["render"]["ambientReflection"], "approx");
    EXPECT_EQ(smatBatch({"project", "set", "p.smat", "0", "--altitude", "600"}, folder.path()).err,
              "");
}

TEST(FormerNames, BesideThoseOfTodayAreRefused) {
    const TemporaryFolder folder;
    writeProject(folder / "p.smat", R"("render": {"fluxes": "off", "ambientReflection": "smart"})");
    const Ran ran = smatBatch({"image", "p.smat", "--out", "a.exr"}, folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.err, HasSubstr("render.fluxes"));
    EXPECT_THAT(ran.err, HasSubstr("expected nothing beside render.ambientReflection"));
}

TEST(FormerNames, OfOptionsValuesAndSettingsAreReadWithOneRemark) {
    const TemporaryFolder folder;
    const Ran ran =
        smatBatch({"image", box, "--width", "8", "--height", "4", "--hot-parts", "false",
                   "--fluxes=off", "--set", "render.referenceAir=segment", "--out", "a.csv"},
                  folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    for (const char* remark :
         {"--hot-parts is called --hot-spots now", "--fluxes is called --ambient-reflection now",
          "render.referenceAir is called render.referenceTransmittance now"}) {
        EXPECT_EQ(countOf(remark, ran.err), 1u) << remark << "\n" << ran.err;
    }
    const std::string written = contentOf(folder / "a.csv");
    EXPECT_THAT(written, HasSubstr("# render.hotSpots: false"));
    EXPECT_THAT(written, HasSubstr("# render.ambientReflection: off"));
    EXPECT_THAT(written, HasSubstr("# render.referenceTransmittance: segment"));
}

TEST(FormerNames, OfAResultAreReadWhenItIsRunAgain) {
    const TemporaryFolder folder;
    std::filesystem::copy(sample("box"), folder / "box");
    ASSERT_EQ(smatBatch({"image", "box/box.smat", "--width", "8", "--height", "4",
                         "--ambient-reflection", "off", "--out", "box/a.csv"},
                        folder.path())
                  .exitCode,
              0);
    std::string text = contentOf(folder / "box/a.csv");
    const std::string today = "# render.ambientReflection: off";
    ASSERT_NE(text.find(today), std::string::npos) << text;
    text.replace(text.find(today), today.size(), "# render.fluxes: off");
    write(folder / "box/a.csv", text);
    const Ran ran = smatBatch({"replay", "box/a.csv", "--out", "again.csv"}, folder.path());
    EXPECT_EQ(ran.exitCode, 0) << ran.out << ran.err;
    EXPECT_EQ(countOf("render.fluxes is called render.ambientReflection now", ran.err), 1u)
        << ran.err;
    EXPECT_THAT(contentOf(folder / "again.csv"), HasSubstr(today));
}

TEST(FormerNames, OfACommandAndItsOptionAreReadWithOneRemark) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"--threads", "1", "frontier", box, "--ways", "likely", "--dry-run"},
                              folder.path());
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("frontier is called cost-accuracy now"));
    EXPECT_THAT(ran.err, HasSubstr("--ways is called --configurations now"));
    EXPECT_THAT(smatBatch({"--help"}).out, Not(HasSubstr("frontier")));
    EXPECT_THAT(smatBatch({"cost-accuracy", "--help"}).out, Not(HasSubstr("--ways")));
}

} // namespace
} // namespace smat::test

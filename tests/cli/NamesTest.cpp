// Names that are mistyped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

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
        MistypedRow{"AWordTooMany", image({"5"}), "found 5, expected no further argument"},
        MistypedRow{"ASetting", image({"--set", "sensor.widht=5"}),
                    "--set: sensor.widht: found 5, expected a setting that exists (smat-batch "
                    "settings lists them); did you mean 'sensor.width'?"},
        MistypedRow{"ASettingWithoutItsSection", image({"--set", "fov=5"}),
                    "did you mean 'sensor.fov'?"},
        MistypedRow{"AChoiceOfAnOption", image({"--sun", "smrt"}),
                    "expected off, approx or smart; did you mean 'smart'?"},
        MistypedRow{"AChoiceOfASetting", image({"--set", "render.supersampling=peraxs"}),
                    "expected perAxis or inAll; did you mean 'perAxis'?"},
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

} // namespace
} // namespace smat::test

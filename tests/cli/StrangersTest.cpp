#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/image/ExrFile.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

const std::string strangers = std::string(SMAT_SOURCE_DIR) + "/tests/data/strangers/";

/// A command on files that nobody here made, what it ends with and what it says.
struct Row {
    const char* name;
    std::vector<std::string> arguments;
    int exitCode = 0;
    const char* out = "";
    const char* err = "";
};
void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}
class FilesOfStrangers : public testing::TestWithParam<Row> {};

TEST_P(FilesOfStrangers, AreReadAsTheyAreMeantAndWhatWasTakenIsSaid) {
    const TemporaryFolder folder;
    const std::filesystem::path database = folder / "d.sigdb";
    std::vector<std::string> arguments = GetParam().arguments;
    if (arguments.front() == "db") {
        ASSERT_EQ(smatBatch({"db", "create", "d.sigdb"}, folder.path()).exitCode, 0);
    }
    for (std::string& argument : arguments) {
        if (argument.starts_with("@")) {
            argument.replace(0, 1, strangers);
        }
    }
    const Ran ran = smatBatch(arguments, folder.path());
    EXPECT_EQ(ran.exitCode, GetParam().exitCode) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr(GetParam().out));
    EXPECT_THAT(ran.err, HasSubstr(GetParam().err));
}

Row compared(const char* name, const char* a, const char* b, std::vector<std::string> more,
             const char* err, int exitCode = 0) {
    Row row{name, {"compare", a, b}, exitCode, exitCode == 0 ? "PASS" : "", err};
    row.arguments.insert(row.arguments.end(), more.begin(), more.end());
    return row;
}

Row imported(const char* name, const char* file, const char* kind, const char* err) {
    Row row{name, {"db", "import", file, "d.sigdb", "--as", kind}, 0, "", err};
    if (std::string(kind) == "material") {
        row.arguments.insert(row.arguments.end(), {"--material", "1"});
    }
    return row;
}

INSTANTIATE_TEST_SUITE_P(
    Of, FilesOfStrangers,
    testing::Values(
        compared("German", "@matrix-decimal-comma/german.csv", "@matrix-decimal-comma/english.csv",
                 {}, "german.csv: columns separated by semicolons, decimal commas"),
        compared("Tabs", "@matrix-decimal-comma/tabs.txt", "@matrix-decimal-comma/english.csv", {},
                 "tabs.txt: columns separated by tabs, decimal commas"),
        compared("PartWithRadiance", "@multipart-exr/depth-first.exr",
                 "@multipart-exr/radiance.exr", {}, "depth-first.exr: holds 2 parts"),
        compared("PartByNumber", "@multipart-exr/depth-first.exr", "@multipart-exr/radiance.exr",
                 {"--part-a", "2"}, ""),
        compared("PartThatIsAnother", "@multipart-exr/depth-first.exr",
                 "@multipart-exr/radiance.exr", {"--part", "1"}, "", 2),
        compared("PageByNumber", "@multipage-tiff/two.tif", "@multipage-tiff/one.tif",
                 {"--page", "1"}, ""),
        compared("PageUnasked", "@multipage-tiff/two.tif", "@multipage-tiff/one.tif", {},
                 "two.tif: holds 2 pages"),
        compared("PageThatIsAnother", "@multipage-tiff/two.tif", "@multipage-tiff/one.tif",
                 {"--page-a", "2"}, "", 2),
        compared("PageOfNoPages", "@image-forms/plain.csv", "@image-forms/plain.csv",
                 {"--page", "1"}, "--page: found 1", 2),
        compared("CameraHeadLines", "@image-forms/camera-head-lines.csv", "@image-forms/plain.csv",
                 {}, "are left out as head lines"),
        compared("Envi", "@image-forms/envi.hdr", "@image-forms/plain.csv", {}, ""),
        compared("EnviData", "@image-forms/envi.img", "@image-forms/plain.csv", {}, ""),
        compared("Fortran", "@image-forms/fortran-d.txt", "@image-forms/plain.csv", {}, "blanks"),
        compared("Grid", "@image-forms/grid.asc", "@image-forms/plain.csv", {}, ""),
        compared("FloatMap", "@image-forms/grid.pfm", "@image-forms/plain.csv", {}, ""),
        compared("NumPy", "@image-forms/matrix.npy", "@image-forms/plain.csv", {}, ""),
        compared("Quoted", "@image-forms/quoted.csv", "@image-forms/plain.csv", {}, ""),
        Row{"AirOfASpreadsheet",
            {"radiative", "@air-csv-saved-by-spreadsheet/libre.csv", "--quantity", "transmittance",
             "--sensor-altitude", "0", "--los-elevation", "0", "--range", "1000", "--out",
             "t.csv"}},
        imported("RadiancePerNanometre", "@radiance-per-nm/rad_w_nm.csv", "spectrum", ""),
        imported("RadisHeads", "@radiance-per-nm/radis.csv", "spectrum", ""),
        imported("Dirsig", "@material-forms/dirsig.ems", "material", "DIRSIG .ems"),
        imported("Ecostress", "@material-forms/ecostress.spectrum.txt", "material", "ECOSTRESS"),
        imported("Excel", "@material-forms/excel_bom_semicolon.csv", "material", "semicolons"),
        imported("Jcamp", "@material-forms/jcamp.jdx", "material", "JCAMP-DX"),
        imported("OverOne", "@material-forms/over1.csv", "material", "1.003"),
        imported("RefractiveIndex", "@material-forms/rii.yml", "material", "Fresnel"),
        imported("Usgs", "@material-forms/usgs.asc", "material", "USGS")),
    [](const auto& row) { return row.param.name; });

TEST(StrangersImages, ColoursAreComparedWithOurRadianceByTheirChannel) {
    const TemporaryFolder folder;
    const std::string colours = strangers + "rgb-against-l/rgb.exr";
    const irsg::RadianceImage rgb = irsg::readExr(colours);
    irsg::RadianceImage ours(rgb.width(), rgb.height());
    ours.primary().values = rgb.find("R")->values;
    irsg::writeExr(ours, folder / "ours.exr");
    const Ran named = smatBatch({"compare", "ours.exr", colours, "--channel", "R"}, folder.path());
    EXPECT_EQ(named.exitCode, 0) << named.out << named.err;
    EXPECT_THAT(named.err, HasSubstr("has no channel 'R'; its 'L' is compared with it"));
    const Ran each = smatBatch(
        {"compare", "ours.exr", colours, "--channel-a", "L", "--channel-b", "R"}, folder.path());
    EXPECT_EQ(each.exitCode, 0) << each.out << each.err;
    EXPECT_EQ(each.err, "");
}

} // namespace
} // namespace smat::test

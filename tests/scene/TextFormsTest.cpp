#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/conversion/ModelNames.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/model/PlacingGuess.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/text/ModelText.h"
#include "irsg/geometry/reading/text/UnitWords.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/TwoPlates.h"
#include "tests/support/WalkedReaders.h"

using namespace irsg;
using namespace irsg::test;
using smat::test::ownFolder;
using smat::test::refusalOf;
using smat::test::writtenFile;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
namespace fs = std::filesystem;

namespace {

fs::path stranger(const std::string& name) {
    return fs::path(SMAT_SOURCE_DIR) / "tests/data/strangers" / name;
}

double areaOf(const fs::path& file) {
    double area_m2 = 0.0;
    const auto model = Model::load(file);
    for (const auto& [codes, use] : model->codes()) {
        area_m2 += use.area_m2;
    }
    return area_m2;
}

/// The area of a text as a model of this extension, 0 with a message where it is refused.
double areaOf(const std::string& extension, const std::string& text) {
    try {
        return areaOf(writtenFile(ownFolder() / ("a." + extension), text));
    } catch (const InputError& error) {
        ADD_FAILURE() << extension << ": " << error.what();
        return 0.0;
    }
}

std::vector<std::string> namesOfKind(const fs::path& file, std::size_t kind) {
    std::vector<std::string> names;
    const ModelNames all = namesOf(file, ModelCodes());
    for (const auto& [name, faces] : all.names[kind]) {
        names.push_back(name);
    }
    return names;
}

std::string withEnds(const std::string& text, const std::string& end) {
    std::string changed;
    for (const char c : text) {
        c == '\n' ? changed += end : changed += c;
    }
    return changed;
}

/// ASCII in units of so many bytes behind their mark.
std::string wide(const std::string& text, std::size_t unit_B, bool bigEndian) {
    std::string bytes;
    const auto add = [&](unsigned int c) {
        for (std::size_t i = 0; i < unit_B; ++i) {
            const std::size_t place = bigEndian ? unit_B - 1 - i : i;
            bytes += static_cast<char>(place < 4 ? c >> 8 * place & 0xFF : 0);
        }
    };
    add(0xFEFF);
    for (const char c : text) {
        add(static_cast<unsigned char>(c));
    }
    return bytes;
}

struct Form {
    const char* name;
    std::function<std::string(const std::string&)> made;
};
const std::vector<Form> forms = {
    {"as it is", [](const std::string& text) { return text; }},
    {"a mark of UTF-8", [](const std::string& text) { return "\xEF\xBB\xBF" + text; }},
    {"UTF-16, little endian", [](const std::string& text) { return wide(text, 2, false); }},
    {"UTF-16, big endian", [](const std::string& text) { return wide(text, 2, true); }},
    {"UTF-32, little endian", [](const std::string& text) { return wide(text, 4, false); }},
    {"lines of DOS", [](const std::string& text) { return withEnds(text, "\r\n"); }},
    {"lines of DOS and its end",
     [](const std::string& text) { return withEnds(text, "\r\n") + "\x1A"; }},
    {"lines of the first Macintosh", [](const std::string& text) { return withEnds(text, "\r"); }},
    {"a mark and lines of DOS",
     [](const std::string& text) { return "\xEF\xBB\xBF" + withEnds(text, "\r\n"); }}};

} // namespace

TEST(TextForms, AreAlikeInEveryFormat) {
    for (const auto& [extension, text] : twoPlates()) {
        for (const Form& form : forms) {
            EXPECT_NEAR(areaOf(extension, form.made(text)), 5.0, 1e-5)
                << extension << " with " << form.name;
        }
    }
}

TEST(WalkedReaders, OfTextsAreAsManyAsThePageHas) {
    using smat::test::expectWalked;
    expectWalked("marks of byte order, encodings and line ends of models", twoPlates().size());
    expectWalked("encodings and line ends that each of them has", forms.size());
}

TEST(TextForms, AreThoseOfAllFormatsThatHaveATextForm) {
    // Models that are numbers alone have no such row.
    for (const FileFormat& format : formatsOf(FileKind::model)) {
        EXPECT_EQ(hasTextForm(format.extension), twoPlates().contains(format.extension))
            << format.extension;
    }
}

TEST(TextForms, HaveExponentsAsFortranWritesThemInOurOwnFormats) {
    // All that is 1 in a triangle with sides of 1, 1 and the root of 2.
    const std::map<std::string, std::string> triangles = {
        {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"},
        {"ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"dxf", "0\nSECTION\n2\nENTITIES\n0\n3DFACE\n8\na\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n"
                "31\n0\n12\n0\n22\n1\n32\n0\n13\n0\n23\n1\n33\n0\n0\nENDSEC\n0\nEOF\n"}};
    const std::map<std::string, std::array<const char*, 2>> ones = {
        {"obj", {"v 1 0", "v 0 1"}},
        {"stl", {"vertex 1", "vertex 0 1"}},
        {"ply", {"\n1 0 0", "\n0 1 0"}},
        {"dxf", {"11\n1", "22\n1"}}};
    smat::test::expectWalked("exponents as Fortran writes them in models", triangles.size());
    for (const auto& [extension, text] : triangles) {
        std::string changed = text;
        for (const std::string one : ones.at(extension)) {
            std::string other = one;
            other.replace(other.rfind('1'), 1, "0.1D+01");
            ASSERT_NE(changed.find(one), changed.npos);
            changed.replace(changed.find(one), one.size(), other);
        }
        EXPECT_NEAR(areaOf(extension, changed), 0.5, 1e-6) << changed;
        const fs::path bad = ownFolder() / ("bad." + extension);
        std::string wrong = changed;
        wrong.replace(wrong.find("0.1D+01"), 7, "0.1D1D1");
        writtenFile(bad, wrong);
        EXPECT_THAT(refusalOf([&] { Model::load(bad); }), HasSubstr("0.1D1D1"));
    }
}

TEST(TextForms, KeepNumbersOfLines) {
    EXPECT_EQ(plainText("a\r\nb\rc\n\rd", "a"), "a\nb\nc\n\nd");
    EXPECT_EQ(plainText("\xEF\xBB\xBF", "a"), "");
    EXPECT_EQ(plainText("a\x1A", "a"), "a");
}

TEST(TextForms, RefuseWhatIsNoTextOfTheirEncoding) {
    using namespace std::string_literals;
    EXPECT_EQ(plainText("\xFF\xFE\x3D\xD8\x00\xDE"
                        "A\0"s,
                        "a"),
              "\xF0\x9F\x98\x80"
              "A");
    EXPECT_THAT(refusalOf([] { plainText("\xFF\xFE\x41"s, "a.obj"); }),
                AllOf(HasSubstr("a.obj: byte 2"), HasSubstr("UTF-16")));
    EXPECT_THAT(refusalOf([] { plainText("\xFF\xFE\x3D\xD8"s, "a.obj"); }),
                AllOf(HasSubstr("byte 2"), HasSubstr("a character that there is not")));
}

TEST(TextForms, HaveTheirWordsInAnyCaseWhereTheFormatSays) {
    EXPECT_NEAR(areaOf(stranger("upper.stl")), 22.0, 1e-5);
    EXPECT_THAT(namesOfKind(stranger("upper.stl"), 1), Contains("HULL"));
    std::string mixed = twoPlates().at("stl");
    for (const auto& [from, to] : {std::pair{"solid", "Solid"},
                                   {"facet", "FaCet"},
                                   {"vertex", "VERTEX"},
                                   {"endsolid", "EndSolid"}}) {
        for (auto at = mixed.find(from); at != mixed.npos; at = mixed.find(from, at + 1)) {
            mixed.replace(at, std::string(from).size(), to);
        }
    }
    EXPECT_NEAR(areaOf("stl", mixed), 5.0, 1e-5);
}

TEST(TextForms, KeepNamesOfPartsInEveryFormat) {
    const std::map<std::string, std::size_t> withoutNames = {{"ply", 0}};
    const std::map<std::string, std::size_t> withoutMaterials = {
        {"ply", 0}, {"stl", 0}, {"dxf", 0}, {"dae", 0}, {"fbx", 0}};
    for (const auto& [extension, text] : twoPlates()) {
        const fs::path file = writtenFile(ownFolder() / ("a." + extension), text);
        std::vector<std::string> parts;
        for (const std::size_t kind : {1u, 2u}) {
            for (const std::string& name : namesOfKind(file, kind)) {
                parts.push_back(name);
            }
        }
        if (!withoutNames.contains(extension) && extension != "dae" && extension != "fbx") {
            EXPECT_THAT(parts, IsSupersetOf({"Hull", "Exhaust"})) << extension;
        }
        if (!withoutMaterials.contains(extension)) {
            EXPECT_THAT(namesOfKind(file, 0), IsSupersetOf({"PaintGrey", "HotPipe"})) << extension;
        }
    }
    EXPECT_THAT(namesOfKind(writtenFile(ownFolder() / "a.x", twoPlates().at("x")), 1),
                testing::ElementsAre("ExhaustMesh", "HullMesh"));
    const fs::path file = stranger("two-materials.x");
    EXPECT_THAT(namesOfKind(file, 0), IsSupersetOf({"PaintGrey", "HotPipe"}));
    EXPECT_THAT(namesOfKind(file, 1), testing::ElementsAre("HullMesh"));
    EXPECT_THAT(namesOfKind(file, 2), testing::ElementsAre("Hull", "HullMesh"));
    EXPECT_NEAR(areaOf(file), 2.0, 1e-6);
}

TEST(X, FollowsItsFramesWithNumbersInAnyForm) {
    std::string text = twoPlates().at("x");
    const std::string frame = "Frame Exhaust {\n";
    // Five along x, six up, seven away from the viewer; whole numbers without blanks.
    text.replace(text.find(frame), frame.size(),
                 frame + "FrameTransformMatrix {\n1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1;;\n}\n");
    const auto box = Model::load(writtenFile(ownFolder() / "a.x", text))->bounds();
    EXPECT_NEAR(box.max.x, 8.0, 1e-6);
    EXPECT_NEAR(box.max.y, 8.0, 1e-6);
    EXPECT_NEAR(box.max.z, 7.0, 1e-6);
}

TEST(TextForms, OfStrangersAreReadAsTheyAreMeant) {
    EXPECT_NEAR(areaOf(stranger("without-mark.obj")), 6.0, 1e-6);
    EXPECT_NEAR(areaOf(stranger("with-mark.obj")), 6.0, 1e-6);
    EXPECT_NEAR(areaOf(stranger("bom.ply")), 22.0, 1e-5);
    EXPECT_NEAR(areaOf(stranger("bom.stl")), 0.5, 1e-6);
    EXPECT_NEAR(areaOf(stranger("bomjson.gltf")), 22.0, 1e-5);
    EXPECT_NEAR(areaOf(stranger("twobom.ac")), 4.0, 1e-6);
    EXPECT_NEAR(areaOf(stranger("cr-only.obj")), 3.0, 1e-6);
    EXPECT_NEAR(areaOf(stranger("colour.dae")), 22.0, 1e-5);
    EXPECT_THAT(namesOfKind(stranger("colour.dae"), 0), Contains("paint"));
}

TEST(Collada, HasBlanksAndCommentsWhereXmlHasThem) {
    const std::string text = twoPlates().at("dae");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        const auto at = changed.find(from);
        EXPECT_NE(at, changed.npos) << from;
        return changed.replace(at, from.size(), to);
    };
    EXPECT_NEAR(areaOf("dae", with("<vcount>", "<vcount>\n\t ")), 5.0, 1e-5);
    EXPECT_NEAR(areaOf("dae", with("<p>", "<p>\n  ")), 5.0, 1e-5);
    EXPECT_NEAR(areaOf("dae", with("</p>", "\n\t</p>")), 5.0, 1e-5);
    EXPECT_NEAR(areaOf("dae", with("<p>", "<p><!-- corners -->")), 5.0, 1e-5);
    const auto graph =
        loadGraphAsIs(writtenFile(ownFolder() / "b.dae", with("<up_axis>", "<up_axis> \n")),
                      LoadPurpose::infrared);
    EXPECT_EQ(graph.axes.up, ModelAxis::plusZ);
}

TEST(Units, AreThoseThatAFileStates) {
    const auto model = Model::load(stranger("millimetres.dxf"));
    EXPECT_EQ(model->placing().unit_m, 0.001);
    EXPECT_THAT(placingGuess(stranger("millimetres.dxf")).reasons,
                Contains(HasSubstr("$INSUNITS 4 (millimetres)")));
    struct Row {
        const char* number;
        std::optional<double> unit_m;
    };
    for (const Row& row :
         {Row{"0", std::nullopt}, Row{"1", 0.0254}, Row{"2", 0.3048}, Row{"5", 0.01}, Row{"6", 1.0},
          Row{"7", 1000.0}, Row{"10", 0.9144}, Row{"14", 0.1}, Row{"13", 1e-6},
          Row{"18", std::nullopt}, Row{"99", std::nullopt}, Row{"-1", std::nullopt}}) {
        const std::string text = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" +
                                 std::string(row.number) + "\n0\nENDSEC\n" + twoPlates().at("dxf");
        const auto graph =
            loadGraphAsIs(writtenFile(ownFolder() / "a.dxf", text), LoadPurpose::infrared);
        EXPECT_EQ(graph.axes.unit_m, row.unit_m) << row.number;
        if (!row.unit_m && std::string(row.number) != "0") {
            EXPECT_THAT(graph.remarks, Contains(HasSubstr("$INSUNITS"))) << row.number;
        }
    }
}

TEST(Units, InCommentsAndNamesAreForTheGuessInEveryFormatThatHasThem) {
    const std::map<std::string, std::pair<std::string, std::string>> comments = {
        {"obj", {"", "# File units = millimeters\n"}},
        {"stl", {"solid Hull", "solid Hull units=mm"}},
        {"ply", {"format ascii 1.0\n", "format ascii 1.0\ncomment units: mm\n"}},
        {"dxf", {"", "999\nunits: millimetres\n"}},
        {"x", {"xof 0303txt 0032\n", "xof 0303txt 0032\n// all dimensions in mm\n"}}};
    for (const auto& [extension, change] : comments) {
        std::string text = twoPlates().at(extension);
        text.replace(text.find(change.first), change.first.size(), change.second);
        const fs::path file = writtenFile(ownFolder() / ("a." + extension), text);
        const auto graph = loadGraphAsIs(file, LoadPurpose::infrared);
        ASSERT_TRUE(graph.axes.spokenUnit) << extension;
        EXPECT_EQ(graph.axes.spokenUnit->unit_m, 0.001) << extension;
        EXPECT_EQ(Model::load(file)->placing().unit_m, 1.0) << extension;
    }
    const auto guess = placingGuess(stranger("millimetres-in-comment.obj"));
    EXPECT_EQ(guess.placing.unit_m, 0.001);
    EXPECT_THAT(guess.reasons, Contains(AllOf(HasSubstr("millimetres"), HasSubstr("comment"))));
}

TEST(Units, InWordsAreFoundBehindAWordThatAnnouncesThem) {
    struct Row {
        const char* line;
        double unit_m; ///< 0 for none
    };
    for (const Row& row :
         {Row{"# File units = millimeters", 0.001}, Row{"UNITS=mm", 0.001},
          Row{"Units: Inches", 0.0254}, Row{"all dimensions in metres", 1.0}, Row{"unit m", 1.0},
          Row{"1 unit = 0.01 m", 0.01}, Row{"1 unit = 10 mm", 0.01}, Row{"scale: feet", 0.3048},
          Row{"units in in", 0.0254}, Row{"units_cm", 0.01}, Row{"lengths are in km", 1000.0},
          Row{"units", 0.0}, Row{"made in Meter street", 0.0}, Row{"5 m long", 0.0},
          Row{"10 units per metre", 0.0}, Row{"units: mm to metres", 0.0},
          Row{"unit cube in the middle", 0.0}, Row{"", 0.0}}) {
        const auto found = unitInWords(row.line);
        EXPECT_EQ(found.has_value(), row.unit_m > 0.0) << row.line;
        if (found && row.unit_m > 0.0) {
            EXPECT_NEAR(found->unit_m, row.unit_m, 1e-12) << row.line;
        }
    }
}

TEST(Refusals, OfModelsWithoutFacesSayWhatWasLeftOut) {
    for (const auto& act : std::vector<std::function<void()>>{
             [] { Model::load(stranger("pages-only.osgt")); },
             [] { placingGuess(stranger("pages-only.osgt")); },
             [] { namesOf(stranger("pages-only.osgt"), ModelCodes()); }}) {
        EXPECT_THAT(refusalOf(act),
                    HasSubstr("refers to the page sq2.osgt, which is left out: pages "
                              "are not read"));
    }
    const fs::path lines =
        writtenFile(ownFolder() / "lines.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n11\n"
                                               "1\n0\n3DSOLID\n8\n0\n0\nENDSEC\n0\nEOF\n");
    EXPECT_THAT(refusalOf([&] { Model::load(lines); }),
                AllOf(HasSubstr("1 LINE have no faces"), HasSubstr("1 3DSOLID are left out")));
}

TEST(Ac3d, SaysWhatStandsBehindTheLastObjectThatIsCounted) {
    std::string text = twoPlates().at("ac");
    const double whole_m2 = areaOf("ac", text);
    text.replace(text.find("kids 2"), 6, "kids 1");
    const auto model = Model::load(writtenFile(ownFolder() / "a.ac", text));
    EXPECT_THAT(model->remarks(),
                Contains(HasSubstr("1 objects stand behind the last that the file counts")));
    EXPECT_LT(areaOf("ac", text), 0.9 * whole_m2);
}

TEST(Ac3d, TakesTabsForBlanksAndLinesThatAreIndented) {
    std::string text = twoPlates().at("ac");
    for (std::size_t at = 0; (at = text.find("kids ", at)) != text.npos; at += 7) {
        text.replace(at, 5, " \tkids\t");
    }
    for (std::size_t at = 0; (at = text.find("refs ", at)) != text.npos; at += 5) {
        text[at + 4] = '\t';
    }
    EXPECT_NEAR(areaOf("ac", text), 5.0, 1e-5);
}

TEST(Ac3d, ReadsAFileThatCountsMoreObjectsThanItHas) {
    std::string text = twoPlates().at("ac");
    for (const auto& [from, to] : {std::pair{"kids 2", "kids 3"}, {"kids 0", "kids 1"}}) {
        std::string changed = text;
        changed.replace(changed.rfind(from), 6, to);
        const auto model = Model::load(writtenFile(ownFolder() / "a.ac", changed));
        EXPECT_THAT(model->remarks(), Contains(HasSubstr("counts 1 more objects than it has")));
        EXPECT_NEAR(areaOf("ac", changed), 5.0, 1e-5) << to;
    }
}

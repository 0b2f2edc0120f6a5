#include <bit>
#include <cstdint>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/model/ModelConverter.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "tests/support/ForeignModels.h"
#include "tests/support/FormatFeatures.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg::test {
namespace {

namespace fs = std::filesystem;
using smat::test::ownFolder;
using smat::test::refusalOf;
using smat::test::writtenFile;
using testing::Contains;
using testing::HasSubstr;

const fs::path source = SMAT_SOURCE_DIR;
const std::vector<std::string> writtenKinds = {"osgt", "osgb", "ive", "osg", "osgx"};

template <typename Number>
std::string bigEndian(Number value) {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
    return std::endian::native == std::endian::little ? std::string(bytes.rbegin(), bytes.rend())
                                                      : bytes;
}
std::string chunk(const std::string& kind, const std::string& content) {
    return kind + bigEndian(static_cast<std::uint32_t>(content.size())) + content;
}
/// A plate of 2 m by 1 m as LightWave has it.
std::string lightWave() {
    std::string points, polygon = bigEndian(std::uint16_t{4});
    for (const float x : {0.f, 0.f, 0.f, 2.f, 0.f, 0.f, 2.f, 1.f, 0.f, 0.f, 1.f, 0.f}) {
        points += bigEndian(x);
    }
    for (const int corner : {0, 1, 2, 3, 1}) { // the last is the surface
        polygon += bigEndian(static_cast<std::uint16_t>(corner));
    }
    return chunk("FORM", "LWOB" + chunk("PNTS", points) + chunk("SRFS", std::string("paint\0", 6)) +
                             chunk("POLS", polygon));
}

double areaOf(const Model& model) {
    double area_m2 = 0.0;
    for (const auto& [codes, use] : model.codes()) {
        area_m2 += use.area_m2;
    }
    return area_m2;
}

void expectSame(const Model& before, const Model& after) {
    EXPECT_NEAR(areaOf(after), areaOf(before), 1e-5 * areaOf(before));
    const double may_m = 1e-5 * before.bounds().diagonal_m();
    for (const auto& [one, other] : {std::pair{before.bounds().min, after.bounds().min},
                                     std::pair{before.bounds().max, after.bounds().max}}) {
        EXPECT_NEAR(length(one - other), 0.0, may_m);
    }
    for (const auto& [codes, use] : before.codes()) {
        if (use.area_m2 > 0.0) {
            ASSERT_TRUE(after.codes().contains(codes));
            EXPECT_NEAR(after.codes().at(codes).area_m2, use.area_m2, 1e-5 * use.area_m2);
        }
    }
}

/// Files of every format that is read: those of the tables of features that are followed, and one
/// of each format that has no table.
struct ReadFile {
    std::string name;
    fs::path file;
};
std::vector<ReadFile> filesOfEveryFormat() {
    std::vector<ReadFile> all;
    int count = 0;
    for (const FormatFeature& feature : allFeatures()) {
        if (feature.outcome != Outcome::followed) {
            continue;
        }
        const fs::path folder = ownFolder() / std::to_string(count++);
        for (const auto& [name, bytes] : feature.beside) {
            writtenFile(folder / name, bytes);
        }
        all.push_back({feature.format + ", " + feature.feature,
                       writtenFile(folder / feature.name, feature.bytes)});
    }
    all.push_back({"OpenFlight", source / "samples/box/box.flt"});
    all.push_back({"packed glTF", writtenFile(ownFolder() / "a.glb", smallAircraft().binary())});
    all.push_back({"LightWave", writtenFile(ownFolder() / "a.lwo", lightWave())});
    for (const std::string& kind : writtenKinds) {
        const fs::path file = ownFolder() / ("box." + kind);
        convertModel(source / "samples/box/box.flt", file);
        all.push_back({kind, file});
    }
    return all;
}

} // namespace

TEST(ConvertedUnits, AColladaInInchesBecomesMetresWithItsNoseAlongY) {
    ColladaWriter collada;
    collada.up = "<up_axis>Y_UP</up_axis>";
    // 10 inches to starboard (x), 30 up (y), 20 forward (z), an L in each of two planes.
    collada.corners = {{0, 0, 0}, {10, 0, 0}, {10, 30, 0}, {0, 30, 0}, {0, 0, 20}, {0, 30, 20}};
    collada.polygons = {{0, 1, 2, 3}, {0, 3, 5, 4}};
    const fs::path in = writtenFile(ownFolder() / "a.dae", collada.text());
    for (const std::string& kind : writtenKinds) {
        SCOPED_TRACE(kind);
        const fs::path out = ownFolder() / ("a." + kind);
        const ConversionReport report = convertModel(in, out);
        const auto model = Model::load(out);
        EXPECT_NEAR(areaOf(*model), (10 * 30 + 20 * 30) * 0.0254 * 0.0254, 1e-6);
        const Vec3 size = model->bounds().max - model->bounds().min;
        EXPECT_NEAR(size.x, 0.254, 1e-6);
        EXPECT_NEAR(size.y, 0.508, 1e-6);
        EXPECT_NEAR(size.z, 0.762, 1e-6);
        EXPECT_THAT(report.remarks,
                    Contains(testing::AllOf(HasSubstr("written in metres"), HasSubstr("inches"),
                                            HasSubstr("up +y, nose +z"), HasSubstr("." + kind))));
        EXPECT_EQ(report.placing.unit_m, 0.0254);
        // What is written is in metres already: nothing is scaled again.
        const fs::path again = ownFolder() / ("b." + kind);
        convertModel(out, again);
        expectSame(*model, *Model::load(again));
    }
}

TEST(ConvertedUnits, AreaAndExtentOfEveryFormatStayInEveryOther) {
    std::set<std::string> walked, firstOf;
    std::size_t turn = 0;
    for (const ReadFile& read : filesOfEveryFormat()) {
        SCOPED_TRACE(read.name);
        const std::string extension = read.file.extension().string().substr(1);
        walked.insert(extension);
        const auto before = Model::load(read.file);
        // One file of each format goes into all kinds, the others take turns.
        const bool isFirst = firstOf.insert(extension).second;
        const std::vector<std::string> kinds =
            isFirst ? writtenKinds : std::vector{writtenKinds[turn++ % writtenKinds.size()]};
        for (const std::string& kind : kinds) {
            SCOPED_TRACE(kind);
            const fs::path out = ownFolder() / ("out." + kind);
            convertModel(read.file, out);
            expectSame(*before, *Model::load(out));
        }
    }
    for (const FileFormat& format : formatsOf(FileKind::model)) {
        EXPECT_TRUE(walked.contains(format.extension)) << format.extension;
    }
}

TEST(ConvertedUnits, UnitAndAxesThatAreGivenWinOverTheFile) {
    ColladaWriter collada;
    collada.corners = boxCorners(1, 2, 3);
    collada.polygons = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}};
    const fs::path dae = writtenFile(ownFolder() / "a.dae", collada.text());
    const fs::path stl = writtenFile(
        ownFolder() / "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 "
                               "0\nvertex 2 1 3\nendloop\nendfacet\nendsolid a\n");
    const struct {
        const char* name;
        fs::path in;
        ModelPlacing placing;
    } rows[] = {{"feet", dae, {.unit_m = 0.3048}},
                {"millimetres of no unit", stl, {.unit_m = 0.001}},
                {"y up", stl, {.up = ModelAxis::plusY}},
                {"x up", stl, {.up = ModelAxis::plusX}},
                {"upside down", dae, {.up = ModelAxis::minusZ, .nose = ModelAxis::minusX}},
                {"all", stl, {ModelAxis::minusY, ModelAxis::plusX, 1000.0, {}}}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const fs::path out = ownFolder() / "out.osgb";
        const ConversionReport report = convertModel(row.in, out, {}, {.placing = row.placing});
        const auto before = Model::load(row.in, {.placing = row.placing});
        expectSame(*before, *Model::load(out));
        EXPECT_EQ(report.placing, before->placing());
    }
}

TEST(ConvertedUnits, RemarksStateWhatTheFileLeavesOpenAndNothingElse) {
    const auto remarks = [](const fs::path& in, const ModelPlacing& placing = {}) {
        std::string all;
        for (const std::string& remark :
             convertModel(in, ownFolder() / "out.osgb", {}, {.placing = placing}).remarks) {
            all += remark + "\n";
        }
        return all;
    };
    const fs::path ply =
        writtenFile(ownFolder() / "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty "
                                           "float x\nproperty float y\nproperty float z\nelement "
                                           "face 1\nproperty list uchar int vertex_indices\n"
                                           "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    EXPECT_THAT(remarks(ply), HasSubstr("does not state its unit, up axis or nose axis: taken as "
                                        "metres, up +z, nose +y"));
    EXPECT_THAT(remarks(ply, {.unit_m = 0.01}),
                testing::AllOf(HasSubstr("state its up axis or nose axis: taken as up +z, nose +y"),
                               HasSubstr("as read it is in centimetres")));
    EXPECT_THAT(remarks(ply, {.up = ModelAxis::plusY, .unit_m = 1.0}),
                HasSubstr("state its nose axis: taken as nose +z"));
    EXPECT_EQ(remarks(ply, {ModelAxis::plusZ, ModelAxis::plusY, 1.0, {}}), "");
    EXPECT_EQ(remarks(source / "samples/box/box.flt"), "") << "the format is in metres, z up";
    EXPECT_THAT(remarks(writtenFile(ownFolder() / "a.glb", smallAircraft().binary())),
                testing::AllOf(HasSubstr("written in metres"), HasSubstr("glTF"),
                               testing::Not(HasSubstr("does not state"))));
}

TEST(ConvertedUnits, APlacingThatCannotBeIsRefusedAndNothingWritten) {
    const fs::path in = source / "samples/box/box.flt", out = ownFolder() / "a.osgb";
    EXPECT_THAT(refusalOf([&] {
                    convertModel(in, out, {},
                                 {.placing = {.up = ModelAxis::plusY, .nose = ModelAxis::minusY}});
                }),
                HasSubstr("-y with +y up"));
    EXPECT_THAT(refusalOf([&] { convertModel(in, out, {}, {.placing = {.unit_m = 0.0}}); }),
                HasSubstr("metres from 1e-6 to 1e6"));
    EXPECT_THROW(convertModel(in, out, {}, {.placing = {.origin = ModelOrigin{}}}), LogicError);
    EXPECT_FALSE(fs::exists(out));
}

} // namespace irsg::test

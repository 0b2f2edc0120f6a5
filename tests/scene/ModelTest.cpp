#include "irsg/geometry/model/Model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osgDB/WriteFile>

#include "irsg/geometry/flight/FlightScanner.h"
#include "tests/support/FlightBytes.h"
#include "tests/support/ModelAccess.h"

using namespace irsg;
using namespace irsg::test;
namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

namespace {

const fs::path source = SMAT_SOURCE_DIR;
const fs::path data = source / "tests/data/models";

} // namespace

TEST(Model, OfTheBoxHasItsAreasBoundsAndCodes) {
    const auto model = Model::load(source / "samples/box/box.flt");
    const std::map<IrCodes, CodeUse> expected{{{1, 1}, {1, 2.0}}, {{2, 1}, {1, 2.0}},
                                              {{3, 1}, {1, 4.0}}, {{4, 1}, {1, 4.0}},
                                              {{5, 1}, {1, 8.0}}, {{6, 1}, {1, 8.0}}};
    EXPECT_EQ(model->codes(), expected);
    EXPECT_EQ(model->bounds(), (BoundingBox{{-1, -2, -0.5}, {1, 2, 0.5}}));
    EXPECT_EQ(model->name(), "box");
    EXPECT_TRUE(model->remarks().empty());
    const Vec3 normals[] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
    ASSERT_EQ(parts(*model), 6u);
    for (unsigned int i = 0; i < 6; ++i) {
        EXPECT_EQ(fromOsg(faceNormal(partOf(*model, i), 0)), normals[i]);
        EXPECT_EQ(partOf(*model, i).codes, (IrCodes{static_cast<int>(i) + 1, 1}));
    }
}

TEST(Model, OfTheSphereHasTheAreaOfItsZones) {
    // A zone between two parallels of a latitude-longitude mesh is a ring of flat trapezia.
    constexpr int rings = 128, segments = 256;
    double area = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double t0 = std::numbers::pi * i / rings, t1 = std::numbers::pi * (i + 1) / rings;
        const double half = std::sin(std::numbers::pi / segments);
        const double w0 = 2 * std::sin(t0) * half, w1 = 2 * std::sin(t1) * half;
        const double side = 2 * std::sin(0.5 * (t1 - t0));
        const double height = std::sqrt(side * side - 0.25 * (w1 - w0) * (w1 - w0));
        area += segments * 0.5 * (w0 + w1) * height;
    }
    const auto model = Model::load(source / "samples/sphere/sphere.flt");
    ASSERT_EQ(model->codes().size(), 1u);
    EXPECT_NEAR(model->codes().at({1, 1}).area_m2, area, single * area);
    EXPECT_LT(area, 4 * std::numbers::pi);

    // Normals are those of the sphere, outward, and no facet looks inward.
    const Mesh::Part& part = partOf(*model, 0);
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
        ASSERT_LT(length(toVec3(part.vertices[i]) - toVec3(part.normals[i])), single);
    }
    for (std::size_t i = 0; i < part.triangles.size() / 3; ++i) {
        ASSERT_GT(faceNormal(part, i) * toOsg(part.vertices[part.triangles[3 * i]]), 0.999);
    }
}

TEST(Model, HasAMeshWhosePartsAndPiecesHoldTogether) {
    for (const char* name : {"tricky_1420.flt", "tricky_1540.flt", "tricky_1640.flt"}) {
        SCOPED_TRACE(name);
        const auto model = Model::load(data / name);
        const Mesh& mesh = *model->mesh();
        EXPECT_EQ(mesh.bounds, model->bounds());
        EXPECT_TRUE(std::ranges::is_sorted(mesh.parts, [](const auto& a, const auto& b) {
            return static_cast<const Mesh::Kind&>(a) < static_cast<const Mesh::Kind&>(b);
        }));
        std::vector<std::size_t> inPieces(mesh.parts.size());
        for (const Mesh::Piece& piece : mesh.pieces) {
            EXPECT_EQ(piece.first, inPieces.at(piece.part)) << "pieces follow each other";
            inPieces[piece.part] += piece.count;
        }
        for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
            const Mesh::Part& part = mesh.parts[i];
            EXPECT_EQ(part.normals.size(), part.vertices.size());
            EXPECT_TRUE(part.texturePlaces.empty());
            EXPECT_FALSE(part.triangles.empty());
            EXPECT_EQ(part.triangles.size() % 3, 0u);
            EXPECT_EQ(part.triangles.size(), inPieces[i]);
            EXPECT_LT(*std::ranges::max_element(part.triangles), part.vertices.size());
            for (const Float3& normal : part.normals) {
                EXPECT_NEAR(length(toVec3(normal)), 1.0, single);
            }
            for (const Float3& vertex : part.vertices) {
                EXPECT_LE(length(toVec3(vertex) - mesh.sphere.centre_m), mesh.sphere.radius_m);
            }
        }
    }
}

TEST(Model, HasTheCodesOfTheFileWithTheirFaces) {
    std::vector<fs::path> files{data / "tricky_1420.flt", data / "tricky_1540.flt",
                                data / "tricky_1640.flt", data / "plate.flt"};
    if (!sharedModels().empty()) {
        for (const auto& entry : fs::recursive_directory_iterator(sharedModels())) {
            if (entry.path().extension() == ".flt") {
                files.push_back(entry.path());
            }
        }
    }
    for (const auto& file : files) {
        SCOPED_TRACE(file.string());
        const auto model = Model::load(file);
        std::map<IrCodes, int> faces;
        for (const auto& [codes, use] : model->codes()) {
            faces[codes] = use.faces;
        }
        EXPECT_EQ(faces, scanFlight(file).faceCounts());
        EXPECT_TRUE(model->bounds().valid());
        EXPECT_GT(parts(*model), 0u);
    }
}

TEST(Model, OfTheTrickyFileHasKnownAreas) {
    const auto codes = Model::load(data / "tricky_1640.flt")->codes();
    EXPECT_NEAR(codes.at({105, 205}).area_m2, 6.0, single) << "concave, cut into ears";
    EXPECT_EQ(codes.at({106, 206}), (CodeUse{1, 0.0})) << "hidden";
    EXPECT_EQ(codes.at({107, 207}), (CodeUse{1, 0.0})) << "a line";
    EXPECT_NEAR(codes.at({109, 209}).area_m2, 9.0, single) << "a face below its subfaces";
    EXPECT_NEAR(codes.at({113, 213}).area_m2, 2.0, single) << "an instance placed twice";
    EXPECT_NEAR(codes.at({114, 214}).area_m2, 1.0, single) << "the near level of detail";
    EXPECT_EQ(codes.at({116, 216}), (CodeUse{1, 0.0})) << "the far level of detail";
    EXPECT_NEAR(codes.at({501, 601}).area_m2, 2.0, single) << "a file referred to twice";
    EXPECT_NEAR(codes.at({302, 402}).area_m2, 3.15 * 3.15, 1e-5) << "a mesh of 64 KiB and more";
    EXPECT_NEAR(codes.at({-1, -2}).area_m2, 1.0, single);
    EXPECT_NEAR(codes.at({2147483647, -2147483647 - 1}).area_m2, 1.0, single);
}

TEST(Model, SaysWhatItOverrides) {
    const auto remarks = Model::load(data / "tricky_1640.flt")->remarks();
    EXPECT_THAT(remarks, Contains(HasSubstr("range LODs are overridden")));
    EXPECT_THAT(remarks, Contains(HasSubstr("hidden polygons stay hidden")));
    EXPECT_THAT(remarks, Contains(HasSubstr("only the first copy appears")));
    EXPECT_THAT(remarks, Contains(HasSubstr("lines and points")));
}

TEST(Model, LoadedTwiceIsEqual) {
    const auto one = Model::load(data / "tricky_1640.flt");
    const auto two = Model::load(data / "tricky_1640.flt");
    EXPECT_NE(one->mesh(), two->mesh());
    EXPECT_EQ(one->codes(), two->codes());
    ASSERT_EQ(parts(*one), parts(*two));
    for (std::size_t i = 0; i < parts(*one); ++i) {
        const Mesh::Part &a = partOf(*one, i), &b = partOf(*two, i);
        EXPECT_EQ(static_cast<const Mesh::Kind&>(a), static_cast<const Mesh::Kind&>(b));
        EXPECT_EQ(a.vertices, b.vertices);
        EXPECT_EQ(a.normals, b.normals);
        EXPECT_EQ(a.triangles, b.triangles);
    }
}

TEST(Model, PrintsNothing) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    Model::load(data / "tricky_1640.flt");
    const TemporaryFolder folder;
    refusal([&] { Model::load(folder.write("x.osgt", "not a scene")); });
    refusal([&] { Model::load(folder.write("x.ive", "not a scene")); });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Model, CullsBackFacesOfDrawTypeZeroOnly) {
    const TemporaryFolder folder;
    for (const auto& [drawType, culled] : {std::pair{0, true}, {1, false}, {4, false}}) {
        SquareFile file;
        file.drawType = drawType;
        file.remake();
        const auto path = folder.write("square.flt", file.bytes());
        EXPECT_EQ(partOf(*Model::load(path), 0).culled, culled) << drawType;
        EXPECT_FALSE(partOf(*Model::load(path, {.forceTwoSided = true}), 0).culled) << drawType;
    }
}

TEST(Model, KeepsTheNormalsOfUnlitFacesAndMakesThoseOfBareVertices) {
    const TemporaryFolder folder;
    SquareFile file;
    file.lightMode = 0;
    file.remake();
    const std::string tilted = f32(0.6f) + f32(0) + f32(0.8f);
    for (std::size_t i = 0; i < 4; ++i) {
        file.vertices.replace(56 * i + 32, 12, tilted);
    }
    const auto unlit = Model::load(folder.write("unlit.flt", file.bytes()));
    EXPECT_NEAR(partOf(*unlit, 0).normals[0][0], 0.6, single);

    SquareFile bare;
    bare.vertices = "";
    for (const auto& [x, z] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
        bare.vertices += record(flight::vertexC, zeros(4) + f64(x) + f64(0) + f64(z) + zeros(8));
    }
    bare.palette = record(flight::vertexPalette, i32(8 + 4 * 40));
    bare.list = record(flight::vertexList, i32(8) + i32(48) + i32(88) + i32(128));
    const auto upright = Model::load(folder.write("bare.flt", bare.bytes()));
    EXPECT_NEAR(partOf(*upright, 0).normals[0][1], -1.0, single);
}

TEST(Model, RefusesWhatIsNoModelWithASentence) {
    const TemporaryFolder folder;
    SquareFile empty;
    empty.face = empty.pushFace = empty.list = empty.popFace = "";
    SquareFile onlyLine;
    onlyLine.drawType = 3;
    onlyLine.remake();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    osg::ref_ptr<osg::Group> nothing = new osg::Group;
    osgDB::writeNodeFile(*nothing, (folder.path() / "empty.osgt").string());
    auto outside = polygon(square, {1, 1});
    outside->getDrawable(0)->asGeometry()->setPrimitiveSet(0, new osg::DrawArrays(GL_QUADS, 2, 4));

    struct Row {
        const char* name;
        std::function<void()> act;
        const char* says;
    };
    for (const auto& row : std::vector<Row>{
             {"missing", [&] { Model::load(folder.path() / "none.flt"); }, "no such file"},
             {"missing scene", [&] { Model::load(folder.path() / "none.osgt"); }, "no such file"},
             {"a folder", [&] { Model::load(folder.path()); }, "no such file"},
             {"unknown kind", [&] { Model::load(folder.write("a.xyz", "x")); }, "type \".xyz\""},
             {"no kind", [&] { Model::load(folder.write("a", "x")); }, "type \".\""},
             {"empty file", [&] { Model::load(folder.write("a.flt", "")); }, "empty file"},
             {"no faces", [&] { Model::load(folder.write("b.flt", empty.bytes())); },
              "without faces"},
             {"only a line", [&] { Model::load(folder.write("c.flt", onlyLine.bytes())); },
              "without any visible face"},
             {"empty scene", [&] { Model::load(folder.path() / "empty.osgt"); },
              "without any visible face"},
             {"damaged osgt",
              [&] {
                  Model::load(folder.write("a.osgt", "#Ascii Scene\n#Version 161\nosg::Geode {"));
              },
              "a.osgt"},
             {"text as osgb", [&] { Model::load(folder.write("a.osgb", "hello, world, hello")); },
              "a.osgb"},
             {"text as ive", [&] { Model::load(folder.write("a.ive", "hello, world, hello")); },
              "a.ive"},
             {"not a number",
              [&] {
                  modelOfGraph(
                      polygon({osg::Vec3(0, 0, 0), osg::Vec3(nan, 0, 0), osg::Vec3(0, 1, 0)}, {}),
                      "nan");
              },
              "vertex 1"},
             {"index outside", [&] { modelOfGraph(outside, "outside"); }, "vertex 4"}}) {
        EXPECT_THAT(refusal(row.act), HasSubstr(row.says)) << row.name;
    }
    EXPECT_THROW(modelOfGraph(nullptr, "none"), LogicError);
}

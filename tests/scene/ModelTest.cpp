#include "irsg/geometry/model/Model.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osgDB/WriteFile>
#include <osgSim/ShapeAttribute>

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
    ASSERT_EQ(drawables(*model), 6u);
    for (unsigned int i = 0; i < 6; ++i) {
        const auto n = faceNormal(drawable(*model, i), 0);
        EXPECT_EQ((Vec3{n.x(), n.y(), n.z()}), normals[i]);
        EXPECT_EQ(codesOf(drawable(*model, i), {}), (IrCodes{static_cast<int>(i) + 1, 1}));
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
    const auto& geometry = drawable(*model, 0);
    const auto& vertices = array(geometry.getVertexArray());
    const auto& normals = array(geometry.getNormalArray());
    for (unsigned int i = 0; i < vertices.size(); ++i) {
        ASSERT_LT((vertices[i] - normals[i]).length(), single);
    }
    for (unsigned int i = 0; i < geometry.getPrimitiveSet(0)->getNumIndices() / 3; ++i) {
        ASSERT_GT(faceNormal(geometry, i) * vertices[geometry.getPrimitiveSet(0)->index(3 * i)],
                  0.999);
    }
}

TEST(Model, HoldsNothingButIndexedTrianglesCodesAndCulling) {
    for (const char* name : {"tricky_1420.flt", "tricky_1540.flt", "tricky_1640.flt"}) {
        SCOPED_TRACE(name);
        const auto model = Model::load(data / name);
        EXPECT_EQ(model->graph()->getStateSet(), nullptr);
        for (unsigned int i = 0; i < drawables(*model); ++i) {
            const auto& geometry = drawable(*model, i);
            const auto vertices = geometry.getVertexArray()->getNumElements();
            EXPECT_EQ(geometry.getNormalArray()->getNumElements(), vertices);
            EXPECT_EQ(geometry.getColorArray()->getNumElements(), vertices);
            ASSERT_EQ(geometry.getNumPrimitiveSets(), 1u);
            EXPECT_EQ(geometry.getPrimitiveSet(0)->getMode(), GLenum{GL_TRIANGLES});
            EXPECT_EQ(geometry.getPrimitiveSet(0)->getType(),
                      osg::PrimitiveSet::DrawElementsUIntPrimitiveType);
            EXPECT_TRUE(geometry.getUseVertexBufferObjects());
            EXPECT_FALSE(geometry.getUseDisplayList());
            const auto* list =
                dynamic_cast<const osgSim::ShapeAttributeList*>(geometry.getUserData());
            ASSERT_NE(list, nullptr);
            EXPECT_EQ(list->size(), 2u);
            const auto& state = *geometry.getStateSet();
            EXPECT_TRUE(state.getTextureAttributeList().empty());
            for (const auto& [type, attribute] : state.getAttributeList()) {
                EXPECT_TRUE(type.first == osg::StateAttribute::CULLFACE ||
                            type.first == osg::StateAttribute::POLYGONOFFSET);
            }
            for (const auto& normal : array(geometry.getNormalArray())) {
                EXPECT_NEAR(normal.length(), 1.0, single);
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
        EXPECT_GT(drawables(*model), 0u);
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
    EXPECT_NE(one->graph(), two->graph());
    EXPECT_EQ(one->codes(), two->codes());
    ASSERT_EQ(drawables(*one), drawables(*two));
    for (unsigned int i = 0; i < drawables(*one); ++i) {
        const auto &a = drawable(*one, i), &b = drawable(*two, i);
        EXPECT_EQ(codesOf(a, {}), codesOf(b, {}));
        EXPECT_TRUE(array(a.getVertexArray()).asVector() == array(b.getVertexArray()).asVector());
        EXPECT_TRUE(array(a.getNormalArray()).asVector() == array(b.getNormalArray()).asVector());
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
        const auto mode = [&](const ModelOptions& options) {
            return drawable(*Model::load(path, options), 0).getStateSet()->getMode(GL_CULL_FACE);
        };
        EXPECT_EQ(mode({}) == osg::StateAttribute::ON, culled) << drawType;
        EXPECT_EQ(mode({.forceTwoSided = true}), osg::StateAttribute::GLModeValue{0}) << drawType;
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
    EXPECT_NEAR(array(drawable(*unlit, 0).getNormalArray())[0].x(), 0.6, single);

    SquareFile bare;
    bare.vertices = "";
    for (const auto& [x, z] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
        bare.vertices += record(flight::vertexC, zeros(4) + f64(x) + f64(0) + f64(z) + zeros(8));
    }
    bare.palette = record(flight::vertexPalette, i32(8 + 4 * 40));
    bare.list = record(flight::vertexList, i32(8) + i32(48) + i32(88) + i32(128));
    const auto upright = Model::load(folder.write("bare.flt", bare.bytes()));
    EXPECT_NEAR(array(drawable(*upright, 0).getNormalArray())[0].y(), -1.0, single);
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
                  Model::fromGraph(
                      polygon({osg::Vec3(0, 0, 0), osg::Vec3(nan, 0, 0), osg::Vec3(0, 1, 0)}, {}),
                      "nan");
              },
              "vertex 1"},
             {"index outside", [&] { Model::fromGraph(outside, "outside"); }, "vertex 4"}}) {
        EXPECT_THAT(refusal(row.act), HasSubstr(row.says)) << row.name;
    }
    EXPECT_THROW(Model::fromGraph(nullptr, "none"), LogicError);
}

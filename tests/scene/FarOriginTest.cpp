#include "irsg/geometry/reading/FarOrigin.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/MatrixTransform>

#include "irsg/geometry/conversion/GeometryCollector.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/conversion/SurfaceMesh.h"
#include "tests/support/FlightBytes.h"

using namespace irsg;
using namespace irsg::test;
using testing::Contains;
using testing::HasSubstr;

namespace {

struct Shape {
    double area = 0.0, drawnArea = 0.0;
    osg::BoundingBoxd bounds;
};

/// What is drawn of a loaded model that is counted from an origin, in single precision.
Shape shapeOf(const LoadedGraph& loaded, const osg::Vec3d& origin) {
    SurfaceMesh mesh;
    Matrix4 toModel;
    toModel.rows[3] = {-origin.x(), -origin.y(), -origin.z(), 1.0};
    GeometryCollector(mesh, toModel, "a", {.forceTwoSided = true}).collect(*loaded.node);
    Shape shape;
    for (const auto& [kind, part] : mesh.parts()) {
        shape.area += part.area_m2;
        for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return osg::Vec3d(toOsg(part.vertices[part.triangles[i + k]]));
            };
            const osg::Vec3d a = corner(0), b = corner(1), c = corner(2);
            shape.drawnArea += 0.5 * ((b - a) ^ (c - a)).length();
            for (const auto& each : {a, b, c}) {
                shape.bounds.expandBy(each);
            }
        }
    }
    return shape;
}

void expectBox(const Shape& shape, const osg::Vec3d& least, const osg::Vec3d& most, double area) {
    EXPECT_NEAR(shape.area, area, 1e-5 * area);
    EXPECT_NEAR(shape.drawnArea, area, 1e-5 * area);
    EXPECT_NEAR((shape.bounds._min - least).length(), 0.0, 1e-5);
    EXPECT_NEAR((shape.bounds._max - most).length(), 0.0, 1e-5);
}

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6f", value);
    return text;
}

/// A unit cube whose least corner is at a place.
std::string cube(const osg::Vec3d& at) {
    std::string text;
    for (int i = 0; i < 8; ++i) {
        text += "v " + number(at.x() + (i & 1)) + " " + number(at.y() + (i >> 1 & 1)) + " " +
                number(at.z() + (i >> 2)) + "\n";
    }
    return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

/// The vertices of a square of 1 x 1 at a place, for SquareFile.
std::string verticesAt(double x, double y, double z) {
    std::string vertices;
    for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        vertices +=
            record(flight::vertexCN, i16(0) + i16(0x1000) + f64(x + u) + f64(y + v) + f64(z) +
                                         f32(0) + f32(0) + f32(1) + i32(-1) + i32(-1) + i32(0));
    }
    return vertices;
}

} // namespace

TEST(FarOrigin, KeepsTheShapeOfACubeAMillionMetresAway) {
    const TemporaryFolder folder;
    for (const double far : {1e4, 1e6, 1e8}) {
        const osg::Vec3d at(far + 0.1, -0.3 * far, 0.7 * far + 0.2);
        const auto loaded = loadGraph(folder.write("a.obj", cube(at)), LoadPurpose::infrared);
        const osg::Vec3d turned(at.x(), -at.z() - 1, at.y());
        expectBox(shapeOf(loaded, turned), {0, 0, 0}, {1, 1, 1}, 6.0);
        EXPECT_THAT(loaded.remarks, testing::Not(Contains(HasSubstr("single precision"))));
    }
}

TEST(FarOrigin, TouchesNothingNearTheOrigin) {
    const TemporaryFolder folder;
    const auto loaded = loadGraph(folder.write("a.obj", cube({0.5, 1, 2})), LoadPurpose::infrared);
    EXPECT_FALSE(loaded.node->asTransform());
    EXPECT_FALSE(farOriginOf({osg::Vec3d(0, 0, 0), osg::Vec3d(100, 1, 1)}));
    EXPECT_FALSE(farOriginOf({osg::Vec3d(10, 0, 0), osg::Vec3d(11, 1, 1)}));
    EXPECT_FALSE(farOriginOf(osg::BoundingBoxd()));
    ASSERT_TRUE(farOriginOf({osg::Vec3d(1000, 0, 0), osg::Vec3d(1001, 1, 1)}));
    EXPECT_EQ(*farOriginOf({osg::Vec3d(1000.3, 0, 0), osg::Vec3d(1001.1, 0.2, 0.2)}),
              osg::Vec3d(1001, 0, 0));
}

TEST(FarOrigin, KeepsTheShapeOfOpenFlightInItsUnitBelowItsMatrices) {
    const TemporaryFolder folder;
    // Feet; a quarter turn about z and 5 ft along z above the object; one face twice, in two
    // groups.
    SquareFile file;
    file.unit = 4;
    file.remake();
    file.vertices = verticesAt(1000000.25, -3000000.5, 70.125);
    std::string turn;
    for (const float value :
         {0.f, 1.f, 0.f, 0.f, -1.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 5.f, 1.f}) {
        turn += f32(value);
    }
    file.group += record(flight::matrix, turn);
    const auto loaded = loadGraph(folder.write("a.flt", file.bytes()), LoadPurpose::infrared);
    // (x, y, z) -> (-y, x, z + 5)
    const osg::Vec3d at(2999999.5, 1000000.25, 75.125);
    expectBox(shapeOf(loaded, at * 0.3048), {0, 0, 0}, osg::Vec3d(0.3048, 0.3048, 0),
              0.3048 * 0.3048);
    EXPECT_THAT(loaded.remarks, testing::Not(Contains(HasSubstr("single precision"))));
    EXPECT_EQ(loaded.axes.unit_m, 1.0);
    EXPECT_EQ(loaded.axes.up, ModelAxis::plusZ);
}

TEST(FarOrigin, KeepsTheShapeOfPoolsThatAreContinued) {
    const TemporaryFolder folder;
    std::string pool = i32(4) + i32(0x90000000);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
        pool += f64(5e6 + 0.1 + x) + f64(-2e6 + y) + f64(3) + f32(0) + f32(0) + f32(1);
    }
    for (const std::size_t cut : {pool.size(), std::size_t{8}, std::size_t{50}, std::size_t{61}}) {
        SquareFile file;
        const std::string mesh = meshRecords();
        const auto begin = mesh.find(record(flight::localVertexPool, "").substr(0, 2));
        const std::size_t whole = 4 + pool.size();
        file.face = mesh.substr(0, begin) + record(flight::localVertexPool, pool.substr(0, cut));
        if (cut < pool.size()) {
            file.face += record(flight::continuation, pool.substr(cut));
        }
        file.face += mesh.substr(begin + whole);
        file.pushFace = file.list = file.popFace = file.palette = file.vertices = "";
        const auto loaded = loadGraph(folder.write("a.flt", file.bytes()), LoadPurpose::infrared);
        SCOPED_TRACE(cut);
        expectBox(shapeOf(loaded, {5e6 + 0.1, -2e6, 3}), {0, 0, 0}, {1, 1, 0}, 1.0);
    }
}

TEST(FarOrigin, LeavesPartsThatAreUsedTwiceShared) {
    osg::ref_ptr<osg::Geode> shared = new osg::Geode, alone = new osg::Geode;
    osg::ref_ptr<osg::Group> root = new osg::Group, pair = new osg::Group;
    osg::ref_ptr<osg::MatrixTransform> moved =
        new osg::MatrixTransform(osg::Matrixd::translate(1, 2, 3));
    moved->addChild(shared);
    pair->addChild(alone);
    pair->addChild(new osg::Geode);
    root->addChild(moved);
    root->addChild(shared);
    root->addChild(pair);
    moveBack(*root, {10, 0, 0});
    ASSERT_EQ(shared->getNumParents(), 1u);
    EXPECT_EQ(shared->getParent(0)->getNumParents(), 2u);
    ASSERT_EQ(pair->getNumChildren(), 1u) << "faces side by side share a translation";
    EXPECT_EQ(pair->getChild(0)->asGroup()->getNumChildren(), 2u);
    const auto paths = shared->getParentalNodePaths();
    ASSERT_EQ(paths.size(), 2u);
    EXPECT_EQ(osg::computeLocalToWorld(paths[0]).getTrans(), osg::Vec3d(11, 2, 3));
    EXPECT_EQ(osg::computeLocalToWorld(paths[1]).getTrans(), osg::Vec3d(10, 0, 0));
}

TEST(FarOrigin, IsRemarkedWhereAReaderRoundsBefore) {
    const TemporaryFolder folder;
    const auto ply = [](double at) {
        std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                           "property float y\nproperty float z\nelement face 1\n"
                           "property list uchar int vertex_indices\nend_header\n";
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}}) {
            text += number(at + x) + " " + number(y) + " 0\n";
        }
        return text + "3 0 1 2\n";
    };
    const auto ac = [](double at) {
        std::string text =
            "AC3Db\nMATERIAL \"m\" rgb 1 0 0 amb 1 0 0 emis 0 0 0 spec 0 0 0 shi 1 trans 0\n"
            "OBJECT world\nkids 1\nOBJECT poly\nnumvert 3\n";
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}}) {
            text += number(at + x) + " " + number(y) + " 0\n";
        }
        return text + "numsurf 1\nSURF 0x20\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids 0\n";
    };
    const auto remarks = [&](const char* name, const std::string& text) {
        return loadGraph(folder.write(name, text), LoadPurpose::infrared).remarks;
    };
    EXPECT_THAT(remarks("a.ac", ac(1e6)), Contains(HasSubstr("in single precision")));
    EXPECT_THAT(remarks("b.ac", ac(3)), testing::Not(Contains(HasSubstr("single precision"))));
    // Our own readers have double.
    for (const double at : {3.0, 1e6}) {
        EXPECT_THAT(remarks("a.ply", ply(at)),
                    testing::Not(Contains(HasSubstr("single precision"))));
    }
}

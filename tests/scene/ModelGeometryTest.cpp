// What a Model makes of graphs: transforms, normals, polygons, levels of detail, codes.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osg/Switch>
#include <osgSim/ShapeAttribute>

#include "tests/support/ModelAccess.h"

using namespace irsg;
using namespace irsg::test;
using testing::Contains;
using testing::HasSubstr;

TEST(Model, IsTurnedSoThatItsNoseIsPlusY) {
    // The nose axis of the file at (2, 0) or so goes to (0, 2); z stays.
    for (const auto& [axis, nose] : {std::pair{ModelAxis::plusX, osg::Vec3(2, 0, 0)},
                                     {ModelAxis::minusX, osg::Vec3(-2, 0, 0)},
                                     {ModelAxis::plusY, osg::Vec3(0, 2, 0)},
                                     {ModelAxis::minusY, osg::Vec3(0, -2, 0)}}) {
        const auto graph = polygon({osg::Vec3(0, 0, 0), nose, osg::Vec3(0, 0, 1)}, {1, 1});
        const auto model = modelOfGraph(graph, "arrow", {.placing = {.nose = axis}});
        EXPECT_EQ(model->bounds(), (BoundingBox{{0, 0, 0}, {0, 2, 1}}));
    }
    // A turn, not a reflection: starboard of a nose at +x is -y.
    const auto graph = polygon({osg::Vec3(0, 0, 0), osg::Vec3(0, -1, 0), osg::Vec3(0, 0, 1)}, {});
    EXPECT_EQ(modelOfGraph(graph, "wing", {.placing = {.nose = ModelAxis::plusX}})->bounds(),
              (BoundingBox{{0, 0, 0}, {1, 0, 1}}));
}

TEST(Model, TurnsMirroredPartsRoundSoThatTheirFrontStaysOutside) {
    const auto mirrored = [](const osg::Matrixd& matrix) {
        osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(matrix);
        transform->addChild(polygon(square, {1, 1}));
        return modelOfGraph(transform, "part");
    };
    EXPECT_GT(faceNormal(partOf(*mirrored(osg::Matrixd::scale(-1, 1, 1)), 0), 0).z(), 0.99f);
    EXPECT_LT(faceNormal(partOf(*mirrored(osg::Matrixd::scale(1, 1, -1)), 0), 0).z(), -0.99f);
    const auto flat = mirrored(osg::Matrixd::scale(2, 3, 0.5) * osg::Matrixd::translate(0, 0, 7));
    EXPECT_NEAR(flat->codes().at({1, 1}).area_m2, 6.0, single);
    EXPECT_EQ(flat->bounds().min.z, 7.0);
}

TEST(Model, TransformsNormalsByTheInverseTransposed) {
    // A plane tilted by 45 degrees, squeezed to a quarter of its height, tilts by atan(1/4).
    auto geode = polygon(
        {osg::Vec3(0, 0, 0), osg::Vec3(1, 0, 1), osg::Vec3(1, 1, 1), osg::Vec3(0, 1, 0)}, {1, 1});
    osg::ref_ptr<osg::Vec3Array> normals = new osg::Vec3Array;
    normals->push_back(osg::Vec3(-1, 0, 1));
    auto* geometry = geode->getDrawable(0)->asGeometry();
    geometry->setNormalArray(normals, osg::Array::BIND_OVERALL);
    osg::ref_ptr<osg::MatrixTransform> squeeze =
        new osg::MatrixTransform(osg::Matrixd::scale(1, 1, 0.25));
    squeeze->addChild(geode);
    const auto model = modelOfGraph(squeeze, "plane");
    const osg::Vec3 normal = toOsg(partOf(*model, 0).normals[0]);
    EXPECT_NEAR(normal.x(), -1 / std::sqrt(17.0), single);
    EXPECT_NEAR(normal.z(), 4 / std::sqrt(17.0), single);
}

TEST(Model, MakesNormalsThatAreMissingAndTurnsThoseThatPointAway) {
    const auto load = [](const std::vector<osg::Vec3>& normals) {
        auto geode = polygon(square, {1, 1});
        auto* geometry = geode->getDrawable(0)->asGeometry();
        if (!normals.empty()) {
            geometry->setNormalArray(new osg::Vec3Array(normals.begin(), normals.end()),
                                     osg::Array::BIND_PER_VERTEX);
        }
        return modelOfGraph(geode, "square");
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const osg::Vec3 up(0, 0, 1), down(0, 0, -3), none(0, 0, 0), bad(nan, 0, 1);
    for (const auto& normals : std::vector<std::vector<osg::Vec3>>{{},
                                                                   {up, up, up, up},
                                                                   {down, down, down, down},
                                                                   {none, up, none, up},
                                                                   {bad, up, up, up},
                                                                   {up, up}}) {
        const auto model = load(normals);
        for (const Float3& normal : partOf(*model, 0).normals) {
            EXPECT_NEAR((toOsg(normal) - up).length(), 0.0, single);
        }
    }
    EXPECT_THAT(load({})->remarks(), Contains(HasSubstr("normals of their own")));
    EXPECT_THAT(load({down, down, down, down})->remarks(), Contains(HasSubstr("turned")));
}

TEST(Model, ShowsTheHighestDetailOfLevelsAtAnyRange) {
    osg::ref_ptr<osg::LOD> lod = new osg::LOD;
    lod->addChild(polygon(square, {2, 1}), 100, 1e4);
    lod->addChild(polygon(square, {1, 1}), 0, 100);
    const auto model = modelOfGraph(lod, "levels");
    EXPECT_EQ(model->codes().size(), 1u);
    EXPECT_TRUE(model->codes().contains({1, 1}));
    EXPECT_THAT(model->remarks(), Contains(HasSubstr("highest detail")));

    // OpenFlight has a node a level, side by side; their ranges need not join.
    const auto level = [](IrCodes codes, float from, float to) {
        osg::ref_ptr<osg::LOD> node = new osg::LOD;
        node->addChild(polygon(square, codes), from, to);
        return node;
    };
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(level({2, 1}, 100, 1e4));
    group->addChild(level({1, 1}, 0, 80));
    const auto codes = modelOfGraph(group, "siblings")->codes();
    EXPECT_TRUE(codes.contains({1, 1}));
    EXPECT_FALSE(codes.contains({2, 1}));

    // A part that has one level only is drawn however far its range begins or ends.
    osg::ref_ptr<osg::LOD> alone = new osg::LOD;
    alone->addChild(polygon(square, {3, 1}), 50, 60);
    EXPECT_TRUE(modelOfGraph(alone, "alone")->codes().contains({3, 1}));
}

TEST(Model, ShowsWhatSwitchesShow) {
    osg::ref_ptr<osg::Switch> choice = new osg::Switch;
    choice->addChild(polygon(square, {1, 1}), false);
    choice->addChild(polygon(square, {2, 1}), true);
    const auto model = modelOfGraph(choice, "choice");
    EXPECT_FALSE(model->codes().contains({1, 1}));
    EXPECT_TRUE(model->codes().contains({2, 1}));
    EXPECT_THAT(model->remarks(), Contains("1 polygons are switched off"));
}

TEST(Model, CutsEveryKindOfPrimitiveIntoItsTriangles) {
    struct Row {
        const char* name;
        GLenum mode;
        std::vector<osg::Vec3> corners;
        double area;
        unsigned int triangles;
    };
    const osg::Vec3 a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0), e(2, 0, 0), f(2, 1, 0);
    for (const auto& row :
         std::vector<Row>{{"triangles", GL_TRIANGLES, {a, b, c, a, c, d}, 1, 2},
                          {"quads", GL_QUADS, {a, b, c, d, b, e, f, c}, 2, 4},
                          {"quad strip", GL_QUAD_STRIP, {d, a, c, b, f, e}, 2, 4},
                          {"triangle strip", GL_TRIANGLE_STRIP, {d, a, c, b, f, e}, 2, 4},
                          {"fan", GL_TRIANGLE_FAN, {a, b, c, d}, 1, 2},
                          {"dart", GL_POLYGON, {a, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}, 1, 2},
                          {"comb",
                           GL_POLYGON,
                           {{0, 0, 0},
                            {5, 0, 0},
                            {5, 2, 0},
                            {4, 2, 0},
                            {4, 1, 0},
                            {3, 1, 0},
                            {3, 2, 0},
                            {2, 2, 0},
                            {2, 1, 0},
                            {1, 1, 0},
                            {1, 2, 0},
                            {0, 2, 0}},
                           8,
                           10},
                          {"collinear corner", GL_POLYGON, {a, {0.5, 0, 0}, b, c, d}, 1, 3}}) {
        SCOPED_TRACE(row.name);
        const auto model = modelOfGraph(polygon(row.corners, {1, 1}, row.mode), row.name);
        EXPECT_NEAR(model->codes().at({1, 1}).area_m2, row.area, single);
        const Mesh::Part& part = partOf(*model, 0);
        EXPECT_LE(part.triangles.size() / 3, row.triangles);
        for (std::size_t i = 0; i < part.triangles.size() / 3; ++i) {
            EXPECT_GT(faceNormal(part, i).z(), 0.99f);
        }
    }
}

TEST(Model, LeavesOutPolygonsWithoutAreaAndSaysSo) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(polygon(square, {1, 1}));
    group->addChild(polygon({osg::Vec3(0, 0, 0), osg::Vec3(1, 1, 1), osg::Vec3(2, 2, 2)}, {2, 1}));
    group->addChild(polygon({osg::Vec3(0, 0, 0), osg::Vec3(0, 0, 0), osg::Vec3(0, 0, 0)}, {2, 1}));
    const auto model = modelOfGraph(group, "thin");
    EXPECT_EQ(model->codes().size(), 1u);
    EXPECT_THAT(model->remarks(), Contains("2 polygons without area are left out"));
}

TEST(Model, SaysWhenItLiesTooFarFromItsOriginForSinglePrecision) {
    osg::ref_ptr<osg::MatrixTransform> far =
        new osg::MatrixTransform(osg::Matrixd::translate(6.4e6, 0, 0));
    far->addChild(polygon(square, {1, 1}));
    EXPECT_THAT(modelOfGraph(far, "far", {.placing = {.origin = ModelOrigin{}}})->remarks(),
                Contains(HasSubstr("single precision")));
    EXPECT_TRUE(modelOfGraph(polygon(square, {1, 1}), "near")->remarks().size() == 1u)
        << "its normals only";
}

TEST(Model, TakesCodesFromTheDrawableElseFromTheNodesAbove) {
    auto own = polygon(square, {4, 5});
    auto bare = polygon(square, {0, 0});
    bare->getDrawable(0)->setUserDataContainer(nullptr);
    osg::ref_ptr<osgSim::ShapeAttributeList> list = new osgSim::ShapeAttributeList;
    list->push_back(osgSim::ShapeAttribute("IRMaterial", 9));
    bare->setUserData(list);
    auto none = polygon(square, {0, 0});
    none->getDrawable(0)->setUserDataContainer(nullptr);
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(own);
    group->addChild(bare);
    group->addChild(none);
    const auto codes = modelOfGraph(group, "three")->codes();
    EXPECT_EQ(codes.size(), 3u);
    EXPECT_TRUE(codes.contains({4, 5}));
    EXPECT_TRUE(codes.contains({0, 9}));
    EXPECT_TRUE(codes.contains({0, 0}));
}

TEST(Model, BoundsOfTheGeometryThatIsWanted) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(polygon(square, {1, 1}));
    osg::ref_ptr<osg::MatrixTransform> far =
        new osg::MatrixTransform(osg::Matrixd::translate(10, 0, 0));
    far->addChild(polygon(square, {1, 2}));
    group->addChild(far);
    const auto model = modelOfGraph(group, "two");
    EXPECT_EQ(model->bounds(), (BoundingBox{{0, 0, 0}, {11, 1, 0}}));
    EXPECT_EQ(model->boundsOf([](const IrCodes& c) { return c.material == 1; }),
              (BoundingBox{{0, 0, 0}, {1, 1, 0}}));
    EXPECT_FALSE(model->boundsOf([](const IrCodes&) { return false; }).valid());
}

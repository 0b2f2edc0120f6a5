// Faces chosen one by one, as connected parts, by material, angle and box, and painted: on closed
// shapes whose answers are known.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <osg/Material>
#include <osg/MatrixTransform>

#include "irsg/geometry/conversion/CodedGraph.h"
#include "irsg/geometry/model/Painting.h"
#include "tests/support/ModelAccess.h"

using namespace irsg;
using namespace irsg::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

using Surfaces = std::vector<PaintedSurface>;

/// A cube of 12 triangles, its lower corner at `low`: bottom, top, front (y = 0), back, left,
/// right, two each. Every side has corners of its own, as normals need them.
osg::ref_ptr<osg::Geode> cube(const osg::Vec3& low, float side = 1.0F) {
    const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    auto* corners = new osg::Vec3Array;
    for (const auto& quad : quads) {
        for (const int k : {0, 1, 2, 0, 2, 3}) {
            const int c = quad[k];
            const osg::Vec3 at(static_cast<float>(c & 1), static_cast<float>((c >> 1) & 1),
                               static_cast<float>(c >> 2));
            corners->push_back(low + at * side);
        }
    }
    geometry->setVertexArray(corners);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 36));
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    return geode;
}

/// A sphere of radius 1 of n rings of 2 n quads, those at the poles triangles.
osg::ref_ptr<osg::Geode> sphere(int n) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    auto* corners = new osg::Vec3Array;
    const auto at = [&](int ring, int slice) {
        const double polar = std::numbers::pi * ring / n, around = std::numbers::pi * slice / n;
        return osg::Vec3(static_cast<float>(std::sin(polar) * std::cos(around)),
                         static_cast<float>(std::sin(polar) * std::sin(around)),
                         static_cast<float>(std::cos(polar)));
    };
    for (int ring = 0; ring < n; ++ring) {
        for (int slice = 0; slice < 2 * n; ++slice) {
            const auto a = at(ring, slice), b = at(ring + 1, slice), c = at(ring + 1, slice + 1),
                       d = at(ring, slice + 1);
            const auto add = [&](const auto&... three) { (corners->push_back(three), ...); };
            if (ring < n - 1) {
                add(a, b, c);
            }
            if (ring > 0) {
                add(a, c, d);
            }
        }
    }
    geometry->setVertexArray(corners);
    geometry->addPrimitiveSet(
        new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(corners->size())));
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    return geode;
}

osg::ref_ptr<osg::Group> together(const std::vector<osg::ref_ptr<osg::Geode>>& parts) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const auto& part : parts) {
        group->addChild(part);
    }
    return group;
}

void call(osg::Node& node, const std::string& material) {
    osg::ref_ptr<osg::Material> named = new osg::Material;
    named->setName(material);
    node.getOrCreateStateSet()->setAttribute(named);
}

FaceMesh meshOf(osg::Node& graph, const std::vector<CodeRule>& rules = {}) {
    return {loaded(&graph), rules, "shape"};
}

/// Polygons by their codes when a graph is read with what is painted.
std::map<IrCodes, long> read(osg::ref_ptr<osg::Node> graph, const Surfaces& painted,
                             std::vector<std::string>* remarks = nullptr) {
    const auto said = giveCodes(graph, {{}, painted}, "shape.obj");
    if (remarks != nullptr) {
        *remarks = said;
    }
    return polygonCounts(*graph);
}
std::map<IrCodes, long> told(const FaceMesh& mesh, const Surfaces& painted) {
    std::map<IrCodes, long> counts;
    for (const IrCodes& codes : mesh.codes(painted)) {
        ++counts[codes];
    }
    return counts;
}
std::size_t trianglesIn(const Surfaces& painted) {
    std::size_t count = 0;
    for (const auto& surface : painted) {
        count += surface.triangles.size();
    }
    return count;
}

/// A picture of 400 x 400 pixels from `eye` towards the origin, z up, 400 pixels to the radian.
FaceBox pictureFrom(const osg::Vec3d& eye) {
    osg::Vec3d ahead = -eye, right = ahead ^ osg::Vec3d(0, 0, 1);
    ahead.normalize();
    right.normalize();
    const osg::Vec3d down = ahead ^ right;
    FaceBox box;
    box.eye = fromOsg(eye);
    osg::Matrixd m;
    for (int i = 0; i < 3; ++i) {
        m(i, 0) = 400.0 * right[i] + 200.0 * ahead[i];
        m(i, 1) = 400.0 * down[i] + 200.0 * ahead[i];
        m(i, 2) = m(i, 3) = ahead[i];
    }
    m(3, 3) = 0.0;
    m = osg::Matrixd::translate(-eye) * m;
    for (std::size_t i = 0; i < 16; ++i) {
        box.toPicture(i / 4, i % 4) = m.ptr()[i];
    }
    box.right = box.bottom = 400.0;
    return box;
}

constexpr double degree = std::numbers::pi / 180.0;

} // namespace

TEST(FaceChoice, ACubeIsOnePartThoughEverySideHasItsOwnCorners) {
    const auto graph = together({cube({0, 0, 0}), cube({3, 0, 0})});
    const FaceMesh mesh = meshOf(*graph);
    ASSERT_EQ(mesh.faces().size(), 24u);
    EXPECT_EQ(partOf(mesh, 0).size(), 12u);
    EXPECT_EQ(partOf(mesh, 0).front(), 0u);
    EXPECT_EQ(partOf(mesh, 23).front(), 12u);
    EXPECT_EQ(partOf(mesh, 23).size(), 12u);
}

TEST(FaceChoice, CornersThatDifferByRoundingAreOneAndThoseFartherApartAreNot) {
    for (const auto& [gap, parts] : {std::pair{1e-7F, 1U}, {1e-3F, 2U}}) {
        const auto graph = together({cube({0, 0, 0}), cube({1.0F + gap, 0, 0})});
        const FaceMesh mesh = meshOf(*graph);
        EXPECT_EQ(partOf(mesh, 0).size(), parts == 1 ? 24u : 12u) << gap;
    }
}

TEST(FaceChoice, PartsMeetAcrossDrawablesAndTransforms) {
    osg::ref_ptr<osg::MatrixTransform> mirrored =
        new osg::MatrixTransform(osg::Matrixd::scale(-1, 1, 1));
    mirrored->addChild(cube({0, 0, 0}));
    osg::ref_ptr<osg::Group> graph = together({cube({0, 0, 0})});
    graph->addChild(mirrored);
    const FaceMesh mesh = meshOf(*graph);
    EXPECT_EQ(partOf(mesh, 0).size(), 24u) << "they share the side x = 0";
    for (const auto& face : mesh.faces()) {
        const auto number = static_cast<std::size_t>(&face - mesh.faces().data());
        const osg::Vec3d centre(number < 12 ? 0.5 : -0.5, 0.5, 0.5);
        EXPECT_GT(dot(face.normal, face.point - fromOsg(centre)), 0.0) << "fronts look outward";
    }
}

TEST(FaceChoice, OneSideOfACubeIsSmoothAndAllOfItAtARightAngle) {
    const auto graph = together({cube({0, 0, 0}), cube({3, 0, 0})});
    const FaceMesh mesh = meshOf(*graph);
    EXPECT_THAT(smoothFrom(mesh, 3, 0.0), ElementsAre(2, 3));
    EXPECT_THAT(smoothFrom(mesh, 3, 89.0 * degree), ElementsAre(2, 3));
    EXPECT_EQ(smoothFrom(mesh, 3, 90.0 * degree).size(), 12u);
    EXPECT_EQ(smoothFrom(mesh, 3, 180.0 * degree).size(), 12u) << "never to another part";
}

TEST(FaceChoice, ASphereIsReachedAsSoonAsItsRingsAreAndACapIsNot) {
    // 36 rings, 5 degrees from one to the next.
    const auto ball = sphere(36);
    const FaceMesh mesh = meshOf(*ball);
    ASSERT_EQ(mesh.faces().size(), 36u * 72u * 2u - 2u * 72u);
    EXPECT_EQ(smoothFrom(mesh, 1000, 6.0 * degree).size(), mesh.faces().size());
    EXPECT_LT(smoothFrom(mesh, 1000, 4.0 * degree).size(), 200u);
    EXPECT_EQ(partOf(mesh, 5).size(), mesh.faces().size()) << "the seam at 0 degrees holds";
}

TEST(FaceChoice, TheAngleCountsBetweenSurfacesWhicheverWayTheirFacesRun) {
    // Two squares in a plane, the second with its corners the other way round.
    osg::ref_ptr<osg::Group> graph = new osg::Group;
    graph->addChild(polygon(square, {}));
    graph->addChild(polygon({{1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 0, 0}}, {}));
    EXPECT_EQ(smoothFrom(meshOf(*graph), 0, 1.0 * degree).size(), 2u);
    // A wall with both its sides: the back is no continuation of the front.
    osg::ref_ptr<osg::Group> wall = new osg::Group;
    wall->addChild(polygon(square, {}));
    wall->addChild(polygon({{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}, {}));
    EXPECT_EQ(smoothFrom(meshOf(*wall), 0, 170.0 * degree).size(), 1u);
}

TEST(FaceChoice, AMaterialIsOneByItsNameElseByItsState) {
    const auto a = cube({0, 0, 0}), b = cube({3, 0, 0}), c = cube({6, 0, 0}), d = cube({9, 0, 0});
    call(*a, "Paint");
    call(*b, "Paint");
    call(*c, "");
    const auto graph = together({a, b, c, d});
    const FaceMesh mesh = meshOf(*graph);
    EXPECT_EQ(sameMaterialAs(mesh, 0).size(), 24u);
    EXPECT_EQ(sameMaterialAs(mesh, 30).size(), 12u);
    EXPECT_EQ(sameMaterialAs(mesh, 40).size(), 12u);
}

TEST(FaceChoice, ARayMeetsTheNearestFaceThatIsDrawnFromItsSide) {
    const auto graph = together({cube({0, 0, 0}), cube({0, 3, 0})});
    const FaceMesh mesh = meshOf(*graph);
    const auto front = faceAlong(mesh, {0.7, -5, 0.2}, {0, 1, 0});
    ASSERT_TRUE(front);
    EXPECT_EQ(mesh.faces()[*front].normal, (Vec3{0, -1, 0}));
    EXPECT_LT(*front, 12u);
    EXPECT_FALSE(faceAlong(mesh, {0.7, -5, 0.2}, {0, -1, 0}));
    EXPECT_FALSE(faceAlong(mesh, {1.7, -5, 0.2}, {0, 1, 0}));
    const auto between = faceAlong(mesh, {0.7, 2, 0.2}, {0, 1, 0});
    ASSERT_TRUE(between);
    EXPECT_GE(*between, 12u);
}

TEST(FaceChoice, ABoxTakesWhatIsSeenAndOnDemandWhatIsHidden) {
    // One cube before the other, seen from the front.
    const auto graph = together({cube({-0.5F, -0.5F, -0.5F}), cube({-0.5F, 2.0F, -0.5F})});
    const FaceMesh mesh = meshOf(*graph);
    FaceBox box = pictureFrom({0, -6, 0});
    EXPECT_THAT(facesIn(mesh, box), ElementsAre(4, 5)) << "the front of the nearer one";
    box.hiddenToo = true;
    EXPECT_EQ(facesIn(mesh, box).size(), 24u);
    box.hiddenToo = false;
    // Middles of the two triangles of the front lie below and above the diagonal.
    box.top = 200.0;
    EXPECT_EQ(facesIn(mesh, box).size(), 1u);
    box.left = box.right = 10.0;
    EXPECT_THAT(facesIn(mesh, box), IsEmpty());
    // From a corner three sides are seen.
    EXPECT_EQ(facesIn(meshOf(*cube({-0.5F, -0.5F, -0.5F})), pictureFrom({-4, -4, 4})).size(), 6u);
}

TEST(FaceChoice, OfASphereTheCapIsSeenThatLooksAtTheEye) {
    const auto ball = sphere(36);
    const FaceMesh mesh = meshOf(*ball);
    const auto seen = facesIn(mesh, pictureFrom({0, -5, 0}));
    for (unsigned int f = 0; f < mesh.faces().size(); ++f) {
        // From five radii away it ends at y = -1/5.
        const bool isSeen = std::ranges::binary_search(seen, f);
        const double y = mesh.faces()[f].point.y;
        EXPECT_FALSE(isSeen && y > -0.18) << f << " at " << y;
        EXPECT_FALSE(!isSeen && y < -0.22) << f << " at " << y;
    }
    // From afar, a few pixels large, no face of the back is taken.
    for (const unsigned int f : facesIn(mesh, pictureFrom({0, -50, 0}))) {
        EXPECT_LT(mesh.faces()[f].point.y, 0.0);
    }
}

TEST(FaceChoice, WhatIsChosenIsAddedToAndTakenFrom) {
    EXPECT_THAT(chosen({1, 3, 5}, {2, 3}, Choosing::anew), ElementsAre(2, 3));
    EXPECT_THAT(chosen({1, 3, 5}, {2, 3}, Choosing::add), ElementsAre(1, 2, 3, 5));
    EXPECT_THAT(chosen({1, 3, 5}, {2, 3}, Choosing::takeAway), ElementsAre(1, 5));
}

TEST(Painting, WhatIsPaintedIsWhatIsReadAndLosesNothing) {
    const auto graph = together({cube({0, 0, 0}), cube({3, 0, 0})});
    const FaceMesh mesh = meshOf(*graph);
    const Surfaces one = painted({}, mesh, partOf(mesh, 12), {3, 4});
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].triangles.size(), 12u);
    std::vector<std::string> remarks;
    EXPECT_EQ(read(graph, one, &remarks), (std::map<IrCodes, long>{{{0, 0}, 12}, {{3, 4}, 12}}));
    EXPECT_THAT(remarks, IsEmpty());
    EXPECT_EQ(told(mesh, one), read(graph, one));
    // Written and read again they are equal to the last digit.
    EXPECT_EQ(modelCodesFromJson(modelCodesToJson({{}, one}), "a").painted, one);
}

TEST(Painting, PaintingAgainDoesNotPileUpAndOneKindOfCodeLeavesTheOther) {
    const auto graph = together({cube({0, 0, 0})});
    const FaceMesh mesh = meshOf(*graph);
    Surfaces surfaces = painted({}, mesh, {0, 1, 2, 3}, {1, std::nullopt});
    surfaces = painted(surfaces, mesh, {2, 3, 4, 5}, {std::nullopt, 7});
    EXPECT_EQ(told(mesh, surfaces),
              (std::map<IrCodes, long>{{{0, 0}, 6}, {{0, 7}, 2}, {{1, 0}, 2}, {{1, 7}, 2}}));
    EXPECT_EQ(surfaces.size(), 3u);
    for (int i = 0; i < 20; ++i) {
        surfaces = painted(surfaces, mesh, {0, 1, 2, 3, 4, 5}, {i % 3, i % 2});
    }
    EXPECT_EQ(surfaces.size(), 1u);
    EXPECT_EQ(trianglesIn(surfaces), 6u);
    EXPECT_EQ(read(graph, surfaces), (std::map<IrCodes, long>{{{0, 0}, 6}, {{1, 1}, 6}}));
}

TEST(Painting, ErasingGivesBackWhatFileAndRulesSay) {
    const auto box = cube({0, 0, 0});
    setCodes(*box->getDrawable(0), {5, 6});
    call(*box, "Steel");
    const auto graph = together({box});
    const std::vector<CodeRule> rules{{CodeRule::Of::material, "Steel", {std::nullopt, 9}}};
    const FaceMesh mesh = meshOf(*graph, rules);
    Surfaces surfaces = painted({}, mesh, {0, 1, 2, 3}, {1, 2});
    EXPECT_EQ(told(mesh, surfaces), (std::map<IrCodes, long>{{{1, 2}, 4}, {{5, 9}, 8}}));
    surfaces = erased(surfaces, mesh, {0, 1});
    EXPECT_EQ(told(mesh, surfaces), (std::map<IrCodes, long>{{{1, 2}, 2}, {{5, 9}, 10}}));
    surfaces = erased(surfaces, mesh, {2, 3, 4, 5});
    EXPECT_THAT(surfaces, IsEmpty());
}

TEST(Painting, MirroredPartsArePaintedOnTheSideThatIsSeen) {
    osg::ref_ptr<osg::MatrixTransform> graph =
        new osg::MatrixTransform(osg::Matrixd::scale(-2, 1, 1));
    graph->addChild(cube({0, 0, 0}));
    const FaceMesh mesh = meshOf(*graph);
    const Surfaces surfaces = painted({}, mesh, {4, 5}, {3, 3});
    const auto& c = surfaces[0].triangles[0];
    const osg::Vec3d a(c[0], c[1], c[2]), b(c[3], c[4], c[5]), d(c[6], c[7], c[8]);
    EXPECT_LT(((b - a) ^ (d - a)).y(), 0.0) << "the front looks towards -y";
    EXPECT_EQ(read(graph, surfaces), (std::map<IrCodes, long>{{{0, 0}, 10}, {{3, 3}, 2}}));
}

TEST(Painting, QuadsGoWithBothTheirTriangles) {
    osg::ref_ptr<osg::Group> graph = new osg::Group;
    graph->addChild(polygon(square, {}));
    const FaceMesh mesh = meshOf(*graph);
    ASSERT_EQ(mesh.faces().size(), 1u);
    Surfaces surfaces = painted({}, mesh, {0}, {1, 1});
    EXPECT_EQ(trianglesIn(surfaces), 2u);
    surfaces = painted(surfaces, mesh, {0}, {2, 2});
    EXPECT_EQ(trianglesIn(surfaces), 2u);
    EXPECT_THAT(erased(surfaces, mesh, {0}), IsEmpty());
}

TEST(Painting, WhatWasPaintedOnAnotherCutIsPaintedOverPieceByPiece) {
    // A square of two triangles, exported anew as 16 squares.
    osg::ref_ptr<osg::Group> coarse = new osg::Group, fine = new osg::Group;
    coarse->addChild(polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {}));
    for (int i = 0; i < 16; ++i) {
        const auto x = static_cast<float>(i % 4), y = static_cast<float>(i / 4);
        fine->addChild(polygon({{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}}, {}));
    }
    const FaceMesh whole = meshOf(*coarse), cut = meshOf(*fine);
    const Surfaces before = painted({}, whole, {0}, {1, 1});
    EXPECT_EQ(told(cut, before), (std::map<IrCodes, long>{{{1, 1}, 16}}));
    for (unsigned int f = 0; f < 16; ++f) {
        const Surfaces over = painted(before, cut, {f}, {2, std::nullopt});
        EXPECT_EQ(told(cut, over), (std::map<IrCodes, long>{{{1, 1}, 15}, {{2, 1}, 1}})) << f;
        const Surfaces less = erased(before, cut, {f});
        std::vector<std::string> remarks;
        EXPECT_EQ(read(fine, less, &remarks), (std::map<IrCodes, long>{{{0, 0}, 1}, {{1, 1}, 15}}))
            << f;
        EXPECT_THAT(remarks, IsEmpty());
    }
}

TEST(Painting, SmallFacesBesideLargeOnesKeepTheirCodes) {
    // A strip of squares that are smaller than the tolerance of what is painted on another cut.
    osg::ref_ptr<osg::Group> graph = new osg::Group;
    graph->addChild(polygon({{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0}}, {}));
    for (int i = 0; i < 10; ++i) {
        const float x = 0.05F * static_cast<float>(i);
        graph->addChild(
            polygon({{x, -0.05F, 0}, {x + 0.05F, -0.05F, 0}, {x + 0.05F, 0, 0}, {x, 0, 0}}, {}));
    }
    const FaceMesh mesh = meshOf(*graph);
    Surfaces surfaces = painted({}, mesh, {0}, {1, 1});
    for (unsigned int f = 1; f < 11; f += 2) {
        surfaces = painted(surfaces, mesh, {f}, {static_cast<int>(f), 2});
    }
    const auto codes = mesh.codes(surfaces);
    EXPECT_EQ(codes[0], (IrCodes{1, 1}));
    for (unsigned int f = 1; f < 11; f += 2) {
        EXPECT_EQ(codes[f], (IrCodes{static_cast<int>(f), 2}));
    }
}

TEST(Painting, AfterANewExportWithATenthOfTheFacesMovedTheRestIsKeptAndTheLossTold) {
    const auto ball = sphere(20);
    const FaceMesh mesh = meshOf(*ball);
    FaceNumbers all(mesh.faces().size());
    for (unsigned int f = 0; f < all.size(); ++f) {
        all[f] = f;
    }
    const Surfaces surfaces = painted({}, mesh, all, {3, 4});
    // Exported anew: every tenth triangle lies elsewhere.
    const auto anew = sphere(20);
    auto& corners =
        static_cast<osg::Vec3Array&>(*anew->getDrawable(0)->asGeometry()->getVertexArray());
    for (std::size_t f = 0; f < corners.size() / 3; f += 10) {
        for (std::size_t k = 0; k < 3; ++k) {
            corners[3 * f + k] *= 1.1F;
        }
    }
    std::vector<std::string> remarks;
    const auto count = static_cast<long>(all.size());
    EXPECT_EQ(read(anew, surfaces, &remarks),
              (std::map<IrCodes, long>{{{0, 0}, count / 10}, {{3, 4}, count - count / 10}}));
    EXPECT_THAT(remarks, ElementsAre(HasSubstr(std::to_string(count / 10) + " of " +
                                               std::to_string(count) + " triangles")));
    // What moved is painted again; what lies nowhere stays as it is, and is still told.
    const FaceMesh moved = meshOf(*anew);
    const Surfaces again = painted(surfaces, moved, {0, 10}, {3, 4});
    EXPECT_EQ(told(moved, again).at({3, 4}), count - count / 10 + 2);
}

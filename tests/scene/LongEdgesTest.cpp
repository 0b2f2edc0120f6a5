#include "irsg/geometry/mesh/LongEdges.h"

#include <gtest/gtest.h>

#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes paint{1, 1}, glass{1, 2};

std::vector<ModelEdge> edgesOf(const Triangles& mesh) {
    return modelOf(mesh)->mesh()->longEdges;
}

TEST(LongEdges, OfABoxAreItsTwelveAndNoDiagonals) {
    const auto edges = edgesOf(boxMesh({3.0, 2.0, 1.0}, std::vector(6, paint)));
    ASSERT_EQ(edges.size(), 12u);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        EXPECT_NEAR(length(edges[i].to_m - edges[i].from_m), i < 4 ? 6.0 : i < 8 ? 4.0 : 2.0, 1e-6);
    }
}

TEST(LongEdges, PartPlanesOnlyWhereTheirCodesDiffer) {
    const Triangles left = plateMesh({-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, paint);
    const auto one = joined(left, plateMesh({1, 0, 0}, {1, 0, 0}, {0, 0, 1}, paint));
    const auto two = joined(left, plateMesh({1, 0, 0}, {1, 0, 0}, {0, 0, 1}, glass));
    EXPECT_EQ(edgesOf(one).size(), 6u);
    EXPECT_EQ(edgesOf(two).size(), 7u);
}

TEST(LongEdges, AreNoneOnAFineMeshAndFewOnAnyOther) {
    EXPECT_TRUE(edgesOf(sphereMesh(1.0, 32, 64, paint)).empty());
    Triangles boxes;
    for (int i = 0; i < 5; ++i) {
        Triangles box = boxMesh({1.0, 1.0, 1.0}, std::vector(6, paint));
        for (Triangle& triangle : box) {
            for (Vec3& vertex : triangle.vertex) {
                vertex.x += 1.5 * i;
            }
        }
        boxes = joined(boxes, box);
    }
    EXPECT_EQ(edgesOf(boxes).size(), mostLongEdges);
}

} // namespace

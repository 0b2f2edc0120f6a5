// Which triangles hang together, and what of it is closed.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "irsg/geometry/mesh/MeshSurfaces.h"
#include "tests/support/RevolvedMeshes.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

std::vector<MeshSurface> surfacesOf(const Triangles& triangles) {
    return irsg::surfacesOf(*modelOf(triangles)->mesh());
}

Triangles box() {
    return boxMesh({1, 2, 3}, std::vector<IrCodes>(6, {1, 1}));
}

} // namespace

TEST(MeshSurfaces, ABoxIsOneAndClosedWhateverItsMaterials) {
    for (const Triangles& mesh :
         {box(), boxMesh({1, 2, 3}, {{1, 1}, {2, 2}, {3, 3}, {1, 1}, {2, 2}, {3, 3}})}) {
        const std::vector<MeshSurface> surfaces = surfacesOf(mesh);
        ASSERT_EQ(surfaces.size(), 1u);
        EXPECT_TRUE(surfaces[0].isClosed());
        EXPECT_EQ(surfaces[0].facets, 12u);
        EXPECT_NEAR(surfaces[0].area_m2, 8.0 * (2.0 + 3.0 + 6.0), 1e-4);
        EXPECT_EQ(surfaces[0].flippedEdges + surfaces[0].sharedEdges, 0u);
    }
}

TEST(MeshSurfaces, WhatIsMissingAndWhatIsFlippedIsCountedByEdges) {
    Triangles open = box();
    open.pop_back();
    ASSERT_EQ(surfacesOf(open).size(), 1u);
    EXPECT_EQ(surfacesOf(open)[0].openEdges, 3u);
    EXPECT_FALSE(surfacesOf(open)[0].isClosed());

    Triangles flipped = box();
    std::swap(flipped[0].vertex[1], flipped[0].vertex[2]);
    EXPECT_TRUE(surfacesOf(flipped)[0].isClosed());
    EXPECT_EQ(surfacesOf(flipped)[0].flippedEdges, 3u);
}

TEST(MeshSurfaces, SeparateBodiesComeByTheirAreasAndTouchingOnesAreOne) {
    const Triangles plate = plateMesh({0, 0, 20}, {2, 0, 0}, {0, 2, 0}, {1, 1});
    const std::vector<MeshSurface> apart =
        surfacesOf(joined(plate, joined(moved(box(), {10, 0, 0}), sphereMesh(1.0, 8, 16, {2, 2}))));
    ASSERT_EQ(apart.size(), 3u);
    EXPECT_EQ(apart[0].facets, 12u);
    EXPECT_TRUE(apart[1].openEdges == 4u || apart[2].openEdges == 4u);
    EXPECT_EQ(std::ranges::count_if(apart, &MeshSurface::isClosed), 2);
    // Two boxes with one common edge: four triangles meet there.
    const std::vector<MeshSurface> touching = surfacesOf(joined(box(), moved(box(), {2, 4, 0})));
    ASSERT_EQ(touching.size(), 1u);
    EXPECT_EQ(touching[0].sharedEdges, 1u);
    EXPECT_TRUE(touching[0].isClosed());
}

TEST(MeshSurfaces, SidesAreCountedAndNothingHasNone) {
    Triangles mixed = box();
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        mixed[i].cullsBackFaces = i < 5;
    }
    EXPECT_EQ(surfacesOf(mixed)[0].twoSidedFacets, 7u);
    EXPECT_TRUE(irsg::surfacesOf(Mesh{}).empty());
}

TEST(MeshSurfaces, PlacesAreEqualButForRounding) {
    PlaceNumbers numbers(1e-6);
    const std::uint32_t first = numbers.of({1, 2, 3});
    EXPECT_EQ(numbers.of({1, 2, 3 + 1e-9}), first);
    EXPECT_NE(numbers.of({1, 2, 3.01}), first);
    EXPECT_EQ(numbers.of({1, 2, 3}), first);
    EXPECT_EQ(numbers.of({0.0, 0.0, 0.0}), numbers.of({-0.0, 1e-9, -1e-9}));
    // More than the first table of slots has room for.
    for (std::uint32_t i = 0; i < 1000; ++i) {
        EXPECT_EQ(numbers.of({10.0 + i, 0, 0}), 3 + i);
    }
    EXPECT_EQ(numbers.of({10.0, 0, 0}), 3u);
}

// The division of surfaces where others stand on them, and which places are one surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "irsg/radiance/exchange/ExchangeNodes.h"
#include "irsg/radiance/exchange/SurfaceWays.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/RayVectors.h"
#include "tests/support/RaysTest.h"
#include "tests/support/RevolvedMeshes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

using Line = FacetDivision::Line;

double areaOf(const FacetDivision::Triangle& t) {
    const FacetPlace b = t[1] - t[0], c = t[2] - t[0];
    return 0.5 * (b.u * c.v - b.v * c.u);
}

FacetPlace placeIn(const FacetDivision::Triangle& t, double a, double b) {
    const double root = std::sqrt(a);
    return t[0] + (t[1] - t[0]) * (root * (1.0 - b)) + (t[2] - t[0]) * (root * b);
}

constexpr FacetDivision::Triangle whole{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};

class ExchangeMeshTest : public RaysTest {};

std::unique_ptr<const ExchangeMesh> meshOf(const Triangles& triangles, bool isTwoSided = true,
                                           const ExchangeResolution& resolution = {}) {
    const std::shared_ptr<const Mesh> mesh = modelOf(triangles)->mesh();
    PieceUses uses(mesh->pieces.size());
    for (std::size_t i = 0; i < mesh->pieces.size(); ++i) {
        uses.set(i, {true, false, !isTwoSided, 0});
    }
    return std::make_unique<ExchangeMesh>(RayMesh::of(mesh), uses, resolution);
}

/// The cell that is met from `from_m` downwards.
ExchangeMesh::Place below(const ExchangeMesh& mesh, const Vec3& from_m) {
    PieceUses uses(mesh.rays().pieces());
    for (std::size_t i = 0; i < mesh.rays().pieces(); ++i) {
        uses.set(i, {true, false, false, 0});
    }
    RayHit hit;
    std::vector<RayHit> through;
    EXPECT_TRUE(mesh.rays().meet({from_m, {0, 0, -1}}, uses, 0.0, hit, through));
    return mesh.placeOf(hit);
}

/// Vertices that one can go to from a cell, along the surface on its side.
std::vector<bool> reachedFrom(const ExchangeMesh& mesh, std::uint32_t cell) {
    std::vector<bool> reached(mesh.vertices().size());
    std::vector<std::uint32_t> open(mesh.corners(cell).begin(), mesh.corners(cell).end());
    while (!open.empty()) {
        const std::uint32_t at = open.back();
        open.pop_back();
        if (reached[at]) {
            continue;
        }
        reached[at] = true;
        open.insert(open.end(), mesh.beside(at).begin(), mesh.beside(at).end());
    }
    return reached;
}

bool isReached(const ExchangeMesh& mesh, const Vec3& from_m, const Vec3& to_m) {
    return reachedFrom(mesh, below(mesh, from_m).cell)[mesh.corners(below(mesh, to_m).cell)[0]];
}

Triangles groundOf(double half_m) {
    return plateMesh({0, 0, 0}, {half_m, 0, 0}, {0, half_m, 0}, {1, 1});
}

/// The side walls of a box that is open above and below.
Triangles fence(double half_m, double height_m) {
    const double up_m = 0.5 * height_m;
    Triangles all;
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        all = joined(all, plateMesh({x * half_m, y * half_m, up_m}, {-y * half_m, x * half_m, 0},
                                    {0, 0, up_m}, {1, 1}));
    }
    return all;
}

} // namespace

TEST(FacetDivisionTest, CellsTileTheFacetAndNoWallGoesThroughThem) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> even(-0.2, 1.2), inside(0.0, 1.0);
    constexpr double tolerance = 1e-6;
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Line> walls;
        for (int i = 0; i < trial % 9; ++i) {
            Line wall{{even(random), even(random)}, {even(random), even(random)}};
            if (FacetDivision::clip(wall, whole, 0.0)) {
                walls.push_back(wall);
            }
        }
        FacetDivision division(walls, tolerance);
        division.refine(
            [&](std::uint32_t, const FacetDivision::Triangle& t) { return areaOf(t) > 0.04; },
            [](const FacetPlace& a, const FacetPlace& b) {
                return std::hypot(b.u - a.u, b.v - a.v);
            });
        double area = 0.0;
        for (std::uint32_t i = 0; i < division.cells().size(); ++i) {
            const FacetDivision::Triangle& corners = division.cells()[i].corners;
            ASSERT_GT(areaOf(corners), 0.0);
            area += areaOf(corners);
            for (int n = 0; n < 5; ++n) {
                const FacetPlace place = placeIn(corners, inside(random), inside(random));
                ASSERT_EQ(division.cellOf(place), i) << "trial " << trial;
            }
            for (Line wall : walls) {
                const bool goesThrough =
                    FacetDivision::clip(wall, corners, -tolerance) &&
                    std::hypot(wall.to.u - wall.from.u, wall.to.v - wall.from.v) > 2.0 * tolerance;
                ASSERT_FALSE(goesThrough) << "trial " << trial << ", cell " << i;
            }
        }
        EXPECT_NEAR(area, 0.5, 1e-12);
    }
}

TEST(FacetDivisionTest, AWallIsBetweenPlacesOnItsTwoSidesAndNotBeyondItsEnd) {
    const FacetDivision division({{{0.2, 0.0}, {0.2, 0.4}}}, 1e-6);
    const FacetPlace left{0.199, 0.2}, right{0.201, 0.2}, leftBeyond{0.199, 0.6},
        rightBeyond{0.201, 0.6};
    EXPECT_NE(division.cellOf(left), division.cellOf(right));
    EXPECT_TRUE(division.isBetween(division.cellOf(left), left, right));
    EXPECT_TRUE(division.isBetween(division.cellOf(right), left, right));
    EXPECT_FALSE(division.isBetween(division.cellOf(leftBeyond), leftBeyond, rightBeyond));
}

/// The vertices about one as SurfaceWays finds them, by the length of each way found by giving it
/// on from vertex to vertex until nothing changes.
std::map<std::size_t, double> aboutByPatience(const ExchangeMesh& mesh, std::size_t from,
                                              double most_m) {
    const auto& vertices = mesh.vertices();
    std::vector<double> ways_m(vertices.size(), std::numeric_limits<double>::infinity());
    ways_m[from] = 0.0;
    for (bool isChanged = true; isChanged;) {
        isChanged = false;
        for (std::uint32_t v = 0; v < vertices.size(); ++v) {
            for (const std::uint32_t next : mesh.beside(v)) {
                const double way_m =
                    ways_m[v] + plainLength(vertices[next].at_m - vertices[v].at_m);
                if (way_m < ways_m[next]) {
                    ways_m[next] = way_m;
                    isChanged = true;
                }
            }
        }
    }
    std::map<std::size_t, double> found;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const double apart_m = length(vertices[v].at_m - vertices[from].at_m);
        if (vertices[v].piece == vertices[from].piece && apart_m < most_m &&
            ways_m[v] <= std::min(2.5 * apart_m, 1.5 * most_m)) {
            found[v] = apart_m;
        }
    }
    return found;
}

TEST_F(ExchangeMeshTest, FindsAllVerticesAboutOneByTheShortestWays) {
    // A ball, a plate of fine and long triangles with a fence on it, and a fence.
    Triangles fenced = fence(0.7, 0.4);
    for (int x = -10; x < 10; ++x) {
        for (int y = -2; y < 2; ++y) {
            fenced = joined(fenced, plateMesh({0.1 * x + 0.05, 0.5 * y + 0.25, 0}, {0.05, 0, 0},
                                              {0, 0.25, 0}, {1, 1}));
        }
    }
    for (const Triangles& triangles :
         {sphereOfEqualArea(1.0, 24, {1, 1}), fenced, fence(1.0, 1.0)}) {
        const auto mesh = meshOf(triangles);
        const auto isOfFirst = [](const ExchangeMesh::Vertex& vertex) { return vertex.piece == 0; };
        const auto count = static_cast<std::size_t>(
            std::ranges::count_if(mesh->vertices(), isOfFirst)); // pieces follow each other
        ASSERT_TRUE(std::ranges::all_of(std::span(mesh->vertices()).first(count), isOfFirst));
        SurfaceWays ways(*mesh, 0, count);
        std::size_t most = 0;
        for (std::size_t from = 0; from < count; from += 1 + count / 7) {
            for (const double most_m : {0.0, 0.01, 0.15, 0.6, 5.0}) {
                std::map<std::size_t, double> found;
                ways.forEachAbout(from, most_m, [&](std::size_t at, double apart_m) {
                    EXPECT_TRUE(found.emplace(at, apart_m).second) << "twice";
                });
                EXPECT_EQ(found, aboutByPatience(*mesh, from, most_m)) << from << ' ' << most_m;
                most = std::max(most, found.size());
            }
        }
        EXPECT_GT(most, 4U);
    }
}

TEST_F(ExchangeMeshTest, TheGroundInsideAFenceIsASurfaceOfItsOwn) {
    for (const double half_m : {0.5, 0.503}) {
        const auto mesh = meshOf(joined(groundOf(2.0), fence(half_m, 0.3)));
        const Vec3 in{0.1, 0.07, 0.2}, alsoIn{-0.4, -0.41, 0.2}, out{0.9, 0.07, 0.2},
            alsoOut{-1.2, -1.3, 0.2};
        EXPECT_TRUE(isReached(*mesh, in, alsoIn));
        EXPECT_TRUE(isReached(*mesh, out, alsoOut));
        EXPECT_FALSE(isReached(*mesh, in, out));
        // Cells fit: none lies on both sides.
        for (std::uint32_t cell = 0; cell < mesh->cells(); ++cell) {
            if (mesh->normal(cell).z < 0.9) {
                continue;
            }
            int within = 0, outside = 0;
            for (const Vec3& corner : mesh->cornersAt_m(cell)) {
                const double far = std::max(std::abs(corner.x), std::abs(corner.y));
                within += far < half_m - 1e-4 ? 1 : 0;
                outside += far > half_m + 1e-4 ? 1 : 0;
            }
            EXPECT_FALSE(within > 0 && outside > 0) << "cell " << cell;
        }
    }
}

TEST_F(ExchangeMeshTest, TheOtherSideOfTheGroundKnowsNothingOfTheFence) {
    const auto mesh = meshOf(joined(groundOf(2.0), fence(0.5, 0.3)));
    std::vector<bool> reached;
    for (std::uint32_t cell = 0; cell < mesh->cells(); ++cell) {
        if (mesh->normal(cell).z < -0.9) {
            if (reached.empty()) {
                reached = reachedFrom(*mesh, cell);
            }
            EXPECT_TRUE(reached[mesh->corners(cell)[0]]);
        }
    }
    EXPECT_FALSE(reached.empty());
}

TEST_F(ExchangeMeshTest, AWallWithFreeEndsIsGoneAround) {
    const Triangles wall = plateMesh({0, 0.1, 0.2}, {0.5, 0, 0}, {0, 0, 0.2}, {1, 1});
    const auto mesh = meshOf(joined(groundOf(2.0), wall));
    const Vec3 before{0.03, 0.05, 0.6}, behind{0.03, 0.15, 0.6};
    EXPECT_TRUE(isReached(*mesh, before, behind));
    // But no node has a part on both sides of its middle.
    ExchangeResolution resolution;
    const ExchangeNodes nodes(
        std::shared_ptr<const ExchangeMesh>(meshOf(joined(groundOf(2.0), wall))), resolution);
    for (const ExchangeNodes::Share& a :
         ExchangeNodes::OfPlace(nodes, below(nodes.mesh(), before))) {
        for (const ExchangeNodes::Share& b :
             ExchangeNodes::OfPlace(nodes, below(nodes.mesh(), behind))) {
            EXPECT_FALSE(a.node == b.node && a.part > 0.01f && b.part > 0.01f);
        }
    }
}

TEST_F(ExchangeMeshTest, ASheetOfTwoCopiesCutsWhatLiesCloseBelowIt) {
    // As propeller discs are drawn: each copy turns to one side, and both have the same edges.
    const auto sheet = [](const Vec3& centre, double half_m) {
        return joined(oneSidedPlate(centre, {half_m, 0, 0}, {0, half_m, 0}, {1, 1}),
                      oneSidedPlate(centre, {0, half_m, 0}, {half_m, 0, 0}, {1, 1}));
    };
    const auto mesh = meshOf(joined(sheet({}, 1.0), sheet({0.2, 0.1, 1e-3}, 0.5)), false);
    const auto isBelow = [](const Vec3& at_m, double off_m) {
        return std::max(std::abs(at_m.x - 0.2), std::abs(at_m.y - 0.1)) < 0.5 + off_m;
    };
    int below = 0, beside = 0;
    for (std::uint32_t cell = 0; cell < mesh->cells(); ++cell) {
        const std::array<Vec3, 3> c = mesh->cornersAt_m(cell);
        if (mesh->normal(cell).z < 0.9 || c[0].z > 5e-4) {
            continue;
        }
        const bool isMiddleBelow = isBelow((c[0] + c[1] + c[2]) * (1.0 / 3.0), 0.0);
        ++(isMiddleBelow ? below : beside);
        for (const Vec3& corner : c) {
            EXPECT_TRUE(isMiddleBelow ? isBelow(corner, 1e-4) : !isBelow(corner, -1e-4));
        }
    }
    EXPECT_GT(below, 10);
    EXPECT_GT(beside, 10);
    EXPECT_FALSE(isReached(*mesh, {0.2, 0.1, 5e-4}, {-0.8, 0.1, 5e-4}));
}

TEST_F(ExchangeMeshTest, NodesOfManySendTogetherWithTheirOwnSide) {
    const Triangles cabin = moved(boxMesh({1, 2, 3}, std::vector<IrCodes>(6, {1, 1})), {0.1, 0, 0});
    ExchangeResolution resolution;
    resolution.fewSenders = 100;
    const ExchangeNodes nodes(std::shared_ptr<const ExchangeMesh>(meshOf(cabin)), resolution);
    EXPECT_LT(nodes.senders(), nodes.nodes() / 2);
    // Of each sender: where its surface is; its walls are a plane each.
    std::vector<Vec3> sums(nodes.senders());
    std::vector<int> counts(nodes.senders());
    for (std::uint32_t cell = 0; cell < nodes.mesh().cells(); ++cell) {
        for (const std::uint32_t corner : nodes.mesh().corners(cell)) {
            for (const ExchangeNodes::Share& share : nodes.sharesOf(corner)) {
                const std::uint32_t sender = nodes.senderOf(share.node);
                sums[sender] = sums[sender] + nodes.mesh().normal(cell);
                ++counts[sender];
            }
        }
    }
    for (std::size_t s = 0; s < sums.size(); ++s) {
        ASSERT_GT(counts[s], 0);
        EXPECT_NEAR(length(sums[s]) / counts[s], 1.0, 1e-9);
    }
    // Alone where they are few.
    const ExchangeNodes few(std::shared_ptr<const ExchangeMesh>(meshOf(cabin)),
                            {.fewSenders = 100'000});
    EXPECT_EQ(few.senders(), few.nodes());
    // No fewer than are allowed where little would do.
    resolution.fewSenders = nodes.nodes() * 3 / 4;
    const ExchangeNodes some(std::shared_ptr<const ExchangeMesh>(meshOf(cabin)), resolution);
    EXPECT_EQ(some.nodes(), nodes.nodes());
    EXPECT_LE(some.senders(), resolution.fewSenders);
    EXPECT_GT(some.senders(), nodes.senders());
}

TEST_F(ExchangeMeshTest, SmoothingKeepsWhatIsTheSameEverywhereAndSumsOverSurfaces) {
    const Triangles room = joined(boxMesh({1, 2, 3}, std::vector<IrCodes>(6, {1, 1})),
                                  sphereMesh(0.5, 12, 24, {2, 2}));
    const ExchangeNodes nodes(std::shared_ptr<const ExchangeMesh>(meshOf(room)), {});
    std::vector<double> received_m2(nodes.nodes());
    for (std::uint32_t n = 0; n < nodes.nodes(); ++n) {
        if (nodes.areaOf_m2(n) == 0.0) {
            continue;
        }
        EXPECT_NEAR(nodes.smoothing().sumOf(n), 1.0, 1e-5);
        const auto [first, last] = nodes.smoothing().of(n);
        for (const LightPair* pair = first; pair != last; ++pair) {
            received_m2[pair->sender] += nodes.areaOf_m2(n) * static_cast<double>(pair->factor);
        }
    }
    for (std::uint32_t n = 0; n < nodes.nodes(); ++n) {
        EXPECT_NEAR(received_m2[n], nodes.areaOf_m2(n), 1e-5 * nodes.areaOf_m2(n) + 1e-9);
    }
}

TEST_F(ExchangeMeshTest, SmoothingIsTheProductOfWhatIsBetweenNodes) {
    // Values at nodes are linear over cells between their means at corners. Of two such functions,
    // which are random here, the integral of the product is that of node values and means.
    const Triangles room = joined(boxMesh({1, 2, 3}, std::vector<IrCodes>(6, {1, 1})),
                                  sphereMesh(0.5, 12, 24, {2, 2}));
    const ExchangeNodes nodes(std::shared_ptr<const ExchangeMesh>(meshOf(room)), {});
    const auto valueOf = [](std::uint32_t node, std::size_t which) {
        return std::sin(12.9898 * node + 78.233 * static_cast<double>(which));
    };
    double integral = 0.0;
    for (std::uint32_t cell = 0; cell < nodes.mesh().cells(); ++cell) {
        std::array<std::array<double, 3>, 2> at{};
        for (std::size_t c = 0; c < 3; ++c) {
            for (const ExchangeNodes::Share& share :
                 nodes.sharesOf(nodes.mesh().corners(cell)[c])) {
                for (std::size_t which = 0; which < 2; ++which) {
                    at[which][c] += static_cast<double>(share.part) * valueOf(share.node, which);
                }
            }
        }
        for (std::size_t c = 0; c < 3; ++c) { // middles of edges: exact for products
            const std::size_t next = (c + 1) % 3;
            integral += nodes.mesh().area_m2(cell) / 3.0 * 0.25 * (at[0][c] + at[0][next]) *
                        (at[1][c] + at[1][next]);
        }
    }
    double sum = 0.0;
    for (std::uint32_t n = 0; n < nodes.nodes(); ++n) {
        const auto [first, last] = nodes.smoothing().of(n);
        for (const LightPair* pair = first; pair != last; ++pair) {
            sum += nodes.areaOf_m2(n) * valueOf(n, 0) * static_cast<double>(pair->factor) *
                   valueOf(pair->sender, 1);
        }
    }
    double area_m2 = 0.0;
    for (std::uint32_t n = 0; n < nodes.nodes(); ++n) {
        area_m2 += nodes.areaOf_m2(n);
    }
    EXPECT_NEAR(sum, integral, 1e-6 * area_m2);
}

TEST_F(ExchangeMeshTest, WhatABodyHidesOfAnotherIsASurfaceOfItsOwn) {
    // A bar through a ball, both read with two sides: its middle is inside.
    const Triangles ball = sphereMesh(1.0, 16, 32, {1, 1});
    const Triangles bar = boxMesh({3.0, 0.2, 0.1}, std::vector<IrCodes>(6, {2, 2}));
    const auto mesh = meshOf(joined(ball, bar));
    std::vector<bool> inside;
    for (std::uint32_t cell = 0; cell < mesh->cells(); ++cell) {
        const std::array<Vec3, 3> c = mesh->cornersAt_m(cell);
        const Vec3 middle = (c[0] + c[1] + c[2]) * (1.0 / 3.0);
        if (mesh->normal(cell).z < 0.9 || std::abs(middle.z - 0.1) > 1e-3) {
            continue;
        }
        if (inside.empty() && length(middle) < 0.5) {
            inside = reachedFrom(*mesh, cell);
        }
    }
    ASSERT_FALSE(inside.empty());
    int within = 0, outside = 0;
    for (std::uint32_t v = 0; v < inside.size(); ++v) {
        const Vec3& at_m = mesh->vertices()[v].at_m;
        if (mesh->sights()[v].normal.z > 0.9 && std::abs(at_m.z - 0.1) < 1e-3) {
            if (length(at_m) < 0.97) {
                ++within;
                EXPECT_TRUE(inside[v]);
            } else if (length(at_m) > 1.03) {
                ++outside;
                EXPECT_FALSE(inside[v]);
            }
        }
    }
    EXPECT_GT(within, 0);
    EXPECT_GT(outside, 0);
}

TEST_F(ExchangeMeshTest, ConvexBodiesSeeNothingAndCornersDo) {
    const auto ball = meshOf(oneSided(sphereMesh(1.0, 16, 32, {1, 1})), false);
    for (std::uint32_t cell = 0; cell < ball->cells(); ++cell) {
        EXPECT_FALSE(ball->seesAnything(cell));
    }
    const auto room = meshOf(boxMesh({1, 2, 3}, std::vector<IrCodes>(6, {1, 1})));
    for (std::uint32_t cell = 0; cell < room->cells(); ++cell) {
        const std::array<Vec3, 3> c = room->cornersAt_m(cell);
        EXPECT_EQ(room->seesAnything(cell), dot(room->normal(cell), c[0]) < 0.0);
    }
}

TEST_F(ExchangeMeshTest, AConvexBodyThatStandsAloneHasNoCells) {
    ExchangeResolution alone;
    alone.hasInsides = alone.isAlone = true;
    const Triangles ball = sphereMesh(1.0, 16, 32, {1, 1});
    const Triangles box = boxMesh({1, 2, 3}, std::vector<IrCodes>(6, {1, 1}));
    for (const bool isTwoSided : {true, false}) {
        EXPECT_EQ(meshOf(ball, isTwoSided, alone)->cells(), 0u);
        EXPECT_EQ(meshOf(box, isTwoSided, alone)->cells(), 0u);
        EXPECT_GT(meshOf(ball, isTwoSided)->cells(), 0u);
        // Two of them, one with an opening, one turned inside out, and one with a dent are not.
        EXPECT_GT(meshOf(joined(ball, moved(ball, {5, 0, 0})), isTwoSided, alone)->cells(), 0u);
        EXPECT_GT(meshOf(Triangles(box.begin(), box.end() - 1), isTwoSided, alone)->cells(), 0u);
        EXPECT_GT(meshOf(reversed(box), isTwoSided, alone)->cells(), 0u);
        Triangles dented = box;
        for (Triangle& triangle : dented) {
            for (Vec3& vertex : triangle.vertex) {
                if (vertex == Vec3{1, 2, 3}) {
                    vertex = {0, 0, 0};
                }
            }
        }
        EXPECT_GT(meshOf(dented, isTwoSided, alone)->cells(), 0u);
    }
}

TEST_F(ExchangeMeshTest, SpacesInsideAreToldApartUnlessTheyAreOpen) {
    ExchangeResolution resolution;
    resolution.hasInsides = true;
    const auto insideOf = [&](const Triangles& triangles) {
        const auto mesh = meshOf(triangles, true, resolution);
        std::size_t inside = 0;
        for (std::uint32_t cell = 0; cell < mesh->cells(); ++cell) {
            inside += mesh->isInside(cell) ? 1 : 0;
        }
        return static_cast<double>(inside) / static_cast<double>(mesh->cells());
    };
    const Triangles box = boxMesh({1, 2, 3}, std::vector<IrCodes>(6, {1, 1}));
    const Triangles two = joined(box, moved(box, {5, 0, 0}));
    EXPECT_GT(insideOf(two), 0.3);
    EXPECT_LT(insideOf(two), 0.9);
    EXPECT_EQ(insideOf(joined(Triangles(box.begin(), box.end() - 2),
                              moved(Triangles(box.begin(), box.end() - 2), {5, 0, 0}))),
              0.0);
}

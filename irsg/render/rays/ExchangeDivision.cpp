#include <cmath>
#include <numeric>

#include "irsg/core/JoinedNumbers.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/render/rays/ExchangeMeshMaking.h"
#include "irsg/render/rays/LightDirections.h"

namespace irsg {

namespace {

/// Of models with more sides, some are probed for all.
constexpr std::size_t mostProbed = 200'000;
/// Of a part of a side; of one that is a large part of the surface, where what stands before it
/// fills little of its hemisphere.
constexpr std::uint32_t fewRays = 16, someRays = 32, manyRays = 256;
constexpr std::size_t manyParts = 20'000;
constexpr double nearest = 0.02; ///< that counts, of the longest edge
/// What is no higher above a side than this part of its own size casts a sharp shadow on it.
constexpr double lowPart = 0.1;
/// How high anything is looked for above a side, of its longest edge.
constexpr double mostHeight = 0.05;

double areaOf_m2(const Triangle3& c) {
    return 0.5 * length(crossed(c[1] - c[0], c[2] - c[0]));
}

} // namespace

BoundingBox ExchangeMesh::Making::boxAbove(const Facet& own, std::uint32_t side) const {
    const Vec3 up = normalOf(own, side);
    BoundingBox box = BoundingBox::nowhere();
    const Vec3 margin{2.0 * lift_m, 2.0 * lift_m, 2.0 * lift_m};
    for (const Vec3& corner : own.corners_m) {
        box.include(corner - margin);
        box.include(corner + margin);
        box.include(corner + up * (mostHeight * own.longest_m));
    }
    return box;
}

void ExchangeMesh::Making::findNeighbours(const Facet& own, std::uint32_t facet,
                                          const FacetTree& tree,
                                          std::vector<Neighbour>& found) const {
    found.clear();
    const std::array<BoundingBox, 2> above{boxAbove(own, 2 * facet), boxAbove(own, 2 * facet + 1)};
    BoundingBox both = above[0];
    both.include(above[1]);
    const double along_m = product(own.normal, own.corners_m[0]);
    const std::array<std::uint32_t, 3>& ownPlaces = places[facet];
    tree.forEachTouching(both, [&](std::uint32_t number, const FacetTree::Box& box) {
        std::size_t common = 0;
        for (const std::uint32_t place : places[number])
            for (const std::uint32_t ownPlace : ownPlaces)
                common += place == ownPlace ? 1 : 0;
        if (number == facet || common >= 2)
            return;
        Neighbour one{number, {}, cornersOf(number), {}};
        for (std::size_t i = 0; i < 3; ++i)
            one.along_m[i] = product(own.normal, one.corners_m[i]);
        one.isNear = {std::ranges::max(one.along_m) - (along_m + lift_m) > 0.0 &&
                          FacetTree::touch(box, above[0]),
                      -std::ranges::min(one.along_m) - (-along_m + lift_m) > 0.0 &&
                          FacetTree::touch(box, above[1])};
        if (one.isNear[0] || one.isNear[1])
            found.push_back(one);
    });
    std::ranges::sort(found, {}, &Neighbour::facet);
}

/// Walls: where facets cross the plane that rays from a side begin in. Facets in that of the side
/// itself do not, as of a box that stands on it; its walls do. The outline of what lies close above
/// the side is one, too: below it all is dark, beside it nothing.
std::vector<FacetDivision::Line>
ExchangeMesh::Making::wallsOn(std::uint32_t side, const Facet& own,
                              std::span<const Neighbour> neighbours) const {
    std::vector<FacetDivision::Line> walls;
    if (std::ranges::none_of(neighbours,
                             [&](const Neighbour& one) { return one.isNear[side % 2]; }))
        return walls;
    const double turn = side % 2 == 0 ? 1.0 : -1.0;
    const double offset_m = turn * product(own.normal, own.corners_m[0]) + lift_m;
    const Vec3 b = own.corners_m[1] - own.corners_m[0], c = own.corners_m[2] - own.corners_m[0];
    const Vec3 across = crossed(b, c);
    const double square = product(across, across);
    const auto placeOf = [&](const Vec3& at_m) {
        const Vec3 from = at_m - own.corners_m[0];
        return FacetPlace{product(crossed(from, c), across) / square,
                          product(crossed(b, from), across) / square};
    };
    const double tolerance = toleranceOf(own);
    for (const Neighbour& neighbour : neighbours) {
        if (!neighbour.isNear[side % 2])
            continue;
        const Triangle3& other_m = neighbour.corners_m;
        std::array<double, 3> above_m{};
        for (std::size_t i = 0; i < 3; ++i)
            above_m[i] = turn * neighbour.along_m[i] - offset_m;
        const auto addWall = [&](const Vec3& from_m, const Vec3& to_m) {
            FacetDivision::Line wall{placeOf(from_m), placeOf(to_m)};
            const FacetPlace along = wall.to - wall.from;
            if (std::hypot(along.u, along.v) > tolerance &&
                FacetDivision::clip(wall, FacetDivision::whole, 2.0 * tolerance))
                walls.push_back(wall);
        };
        if (std::ranges::min(above_m) > 0.0 &&
            std::ranges::max(above_m) < lowPart * std::sqrt(areaOf_m2(other_m)))
            for (std::size_t i = 0; i < 3; ++i)
                if (isOutline(neighbour.facet, i))
                    addWall(other_m[i], other_m[(i + 1) % 3]);
        std::array<Vec3, 2> ends{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3 && count < 2; ++i) {
            const std::size_t k = (i + 1) % 3;
            if ((above_m[i] > 0.0) != (above_m[k] > 0.0))
                ends[count++] = other_m[i] + (other_m[k] - other_m[i]) *
                                                 (above_m[i] / (above_m[i] - above_m[k]));
        }
        if (count == 2)
            addWall(ends[0], ends[1]);
    }
    return walls;
}

/// Whether there is anything beyond the plane of a side that does not turn its culled back
/// to all of it. On a convex body there is nothing. `known`: a facet that a side near it saw, which
/// is looked at first, or none; becomes the one that was found.
bool ExchangeMesh::Making::seesAny(std::uint32_t side, const Facet& own, const FacetTree& tree,
                                   double extent_m, std::uint32_t& known) const {
    const Vec3 up = normalOf(own, side);
    const double flat_m = flatOfExtent * extent_m;
    const double offset_m = product(up, own.corners_m[0]) + flat_m;
    const auto isSeen = [&](std::uint32_t number) {
        if (std::ranges::none_of(cornersOf(number), [&](const Vec3& corner) {
                return product(up, corner) > offset_m;
            }))
            return false;
        if (!roleOf(number).isCulled)
            return true;
        const Facet other = facetOf(number);
        const double before_m = product(other.normal, other.corners_m[0]) + flat_m;
        return std::ranges::any_of(own.corners_m, [&](const Vec3& corner) {
            return product(other.normal, corner) > before_m;
        });
    };
    if (known != none && isSeen(known))
        return true;
    // Of a fine mesh many boxes reach beyond the plane, and no facet: rays tell sooner.
    constexpr double marginOfFlat = 1e-3; // beyond rounding
    return tree.isAnyBeyond(up, offset_m, marginOfFlat * flat_m,
                            [&](std::uint32_t number, bool isWhole) {
                                if (isWhole ? roleOf(number).isCulled : !isSeen(number))
                                    return false;
                                known = number;
                                return true;
                            });
}

void ExchangeMesh::Making::findWalls(double extent_m) {
    std::vector<FacetTree::Box> boxes(facets());
    for (std::uint32_t f = 0; f < boxes.size(); ++f)
        if (roleOf(f).isMet && hasArea[f])
            for (const Vec3& corner : cornersOf(f))
                boxes[f].include(corner);
    cut.resize(sides());
    std::vector<char> seen(sides());
    const FacetTree tree(std::move(boxes));
    // Facets that follow each other mostly lie near each other, and see the same.
    constexpr std::size_t atOnce = 256;
    parallelFor((facets() + atOnce - 1) / atOnce, [&](std::size_t part) {
        std::array<std::uint32_t, 2> known{none, none}; // by front and back
        std::vector<Neighbour> neighbours;
        const std::size_t end = std::min(facets(), atOnce * (part + 1));
        for (auto facet = static_cast<std::uint32_t>(atOnce * part); facet < end; ++facet) {
            const std::array<std::uint32_t, 2> ofFacet{2 * facet, 2 * facet + 1};
            const Facet own = facetOf(facet);
            for (const std::uint32_t side : ofFacet)
                seen[side] = isThere(side) && seesAny(side, own, tree, extent_m, known[side % 2]);
            if (seen[ofFacet[0]] || seen[ofFacet[1]])
                findNeighbours(own, facet, tree, neighbours);
            for (const std::uint32_t side : ofFacet)
                if (const auto walls = seen[side] ? wallsOn(side, own, neighbours)
                                                  : std::vector<FacetDivision::Line>();
                    !walls.empty())
                    cut[side] = std::make_unique<FacetDivision>(walls, toleranceOf(own));
        }
    });
    sees.assign(seen.begin(), seen.end());
}

void ExchangeMesh::Making::sendProbes() {
    firstPart.reserve(sides() + 1);
    firstPart.push_back(0);
    for (std::uint32_t side = 0; side < sides(); ++side)
        firstPart.push_back(firstPart.back() + partsOf(side));
    const std::size_t parts = firstPart.back();
    const auto stride = static_cast<std::uint32_t>(2 * (parts / mostProbed) + 1);
    const auto isProbed = [&](std::uint32_t side) {
        return stride == 1 || side % (2 * stride) < 2 || partsOf(side) > 1;
    };
    probeOf.assign(parts, 0);
    std::uint32_t count = 1;
    for (std::uint32_t side = 0; side < sides(); ++side)
        for (std::uint32_t part = firstPart[side];
             sees[side] && part < firstPart[side + 1] && isProbed(side); ++part)
            probeOf[part] = count++;
    probes.resize(count);
    parallelForSmall(sides(), [&](std::uint32_t side) {
        if (sees[side] && isProbed(side))
            for (std::uint32_t part = 0; part < partsOf(side); ++part)
                probe(side, part);
    });
    for (std::uint32_t side = 0; side < sides(); ++side) {
        const std::uint32_t known = side - side % (2 * stride) + side % 2;
        if (sees[side] && !isProbed(side) && partsOf(known) > 0 &&
            pieceOf[known / 2] == pieceOf[side / 2])
            probeOf[firstPart[side]] = probeOf[firstPart[known]];
    }
}

void ExchangeMesh::Making::refine(std::span<const std::uint32_t> large, const CellSize& size) {
    parallelForSmall(large.size(), [&](std::uint32_t i) {
        const std::uint32_t side = large[i];
        if (!isAnyTooLarge(side, size))
            return;
        const Triangle3 c = cornersOf(side / 2);
        if (!cut[side])
            cut[side] = std::make_unique<FacetDivision>(std::vector<FacetDivision::Line>(),
                                                        toleranceOf(side));
        cut[side]->refine(
            [&](std::uint32_t part, const FacetDivision::Triangle& corners) {
                return isTooLarge(side, part, c, corners, size);
            },
            [&](const FacetPlace& from, const FacetPlace& to) {
                return plainLength(at(c, to) - at(c, from));
            });
    });
}

/// Parts that meet at edges turn to one space. It is inside where no ray left from any of them.
void ExchangeMesh::Making::findSpaces() {
    spaces.resize(probeOf.size());
    if (!resolution.hasInsides)
        return;
    firstCell = firstPart; // no part is divided yet
    JoinedNumbers parts(probeOf.size());
    for (std::uint32_t side = 0; side < sides(); ++side)
        for (std::uint32_t part = firstPart[side]; part < firstPart[side + 1]; ++part)
            for (std::size_t edge = 0; edge < 3; ++edge)
                if (const std::uint32_t beyond =
                        cellBeyond(side, part - firstPart[side], edge, false);
                    beyond != none)
                    parts.join(part, beyond);
    std::vector<bool> isOpen(probeOf.size());
    for (std::uint32_t part = 0; part < probeOf.size(); ++part)
        if (probeAt(part).isOpen())
            isOpen[parts.of(part)] = true;
    for (std::uint32_t part = 0; part < probeOf.size(); ++part)
        spaces[part] = isOpen[parts.of(part)] ? 0 : parts.of(part) + 1;
}

void ExchangeMesh::Making::probe(std::uint32_t side, std::uint32_t part) {
    const Facet facet = facetOf(side / 2);
    const Triangle3 c = facet.at(divisionOf(side).parts()[part].corners);
    Probe& own = probes[probeOf[firstPart[side] + part]];
    own.least_m = nearest * longestEdgeOf(c);
    const double ownArea_m2 = 0.5 * plainLength(crossed(c[1] - c[0], c[2] - c[0]));
    own.rays = ownArea_m2 > 0.01 * area_m2    ? manyRays
               : firstPart.back() < manyParts ? someRays
                                              : fewRays;
    const LightPoints points((firstPart[side] + part + 1) * 0x9e3779b9u);
    const Vec3 up = normalOf(facet, side);
    RayHit hit;
    std::vector<RayHit> through;
    for (std::uint32_t i = 0; i < own.rays; ++i) {
        const LightPoint point = points.at(i);
        // A part has no parts to choose from: its place takes the first two coordinates.
        const double root = std::sqrt(point[0]);
        const double u = root * (1.0 - point[1]), v = root * point[1];
        const Vec3 at = c[0] * (1.0 - u - v) + c[1] * u + c[2] * v;
        const Ray ray{at + up * lift_m, cosineDirection(up, point[2], point[3])};
        const bool isStopped = mesh.meet(ray, uses, 0.0, hit, through);
        own.stopped += isStopped ? 1 : 0;
        std::erase_if(through, [&](const RayHit& one) {
            return uses[static_cast<std::size_t>(one.piece)].pane == 0;
        });
        const auto nearest = std::ranges::min_element(through, {}, &RayHit::distance_m);
        if (isStopped || nearest != through.end())
            own.seen_m.push_back(ray.origin_m + ray.direction * (nearest != through.end()
                                                                     ? nearest->distance_m
                                                                     : hit.distance_m));
    }
}

bool ExchangeMesh::Making::isTooLarge(std::uint32_t side, std::uint32_t part,
                                      const Triangle3& corners_m,
                                      const FacetDivision::Triangle& corners,
                                      const CellSize& size) const {
    const Triangle3 c = at(corners_m, corners);
    const double longest_m = longestEdgeOf(c);
    if (longest_m <= 1.001 * resolution.shortestEdge * longestEdgeOf(corners_m) ||
        plainLength(crossed(c[1] - c[0], c[2] - c[0])) <= 2.0 * size.leastArea_m2)
        return false;
    if (longest_m > (sees[side] ? size.longest_m : resolution.longestEdge_m) &&
        (sees[side] || resolution.longestEdge_m > 0.0))
        return true;
    const Probe& probe = probeAt(firstPart[side] + part);
    return !probe.seen_m.empty() &&
           longest_m * std::sqrt(probe.nearnessAt_per_m2((c[0] + c[1] + c[2]) * (1.0 / 3.0))) >
               size.fineness * resolution.edgePerDistance;
}

std::size_t ExchangeMesh::Making::cellsOf(std::uint32_t side, std::uint32_t part,
                                          const Triangle3& corners_m,
                                          const FacetDivision::Triangle& corners,
                                          const CellSize& size) const {
    if (!isTooLarge(side, part, corners_m, corners, size))
        return 1;
    const auto halves =
        FacetDivision::halvesOf(corners, [&](const FacetPlace& from, const FacetPlace& to) {
            return plainLength(at(corners_m, to) - at(corners_m, from));
        });
    return cellsOf(side, part, corners_m, halves[0], size) +
           cellsOf(side, part, corners_m, halves[1], size);
}

bool ExchangeMesh::Making::isAnyTooLarge(std::uint32_t side, const CellSize& size) const {
    const Triangle3 c = cornersOf(side / 2);
    const auto& parts = divisionOf(side).parts();
    for (std::uint32_t part = 0; part < partsOf(side); ++part)
        if (isTooLarge(side, part, c, parts[part].corners, size))
            return true;
    return false;
}

std::size_t ExchangeMesh::Making::moreCells(std::span<const std::uint32_t> some,
                                            const CellSize& size) const {
    constexpr std::size_t pieces = 256;
    std::vector<std::size_t> counts(pieces);
    parallelFor(pieces, [&](std::size_t piece) {
        for (std::size_t i = beginOfPart(piece, pieces, some.size());
             i < beginOfPart(piece + 1, pieces, some.size()); ++i) {
            const std::uint32_t side = some[i];
            const Triangle3 c = cornersOf(side / 2);
            for (std::uint32_t part = 0; part < firstPart[side + 1] - firstPart[side]; ++part)
                counts[piece] +=
                    cellsOf(side, part, c, divisionOf(side).parts()[part].corners, size) - 1;
        }
    });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// Simple models are resolved more finely. Small cells are few where there would be too many: what
/// is small matters less.
ExchangeMesh::Making::CellSize
ExchangeMesh::Making::chosenSize(double extent_m, std::vector<std::uint32_t>& large) const {
    CellSize size;
    size.leastArea_m2 = 0.25 * area_m2 / static_cast<double>(resolution.mostCells);
    const auto measure = [&] {
        size.longest_m = size.fineness * resolution.longestOfExtent * extent_m;
        if (resolution.longestEdge_m > 0.0)
            size.longest_m = std::min(size.longest_m, resolution.longestEdge_m);
    };
    const auto isEnough = [&](std::size_t most) {
        measure();
        return moreCells(large, size) <= most;
    };
    // What is not too large for the finest size is not for another.
    size.fineness = 0.25;
    measure();
    std::vector<char> isLarge(sides());
    parallelForSmall(sides(), [&](std::uint32_t side) {
        isLarge[side] = isThere(side) && isAnyTooLarge(side, size);
    });
    large.clear();
    for (std::uint32_t side = 0; side < sides(); ++side)
        if (isLarge[side])
            large.push_back(side);
    for (; size.fineness < 0.99; size.fineness *= std::sqrt(2.0))
        if (isEnough(resolution.fewCells))
            return size;
    size.fineness = 1.0;
    while (!isEnough(resolution.mostCells))
        size.leastArea_m2 *= 1.5;
    return size;
}

} // namespace irsg

#include "irsg/render/rays/ExchangeMesh.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>

#include "irsg/core/JoinedNumbers.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/geometry/mesh/MeshSurfaces.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/rays/FacetTree.h"
#include "irsg/render/rays/LightDirections.h"
#include "irsg/render/rays/RayVectors.h"

namespace irsg {

namespace {

/// Of models with more sides, some are probed for all.
constexpr std::size_t mostProbed = 200'000;
/// Of a part of a side; of one that is a large part of the surface, where what stands before it
/// fills little of its hemisphere.
constexpr std::uint32_t fewRays = 16, someRays = 32, manyRays = 256;
constexpr std::size_t manyParts = 20'000;
constexpr double nearest = 0.02; ///< that counts, of the longest edge
/// Facets that are looked at until one is found that a side may see.
constexpr std::size_t mostLooks = 256;
/// Cosine of the normals of sides that continue each other smoothly.
constexpr double alike = 0.5;
/// The same, either way, of facets that are one surface seen from afar.
constexpr double flush = 0.9;
/// What is no higher above a side than this part of its own size casts a sharp shadow on it.
constexpr double lowPart = 0.1;
/// How high anything is looked for above a side, of its longest edge.
constexpr double mostHeight = 0.05;
/// Facets whose corners rise less beyond the plane of another are one smooth surface with it, of
/// the extent of the model.
constexpr double flat = 1e-5;

using Triangle3 = std::array<Vec3, 3>;

double longestEdgeOf(const Triangle3& c) {
    return std::max({plainLength(c[1] - c[0]), plainLength(c[2] - c[1]), plainLength(c[0] - c[2])});
}

} // namespace

/// What is at hand while a mesh is made.
struct ExchangeMesh::Making {
    struct Facet {
        Triangle3 corners_m;
        std::array<std::uint32_t, 3> places{}; ///< equal where corners of facets coincide
        std::uint32_t piece = 0;
        Vec3 normal;
        double area_m2 = 0.0, longest_m = 0.0;
        bool isMet = false, isOpaque = false, isCulled = false;
        std::array<bool, 3> isOutline{true, true, true}; ///< by edge: its surface ends there

        Vec3 at(const FacetPlace& place) const {
            return corners_m[0] * (1.0 - place.u - place.v) + corners_m[1] * place.u +
                   corners_m[2] * place.v;
        }
        Triangle3 at(const FacetDivision::Triangle& t) const {
            return {at(t[0]), at(t[1]), at(t[2])};
        }
        /// How near places are that count as one, as weights, for lengths.
        double toleranceOf(double length_m) const {
            return std::clamp(4.0 * length_m * longest_m / (2.0 * area_m2), 1e-6, 0.02);
        }
    };
    /// What is seen of places of a part of a side.
    struct Probe {
        double least_m = 0.0;                ///< nothing counts as nearer
        std::uint32_t rays = 1, stopped = 0; ///< stopped: by what is opaque
        std::vector<Vec3> seen_m;

        bool isOpen() const { return stopped < rays; }
        float open() const { return 1.0f - static_cast<float>(stopped) / static_cast<float>(rays); }
        double nearnessAt_per_m2(const Vec3& place_m) const {
            double sum_per_m2 = 0.0;
            for (const Vec3& seen : seen_m) {
                const Vec3 apart = seen - place_m;
                sum_per_m2 += 1.0 / std::max(product(apart, apart), least_m * least_m);
            }
            return sum_per_m2 / rays;
        }
    };
    /// A side and an edge of it, by its first corner, from which one goes on to another side.
    struct Passage {
        std::uint32_t side = none;
        std::uint8_t edge = 0;
        bool isSmooth = false;    ///< one surface goes on
        bool isOneOfMany = false; ///< more than two facets meet there
    };

    /// What cells are cut down to.
    struct CellSize {
        double fineness = 1.0, longest_m = 0.0, leastArea_m2 = 0.0;
    };

    const PieceUses& uses;
    const ExchangeResolution& resolution;
    double lift_m = 0.0; ///< of the mesh
    std::vector<Facet> facets{};
    double area_m2 = 0.0;
    /// By side: none where it is not there, or where it is whole, as nearly all of a large model
    /// are.
    std::vector<std::unique_ptr<FacetDivision>> cut{};
    std::vector<bool> sees{};                       ///< likewise
    std::vector<std::uint32_t> firstPart{};         ///< likewise, and behind the last
    std::vector<Probe> probes{};                    ///< first the one of what sees nothing
    std::vector<std::uint32_t> probeOf{};           ///< by part; sides may share one
    std::vector<std::array<Passage, 3>> passages{}; ///< by side
    std::vector<std::uint32_t> firstCell{};         ///< by side
    std::vector<std::uint32_t> spaces{};            ///< by part, see Vertex

    bool isThere(std::uint32_t side) const {
        const Facet& facet = facets[side / 2];
        const PieceUse& use = uses[facet.piece];
        return use.isThere && facet.area_m2 > 0.0 &&
               (side % 2 == 0 || use.transparent || !use.cullsBackFaces);
    }
    const FacetDivision& divisionOf(std::uint32_t side) const {
        static const FacetDivision whole({}, 0.0);
        return cut[side] ? *cut[side] : whole;
    }
    double toleranceOf(std::uint32_t side) const { return facets[side / 2].toleranceOf(lift_m); }
    const Probe& probeAt(std::uint32_t part) const { return probes[probeOf[part]]; }
    Vec3 normalOf(std::uint32_t side) const {
        const Vec3& normal = facets[side / 2].normal;
        return side % 2 == 0 ? normal : normal * -1.0;
    }
    /// Corners are at one place that are, in steps of a length, in all three coordinates.
    void numberPlaces(double step_m);
    std::vector<FacetDivision::Line> wallsOn(std::uint32_t side, const FacetTree& tree) const;
    bool seesAny(std::uint32_t side, const FacetTree& tree, double extent_m) const;
    void probe(std::uint32_t side, std::uint32_t part, const RayMesh& mesh);
    bool isTooLarge(std::uint32_t side, std::uint32_t part, const FacetDivision::Triangle& corners,
                    const CellSize& size) const;
    std::size_t cellsOf(std::uint32_t side, std::uint32_t part,
                        const FacetDivision::Triangle& corners, const CellSize& size) const;
    std::size_t allCells(const CellSize& size) const;
    CellSize chosenSize(double extent_m) const;
    void findPassages();
    bool continues(std::uint32_t facet, std::uint32_t edge, std::uint32_t other,
                   std::uint32_t edgeOfOther) const;
    bool isConvex(double extent_m) const;
    Passage passageFrom(std::uint32_t side, std::uint32_t edge,
                        std::span<const std::pair<std::uint32_t, std::uint32_t>> about) const;
    /// The cell beyond an edge of one of the side's own, on its side or another; none where a wall
    /// stands between, and if asked for where that is another surface.
    std::uint32_t cellBeyond(std::uint32_t side, std::uint32_t cell, std::size_t edge,
                             bool isSmooth) const;
};

ExchangeMesh::ExchangeMesh(std::shared_ptr<const RayMesh> mesh, const PieceUses& uses,
                           const ExchangeResolution& resolution)
    : mesh_(std::move(mesh)) {
    Making making{uses, resolution};
    BoundingBox all = BoundingBox::nowhere();
    for (std::uint32_t piece = 0; piece < mesh_->pieces(); ++piece) {
        firstFacet_.push_back(static_cast<std::uint32_t>(making.facets.size()));
        for (unsigned f = 0; f < mesh_->facetsOf(piece); ++f) {
            Making::Facet& facet = making.facets.emplace_back();
            const Triangle3& c = facet.corners_m = mesh_->facet(piece, f).corners_m;
            facet.piece = piece;
            const Vec3 across = crossed(c[1] - c[0], c[2] - c[0]);
            facet.normal = across == Vec3{} ? Vec3{0, 0, 1} : normalized(across);
            facet.area_m2 = 0.5 * length(across);
            facet.longest_m = longestEdgeOf(c);
            facet.isOpaque = uses[piece].isThere && !uses[piece].transparent;
            facet.isMet = facet.isOpaque || uses[piece].pane > 0;
            facet.isCulled = uses[piece].cullsBackFaces && !uses[piece].transparent;
            making.area_m2 += facet.area_m2;
            for (const Vec3& corner : c)
                all.include(corner);
        }
    }
    extent_m_ = all.valid() ? all.diagonal_m() : 0.0;
    making.lift_m = lift_m();
    making.numberPlaces(samePlaceOfSize * extent_m_);
    making.findPassages();
    if (resolution.isAlone && resolution.hasInsides && making.isConvex(extent_m_)) {
        sides_.resize(2 * making.facets.size());
        firstBeside_.push_back(0);
        return;
    }
    divide(making);
    addCells(making);
    joinVertices(making);
}

ExchangeMesh::Place ExchangeMesh::placeOf(const RayHit& hit) const {
    const std::size_t side =
        2 * static_cast<std::size_t>(firstFacet_[static_cast<std::size_t>(hit.piece)] + hit.facet) +
        (hit.isFront ? 0 : 1);
    if (sides_[side].root == nowhere)
        return {};
    const double u = std::clamp(hit.weights[1], 0.0, 1.0);
    const double v = std::clamp(hit.weights[2], 0.0, 1.0 - u);
    Place place;
    place.cell = FacetDivision::cellOf({u, v}, sides_[side].root, splits_);
    const auto& c = onFacet_[place.cell];
    const double u0 = static_cast<double>(c[0][0]), v0 = static_cast<double>(c[0][1]);
    const double u1 = static_cast<double>(c[1][0]) - u0, v1 = static_cast<double>(c[1][1]) - v0;
    const double u2 = static_cast<double>(c[2][0]) - u0, v2 = static_cast<double>(c[2][1]) - v0;
    const double whole = u1 * v2 - u2 * v1;
    if (whole == 0.0)
        return place;
    const double second = std::clamp(((u - u0) * v2 - (v - v0) * u2) / whole, 0.0, 1.0);
    const double third = std::clamp(((v - v0) * u1 - (u - u0) * v1) / whole, 0.0, 1.0 - second);
    place.u = static_cast<float>(second);
    place.v = static_cast<float>(third);
    return place;
}

double ExchangeMesh::area_m2(std::uint32_t cell) const {
    const Triangle3 c = cornersAt_m(cell);
    return 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
}

/// Walls: where facets cross the plane that rays from a side begin in. Facets in that of the side
/// itself do not, as of a box that stands on it; its walls do. The outline of what lies close above
/// the side is one, too: below it all is dark, beside it nothing.
std::vector<FacetDivision::Line> ExchangeMesh::Making::wallsOn(std::uint32_t side,
                                                               const FacetTree& tree) const {
    const Facet& own = facets[side / 2];
    const Vec3 up = normalOf(side);
    const double offset_m = product(up, own.corners_m[0]) + lift_m;
    const Vec3 b = own.corners_m[1] - own.corners_m[0], c = own.corners_m[2] - own.corners_m[0];
    const Vec3 across = crossed(b, c);
    const double square = product(across, across);
    const double tolerance = own.toleranceOf(lift_m);
    const auto placeOf = [&](const Vec3& at_m) {
        const Vec3 from = at_m - own.corners_m[0];
        return FacetPlace{product(crossed(from, c), across) / square,
                          product(crossed(b, from), across) / square};
    };
    BoundingBox box = BoundingBox::nowhere();
    const Vec3 margin{2.0 * lift_m, 2.0 * lift_m, 2.0 * lift_m};
    for (const Vec3& corner : own.corners_m) {
        box.include(corner - margin);
        box.include(corner + margin);
        box.include(corner + up * (mostHeight * own.longest_m));
    }
    std::vector<FacetDivision::Line> walls;
    std::vector<std::uint32_t> found;
    tree.forEachTouching(box, [&](std::uint32_t number) { found.push_back(number); });
    std::ranges::sort(found);
    for (const std::uint32_t number : found) {
        const Facet& other = facets[number];
        std::size_t common = 0;
        for (const std::uint32_t place : other.places)
            common += static_cast<std::size_t>(std::ranges::count(own.places, place));
        if (number == side / 2 || common >= 2)
            continue;
        std::array<double, 3> above_m{};
        for (std::size_t i = 0; i < 3; ++i)
            above_m[i] = product(up, other.corners_m[i]) - offset_m;
        const auto addWall = [&](const Vec3& from_m, const Vec3& to_m) {
            FacetDivision::Line wall{placeOf(from_m), placeOf(to_m)};
            const FacetPlace along = wall.to - wall.from;
            if (std::hypot(along.u, along.v) > tolerance &&
                FacetDivision::clip(wall, FacetDivision::whole, 2.0 * tolerance))
                walls.push_back(wall);
        };
        if (std::ranges::min(above_m) > 0.0 &&
            std::ranges::max(above_m) < lowPart * std::sqrt(other.area_m2))
            for (std::size_t i = 0; i < 3; ++i)
                if (other.isOutline[i])
                    addWall(other.corners_m[i], other.corners_m[(i + 1) % 3]);
        std::array<Vec3, 2> ends{};
        std::size_t count = 0;
        for (std::size_t i = 0; i < 3 && count < 2; ++i) {
            const std::size_t k = (i + 1) % 3;
            if ((above_m[i] > 0.0) != (above_m[k] > 0.0))
                ends[count++] = other.corners_m[i] + (other.corners_m[k] - other.corners_m[i]) *
                                                         (above_m[i] / (above_m[i] - above_m[k]));
        }
        if (count == 2)
            addWall(ends[0], ends[1]);
    }
    return walls;
}

/// Whether there is anything beyond the plane of a side that does not turn its culled back
/// to all of it. On a convex body there is nothing.
bool ExchangeMesh::Making::seesAny(std::uint32_t side, const FacetTree& tree,
                                   double extent_m) const {
    const Facet& own = facets[side / 2];
    const Vec3 up = normalOf(side);
    const double offset_m = product(up, own.corners_m[0]) + flat * extent_m;
    std::size_t looks = 0;
    return tree.isAnyBeyond(up, offset_m, [&](std::uint32_t number) {
        // Of a fine mesh many boxes reach beyond the plane, and no facet: rays tell sooner.
        if (++looks > mostLooks)
            return true;
        const Facet& other = facets[number];
        if (std::ranges::none_of(other.corners_m, [&](const Vec3& corner) {
                return product(up, corner) > offset_m;
            }))
            return false;
        if (!other.isCulled)
            return true;
        const double before_m = product(other.normal, other.corners_m[0]) + flat * extent_m;
        return std::ranges::any_of(own.corners_m, [&](const Vec3& corner) {
            return product(other.normal, corner) > before_m;
        });
    });
}

/// Whether all that is there is one closed opaque surface that is convex at every edge: then it is
/// convex (van Heijenoort, Comm. Pure Appl. Math. 5, 223, 1952).
bool ExchangeMesh::Making::isConvex(double extent_m) const {
    JoinedNumbers joined(facets.size());
    std::uint32_t first = none;
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
        const Facet& own = facets[f];
        if (!uses[own.piece].isThere || !(own.area_m2 > 0.0))
            continue;
        first = std::min(first, f);
        for (std::size_t edge = 0; edge < 3; ++edge) {
            // Beyond each edge of the front lies the front of one neighbour, which falls away.
            const Passage& passage = passages[2 * f][edge];
            if (!own.isOpaque || passage.side == none || passage.side % 2 != 0 ||
                passage.isOneOfMany)
                return false;
            const Facet& other = facets[passage.side / 2];
            const Vec3& third = other.corners_m[(passage.edge + 2) % 3];
            if (product(own.normal, third - own.corners_m[0]) > flat * extent_m)
                return false;
            joined.join(f, passage.side / 2);
        }
    }
    for (std::uint32_t f = 0; f < facets.size(); ++f)
        if (uses[facets[f].piece].isThere && facets[f].area_m2 > 0.0 && joined.of(f) != first)
            return false;
    return true;
}

void ExchangeMesh::Making::numberPlaces(double step_m) {
    PlaceNumbers numbers(step_m);
    for (Facet& facet : facets)
        for (std::size_t i = 0; i < 3; ++i)
            facet.places[i] = numbers.of(facet.corners_m[i]);
}

void ExchangeMesh::divide(Making& making) {
    std::vector<BoundingBox> boxes(making.facets.size(), BoundingBox::nowhere());
    for (std::size_t f = 0; f < boxes.size(); ++f)
        if (making.facets[f].isMet && making.facets[f].area_m2 > 0.0)
            for (const Vec3& corner : making.facets[f].corners_m)
                boxes[f].include(corner);
    const std::size_t sides = 2 * making.facets.size();
    making.cut.resize(sides);
    std::vector<char> sees(sides);
    {
        const FacetTree tree(std::move(boxes));
        parallelForSmall(sides, [&](std::uint32_t side) {
            if (!making.isThere(side))
                return;
            sees[side] = making.seesAny(side, tree, extent_m_);
            if (!sees[side])
                return;
            if (const auto walls = making.wallsOn(side, tree); !walls.empty())
                making.cut[side] = std::make_unique<FacetDivision>(walls, making.toleranceOf(side));
        });
    }
    making.sees.assign(sees.begin(), sees.end());
    const auto partsOf = [&](std::uint32_t side) {
        return making.isThere(side)
                   ? static_cast<std::uint32_t>(making.divisionOf(side).parts().size())
                   : 0u;
    };
    making.firstPart.reserve(sides + 1);
    making.firstPart.push_back(0);
    for (std::uint32_t side = 0; side < sides; ++side)
        making.firstPart.push_back(making.firstPart.back() + partsOf(side));
    const std::size_t parts = making.firstPart.back();
    const auto stride = static_cast<std::uint32_t>(2 * (parts / mostProbed) + 1);
    const auto isProbed = [&](std::uint32_t side) {
        return stride == 1 || side % (2 * stride) < 2 || partsOf(side) > 1;
    };
    making.probeOf.assign(parts, 0);
    std::uint32_t probes = 1;
    for (std::uint32_t side = 0; side < sides; ++side)
        for (std::uint32_t part = making.firstPart[side];
             making.sees[side] && part < making.firstPart[side + 1] && isProbed(side); ++part)
            making.probeOf[part] = probes++;
    making.probes.resize(probes);
    parallelForSmall(sides, [&](std::uint32_t side) {
        if (making.sees[side] && isProbed(side))
            for (std::uint32_t part = 0; part < partsOf(side); ++part)
                making.probe(side, part, *mesh_);
    });
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t known = side - side % (2 * stride) + side % 2;
        if (making.sees[side] && !isProbed(side) && partsOf(known) > 0 &&
            making.facets[known / 2].piece == making.facets[side / 2].piece)
            making.probeOf[making.firstPart[side]] = making.probeOf[making.firstPart[known]];
    }
    findSpaces(making);
    const Making::CellSize size = making.chosenSize(extent_m_);
    fineness_ = size.fineness;
    parallelForSmall(sides, [&](std::uint32_t side) {
        if (!making.isThere(side))
            return;
        if (!making.cut[side]) {
            if (!making.isTooLarge(side, 0, FacetDivision::whole, size))
                return;
            making.cut[side] = std::make_unique<FacetDivision>(std::vector<FacetDivision::Line>(),
                                                               making.toleranceOf(side));
        }
        making.cut[side]->refine(
            [&](std::uint32_t part, const FacetDivision::Triangle& corners) {
                return making.isTooLarge(side, part, corners, size);
            },
            [&](const FacetPlace& from, const FacetPlace& to) {
                const Making::Facet& facet = making.facets[side / 2];
                return plainLength(facet.at(to) - facet.at(from));
            });
    });
}

/// Parts that meet at edges turn to one space. It is inside where no ray left from any of them.
void ExchangeMesh::findSpaces(Making& making) const {
    making.spaces.resize(making.probeOf.size());
    if (!making.resolution.hasInsides)
        return;
    making.firstCell = making.firstPart; // no part is divided yet
    JoinedNumbers parts(making.probeOf.size());
    for (std::uint32_t side = 0; side < making.cut.size(); ++side)
        for (std::uint32_t part = making.firstPart[side]; part < making.firstPart[side + 1]; ++part)
            for (std::size_t edge = 0; edge < 3; ++edge)
                if (const std::uint32_t beyond =
                        making.cellBeyond(side, part - making.firstPart[side], edge, false);
                    beyond != none)
                    parts.join(part, beyond);
    std::vector<bool> isOpen(making.probeOf.size());
    for (std::uint32_t part = 0; part < making.probeOf.size(); ++part)
        if (making.probeAt(part).isOpen())
            isOpen[parts.of(part)] = true;
    for (std::uint32_t part = 0; part < making.probeOf.size(); ++part)
        making.spaces[part] = isOpen[parts.of(part)] ? 0 : parts.of(part) + 1;
}

void ExchangeMesh::Making::probe(std::uint32_t side, std::uint32_t part, const RayMesh& mesh) {
    const Facet& facet = facets[side / 2];
    const Triangle3 c = facet.at(divisionOf(side).parts()[part].corners);
    Probe& own = probes[probeOf[firstPart[side] + part]];
    own.least_m = nearest * longestEdgeOf(c);
    const double ownArea_m2 = 0.5 * plainLength(crossed(c[1] - c[0], c[2] - c[0]));
    own.rays = ownArea_m2 > 0.01 * area_m2    ? manyRays
               : firstPart.back() < manyParts ? someRays
                                              : fewRays;
    const LightPoints points((firstPart[side] + part + 1) * 0x9e3779b9u);
    const Vec3 up = normalOf(side);
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
                                      const FacetDivision::Triangle& corners,
                                      const CellSize& size) const {
    const Facet& facet = facets[side / 2];
    const Triangle3 c = facet.at(corners);
    const double longest_m = longestEdgeOf(c);
    if (longest_m <= 1.001 * resolution.shortestEdge * facet.longest_m ||
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
                                          const FacetDivision::Triangle& corners,
                                          const CellSize& size) const {
    if (!isTooLarge(side, part, corners, size))
        return 1;
    const auto halves =
        FacetDivision::halvesOf(corners, [&](const FacetPlace& from, const FacetPlace& to) {
            const Facet& facet = facets[side / 2];
            return plainLength(facet.at(to) - facet.at(from));
        });
    return cellsOf(side, part, halves[0], size) + cellsOf(side, part, halves[1], size);
}

std::size_t ExchangeMesh::Making::allCells(const CellSize& size) const {
    constexpr std::size_t pieces = 256;
    std::vector<std::size_t> counts(pieces);
    parallelFor(pieces, [&](std::size_t piece) {
        for (std::size_t i = beginOfPart(piece, pieces, cut.size());
             i < beginOfPart(piece + 1, pieces, cut.size()); ++i) {
            const auto side = static_cast<std::uint32_t>(i);
            for (std::uint32_t part = 0; part < firstPart[side + 1] - firstPart[side]; ++part)
                counts[piece] += cellsOf(side, part, divisionOf(side).parts()[part].corners, size);
        }
    });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// Simple models are resolved more finely. Small cells are few where there would be too many: what
/// is small matters less.
ExchangeMesh::Making::CellSize ExchangeMesh::Making::chosenSize(double extent_m) const {
    CellSize size;
    size.leastArea_m2 = 0.25 * area_m2 / static_cast<double>(resolution.mostCells);
    const auto isEnough = [&](std::size_t most) {
        size.longest_m = size.fineness * resolution.longestOfExtent * extent_m;
        if (resolution.longestEdge_m > 0.0)
            size.longest_m = std::min(size.longest_m, resolution.longestEdge_m);
        return allCells(size) <= most + firstPart.back();
    };
    for (size.fineness = 0.25; size.fineness < 0.99; size.fineness *= std::sqrt(2.0))
        if (isEnough(resolution.fewCells))
            return size;
    size.fineness = 1.0;
    while (!isEnough(resolution.mostCells))
        size.leastArea_m2 *= 1.5;
    return size;
}

void ExchangeMesh::addCells(Making& making) {
    sides_.resize(making.cut.size());
    making.firstCell.clear();
    for (std::uint32_t side = 0; side < sides_.size(); ++side) {
        sides_[side].normal = making.normalOf(side);
        const auto first = static_cast<std::uint32_t>(sideOf_.size());
        making.firstCell.push_back(first);
        if (!making.isThere(side))
            continue;
        const FacetDivision& division = making.divisionOf(side);
        const auto firstSplit = static_cast<std::int32_t>(splits_.size());
        const auto moved = [&](std::int32_t at) {
            return at >= 0 ? at + firstSplit : at - static_cast<std::int32_t>(first);
        };
        sides_[side].root = moved(division.root());
        for (Split one : division.splits()) {
            one.branches = {moved(one.branches[0]), moved(one.branches[1])};
            splits_.push_back(one);
        }
        for (const FacetDivision::Cell& cell : division.cells()) {
            sideOf_.push_back(side);
            sees_.push_back(making.sees[side]);
            auto& places = onFacet_.emplace_back();
            for (std::size_t i = 0; i < 3; ++i)
                places[i] = {static_cast<float>(cell.corners[i].u),
                             static_cast<float>(cell.corners[i].v)};
        }
    }
}

void ExchangeMesh::Making::findPassages() {
    struct Edge {
        std::uint32_t from, to; // places
        std::uint32_t facet, edge;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * facets.size());
    for (std::uint32_t f = 0; f < facets.size(); ++f)
        for (std::uint32_t i = 0; i < 3 && facets[f].area_m2 > 0.0; ++i) {
            const std::uint32_t a = facets[f].places[i], b = facets[f].places[(i + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), f, i});
        }
    std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
        return std::tuple(a.from, a.to, a.facet, a.edge) <
               std::tuple(b.from, b.to, b.facet, b.edge);
    });
    passages.resize(2 * facets.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> about;
    for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
        about.clear();
        for (; end < edges.size() && edges[end].from == edges[first].from &&
               edges[end].to == edges[first].to;
             ++end)
            about.emplace_back(edges[end].facet, edges[end].edge);
        if (about.size() < 2)
            continue;
        for (const auto& [facet, edge] : about)
            facets[facet].isOutline[edge] = std::ranges::none_of(about, [&](const auto& other) {
                return continues(facet, edge, other.first, other.second);
            });
        for (const auto& [facet, edge] : about)
            for (std::uint32_t side = 2 * facet; side < 2 * facet + 2; ++side)
                if (isThere(side))
                    passages[side][edge] = passageFrom(side, edge, about);
    }
}

/// Whether another facet lies beyond an edge, almost in the plane of this one: not its own copy
/// that turns the other way.
bool ExchangeMesh::Making::continues(std::uint32_t facet, std::uint32_t edge, std::uint32_t other,
                                     std::uint32_t edgeOfOther) const {
    const Facet &own = facets[facet], &there = facets[other];
    const Vec3& from = own.corners_m[edge];
    const Vec3 along = own.corners_m[(edge + 1) % 3] - from;
    const auto isLeft = [&](const Facet& one, std::uint32_t edgeOfOne) {
        const Vec3 third = one.corners_m[(edgeOfOne + 2) % 3] - from;
        return product(crossed(along, third), own.normal) > 0.0;
    };
    return other != facet && std::abs(product(there.normal, own.normal)) > flush &&
           isLeft(there, edgeOfOther) != isLeft(own, edge);
}

/// About an edge, from a side, the next facet is where one gets: the one that turns its own side
/// towards the wedge between them.
ExchangeMesh::Making::Passage ExchangeMesh::Making::passageFrom(
    std::uint32_t side, std::uint32_t edge,
    std::span<const std::pair<std::uint32_t, std::uint32_t>> about) const {
    const Facet& own = facets[side / 2];
    const Vec3& from = own.corners_m[edge];
    const Vec3 along = own.corners_m[(edge + 1) % 3] - from;
    const Vec3 up = normalOf(side);
    const double square = product(along, along);
    const auto inward = [&](const Facet& facet, std::size_t ofEdge) {
        const Vec3 to = facet.corners_m[(ofEdge + 2) % 3] - from;
        return to - along * (product(to, along) / square);
    };
    const Vec3 in = inward(own, edge);
    const Vec3 right = in * (1.0 / plainLength(in));
    double least = 4.0 * pi;
    Passage next;
    for (const auto& [facet, ofEdge] : about) {
        const Facet& other = facets[facet];
        if (facet == side / 2 || !(other.isMet || other.piece == own.piece))
            continue;
        const Vec3 there = inward(other, ofEdge);
        double angle = std::atan2(product(there, up), product(there, right));
        angle += angle <= 0.0 ? 2.0 * pi : 0.0;
        if (angle >= least)
            continue;
        least = angle;
        const Vec3 ahead = up * std::cos(angle) - right * std::sin(angle);
        next = {2 * facet + (product(other.normal, ahead) < 0.0 ? 0u : 1u),
                static_cast<std::uint8_t>(ofEdge)};
        next.isSmooth = other.piece == own.piece && product(normalOf(next.side), up) > alike;
        next.isOneOfMany = about.size() > 2;
    }
    return next.side != none && isThere(next.side) ? next : Passage{};
}

std::uint32_t ExchangeMesh::Making::cellBeyond(std::uint32_t side, std::uint32_t cell,
                                               std::size_t edge, bool isSmooth) const {
    const FacetDivision& division = divisionOf(side);
    const FacetDivision::Triangle& corners = division.cells()[cell].corners;
    const FacetPlace from = corners[edge], way = corners[(edge + 1) % 3] - from;
    const FacetPlace middle = from + way * 0.5;
    const double step = 2.0 * toleranceOf(side) / std::hypot(way.u, way.v);
    const FacetPlace out{way.v * step, -way.u * step};
    const FacetPlace before = middle - out, behind = middle + out;
    if (division.isBetween(cell, before, behind))
        return none;
    const std::array<double, 3> weights{1.0 - behind.u - behind.v, behind.u, behind.v};
    const auto outside =
        static_cast<std::size_t>(std::ranges::min_element(weights) - weights.begin());
    if (weights[outside] > 0.0) {
        const std::uint32_t other = division.cellOf(behind);
        return other == cell || division.isBetween(other, before, behind) ? none
                                                                          : firstCell[side] + other;
    }
    // Across the edge of the facet that lies opposite that corner.
    const std::size_t begin = (outside + 1) % 3, end = (outside + 2) % 3;
    const Passage& passage = passages[side][begin];
    if (passage.side == none || (isSmooth && !passage.isSmooth))
        return none;
    const std::array<double, 3> at{1.0 - middle.u - middle.v, middle.u, middle.v};
    const double part = std::clamp(at[end] / std::max(at[begin] + at[end], 1e-30), 0.0, 1.0);
    const FacetDivision& there = divisionOf(passage.side);
    const Facet& other = facets[passage.side / 2];
    const bool isReversed = other.places[passage.edge] == facets[side / 2].places[end];
    const double along = isReversed ? 1.0 - part : part;
    const auto placeAt = [&](double inward) {
        std::array<double, 3> w{};
        w[passage.edge] = (1.0 - along) * (1.0 - inward);
        w[(passage.edge + 1) % 3] = along * (1.0 - inward);
        w[(passage.edge + 2) % 3] = inward;
        return FacetPlace{w[1], w[2]};
    };
    const double width = 2.0 * toleranceOf(passage.side);
    const std::uint32_t found = there.cellOf(placeAt(width));
    return there.isBetween(found, placeAt(-width), placeAt(width))
               ? none
               : firstCell[passage.side] + found;
}

void ExchangeMesh::joinVertices(Making& making) {
    const auto at_m = [&](std::uint32_t cell) {
        const std::uint32_t side = sideOf_[cell];
        const auto& cells = making.divisionOf(side).cells();
        return making.facets[side / 2].at(cells[cell - making.firstCell[side]].corners);
    };
    corners_.resize(sideOf_.size());
    std::vector<std::array<std::uint32_t, 3>> beyond(sideOf_.size());
    parallelForSmall(sideOf_.size(), [&](std::uint32_t cell) {
        const std::uint32_t side = sideOf_[cell], local = cell - making.firstCell[side];
        for (std::size_t edge = 0; edge < 3; ++edge)
            beyond[cell][edge] = making.cellBeyond(side, local, edge, true);
    });
    // Corners of cells that continue each other and lie at one place are one vertex.
    JoinedNumbers same(3 * sideOf_.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> uneven; // cells that share one vertex
    for (std::uint32_t cell = 0; cell < sideOf_.size(); ++cell)
        for (const std::uint32_t other : beyond[cell]) {
            if (other == none)
                continue;
            const Triangle3 own_m = at_m(cell), other_m = at_m(other);
            const double near_m = 1e-4 * std::min(longestEdgeOf(own_m), longestEdgeOf(other_m));
            std::size_t common = 0;
            for (std::uint32_t i = 0; i < 3; ++i)
                for (std::uint32_t k = 0; k < 3; ++k)
                    if (plainLength(own_m[i] - other_m[k]) < near_m) {
                        same.join(3 * cell + i, 3 * other + k);
                        ++common;
                    }
            if (common < 2)
                uneven.emplace_back(cell, other);
        }
    std::vector<std::uint32_t> numbers(3 * sideOf_.size(), none);
    for (std::uint32_t cell = 0; cell < sideOf_.size(); ++cell) {
        const std::uint32_t side = sideOf_[cell], local = cell - making.firstCell[side];
        const std::uint32_t part = making.divisionOf(side).cells()[local].part;
        const Making::Probe& probe = making.probeAt(making.firstPart[side] + part);
        const Triangle3 c = at_m(cell);
        const double area_m2 = 0.5 * plainLength(crossed(c[1] - c[0], c[2] - c[0]));
        for (std::uint32_t i = 0; i < 3; ++i) {
            std::uint32_t& number = numbers[same.of(3 * cell + i)];
            if (number == none) {
                number = static_cast<std::uint32_t>(vertices_.size());
                vertices_.push_back({making.facets[side / 2].piece,
                                     c[i],
                                     {},
                                     0.0,
                                     0.0f,
                                     making.spaces[making.firstPart[side] + part]});
            }
            Vertex& vertex = vertices_[corners_[cell][i] = number];
            vertex.normal = vertex.normal + sides_[side].normal * area_m2;
            vertex.nearness_per_m2 =
                std::max(vertex.nearness_per_m2, probe.nearnessAt_per_m2(c[i]));
            vertex.open = std::max(vertex.open, probe.open());
        }
    }
    for (Vertex& vertex : vertices_)
        vertex.normal =
            vertex.normal == Vec3{} ? Vec3{0, 0, 1} : vertex.normal * (1.0 / length(vertex.normal));

    std::vector<std::pair<std::uint32_t, std::uint32_t>> ways;
    ways.reserve(6 * corners_.size() + 18 * uneven.size());
    const auto connect = [&](std::uint32_t a, std::uint32_t b) {
        if (a != b) {
            ways.emplace_back(a, b);
            ways.emplace_back(b, a);
        }
    };
    for (const auto& c : corners_)
        for (std::size_t i = 0; i < 3; ++i)
            connect(c[i], c[(i + 1) % 3]);
    for (const auto& [cell, other] : uneven)
        for (const std::uint32_t a : corners_[cell])
            for (const std::uint32_t b : corners_[other])
                connect(a, b);
    std::ranges::sort(ways);
    ways.erase(std::unique(ways.begin(), ways.end()), ways.end());
    firstBeside_.assign(vertices_.size() + 1, 0);
    for (const auto& [from, to] : ways) {
        ++firstBeside_[from + 1];
        beside_.push_back(to);
    }
    std::partial_sum(firstBeside_.begin(), firstBeside_.end(), firstBeside_.begin());
}

} // namespace irsg

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "irsg/render/rays/ExchangeMesh.h"
#include "irsg/render/rays/FacetTree.h"
#include "irsg/render/rays/RayVectors.h"

namespace irsg {

/// Facets whose corners rise less beyond the plane of another are one smooth surface with it, of
/// the extent of the model.
inline constexpr double flatOfExtent = 1e-5;

using Triangle3 = std::array<Vec3, 3>;

inline double longestEdgeOf(const Triangle3& c) {
    return std::max({plainLength(c[1] - c[0]), plainLength(c[2] - c[1]), plainLength(c[0] - c[2])});
}

/// What is at hand while a mesh is made. Models may have millions of facets: what follows from
/// their corners is computed where it is needed, and what most of them lack takes no room.
struct ExchangeMesh::Making {
    struct Facet {
        Triangle3 corners_m;
        std::uint32_t piece = 0;
        Vec3 normal;
        double area_m2 = 0.0, longest_m = 0.0;

        Vec3 at(const FacetPlace& place) const { return Making::at(corners_m, place); }
        Triangle3 at(const FacetDivision::Triangle& t) const {
            return {at(t[0]), at(t[1]), at(t[2])};
        }
    };
    /// How the facets of a piece count.
    struct Role {
        bool isMet = false, isOpaque = false, isCulled = false;
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
        static constexpr std::uint32_t nowhere = (1u << 28) - 1;
        std::uint32_t side : 28 = nowhere;
        std::uint32_t edge : 2 = 0;
        bool isSmooth : 1 = false;    ///< one surface goes on
        bool isOneOfMany : 1 = false; ///< more than two facets meet there
    };
    static_assert(sizeof(Passage) == 4);
    /// A facet at an edge, by the edge's first corner.
    struct FacetAtEdge {
        std::uint32_t facet = 0, edge = 0;
        Facet values;
    };

    /// A facet about another that rises beyond one of the planes its sides' rays begin in.
    struct Neighbour {
        std::uint32_t facet = 0;
        std::array<bool, 2> isNear{}; ///< front and back of the other
        Triangle3 corners_m;
        std::array<double, 3> along_m{}; ///< of the corners, along the normal of the other's front
    };

    /// What cells are cut down to.
    struct CellSize {
        double fineness = 1.0, longest_m = 0.0, leastArea_m2 = 0.0;
    };

    const RayMesh& mesh;
    const std::vector<std::uint32_t>& firstFacet; ///< by piece
    const PieceUses& uses;
    const ExchangeResolution& resolution;
    double lift_m = 0.0; ///< of the mesh
    double area_m2 = 0.0;
    std::vector<Role> roles{};                          ///< by piece
    std::vector<RayMesh::Corners> corners{};            ///< likewise
    std::vector<std::uint32_t> pieceOf{};               ///< by facet
    std::vector<std::array<std::uint32_t, 3>> places{}; ///< equal where corners coincide
    std::vector<std::uint8_t> outlines{};               ///< a bit an edge: a surface ends there
    std::vector<bool> hasArea{};                        ///< by facet
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

    static Vec3 at(const Triangle3& c, const FacetPlace& place) {
        return c[0] * (1.0 - place.u - place.v) + c[1] * place.u + c[2] * place.v;
    }
    static Triangle3 at(const Triangle3& c, const FacetDivision::Triangle& t) {
        return {at(c, t[0]), at(c, t[1]), at(c, t[2])};
    }
    /// Takes facets in, and returns the box around them.
    BoundingBox takeFacets();
    std::size_t facets() const { return pieceOf.size(); }
    std::size_t sides() const { return 2 * facets(); }
    const Role& roleOf(std::uint32_t facet) const { return roles[pieceOf[facet]]; }
    Triangle3 cornersOf(std::uint32_t facet) const {
        const std::uint32_t piece = pieceOf[facet];
        return corners[piece].of(facet - firstFacet[piece]);
    }
    Facet facetOf(std::uint32_t facet) const;
    bool isOutline(std::uint32_t facet, std::size_t edge) const {
        return (outlines[facet] >> edge) % 2 != 0;
    }
    bool isThere(std::uint32_t side) const {
        const PieceUse& use = uses[pieceOf[side / 2]];
        return use.isThere && hasArea[side / 2] &&
               (side % 2 == 0 || use.transparent || !use.cullsBackFaces);
    }
    const FacetDivision& divisionOf(std::uint32_t side) const {
        static const FacetDivision whole({}, 0.0);
        return cut[side] ? *cut[side] : whole;
    }
    std::uint32_t partsOf(std::uint32_t side) const {
        return isThere(side) ? static_cast<std::uint32_t>(divisionOf(side).parts().size()) : 0u;
    }
    /// How near places on a facet are that count as one, as weights.
    double toleranceOf(const Facet& facet) const {
        return std::clamp(4.0 * lift_m * facet.longest_m / (2.0 * facet.area_m2), 1e-6, 0.02);
    }
    double toleranceOf(std::uint32_t side) const { return toleranceOf(facetOf(side / 2)); }
    const Probe& probeAt(std::uint32_t part) const { return probes[probeOf[part]]; }
    static Vec3 normalOf(const Facet& facet, std::uint32_t side) {
        return side % 2 == 0 ? facet.normal : facet.normal * -1.0;
    }
    /// Corners are at one place that are, in steps of a length, in all three coordinates.
    void numberPlaces(double step_m);
    void findPassages();
    static bool continues(const FacetAtEdge& own, const FacetAtEdge& other);
    bool isConvex(double extent_m) const;
    Passage passageFrom(std::uint32_t side, const FacetAtEdge& own,
                        std::span<const FacetAtEdge> about) const;
    /// The cell beyond an edge of one of the side's own, on its side or another; none where a wall
    /// stands between, and if asked for where that is another surface.
    std::uint32_t cellBeyond(std::uint32_t side, std::uint32_t cell, std::size_t edge,
                             bool isSmooth) const;

    /// What rays begin above, and where they may be stopped at once.
    BoundingBox boxAbove(const Facet& own, std::uint32_t side) const;
    /// In ascending order.
    void findNeighbours(const Facet& own, std::uint32_t facet, const FacetTree& tree,
                        std::vector<Neighbour>& found) const;
    std::vector<FacetDivision::Line> wallsOn(std::uint32_t side, const Facet& own,
                                             std::span<const Neighbour> neighbours) const;
    bool seesAny(std::uint32_t side, const Facet& own, const FacetTree& tree, double extent_m,
                 std::uint32_t& known) const;
    /// Finds what sides see, and cuts them along walls.
    void findWalls(double extent_m);
    /// Sends the first rays, from all sides or some.
    void sendProbes();
    void probe(std::uint32_t side, std::uint32_t part);
    /// `corners_m`: of the facet.
    bool isTooLarge(std::uint32_t side, std::uint32_t part, const Triangle3& corners_m,
                    const FacetDivision::Triangle& corners, const CellSize& size) const;
    std::size_t cellsOf(std::uint32_t side, std::uint32_t part, const Triangle3& corners_m,
                        const FacetDivision::Triangle& corners, const CellSize& size) const;
    bool isAnyTooLarge(std::uint32_t side, const CellSize& size) const;
    /// Of some sides: cells beyond one for each part.
    std::size_t moreCells(std::span<const std::uint32_t> some, const CellSize& size) const;
    /// `large`: becomes those sides of which a part is too large for the finest size that was
    /// tried.
    CellSize chosenSize(double extent_m, std::vector<std::uint32_t>& large) const;
    void refine(std::span<const std::uint32_t> large, const CellSize& size);
    void findSpaces();
};

} // namespace irsg

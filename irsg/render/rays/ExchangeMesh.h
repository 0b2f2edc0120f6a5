#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "irsg/core/BinaryArchive.h"
#include "irsg/geometry/view/Vec3.h"
#include "irsg/render/rays/FacetDivision.h"
#include "irsg/render/rays/RayMesh.h"

namespace irsg {

/// How finely the surfaces of a model are resolved where they exchange radiation.
struct ExchangeResolution {
    /// Lengths on a surface times the root mean square of 1 / distance of what it sees.
    double edgePerDistance = 0.25;
    /// Longest edge of any, m; 0 for no matter. For what others light, which the body knows not.
    double longestEdge_m = 0.0;
    /// The shortest edge that a facet is divided down to, as a part of its longest.
    double shortestEdge = 1.0 / 64.0;
    /// Longest edge of what sees anything, of the extent of the model.
    double longestOfExtent = 0.05;
    /// What is small is divided less and has fewer nodes where there would be more. Of more than a
    /// few, those near each other send as one.
    std::size_t mostCells = 150'000, mostNodes = 16'000, mostSenders = 4'000;
    /// Lengths are down to a quarter of these where so many are enough; so few senders send alone.
    std::size_t fewCells = 16'000, fewNodes = 4'000, fewSenders = 1'000;
    /// The same of models whose nodes would be coarser, see ExchangeNodes::coarseness.
    double mostCoarseness = 3.0;
    std::size_t mostNodesOfDetail = 48'000, mostSendersOfDetail = 12'000;
    /// Whether spaces inside are told apart, which nobody looks at from within.
    bool hasInsides = false;
    /// Whether there is nothing else near: then a convex body has no cells, which nobody lights.
    bool isAlone = false;

    /// Of lengths where view factors are wanted with an error: what is between nodes is off by the
    /// square of their distance.
    static double spacingFor(double error) {
        constexpr double usualError = 0.005;
        return std::clamp(std::sqrt(error / usualError), 0.25, 2.0);
    }
};

/// The surface of a model as inter-reflection is computed on it: the sides of its facets, divided
/// into cells. A side is cut along the lines where other facets stand on it or go through it, so
/// that no cell lies on both sides of a wall, inside and outside of a body; cells that see
/// something near are cut further. In the axes of the mesh.
class ExchangeMesh {
  public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    /// A place in a cell.
    struct Place {
        std::uint32_t cell = none;
        float u = 0.0f, v = 0.0f; ///< weights of its second and third corner
    };
    /// A corner of cells. Those of a smooth surface share it, unless a wall stands between them.
    struct Vertex {
        Vec3 at_m;
        std::uint32_t piece = 0;
        /// 0, or the number of the space inside that the side turns to: one from which no ray was
        /// found to leave the model.
        std::uint32_t space = 0;
    };
    /// What is seen from a vertex.
    struct Sight {
        Vec3 normal; ///< to the side; the mean of those of the cells, as areas count
        /// Mean square of 1 / distance of what is seen from there.
        double nearness_per_m2 = 0.0;
        /// Part of the rays about it that leave the model, through transparent surfaces or not.
        float open = 1.0f;
    };

    ExchangeMesh(std::shared_ptr<const RayMesh> mesh, const PieceUses& uses,
                 const ExchangeResolution& resolution);

    /// As it was written, of the same mesh; nothing where the bytes are not those of one.
    static std::shared_ptr<const ExchangeMesh> read(std::shared_ptr<const RayMesh> mesh,
                                                    BinaryReader& reader);
    /// What is left after forgetWays.
    void write(BinaryWriter& writer) const;

    const RayMesh& rays() const { return *mesh_; }
    std::size_t cells() const { return sideOf_.size(); }
    const std::vector<Vertex>& vertices() const { return vertices_; }
    /// By vertex; none after forgetWays.
    const std::vector<Sight>& sights() const { return sights_; }
    /// Leaves out what is seen from vertices and where one gets from them, which nodes are placed
    /// by, and which takes 70 bytes a vertex.
    void forgetWays();

    /// No cell where the side is not there: a back that is culled.
    Place placeOf(const RayHit& hit) const;
    /// Numbers of vertices.
    const std::array<std::uint32_t, 3>& corners(std::uint32_t cell) const { return corners_[cell]; }
    std::array<Vec3, 3> cornersAt_m(std::uint32_t cell) const {
        const auto& c = corners_[cell];
        return {vertices_[c[0]].at_m, vertices_[c[1]].at_m, vertices_[c[2]].at_m};
    }
    std::size_t pieceOf(std::uint32_t cell) const { return vertices_[corners_[cell][0]].piece; }
    double area_m2(std::uint32_t cell) const;
    /// Unit, to its side.
    Vec3 normal(std::uint32_t cell) const;
    /// Whether anything stands before the side of the facet.
    bool seesAnything(std::uint32_t cell) const { return sees_[cell]; }
    /// Whether it turns to a space inside, which the outside sees through small holes at most.
    bool isInside(std::uint32_t cell) const { return vertices_[corners_[cell][0]].space != 0; }
    /// Vertices that one can go to along the surface, on its side, without passing others; not
    /// after forgetWays.
    std::span<const std::uint32_t> beside(std::uint32_t vertex) const {
        return std::span(beside_).subspan(firstBeside_[vertex],
                                          firstBeside_[vertex + 1] - firstBeside_[vertex]);
    }
    /// Of the lengths of the resolution: what they are times this is not exceeded.
    double fineness() const { return fineness_; }
    /// Of the box around all of it, m.
    double extent_m() const { return extent_m_; }
    /// How far above a side rays begin: walls that reach so high divide it.
    double lift_m() const { return 1e-6 * extent_m_; }

  private:
    static constexpr std::int32_t nowhere = std::numeric_limits<std::int32_t>::max();
    using Split = FacetDivision::Split;
    using CellPair = std::pair<std::uint32_t, std::uint32_t>;
    struct Making;
    ExchangeMesh() = default;
    template <typename Mesh, typename Archive>
    static void visitKept(Mesh& mesh, Archive& archive);
    void addCells(Making& making);
    /// Returns cells that continue each other where they share one vertex at most.
    std::vector<CellPair> joinVertices(Making& making);
    void connectVertices(const std::vector<CellPair>& uneven);

    // Models may have millions of facets, nearly all whole: what follows from these is computed.
    std::shared_ptr<const RayMesh> mesh_;
    std::vector<std::uint32_t> firstFacet_; // by piece
    /// By side, of facet `side / 2`; odd: its back: a split, or -1 - the number of the only cell.
    std::vector<std::int32_t> rootOf_;
    std::vector<Split> splits_;
    std::vector<std::uint32_t> sideOf_; // by cell
    /// By split: how many cells before those of its side are the only ones of theirs.
    std::vector<std::uint32_t> othersBefore_;
    /// By cell of sides that have several: corners' places there.
    std::vector<std::array<std::array<float, 2>, 3>> onFacet_;
    std::vector<std::array<std::uint32_t, 3>> corners_; // by cell
    std::vector<bool> sees_;                            // by cell
    std::vector<Vertex> vertices_;
    std::vector<Sight> sights_;                       // by vertex
    std::vector<std::uint32_t> firstBeside_, beside_; // by vertex
    double extent_m_ = 0.0, fineness_ = 1.0;
};

} // namespace irsg

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "irsg/geometry/view/Vec3.h"
#include "irsg/render/rays/RayMesh.h"

namespace irsg {

/// How far apart a model's surfaces are resolved where light goes between them.
struct LightResolution {
    /// Lengths on a surface times the root mean square of 1 / distance of what it sees.
    double edgePerDistance = 0.5;
    /// Longest edge of any, m; 0 for no matter. For what others light, which the body knows not.
    double longestEdge_m = 0.0;
    /// Most parts that an edge of a facet is cut into, a power of two.
    int mostParts = 16;
    /// Facets are cut less and nodes stand farther apart where there would be more.
    std::size_t mostTriangles = 60'000, mostNodes = 4'000;
};

/// The surface of a model as light between surfaces is computed on it: facets, those that see
/// something near cut into n x n triangles. In the axes of the mesh.
class LightMesh {
  public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    /// A place in a triangle, and the side that is meant.
    struct Place {
        std::uint32_t triangle = none; ///< 2 number, + 1 for the back
        float u = 0.0f, v = 0.0f;      ///< weights of its second and third corner
    };
    /// A corner of triangles, which those of a smooth surface share.
    struct Vertex {
        std::uint32_t piece = 0;
        Vec3 at_m, normal; ///< the normal is the mean of those of the triangles, as areas count
        /// Mean square of 1 / distance of what is seen from there.
        double nearness_per_m2 = 0.0;
    };

    LightMesh(std::shared_ptr<const RayMesh> mesh, const PieceUses& uses,
              const LightResolution& resolution);

    const RayMesh& rays() const { return *mesh_; }
    std::size_t triangles() const { return corners_.size(); }
    const std::vector<Vertex>& vertices() const { return vertices_; }

    Place placeOf(const RayHit& hit) const;
    /// Numbers of vertices.
    const std::array<std::uint32_t, 3>& corners(std::uint32_t triangle) const {
        return corners_[triangle];
    }
    std::array<Vec3, 3> cornersAt_m(std::uint32_t triangle) const {
        const auto& c = corners_[triangle];
        return {vertices_[c[0]].at_m, vertices_[c[1]].at_m, vertices_[c[2]].at_m};
    }
    double area_m2(std::uint32_t triangle) const;
    /// Unit, to the front.
    const Vec3& normal(std::uint32_t triangle) const { return facets_[facetOf_[triangle]].normal; }
    /// Whether anything opaque was found before the facet of a triangle, on either side.
    bool seesAnything(std::uint32_t triangle, bool front) const {
        return facets_[facetOf_[triangle]].sees[front ? 0 : 1];
    }
    /// Of the box around all of it, m.
    double extent_m() const { return extent_m_; }

  private:
    struct Facet {
        std::uint32_t first = 0; ///< of its triangles
        std::uint16_t parts = 1; ///< of an edge
        std::array<bool, 2> sees{};
        Vec3 normal;
    };
    /// What is seen of a facet's places, on the side that sees nearer things.
    struct Probe {
        double longest_m = 0.0, nearness_per_m = 0.0;
        std::uint32_t rays = 1;
        std::vector<Vec3> seen_m;
    };
    class Numbering;
    void probe(std::size_t number, const PieceUses& uses, Probe& probe);
    void chooseParts(const std::vector<Probe>& probes, const LightResolution& resolution);
    void addTriangles(std::size_t number, const Probe& probe, Numbering& numbering);
    unsigned numberInPiece(std::size_t facet) const {
        return static_cast<unsigned>(facet - firstFacet_[pieceOfFacet_[facet]]);
    }

    std::shared_ptr<const RayMesh> mesh_;
    std::vector<std::uint32_t> firstFacet_; // by piece
    std::vector<Facet> facets_;
    std::vector<std::uint32_t> facetOf_, pieceOfFacet_; // by triangle; by facet
    std::vector<std::array<std::uint32_t, 3>> corners_; // by triangle
    std::vector<Vertex> vertices_;
    std::vector<BoundingBox> opaque_; // of pieces that hide
    double area_m2_ = 0.0, extent_m_ = 0.0;
};

} // namespace irsg

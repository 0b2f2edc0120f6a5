#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "irsg/render/rays/LightMesh.h"

namespace irsg {

/// The unknowns of light between the surfaces of a model. A node stands for the surface around it,
/// as wide as what is seen from there is far away; what a vertex has is a mean of up to three nodes
/// near it that look the same way, so that all that is smooth stays smooth in a picture while
/// hundreds of nodes do for tens of thousands of facets. Each node has two sides, its receivers:
/// 2 node for the front, from where corners are seen counter-clockwise, 2 node + 1 for the back.
/// A patch is the triangles that are mostly one node's, with its number and two sides, too: each
/// triangle belongs to one. In the axes of the mesh.
class LightNodes {
  public:
    /// A node's part of what a vertex has. Those of a vertex add up to 1.
    struct Share {
        std::uint32_t node;
        float part;
    };
    /// A node of a patch: its area there, m2.
    struct Near {
        std::uint32_t node;
        float area_m2;
    };
    /// A place on a patch, to its side.
    struct Start {
        LightMesh::Place place;
        Vec3 at_m, normal;
    };

    LightNodes(std::shared_ptr<const LightMesh> mesh, const LightResolution& resolution);

    const LightMesh& mesh() const { return *mesh_; }
    const std::shared_ptr<const LightMesh>& shared() const { return mesh_; }
    std::size_t nodes() const { return pieceOf_.size(); }
    std::size_t receivers() const { return 2 * nodes(); }
    int pieceOf(std::uint32_t node) const { return static_cast<int>(pieceOf_[node]); }
    std::span<const Share> sharesOf(std::uint32_t vertex) const {
        return std::span(shares_).subspan(firstShare_[vertex],
                                          firstShare_[vertex + 1] - firstShare_[vertex]);
    }
    /// The nodes of a place, each once; their parts add up to 1.
    class OfPlace {
      public:
        OfPlace(const LightNodes& nodes, const LightMesh::Place& place);
        const Share* begin() const { return shares_.data(); }
        const Share* end() const { return shares_.data() + count_; }

      private:
        std::array<Share, 9> shares_;
        std::size_t count_ = 0;
    };

    /// The surface that a node stands for.
    double areaOf_m2(std::uint32_t node) const { return area_m2_[node]; }
    double patchArea_m2(std::uint32_t patch) const {
        return first_[patch] == first_[patch + 1] ? 0.0 : areaUpTo_m2_[first_[patch + 1] - 1];
    }
    std::span<const std::uint32_t> trianglesOf(std::uint32_t patch) const {
        return std::span(triangles_).subspan(first_[patch], first_[patch + 1] - first_[patch]);
    }
    /// Whether anything opaque was found before a patch's side.
    bool seesAnything(std::uint32_t side) const;
    /// Nodes that have some of a patch, ascending.
    std::span<const Near> near(std::uint32_t patch) const {
        return std::span(near_).subspan(firstNear_[patch],
                                        firstNear_[patch + 1] - firstNear_[patch]);
    }
    /// The place of a node among these.
    std::size_t placeNear(std::uint32_t patch, std::uint32_t node) const;
    /// A place of a patch's side from three numbers that are even in (0, 1).
    Start start(std::uint32_t side, double which, double a, double b) const;

  private:
    struct OfPiece;
    void placeNodes(const LightResolution& resolution);
    static void place(OfPiece& piece, const LightMesh& mesh, double edge, double longest_m);
    static void share(OfPiece& piece, const LightMesh& mesh);
    void gatherPatches();

    std::shared_ptr<const LightMesh> mesh_;
    std::vector<std::uint32_t> pieceOf_;    // by node
    std::vector<double> area_m2_;           // by node
    std::vector<std::uint32_t> firstShare_; // by vertex, and behind the last
    std::vector<Share> shares_;
    std::vector<std::uint32_t> first_, triangles_; // by patch
    std::vector<double> areaUpTo_m2_;              // of a patch's triangles, as they lie there
    std::vector<std::uint32_t> firstNear_;         // by patch
    std::vector<Near> near_;
};

} // namespace irsg

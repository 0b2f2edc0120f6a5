#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "irsg/radiance/exchange/LightPairs.h"
#include "irsg/render/rays/ExchangeMesh.h"

namespace irsg {

/// The unknowns of inter-reflection on a model. A node stands for the surface around it, on one
/// side, as wide as what is seen from there is far away; what a vertex has is a mean of up to three
/// nodes near it that look the same way and that one can go to along the surface, so that all that
/// is smooth stays smooth in a picture while thousands of nodes do for many more facets. What nodes
/// receive changes over a shorter way than it matters where light was sent from: some send as one.
/// A patch is the cells that are mostly one node's, with its number: each cell belongs to one. In
/// the axes of the mesh.
class ExchangeNodes {
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
        ExchangeMesh::Place place;
        Vec3 at_m, normal;
    };

    ExchangeNodes(std::shared_ptr<const ExchangeMesh> mesh, const ExchangeResolution& resolution);

    /// As they were written, of the same mesh.
    static std::shared_ptr<const ExchangeNodes> read(std::shared_ptr<const ExchangeMesh> mesh,
                                                     BinaryReader& reader);
    void write(BinaryWriter& writer) const;

    const ExchangeMesh& mesh() const { return *mesh_; }
    const std::shared_ptr<const ExchangeMesh>& shared() const { return mesh_; }
    std::size_t nodes() const { return pieceOf_.size(); }
    /// Of the lengths of the resolution: what nodes are apart in units of what they may be.
    double fineness() const { return fineness_; }
    /// How much farther nodes are apart at least than is wanted, since they would be too many.
    double coarseness() const { return coarseness_; }
    int pieceOf(std::uint32_t node) const { return static_cast<int>(pieceOf_[node]); }
    std::span<const Share> sharesOf(std::uint32_t vertex) const {
        return std::span(shares_).subspan(firstShare_[vertex],
                                          firstShare_[vertex + 1] - firstShare_[vertex]);
    }
    /// The nodes of a place, each once; their parts add up to 1.
    class OfPlace {
      public:
        OfPlace(const ExchangeNodes& nodes, const ExchangeMesh::Place& place);
        /// The same of what sends as one, by the number of the sender.
        OfPlace ofSenders(const ExchangeNodes& nodes) const;
        const Share* begin() const { return shares_.data(); }
        const Share* end() const { return shares_.data() + count_; }

      private:
        OfPlace() = default;
        void add(std::uint32_t number, float part);
        std::array<Share, 9> shares_;
        std::size_t count_ = 0;
    };

    std::size_t senders() const { return senders_; }
    std::uint32_t senderOf(std::uint32_t node) const { return senderOf_[node]; }
    const std::vector<std::uint32_t>& senderOfAll() const { return senderOf_; }

    /// The surface that a node stands for.
    double areaOf_m2(std::uint32_t node) const { return area_m2_[node]; }
    double patchArea_m2(std::uint32_t patch) const {
        return first_[patch] == first_[patch + 1] ? 0.0 : areaUpTo_m2_[first_[patch + 1] - 1];
    }
    std::span<const std::uint32_t> cellsOf(std::uint32_t patch) const {
        return std::span(cells_).subspan(first_[patch], first_[patch + 1] - first_[patch]);
    }
    /// Whether anything stands before a patch.
    bool seesAnything(std::uint32_t patch) const;
    /// Whether a patch turns to a space inside of the model; see ExchangeMesh.
    bool isInside(std::uint32_t patch) const {
        return first_[patch] != first_[patch + 1] && mesh_->isInside(cells_[first_[patch]]);
    }
    /// Nodes that have some of a patch, ascending.
    std::span<const Near> near(std::uint32_t patch) const {
        return std::span(near_).subspan(firstNear_[patch],
                                        firstNear_[patch + 1] - firstNear_[patch]);
    }
    /// The place of a node among these.
    std::size_t placeNear(std::uint32_t patch, std::uint32_t node) const;
    /// What a node's mean over the places that it has a part of is made of: by node, the means of
    /// what is between nodes there. Row sums are 1.
    const LightPairs& smoothing() const { return smoothing_; }
    /// The same of what sends as one.
    const LightPairs& smoothingOfSenders() const { return smoothingOfSenders_; }
    /// A place of a patch from three numbers that are even in (0, 1).
    Start start(std::uint32_t patch, double which, double a, double b) const;

  private:
    ExchangeNodes() = default;
    template <typename Nodes, typename Archive>
    static void visitKept(Nodes& nodes, Archive& archive);
    struct FewNodes;
    struct OfPiece;
    /// How far apart nodes are: as what they see is far away, within bounds.
    struct NodeSpacing {
        double edgePerDistance = 0.0, least_m = 0.0, longest_m = 0.0;
        /// The least is more where little can be seen from outside.
        bool spareDark = false;
    };
    void placeNodes(const ExchangeResolution& resolution);
    static constexpr std::size_t allNodes = std::numeric_limits<std::size_t>::max();
    /// Whether no more than `most` nodes of all pieces turn to no space inside; else they are not
    /// all placed.
    static bool placeAll(std::vector<OfPiece>& pieces, const ExchangeMesh& mesh,
                         const NodeSpacing& spacing, std::size_t most);
    /// `outside` counts nodes of all pieces that turn to no space inside.
    static void place(OfPiece& piece, const ExchangeMesh& mesh, const NodeSpacing& spacing,
                      std::size_t most, std::atomic<std::size_t>& outside);
    static void share(OfPiece& piece, const ExchangeMesh& mesh);
    void takeShares(std::vector<OfPiece>& pieces);
    void placeSenders(std::vector<OfPiece>& pieces, NodeSpacing spacing,
                      const ExchangeResolution& resolution);
    void gatherPatches();
    void findSmoothing();
    void findSmoothingOfSenders();

    std::shared_ptr<const ExchangeMesh> mesh_;
    double fineness_ = 1.0, coarseness_ = 1.0;
    std::vector<std::uint32_t> pieceOf_;  // by node
    std::vector<std::uint32_t> senderOf_; // by node
    std::size_t senders_ = 0;
    std::vector<double> area_m2_;           // by node
    std::vector<std::uint32_t> firstShare_; // by vertex, and behind the last
    std::vector<Share> shares_;
    std::vector<std::uint32_t> first_, cells_; // by patch
    std::vector<double> areaUpTo_m2_;          // of a patch's cells, as they lie there
    std::vector<std::uint32_t> firstNear_;     // by patch
    std::vector<Near> near_;
    LightPairs smoothing_, smoothingOfSenders_;
};

} // namespace irsg

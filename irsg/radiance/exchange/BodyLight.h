#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/exchange/ExchangeNodes.h"
#include "irsg/radiance/exchange/LightBalance.h"
#include "irsg/render/rays/LightDirections.h"

namespace irsg {

/// The rays of a patch that meet its body, in the order of the cells where they begin: what a body
/// that has turned needs of them.
struct PatchRays {
    struct Ray {
        std::uint32_t number;       ///< among BodyLight::raysOf
        float u, v;                 ///< where it begins, see ExchangeMesh::Place
        std::array<float, 3> along; ///< unit, in the axes of the mesh
    };
    struct OfCell {
        std::uint32_t cell;
        std::uint32_t end; ///< behind the last of its rays, which follow those of the cell before
    };
    std::vector<Ray> rays;
    std::vector<OfCell> cells;
};

/// What is computed anew of a body each time that it has turned, unless it is kept.
struct TurnedBody {
    std::vector<PatchRays> rays;  ///< by patch
    std::vector<double> areas_m2; ///< by cell, as the mesh has them; may be missing
    std::vector<Vec3> normals;    ///< likewise
};

/// What the surfaces of one model see of it: rays from points spread evenly over each
/// patch, along the cosine-weighted hemisphere of the facet there. What they meet counts for the
/// nodes that have a part of the place where they begin. As many rays as are needed until their
/// halves agree. Facets are met as a sensor would meet them; a ray goes on behind what is
/// transparent. Without a place in the world: made once for a model.
class BodyLight {
  public:
    /// A ray that meets the body. One that meets something transparent is followed by itself
    /// behind that; its place has no cell where it meets nothing more.
    struct LightRay {
        std::uint16_t index;
        /// Not what a ray the other way would find: it went out through the back of a facet that
        /// is seen from its front, or began on gas, which nobody sees.
        bool isOneWay;
        std::uint8_t passage; ///< what it has passed, by number (passages)
        float distance_m;     ///< where it meets the place
        ExchangeMesh::Place place;

        bool meetsAnything() const { return place.cell != ExchangeMesh::none; }
    };
    /// Where a ray begins, and where it goes.
    struct LightStart {
        ExchangeNodes::Start from;
        Ray ray;
    };
    static constexpr std::uint32_t fewestInside = 32, fewestRays = 128, mostRays = mostLightPoints;
    /// Of all patches together: where it does not do, each gets fewer.
    static constexpr std::size_t mostSent = std::size_t{1} << 22;
    /// Transparent surfaces that a ray is followed through, and sets of their materials. More is
    /// not there.
    static constexpr std::size_t mostPassed = 8, mostPassages = 255;

    /// `error`: of the part of its hemisphere that a node sees of the body, root mean square over
    /// the surface that sees anything.
    BodyLight(std::shared_ptr<const ExchangeNodes> nodes, const PieceUses& uses, double error);

    /// As it was written, of a model of the same facets; nothing where the bytes are not those of
    /// one.
    static std::shared_ptr<const BodyLight> read(std::shared_ptr<const RayMesh> mesh,
                                                 std::string_view bytes);
    /// With its mesh and nodes.
    std::string written() const;

    const ExchangeNodes& nodes() const { return *nodes_; }
    const ExchangeMesh& mesh() const { return nodes_->mesh(); }
    /// By node and by sender, of what is seen through nothing, and through others of `passages`.
    const LightBalance& balance(int passage = 0) const {
        return balances_[static_cast<std::size_t>(passage)];
    }
    /// What rays pass: sets of materials as PieceUse has them, of an entity 0.
    const OccluderStacks& passages() const { return passages_; }

    /// Ray `index` of a patch, in the axes of the mesh; `mostRays` of them.
    class Rays {
      public:
        Rays(const ExchangeNodes& nodes, std::uint32_t patch);
        LightStart at(std::uint32_t index) const;

      private:
        const ExchangeNodes& nodes_;
        std::uint32_t patch_;
        LightPoints points_;
    };
    /// How many rays a patch has sent: none where it sees nothing of the body.
    std::uint32_t sent(std::uint32_t patch) const { return sent_[patch]; }
    /// Of these the ones that meet the body, each from place to place.
    std::span<const LightRay> raysOf(std::uint32_t patch) const {
        return std::span(rays_).subspan(first_[patch], first_[patch + 1] - first_[patch]);
    }
    /// The same rays by cells. At first the rays alone, as they are at hand since they were sent;
    /// who asks again has turned the body and will do so again, so that all is kept: 24 bytes a ray
    /// and 32 a cell.
    std::shared_ptr<const TurnedBody> turned() const;
    /// Leaves out what is at hand, since nobody will ask for it.
    void forgetRays() const;
    /// By node that is near the patch: what a ray that meets something counts there, times the
    /// node's part of the place where it begins.
    std::span<const float> scalesOf(std::uint32_t patch) const {
        return std::span(scales_).subspan(firstScale_[patch],
                                          firstScale_[patch + 1] - firstScale_[patch]);
    }

    /// Rays that began on a receiver.
    double raysFrom(std::uint32_t receiver) const { return raysFrom_[receiver]; }
    /// All rays that were sent, without those that find out what is near.
    std::size_t raysSent() const { return allSent_; }
    /// Of the part of its hemisphere that a node sees of the body, by what the two halves of the
    /// rays differ by, root mean square over the surface that sees anything.
    double error() const { return error_; }
    /// Whether patches got fewer rays than the error that was asked for takes.
    bool isLimited() const { return isLimited_; }

    /// Orders the panes that a ray passes from where it begins, no more of them than count.
    static void sortPassed(const PieceUses& uses, std::vector<RayHit>& through);

  private:
    BodyLight() = default;
    template <typename Light, typename Archive>
    static void visitKept(Light& light, Archive& archive);
    struct Sending;
    class Errors;
    struct Uses;
    void send(Sending& sending, std::uint32_t patch, const Uses& uses, std::uint32_t wanted) const;
    /// By patch: rays that it sends at least.
    std::vector<std::uint32_t> fewestOf(const std::vector<std::uint32_t>& active) const;
    void refine(std::vector<Sending>& sendings, const Uses& uses, double error);
    void gather(std::vector<Sending>& sendings, const PieceUses& uses);
    /// Numbers what the rays of a patch pass.
    void numberPassages(Sending& sending, const PieceUses& uses);
    std::shared_ptr<TurnedBody> raysByCells() const;

    std::shared_ptr<const ExchangeNodes> nodes_;
    std::vector<std::uint32_t> sent_; // by patch
    std::vector<std::size_t> first_;  // rays by patch
    std::vector<LightRay> rays_;
    std::vector<std::size_t> firstScale_; // by patch
    std::vector<float> scales_;
    std::vector<double> raysFrom_; // by receiver
    OccluderStacks passages_;
    std::vector<LightBalance> balances_; // by passage
    std::size_t allSent_ = 0;
    double error_ = 0.0;
    bool isLimited_ = false;
    mutable std::mutex turning_;
    mutable std::shared_ptr<const TurnedBody> atHand_, turned_;
    mutable bool wasAskedForRays_ = false;
};

} // namespace irsg

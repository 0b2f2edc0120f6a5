#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "irsg/radiance/exchange/LightNodes.h"
#include "irsg/radiance/exchange/LightPairs.h"
#include "irsg/render/rays/LightDirections.h"

namespace irsg {

/// What the surfaces of one model see of it: rays from points spread evenly over each side of a
/// patch, along the cosine-weighted hemisphere of the facet there. What they meet counts for the
/// nodes that have a part of the place where they begin. As many rays as are needed until their
/// halves agree. Facets are met as a sensor would meet them; what is transparent is not there.
/// Without a place in the world: made once for a model.
class BodyLight {
  public:
    /// A ray that meets the body.
    struct LightRay {
        std::uint16_t index;
        /// Not what a ray the other way would find: it went out through the back of a facet that
        /// is seen from its front, or began on what is transparent.
        bool isOneWay;
        float distance_m; ///< where it meets the place
        LightMesh::Place place;
    };
    /// Where a ray begins, and where it goes.
    struct LightStart {
        LightNodes::Start from;
        Ray ray;
    };
    static constexpr std::uint32_t fewestRays = 64, mostRays = mostLightPoints;
    /// Of all patches together: where it does not do, each gets fewer.
    static constexpr std::size_t mostSent = std::size_t{1} << 22;

    /// `error`: of the part of its hemisphere that a node sees of the body, root mean square over
    /// the surface that sees anything.
    BodyLight(std::shared_ptr<const LightNodes> nodes, const PieceUses& uses, double error);

    const LightNodes& nodes() const { return *nodes_; }
    const LightMesh& mesh() const { return nodes_->mesh(); }
    const LightPairs& pairs() const { return pairs_; }

    /// Ray `index` of a patch's side, in the axes of the mesh; `mostRays` of them.
    class Rays {
      public:
        Rays(const LightNodes& nodes, std::uint32_t side);
        LightStart at(std::uint32_t index) const;

      private:
        const LightNodes& nodes_;
        std::uint32_t side_;
        LightPoints points_;
    };
    /// How many rays a side has sent: none where it sees nothing of the body.
    std::uint32_t sent(std::uint32_t side) const { return sent_[side]; }
    /// Of these the ones that meet the body.
    std::span<const LightRay> raysOf(std::uint32_t side) const {
        return std::span(rays_).subspan(first_[side], first_[side + 1] - first_[side]);
    }
    /// By node that is near the patch: what a ray that meets something counts there, times the
    /// node's part of the place where it begins.
    std::span<const float> scalesOf(std::uint32_t side) const {
        return std::span(scales_).subspan(firstScale_[side],
                                          firstScale_[side + 1] - firstScale_[side]);
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

  private:
    struct Sending;
    class Errors;
    struct Uses;
    void send(Sending& sending, std::uint32_t side, const Uses& uses, std::uint32_t wanted) const;
    void refine(std::vector<Sending>& sendings, const Uses& uses, double error);
    void gather(std::vector<Sending>& sendings);

    std::shared_ptr<const LightNodes> nodes_;
    std::vector<std::uint32_t> sent_; // by side
    std::vector<std::size_t> first_;  // rays by side
    std::vector<LightRay> rays_;
    std::vector<std::size_t> firstScale_; // by side
    std::vector<float> scales_;
    std::vector<double> raysFrom_; // by receiver
    LightPairs pairs_;
    std::size_t allSent_ = 0;
    double error_ = 0.0;
    bool isLimited_ = false;
};

} // namespace irsg

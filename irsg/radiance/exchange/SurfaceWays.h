#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/render/rays/ExchangeMesh.h"
#include "irsg/render/rays/RayVectors.h"

namespace irsg {

/// The shortest ways along the edges of the cells of a piece, from one of its vertices to those
/// about it. A vertex is named by its place in the piece. Holds 20 bytes for each vertex.
class SurfaceWays {
  public:
    /// Of the vertices of a mesh that still has its ways, from the first on; the mesh outlives it.
    SurfaceWays(const ExchangeMesh& mesh, std::uint32_t first, std::size_t count)
        : mesh_(mesh), first_(first), ways_(count) {}

    /// Calls visit(place, distance_m) for the vertices that are nearer than `most_m` along a
    /// straight line, and along the surface not much farther; in no certain order.
    template <typename Visit>
    void forEachAbout(std::size_t from, double most_m, Visit visit) {
        if (!(most_m > 0.0))
            return;
        find(from, most_m);
        const Vec3& from_m = atOf(from);
        for (const std::uint32_t place : reached_) {
            const Vec3 apart = atOf(place) - from_m;
            if (product(apart, apart) > above * most_m * most_m)
                continue;
            const double apart_m = length(apart);
            if (apart_m < most_m && ways_[place].way_m <= mostRoundabout * apart_m)
                visit(static_cast<std::size_t>(place), apart_m);
        }
    }

  private:
    /// How much longer the way along the edges of cells may be than the straight line: one around
    /// a wall is longer.
    static constexpr double mostRoundabout = 2.5;
    /// The same of ways that are looked for at all, of the longest straight line.
    static constexpr double detour = 1.5;
    /// What leaves room for the rounding of squares.
    static constexpr double above = 1.0 + 1e-9;
    /// How long a step is, of the edges about where ways begin; and how many there are at most.
    static constexpr double stepOfEdge = 0.5;
    static constexpr std::size_t mostSteps = 4096;

    struct Way {
        double way_m = 0.0;
        std::uint32_t turn = 0; ///< the last call in which it was reached
    };
    struct Open {
        double way_m;
        std::uint32_t place;
    };
    const Vec3& atOf(std::size_t place) const { return mesh_.vertices()[first_ + place].at_m; }
    void find(std::size_t from, double most_m);
    double meanEdge_m(std::size_t from) const;

    const ExchangeMesh& mesh_;
    std::uint32_t first_ = 0, turn_ = 0;
    std::vector<Way> ways_; // by place
    std::vector<std::uint32_t> reached_;
    std::vector<std::vector<Open>> open_; // by the step of the way in which they lie
};

} // namespace irsg

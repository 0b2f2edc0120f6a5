#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "irsg/geometry/view/Vec3.h"
#include "irsg/render/rays/RayMesh.h"

namespace irsg {

/// Facets of a mesh that all light of one source falls on, which is known without a ray: nothing of
/// the mesh that counts stands over them, as seen from the source. It is on the safe side: facets
/// of which it is not sure are left to rays, and what it says is what rays find, beyond the
/// rounding of these. Each facet is looked at when it is first asked for, by any thread. The mesh
/// must be there as long as facets are asked for, and is not kept by this.
class SunlitFacets {
  public:
    /// `towards`: unit, in the axes of the mesh. `radius_rad`: half the angle of the source.
    SunlitFacets(const std::shared_ptr<const RayMesh>& mesh, PieceUses uses, const Vec3& towards,
                 double radius_rad);

    /// Of meshes with more facets than samples nothing is won.
    static constexpr std::size_t mostFacets = 200'000;

    bool isOf(const std::shared_ptr<const RayMesh>& mesh, const PieceUses& uses,
              const Vec3& towards, double radius_rad) const;
    /// Whether the mesh is no more.
    bool isGone() const { return of_.expired(); }
    /// Whether all light arrives on the side of a facet that was hit.
    bool isLit(const RayHit& hit) const;

  private:
    /// A facet as it is seen from the source.
    struct Outline {
        std::array<double, 3> x{}, y{}, along{}; ///< of its corners; `along` grows to the source
        double least(const std::array<double, 3>& of) const;
        double most(const std::array<double, 3>& of) const;
    };
    struct Box {
        float x0 = 0, x1 = 0, y0 = 0, y1 = 0, along = 0; ///< `along`: the most
    };
    Outline outlineOf(const std::array<Vec3, 3>& corners_m) const;
    bool mayStandOver(std::size_t other, std::size_t facet, const RayMesh::Facet& own,
                      const Outline& outline, const Vec3& normal, double bulge_m) const;
    bool isFree(std::size_t facet, bool isFront) const;
    std::size_t cellOf(float place, float low, float size) const;
    /// Calls visit(cell) for the cells of a box.
    template <typename Visit>
    void forEachCell(const Box& box, Visit visit) const;

    std::weak_ptr<const RayMesh> of_;
    const RayMesh* mesh_;
    PieceUses uses_;
    Vec3 towards_, right_, up_;
    double radius_rad_, rounding_m_ = 0.0;
    std::vector<std::uint32_t> firstFacet_, pieceOf_; // by piece; by facet
    std::vector<Box> boxes_;                          // by facet
    Box all_;
    std::size_t side_ = 1;                  // cells along each axis
    std::vector<std::uint32_t> begin_, in_; // facets of cells
    std::vector<std::uint32_t> large_;      // of many cells
    enum : std::uint8_t { unknown, lit, unsure };
    std::unique_ptr<std::atomic<std::uint8_t>[]> known_; // 2 facet, + 1 for the back
};

} // namespace irsg

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/render/rays/RaysBuilt.h"

namespace irsg {

/// A half-line in the axes of a mesh.
struct Ray {
    Vec3 origin_m;
    Vec3 direction;                                                      ///< unit
    double from_m = 0.0, to_m = std::numeric_limits<double>::infinity(); ///< what of it counts
};

/// Where a ray meets a facet, in double.
struct RayHit {
    double distance_m = 0.0;
    double order_m = 0.0; ///< the distance at which it stands before others: a subface is lifted
    int piece = 0;        ///< of the mesh
    unsigned facet = 0;
    std::array<double, 3> weights{}; ///< of its corners
    bool isFront = false;            ///< corners are seen counter-clockwise
};

/// How a piece of a mesh is met.
struct PieceUse {
    bool isThere = false;
    bool transparent = false;    ///< rays go on behind it; both sides of it count
    bool cullsBackFaces = false; ///< of an opaque one
    int layer = 0;               ///< of a subface, which lies in the plane of the layer below
    /// Above 0 a transparent one that inter-reflection sees; those of equal numbers transmit alike.
    int pane = 0;
    bool operator==(const PieceUse&) const = default;
};

/// The same of all pieces of a mesh.
class PieceUses {
  public:
    explicit PieceUses(std::size_t pieces) : pieces_(pieces) {}
    void set(std::size_t piece, const PieceUse& use) {
        pieces_[piece] = use;
        layers_ = std::max(layers_, use.layer);
        isPlain_ = isPlain_ && !use.transparent && !use.cullsBackFaces;
        areAnyPanes_ = areAnyPanes_ || use.pane > 0;
        ++known_;
    }

    const PieceUse& operator[](std::size_t piece) const { return pieces_[piece]; }
    const PieceUse* data() const { return pieces_.data(); }
    int layers() const { return layers_; }
    /// The first facet of any piece ends a ray.
    bool arePlain() const { return isPlain_ && known_ == pieces_.size(); }
    bool areAnyPanes() const { return areAnyPanes_; }
    /// The same with the backs of all facets there.
    PieceUses withBacks() const {
        PieceUses same = *this;
        same.isPlain_ = true;
        for (PieceUse& use : same.pieces_) {
            use.cullsBackFaces = false;
            same.isPlain_ = same.isPlain_ && !use.transparent;
        }
        return same;
    }
    /// Whether a hit by `withBacks` is on a back that is not there.
    bool isCulled(const RayHit& hit) const {
        const PieceUse& use = pieces_[static_cast<std::size_t>(hit.piece)];
        return use.cullsBackFaces && !use.transparent && !hit.isFront;
    }
    bool operator==(const PieceUses&) const = default;

  private:
    std::vector<PieceUse> pieces_;
    std::size_t known_ = 0;
    int layers_ = 0;
    bool isPlain_ = true, areAnyPanes_ = false;
};

/// The triangles of a mesh as rays meet them, piece by piece. Which facets a ray meets is found in
/// float about the mesh; where it meets them is computed in double from the facets' own corners.
/// Equal input gives equal answers, whatever the number of threads.
class RayMesh {
  public:
    /// Shares the mesh. InputError without rays in this build.
    static std::shared_ptr<const RayMesh> of(std::shared_ptr<const Mesh> mesh);
    ~RayMesh();

    std::size_t facets() const;
    std::size_t pieces() const;

    /// The corners of all facets of a piece: three numbers of vertices for each.
    struct Corners {
        const Float3* vertices = nullptr;
        const unsigned* numbers = nullptr;
        std::array<Vec3, 3> of(std::size_t facet) const {
            const unsigned* own = numbers + 3 * facet;
            return {toVec3(vertices[own[0]]), toVec3(vertices[own[1]]), toVec3(vertices[own[2]])};
        }
    };
    /// Lives as long as the mesh.
    Corners cornersOf(std::size_t piece) const;

    /// A facet by its corners, in the order of a hit's weights. Facets that continue each other
    /// smoothly share corners: equal numbers in equal arrays.
    struct Facet {
        std::array<Vec3, 3> corners_m;
        std::array<unsigned, 3> vertices{};
        const void* arrays = nullptr;
    };
    std::size_t facetsOf(std::size_t piece) const;
    Facet facet(std::size_t piece, unsigned number) const;
    /// Whether the facets of two hits are one, or continue each other smoothly.
    bool touch(const RayHit& hit, const RayHit& other) const;

    /// The nearest opaque facet, if any, and every transparent one before it, in any order, in
    /// place of what `through` held. Subfaces that lie in one plane are met as their layers stand;
    /// `sampleWidth` is how wide a sample is per distance, and lifts them as depth offsets do.
    bool meet(const Ray& ray, const PieceUses& uses, double sampleWidth, RayHit& opaque,
              std::vector<RayHit>& through) const;

    /// Of places on it in float, m.
    double rounding_m() const;
    /// How far `lifted` moves places on a side of a facet, beyond rounding, at most, m; below 0
    /// where not to that side alone.
    double bulge_m(std::size_t piece, unsigned number, bool isFront) const;

    /// Where another ray meets the plane of the facet that one has met, inside its corners or not.
    RayHit onPlaneOf(const RayHit& hit, const Ray& ray) const;

    /// How well the distance along a ray is known: but for rounding by `rounding_m`, at worst by
    /// `off_m`.
    struct Distance {
        double m = 0.0, rounding_m = 0.0, off_m = 0.0;
    };
    /// The facet of those pieces that is seen at a distance along a ray. Of sheets that rounding
    /// does not tell apart it is the first one, of subfaces the highest; else the nearest.
    std::optional<RayHit> seenAt(const Ray& ray, const Distance& distance, const PieceUses& uses,
                                 const std::function<bool(int piece)>& isWanted) const;
    /// Finds facets that have others so near that a distance may not tell them apart.
    void findCloseSheets() const;
    /// Whether a facet has none nearer than `apart_m`, at most as far as was looked: then `again`
    /// tells. After findCloseSheets.
    bool standsAlone(int piece, unsigned facet, double apart_m) const;
    /// A facet that was found nearby is it again: false, with any hit, where a ray does not meet
    /// it, or farther than `off_m` from a distance, or on a back that is not there.
    bool again(const Ray& ray, int piece, unsigned facet, const PieceUse& use, double distance_m,
               double off_m, RayHit& hit) const;
    /// Whether light goes along a ray. What is transparent is told, piece by piece; of the opaque
    /// facets those count that are seen from where the light comes from. The facet that light falls
    /// on, `own`, and those that share a corner with it, one smooth surface, are not in its way.
    bool letsPass(const Ray& ray, const PieceUses& uses, const RayHit* own,
                  std::vector<int>& through) const;
    /// The place of a hit, moved to the side that the ray comes from: beyond rounding, and to the
    /// smooth surface that corners and normals stand for (Hanika, Ray Tracing Gems II, ch. 4).
    Vec3 lifted(const RayHit& hit, const Ray& ray) const;

    /// Unit normal there, as its corners have them, and that of the facet's plane; both point to
    /// the front.
    Vec3 normal(const RayHit& hit) const;
    Vec3 planeNormal(const RayHit& hit) const;

    struct Impl;

  private:
    explicit RayMesh(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg

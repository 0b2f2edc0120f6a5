#include "irsg/geometry/mesh/MeshPieces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace irsg {

namespace {

struct Triangle {
    std::array<unsigned, 3> corners;
    Float3 middle;
    std::uint32_t number; ///< in the part
};

std::vector<Triangle> trianglesOf(const Mesh::Part& part) {
    std::vector<Triangle> triangles;
    triangles.reserve(part.triangles.size() / 3);
    for (std::size_t i = 0; i < part.triangles.size(); i += 3) {
        Triangle& triangle = triangles.emplace_back();
        triangle.number = static_cast<std::uint32_t>(i / 3);
        std::copy_n(&part.triangles[i], 3, triangle.corners.begin());
        const auto& [a, b, c] = triangle.corners;
        for (std::size_t axis = 0; axis < 3; ++axis)
            triangle.middle[axis] =
                (part.vertices[a][axis] + part.vertices[b][axis] + part.vertices[c][axis]) / 3.0f;
    }
    return triangles;
}

/// Orders triangles by their middles: by the axis along which they were halved last, those that are
/// equal there by the one before, and at the end as they came.
class ByMiddle {
  public:
    ByMiddle along(std::size_t axis) const {
        ByMiddle next;
        next.axes_[next.count_++] = axis;
        for (std::size_t i = 0; i < count_; ++i)
            if (axes_[i] != axis)
                next.axes_[next.count_++] = axes_[i];
        return next;
    }
    bool operator()(const Triangle& a, const Triangle& b) const {
        for (std::size_t i = 0; i < count_; ++i)
            if (a.middle[axes_[i]] != b.middle[axes_[i]])
                return a.middle[axes_[i]] < b.middle[axes_[i]];
        return a.number < b.number;
    }

  private:
    std::array<std::size_t, 3> axes_{};
    std::size_t count_ = 0;
};

/// Halves the triangles along the longest side of their middles until there are few enough.
template <typename Take>
void halve(std::span<Triangle> triangles, std::size_t most, const ByMiddle& order, Take take) {
    if (triangles.size() <= most) {
        std::ranges::sort(triangles, order);
        return take(triangles);
    }
    Float3 low = triangles.front().middle, high = low;
    for (const Triangle& triangle : triangles)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], triangle.middle[axis]);
            high[axis] = std::max(high[axis], triangle.middle[axis]);
        }
    const Float3 side{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
    const std::size_t axis = side[0] >= side[1] && side[0] >= side[2] ? 0
                             : side[1] >= side[2]                     ? 1
                                                                      : 2;
    const ByMiddle next = order.along(axis);
    const std::size_t half = triangles.size() / 2;
    std::ranges::nth_element(triangles, triangles.begin() + static_cast<std::ptrdiff_t>(half),
                             next);
    halve(triangles.first(half), most, next, take);
    halve(triangles.subspan(half), most, next, take);
}

} // namespace

void cutIntoPieces(Mesh& mesh) {
    std::vector<Mesh::Piece> pieces;
    for (const Mesh::Piece& whole : std::exchange(mesh.pieces, {})) {
        Mesh::Part& part = mesh.parts[whole.part];
        std::vector<Triangle> triangles = trianglesOf(part);
        if (triangles.size() <= mostTriangles) {
            pieces.push_back(whole);
            continue;
        }
        // A drawing minds each piece, so that of a large part there are not ever more.
        constexpr std::size_t mostPieces = 128;
        const std::size_t most = std::max(mostTriangles, triangles.size() / mostPieces);
        part.triangles.clear();
        halve(std::span(triangles), most, ByMiddle(), [&](std::span<const Triangle> near) {
            Mesh::Piece& piece = pieces.emplace_back(Mesh::Piece{
                whole.part, part.triangles.size(), 3 * near.size(), BoundingBox::nowhere()});
            for (const Triangle& triangle : near)
                for (const unsigned corner : triangle.corners) {
                    part.triangles.push_back(corner);
                    piece.bounds.include(toVec3(part.vertices[corner]));
                }
        });
    }
    mesh.pieces = std::move(pieces);
}

} // namespace irsg

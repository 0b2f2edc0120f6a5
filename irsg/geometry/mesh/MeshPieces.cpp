#include "irsg/geometry/mesh/MeshPieces.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

namespace irsg {

namespace {

struct Triangle {
    std::array<unsigned, 3> corners;
    Float3 middle;
};

std::vector<Triangle> trianglesOf(const Mesh::Part& part) {
    std::vector<Triangle> triangles;
    triangles.reserve(part.triangles.size() / 3);
    for (std::size_t i = 0; i < part.triangles.size(); i += 3) {
        Triangle& triangle = triangles.emplace_back();
        std::copy_n(&part.triangles[i], 3, triangle.corners.begin());
        const auto& [a, b, c] = triangle.corners;
        for (std::size_t axis = 0; axis < 3; ++axis)
            triangle.middle[axis] =
                (part.vertices[a][axis] + part.vertices[b][axis] + part.vertices[c][axis]) / 3.0f;
    }
    return triangles;
}

/// Halves the triangles along the longest side of their middles until there are few enough.
template <typename Take>
void halve(std::span<Triangle> triangles, std::size_t most, Take take) {
    if (triangles.size() <= most)
        return take(triangles);
    Float3 side{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::ranges::minmax(
            triangles, {}, [axis](const Triangle& triangle) { return triangle.middle[axis]; });
        side[axis] = high.middle[axis] - low.middle[axis];
    }
    const std::size_t axis = side[0] >= side[1] && side[0] >= side[2] ? 0
                             : side[1] >= side[2]                     ? 1
                                                                      : 2;
    const std::size_t half = triangles.size() / 2;
    std::ranges::stable_sort(triangles, {},
                             [axis](const Triangle& triangle) { return triangle.middle[axis]; });
    halve(triangles.first(half), most, take);
    halve(triangles.subspan(half), most, take);
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
        halve(std::span(triangles), most, [&](std::span<const Triangle> near) {
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

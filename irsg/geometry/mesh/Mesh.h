#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "irsg/geometry/reading/ModelValues.h"
#include "irsg/geometry/view/Vec3.h"

namespace irsg {

/// A place or a direction in single precision, as graphics cards and ray trees take it.
using Float3 = std::array<float, 3>;
inline Vec3 toVec3(const Float3& v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// A straight line between two vertices, m.
struct ModelEdge {
    Vec3 from_m, to_m;
};

struct BoundingSphere {
    Vec3 centre_m;
    double radius_m = 0.0;
};

/// The surfaces of a model, or of a terrain, as they are sampled: triangles in its own axes (of a
/// model x starboard, y nose, z up), m, one part for each kind of surface. All arrays of a part
/// have the same length, or are empty where its surfaces have no such values. Whoever reads it
/// shares its arrays; nobody changes them.
struct Mesh {
    /// What the triangles of a part have in common.
    struct Kind {
        /// Depth of a subface, 0 for a face: it lies in the plane of the layer below and is seen in
        /// front of it.
        int layer = 0;
        IrCodes codes;
        bool culled = false; ///< the back faces are not there (OpenFlight draw type 0)
        auto operator<=>(const Kind&) const = default;
    };
    struct Part : Kind {
        std::vector<Float3> vertices;
        std::vector<Float3> normals; ///< unit, on the side of the triangles' front
        std::vector<std::array<float, 2>> texturePlaces; ///< 0 to 1 over a texture, upwards
        /// Three vertices for each triangle, counter-clockwise from the front; those of a piece
        /// follow each other.
        std::vector<unsigned> triangles;
        long polygons = 0; ///< of the file, which the triangles were
        double area_m2 = 0.0;
        BoundingBox bounds = BoundingBox::nowhere();
    };
    /// Triangles of one part that lie close together.
    struct Piece {
        std::size_t part = 0;
        std::size_t first = 0, count = 0; ///< in the part's `triangles`: three for each triangle
        BoundingBox bounds;
    };

    std::vector<Part> parts;   ///< of a model in the order of their kinds
    std::vector<Piece> pieces; ///< all triangles, part by part
    BoundingBox bounds = BoundingBox::nowhere();
    BoundingSphere sphere;            ///< about the middle of the bounds, around all vertices
    std::vector<ModelEdge> longEdges; ///< see LongEdges.h; none of a terrain

    const Part& partOf(const Piece& piece) const { return parts[piece.part]; }
    std::span<const unsigned> trianglesOf(const Piece& piece) const {
        return std::span(parts[piece.part].triangles).subspan(piece.first, piece.count);
    }
    std::size_t facets() const;
};

/// A mesh of these parts, whose bounds are known: each is one piece.
Mesh meshOf(std::vector<Mesh::Part> parts);

} // namespace irsg

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"

namespace irsg {

/// Corners of facets that are nearer count as one, of the size of the model: what rounding leaves.
inline constexpr double samePlaceOfSize = 2e-7;

/// Numbers of places, from 0 on: those have one that are equal in steps of a length in all three
/// coordinates; a step of 0 stands for 1 m.
std::vector<std::uint32_t> numbersOfPlaces(std::span<const Vec3> places_m, double step_m);

/// Triangles that hang together at edges, of a mesh.
struct MeshSurface {
    std::size_t facets = 0, twoSidedFacets = 0;
    double area_m2 = 0.0;
    std::size_t openEdges = 0;    ///< where it ends
    std::size_t flippedEdges = 0; ///< whose two facets turn their fronts to different sides
    std::size_t sharedEdges = 0;  ///< of more than two facets

    /// It has an inside, which nothing outside of it sees: what is read with two sides keeps the
    /// light of its inside.
    bool isClosed() const { return openEdges == 0; }
};

/// All surfaces, the largest area first. Facets without area belong to none.
std::vector<MeshSurface> surfacesOf(const Mesh& mesh);

} // namespace irsg

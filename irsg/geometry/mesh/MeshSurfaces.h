#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"

namespace irsg {

/// Corners of facets that are nearer count as one, of the size of the model: what rounding leaves.
inline constexpr double samePlaceOfSize = 2e-7;

/// Numbers of places, from 0 on in the order in which they come: those have one that are equal in
/// steps of a length in all three coordinates; a step of 0 stands for 1 m. It takes 32 to 40 bytes
/// a place.
class PlaceNumbers {
  public:
    explicit PlaceNumbers(double step_m) : per_m_(step_m > 0.0 ? 1.0 / step_m : 1.0) {}
    std::uint32_t of(const Vec3& place_m);

  private:
    void grow();
    double per_m_;
    std::vector<Vec3> places_; ///< in steps
    /// Number + 1 of the place that a hash chooses, 0 where free; a power of two of them.
    std::vector<std::uint32_t> slots_;
};

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

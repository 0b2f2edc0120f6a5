#pragma once

#include <cstddef>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"

namespace irsg {

/// The longest edges of a mesh, longest first: those of at least `longFrom` of the radius of its
/// sphere that end a surface, bend it or part two pairs of codes, at most `mostLongEdges`. A body
/// of few faces has some, a finely tessellated one none. They are what the lattice of a window is
/// chosen by (SampleLattice).
std::vector<ModelEdge> longEdges(const Mesh& mesh);
inline constexpr double longFrom = 0.25;
inline constexpr std::size_t mostLongEdges = 24;

} // namespace irsg

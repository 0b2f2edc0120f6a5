#pragma once

#include <vector>

#include "irsg/geometry/model/RenderList.h"

namespace irsg {

/// A straight line between two vertices, model axes.
struct ModelEdge {
    Vec3 from_m, to_m;
};

/// The longest edges of a model, longest first: those of at least `longFrom` of the radius of its
/// sphere that end a surface, bend it or part two pairs of codes, at most `mostLongEdges`. A body
/// of few faces has some, a finely tessellated one none. They are what the lattice of a window is
/// chosen by (SampleLattice).
std::vector<ModelEdge> longEdges(const std::vector<RenderItem>& items, double radius_m);
inline constexpr double longFrom = 0.25;
inline constexpr std::size_t mostLongEdges = 24;

} // namespace irsg

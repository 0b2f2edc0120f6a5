#pragma once

#include <vector>

#include "irsg/geometry/conversion/SurfaceMesh.h"

namespace irsg {

/// Finds polygons of different codes that lie in one plane and cover each other there, by more than
/// rounding does, and lets the file's order decide: of one level of subfaces, what was added first
/// is lifted over what came later, as a subface is over its face. Two faces that turn their culled
/// backs to each other are never seen together and stay. Returns what was settled, a pair of codes
/// each, the largest area first; a mesh without such faces stays as it is. Takes about a second for
/// a million triangles, and nothing where there is one pair of codes.
std::vector<SharedPlane> settleSharedPlanes(SurfaceMesh& mesh);

} // namespace irsg

#pragma once

#include "irsg/geometry/view/Vec3.h"

namespace irsg {

class SurfaceMesh;

/// Towards which end of an aircraft its tail lies: the end that has upright surfaces high above the
/// ground (a fin), lies higher on average, and is wider (a tailplane against a nose). Axes by their
/// numbers, 0 to 2, as the mesh has them: `length` from end to end, `up`, which points down where
/// `isDown`. Above 0: at the end of larger coordinates; below 0: at the other; within ±0.02 nothing
/// tells. What is no aircraft may give anything. docs/formats-models.md has how often it is right.
double tailTowards(const SurfaceMesh& mesh, const BoundingBox& box, int length, int up,
                   bool isDown);

} // namespace irsg
